"""Base and tool: left out, in the wrong place, turned."""

import numpy as np

from ...transform import rot_x, rot_z, trans
from .changes import FIRST, LAST, ArmChange, RowChange, scaled
from .registry import END, mistake
from .remade import with_parts


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

    yield ArmChange(make, "base")
