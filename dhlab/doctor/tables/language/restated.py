"""Other spellings of an assignment, a number or a row, said as ``name = value`` or plainly, before
anything is read.
"""

import re

from .brackets import cells_in
from .roles import ROLES, role_of

__all__ = ["restated"]

# LinuxCNC's setp genserkins.ALPHA-1 -1.571
SETP = re.compile(r"^[ \t]*setp[ \t]+[\w.]*\.(A|ALPHA|D|THETA)-(\d+)[ \t]+(\S+)", re.MULTILINE)
# link_0 (offset -90) (D 0.2) (A 0) (alpha 90)
IN_BRACKETS = re.compile(r"\(\s*([A-Za-z]\w*)\s+(-?\d[\d.]*)\s*\)")
# rows of LaTeX one behind the other
ONE_LINE = re.compile(r"\\begin\{(?:array|tabular)\}[^\n]*\\\\[^\n]*\\\\[^\n]*")
EQUATION = re.compile(r"(\w+)\s*&=\s*(?:[^\n=&]*=)*\s*([^\n=&]*?)\s*(?:\\\\)?$", re.MULTILINE)
DECIMAL_COMMA = re.compile(r"(=\s*-?\d+),(\d+\s*(?:mm|cm|m)\b)")
MIXED = re.compile(r"(?<![\w./])(-?)(\d+)[ -](\d+)/(\d+)(?=\s*(?:\"|″|''|in\b|inch))")
INCHES = re.compile(
    r"(?<![\w.'\"])(?<!['\"]-)(-?\d+(?:\.\d+)?)(?:\"|″|'')(?=\s|$|[,;|)])", re.MULTILINE
)
# KDL: const Joint rotZ(Joint::RotZ);
KDL_JOINT = re.compile(r"\bJoint\s+(\w+)\s*[({]\s*((?:\w+::)*Joint::\w+)\s*[)}]\s*;")
MATRIX = re.compile(r"\b([A-Za-z]\w*)[ \t]*=[ \t]*\[([^\[\]]*;[^\[\]]*)\]")


# YAML: PI_2: &PI_2 1.5708, then *PI_2
ANCHOR = re.compile(r"&([A-Za-z]\w*)[ \t]+(-?[\d.][\w.+-]*)[ \t]*$", re.MULTILINE)


