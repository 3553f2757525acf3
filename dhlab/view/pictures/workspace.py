"""Where the end of an arm can be: its reach, seen from above and from the side."""

from functools import partial

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from numpy.typing import NDArray

from ...arm import Arm
from ...printing import number
from ..drawing.page import NARROW, Page, heading
from ..drawing.style import FLOOR, FONT, INK, QUIET, SIZES
from ..given import require_arm
from ..picture import Picture

__all__ = ["workspace"]

CELLS = 120  # along the longer side of a view
HEADINGS = ("direction", "from (m)", "to (m)")
WIDTH, HEIGHT, HEAD = 8.0, 4.3, 0.55  # inches


def workspace(arm: Arm, n: int = 200_000, seed: int = 0, *, title: str | None = None) -> Picture:
    """The reach of an arm: where its end is at many random joint values, the darker the oftener.

    Parameters
    ----------
    arm : Arm
    n, seed : int
        As :meth:`dhlab.Arm.workspace` takes them.
    title : str, optional

    Returns
    -------
    Picture
        From above, and as a section: height over the distance from the z axis of the base frame.
        The table holds how far the end came in each direction.

    Raises
    ------
    ValueError
        No arm, or a sliding joint without limits.

    Examples
    --------
    >>> import dhlab as dh
    >>> from dhlab import view
    >>> print(view.workspace(dh.load("cobra600"), 50_000).table)
    Where the end was, 50000 random poses
     direction        from (m)  to (m)
     x                0.009     0.6
     y                -0.524    0.524
     z                0.177     0.387
     from the z axis  0.433     0.6
    """
    require_arm(arm, "view.workspace")
    points = arm.workspace(n, seed)
    out = np.hypot(points[:, 0], points[:, 1])
    title = title or f"{arm.name or 'Arm'}: where its end can be"
    figure = _page(title, points, out)
    figure.narrow = partial(_page, title, points, out, narrow=True)
    ends = [*zip("xyz", points.T), ("from the z axis", out)]
    rows = [[name, number(values.min(), 3), number(values.max(), 3)] for name, values in ends]
    picture = Picture(
        figure,
        _alt(arm, points, out),
        HEADINGS,
        rows,
        f"Where the end was, {n} random poses",
        {"end": points},
    )
    picture.summary = "The reach as a table"
    return picture


def _page(title, points, out, narrow=False):
    width, height = (NARROW.width / 72, 7.4) if narrow else (WIDTH, HEIGHT)
    left = 0.2 if narrow else 0.09
    figure = Page(figsize=(width, height), dpi=150)
    FigureCanvasAgg(figure)
    figure.subplots_adjust(
        left=left,
        right=0.95 if narrow else 0.98,
        bottom=0.13 * HEIGHT / height,
        top=1 - (HEAD + 0.05 * HEIGHT) / height,
    )
    for k, (line, _) in enumerate(heading(title, 0.8 * NARROW.width if narrow else None)):
        figure.text(
            left,
            1 - (0.25 + 0.2 * k) / height,
            line,
            size=SIZES["title"],
            color=INK,
            family=FONT,
            va="center",
        )
    apart = {"wspace": 0.32, "hspace": 0.3}
    top, side = figure.subplots(*((2, 1) if narrow else (1, 2)), gridspec_kw=apart)
    _density(top, points[:, 0], points[:, 1], ("x (m)", "y (m)"), "from above")
    _density(side, out, points[:, 2], ("distance from the z axis (m)", "z (m)"), "section")
    return figure


def _density(axes, across, up, labels, name):
    """How often the end was in each square."""
    size = max(np.ptp(across), np.ptp(up)) or 1.0
    edges = [
        np.linspace(v.min() - 0.01 * size, v.max() + 0.01 * size, _cells(v, size))
        for v in (across, up)
    ]
    counts, *_ = np.histogram2d(across, up, bins=edges)
    shown = np.ma.masked_equal(np.log1p(counts.T), 0)  # the few cells near an axis hold the most
    axes.pcolormesh(*edges, shown, cmap="Blues", vmin=-0.6 * shown.max(), rasterized=True)
    axes.plot(0, 0, "+", color=INK, markersize=9, gid="base")
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_title(name, size=SIZES["note"], color=QUIET, family=FONT)
    axes.set_xlabel(labels[0], size=SIZES["tick"], color=INK, family=FONT)
    axes.set_ylabel(labels[1], size=SIZES["tick"], color=INK, family=FONT)
    axes.tick_params(labelsize=SIZES["tick"], colors=QUIET)
    axes.grid(color=FLOOR, linewidth=0.6)
    axes.set_axisbelow(True)


def _cells(values, size):
    return max(3, int(CELLS * np.ptp(values) / size) + 2)


def _alt(arm: Arm, points: NDArray[np.float64], out: NDArray[np.float64]) -> str:
    low, high = points.min(axis=0), points.max(axis=0)
    return (
        f"Where the end of {arm.name or 'an arm'} is at {len(points)} random joint values within"
        f" the limits, seen from above and as a section. It comes {number(out.min(), 2)} to"
        f" {number(out.max(), 2)} m from the z axis, and {number(low[2], 2)} to"
        f" {number(high[2], 2)} m high."
    )
