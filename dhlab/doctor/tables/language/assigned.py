"""What the names of a text are said to be: assigned, defined, listed under an index."""

import re

from .brackets import cells_in
from .expressions import NoExpression, evaluate, key

__all__ = [
    "DEFINED",
    "assigned_in",
    "counted_from_zero",
    "from_zero",
    "joint_values",
    "listed_in",
    "parameters_of",
    "without_overwritten",
]

DEFINED = re.compile(r"^\s*#\s*define\s+(\w+)\s+(.+?)\s*$", re.MULTILINE)
ASSIGNED = re.compile(
    r"(?:^|[;,{(\s|])['\"]?([A-Za-z_]\w*(?:(?:\.|->)[A-Za-z_]\w*)*)['\"]?\s*"
    r"(?::=|=(?!=)|:(?![:=]))[ \t]*"
    r"((?:[^=;\n,|{}\[\]:'\"()]|(?<=\w)\[\d\]|\((?:[^=;\n|{}\[\]:'\"()]|\([^=;\n|{}\[\]:'\"()]{0,40}\)){0,80}\)|[()]){1,120})"
)
# the cells of a table that says what letters are
LETTER = re.compile(r"(?:alpha|theta|[adlhr])_?\{?\d+\}?", re.IGNORECASE)
NUMBER = re.compile(r"[-+]?\d*\.?\d+\s*(?:mm|cm|m|deg|°|rad)?")
UNIT = re.compile(r"[\[(]?(?:mm|cm|m|deg|rad)[\])]?")
OF_A_ROW = re.compile(r"theta|\bpi\b|\b[qt]_?\{?\d")  # a cell of the table itself
# a number under a name, alone in its line; and where the order of lines is no order of time
PLAIN = re.compile(r"\s*([A-Za-z_]\w*)\s*=\s*[-+*/.\deE() \t]+;?\s*")
BEGINS = re.compile(
    r"\s*(?:(?:async\s+)?def|class|function|func|fn|if|elif|else|for|while|switch|case|end|try|with)\b"
    r"|[^=]*[{}]|\s*\[[^\[\]=,;]*\]\s*$|\s*\[\[[^\[\]=,;]*\]\]\s*$"  # [joint2] of INI and TOML
)
JOINT = re.compile(r"(?:theta|th|q|t|joint|phi)\d*|q\[\d+\]")
# an element of an array of joint values; of one whose name a column of the table may have as well
ELEMENT = re.compile(r"(?:joint(?:s|angles?|values?|pos\w*|states?)?|jt|ja|jv)\[\d+\]")
EITHER = re.compile(r"(thetas?|th|t|phi|angles?)\[\d+\]")
COLUMN = re.compile(r"(?:alphas?|alfas?|[ad]|d?dist\w*|lengths?|twists?)\[\d+\]")
# d1 (height of the base): 125 mm, d1 is 125 mm
TOLD = re.compile(
    r"(?:\band[ \t]+)?`?(?<!\w)([adlhrADLHR]_?\d+)`?(?:"
    r"[ \t]+\([^()=:|\n]*[a-z]{3}[^()=:|\n]*\)`?[ \t]*[:=][ \t]*(?=[-+]?\d)"
    r"|[ \t]+(?:is|equals|equal to|of|being|beträgt|est|vale)[ \t]+"
    r"(?=[-+]?[\d.]+ ?(?:mm|cm|m)[ \t]*(?:[.;,)\n]|and\b|$)))"
)
TAKEN = re.compile(r"\b(?:def|function|func|fn)\s[^()\n]*\(([^()]*)\)")
OF_ANOTHER = re.compile(r"(?<![A-Za-z_])(?!pi\b|np\b|math\b)[a-z]+_?\d")  # joint's variable
JOINED = re.compile(
    r"\s*(?:\b(?:and|und|sowie|et|y|e|en|och|oraz|ve|dan|и)\b|和|及|と)\s*(?=\w+\s*=)"
)
RANGED = re.compile(
    r"\s*[-+]?[\d.]+\s*(?:°|deg|mm|cm|m)?\s*(?:\bto\b|\bbis\b|\.{2,3}|…|~)\s*[-+]?\d"
    r"|\s*(?:0|-[\d.]+)\s*(?:°|deg|mm|cm|m)?\s*-\s*\+?[\d.]+\s*(?:°|deg|mm|cm|m)\s*$"
)
EQUAL = re.compile(  # a2 = a3 = 125 mm
    r"\b((?:[A-Za-z_]\w*\s*=\s*){2,})([^=;,\n]+?)\s*(?=[;\n]|,|\.\s|\.?$)"
)
# numbers under one name, used one by one: lengths = [0.33, 0.37], then lengths[0]
LISTED = re.compile(
    r"\b([A-Za-z_]\w*)(?:\[\w*\])?\s*=\s*(?:\w+\.)?(?:array\(\s*)?"
    r"[\[{]((?:[-+*/.\deE,\s]|\b(?:np\.|numpy\.|math\.)?pi\b"
    r"|\b(?:(?:np|math)\.)?(?:d2r|deg2rad|radians)\([-+.\d\s]+\)"
    r"|\((?:[-+*/.\d\s]|\bpi\b|\([-+.\d\s]+\))+\))+)[\]}]"
)


