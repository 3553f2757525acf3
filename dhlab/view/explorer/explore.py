"""``dhlab.explore``: one call, seven modes."""

import inspect
from collections.abc import Sequence
from typing import Any

from numpy.typing import ArrayLike

from ...arm import Arm
from ...placing.board import Placement
from ...table import DHTable
from .modes import MODES
from .widget import Explorer

__all__ = ["arm_bundle", "explore"]


def explore(
    arm: Arm | DHTable | Placement | ArrayLike | Sequence[Sequence[Any]] | None = None,
    mode: str = "arm",
    *,
    length: str = "m",
    **needs: Any,
) -> Explorer:
    """Take hold of an arm, a row of its table, two conventions, measurements, bare axes or a
    single plate, in 3D.

    Parameters
    ----------
    arm : Arm or DHTable
        In mode "place" also a list of joint axes, as :func:`dhlab.assign_frames` takes them, or a
        :class:`dhlab.placing.Placement` with what is placed on it. In mode "pose" the pose (4, 4)
        of a plate, or two of them, ``[T_01, T_12]``; or nothing.
    mode : "arm", "link", "conventions", "compare", "branches", "place" or "pose"
        The whole arm with its frames; the four numbers of one row and the moves they stand for;
        standard and Craig frames together; predicted against measured, or two arms; several
        configurations of one arm, such as what :meth:`Arm.solve` gives; joint axes on which frames
        are to be placed; one plate beside its matrix, or two and the product of theirs.
    length : "m" or "mm"
        The unit in which lengths are shown; Python's side is in metres always. Errors of "compare"
        are in millimetres.
    **needs
        ``q`` (n,): where the arm stands at first, in every mode but "place", "pose", "branches" and
        "compare" with poses; zeros when left out. "arm": ``jacobian=True`` shows its columns, each
        with what its joint does to the end; ``meshes`` draws the real links over the frames: the
        path of a URDF that names STL files, a folder or list of STL files (assembled at q = 0, the
        last number in a name is the link's), or ``{i: file}``, each in its own DH frame. The files
        stay where they are: a saved notebook holds none of them. "link": ``joint``, the row, from
        1. "compare": ``q`` (m, n) and ``poses``, (m, 4, 4) or positions (m, 3); or ``other``, a
        second arm of as many joints. "branches": ``q`` (k, n), all of them. "place":
        ``convention``, "standard" or "craig" (the arm's when left out); ``end`` (4, 4)
        with a list of axes.

    Returns
    -------
    Explorer

    Raises
    ------
    ValueError
        No arm, an unknown mode, or something missing or too much for it.

    Examples
    --------
    >>> import dhlab as dh
    >>> explorer = dh.explore(dh.load("ur5e"), mode="link", joint=2)
    >>> explorer.row.round(3)
    array([ 0.   ,  0.   , -0.425,  0.   ])
    >>> dh.explore(mode="pose").poses[0, :3, 3]
    array([0.4, 0.3, 0.2])
    >>> dh.explore(dh.load("ur5e"), mode="link", row=2)
    Traceback (most recent call last):
    ...
    ValueError: explore: mode "link" takes q, joint, found 'row'; leave it out
    """
    if mode not in MODES:
        raise ValueError(f"explore: expected one of the modes {', '.join(MODES)}, found {mode!r}")
    known = [
        name
        for name, given in inspect.signature(MODES[mode]).parameters.items()
        if given.kind is given.KEYWORD_ONLY
    ]
    for name in needs:
        if name not in known:
            raise ValueError(
                f'explore: mode "{mode}" takes {", ".join(known) or "poses alone"}, found {name!r};'
                " leave it out"
            )
    if length not in ("m", "mm"):
        raise ValueError(f'explore: expected length "m" or "mm", found {length!r}')
    explorer = MODES[mode](arm, **needs)
    if length == "m":  # a page says nothing of what is not there
        explorer._data = {**explorer._data, "metres": True}
    return explorer


def arm_bundle(arm: Arm) -> Any:
    """How an arm shows itself: the explorer with the arm's table as what is seen without it; the
    table alone where no notebook asks.
    """
    from IPython import get_ipython

    if getattr(get_ipython(), "kernel", None) is None:
        return {"text/html": arm._repr_html_(), "text/plain": repr(arm)}
    return explore(arm)._repr_mimebundle_(
        still={"text/html": arm._repr_html_(), "text/plain": repr(arm)}
    )
