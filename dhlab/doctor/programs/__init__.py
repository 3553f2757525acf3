"""What is wrong with a learner's program, found by calling it."""

import lazy_loader

# __init__.pyi lists the names; who only calls functions does not load what explains their answers
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
