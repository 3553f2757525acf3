"""IPython's rules for magics, without the rest of IPython: that is large, and no cell needs it for
this. The warm parent loads this once somebody has needed it.
"""

import sys
from importlib import import_module
from importlib.machinery import PathFinder
from types import ModuleType

__all__ = ["without_magics"]

NAME = "IPython.core.inputtransformer2"


def _rules():
    if "IPython" in sys.modules:
        return import_module(NAME)
    found = PathFinder.find_spec("IPython")
    if found is None:
        raise ImportError("IPython is not here")
    package = sys.modules["IPython"] = ModuleType("IPython")
    try:
        package.__path__ = list(found.submodule_search_locations or ())
        return import_module(NAME)
    finally:
        for part in [one for one in sys.modules if one.partition(".")[0] == "IPython"]:
            del sys.modules[part]


RULES = _rules()


def without_magics(source: str) -> str:
    """A cell with its magics turned into calls, as IPython does it.

    Examples
    --------
    >>> without_magics("%matplotlib inline").strip()
    "get_ipython().run_line_magic('matplotlib', 'inline')"
    """
    return str(RULES.TransformerManager().transform_cell(source))
