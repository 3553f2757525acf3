"""What programming languages spell each in its own way, said in one: literals, declared types,
assignments, makers of lists and setters. Nothing here knows a table: it takes the language off.
"""

import re

from .brackets import cells_in
from .expressions import NoExpression, evaluate
from .roles import role_of

__all__ = ["neutral"]

# --- numbers: 0.5f64, 0.1f, 1.0d0, 90.0_deg, (-90.0_f64).to_radians(), .pi, %pi, Math::PI
SUFFIX = re.compile(
    r"(?<![\w.])(\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+)(?:_?f(?:16|32|64|128)|[fFlL]|D)\b"
)
FORTRAN = re.compile(r"(?<![\w.])(\d+\.\d*|\d*\.\d+)d([-+]?\d+)\b", re.IGNORECASE)
LITERAL_UNIT = re.compile(r"(?<=[\d.])_(deg|rad|mm|cm|m)\b")
POSTFIX = re.compile(
    r"(\((?:[^()\n]|\([^()\n]*\))*\)|\d[\d.]*)\s*\.(to_?radians|to_?rad|deg2rad)\(\)"
)
PI = re.compile(
    r":math\.pi(?:\(\))?|(?:\b\w+::)+pi(?:_v)?(?:\s*<\s*\w+\s*>)?(?:\(\))?(?!\w)"
    r"|(?<![\w)\]])\.pi\b|%pi\b|\bpi\s*<\s*\w+\s*>\s*\(\)|\bM_PIl?\b(?!_)"
    r"|\b[A-Z]{2,8}_PI\b(?=\s*/\s*180)",  # KIN_PI / 180; HALF_PI is another number
    re.IGNORECASE,
)
CAST = re.compile(r"\((?:float|double|real|int|long double|f32|f64|number)\)\s*(?=[-+\d.(A-Za-z])")
# --- declared types: const L: [[f64; 4]; 6] = …, val d: List<Double> = …, a: array[0..5] of Real =
KIND = (
    r"(?:f32|f64|f16|float\d*|double|number|real(?:\(\d\))?|int\d*|usize|decimal|auto|any|tuple"
    r"|list|dict|(?:np\.)?ndarray|(?:np\.)?array)"
)
TYPED = re.compile(
    r"(?<=[\w$)\]])[ \t]*:[ \t]*&?(?:'static[ \t]+)?(?:"
    r"\[+[^=\n]*?\]+|array[ \t]*\[[^\]\n]*\][ \t]*of[ \t]+\w+"
    r"|[A-Z_a-z][\w.]*[ \t]*(?:<[^=\n]*?>+|\[[^=\n]*?\]+|\{[^=\n]*?\})"
    rf"|{KIND}|(?-i:[A-Z][a-zA-Z]*[a-z]))[ \t]*(?==(?!=))",
    re.IGNORECASE,
)
PARAMETER = re.compile(  # def dh(theta: float, d: float), fn dh(theta: f64)
    rf"(?<=\w)[ \t]*:[ \t]*(?:{KIND}|(?:sp|sympy|torch|jnp)\.\w+|str|bool|Symbol|Expr)[ \t]*"
    r"(?=[,);}])",
    re.IGNORECASE,
)
FORTRAN_TYPED = re.compile(
    r"^[ \t]*(?:real|double precision)[^:\n]*::\s*(\w+)\s*(?:\([^)\n]*\))?\s*=",
    re.MULTILINE | re.IGNORECASE,
)
ATTRIBUTE = re.compile(r"(?<=[\])\w])\s*\b(?:PROGMEM|__attribute__\s*\(\([^)]*\)\))\s*(?==)")
VB_TYPED = re.compile(
    r"^([ \t]*(?:Dim|Const|Private|Public|ReadOnly|Static)[^=\n]*?\b(\w+)\s*(?:\([,\s]*\))?"
    r"\s+As\s+\w+(?:\([,\s]*\))?\s*=)",
    re.MULTILINE,
)
# --- assignments: x := 1, x <- 1, 'x' => 1, "x" -> 1, :x 1, $x, @x
ARROW = re.compile(r"(?<=[\w'\"\])])\s*(?::=|<-(?!\s*\d+\s*\.\.)|=>)\s*|(?<=['\"])\s*->\s*")
SIGIL = re.compile(
    r"(?<![\w\\$}])\$(?:this->)?(?=[A-Za-z_]\w*\s*(?:=|\[|->|;|,|\)))"
    r"|(?<![\w.])@{1,2}(?=[A-Za-z_]\w*\s*(?:=|\[))|\b(?:my|our)\s+@(?=\w)"
)
OF_DOLLARS = re.compile(
    r"^[ \t]*(?:my |our |private |public |protected |const )*\$\w+\s*=", re.MULTILINE
)
DECLARED = (  # define("L1", 0.4), double L1{0.4}, (defconstant L1 0.4), @l1 0.4
    re.compile(r"\bdefine\(\s*['\"](\w+)['\"]\s*,\s*([^()\n]+)\)"),
    re.compile(r"\b(?:double|float|auto)\s+(\w+)\s*\{([^{}\n]+)\}"),
    re.compile(r"\((?:def\w+|setq|setf|define)\s+([\w*+-]+)\s+([-+\d.][^()\s]*)\s*\)"),
    re.compile(r"^[ \t]*@(\w+)[ \t]+(?=[-\d\[{(])([^\n]+)$", re.MULTILINE),
)
LISP = re.compile(r"(?<=[\s({]):([A-Za-z]\w*)\s+(-?[\w.]+|\([^()\n]*\))(?=[\s)}])")
# --- makers: new double[][] {…}, vec![…], []float64{…}, [_]f64{…}, .{…}, %{…}, @[…], (/ … /), <|…|>
MAKER = re.compile(
    r"\bnew\s+[\w.]+(?:\s*<[^>\n]*>+)?\s*(?:\[[\w,\s]*\]\s*)+(?=\{)|\bnew\s*\[\]\s*(?=\{)"
    r"|\bnew\s+(?=[\w.]+\()"
    r"|\bvec!\s*(?=[\[(])|(?:\[[\w.]*\]\s*)+\*?[A-Za-z_][\w.]*\s*(?=\{)"
    r"|(?<![\w)\]])[.%](?=\{)|(?<![\w)\]])@(?=\[)"
    r"|<[A-Z]\w*(?:<[^>\n]*>)?>\s*(?=[\[{])|(?<=[\s(,])'(?=\()"
)
# --- setters: .setD(0.1), .withAlpha(…), .theta(…) in a chain
ARGUMENT = r"\(\s*((?:[^()\n]|\((?:[^()\n]|\([^()\n]*\))*\))*?)\s*\)"
SETTER = re.compile(r"\s*\.\s*(?:set|with)?_?([A-Za-z]\w*)(?=\()")
SETTING = re.compile(ARGUMENT)
# a1, d1 = 0.3, 0.1
TOGETHER = re.compile(
    r"((?:^|;)[ \t]*(?:local |let |var |const )?)([\w.]+(?:[ \t]*,[ \t]*[\w.]+)+)"
    r"[ \t]*=(?!=)[ \t]*([^=;\n\[\]{}]+?)[ \t]*(?=;|$)",
    re.MULTILINE,
)
# L1, L2, L3 = L, where L = [0.3, 0.2, 0.1]; [d1, a2] = deal(0.3, 0.2)
UNPACKED = re.compile(
    r"^([ \t]*(?:local |let |var |const |auto )?)[\[(]?([\w.]+(?:[ \t]*,[ \t]*[\w.]+)+)[\])]?"
    r"[ \t]*=[ \t]*(?:deal\((.+)\)|([A-Za-z_][\w.]*))[ \t]*;?[ \t]*$",
    re.MULTILINE,
)
ZEROS = re.compile(  # zeros(7, 1), np.zeros(6), [0.0] * 6
    r"(?<![\w.])(?:np\.|numpy\.)?zeros[ ]?\(\(?(?:1,[ ]?\d|\d(?:,[ ]?1?)?)\)?\)"
    r"|\[0(?:\.0*)?\]\s*\*\s*\d\b"
)
TRANSPOSED = re.compile(  # [90 0]' * pi/180
    r"\]'(?=\s*[;*/,)\n])"
)
DICTIONARY = re.compile(r"\b([A-Za-z_]\w*)[ \t]*=[ \t]*\{([^{}]*)\}")
ENTRY = re.compile(r"['\"](\w+)['\"]\s*:\s*([^,'\"\[\]\n]+)")
# functions of one number that a text defines itself: def rad(x): return x * pi / 180
OWN = (
    r"\bdef\s+(\w+)\(\s*(\w+)[^)\n]*\)[^:\n]*:((?:\n[ \t]+\w+[ \t]*=[^\n]*){0,3})"
    r"\s*return[ \t]+([^\n#]+)",
    r"\b(\w+)\s*\(\s*(?:const\s+)?(?:double|float|real)\s+(\w+)\s*\)()\s*\{\s*return\s+([^;}]+)",
    r"\b(\w+)\s*=\s*lambda\s+(\w+)\s*:()\s*([^\n#]+)",
    r"\b(\w+)\s*=\s*@\(\s*(\w+)\s*\)()\s*([^;\n%]+)",
    r"\b(\w+)\s*=\s*\(?\s*(\w+)[^()=\n]{0,12}\)?\s*=>()\s*([^;\n{]+)",
    r"\bfunction\s+(\w+)\s*\(\s*(\w+)[^)]*\)[^{]*\{()\s*return\s+([^;}]+)",
    r"#\s*define\s+(\w+)\((\w+)\)()[ \t]+([^\n]+)",
)
OBJECT = re.compile(  # C++: DHParam j1(0, 0.09, 0, 1.57);
    r"^([ \t]*)([A-Z]\w*)[ \t]+([A-Za-z]\w*)\((?![^;\n]*\b(?:double|float|const|int|auto)\b)"
    r"([^;\n]*\d[^;\n]*)\)[ \t]*;",
    re.MULTILINE,
)
DESIGNATED = re.compile(r"(?<!\w)\[(\d+)\]\s*=\s*")
ELEMENT = re.compile(r"<([A-Za-z]\w*)(?:\s+unit=\"(\w+)\")?>([^<>\n]{1,60})</\1>[ \t]*(?=(<?))")


