"""Formulas that a page shows as pictures, in the words that the pictures were made of."""

import re
from urllib.parse import unquote

__all__ = ["without_pictures"]

# <!-- $\pi/2$ --> <img src="…">, as editors write it that draw formulas
NOTED = re.compile(r"<!--\s*\$+([^$\n]*)\$+\s*-->[ \t]*<img\b[^<>\n]*>", re.IGNORECASE)
PICTURE = re.compile(
    r"<img\b(?P<tag>[^<>\n]*)>|!\[(?P<words>[^\]\n]*)\]\((?P<link>[^()\s]*)\)", re.IGNORECASE
)
IN_ADDRESS = re.compile(r"(?:[?&](?:math|tex|eq|chl)=|latex\?)([^\"'&\s]*)", re.IGNORECASE)
ALT = re.compile(r"\balt\s*=\s*[\"']([^\"'\n]+)[\"']", re.IGNORECASE)
TAG = re.compile(r"</?(?:a|span|font|b|i|em|strong|p|div)\b[^<>\n]*>", re.IGNORECASE)
DRESS = re.compile(  # colours and sizes of a formula
    r"\\color\{\w+\}|\\(?:large|small|inline|bg_\w+|dpi\{\d+\}|displaystyle|textstyle)\b", re.I
)


def without_pictures(text):
    r"""The text with the formulas that its pictures show, and without tags in lines with pipes: a
    pipe in an address or an attribute ends no cell, and a picture that says nothing is a ``?``.

    Examples
    --------
    >>> without_pictures('| <!-- $\\color{grey}\\pi/2$ --> <img src="x?a|b"> | 0 |')
    '| \\pi/2 | 0 |'
    >>> without_pictures('| <img src="https://host/math?math=%5Calpha"> | 0 |')
    '| \\alpha | 0 |'
    """
    text = NOTED.sub(lambda match: _plain(match[1]), text)
    lines = text.split("\n")
    return "\n".join(
        TAG.sub("", PICTURE.sub(_shown, line)) if "|" in line and PICTURE.search(line) else line
        for line in lines
    )


def _shown(picture):
    """The formula in the address of a picture, else the words for it; "?" without either."""
    said = IN_ADDRESS.search(picture["tag"] or picture["link"] or "")
    words = picture["words"] or "".join(ALT.findall(picture["tag"] or ""))
    return (_plain(unquote(said[1])) if said else words.strip()) or "?"


def _plain(formula):
    return DRESS.sub("", formula).strip()
