"""Pictures for the page and the notebook: frames, arms, configurations, one row of a table. Each
says in words and numbers what it shows.

Look at one with ``view.arm(dhlab.load("ur5e"))``; every function returns a :class:`Picture`.
"""

import lazy_loader

# __init__.pyi lists the names; each is loaded when it is first asked for
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
