"""Greek letters, minus signs, subscripts and TeX written in plain letters."""

import re
import unicodedata
from functools import lru_cache

__all__ = ["KEPT", "plain", "unified"]

KEPT = 500  # texts whose meaning is remembered: all readers of a table ask for the same ones

STYLED = re.compile("[\U0001d400-\U0001d7ff]")  # mathematical letters and digits, as 𝜃 and 𝟎
SPACED = re.compile(r"(?<=[\[(]) ?(r ?a ?d|d ?e ?g|m ?m|c ?m) ?(?=[\])])")  # [r a d ] of a PDF

SAME = str.maketrans(
    {
        **dict.fromkeys("−–—‒﹣－", "-"),
        "₋": "-",
        **dict.fromkeys("×·∗⁎∙⋅", "*"),
        "÷": "/",
        "∕": "/",
        **dict.fromkeys("│┃║｜", "|"),
        **dict.fromkeys("πΠϖ", "pi"),
        **dict.fromkeys("θϑΘϴѳѲөӨɵƟᶿ", "theta"),
        **dict.fromkeys("α⍺ɑⲁ∝", "alpha"),
        **dict.fromkeys("φϕ", "phi"),
        "Δ": "delta",
        "δ": "delta",
        "σ": "sigma",
        "β": "beta",
        "γ": "gamma",
        "ⱼ": "_j",
        **dict.fromkeys("₍₎⁽⁾", ""),  # a₍ᵢ₋₁₎
        "ℓ": "l",
        "ᵢ": "_i",
        "ₙ": "_n",
        "₊": "+",
        **dict.fromkeys("º˚∘⁰◦○", "°"),
        "′": "'",
        "’": "'",
        "‘": "'",
        "“": '"',
        "”": '"',
        "√": "sqrt",
        "⁄": "/",
        **dict.fromkeys("\u00a0\u2009\u2002\u2003\u202f\u3000", " "),
        **dict.fromkeys("\u200b\u2060\ufeff", ""),
        "，": ",",
        "；": ";",
        "（": "(",
        "）": ")",
        "：": ":",
        **{chr(0x2080 + k): str(k) for k in range(10)},
    }
)
VULGAR = re.compile("(-?)([0-9]*)([¼-¾⅐-⅞])")  # 7½
FRACTION = re.compile(r"\\(?:[dtcs]|nice)?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}")
SHORT_FRACTION = re.compile(r"\\(?:[dtcs]|nice)?frac\s*(\d|\\pi)\s*(\d|\{\d+\})")
WRAPPERS = re.compile(
    r"\\(?:mathrm|text|textbf|textit|textsc|emph|underline|caption|mbox|ensuremath|section\*?|mathbf|mathit|boldsymbol|bm|rm|operatorname|mathsf|si|hspace)"
    r"\s*\{([^{}]*)\}"
)
DEGREES = re.compile(
    r"\^\s*(?:\{\s*(?:\\circ|\\degree|°|\*?\\?o(?![a-z]))\s*\}|(?:\\circ|\\degree|°|\*?\\?o(?![a-z])))"
    r"|\\circ|\\degree\b"
)
# a link matrix, which is no table: written as MATLAB has it
MATRIX = re.compile(r"\\begin\{([bpvBV]?matrix)\}(.*?)\\end\{\1\}", re.DOTALL)
OF_ANGLES = re.compile(r"\\(?:cos|sin)|\b[csCS]_?\{?\\?(?:theta|alpha|[ta])")
TEX_FUNCTION = re.compile(r"(?<=\w)\\(?=(?:cos|sin)(?![a-z]))")
SIUNITX = (
    (re.compile(r"\\ang\s*\{([^{}]*)\}"), r"\1°"),
    (re.compile(r"\\(?:SI|qty)\s*\{([^{}]*)\}\s*\{\s*(?:\\degree|°|\\circ)\s*\}"), r"\1°"),
    (
        re.compile(r"\\(?:SI|qty)\s*\{([^{}]*)\}\s*\{\s*(?:\\milli\\met(?:re|er)|\\mm|mm)\s*\}"),
        r"\1 mm",
    ),
    (re.compile(r"\\(?:SI|qty)\s*\{([^{}]*)\}\s*\{\s*(?:\\met(?:re|er)|m)\s*\}"), r"\1 m"),
    (re.compile(r"\\(?:SI|qty)\s*\{([^{}]*)\}\s*\{\s*(?:\\radian|rad)\s*\}"), r"\1 rad"),
    (re.compile(r"\\num\s*\{([^{}]*)\}"), r"\1"),
    (re.compile(r"\\milli\\met(?:re|er)"), "mm"),
    (re.compile(r"\\met(?:re|er)\b"), "m"),
)
# what lays out the cells of a table
SPANS = re.compile(
    r"\\multi(column|row)\s*(?:\{([^{}]*)\}|\*)\s*(?:\{[^{}]*\}|\*)\s*(?=\{([^{}]*)\})"
    r"|\\(?:row|cell|column)color\s*(?:\[[^\]]*\])?\s*\{[^{}]*\}"
)
FOOTNOTE = re.compile(
    r"\\(?:tnote|tablefootnote|footnotemark|footnote|label|cite)\s*(?:\{[^{}]*\}|\[[^\]]*\])"
)
IN_CELL = re.compile(
    r"\\(?:makecell|shortstack|thead|specialcell)\s*(?:\[[^\]]*\])?\s*"
    r"\{((?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*)\}"
)
ROOT = re.compile(r"\\sqrt\s*\{([^{}]*)\}")
LAYOUT = re.compile(
    r"\\(?:hline|toprule|midrule|bottomrule|cline\s*\{[^{}]*\}|centering|left|right|displaystyle"
    r"|quad|qquad|limits|small|large|footnotesize|scriptsize|normalsize|boldmath|bfseries|itshape"
    r"|endhead|endfirsthead|noindent|label\s*\{[^{}]*\}"
    r"|(?:begin|end)\s*\{[^{}]*\}(?:\s*\[[^\]]*\])?(?:\s*\{[|lcrp@{}!.\s\d*]*\})?)"
)
TEX_NAMES = {"vartheta": "theta", "cdot": "*", "times": "*", "arctan": "atan", "star": "*"}
# what has a backslash and is no TeX: C:\\robot\\toolbox, the ends of lines in printf("\\nPose")
PATH = re.compile(r"(?<![A-Za-z])[A-Za-z]:\\[^\s'\"]*")
ESCAPED = re.compile(
    r"(?:[(,=:+]|<<)\s*[fr]?([\"'])(?:(?!\1)[^\n\\$]|\\[nrt](?!heta|ext|imes|ight|m\b))*\1"
)
TEX = re.compile(r"\\[A-Za-z]{2,}|\$[^$\n]*\$|\\\\")
MOST_NESTED = 6


