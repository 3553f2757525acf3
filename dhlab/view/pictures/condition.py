"""How near an arm comes to a singularity along a path: the condition number of its Jacobian,
configuration by configuration.
"""

from functools import partial

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.ticker import LogLocator, NullLocator, StrMethodFormatter
from numpy.typing import ArrayLike

from ...arm import Arm
from ...printing import listed, number
from .. import words
from ..drawing.page import DPI, NARROW, Page, heading
from ..drawing.style import AXES, FLOOR, FONT, INK, QUIET, SIZES
from ..given import require_arm
from ..picture import Picture

__all__ = ["condition"]

# a condition number above this is drawn as a line without end: between 1e6 and infinity only
# rounding decides
SINGULAR = 1e6
ROWS = 9  # of the table, besides the singular ones and their neighbours
CURVE, LOST = AXES[2].color, AXES[0].color
HEADINGS = ("condition number", "smallest singular value", "rank")


def condition(arm: Arm, qs: ArrayLike, joint: int, *, title: str | None = None) -> Picture:
    """The condition number of the Jacobian along a path, on a logarithmic scale, against the value
    of one joint.

    Parameters
    ----------
    arm : Arm
    qs : array (m, n)
        Radians, metres for a prismatic joint: the path, two configurations at least.
    joint : int
        1-based: the joint whose values stand along the lower edge.
    title : str, optional

    Returns
    -------
    Picture
        The table holds nine of the configurations, and the singular ones with their neighbours.

    Raises
    ------
    ValueError
        No arm, a path that does not fit it, or a joint that does not move along it.

    Notes
    -----
    The condition number is the largest singular value of the Jacobian divided by the smallest. It
    mixes metres with radians, so its size depends on the unit of length; where it goes to infinity
    does not.

    Examples
    --------
    >>> import dhlab as dh
    >>> from dhlab import view
    >>> path = np.deg2rad([[0, 40, -60, 50, angle, 0] for angle in (-60, -30, 0, 30, 60)])
    >>> print(view.condition(dh.load("article-6r"), path, 5).table)
    Condition number of the Jacobian along the path
     joint 5 (deg)  condition number  smallest singular value  rank
     -60            13.1              0.149                    6
     -30            14                0.145                    6
     0              singular          0                        5
     30             13.4              0.1491                   6
     60             12.5              0.1497                   6
    """
    qs, along = _given(arm, qs, joint)
    sizes = np.linalg.svd(arm.jacobian(qs), compute_uv=False)
    if len(arm) < 6:
        raise ValueError(
            f"view.condition: expected an arm of six joints or more, found {len(arm)}: with fewer"
            " some direction is lost everywhere"
        )
    with np.errstate(divide="ignore"):
        numbers = sizes[:, 0] / sizes[:, -1]
    picture = Picture(
        _figure(arm, along, numbers, joint, title),
        _alt(arm, along, numbers, joint),
        (f"joint {joint} ({_unit(arm, joint)[1]})", *HEADINGS),
        _rows(along, numbers, sizes),
        "Condition number of the Jacobian along the path",
        {"curve": np.column_stack([along, numbers])},
    )
    picture.summary = "The numbers as a table"
    return picture


def _unit(arm, joint):
    """Factor and name of the unit in which a joint's values are written."""
    return (1.0, "m") if arm.table.joints[joint - 1] == "P" else (180 / np.pi, "deg")


def _given(arm, qs, joint):
    """The path and the values of the joint along it, in the unit people read."""
    require_arm(arm, "view.condition")
    if joint not in range(1, len(arm) + 1):
        raise ValueError(f"view.condition: expected a joint from 1 to {len(arm)}, found {joint!r}")
    if arm.forward(qs).shape[:-2] != (len(qs),) or len(qs) < 2:
        raise ValueError(
            f"view.condition: expected a path (m, {len(arm)}) of two configurations at least, found"
            f" shape {np.shape(qs)}"
        )
    qs = np.asarray(qs, dtype=float)
    along = qs[:, joint - 1] * _unit(arm, joint)[0]
    if np.ptp(along) < 1e-9:
        raise ValueError(
            f"view.condition: expected joint {joint} to move along the path, found one value"
            " throughout; name the joint that moves"
        )
    return qs, along


