"""Pictures for the page and the notebook: frames, arms, configurations, one row of a table. Each says in words and numbers what it shows.

Look at one with ``view.arm(dhlab.load("ur5e"))``; every function returns a :class:`Picture`.
"""

from .axes import axes
from .circle import circle
from .compared import compared
from .condition import condition
from .conventions import conventions
from .explorer import Explorer, explore
from .link import link
from .picture import Picture
from .pictures import arm, frames, poses

__all__ = ["Explorer", "Picture", "arm", "axes", "circle", "compared", "condition", "conventions", "explore", "frames", "link", "poses"]
