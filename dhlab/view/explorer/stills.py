"""The still pictures: what is seen where no program runs, and stored with a notebook."""

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
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
from ..pictures.arm import frames as frames_picture
from ..pictures.axes import axes as axes_picture
from ..pictures.compared import compared as measured
from ..pictures.conventions import conventions
from ..pictures.link import link
from .placing import Placing

__all__ = ["arm", "branches", "conventions", "link", "measured", "place", "plates", "two"]

SECOND = "#916008"
OTHERS = "#c9ced4"


def arm(arm: Arm, q: NDArray[np.float64]) -> Picture:
    """The arm with its frames."""
    return arm_picture(arm, q, side=False)


def branches(arm: Arm, qs: NDArray[np.float64]) -> Picture:
    """Every configuration as a line from origin to origin, the first one in front."""
    scene, last = Scene(), len(qs)
    chains, ends = arm.frames(qs), arm.forward(qs)
    for k in reversed(range(last)):
        path = dh_path(arm.table.convention, chains[k])
        _add_line(scene, path, ends[k], SECOND if k == 0 else OTHERS, "1" if k == 0 else "")
    add_triads(scene, ends[:1], ["1"], 0.12 * spread(scene.points()), titles=[""], subscripts=False)
    camera = orbit()
    add_floor(scene, camera, floor_height(scene.points()))
    first = words.configuration(arm.table.joints, qs[0])
    return Picture(
        compose(
            [View(scene, camera)], f"{arm.name or 'Arm'}: {last} ways to one pose, one in gold"
        ),
        f"An arm in {last} configurations, drawn over each other as lines, with its end at"
        f" {words.place(ends[0, :3, 3])} in the first of them, q = {first}.",
        ("solution", *(f"q{i + 1}" for i in range(len(arm)))),
        [
            [str(k), *words.configuration(arm.table.joints, q).split(", ")]
            for k, q in enumerate(qs, 1)
        ],
        "Every configuration",
    )


def plates(poses: NDArray[np.float64]) -> Picture:
    """Frame 0 and the plates seen from it; of two also the product the other way round."""
    if len(poses) == 1:
        return frames_picture([np.eye(4), poses[0]], ["0", "1"])
    T_01, T_12 = poses
    return frames_picture(
        [np.eye(4), T_01, T_01 @ T_12, T_12 @ T_01], ["0", "1", "2 = 01·12", "12·01"]
    )


def place(placing: Placing) -> Picture:
    """The bare axes, the base and the end, with the frames that came placed."""
    axes, end, _ = placing.given
    return axes_picture(axes, end, placing.shown)


def two(first: Arm, second: Arm, q: NDArray[np.float64]) -> Picture:
    """Two arms at one configuration, each as a line from origin to origin."""
    titles = (
        first.name or "first",
        (second.name if second.name != first.name and second.name else "second"),
    )
    scene, arms = Scene(), ((first, titles[0], LINK), (second, titles[1], SECOND))
    poses = [np.concatenate([one.frames(q), [one.forward(q)]]) for one in (first, second)]
    for (one, title, color), chain in zip(reversed(arms), reversed(poses)):
        _add_line(scene, dh_path(one.table.convention, chain[:-1]), chain[-1], color, title)
    ends = np.array([chain[-1] for chain in reversed(poses)])
    size = 0.12 * spread(scene.points())
    add_triads(scene, ends, ["2", "1"], size, titles=["", ""], subscripts=False)
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
        [row for chain, title in zip(poses, titles) for row in _rows(chain, title)],
        TABLE,
    )


def _add_line(scene, path, end, color, title):
    path = np.vstack([path, end[:3, 3]])
    scene.add(
        Stroke(path, color, 4.0, casing=1.0),
        *(Dot(point, 4.0, color, "aid") for point in path[::2]),
        Label(path[-1], title, far=True),
    )


def _rows(chain, title):
    names = [f"{{{i}}} {title}" for i in range(len(chain) - 1)]
    return words.frame_rows(chain, [*names, f"end {title}"])