def _figure(arm, along, numbers, joint, title):
    name = title if title is not None else f"{arm.name or 'Arm'}: how near to a singularity"
    label = f"joint {joint} ({_unit(arm, joint)[1]})"
    figure = _page(along, numbers, label, heading(name), 560.0)
    lines = heading(name, NARROW.width)
    figure.narrow = partial(_page, along, numbers, label, lines, NARROW.width)
    return figure


def _page(along, numbers, label, lines, width):
    head = 10.0 + 17.0 * len(lines)
    height = 223.0 + head
    figure = Page(figsize=(width / 72, height / 72), dpi=DPI, facecolor="white")
    FigureCanvasAgg(figure)
    axes = figure.add_axes((56 / width, 50 / height, 1 - 78 / width, 1 - (58 + head) / height))
    lost = numbers > SINGULAR
    top = 2 * numbers[~lost].max(initial=10 * numbers.min())
    # where there is no number the curve rises past the upper edge, so that no peak is seen
    endless = np.where(lost, 100 * top, numbers)
    axes.semilogy(along, endless, color=CURVE, linewidth=2.0, gid="curve")
    for value in along[lost]:
        axes.axvline(value, color=LOST, linewidth=1.2, linestyle=(0, (4, 2)), gid="singular")
        axes.annotate(
            "singular: no end ↑",
            (value, top),
            (5, -12),
            textcoords="offset points",
            color=LOST,
            family=FONT,
            fontsize=SIZES["tick"],
        )
    axes.set(xlim=(along.min(), along.max()), ylim=(0.7 * numbers.min(), top))
    _letter(axes, label)
    for k, (line, kind) in enumerate(lines):
        figure.text(
            0.5,
            1 - (8 + 17 * k) / height,
            line,
            ha="center",
            va="top",
            family=FONT,
            fontsize=SIZES[kind],
            color=INK,
            parse_math=False,
        )
    return figure


def _letter(axes, along):
    """Scales, grid and names of the axes."""
    style = {"color": INK, "family": FONT, "fontsize": SIZES["tick"]}
    axes.set_xlabel(along, **style)
    axes.set_ylabel("condition number", **style)
    axes.yaxis.set(
        major_locator=LogLocator(subs=(1, 2, 5)),
        minor_locator=NullLocator(),
        major_formatter=StrMethodFormatter("{x:g}"),
    )
    axes.grid(True, color=FLOOR, linewidth=0.8)
    axes.tick_params(labelsize=SIZES["tick"], labelcolor=INK, color=QUIET)
    axes.spines[["top", "right"]].set_visible(False)


def _shown(value):
    return "singular" if value > SINGULAR else number(value, 1)


def _rows(along, numbers, sizes):
    """Configurations evenly spread along the path, and the singular ones with their neighbours."""
    lost = np.flatnonzero(numbers > SINGULAR)
    evenly = np.linspace(0, len(along) - 1, min(ROWS, len(along))).round().astype(int)
    chosen = {int(k) for k in [*evenly, *lost - 1, *lost, *lost + 1] if 0 <= k < len(along)}
    return [
        [
            number(along[k], 3),
            _shown(numbers[k]),
            number(sizes[k, -1], 4),
            str(int((sizes[k] * SINGULAR > sizes[k, 0]).sum())),
        ]
        for k in sorted(chosen)
    ]


def _alt(arm, along, numbers, joint):
    unit = _unit(arm, joint)[1].replace("deg", "°").replace("m", " m")
    best = int(np.argmin(numbers))
    lost = [f"{number(value, 2)}{unit}" for value in along[numbers > SINGULAR]]
    worst = int(np.argmax(numbers))
    end = (
        f"The arm is singular at joint {joint} = {listed(lost)}: there the number has no end."
        if lost
        else (
            f"It is highest, {_shown(numbers[worst])}, at {number(along[worst], 2)}{unit}; the path"
            " meets no singularity."
        )
    )
    return (
        f"{words.who(arm)}. The condition number of its Jacobian, on a logarithmic scale, while"
        f" joint {joint} goes from {number(along[0], 2)}{unit} to {number(along[-1], 2)}{unit}. It"
        f" is lowest, {_shown(numbers[best])}, at {number(along[best], 2)}{unit}. {end}"
    )
