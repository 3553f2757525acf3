"""Pictures for the page and the notebook: frames, arms, configurations, one row of a table. Each
says in words and numbers what it shows.

Look at one with ``view.arm(dhlab.load("ur5e"))``; every function returns a :class:`Picture`.
"""

from .explorer import Explorer, explore
from .picture import Picture
from .pictures.arm import arm, frames, poses
from .pictures.axes import axes
from .pictures.circle import circle
from .pictures.compared import compared
from .pictures.condition import condition
from .pictures.conventions import conventions
from .pictures.link import link

__all__ = [
    "Explorer",
    "Picture",
    "arm",
    "axes",
    "circle",
    "compared",
    "condition",
    "conventions",
    "explore",
    "frames",
    "link",
    "poses",
]
