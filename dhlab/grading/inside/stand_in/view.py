"""Stands in for ``dhlab.view`` inside the cage: every picture is free, and none is drawn."""

import sys
from importlib.machinery import ModuleSpec
from typing import Any


class Picture:
    """A picture that nobody will look at; whatever is asked of it is another one."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return self

    def __call__(self, *args: object, **kwargs: object) -> Any:
        return self

    def __str__(self) -> str:
        return ""


class _Rooms:
    """Every module of the package is this one again."""

    @staticmethod
    def find_spec(name, path=None, target=None):
        if not name.startswith("dhlab.view."):
            return None
        return ModuleSpec(name, _Rooms)  # type: ignore[arg-type]  # it has a loader's methods

    @staticmethod
    def create_module(spec):
        return sys.modules["dhlab.view"]

    @staticmethod
    def exec_module(module):
        """It has been loaded already."""


def _any(name):
    if name.startswith("__"):
        raise AttributeError(name)
    return Picture()


if __name__ == "dhlab.view":  # in the cage, not where somebody only reads this file
    __getattr__ = _any
    sys.meta_path.append(_Rooms)
