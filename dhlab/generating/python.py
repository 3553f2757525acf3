"""The source in Python, which needs nothing but ``math``."""

from __future__ import annotations

import textwrap

from ..arm import Arm
from .lines import Lines
from .samples import Samples

__all__ = ["python_source"]

FRAME = '''\
{header}

from math import cos, sin
{limits}

def {name}_forward(q):
    """Pose of the end point, four rows of four."""
{forward}


def {name}_jacobian(q):
    """Jacobian at the end point, six rows of {n}: v, then omega."""
{jacobian}


def _self_check():
    """Compare with what dhlab's plain product of link matrices gives."""
{tests}
    count = 0
    for i in range({m}):
        T = {name}_forward(test_q[i])
        J = {name}_jacobian(test_q[i])
        for row in range(4):
            sizes = [1.0, 1.0, 1.0, {samples.T_length!r}]
            count += _wrong(T[row], test_T[i][row], sizes)
        for row in range(6):
            sizes = [{samples.J_length!r} if row < 3 else 1.0] * {n}
            count += _wrong(J[row], test_J[i][row], sizes)
    print(f"{name}: {m} poses, {{count}} of {total} numbers wrong")
    return count


def _wrong(found, expected, sizes):
    return sum(not abs(a - b) <= 1e-12 * size for a, b, size in zip(found, expected, sizes))


if __name__ == "__main__":
    raise SystemExit(_self_check() != 0)
'''
LIMITS = """
# Low and high of each q, in rad or m, or None; stated, not enforced here.
{name}_limits = [
{rows}
]
"""


def python_source(
    arm: Arm, name: str, header: list[str], forward: Lines, jacobian: Lines, samples: Samples
) -> str:
    """The text of the file; parameters as those of the C source.

    Returns
    -------
    str
    """
    n, m = len(arm), len(samples.q)
    tests = {"q": samples.q, "T": samples.T, "J": samples.J}
    return FRAME.format(
        header="\n".join(f"# {line}".rstrip() for line in header),
        name=name,
        n=n,
        m=m,
        total=m * (16 + 6 * n),
        samples=samples,
        limits=_limits(arm, name),
        forward=_body(forward),
        jacobian=_body(jacobian),
        tests="\n".join(
            f"    test_{key} = [\n"
            + "\n".join(_filled(f"{row},", 8) for row in rows.tolist())
            + "\n    ]"
            for key, rows in tests.items()
        ),
    )


def _body(lines):
    body = [f"    {key} = {formula}" for key, formula in lines.assignments]
    rows = [_filled(f"[{', '.join(row)}],", 8) for row in lines.rows]
    return "\n".join([*body, "    return [", *rows, "    ]"])


def _filled(text, indent):
    blank = " " * indent
    return textwrap.fill(
        text,
        96,
        initial_indent=blank,
        subsequent_indent=f"{blank} ",
        break_on_hyphens=False,
        break_long_words=False,
    )


def _limits(arm, name):
    if arm.limits is None:
        return ""
    rows = "\n".join(f"    {pair}," for pair in arm.limits)
    return LIMITS.format(name=name, rows=rows)
