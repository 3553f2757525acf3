"""Stands in for ``dhlab`` where the task is to write kinematics oneself: tables and the arms of the
lessons as data, and nothing that computes a pose.
"""

import json
import sys
from importlib import import_module
from importlib.machinery import ModuleSpec
from pathlib import Path
from typing import Any

__version__ = "0.1.0"
HERE = ("dhlab.units", "dhlab.checks", "dhlab.table", "dhlab.view", "dhlab.course", "dhlab.grading")
asked: set[str] = set()  # what a program wanted to use and could not


class NotHere(Exception):
    """A program used something that it was to write itself."""


class Closed:
    """A part of dhlab that is not here, and everything that is made from it. It may be named,
    passed on and combined; whoever wants a number of it is told.
    """

    def __init__(self, name: str) -> None:
        object.__setattr__(self, "_name", name)

    def _refuse(self, *args: object, **kwargs: object) -> Any:
        asked.add(self._name)
        raise NotHere(f"dhlab.{self._name} is not here: the task is to write that yourself")

    def _same(self, *args: object, **kwargs: object) -> Any:
        return self

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return self

    __call__ = __getitem__ = __enter__ = __neg__ = __abs__ = _same
    __array__ = __float__ = __int__ = __index__ = __complex__ = _refuse
    __bool__ = __iter__ = __len__ = __contains__ = __str__ = __format__ = _refuse

    def __exit__(self, *error: object) -> None: ...


for _name in "add sub mul truediv matmul pow mod floordiv".split():
    setattr(Closed, f"__{_name}__", Closed._same)
    setattr(Closed, f"__r{_name}__", Closed._same)
# numpy would otherwise ask for an array first
Closed.__array_ufunc__ = Closed._same  # type: ignore[attr-defined]
Closed.__array_function__ = Closed._same  # type: ignore[attr-defined]


class Arm:
    """An arm as data: its table, base, tool, signs and limits."""

    def __init__(self, table: Any, **known: Any) -> None:
        self.table, self.name = table, ""
        self.__dict__.update(known)

    def __len__(self) -> int:
        return len(self.table.rows)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return Closed(name)


def load(name: str) -> Any:
    """An arm of the library that a lesson names; another is not here."""
    import numpy as np

    from dhlab.table import DHTable

    arms = json.loads((Path(__file__).parent / "arms.json").read_text(encoding="utf-8"))
    if name not in arms:
        return Closed("load")
    arm = dict(arms[name])
    make = getattr(DHTable, arm.pop("convention"))
    table = make(np.array(arm.pop("rows")), angle="rad", joints=arm.pop("joints"))
    return Arm(table, **{key: value and np.array(value) for key, value in arm.items()}, name=name)


class _Rooms:
    """Every room that is not here is found, and closed."""

    @staticmethod
    def find_spec(name, path=None, target=None):
        if not name.startswith("dhlab.") or name.startswith(HERE):
            return None
        return ModuleSpec(name, _Rooms, is_package=True)  # type: ignore[arg-type]

    @staticmethod
    def create_module(spec):
        return None

    @staticmethod
    def exec_module(module):
        last = module.__name__.rpartition(".")[2]
        module.__getattr__ = lambda name: _part(name, f"{last}.{name}")


def _part(name, called):
    if name.startswith("__"):
        raise AttributeError(name)
    return Closed(called)


if __name__ == "dhlab":  # in the cage, not where somebody only reads this file
    sys.meta_path.insert(0, _Rooms)

    def __getattr__(name: str) -> Any:
        if name == "DHTable":
            from dhlab.table import DHTable

            return DHTable
        if f"dhlab.{name}" in HERE:
            return import_module(f"dhlab.{name}")
        return _part(name, name)
