"""The way through the course: a map of its sittings with what is done of each, where one stopped,
and where the pre-test says to begin.
"""

from collections import Counter
from collections.abc import Mapping, Sequence
from html import escape
from typing import NamedTuple

from .verdict import RECORDED, RIGHT

__all__ = ["SITTINGS", "Done", "Map", "begin_at", "counted", "file_of", "stopped_in"]

SITTINGS = {
    "00": ("start-here", "Start here"),
    "01": ("frames", "Frames"),
    "02": ("parameters", "Four numbers"),
    "03": ("conventions", "Two conventions"),
    "04": ("placing-frames", "Placing frames"),
    "04b": ("a-whole-arm", "A whole arm"),
    "05": ("link-matrix", "The link matrix"),
    "06": ("forward-kinematics", "Forward kinematics"),
    "07": ("troubleshooting", "Troubleshooting"),
    "08": ("beyond", "Speeds"),
    "08b": ("back-to-the-joints", "Back to the joints"),
    "09": ("your-own-arm", "Your own arm"),
}
ASKED_BY = {"00.2": "01", "00.3": "02", "00.4": "03", "00.5": "05", "00.6": "07"}  # the pre-test
FIRST = ("01", "02", "03")  # what 04 builds on
DONE = (RIGHT, RECORDED)
CHIP = "display:inline-block;padding:.1em .5em;border:1px solid #8c959f80;border-radius:1em"


class Done(NamedTuple):
    """How much of a sitting is done. Its section *More practice* is counted apart: a sitting is
    finished without it.

    Examples
    --------
    >>> str(Done(6, 6, 1, 2)), str(Done(2, 6, 0, 2)), Done(6, 6, 1, 2).words
    ('✓ +1', '2/6', '6 of 6 exercises done, and 1 of 2 of More practice')
    """

    done: int
    of: int
    practised: int = 0
    of_practice: int = 0

    @property
    def finished(self) -> bool:
        return self.done == self.of

    @property
    def words(self) -> str:
        """All of it, in words."""
        more = f", and {self.practised} of {self.of_practice} of More practice"
        return f"{self.done} of {self.of} exercises done{more * bool(self.of_practice)}"

    def __str__(self) -> str:
        more = f" +{self.practised}" if self.practised else ""
        return ("✓" if self.finished else f"{self.done}/{self.of}") + more


def file_of(sitting: str) -> str:
    """The notebook of a sitting.

    Examples
    --------
    >>> file_of("04b")
    '04b-a-whole-arm.ipynb'
    """
    return f"{sitting}-{SITTINGS[sitting][0]}.ipynb"


def begin_at(known: Mapping[str, bool]) -> tuple[str, list[str]]:
    """The sitting to begin with, and those beyond it that take up what was not answered rightly.

    Parameters
    ----------
    known : dict of str to bool
        Of each question of the pre-test, whether its first answer was right. A question without an
        answer counts as one that is not known; a wrong answer and "?" count alike. One right answer
    may be luck and skips nothing: lesson 01 needs that of lesson 02 beside its own.

    Examples
    --------
    >>> begin_at({})[0], begin_at({"00.2": True})[0]
    ('01', '01')
    >>> begin_at({"00.2": True, "00.3": True, "00.4": True, "00.5": False, "00.6": True})
    ('04', ['05'])
    """
    open_ = [lesson for key, lesson in ASKED_BY.items() if not known.get(key)]
    first = next((lesson for lesson in open_ if lesson in FIRST), "04")
    first = "01" if first == "02" else first
    return first, [lesson for lesson in open_ if lesson > first]


def stopped_in(entries: Sequence[Mapping[str, object]], done: Mapping[str, Done]) -> str:
    """The sitting of the last check, or the next one where that is finished; "00" at first.

    Parameters
    ----------
    entries : list of dict
        The log, oldest first; an "exercise" each.
    done : dict
        Of each sitting how much of it is done.
    """
    from .exercises import sittings

    last = entries[-1]["exercise"] if entries else None
    sitting = next((name for name, keys in sittings().items() if last in keys), "00")
    names = list(SITTINGS)
    return names[min(names.index(sitting) + done[sitting].finished, len(names) - 1)]


class Map:
    """The course as a row: every sitting with how much of it is done; shown on top of a lesson.

    Parameters
    ----------
    done : dict
        Of each sitting how much of it is done.
    here : str
        The sitting that is open, or "".
    words : str
        What is said below it.
    """

    def __init__(self, done: Mapping[str, Done], here: str = "", words: str = "") -> None:
        self._done, self._here, self._words = dict(done), here, words

    def to_dict(self) -> dict[str, Done]:
        """{sitting: (done, of, practised, of_practice)}."""
        return self._done

    def __str__(self) -> str:
        row = "  ".join(
            f"{'>' if name == self._here else ''}{name} {done}" for name, done in self._done.items()
        )
        return row + (f"\n{self._words}" if self._words else "")

    __repr__ = __str__

    def _repr_html_(self):
        items = "".join(self._item(name) for name in self._done)
        words = f"<p>{_linked(self._words)}</p>" if self._words else ""
        label = "Where to begin" if words else "The course"  # lesson 00 shows both maps
        return (
            f'<nav aria-label="{label}"><ol style="list-style:none;padding:0;margin:.3em 0;'
            f'display:flex;flex-wrap:wrap;gap:.35em">{items}</ol>{words}</nav>'
        )

    def _item(self, name):
        done = self._done[name]
        here = name == self._here
        title = f"{name} {SITTINGS[name][1]}"
        text, share = f"{name} {done}", 100 * done.done // done.of
        part = f"background:linear-gradient(90deg,#1a7f3740 {share}%,transparent 0)"
        strong = ";border-color:currentColor;font-weight:700" if here else ""
        inner = (
            f'<span aria-current="page">{text}</span>'
            if here
            else f'<a href="{file_of(name)}">{text}</a>'
        )
        label = escape(f"{title}: {done.words}")
        return f'<li title="{label}" style="{CHIP};{part}{strong}">{inner}</li>'


def _linked(words):
    """The words, every "lesson NN" a link to it."""
    text = escape(words)
    for name in sorted(SITTINGS, key=len, reverse=True):
        text = text.replace(f"lesson {name}.", f'<a href="{file_of(name)}">lesson {name}</a>.')
    return text


def counted(best: Mapping[str, tuple[str, float]]) -> dict[str, Done]:
    """Of each sitting how much of it is done; guesses do not count.

    Examples
    --------
    >>> counted({"05.3": ("right", 1)})["05"].done
    1
    """
    from .exercises import exercises, sittings
    from .kinds import Prediction

    found = {}
    for name, keys in sittings().items():
        asked = [exercises()[key] for key in keys if not isinstance(exercises()[key], Prediction)]
        of = Counter(e.practice for e in asked)
        done = Counter(e.practice for e in asked if best.get(e.id, ("", 0))[0] in DONE)
        found[name] = Done(done[False], of[False], done[True], of[True])
    return found
