"""Tables of numbers that a program holds, whatever holds them: columns, by name or number."""

from dataclasses import dataclass, field

import numpy as np

from .scopes import Scope
from .values import Instance

__all__ = ["Table", "Watched", "columns_of"]

WIDEST, MOST_ROWS = 12, 24
MOST_WATCHED = 100
NUMBERS = int | float | np.number


@dataclass(frozen=True)
class Table:
    """A table of a program: its first columns and its last ones, None where it is none any more;
    whether it belongs to a function.
    """

    name: str
    first: dict
    last: dict | None
    is_local: bool


@dataclass
class Watched:
    """The tables under their names: what each was at first, and what is held there now."""

    first: dict = field(default_factory=dict)
    held: dict = field(default_factory=dict)
    last: dict = field(default_factory=dict)

    def watch(self, owner, name, value):
        """Note what a name of a scope, or an attribute of an object, holds from now on."""
        place = id(owner), name
        if place in self.first:
            self.held[place] = owner, value
            return
        if not isinstance(value, list | tuple | dict | np.ndarray):
            return
        if len(self.first) >= MOST_WATCHED:
            return
        empty = isinstance(value, list) and not value  # rows may be appended
        columns = {} if empty else columns_of(value)
        if columns is not None:
            self.first[place], self.held[place] = columns, (owner, value)
        elif isinstance(value, dict):
            for key, part in value.items():
                if isinstance(key, str) and not isinstance(part, dict):
                    self.watch(value, key, part)

    def settle(self):
        """Take what the tables are now for their last values: what is called from outside later
        changes them no more.
        """
        for place, (_, value) in self.held.items():
            if place not in self.last:
                self.last[place] = columns_of(value)

    def tables(self):
        """The Tables; lists of numbers of one owner are the columns of one."""
        self.settle()
        lists: dict = {}
        for place, first in self.first.items():
            last, owner = self.last[place], self.held[place][0]
            if isinstance(first, list):
                lists.setdefault((place[0], len(first)), []).append((place[1], first, last, owner))
            else:
                last = last if isinstance(last, dict) else None
                yield Table(place[1], first, last, _is_local(owner))
        for found in lists.values():
            whole = all(isinstance(last, list) for _, _, last, _ in found)
            first = {name: one for name, one, _, _ in found}
            last = {name: one for name, _, one, _ in found} if whole else None
            yield Table("", first, last, _is_local(found[0][3]))


def _is_local(owner):
    """Whether names belong to a function."""
    return isinstance(owner, Scope) and owner.outer is not None


def columns_of(value):
    """The columns of a table, each a list with a number for each row, None in the place of what is
    no known number; by place, key or attribute; of one list of numbers it alone. None of what is no
    table.

    Examples
    --------
    >>> columns_of([[0, 0.1], [1.57, "flange"]])
    {0: [0.0, 1.57], 1: [0.1, None]}
    >>> columns_of({"d": [0.1, 0], "a": [0, 0.4]}) == columns_of([{"d": 0.1, "a": 0},
    ...                                                           {"d": 0, "a": 0.4}])
    True
    >>> columns_of([0.1, 0.2])
    [0.1, 0.2]
    """
    alone = _numbers(value)
    if alone is not None:
        return alone
    named = _named(value)
    if named is not None:
        columns = {key: _numbers(one) for key, one in named.items()}
        columns = {key: one for key, one in columns.items() if one is not None}
        if columns and len({len(one) for one in columns.values()}) == 1:
            return columns
        value = [*named.values()]
    rows = _items(value)
    if rows is None or not 1 <= len(rows) <= MOST_ROWS:
        return None
    held = [_named(row) for row in rows]
    if None in held:
        listed = [_items(row) for row in rows]
        if None in listed:
            return None
        held = [dict(enumerate(row)) for row in listed]
    keys = list(held[0])
    if not 0 < len(keys) <= WIDEST or any(list(row) != keys for row in held):
        return None
    return {key: [_number(row[key]) for row in held] for key in keys}


def _named(value):
    """What a dictionary or an object holds by name; None of others."""
    if isinstance(value, Instance):
        return value.attributes
    return value if isinstance(value, dict) else None


def _items(value):
    if isinstance(value, np.ndarray):
        return list(value) if value.ndim and value.size <= WIDEST * MOST_ROWS else None
    return value if isinstance(value, list | tuple) else None


def _numbers(value):
    """A list of numbers, or of what stands for them; None of lists in lists."""
    items = _items(value)
    if items is None or not 2 <= len(items) <= MOST_ROWS:
        return None
    if any(_items(one) is not None or _named(one) is not None for one in items):
        return None
    return [_number(one) for one in items]


def _number(value):
    return float(value) if isinstance(value, NUMBERS) and not isinstance(value, bool) else None