# Eigen: Translation3d(a, 0, 0) * AngleAxisd(alpha, Vector3d::UnitX())
ALONG = re.compile(r"(?:\w+::)*Translation3[df]\s*\(")
ON_AXIS = re.compile(
    r"(?:\w+::)*AngleAxis[df]\s*\(\s*([^,;]+?)\s*,\s*(?:\w+::)*Unit([XYZ])\(\)\s*\)"
)
# np.matrix('0 0.3; 0 0')
IN_QUOTES = re.compile(r"(?<=mat)(?:rix)?\(\s*['\"]([^'\"\n]*;[^'\"\n]*)['\"]\s*\)")
# <xacro:property name="a1" value="0.3"/>
PROPERTY = re.compile(
    r"^[ \t]*<\S+\s+name\s*=\s*[\"'](\w+)[\"']\s+value\s*=\s*[\"']([^\"'\n]*)[\"']\s*/>",
    re.MULTILINE,
)
# {"value": 210, "unit": "mm"}
MEASURED = re.compile(
    r"\{\s*['\"]?val(?:ue)?['\"]?\s*:\s*([^,{}\[\]\n]+?)\s*,\s*['\"]?units?['\"]?\s*:\s*['\"]?(\w+)['\"]?\s*\}"
)
# dh["alpha"] = [0, 90], C#'s float[] a = new float[6] {0, …}, Markdown's `L1 = 0.2`
UNDER_KEY = re.compile(
    r"^[ \t]*\w+\[['\"]([A-Za-z]\w*)['\"]\]\s*=\s*(?=\[|[\w.]*array\()", re.MULTILINE
)
MADE_ROOM = re.compile(r"=\s*new\s+\w+\s*(?:\[\w*\])+\s*(?=\{)")
CODE_SPAN = re.compile(r"(?<![`:])`([^`\n]+)`(?!`)")
# theta = q + np.array([0, -pi/2])
ONTO_Q = re.compile(
    r"^([ \t]*)(?:theta|th|q)\w*\s*=\s*(?:theta|th|q|joint)\w*\s*\+\s*"
    r"(?=(?:(?:np|numpy)\.)?(?:array\(\s*)?\[)",
    re.MULTILINE,
)
# a factor that says what it is and is defined elsewhere: 145.2 * mm2m
TO_METRES = re.compile(r"(?<=[\d)])\s*\*\s*mm_?(?:2|to)_?m\b", re.IGNORECASE)
# SymPy's Symbol("q1") where it is used
SYMBOL = re.compile(
    r"(?<!=)(?<!= )\b(?:\w+\.)?sym(?:bols?)?\(\s*(['\"])([A-Za-z]\w*)\1[^()\n]*\)", re.I
)
LISTED = re.compile(r"'(\w+)'\s*,\s*\{([^{}']*)\}")  # of MATLAB's struct('d', {0.2, 0})
STRUCT = re.compile(r"\bstruct\((?:\s*'\w+'\s*,\s*\{[^{}']*\}\s*,?)+\)")
# DH(:,1) = [0.5 1]'; % a
COLUMN = re.compile(
    r"^[ \t]*\w+[(\[]:\s*,\s*\d[)\]]\s*=\s*(\[[^\]\n]*\]'?)\s*;?"
    r"[ \t]*[%#][ \t]*(theta|d|a|alpha)\b[^\n]*$",
    re.MULTILINE,
)
COUNTED = re.compile(r"^([ \t]*(\w+)\s*=\s*(\d+)\s*;)([^\n]*\(\2\)[^\n]*)$", re.MULTILINE)
OF_RAD = re.compile(r"\((?:const\s+)?(?:double|float)\s*&?\s*rad\)\s*(?:const\s*)?\{[^{}]*\}")
FLAG = re.compile(r",\s*(true|false)\s*(?=[\]}])", re.IGNORECASE)  # at the end of a row
OF_UNIT = re.compile(r"(=\s*-?\d*\.?\d+)\s*[(\[](mm|cm|m)[)\]]")  # L4 = 0.1 (m)
# disp(" 1 | 0 | 90 "): a table that a program prints
PRINTED = re.compile(
    r"^[ \t]*(?:[\w.]*(?:disp|print\w*|log|cout)[ \t]*(?:\(|<<)[ \t]*)"
    r"([\"'])([^\n]*(?:[|\t]|\\t)[^\n]*?)(?:\\n)?\1[^\n]*$",
    re.MULTILINE,
)
LIST = re.compile(
    r"^[ \t]*([^\W\d]\w*)[ \t]*([=:])[ \t]*([^\n=:\[\]{};|\"#]+?)"
    r"([ \t]*\((?:mm|cm|m|deg|rad|°)\))?[ \t]*$",
    re.MULTILINE,
)
# <a value="0.3"/>, the element being the number's name
VALUED = re.compile(r"<(\w+)\s+(?:value|val|v)\s*=\s*[\"']([^\"'\n]*)[\"']\s*/>")
# theta = q1, d = 0,2, a = 0: a comma within a number, where another and a space end it
IN_NUMBER = re.compile(r"([=:]\s*-?\d+),(\d+)(?=\s*(?:°|mm|cm|m)?\s*(?:[,;]\s|$))")
PAIRED = re.compile(r"([^\W\d]+)_?\d?\s*[=:]")
TAG = re.compile(r"^[ \t]*<\w[^<>\n]*>", re.MULTILINE)
ATTRIBUTE = re.compile(r"([\w.:]+)\s*=\s*[\"']([^\"'<>]*)[\"']\s*(?:/?>)?")


def restated(text):
    r"""The text, with what is spelled otherwise said plainly.

    Examples
    --------
    >>> restated("setp genserkins.ALPHA-1 -1.571")
    'alpha1 = -1.571'
    >>> restated('a = 7 3/8"')
    'a = 7.375in'
    >>> restated("dh = [1 2; 3 4]; d = dh(2,1)")
    'dh = [1 2; 3 4]; d = (3)'
    """
    text = SETP.sub(lambda m: f"{m[1].lower()}{m[2]} = {m[3]}", text)
    text = "\n".join(_with_points(_named(line)) for line in text.split("\n"))
    text = ONE_LINE.sub(lambda m: re.sub(r"\\\\\s*(?:\\hline)?", "\n", m[0]), text)
    text = "\n".join(_in_columns(line) for line in text.split("\n"))
    text = EQUATION.sub(r"\1 = \2", text)
    text = DECIMAL_COMMA.sub(r"\1.\2", text)
    text = MIXED.sub(lambda m: f"{m[1]}{int(m[2]) + int(m[3]) / max(int(m[4]), 1):g}", text)
    text = INCHES.sub(_inches, text)
    text = ON_AXIS.sub(r"rot\2(\1)", ALONG.sub("trans(", text))
    if len(re.findall(r"\\n\s*\|", text)) > 2:
        text = text.replace("\\n", "\n")  # a text within a program
    # jj = 2; L(jj) = link(0, theta(jj)); and an angle that has the name of a unit
    text = COUNTED.sub(lambda m: m[1] + m[4].replace(f"({m[2]})", f"({m[3]})"), text)
    text = OF_RAD.sub(lambda m: re.sub(r"\brad\b", "theta", m[0]), text)
    text = ONTO_Q.sub(r"\1theta_offset = ", text)
    text = CODE_SPAN.sub(_span, MADE_ROOM.sub("= ", UNDER_KEY.sub(r"\1 = ", text)))
    if not re.search(r"\bmm_?(?:2|to)_?m\s*=", text, re.IGNORECASE):
        text = TO_METRES.sub(" / 1000", text)
    text = STRUCT.sub(lambda m: "\n".join(f"{n} = [{v}];" for n, v in LISTED.findall(m[0])), text)
    text = MEASURED.sub(r"\1 \2", PROPERTY.sub(r"\1 = \2", text))
    text = OF_UNIT.sub(r"\1 \2", _with_brackets(text))
    if len(PRINTED.findall(text)) > 2:
        text = PRINTED.sub(lambda m: m[2].replace("\\t", "\t"), text)
    text = COLUMN.sub(r"\2 = \1;", text) if len(COLUMN.findall(text)) > 2 else text
    text = _with_sigma(text)
    text = SYMBOL.sub(r"\2", IN_QUOTES.sub(r"([\1])", text))
    text = VALUED.sub(lambda m: f"{m[1]}: {m[2]}, " if role_of(m[1])[0] in ROLES else m[0], text)
    text = TAG.sub(lambda m: ATTRIBUTE.sub(r"\1 = \2,", m[0]), text)
    for name, number in ANCHOR.findall(text):
        text = re.sub(rf"\*{name}\b", number, text)
    text = ANCHOR.sub(r"\2", text)
    for name, kind in KDL_JOINT.findall(text):
        text = re.sub(rf"\b{name}\b(?!\s*[({{])", f"Joint({kind})", text)
    return _without_indices(text)


