"""Tables and poses as a person would write them: degrees and metres, named; plain text and HTML."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from typing import TYPE_CHECKING, SupportsFloat

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .transform import to_xyz_rpy

if TYPE_CHECKING:
    from .serialchain import SerialChain
    from .table import DHTable

__all__ = [
    "table_text",
    "table_html",
    "arm_text",
    "arm_html",
    "listed",
    "number",
    "matrix_text",
    "grid_text",
    "grid_html",
]

HEADINGS = {
    "standard": ("theta", "d", "a", "alpha"),
    "craig": ("theta", "d", "a(i-1)", "alpha(i-1)"),
}
HTML_HEADINGS = {
    "standard": ("θ<sub>i</sub>", "d<sub>i</sub>", "a<sub>i</sub>", "α<sub>i</sub>"),
    "craig": ("θ<sub>i</sub>", "d<sub>i</sub>", "a<sub>i−1</sub>", "α<sub>i−1</sub>"),
}
SCALES = {"m": 1.0, "mm": 1000.0}
TITLES = {"standard": "standard DH", "craig": "Craig DH"}


def number(value: SupportsFloat, digits: int = 6) -> str:
    """A number with at most ``digits`` decimals and no trailing zeros.

    Examples
    --------
    >>> number(0.4), number(-90.0), number(1e-17), number(0.1625)
    ('0.4', '-90', '0', '0.1625')
    """
    return np.format_float_positional(round(float(value), digits) + 0.0, trim="-")


def listed(words: Iterable[str]) -> str:
    """Words as a list in a sentence.

    Examples
    --------
    >>> listed(["a"]), listed(["a", "b", "c"])
    ('a', 'a, b and c')
    """
    words = list(words)
    return words[0] if len(words) == 1 else ", ".join(words[:-1]) + " and " + words[-1]


def _cells(table, rates, length="m"):
    """The four texts of each row; the joint variable stands where it acts, as in "q2 - 90", "-q1"
    or, of coupled joints, "q3 - q2".
    """
    rates = np.ones(len(table)) if rates is None else rates
    scale = SCALES[length]
    rates = np.diag(rates) if rates.ndim == 1 else _in_degrees(rates, table.prismatic, scale)
    for i, letter in enumerate(table.joints):
        turns, shifts = np.rad2deg([table.theta[i], table.alpha[i]]), [table.d[i], table.a[i]]
        texts = [number(value) for value in (turns[0], *np.multiply(scale, shifts), turns[1])]
        k = 1 if letter == "P" else 0
        parts = [_times(rates[i, j], f"q{j + 1}") for j in _own_first(i, rates[i])]
        texts[k] = _summed(parts if texts[k] == "0" else [*parts, texts[k]])
        yield texts


def _in_degrees(rates, slides, scale):
    """A coupling between joints that turn and joints that slide is per degree, as the table is."""
    unit = np.where(slides, scale, 180 / np.pi)
    return rates * (unit[:, None] / unit)


def _own_first(i, rates):
    """Which numbers of q stand in row i, its own first."""
    return sorted(np.flatnonzero(rates), key=lambda j: j != i)


def _times(rate, variable):
    sign, size = "-" if rate < 0 else "", number(abs(rate))
    return sign + (variable if size == "1" else f"{size} {variable}")


def _summed(parts):
    return " + ".join(parts).replace("+ -", "- ")


def _title(table, length="m"):
    joints = "1 joint" if len(table) == 1 else f"{len(table)} joints"
    return f"{TITLES[table.convention]}, {joints} (lengths in {length}, angles in deg)"


def grid_text(headings: Sequence[object], rows: Iterable[Sequence[object]]) -> str:
    """Columns lined up, as in a printed table.

    Examples
    --------
    >>> print(grid_text(["i", "d"], [["1", "0.1"]]))
     i  d
     1  0.1
    """
    lines = [list(headings), *rows]
    widths = [max(len(str(line[k])) for line in lines) for k in range(len(headings))]
    return "\n".join(
        (" " + "  ".join(str(cell).ljust(w) for cell, w in zip(line, widths))).rstrip()
        for line in lines
    )


def grid_html(headings: Iterable[str], rows: Iterable[Iterable[object]], caption: str) -> str:
    """The same as an HTML table; ``headings`` are HTML, cells and caption are escaped. A column
    without one has none: an empty heading would be read out.
    """
    head = "".join(
        f'<th scope="col">{heading}</th>' if heading else "<td></td>" for heading in headings
    )
    body = "".join(
        "<tr>" + "".join(f"<td>{escape(str(cell))}</td>" for cell in row) + "</tr>" for row in rows
    )
    return (
        f'<table class="dhlab" style="min-width:22em"><caption>{escape(caption)}</caption>'
        f"<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
    )


def table_text(table: DHTable, sign: NDArray[np.float64] | None = None) -> str:
    """A table as plain text, a line per joint; ``sign`` (n,) as in ``Arm``, or what
    each joint makes of each number of q, (n, n)."""
    rows = [[str(i), *cells] for i, cells in enumerate(_cells(table, sign), 1)]
    return _title(table) + "\n" + grid_text(["i", *HEADINGS[table.convention]], rows)


def table_html(
    table: DHTable,
    sign: NDArray[np.float64] | None = None,
    caption: str | None = None,
    length: str = "m",
) -> str:
    """A table as HTML for a notebook; lengths in "m" or "mm"."""
    rows = [
        [str(i), *(cell.replace("-", "−") for cell in cells)]
        for i, cells in enumerate(_cells(table, sign, length), 1)
    ]
    head = ["i", *HTML_HEADINGS[table.convention]]
    return grid_html(head, rows, caption or _title(table, length))


def arm_text(arm: SerialChain) -> str:
    """An arm as plain text: name, table, base and tool when they are not the identity, limits."""
    lines = [arm.name] if arm.name else []
    lines.append(table_text(arm.table, _rates(arm)))
    lines += _extras(arm)
    return "\n".join(lines)


def arm_html(arm: SerialChain) -> str:
    """An arm as HTML for a notebook."""
    caption = f"{arm.name}: {_title(arm.table)}" if arm.name else None
    extras = "".join(f"<p>{escape(line)}</p>" for line in _extras(arm))
    return table_html(arm.table, _rates(arm), caption) + extras


def _rates(arm):
    return arm.sign if arm.coupling is None else arm.coupling * arm.sign


def _extras(arm):
    for name in ("base", "tool"):
        pose = getattr(arm, name)
        if not np.array_equal(pose, np.eye(4)):
            xyz, rpy = to_xyz_rpy(pose)
            yield (
                f"{name}: xyz {' '.join(number(v) for v in xyz)} m, "
                f"roll pitch yaw {' '.join(number(v) for v in np.rad2deg(rpy))} deg"
            )
    if arm.limits:
        yield "limits: " + ", ".join(
            _limit_text(pair, letter) for pair, letter in zip(arm.limits, arm.table.joints)
        )
    if arm.source:
        yield f"source: {arm.source}"


def _limit_text(pair, letter):
    if pair is None:
        return "none"
    scale, unit = (1.0, "m") if letter == "P" else (180 / np.pi, "deg")
    return f"{number(pair[0] * scale, 3)} to {number(pair[1] * scale, 3)} {unit}"


def matrix_text(T: ArrayLike, digits: int = 6) -> str:
    """A matrix in aligned columns; what rounds to nothing is written 0.

    Examples
    --------
    >>> print(matrix_text(np.eye(2)))
    [ 1  0 ]
    [ 0  1 ]
    """
    cells = [[number(value, digits) for value in row] for row in np.atleast_2d(T)]
    width = max(len(cell) for row in cells for cell in row)
    return "\n".join("[ " + "  ".join(cell.rjust(width) for cell in row) + " ]" for row in cells)