def neutral(text):
    """The text without what only its language asks for.

    Examples
    --------
    >>> neutral("const A1: f64 = 0.5f64;")
    'const A1 = 0.5;'
    >>> neutral("a <- c(0, .pi / 2)")
    'a = c(0, pi / 2)'
    """
    text = OBJECT.sub(r"\1\3 = \2(\4);", _numbers(_inlined(text)))
    text = PARAMETER.sub("", _looked_up(text))
    text = TRANSPOSED.sub("]", ZEROS.sub(_zeros, text))
    text = FORTRAN_TYPED.sub(r"\1 =", ATTRIBUTE.sub(" ", TYPED.sub(_untyped, text)))
    text = VB_TYPED.sub(r"\2 =", text)
    if OF_DOLLARS.search(text):
        text = re.sub(r"\$(?=[A-Za-z_])", "", text)
    for declared in DECLARED:
        text = declared.sub(r"\1 = \2;", text)
    text = SIGIL.sub("", ARROW.sub(" = ", text))
    text = LISP.sub(r", \1 = \2", text)
    text = MAKER.sub(lambda m: "\n" * m[0].count("\n"), text)
    text = _without_designators(text)
    text = text.replace("<|", "{").replace("|>", "}")
    text = re.sub(r"\(/(.*?)/\)", r"[\1]", text, flags=re.DOTALL)
    text = re.sub(r"(?<=,)[ \t]*&[ \t]*$", "", text, flags=re.MULTILINE)  # the row goes on
    text = TOGETHER.sub(_apart, ELEMENT.sub(_element, text))
    text = UNPACKED.sub(_unpacked, text)
    return _without_setters(text)


