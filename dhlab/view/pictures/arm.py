"""The pictures of whole arms and of frames."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from ...arm import Arm
from .. import words
from ..drawing.bodies import add_arm, add_tool, dh_path
from ..drawing.camera import PLANES, orbit, widest_plane
from ..drawing.floor import add_drops, add_floor, add_shadow, add_wall, floor_height
from ..drawing.page import View, compose
from ..drawing.scene import Dot, Label, Scene, Stroke
from ..drawing.style import POSES
from ..drawing.triads import add_triads, coincident
from ..given import all_frames, given_arm_at, given_arm_at_all, given_names, given_poses, spread
from ..picture import Picture

__all__ = ["frames", "arm", "poses"]

TABLE = "Origins and axes of the frames, in the world frame"


def frames(
    poses: ArrayLike, names: Sequence[str] | None = None, *, title: str | None = None
) -> Picture:
    """Frames in space, each as three lettered arrows. A notebook shows them as a view that can be
    turned.

    Parameters
    ----------
    poses : array (4, 4) or (k, 4, 4)
        Metres.
    names : sequence of k str, optional
        "0", "1", ... when left out; written {0}, {1}, ...
    title : str, optional

    Returns
    -------
    Picture

    Raises
    ------
    ValueError
        Something that is no pose, or not one name per pose.

    Examples
    --------
    >>> from dhlab import transform, view
    >>> second = transform.trans([0.4, 0, 0.1]) @ transform.rot_x(np.pi / 2)
    >>> picture = view.frames([np.eye(4), second])
    >>> print(picture.table)
    Origins and axes of the frames, in the world frame
     frame  x (m)  y (m)  z (m)  x axis     y axis     z axis
     {0}    0      0      0      (1, 0, 0)  (0, 1, 0)  (0, 0, 1)
     {1}    0.4    0      0.1    (1, 0, 0)  (0, 0, 1)  (0, -1, 0)
    """
    chain = given_poses(poses)
    names = given_names(names, len(chain), [str(k) for k in range(len(chain))])
    shown = [f"{{{name}}}" for name in names]
    origins = chain[:, :3, 3]
    scene, camera = Scene(), orbit()
    add_triads(scene, chain, names, 0.24 * spread(origins) or 0.1)
    height = floor_height(scene.points())
    add_drops(scene, origins[[group[0] for group in coincident(origins)]], height)
    add_floor(scene, camera, height)
    alt = f"{len(chain)} frame{'s' if len(chain) > 1 else ''} in space. " + words.frame_sentences(
        chain, shown
    )
    return _picture([View(scene, camera)], title or "", alt, words.frame_rows(chain, shown))


def arm(arm: Arm, q: ArrayLike | None = None, *, frames: bool = True, side: bool = True) -> Picture:
    """An arm: links along the DH path, joints on their axes, frames, and a view from the side.

    Parameters
    ----------
    arm : Arm
    q : array (n,), optional
        Radians, metres for a prismatic joint; all 0 when left out.
    frames : bool
        Draw every frame; only the end frame otherwise.
    side : bool
        Add a view that shows two world axes in true length.

    Returns
    -------
    Picture

    Raises
    ------
    ValueError
        No arm, or a ``q`` that does not fit it.

    Notes
    -----
    A link goes along z_{i-1} by d, then along x_i by a (standard), or along x_{i-1} by a, then
    along z_i by d (Craig). A joint is drawn in the middle of its d: a cylinder for a revolute
    joint, a box for a prismatic one. Where exactly on its axis a joint sits is nothing a table
    says.

    Examples
    --------
    >>> import dhlab as dh
    >>> from dhlab import view
    >>> print(view.arm(dh.load("article-6r"), side=False).table.splitlines()[-1])
     {6}    0.75   -0.2   0.1    (1, 0, 0)  (0, 0, 1)  (0, -1, 0)
    """
    q, chain = given_arm_at(arm, q)
    poses, names, titles = all_frames(arm, chain)
    path = dh_path(arm.table.convention, chain)
    size = spread(np.vstack([path, poses[:, :3, 3]])) or 0.1
    scene, camera = Scene(), orbit()
    _add_body(scene, arm, chain, poses, size)
    shown = slice(None) if frames else slice(-1, None)
    add_triads(scene, poses[shown], names[shown], 0.13 * size, titles=titles[shown])
    height = floor_height(scene.points())
    add_shadow(scene, path, height)
    add_floor(scene, camera, height)
    views = [View(scene, camera)]
    if side:
        views.append(_side_view(arm, chain, poses, titles, size))
    values = words.configuration(arm.table.joints, q).replace("-", "−")
    return _picture(
        views,
        f"{arm.name or 'Arm'}\nq = ({values})",
        words.arm_sentences(arm, q, poses, titles),
        words.frame_rows(poses, titles),
    )


def _add_body(scene, arm, chain, poses, size):
    add_arm(scene, arm, chain, size)
    if len(poses) > len(chain):
        add_tool(scene, chain[-1, :3, 3], poses[-1, :3, 3])


def _side_view(arm, chain, poses, titles, size):
    """The body without triads, with the names of the frames at the origins; those behind each other
    share a label.
    """
    plane = widest_plane(np.vstack([dh_path(arm.table.convention, chain), poses[:, :3, 3]]))
    camera, scene = PLANES[plane], Scene()
    _add_body(scene, arm, chain, poses, size)
    flat = camera.flat(poses[:, :3, 3])
    for group in coincident(np.round(flat / (0.02 * size))):
        origin = poses[group[0], :3, 3]
        scene.add(
            Dot(origin, 4.5),
            Label(origin, ", ".join(titles[k] for k in group), far=True, gid="side-label"),
        )
    add_wall(scene, camera, plane)
    kind = "view from above" if plane == "x-y" else "side view"
    return View(scene, camera, f"{kind}, {plane.replace('-', '–')} plane", (40.0, 34.0, 24.0, 20.0))


def poses(arm: Arm, qs: ArrayLike, *, names: Sequence[str] | None = None) -> Picture:
    """Several configurations of one arm in one picture, told apart by line style and colour, named
    at the end.

    Parameters
    ----------
    arm : Arm
    qs : array (k, n)
        Radians, metres for a prismatic joint; at most five configurations.
    names : sequence of k str, optional
        "1", "2", ... when left out.

    Returns
    -------
    Picture
        The table holds the end pose of each configuration.

    Raises
    ------
    ValueError
        No arm, a ``qs`` that does not fit it, too many of them, or not one name per configuration.

    Examples
    --------
    >>> import dhlab as dh
    >>> from dhlab import view
    >>> arm = dh.load("article-6r")
    >>> qs = [[0] * 6, [np.pi / 2, 0, 0, 0, 0, 0]]
    >>> print(view.poses(arm, qs, names=["zero", "turned"]).table)
    End frames, in the world frame
     frame   x (m)  y (m)  z (m)  x axis     y axis     z axis
     zero    0.75   -0.2   0.1    (1, 0, 0)  (0, 0, 1)  (0, -1, 0)
     turned  0.2    0.75   0.1    (0, 1, 0)  (0, 0, 1)  (1, 0, 0)
    """
    chains = given_arm_at_all(arm, qs)
    names = given_names(names, len(chains), [str(k + 1) for k in range(len(chains))])
    ends = chains[:, -1] @ arm.tool
    scene, camera = Scene(), orbit()
    paths = [_path_to_end(arm, chain, end) for chain, end in zip(chains, ends)]
    for path, name, (color, dash) in zip(paths, names, POSES):
        scene.add(
            Stroke(path, color, 3.0, dash, casing=1.0, gid=f"pose:{name}"),
            *(Dot(point, 5.5, color, "aid") for point in path[::2]),
        )
    add_triads(
        scene, ends, names, 0.14 * spread(np.vstack(paths)) or 0.1, titles=names, subscripts=False
    )
    height = floor_height(scene.points())
    for path in paths:
        add_shadow(scene, path, height, 3.0)
    add_floor(scene, camera, height)
    alt = (
        f"{words.who(arm)} in {len(chains)} configuration{'s' if len(chains) > 1 else ''}, drawn"
        " over each other. "
    )
    alt += " ".join(
        f"In configuration {name} its end is at {words.place(end[:3, 3])}, its z axis"
        f" {words.direction(end[:3, 2])}."
        for name, end in zip(names, ends)
    )
    return _picture(
        [View(scene, camera)],
        arm.name or "",
        alt,
        words.frame_rows(ends, names),
        "End frames, in the world frame",
    )


def _path_to_end(arm, chain, end):
    path = dh_path(arm.table.convention, chain)
    return path if np.allclose(end[:3, 3], path[-1]) else np.vstack([path, end[:3, 3]])


def _picture(views, title, alt, rows, caption=TABLE):
    figure = compose(views, title)
    return Picture(figure, alt, words.FRAME_HEADINGS, rows, caption, views[0].scene.named())
