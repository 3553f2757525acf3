"""The source in C99, which needs nothing but ``math.h``."""

from __future__ import annotations

import textwrap

from ..arm import Arm
from .lines import Lines
from .samples import Samples

__all__ = ["c_source"]

FRAME = """\
/*
{header}
 */

#include <math.h>

/* For a header of your own. T and J must not overlap q. */
void {name}_forward(const double q[{n}], double T[16]);
void {name}_jacobian(const double q[{n}], double J[{size}]);
{limits}
{forward}

{jacobian}

#ifdef DHLAB_TEST
#include <stdio.h>

/* Joint values, and what dhlab's plain product of link matrices gives for them. */
{tests}

static int wrong(double found, double expected, double size)
{{
    return !(fabs(found - expected) <= 1e-12 * size); /* NaN is wrong */
}}

int main(void)
{{
    double T[16], J[{size}];
    int i, k, count = 0;
    for (i = 0; i < {m}; i++) {{
        {name}_forward(test_q[i], T);
        {name}_jacobian(test_q[i], J);
        for (k = 0; k < 16; k++)
            count += wrong(T[k], test_T[i][k], k % 4 == 3 ? {samples.T_length!r} : 1.0);
        for (k = 0; k < {size}; k++)
            count += wrong(J[k], test_J[i][k], k < {half} ? {samples.J_length!r} : 1.0);
    }}
    printf("{name}: {m} poses, %d of {total} numbers wrong\\n", count);
    return count != 0;
}}
#endif
"""
LIMITS = """
/* Low and high of each q, in rad or m; stated, not enforced here. */
extern const double {name}_limits[{n}][2];
const double {name}_limits[{n}][2] = {{
{rows}
}};
"""


def c_source(
    arm: Arm, name: str, header: list[str], forward: Lines, jacobian: Lines, samples: Samples
) -> str:
    """The text of the file.

    Parameters
    ----------
    arm : Arm
    name : str
        An identifier; the functions are ``name_forward`` and ``name_jacobian``.
    header : list of str
    forward, jacobian : Lines
    samples : Samples

    Returns
    -------
    str
    """
    n, m = len(arm), len(samples.q)
    tests = {"q": samples.q, "T": samples.T.reshape(m, -1), "J": samples.J.reshape(m, -1)}
    return FRAME.format(
        header="\n".join(f" * {line}".rstrip() for line in header),
        name=name,
        n=n,
        m=m,
        size=6 * n,
        half=3 * n,
        total=m * (16 + 6 * n),
        samples=samples,
        limits=_limits(arm, name),
        forward=_function(f"{name}_forward", n, "T", forward),
        jacobian=_function(f"{name}_jacobian", n, "J", jacobian),
        tests="\n".join(_array(f"test_{key}", rows) for key, rows in tests.items()),
    )


def _function(name, n, result, lines):
    entries = [entry for row in lines.rows for entry in row]
    body = [f"    const double {key} = {formula};" for key, formula in lines.assignments]
    body += [f"    {result}[{k}] = {entry};" for k, entry in enumerate(entries)]
    if not any("q[" in line for line in body):
        body.insert(0, "    (void)q; /* nothing here depends on it */")
    signature = f"void {name}(const double q[{n}], double {result}[{len(entries)}])"
    return "\n".join([signature, "{", *body, "}"])


def _array(name, rows):
    body = [_braced(map(repr, row)) for row in rows.tolist()]
    return "\n".join([f"static const double {name}[{len(rows)}][{len(rows[0])}] = {{", *body, "};"])


def _braced(texts):
    return textwrap.fill(
        f"{{{', '.join(texts)}}},",
        96,
        initial_indent="    ",
        subsequent_indent="     ",
        break_on_hyphens=False,
    )


def _limits(arm, name):
    if arm.limits is None:
        return ""
    pairs = [pair or ("-HUGE_VAL", "HUGE_VAL") for pair in arm.limits]
    rows = "\n".join(_braced(map(str, pair)) for pair in pairs)
    return LIMITS.format(name=name, n=len(arm), rows=rows)
