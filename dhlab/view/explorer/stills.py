"""The still pictures: what is seen where no program runs, and stored with a notebook."""

import numpy as np

from .. import words
from ..drawing.bodies import dh_path
from ..drawing.camera import orbit
from ..drawing.floor import add_floor, floor_height
from ..drawing.page import View, compose
from ..drawing.scene import Dot, Label, Scene, Stroke
from ..drawing.style import LINK
from ..drawing.triads import add_triads
from ..given import spread
from ..picture import Picture
from ..pictures.arm import TABLE
from ..pictures.arm import arm as arm_picture
from ..pictures.axes import axes as axes_picture
from ..pictures.compared import compared as measured
from ..pictures.conventions import conventions
from ..pictures.link import link

__all__ = ["arm", "conventions", "link", "measured", "two", "place"]

SECOND = "#916008"


def arm(arm, q):
    """The arm with its frames."""
    return arm_picture(arm, q, side=False)


def place(placing):
    """The bare axes, the base and the end."""
    axes, end, _ = placing.given
    return axes_picture(axes, end)


def two(first, second, q):
    """Two arms at one configuration, each as a line from origin to origin."""
    scene, rows, ends = Scene(), [], []
    titles = (
        first.name or "first",
        (second.name if second.name != first.name and second.name else "second"),
    )
    for one, color, title in ((second, SECOND, titles[1]), (first, LINK, titles[0])):
        chain = one.frames(q)
        end = chain[-1] @ one.tool
        path = np.vstack([dh_path(one.table.convention, chain), end[:3, 3]])
        scene.add(
            Stroke(path, color, 4.0, casing=1.0),
            *(Dot(point, 4.0, color, "aid") for point in path[::2]),
            Label(path[-1], title, far=True),
        )
        rows = (
            words.frame_rows(
                np.concatenate([chain, [end]]),
                [f"{{{i}}} {title}" for i in range(len(chain))] + [f"end {title}"],
            )
            + rows
        )
        ends.append(end)
    add_triads(
        scene,
        np.array(ends),
        ["2", "1"],
        0.12 * spread(scene.points()),
        titles=["", ""],
        subscripts=False,
    )
    camera = orbit()
    add_floor(scene, camera, floor_height(scene.points()))
    apart = 1000 * np.linalg.norm(ends[0][:3, 3] - ends[1][:3, 3])
    alt = (
        f"Two arms at q = {words.configuration(first.table.joints, q)}, drawn over each other as"
        f" lines. Their ends are {apart:.2f} mm apart."
    )
    return Picture(
        compose([View(scene, camera)], f"{titles[0]} (grey) and {titles[1]} (gold)"),
        alt,
        words.FRAME_HEADINGS,
        rows,
        TABLE,
    )
