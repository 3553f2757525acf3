"""A pasted text made ready: comments apart from what they comment, what its letters stand for, what
it says of convention and units.
"""

import re
from dataclasses import dataclass, field
from functools import cached_property

from ..language.assigned import (
    assigned_in,
    counted_from_zero,
    from_zero,
    joint_values,
    listed_in,
    parameters_of,
    without_overwritten,
)
from ..language.expressions import NoExpression, evaluate, key
from ..language.joined import with_columns
from ..language.letters import unified
from ..language.neutral import neutral
from ..language.repeated import repeated
from ..language.roles import role_of
from ..language.shifted import with_shifts
from ..language.wrapping.comments import without_comments
from ..language.wrapping.unwrapped import unwrapped
from .makers import called_convention
from .matrix.matrices import link_matrix_in
from .orders import order_in

__all__ = ["Source", "convention_titled", "source_of"]

MOST_CHARACTERS, MOST_LINES, LONGEST_LINE, LONGEST_WORD = 12_000, 400, 2_000, 120
WORDS_FOR = {
    "craig": r"(?<![a-z])(modified(?! (?:by|from|on|at|it|the|this|my|version)\b)|modif|craig\w*"
    r"|modifi(?:ziert|cad|cat|é)\w*|mdh|moddh|proximal|khalil|kleinfinger)(?![a-z])"
    r"|модифиц|改进|修正|改進|修改(?=\s*型?\s*d-?h)|(?:수정|변형)\w?\s*d-?h"
    r"|zmodyfikowan|modifikovan|modifikasi"
    r"|(?:d-?h|quy ước)[ ,(]*(?:cải tiến|sửa đổi)|degistirilmis",
    "standard": r"(?<![a-z])(standard(?! (?:units|deviation|robot|gripper|tool|pose|position|arm"
    r"|size|model|config)s?)|classic(?:al)?|distal|paul|spong|siciliano|stddh|sdh|std\.?(?= d-?h)"
    r"|std(?=\.?\))"
    r"|est[aá]ndar|padrão|standardow\w*|standardn\w*"
    r"|klassisch\w*|classique|cl[aá]ss?ic[oa]"
    r"|(?:original|originale[nrs]?) (?:d-?h|denavit|19|paper|method)|algoritmo original"
    r"|denavit and hartenberg \(?1955)(?![a-z])|стандарт|классич|标准|標準|标準|표준|klasyczn"
    r"|standard-?(?:konvention|notation|verfahren|method|variante|definition|form\b|d-?h)"
    r"|standart d-?h|(?:d-?h[ ,(]*|konvensi )standar(?![a-z])"
    r"|(?:quy ước|d-?h[ ,(]*)\s*chuẩn|chuẩn d-?h"
    r"|standaard|\bframe(?:::|\.)dh\(",
}
CONVENTION = re.compile(
    r"^[ \t]*['\"]?(?:dh_?)?convention['\"]?[ \t]*[:=][ \t]*['\"]?([\w -]+)",
    re.MULTILINE | re.IGNORECASE,
)
LENGTH_WORDS = {
    "mm": r"\b(mm|milli-?met(?:er|re)s?|mil[ií]metros?|millim[eè]tres?|millimetri)\b"
    r"|毫米|ミリ|миллиметр|(?<!\w)мм(?!\w)|밀리",
    "cm": r"\b(cm|centi-?met(?:er|re)s?|cent[ií]metros?|centim[eè]tres?|centimetri|zentimetern?)\b"
    r"|厘米|センチ|сантиметр|(?<!\w)см(?!\w)|센티",
    "in": r"\b(inch|inches|zoll|pulgadas|pouces)\b",
    "m": r"(?:\bmet(?:er|re)s?\b|\bmetros?\b|\bm[eè]tres?\b|\bmetri\b|(?<![毫厘])米|\bметр"
    r"|[\[(]\s*m\s*[\])]|\bin m\b|\bunits?:? m\b|\bSI units\b"
    r"|=\s*-?\d*\.?\d+\s*m(?![\w/²^*])"
    r"|(?:length|lengths|linear|distance|position)(?:_?units?)?['\"]?\s*[:=]\s*['\"]?m\b(?!\s*[*/]))",
}
ANGLE_WORDS = {
    "deg": r"\bgra(?:d(?:os?|i)?|us?)\b(?! d[ei] lib)|\bdegrés?\b(?! de lib)|角度制|градус"
    r"|(?<![*/.'\"])\b(deg|degrees?)\b(?!\s*(?:2|to|of freedom|[=(]))|[\[(]°[\])]",
    "rad": r"\bradian[ei]s?\b|\bradiane?n\b|(?<![为到成转換])弧度|ラジアン|радиан"
    r"|(?<![*/.'\"])\b(rad|radians?)\b(?!\s*(?:2|to|[=(]))",
}
DENIED = re.compile(
    r"\b(?:not|non|no|isn't|instead of|rather than|unlike|nicht|kein\w*|pas|sin|не"
    r"|(?:last|i|have|was|were|slightly)|(?:correct|convert|chang|switch|translat|migrat)ed from"
    r"|previously|formerly|earlier|originally|no longer|früher|antes|auparavant)[ -]+['\"]?"
    r"(?:(?:an?|the|in|using|use|el|la|los|de|del|le|les|celle|der|die|das|nach|von|di)\s+){0,3}"
    r"(?:modified|standard|classic(?:al)?|craig|mm|degrees?|deg|radians?"
    r"|rad)\b",
    re.IGNORECASE,
)
# words that praise an arm, in a long line that speaks of no table: un brazo clásico
VAGUE = re.compile(
    r"\b(?:standard|est[aá]ndar|padrão|classic(?:al)?|cl[aá]ss?ic[oa]|classique|klassisch\w*"
    r"|modifi\w*|original\w*|классич\w*|стандарт\w*)\b",
    re.IGNORECASE,
)
OF_TABLES = re.compile(
    r"d-?h(?![a-z])|d&h|denavit|hartenberg|conv[ei]n|konvention|param|paramèt|parám|tab[lue]|notation|notaci"
    r"|formul|matri|frame|variant|version|link|row|defini|method|métod|méthod|transform|theta|alpha"
    r"|craig|modif\w*.*standard|standard.*modif",
    re.IGNORECASE,
)
SENTENCE, LONG = re.compile(r"[^.:;!?\n]+"), 7  # words
# the lines above a table in which its title may stand, and what a title has
TITLE = 8
OF_A_TABLE = re.compile(
    r"d-?h(?![a-z])|denavit|param|parám|paramèt|tab[el]|表|таблиц|^\s*#|:\W*$", re.IGNORECASE
)
CONVERTED = re.compile(  # a (mm -> m): what the numbers were in before
    r"(?<![\w.])(?:mm|cm|inch(?:es)?|milli-?met(?:er|re)s?)\s*(?:->|=>|→|⇒|\bto\b|\binto\b)"
    r"\s*(m|cm|mm|met(?:er|re)s?)\b(?!\s*\()",
    re.IGNORECASE,
)