@lru_cache(KEPT)
def unified(text):
    """Unicode and TeX written in plain letters; the case is kept.

    Examples
    --------
    >>> unified("−π/2"), unified("θ₁"), unified(r"$\\theta_{1}-\\frac{\\pi}{2}$")
    ('-pi/2', 'theta1', 'theta_1-((pi)/(2))')
    """
    text = STYLED.sub(lambda m: unicodedata.normalize("NFKC", m[0]), text)
    text = VULGAR.sub(_vulgar, text.replace("−", "-")).translate(SAME)
    text = re.sub(r"(?<!\\)\\[()]", "", text)  # \(x\) is $x$
    text = SPACED.sub(lambda m: m[1].replace(" ", ""), text)
    text = re.sub(r"\^\s*(?:\{\s*\*\s*\}|\*)", "*", text)
    text = re.sub(r"_\{([^{}\\]*)\}", lambda m: "_" + m[1].replace(" ", ""), text)
    if "\\" in text or "$" in text:
        text = _from_tex(text) if TEX.search(ESCAPED.sub("", PATH.sub("", text))) else text
    return text


def _vulgar(match):
    """``-7½`` as ``-7.5``."""
    share = unicodedata.numeric(match[3]) + int(match[2] or 0)
    return f"{match[1]}{share!r}"


