"""Packages that others name and do not use: a rotation of scipy's brings numpy's tests and masked
arrays, its reader of Fortran, Python's pages of help, scipy's trees and the constants of physics
with it, two thirds of what it takes. Here they wait until something of theirs is used, and cost the
process that uses it.
"""

import sys
from functools import partial
from importlib import import_module
from importlib.machinery import PathFinder
from types import ModuleType
from typing import Any

__all__ = ["let_wait", "load"]

CALLED = "when it is called"
# by package, the names that are found in one of its modules without the rest, and functions that
# others import and call much later, or never
LATER: dict[str, dict[str, str]] = {
    "numpy.char": {},
    "numpy.ctypeslib": {},
    "numpy.f2py": {},
    "numpy.ma": {},
    "numpy.polynomial": {},
    "numpy.strings": {},
    "numpy.testing": {},
    "pydoc": {},
    "scipy.spatial": {},
    "scipy.spatial.transform": {"Rotation": "_rotation", "Slerp": "_rotation"},
    "scipy.spatial.transform._rotation_groups": {"create_group": CALLED},
}


class _Waiting(ModuleType):
    """A package that is read when a name of its own is wanted; the modules in it can be imported
    before.
    """

    def __getattr__(self, name: str) -> Any:
        if inner := sys.modules.get(f"{self.__name__}.{name}"):
            return inner
        if name == "__path__":  # which every module is asked for that names are imported from
            raise AttributeError(name)
        home = LATER[self.__name__].get(name)
        if home == CALLED:
            return partial(_called, self, name)
        if home:
            try:
                return getattr(import_module(f"{self.__name__}.{home}"), name)
            except (ImportError, AttributeError):
                pass  # another release has it elsewhere
        return getattr(_read(self), name)


def _read(module):
    if isinstance(module, _Waiting):
        module.__class__ = ModuleType  # type: ignore[assignment]
        loader: Any = module.__spec__ and module.__spec__.loader
        type(loader).exec_module(loader, module)  # not the loader's own, which is _wait
    return module


def _called(module, name, *given, **options):
    return vars(_read(module))[name](*given, **options)


def _wait(module):
    module.__class__ = _Waiting


class _Finder:
    @staticmethod
    def find_spec(name, path=None, target=None):
        spec: Any = PathFinder.find_spec(name, path) if name in LATER else None
        if spec is not None:
            spec.loader.exec_module = _wait
        return spec


def load(name: str) -> ModuleType:
    """A module, with what is wanted of it where it waits: the modules that hold its names, or all
    of it.
    """
    module = import_module(name)
    if isinstance(module, _Waiting):
        for wanted in LATER[name] or ("__all__",):
            getattr(module, wanted)
    return module


def let_wait() -> None:
    """From here on the packages of ``LATER`` wait."""
    sys.meta_path.insert(0, _Finder)