def _without_designators(text):
    """C's ``{[0] = 0.1, [1] = 0}`` as ``{0.1, 0}``, where the indices stand in their order."""
    for inside in re.findall(r"\{([^{}]*)\}", text):
        indices = [int(index) for index in DESIGNATED.findall(inside)]
        if len(indices) > 2 and indices == list(range(len(indices))):
            text = text.replace(inside, DESIGNATED.sub("", inside))
    return re.sub(r"(?<=[{,\n])([ \t]*)\[\d+\]\s*=\s*(?=\{)", r"\1", text)


def _zeros(match):
    count = max(int(k) for k in re.findall(r"\d+", match[0]))
    return f"[{', '.join(['0'] * count)}]" if count < 10 else match[0]


def _looked_up(text):
    """The text with the number itself for ``L["d1"]``, where ``L = {"d1": 0.3}``."""
    for name, inside in DICTIONARY.findall(text):
        found = ENTRY.findall(inside)
        held = {key: value for key, value in found if value.count("(") == value.count(")")}
        text = re.sub(
            rf"\b{name}\[['\"](\w+)['\"]\](?!\s*=(?!=))",
            lambda m, held=held: f"({held[m[1]].strip()})" if m[1] in held else m[0],
            text,
        )
    return text


def _inlined(text):
    """The calls of functions that the text defines itself, as what these compute."""
    for pattern in OWN:
        for name, given, before, said in re.findall(pattern, text):
            for local, value in re.findall(r"(\w+)[ \t]*=[ \t]*([^\n]+)", before):
                said = re.sub(rf"\b{local}\b", f"({value.strip()})", said)
            if _computes(said, given):
                text = _called(text, name, given, said.strip())
    return text


