"""The explorer: one 3D view of an arm, a row, two conventions, measurements or bare joint axes, in
a notebook and on a page without a kernel.

The JavaScript in ``js/`` computes poses itself; ``explorer.js`` beside this file is built from it:
``cd js && npm ci && npm run build``.
"""

from .explore import arm_bundle, explore
from .stored import without_widgets
from .widget import Explorer

__all__ = ["Explorer", "arm_bundle", "explore", "without_widgets"]
