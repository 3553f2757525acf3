"""The names that a notebook's cells begin with, as they stand after every lesson's first cell."""

import builtins
import os
import sys
import types
from collections.abc import Collection
from itertools import islice
from typing import Any

import numpy as np

__all__ = ["loaded", "space"]

MOST_MODULES = 2000


def space(book: Any) -> dict[str, Any]:
    """A new ``__main__``, whose ``check`` notes into ``book``."""
    import dhlab
    from dhlab import course, view

    course.book = book  # type: ignore[attr-defined]  # the one that stands in
    if (here := os.getcwd()) not in sys.path:  # for modules that a notebook writes itself
        sys.path.append(here)
    module = types.ModuleType("__main__")
    sys.modules["__main__"] = module
    module.__dict__.update(
        {name: getattr(course, name) for name in course.__all__},
        np=np,
        dh=dhlab,
        transform=dhlab.transform,
        view=view,
        __builtins__=builtins,
    )
    return module.__dict__


def loaded(warm: Collection[str]) -> list[str]:
    """The modules that are loaded here beyond those that the warm parent has, which may load them
    for all.
    """
    # the last ones: to look at all the names costs a copy of each page that they stand on
    new = islice(reversed(sys.modules), max(0, len(sys.modules) - len(warm)))
    return sorted(name for name in new if name not in warm)[:MOST_MODULES]
