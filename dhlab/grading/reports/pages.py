"""HTML pages from templates: one file each, everything escaped, nothing fetched and no script run
by whoever opens it.
"""

import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from ...formats import plainyaml
from ..shown import readable

__all__ = ["render", "words", "duration"]

HERE = Path(__file__).parent
LONGEST = 2000  # characters of one text; what a stranger's program says can be any length


def render(template: str, **values: Any) -> str:
    """A page from ``templates/``; every value is escaped, and a name that the template does not
    know stops it.

    Examples
    --------
    >>> "<b>" in render("line.html", text="<b>")
    False
    """
    return _environment().get_template(template).render(**values)


@cache
def _environment():
    try:
        import jinja2
    except ImportError:
        raise ValueError(
            "expected Jinja2 for the pages, found that it is not installed; run: pip install"
            ' "dhlab-kinematics[teach]"'
        ) from None
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(HERE / "templates"),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        finalize=_readable,
    )
    environment.filters["number"] = lambda value: f"{round(value, 2):g}"
    environment.filters["percent"] = lambda value: f"{100 * value:.0f}"
    environment.filters["code"] = _with_code
    return environment


def _with_code(text):
    """A text of the course as HTML: what stands in backticks is code."""
    from markupsafe import Markup, escape

    return Markup(re.sub(r"`([^`]+)`", r"<code>\1</code>", str(escape(text))))


def _readable(value):
    """A text that is readable, and not too long."""
    if type(value) is not str:
        return value
    return readable(value[:LONGEST]).replace("\t", "·") + "…" * (len(value) > LONGEST)


def duration(days: float, said: Mapping[str, str]) -> str:
    """How late something is, in days and hours or in hours and minutes.

    Examples
    --------
    >>> duration(0.0625, words("en")), duration(1.25, words("en")), duration(2, words("en"))
    ('1 h 30 min', '1 d 6 h', '2 d')
    """
    minutes = max(1, round(days * 1440))
    parts = [(minutes // 1440, "day"), (minutes // 60 % 24, "hour"), (minutes % 60, "minute")]
    shown = [
        f"{count} {said[unit]}"
        for count, unit in (parts[:2] if minutes >= 1440 else parts[1:])
        if count
    ]
    return " ".join(shown)


@cache
def words(language: str) -> dict[str, Any]:
    """The words of a feedback page by key, and the language they are in; English where the language
    has none.

    Examples
    --------
    >>> words("en")["wrong"], words("zh_CN")["lang"], words("fr")["lang"]
    ('Not right', 'zh-CN', 'en')
    """
    known = plainyaml.read(HERE / "words.yaml", "the words of the feedback").plain()
    found = language if language in known else "en"
    return known["en"] | known[found] | {"lang": found.replace("_", "-")}
