"""Base and tool: left out, in the wrong place, turned."""

import numpy as np

from ....transform import rot_x, rot_y, rot_z, trans, trans_z
from ..changes import FIRST, LAST, ArmChange, RowChange, scaled
from ..registry import END, mistake
from ..remade import with_parts


@mistake("tool-missing", preference=END, value_of=("tool",))
def tool_missing():
    def make(arm):
        yield None, "", with_parts(arm, tool=np.eye(4))

    yield ArmChange(make, "tool")
    yield RowChange(scaled(d=0), "d", rows=(LAST,), end="tool")


@mistake("tool-on-wrong-side")
def tool_on_wrong_side():
    def make(arm):
        yield None, "", with_parts(arm, base=trans(arm.tool[:3, 3]) @ arm.base, tool=np.eye(4))

    def undo(arm):
        yield with_parts(arm, base=np.eye(4), tool=trans(arm.base[:3, 3]) @ arm.tool), ()

    yield ArmChange(make, "tool", undo=undo)


@mistake("base-height-missing-or-twice", value_of=("base shift",))
def base_height_missing_or_twice():
    for factor in (0, 2):
        yield RowChange(scaled(d=factor), "d", rows=(FIRST,), end="base", within=1e-6)

    def make(arm):
        yield None, "", with_parts(arm, base=trans([0, 0, -arm.base[2, 3]]) @ arm.base)

    yield ArmChange(make, "base")


@mistake("base-turned", preference=END, value_of=("base turn",))
def base_turned():
    def make(arm):
        for turn in (rot_z(np.pi), rot_z(np.pi / 2), rot_z(-np.pi / 2), rot_x(np.pi)):
            yield None, "", with_parts(arm, base=turn @ arm.base)

    def undo(arm):
        yield from ((turned, ()) for _, _, turned in make(arm))

    yield ArmChange(make, "base", undo=undo)


# what makers put behind the last frame: a flange, a hand's turn, both, the hand's fingers; and the
# two ways in which ROS and a DH table turn a tool frame
HAND = rot_z(-np.pi / 4)
KNOWN_FLANGES = (
    trans_z(0.107),
    HAND,
    trans_z(0.107) @ HAND,
    trans_z(0.1034),
    HAND @ trans_z(0.1034),
    trans_z(0.107) @ HAND @ trans_z(0.1034),
    rot_y(np.pi / 2),
    rot_z(np.pi),
)


@mistake("flange-frame", preference=END)
def flange_frame():
    """A known transform from the last frame to a flange or a hand, left out or one too many."""

    def make(arm):
        for flange in KNOWN_FLANGES:
            for moved in (flange, np.linalg.inv(flange)):
                yield None, "", with_parts(arm, tool=arm.tool @ moved)

    def undo(arm):
        yield from ((right, ()) for _, _, right in make(arm))

    yield ArmChange(make, "tool", undo=undo, only="arm")