def without_overwritten(code):
    """The code without values that are overwritten before anything uses them: ``L1 = 0.057`` where
    ``L1 = 1`` follows, and nothing names L1 nor begins anew between.

    Examples
    --------
    >>> without_overwritten("L1 = 2\\nL2 = 3\\nL1 = 4\\nd = L1")
    '\\nL2 = 3\\nL1 = 4\\nd = L1'
    """
    lines = code.split("\n")
    held: dict = {}
    for k, line in enumerate(lines):
        if BEGINS.match(line):
            held = {}
        found = PLAIN.fullmatch(line)
        for name in {*re.findall(r"[A-Za-z_]\w*", line)} & set(held):
            at = held.pop(name)
            if found and found[1] == name and len(re.findall(rf"\b{name}\b", line)) == 1:
                lines[at] = ""
        if found:
            held[found[1]] = k
    return "\n".join(lines)


def assigned_in(text):
    """What each name of a text is said to be."""
    known = {key(name): value.split("//")[0] for name, value in DEFINED.findall(text)}
    text = re.sub(r"(?<=\w):[ \t]+(?=\w+[ \t]*=(?!=))", "; ", text)  # link lengths: l1 = 0.5
    text = TOLD.sub(r"; \1 = ", EQUAL.sub(_each, text))
    for name, value in ASSIGNED.findall(JOINED.sub(", ", text)):
        value = re.split(r"(?<=[\w)])\s{2,}(?=[A-Za-z])", value)[0]
        if RANGED.match(value):
            continue  # d4: 0 to 0.15 m says how far the joint goes
        for said in (value, *_shorter(value)):
            said = said.strip().rstrip(".)")
            said += ")" * max(said.count("(") - said.count(")"), 0)
            try:
                evaluate(said, dict(known))
            except NoExpression:
                continue
            again = re.compile(rf"\b{re.escape(name)}\b")
            if not again.search(said):
                known.setdefault(key(name), said)
            elif key(name) in known and (
                not re.search(r"[-+]", said) or _again_before_use(name, text)
            ):  # a1 = a1 / 1000; d1 = d1 + h
                known[key(name)] = again.sub(f"({known[key(name)]})", said)
            break
    for name, items in LISTED.findall(text):
        for k, item in enumerate(cells_in(items)):
            known.setdefault(key(f"{name}[{k}]"), item.strip())
    return known


def _each(match):
    """``a2 = a3 = 125 mm`` with the number behind each name."""
    return "; ".join(f"{name.strip()} = {match[2]}" for name in match[1].split("=")[:-1]) + "; "


def _again_before_use(name, text):
    """Whether a program gives a name its number, adds something to it once in the same block, and
    uses it below only: ``d1 = 0.1``, then ``d1 = d1 + h``.

    Examples
    --------
    >>> _again_before_use("d", "d = 1\\nd = d + h\\n[0 d]")
    True
    >>> _again_before_use("d", "d = 1\\n[0 d]\\nd = d + h")
    False
    """
    given = re.compile(rf"[ \t]*{re.escape(name)}\s*=(?!=)")
    lines = text.split("\n")
    named = [
        k for k, line in enumerate(lines) if re.search(rf"(?<![\w.]){re.escape(name)}\b", line)
    ]
    if [k for k in named if given.match(lines[k])] != named[:2] or len(named) < 2:
        return False
    first, second = named[:2]
    depths = {len(lines[k]) - len(lines[k].lstrip()) for k in (first, second)}
    return len(depths) == 1 and not any(BEGINS.match(line) for line in lines[first + 1 : second])


def listed_in(text):
    """What tables of names and numbers say, one name and one number a row: ``| d1 | 0.089 | m |``.

    Examples
    --------
    >>> listed_in("| Base height | d1 | 0.089 | m |\\n| J1 | d1 | q1 | 0 | pi/2 |")
    {'d1': '0.089 m'}
    """
    known: dict = {}
    for line in text.split("\n"):
        cells = [cell.strip(" *`$") for cell in re.split(r"[|\t]", line)]
        if any(OF_A_ROW.search(cell) and not LETTER.fullmatch(cell) for cell in cells):
            continue
        names = [cell for cell in cells if LETTER.fullmatch(cell)]
        numbers = [cell for cell in cells if NUMBER.fullmatch(cell)]
        if len(names) == len(numbers) == 1 and cells.index(names[0]) < cells.index(numbers[0]):
            unit = next((cell.strip("[]()") for cell in cells if UNIT.fullmatch(cell)), "")
            measured = numbers[0] if re.search(r"[a-z]", numbers[0]) else f"{numbers[0]} {unit}"
            known.setdefault(key(names[0]), measured.strip())
    return known


