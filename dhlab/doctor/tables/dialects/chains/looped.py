"""A loop that adds segments, written out, and frames and joints that have names of their own."""

import re

__all__ = ["named", "written_out"]

FROM_TO = r"(?:(?:int|size_t|unsigned|auto|std::size_t)\s+)*"
IN_C = re.compile(
    rf"\bfor\s*\(\s*{FROM_TO}(\w+)\s*=\s*(\d+)\s*;\s*\1\s*(<=?)\s*([\w.]+(?:\(\))?)\s*;[^)]*\)\s*\{{?"
)
IN_PYTHON = re.compile(r"^([ \t]*)for (\w+) in range\((?:(\w+),\s*)?([\w.()]+)\):", re.MULTILINE)
ONE_CASE = re.compile(
    r"\bif\s*\(?\s*(\d+)\s*(==|!=|<|>|<=|>=)\s*(\d+)\s*\)?\s*:?\s*(?:\{\s*([^{}]*)\}|([^;\n]*;?))"
    r"(?:\s*else\s*:?\s*(?:\{\s*([^{}]*)\}|([^;\n]*;?)))?"
)
MOST = 12  # turns of a loop
MADE = r"(?:(?:const|auto|(?:\w+(?:::|\.))*(?:Frame|Joint))[\s&]+)*"


def written_out(source):
    """The code with each loop that adds segments as what it does one after the other; as it is
    where its ends are no numbers.
    """
    code = source.code
    for pattern, parts in ((IN_C, _of_c), (IN_PYTHON, _of_python)):
        for match in [*pattern.finditer(code)][::-1]:
            name, first, last, body, end = parts(match, code)
            first, last = (_number(one, source) for one in (first, last))
            if "segment" not in body.lower() or first is None or last is None:
                continue
            last += match[3] == "<=" if pattern is IN_C else 0
            if 0 < last - first <= MOST:
                turns = (_turn(body, name, k) for k in range(first, last))
                code = code[: match.start()] + "\n".join(turns) + code[end:]
    return code


def _number(text, source):
    value = source.value(text or "0")
    if value is None:
        sized = re.match(r"len\((\w+)\)|(\w+)\.size\(\)", text)
        name = sized and (sized[1] or sized[2])
        known = sum(one.startswith(f"{name}[") for one in source.known) if name else 0
        return known or None
    return int(value.number) if not value.letters else None


def _of_c(match, code):
    """(counter, first, last, body, where the loop ends) of a loop in C."""
    if not match[0].endswith("{"):
        end = code.find(";", match.end()) + 1 or len(code)
        return match[1], match[2], match[4], code[match.end() : end], end
    depth, at = 1, match.end()
    while at < len(code) and depth:
        depth += (code[at] == "{") - (code[at] == "}")
        at += 1
    return match[1], match[2], match[4], code[match.end() : at - 1], at


def _of_python(match, code):
    """As :func:`_of_c`, of Python: the lines that are further in."""
    rest = code[match.end() :]
    further = re.match(rf"[^\n]*(?:\n(?:[ \t]*(?=\n|$)|{match[1]}[ \t]+[^\n]*))*", rest)
    return match[2], match[3], match[4], further[0], match.end() + further.end()


def _turn(body, name, k):
    """What a loop does at one value of its counter."""
    said = re.sub(rf"\b{name}\b", str(k), body)
    said = re.sub(r"\b(\d+)\s*([-+])\s*(\d+)(?=\s*[\])])", _sum, said)
    return ONE_CASE.sub(_chosen, said)


def _sum(match):
    return str(int(match[1]) + int(match[2] + match[3]))


def _chosen(match):
    """The statements of an ``if`` whose two numbers stand there, or those of its ``else``."""
    one, two = int(match[1]), int(match[3])
    holds = {"==": one == two, "!=": one != two, "<": one < two, ">": one > two,
             "<=": one <= two, ">=": one >= two}[match[2]]  # fmt: skip
    return (match[4] or match[5] if holds else match[6] or match[7]) or ""


def named(text, code, line):
    """What a name of a frame or a joint last stood for above a line of the code; "" of none."""
    above = "\n".join(code.split("\n")[:line])
    said = r"\s*(?:=(?!=)\s*([^;\n]+)|(\([^;\n]+\))|(\{[^;\n]+\}))"
    made = rf"(?<![\w.]){MADE}\b{re.escape(text)}{said}"
    found = [next(filter(None, one)) for one in re.findall(made, above)]
    last = found[-1].strip() if found else ""
    return f"Frame{last}" if last[:1] in ("(", "{") else last
