"""``view.sketch``: the pictures of ideas, which belong to no arm and to no table."""

from collections.abc import Callable

from ..picture import Picture
from .ends import ends, hand_eye
from .hand import right_hand
from .lastaxis import last_axis
from .pipe import bent_pipe
from .tube import bent_tube

__all__ = ["sketch"]

SKETCHES: dict[str, Callable[[], Picture]] = {
    "right hand": right_hand,
    "bent pipe": bent_pipe,
    "bent tube": bent_tube,
    "ends of an arm": ends,
    "last axis": last_axis,
    "hand-eye": hand_eye,
}


def sketch(name: str) -> Picture:
    """A picture of one idea that the course explains.

    Parameters
    ----------
    name : str
        "right hand", "bent pipe", "bent tube", "ends of an arm", "last axis" or "hand-eye".

    Returns
    -------
    Picture

    Raises
    ------
    ValueError
        Another name.

    Examples
    --------
    >>> from dhlab import view
    >>> print(view.sketch("right hand").table)
    What the right hand says
     thumb along  fingers go from  to
     z            x                y
     x            y                z
     y            z                x
    """
    if name not in SKETCHES:
        raise ValueError(
            f"view.sketch: expected one of {', '.join(map(repr, SKETCHES))}, found {name!r}; take"
            " one of these"
        )
    return SKETCHES[name]()