@dataclass
class Source:
    """A text made ready. ``code`` is it without comments, in plain letters; ``assigned`` what each
    name is said to be; ``comments`` the rest, as (line, text); ``known`` what letters stand for:
    what is assigned, but for the values of joints; ``convention``, ``length`` and ``angle`` what
    words of the text say, "" when they say nothing or both; ``asked_length`` what the reader of the
    text says himself; ``pasted`` the text as it came.
    """

    text: str
    code: str
    assigned: dict
    comments: list = field(default_factory=list)
    known: dict = field(default_factory=dict)
    convention: str = ""
    length: str = ""
    angle: str = ""
    asked_length: str = ""
    pasted: str = ""

    @cached_property
    def link_matrix(self):
        """The link matrix that the text computes, None without one."""
        return link_matrix_in(self.code)

    order = cached_property(order_in)  # every reader asks for it

    @property
    def lines(self):
        """The lines of the code."""
        return self.code.split("\n")

    def role(self, name):
        """The parameter that a name means: as the link matrix of the text has it, else by its
        words.
        """
        role, found = role_of(name)[0], self.link_matrix
        name = name.split(".")[-1]
        if found is None or (role is not None and name not in found.listed):
            return role
        return found.roles.get(name, found.roles.get(re.sub(r"_?\d+$", "", name), role))

    def value(self, text):
        """The Value of an expression of this text, None when it is none."""
        try:
            return evaluate(text.strip().strip("'\"`"), self.known)
        except NoExpression:
            return None