def _from_tex(text):
    text = re.sub(r"--(?=[\d$\\])", "-", FOOTNOTE.sub("", text).replace(r"\textdegree", "°"))
    text = IN_CELL.sub(lambda m: m[1].replace(r"\\", " "), SPANS.sub(_spanned, text))
    text = TEX_FUNCTION.sub(r" \\", MATRIX.sub(_in_brackets, text))
    for pattern, written in SIUNITX:
        text = pattern.sub(written, text)
    text = re.sub(r"\\\\(?:\[[^\]\n]*\])?", "\n" if "\n" not in text else " ", text)
    text = DEGREES.sub("°", re.sub(r"\\(?:[,;!:]|(?=\s))", " ", re.sub(r"(?<!\\)%.*", "", text)))
    for _ in range(MOST_NESTED):
        before = text
        text = SHORT_FRACTION.sub(r"((\1)/(\2))", text)
        text = WRAPPERS.sub(r" \1 ", ROOT.sub(r"sqrt(\1)", FRACTION.sub(r"((\1)/(\2))", text)))
        if text == before:
            break
    text = LAYOUT.sub("\n" if "\n" not in text else " ", text)
    if "\n" in text:  # an empty cell at the end of a row is one
        text = re.sub(r"&[ \t]*$", "& -", re.sub(r"^[ \t]*&", "- &", text, flags=re.M), flags=re.M)
    text = text.replace("&", "|")
    text = re.sub(r"(?<!\\)\\([A-Za-z]+)", lambda m: TEX_NAMES.get(m[1], m[1]) + _gap(m), text)
    text = text.replace("$", "")
    text = re.sub(r"_\s*\{\s*([^{}]*?)\s*\}", lambda m: "_" + m[1].replace(" ", ""), text)
    return text.replace("{", "").replace("}", "")


def _spanned(match):
    """Nothing; for a heading over several columns, empty cells before what it holds."""
    wide = match[1] == "column" and (match[2] or "").isdigit() and 1 < int(match[2]) < 9
    behind = match.string[match.end(3) + 1 : match.end(3) + 9] if wide else ""
    return "- & " * (int(match[2]) - 1) if wide and "\\\\" not in behind else ""


def _gap(match):
    """A space where a TeX name would run into the next letters."""
    after = match.string[match.end() : match.end() + 1]
    if after.isdigit() and match[1] in ("theta", "alpha"):  # theta1 is a name
        return ""
    return " " if re.match(r"[A-Za-z0-9]", after) or (after == "\\" and len(match[1]) == 3) else ""


def _in_brackets(match):
    """A matrix of cosines, or of numbers in every row, as ``[ …, …; … ]``; others as they are."""
    rows = re.split(r"\\\\(?:\[[^\]\n]*\])?", _without_marks(match[2]))
    rows = [row for row in rows if row.strip()]
    if not OF_ANGLES.search(match[2]) and not all(re.search(r"\d", row) for row in rows):
        return match[0]
    return "[" + "; ".join(", ".join(row.split("&")) for row in rows if row.strip()) + "]"


def _without_marks(text):
    """The lines of a matrix as one, without the marks of a comment where each has one."""
    lines = text.split("\n")
    if len(lines) > 2 and all(re.match(r"\s*(?:[#%]|//)|\s*$", line) for line in lines[1:]):
        lines = [re.sub(r"^\s*(?:[#%]+|//+)", "", line) for line in lines]
    return " ".join(lines)


def plain(text):
    """As :func:`unified`, in lower case and without spaces around.

    Examples
    --------
    >>> plain("−π/2"), plain("$\\\\theta_1$")
    ('-pi/2', 'theta_1')
    """
    return unified(text).lower().strip()