def _shorter(value):
    """A value before the words that follow it."""
    measure = re.match(r"-?\d+\.?\d*\s*(?:mm|cm|m)\b", value.strip())
    if measure:
        yield measure[0]
    yield value.partition("≈")[0]
    yield re.split(r"\s+\((?=[A-Za-z]{3,}\s)", value)[0]  # 0.1 (default in metres)
    yield re.split(r"\s+(?:and|with|where|is|the|for|from)\b|\s{2,}", value)[0]
    yield re.split(r"(?<=[\w)])\s+(?=[A-Za-z])", value.strip())[0]


def from_zero(code):
    """MATLAB counts the items of a list from 1: ``l(1)`` of a list l is ``l[0]``."""
    for name, _ in LISTED.findall(code):
        code = re.sub(
            rf"\b{name}\((\d{{1,2}})\)", lambda m, name=name: f"{name}[{int(m[1]) - 1}]", code
        )
    return code


def counted_from_zero(name, code):
    """A letter as the answer names it, ``L[1]`` of MATLAB's ``L(1)``, as it is looked up: ``L[0]``.

    Examples
    --------
    >>> counted_from_zero("L[1]", "d = L(1)"), counted_from_zero("L[1]", "d = L[1]")
    ('L[0]', 'L[1]')
    """
    found = re.fullmatch(r"(\w+)\[(\d+)\]", name)
    if not found or not re.search(rf"\b{found[1]}\({found[2]}\)", code):
        return name
    return f"{found[1]}[{int(found[2]) - 1}]"


def joint_values(known):
    """The names that say where a joint stands, as ``theta1 = 0.3``, and nothing a table needs; a
    number among names that most joints have for their variables, ``theta1 = req.q1``, is a fixed
    angle.

    Examples
    --------
    >>> joint_values({"theta1": "0.3", "theta2": "q2 - 90", "d1": "0.1"})
    {'theta1'}
    >>> joint_values({"theta1": "q1", "theta2": "q2 - 90", "theta3": "0"})
    set()
    >>> joint_values({"theta[0]": "0", "d[0]": "0.1"})
    {'theta[0]'}
    """
    names = [name for name in known if JOINT.fullmatch(name.lower())]
    listed = _listed_values(known)
    stands = {name for name in names if not OF_ANOTHER.search(known[name])}
    stems = [name.rstrip("0123456789") for name in names if name not in stands]
    given = [name.rstrip("0123456789") for name in stands]
    defined = {stem for stem in stems if stems.count(stem) > max(given.count(stem), 1)}
    return listed | {name for name in stands if name.rstrip("0123456789") not in defined}


def parameters_of(code):
    """The names, as d3 beside theta1, that a function takes for the values of joints: ``d3: 0 to
    0.2`` of a docstring is no value. Not links' lengths, nor what has a default or is assigned.

    Examples
    --------
    >>> parameters_of("def fk(theta1, s2, l1=0.3):\\n    return theta1 + s2")
    {'s2'}
    """
    found = set()
    for inside in TAKEN.findall(code):
        names = [
            re.sub(r":.*", "", part).split()[-1:] for part in inside.split(",") if part.strip()
        ]
        names = [one[0].strip("*&") for one in names if one]
        if any(JOINT.fullmatch(name.lower()) and name[-1].isdigit() for name in names):
            found |= {key(n) for n in names if re.fullmatch(r"(?![ablABL])[A-Za-z]+_?\d", n)}
    return {
        name
        for name in found
        if not JOINT.fullmatch(name.lower()) and not re.search(rf"\b{name}\s*=(?!=)", code)
    }


def _listed_values(known):
    """The elements of arrays that hold joint values, ``theta[0]`` of ``theta = [0, 0]``; where the
    columns of the table are arrays too, theta with other numbers than 0 is one of these; t and
    angles may be times and twists.
    """
    named = {name for name in known if ELEMENT.fullmatch(name.lower())}
    columns = any(COLUMN.fullmatch(name.lower()) for name in known)
    arrays: dict = {}
    for name in known:
        if found := EITHER.fullmatch(name.lower()):
            arrays.setdefault(found[1], []).append(name)
    for array, elements in arrays.items():
        vague = columns or array in ("t", "angle", "angles")
        if not vague or not any(re.search("[1-9p]", str(known[name])) for name in elements):
            named.update(elements)
    return named
