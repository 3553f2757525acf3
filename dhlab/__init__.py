"""dhlab: learn, teach and debug Denavit-Hartenberg kinematics. Radians and metres inside; degrees
and millimetres where people write.
"""

from importlib import import_module
from importlib.util import find_spec

import lazy_loader

__version__ = "0.1.0"

# __init__.pyi lists the names; each is loaded when it is first asked for, and so is a room
# (dhlab.transform), so that import dhlab costs little
_load, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


def __getattr__(name):
    if name in __all__:
        return _load(name)
    if not name.startswith("_") and find_spec(f"{__name__}.{name}"):
        return import_module(f"{__name__}.{name}")
    raise AttributeError(f"dhlab has no {name!r}; it has {', '.join(__all__)}")
