"""The registry: one function a mistake, and what every search asks of them.

The words of a mistake stand in ``catalogue.yaml``; what it does stands in ``themes``, in one
function that yields its :mod:`changes <dhlab.doctor.mistakes.changes>`:

>>> from dhlab.doctor.mistakes.changes import RowChange, scaled
>>> def alpha_sign():  # under @mistake("alpha-sign", preference=SIGN) in themes/numbers.py
...     yield RowChange(scaled(alpha=-1), "alpha", argument="the turn about x")

From this one line an arm's table is repaired and the repair named, a typed table is explained, and
a program that turns about x the wrong way is recognised.
"""

from dataclasses import dataclass, replace
from functools import cache
from importlib import import_module

from .changes import Symptom

__all__ = ["changes", "mistake", "only_seen", "preference", "value_mistake"]

# the modules of themes; of mistakes that fit equally well the first one is told first
THEMES = (
    "joints",
    "numbers",
    "links",
    "columns",
    "digits",
    "frames",
    "ends",
    "models",
    "products",
    "poses",
)
# Two repairs may make the same arm. These kinds of mistakes are told first, in this order.
CONVENTION, SIGN, SENSE, OFFSET, COLUMNS, UNITS, END, OTHER = range(8)


@dataclass(frozen=True)
class _Entry:
    id: str
    theme: str
    function: object
    preference: int
    value_of: tuple


_ENTRIES = {}


def mistake(id, *, preference=OTHER, value_of=()):
    """Register a function without arguments that yields the changes of a mistake.

    Parameters
    ----------
    id : str
        Its id in the catalogue.
    preference : int
        One of the kinds above.
    value_of : tuple of str
        What this mistake is the name of when it has any other wrong value: ``"theta"``, ``"d"``,
        ``"a"``, ``"alpha"``, ``"sign"``, ``"coupling"``, ``"tool"``, ``"base turn"``,
        ``"base shift"``; or of a whole table: ``"rows are craig"``, ``"rows are standard"``.
    """

    def register(function):
        theme = function.__module__.rpartition(".")[2]
        if theme not in THEMES:
            raise ValueError(f"{id}: expected a module in THEMES, found {theme!r}; add it there")
        if id in _ENTRIES:
            raise ValueError(f"{id}: expected one function, found two; let one of them yield all")
        _ENTRIES[id] = _Entry(id, theme, function, preference, value_of)
        return function

    return register


@cache
def _entries():
    """Every entry, in order of the themes and then as it stands there."""
    for theme in THEMES:
        import_module(f"{__package__}.themes.{theme}")
    return tuple(sorted(_ENTRIES.values(), key=lambda entry: THEMES.index(entry.theme)))


@cache
def changes(*kinds):
    """All changes of these classes, in order; of all classes when none is given.

    Examples
    --------
    >>> from dhlab.doctor.mistakes.changes import RowChange
    >>> [change.place for change in changes(RowChange) if change.mistake == "length-unit"][0]
    'all lengths'
    """
    if kinds:
        return tuple(change for change in changes() if isinstance(change, kinds))
    return tuple(
        replace(change, mistake=entry.id) for entry in _entries() for change in entry.function()
    )


@cache
def preference(id):
    """How early a mistake is told among those that make the same arm: 0 first, :data:`OTHER`
    last.
    """
    return next(entry.preference for entry in _entries() if entry.id == id)


@cache
def value_mistake(what):
    """The id of the mistake that has any other wrong value of ``what``; see :func:`mistake`.

    Examples
    --------
    >>> value_mistake("d"), value_mistake("base turn")
    ('length-value', 'base-turned')
    """
    return next(entry.id for entry in _entries() if what in entry.value_of)


@cache
def only_seen(id):
    """Whether a mistake says what wrong answers look like, but not what made them so.

    Examples
    --------
    >>> only_seen("not-rigid"), only_seen("pose-inverted")
    (True, False)
    """
    made = [change for change in changes() if change.mistake == id]
    return bool(made) and all(isinstance(change, Symptom) for change in made)