def _span(match):
    """What stands between grave accents, and nothing of a link that names parameters alone, as in
    ``Link([theta d a alpha])``.
    """
    names = re.findall(r"\w+", match[1].partition("(")[2])
    link = re.match(r"[\w.]*(?:link|revolute|prismatic)\w*\(", match[1], re.IGNORECASE)
    return "" if link and len(names) > 3 and all(role_of(n)[0] for n in names) else match[1]


def _in_columns(line):
    r"""``d_1 &= 2, & a_1 &= 0 \\`` with nothing but commas between what it says."""
    if len(re.findall(r"&\s*=", line)) < 2:
        return line
    return re.sub(r",?\s*&\s*", ", ", re.sub(r"&\s*=", "=", line))


def _with_points(line):
    """``d = 0,2, a = 0`` as ``d = 0.2, a = 0`` in a line that names three parameters."""
    named = {role_of(name)[0] for name in PAIRED.findall(line)} & set(ROLES)
    return IN_NUMBER.sub(r"\1.\2", line) if len(named) > 2 else line


def _with_brackets(text):
    """``d = 0.1, 0, 0.3`` as ``d = [0.1, 0, 0.3]``, where d, a and alpha stand so."""
    found = [
        (match, cells)
        for match in LIST.finditer(text)
        if role_of(match[1])[0] in (*ROLES, "r", "offset") and len(cells := cells_in(match[3])) > 1
    ]
    named = [role_of(match[1])[0] for match, _ in found]
    counts = {len(cells) for _, cells in found}
    if len(set(named)) < 3 or len(set(named)) < len(named) or len(counts) > 1:
        return text
    for match, cells in reversed(found):
        listed = f"{match[1]} = [{', '.join(cells)}]{match[4] or ''}"
        text = text[: match.start()] + listed + text[match.end() :]
    return text


def _with_sigma(text):
    """``[0, 0.1, 0, 0, True]`` with sigma, 1 of a joint that slides, where the text says of what
    True speaks.
    """
    slides, turns = (
        bool(re.search(word, text, re.IGNORECASE)) for word in ("prismatic", "revolut")
    )
    if slides == turns:
        return text
    as_named = slides or bool(re.search(r"(?:alpha|theta)\W+(?:is_?)?revolut", text, re.IGNORECASE))
    return FLAG.sub(lambda m: f", {int((m[1].lower() == 'true') == as_named)}", text)


def _inches(match):
    """``7"`` as ``7in``, but for the end of a quotation, as in ``"q2-90"``."""
    before = match.string[: match.start()].rsplit("\n", 1)[-1]
    opened = len(re.findall(r'(?<!\d)"', before))
    return match[0] if opened % 2 else f"{match[1]}in"


def _named(line):
    """``(D 0.2) (A 0)`` as ``D = 0.2, A = 0``, where a line has three of them."""
    if len(IN_BRACKETS.findall(line)) < 3:
        return line
    return ", ".join(f"{name} = {value}" for name, value in IN_BRACKETS.findall(line))


def _without_indices(text):
    """``dh(2,1)`` as the number that stands there in ``dh = [ …; … ]``."""
    for name, inside in MATRIX.findall(text):
        plain = re.sub(r"%.*|\.\.\.", "", inside)
        rows = [
            re.split(r"[ \t]*,[ \t]*|[ \t]+", row.strip()) for row in re.split(r"[;\n]+", plain)
        ]
        rows = [row for row in rows if row != [""]]

        def entry(match, rows=rows):
            i, j = int(match[1]) - 1, int(match[2]) - 1
            there = 0 <= i < len(rows) and 0 <= j < len(rows[i])
            return f"({rows[i][j]})" if there else match[0]

        text = re.sub(rf"\b{name}\((\d+)\s*,\s*(\d+)\)(?!\s*=)", entry, text)
    return text
