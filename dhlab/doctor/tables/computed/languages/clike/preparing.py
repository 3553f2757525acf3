"""A text in a language with braces, without comments and what is for its preprocessor."""

import re

from .tokens import simplified

__all__ = ["prepared"]

COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)
MACRO = re.compile(r"^[ \t]*#define[ \t]+(\w+)\(([\w, ]+)\)[ \t]+([^\n]+)$", re.MULTILINE)
DEFINED = re.compile(r"^[ \t]*#define[ \t]+(\w+)[ \t]+([^\n]+)$", re.MULTILINE)
PREPROCESSOR = re.compile(
    r"^[ \t]*(?:</?script[^\n>]*>|#[^\n]*|@\w+[^\n]*|using [^\n]*|import [^\n]*"
    r"|package [^\n]*)$",
    re.MULTILINE,
)
OF_FOUR = re.compile(r"\bMatrix\s*<(?:\s*(?:double|float)\s*,)?\s*4\s*,\s*4\s*(?:,[^<>]*)?>")
COLUMN = re.compile(
    r"\b(?:Matrix<\s*(?:double|float)\s*,\s*(\d+)\s*,\s*1\s*>|Vector(\d)[df])\s+([\w, ]+);"
)
TYPED = re.compile(r":\s*(?:number|void|string|boolean)\b")  # TypeScript
INTERFACE = re.compile(r"\binterface\s+\w+[^{}]*\{[^{}]*\}")
RESULT = re.compile(r"\)\s*:\s*[\w\[\]<>,| ]{1,60}?\s*(?=\{|=>)")
VARIABLE = re.compile(r"\b(const|let|var)\s+(\w+)\s*:\s*[\w\[\]<>,| ]{1,60}=(?![=>])")
# parts of a matrix of Eigen's
BLOCK = re.compile(r"\.block\s*<\s*(\d)\s*,\s*(\d)\s*>\s*\(\s*(\d)\s*,\s*(\d)\s*\)")
CORNER = re.compile(r"\.top(Left|Right)Corner\s*<\s*3\s*,\s*([13])\s*>\s*\(\s*\)")
TRANSFORM = re.compile(r"\b(?:Affine|Isometry)3[df]\b")
PART = re.compile(r"\.(linear|rotation|translation)\(\s*\)")
TURN, PLACE = "[0:3, 0:3]", "[0:3, 3:4]"


def _with_parts(text):
    """Eigen's parts of a matrix as ranges: ``T.block<3, 1>(0, 3)`` as ``T[0:3, 3:4]``."""

    def ranged(match):
        rows, columns, i, j = map(int, match.groups())
        return f"[{i}:{i + rows}, {j}:{j + columns}]"

    text = CORNER.sub(lambda match: PLACE if match.groups() == ("Right", "1") else TURN, text)
    text = BLOCK.sub(ranged, text)
    if not TRANSFORM.search(text):
        return text
    return PART.sub(lambda match: PLACE if match[1] == "translation" else TURN, text)


def _without_annotations(text):
    """A program in TypeScript without its types."""
    text = RESULT.sub(") ", INTERFACE.sub("", text))
    return VARIABLE.sub(r"\1 \2 =", text)


def prepared(text):
    """(The text with its macros as functions and numbers, the lengths of columns by their names:
    ``Matrix<double, 6, 1> offset;``).

    Examples
    --------
    >>> prepared("#define MM(x) (x / 1000)  // lengths")
    ('double MM(x) { return (x / 1000)   ; }', {})
    """
    text = MACRO.sub(r"double \1(\2) { return \3; }", COMMENT.sub(" ", text))
    text = _without_annotations(text) if TYPED.search(text) else text
    text = _with_parts(text)
    text = DEFINED.sub(r"\1 = \2;", text)
    sizes = {
        name: size or short
        for size, short, names in COLUMN.findall(text)
        for name in re.findall(r"\w+", names)
    }
    return simplified(OF_FOUR.sub("Matrix4d", PREPROCESSOR.sub("", text))), sizes
