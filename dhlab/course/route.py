"""The way through the course: a map of its sittings with what is done of each, where one stopped,
and where the pre-test says to begin.
"""

from collections.abc import Mapping, Sequence
from html import escape

from .verdict import RECORDED, RIGHT

__all__ = ["SITTINGS", "Map", "begin_at", "counted", "file_of", "stopped_in"]

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
        answer counts as one that is not known; a wrong answer and "?" count alike.

    Examples
    --------
    >>> begin_at({})[0]
    '01'
    >>> begin_at({"00.2": True, "00.3": True, "00.4": True, "00.5": False, "00.6": True})
    ('04', ['05'])
    """
    open_ = [lesson for key, lesson in ASKED_BY.items() if not known.get(key)]
    first = next((lesson for lesson in open_ if lesson in FIRST), "04")
    return first, [lesson for lesson in open_ if lesson > first]


def stopped_in(entries: Sequence[Mapping[str, object]], done: Mapping[str, tuple[int, int]]) -> str:
    """The sitting of the last check, or the next one where that is finished; "00" at first.

    Parameters
    ----------
    entries : list of dict
        The log, oldest first; an "exercise" each.
    done : dict
        Of each sitting how many exercises are done, of how many.
    """
    from .exercises import sittings

    last = entries[-1]["exercise"] if entries else None
    sitting = next((name for name, keys in sittings().items() if last in keys), "00")
    names = list(SITTINGS)
    finished = done[sitting][0] == done[sitting][1]
    return names[min(names.index(sitting) + finished, len(names) - 1)]


class Map:
    """The course as a row: every sitting with how much of it is done; shown on top of a lesson.

    Parameters
    ----------
    done : dict
        Of each sitting how many exercises are done, of how many.
    here : str
        The sitting that is open, or "".
    words : str
        What is said below it.
    """

    def __init__(
        self, done: Mapping[str, tuple[int, int]], here: str = "", words: str = ""
    ) -> None:
        self._done, self._here, self._words = dict(done), here, words

    def to_dict(self) -> dict[str, tuple[int, int]]:
        """{sitting: (done, of)}."""
        return self._done

    def __str__(self) -> str:
        row = "  ".join(
            f"{'>' if name == self._here else ''}{name} {_amount(*self._done[name])}"
            for name in self._done
        )
        return row + (f"\n{self._words}" if self._words else "")

    __repr__ = __str__

    def _repr_html_(self):
        items = "".join(self._item(name) for name in self._done)
        words = f"<p>{_linked(self._words)}</p>" if self._words else ""
        return (
            '<nav aria-label="The course"><ol style="list-style:none;padding:0;margin:.3em 0;'
            f'display:flex;flex-wrap:wrap;gap:.35em">{items}</ol>{words}</nav>'
        )

    def _item(self, name):
        done, of = self._done[name]
        here = name == self._here
        title = f"{name} {SITTINGS[name][1]}"
        text = f"{name} {_amount(done, of)}"
        part = f"background:linear-gradient(90deg,#1a7f3740 {100 * done // of}%,transparent 0)"
        strong = ";border-color:currentColor;font-weight:700" if here else ""
        inner = (
            f'<span aria-current="page">{text}</span>'
            if here
            else f'<a href="{file_of(name)}">{text}</a>'
        )
        label = escape(f"{title}: {done} of {of} exercises done")
        return f'<li title="{label}" style="{CHIP};{part}{strong}">{inner}</li>'


def _amount(done, of):
    return "✓" if done == of else f"{done}/{of}"


def _linked(words):
    """The words, every "lesson NN" a link to it."""
    text = escape(words)
    for name in sorted(SITTINGS, key=len, reverse=True):
        text = text.replace(f"lesson {name}.", f'<a href="{file_of(name)}">lesson {name}</a>.')
    return text


def counted(best: Mapping[str, tuple[str, float]]) -> dict[str, tuple[int, int]]:
    """Of each sitting how many of its exercises are done, of how many; guesses do not count.

    Examples
    --------
    >>> counted({"05.3": ("right", 1)})["05"][0]
    1
    """
    from .exercises import exercises, sittings
    from .kinds import Prediction

    found = {}
    for name, keys in sittings().items():
        asked = [key for key in keys if not isinstance(exercises()[key], Prediction)]
        found[name] = sum(best.get(key, ("", 0))[0] in DONE for key in asked), len(asked)
    return found
