"""The walk from the base to the end point, written once for one pose and for many.

A moving frame is carried along the chain. What its numbers are, floats or arrays of thousands, is
its own affair (``one.py``, ``many.py``); here stands only the order of the moves, and this trick:

*A run of parallel axes is turned once.* Where alpha is 0 the next joint turns in the same plane. So
the frame waits at the start of such a run: the angles are added up, every length a is laid out in
the plane in the direction it has by then, and where the run ends the frame is turned once, by the
whole angle. (Not where angles are so large that the rounding of their sum would be seen: then
``joined`` is false, and every joint is turned by itself; a single pose in floats is left to the
plain product then.)

The moves of a frame:

================  ==============================================================================
``add_joint(i)``  along z by d of joint i (0-based), whose angle joins the run
``lay(a)``        by a along the x that the frame would have if it were turned now
``turn(a)``       about z by the angle of the run, then along the new x by a; the next run begins
``go(a)``         along x by a
``tilt(s)``       about x by alpha of a ``Step``
================  ==============================================================================
"""

from collections.abc import Iterator
from typing import Protocol, TypeVar

from .chain import Chain, Step

__all__ = ["along_the_joints", "frame_by_frame", "to_the_end"]


class Frame(Protocol):
    """What is carried along."""

    def add_joint(self, i: int) -> None: ...
    def lay(self, a: float) -> None: ...
    def turn(self, a: float) -> None: ...
    def go(self, a: float) -> None: ...
    def tilt(self, step: Step) -> None: ...


AnyFrame = TypeVar("AnyFrame", bound=Frame)


def along_the_joints(chain: Chain, frame: Frame, joined: bool = True) -> Iterator[int]:
    """Carry the frame through all joints: a generator that stops at each, when z is the joint's
    axis and p a point of it. Behind the last joint only ``chain.end`` is missing.
    """
    last = len(chain) - 1
    _across(frame, chain.steps[0])
    for i in range(last + 1):
        frame.add_joint(i)
        yield i
        step = chain.steps[i + 1]
        if i == last:
            frame.turn(0.0)  # its step is in chain.end
        elif step.parallel and joined:
            frame.lay(step.a)
        else:
            frame.turn(step.a)
            frame.tilt(step)


def to_the_end(chain: Chain, frame: AnyFrame, joined: bool = True) -> AnyFrame:
    """Carry the frame through all joints; returns it."""
    for _ in along_the_joints(chain, frame, joined):
        pass
    return frame


def frame_by_frame(chain: Chain, frame: Frame) -> Iterator[int]:
    """A generator that stops at every frame of the table, frame 0 first; here every joint is turned
    by itself, since its frame is asked for.
    """
    yield 0
    _across(frame, chain.steps[0])
    for i in range(len(chain)):
        frame.add_joint(i)
        step = chain.steps[i + 1]
        if chain.standard:  # its frame i stands behind the step, Craig's before it
            frame.turn(step.a)
            frame.tilt(step)
            yield i + 1
        else:
            frame.turn(0.0)
            yield i + 1
            _across(frame, step)


def _across(frame, step):
    frame.go(step.a)
    frame.tilt(step)
