"""What is wrong: the catalogue of mistakes, and the search over it from measured poses, programs,
tables and motion.
"""

import lazy_loader

# __init__.pyi lists the names; each is loaded when it is first asked for
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