def _computes(said, given):
    """Whether an expression is a number's multiple or sum, and of nothing else."""
    try:
        return set(evaluate(said.strip()).letters) == {given}
    except NoExpression:
        return False


def _called(text, name, given, said):
    """The text with ``said`` for each call of a function; not for its own definition."""

    def computed(match):
        word = match[1].strip()
        if word == given or (" " in word and not re.search(r"\d", word)):
            return match[0]
        return "(" + re.sub(rf"\b{given}\b", lambda _: f"({word})", said) + ")"

    return re.sub(rf"(?<![\w.])(?:\w+\.)?{name}\(([^()\n]{{1,60}})\)(?!\s*[:{{])", computed, text)


def _numbers(text):
    text = LITERAL_UNIT.sub(r" \1", FORTRAN.sub(r"\1e\2", SUFFIX.sub(r"\1", text)))
    text = CAST.sub("", PI.sub("pi", text))
    return POSTFIX.sub(r"radians(\1)", text)


def _apart(match):
    names, said = match[2].split(","), cells_in(match[3])
    if len(names) != len(said):
        return match[0]
    return match[1] + "; ".join(f"{name.strip()} = {one}" for name, one in zip(names, said))


def _unpacked(match):
    """Each name with its number, where a list of as many is taken apart."""
    made = r"[ \t]*=[ \t]*(?:[\w.]+\()?[\[({]([^\[\]{}=]+)[\])}]"
    held = match[4] and re.findall(rf"\b{re.escape(match[4])}{made}", match.string)
    names, said = match[2].split(","), cells_in(held[-1] if held else match[3] or "")
    columns = {role_of(name)[0] for name in names} >= {"theta", "alpha"}  # theta, d, a, alpha = row
    if columns or len(names) != len(said) or (held and len(held) > 1):
        return match[0]
    return match[1] + "; ".join(f"{name.strip()} = {one}" for name, one in zip(names, said))


def _untyped(match):
    """Nothing, but for a name of a parameter, as in ``Joint 1: theta = 90``."""
    return match[0] if role_of(match[0].strip(": &"))[0] else " "


def _element(match):
    unit = f" {match[2]}" if match[2] else ""
    behind = ", " if match[4] else ""  # <a>0</a><d>0.1</d>
    return f"{match[1]}: {match[3]}{unit}{behind}" if role_of(match[1])[0] else match[0]


def _without_setters(text):
    """``Link().setD(0.1).setA(0)`` as ``Link(){D = 0.1, A = 0}``; ``link1.setD(0.1)`` as
    ``link1.D = 0.1``.
    """
    out, at = [], 0
    for first in SETTER.finditer(text):
        calls, end = _calls(text, first) if first.start() >= at else ([], 0)
        if len(calls) >= 3:
            said = "{" + ", ".join(f"{name} = {value}" for name, value in calls) + "}"
        elif len(calls) == 1 and "set" in first[0]:
            said = f".{calls[0][0]} = {calls[0][1]}"
        else:
            continue
        out, at = [*out, text[at : first.start()], said], end
    return "".join([*out, text[at:]])


def _calls(text, call):
    """(what each of a chain of calls sets, where the chain ends)."""
    calls, end = [], call.start()
    while call and role_of(call[1])[0]:
        value = SETTING.match(text, call.end())
        if not value or not value[1]:
            break
        calls, end = [*calls, (call[1], value[1])], value.end()
        call = SETTER.match(text, end)
    return calls, end
