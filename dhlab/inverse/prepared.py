"""What was derived for an arm once is kept in the user's cache folder, by the numbers of its table.

ssik keeps its derivations in the folder that ``SSIK_DERIVATION_CACHE`` names; here every arm has
one of its own, with a mark in it when the derivation is complete.
"""

import hashlib
import os
import platform
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.metadata import version
from pathlib import Path

from ..table import DHTable

__all__ = ["folder_of", "is_ready", "mark", "place"]

VARIABLE = "SSIK_DERIVATION_CACHE"
COUNTS = ("ssik", "numpy", "sympy", "mpmath")  # another version may derive other numbers


def place(table: DHTable) -> Path:
    """The folder of a table, existing or not."""
    from platformdirs import user_cache_path

    told = [table.convention, table.joints, *(row.hex() for row in table.rows.ravel())]
    told += [f"{name} {version(name)}" for name in COUNTS] + [platform.machine()]
    key = hashlib.sha256("\n".join(told).encode()).hexdigest()[:24]
    return Path(user_cache_path("dhlab", appauthor=False)) / "inverse" / key


def is_ready(table: DHTable) -> bool:
    """Whether the derivation is there."""
    return (place(table) / "ready").exists()


def mark(table: DHTable) -> None:
    """Say that the derivation is complete."""
    place(table).mkdir(parents=True, exist_ok=True)
    (place(table) / "ready").write_text("")


@contextmanager
def folder_of(table: DHTable) -> Iterator[None]:
    """Let ssik look into, and write to, this table's folder."""
    before = os.environ.get(VARIABLE)
    os.environ[VARIABLE] = str(place(table))
    try:
        yield
    finally:
        if before is None:
            del os.environ[VARIABLE]
        else:
            os.environ[VARIABLE] = before
