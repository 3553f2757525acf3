"""The picture of one row: two frames and the four parameters that lead from the first to the
second.
"""

import numpy as np

from ...printing import listed
from ...table import DHTable
from .. import words
from ..drawing.camera import best_orbit
from ..drawing.moves import add_link_and_axes, add_move, moves_of
from ..drawing.page import View, compose
from ..drawing.scene import Scene
from ..drawing.triads import add_triads
from ..picture import Picture

__all__ = ["link"]

CONVENTIONS = {"standard": "the standard convention", "craig": "Craig's convention"}


def link(table: DHTable, i: int, q: float = 0.0) -> Picture:
    """Row i of a table, its parameters drawn as what they are: theta and alpha arcs about z and x,
    d and a lengths along them.

    Parameters
    ----------
    table : DHTable
    i : int
        The row, counted from 1.
    q : float
        The joint variable, radians or metres, added to theta_i (or d_i).

    Returns
    -------
    Picture
        Frame {i-1} stands upright at the origin. Parameters that are 0 are in the table only, in
        the order in which they act.

    Raises
    ------
    ValueError
        No table, no such row, or a ``q`` that is not one finite number.

    Examples
    --------
    >>> import dhlab as dh
    >>> from dhlab import view
    >>> table = dh.DHTable.craig([[0, 0.1, 0, 0], [40, 0.3, 0.4, 50]], angle="deg")
    >>> print(view.link(table, 2).table)
    Row 2, from {1} to {2}, in Craig's convention
     parameter  what it is       value
     alpha_1    turn about x_1   50°
     a_1        shift along x_1  0.4 m
     theta_2    turn about z_2   40°
     d_2        shift along z_2  0.3 m
    """
    i, q = _checked(table, i, q)
    moves = moves_of(table, i, q)
    first, last = np.eye(4), moves[-1].end
    reach = np.linalg.norm([move.value for move in moves if not move.is_turn])
    length = 0.42 * float(reach) or 0.1
    scene = Scene()
    add_link_and_axes(scene, moves, length)
    add_triads(scene, np.array([first, last]), [str(i - 1), str(i)], 0.85 * length)
    camera = best_orbit(_directions(moves))
    for move in sorted(moves, key=lambda move: not move.is_turn):
        # lengths go where the arcs leave room
        if not move.is_nothing:
            add_move(scene, move, length, camera)
    convention = CONVENTIONS[table.convention]
    figure = compose(
        [View(scene, camera, frame=(56.0, 20.0, 56.0, 20.0))],
        f"Row {i}: from {{{i - 1}}} to {{{i}}}, in {convention}",
    )
    rows = [
        [
            f"{move.kind}_{move.row}",
            f"{'turn about' if move.is_turn else 'shift along'} {move.letter}_{move.axis}",
            move.amount,
        ]
        for move in moves
    ]
    caption = f"Row {i}, from {{{i - 1}}} to {{{i}}}, in {convention}"
    picture = Picture(
        figure,
        _sentences(moves, i, convention),
        ("parameter", "what it is", "value"),
        rows,
        caption,
        scene.named(),
    )
    picture.summary = "The row as a table"
    return picture


def _checked(table, i, q):
    if not isinstance(table, DHTable):
        raise ValueError(
            f"view.link: expected a DHTable first, found {type(table).__name__}; of an arm give"
            " arm.table"
        )
    if isinstance(i, bool) or not isinstance(i, (int, np.integer)) or not 1 <= i <= len(table):
        raise ValueError(
            f"view.link: expected a row from 1 to {len(table)}, found {i!r}; rows are counted"
            " from 1"
        )
    array = np.asarray(q)
    if array.shape != () or array.dtype.kind not in "iuf" or not np.isfinite(array):
        raise ValueError(
            "view.link: expected one finite number for q (radians, metres for a prismatic joint),"
            f" found {q!r}"
        )
    return int(i), float(array)


def _directions(moves):
    """What should be seen at full length: the x and z axes of both frames."""
    first, last = moves[0].start, moves[-1].end
    return np.array([first[:3, 0], first[:3, 2], last[:3, 0], last[:3, 2]])


def _sentences(moves, i, convention):
    steps = [
        f"{'turn' if move.is_turn else 'shift'} by {move.kind}_{move.row} = {move.amount}"
        f" {'about' if move.is_turn else 'along'} {move.letter}_{move.axis}"
        for move in moves
        if not move.is_nothing
    ]
    way = (
        f"the way is {listed(steps)}"
        if steps
        else "all four parameters are 0, so the frames coincide"
    )
    end = moves[-1].end
    return (
        f"Row {i} in {convention}, frames {{{i - 1}}} and {{{i}}} with the parameters between them:"
        f" {way}. Seen from {{{i - 1}}}, {{{i}}} is at {words.place(end[:3, 3])}, its x axis"
        f" {words.direction(end[:3, 0])} and its z axis {words.direction(end[:3, 2])}."
    )
