"""``Cards``: the options of a question as cards; what is chosen is a list of letters."""

import re
from collections.abc import Mapping, Sequence
from html import escape
from pathlib import Path

import anywidget
from traitlets import Dict, List, Unicode

__all__ = ["Cards", "inline"]

MARKS = ((r"`([^`]+)`", r"<code>\1</code>"), (r"\*\*(.+?)\*\*", r"<b>\1</b>"))
FORMULA = re.compile(r"\$([^$]+)\$")
SUBSCRIPT = re.compile(r"_(?:\{([^}]*)\}|(\w))")


def inline(text: str) -> str:
    """One line of an exercise's Markdown as HTML: code, bold, and formulas with subscripts.

    Examples
    --------
    >>> inline("`x` is along $z_i$")
    '<code>x</code> is along <i>z<sub>i</sub></i>'
    """
    html = escape(text, quote=False)
    for pattern, shown in MARKS:
        html = re.sub(pattern, shown, html)
    return FORMULA.sub(lambda found: f"<i>{_formula(found[1])}</i>", html)


def _formula(text):
    return SUBSCRIPT.sub(lambda found: f"<sub>{found[1] or found[2]}</sub>", text)


class Cards(anywidget.AnyWidget):
    """Options to choose one of, or to lay into places.

    Parameters
    ----------
    title : str
    options : dict
        The text of each option by its letter.
    places : list of str
        What the places are called, of an order or a matching; none for a single choice.
    repeats : bool
        Whether an option may have several places.

    Attributes
    ----------
    chosen : list of str
        The letters that lie in the places, "" where there is none; of a choice one letter, or "".
    told : str
        What is said under the cards.

    Examples
    --------
    >>> cards = Cards("Which number moves?", {"a": "θ", "b": "d"})
    >>> cards.chosen = ["b"]
    >>> cards.complete
    True
    """

    _esm = Path(__file__).with_name("cards.js")
    _data = Dict().tag(sync=True)
    chosen = List(Unicode()).tag(sync=True)
    told = Unicode("").tag(sync=True)

    def __init__(
        self,
        title: str,
        options: Mapping[str, str],
        places: Sequence[str] = (),
        repeats: bool = False,
    ) -> None:
        super().__init__(
            _data={
                "title": title,
                "options": [[letter, inline(text)] for letter, text in options.items()],
                "places": [inline(place) for place in places],
                "repeats": repeats,
            },
            chosen=[""] * max(1, len(places)),
        )

    @property
    def complete(self) -> bool:
        """Whether every place has its letter, or "?" stands in one."""
        return all(self.chosen) or "?" in self.chosen