def source_of(text, values=None):
    """The Source of a text; ``values`` are letters' values that were given beside it.

    Raises
    ------
    ValueError
        It is too long to be a table.
    """
    if len(text) > MOST_CHARACTERS or text.count("\n") > MOST_LINES:
        raise ValueError(
            f"recognise_table: expected one table, found a text of {len(text)} characters in"
            f" {text.count(chr(10)) + 1} lines; paste the rows only"
        )
    if any(len(line) > LONGEST_LINE for line in text.split("\n")):
        raise ValueError(
            f"recognise_table: expected lines of at most {LONGEST_LINE} characters, found a longer"
            " one; break it where its rows end"
        )
    if re.search(rf"\w{{{LONGEST_WORD}}}|[\[({{]{{{LONGEST_WORD}}}", text):
        raise ValueError(
            "recognise_table: expected numbers and names, found more than"
            f" {LONGEST_WORD} characters without a gap; paste the rows only"
        )
    pasted, text = text, unified(unwrapped(text))
    comments: list[tuple[int, str]] = []
    code = without_comments(text, comments)
    if not re.search(r"\d", code):
        code = re.sub(r"^[ \t]*(?:%+|#+|//+|\*+(?!\*))", "", text, flags=re.MULTILINE)
    code = neutral(repeated(re.sub(r"\b(?:self|this)(?:\.|->)(?=[A-Za-z_])", "", code)))
    code = with_shifts(without_overwritten(from_zero(_two_families(with_columns(code)))))
    known = assigned_in(code)
    _require_apart(code)
    for name, value in listed_in(code).items():
        known.setdefault(name, value)
    for _, comment in comments:
        for name, value in assigned_in(comment).items():
            known.setdefault(name, value)
    given = {
        counted_from_zero(key(str(name)), code): float(value)
        for name, value in (values or {}).items()
    }
    stands = joint_values(known) | parameters_of(code)
    return Source(
        text,
        code,
        known,
        comments,
        {**{name: said for name, said in known.items() if name not in stands}, **given},
        called_convention(code) or _convention(text) or _convention(_of_tex(pasted)),
        _only(_prose(text, known), LENGTH_WORDS),
        _only(_prose(text, known), ANGLE_WORDS),
        pasted=pasted,
    )


def _of_tex(text):
    """The comments of a text in TeX."""
    return "\n".join(re.findall(r"(?<!\\)%(.*)", text)) if "\\begin{" in text else ""


def _prose(text, known):
    """The text without units that are factors of its own, as in 333*mm."""
    text = CONVERTED.sub(r"\1", text)
    text = re.sub(r"\bmm/s\w*|(?<![*/])[*/]\s*(?:mm|cm)\b|(?<=\d)\s*(?:mm|cm)\b", "", text)
    text = re.sub(r"^.*\brpy/.*$", "", text, flags=re.MULTILINE | re.IGNORECASE)
    own = [unit for unit in ("mm", "cm", "inch", "meter", "metre") if unit in known]
    return re.sub(rf"\b(?:{'|'.join(own)})\b", "", text) if own else text


def _convention(text):
    """What a line ``convention: …`` says, else what words in the text do."""
    said = [_only(value, WORDS_FOR) for value in CONVENTION.findall(text)]
    return said[0] if len(said) == 1 and said[0] else _only(text, WORDS_FOR)


def convention_titled(source, line):
    """The convention that the title of a table names, which begins in a line, where the text speaks
    of both; where the line is not known, 0, what all titles of the text name; "" without one.
    """
    lines = source.text.split("\n")
    above = lines[max(line - 1 - TITLE, 0) : line - 1] if line else lines
    titles = (one for one in reversed(above) if OF_A_TABLE.search(one))
    said = [named for one in titles if (named := _convention(one))]
    return said[0] if said and (line or len(set(said)) == 1) else ""


def _only(text, words):
    """The one name whose words stand in the text, and are not denied there."""
    text = DENIED.sub(" ", text)
    if words is WORDS_FOR:
        text = SENTENCE.sub(_without_praise, text)
    said = [name for name, pattern in words.items() if re.search(pattern, text, re.IGNORECASE)]
    return said[0] if len(said) == 1 else ""


def _without_praise(match):
    """A long sentence of prose that speaks of no table, without words that praise an arm."""
    said = match[0]
    prose = len(said.split()) > LONG and not re.search(r"[={}]", said)
    return VAGUE.sub(" ", said) if prose and not OF_TABLES.search(said) else said


def _require_apart(code):
    """``a1`` and ``a_1`` are one name here; a text that gives them two values would be misread."""
    values: dict = {}
    for name, value in re.findall(r"^[ \t]*(\w+)[ \t]*=[ \t]*([^=\n;#]+)", code, re.MULTILINE):
        if not re.match(r"q|th?(?:eta)?_?\d", name.lower()):  # joint values are given again
            values.setdefault(key(name), {})[name] = value.strip()
    for names in values.values():
        if len(names) > 1 and len(set(names.values())) > 1:
            shown = " and ".join(list(names)[:2])
            raise ValueError(
                f"recognise_table: {shown} are different numbers in this text; what is each? Give"
                " them names that differ in more than an underscore"
            )


def _two_families(code):
    """``[a1, a2]`` and ``[a_1, a_2]`` in one text are two parameters: the second gets another
    name.
    """
    lists = [
        re.findall(r"\b[A-Za-z]+_?\d\b", inside) for inside in re.findall(r"\[([^\[\]]*)\]", code)
    ]
    with_, without = (
        {name for names in lists for name in names if ("_" in name) == mark} for mark in (1, 0)
    )
    for family in {name.split("_")[0] for name in with_}:
        both = {
            name
            for name in with_
            if name.startswith(f"{family}_") and name.replace("_", "") in without
        }
        if len(both) > 1:
            code = re.sub(rf"\b{family}_(?=\d\b)", f"{family}under", code)
    return code
