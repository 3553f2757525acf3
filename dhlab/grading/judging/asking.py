"""A student's program, called where it cannot reach the library's own: what it gave, in the words
of the course. Nothing that the program chose is among these words.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from ...course.kinds import Function
from ...doctor.programs.running.calling import Called, CallFault
from ..cage.cage import Cage
from ..inside.wire import DECODED, decode, error_name, pack
from .programs import ABSENT

__all__ = ["Asked", "ask"]

# packages that a program may be written with and that its room may lack; names that a submission
# makes up are not repeated to its student
PACKAGES = frozenset(
    """casadi control ikpy jax klampt mujoco pandas pinocchio pybullet pytransform3d roboticstoolbox
    scipy spatialmath sympy tensorflow torch transforms3d visual_kinematics""".split()
)
PARTS = frozenset(
    """Arm DHTable assign_frames calibrate_offsets diagnose diagnose_function equivalent explore
    fit_circles forward frames from_xyz_rpy generate inverse jacobian link_matrices load read_poses
    read_urdf recognise_table robots rot_x rot_y rot_z solve symbolic to trans trans_x trans_z
    transform workspace""".split()
)


@dataclass(frozen=True)
class Asked:
    """What a program gave.

    Attributes
    ----------
    called : Called
        The answers to every call, or the fault that stopped it.
    stopped : str
        Why there is neither: "timed out", "crashed", "no time" where it was not called any more,
        "stub" where it is still to be written, "nothing" where there is no program; else empty.
    closed : tuple of str
        The parts of dhlab that are closed in its room and that the calls asked for; where not
        every call was answered, also those that were asked for while the program was made.
    seconds : float
    right_with_library : bool
        Whether it is right where these parts are open.
    absent : tuple of str
        The packages that the calls used and that are not there.
    """

    called: Called = field(default_factory=Called)
    stopped: str = ""
    closed: tuple[str, ...] = ()
    seconds: float = 0.0
    right_with_library: bool = False
    absent: tuple[str, ...] = ()


def ask(
    cage: Cage, request: Mapping[str, Any], notebook: bytes, exercise: Function, number: int
) -> Asked:
    """Call a program with the inputs of an exercise, one after the other.

    Parameters
    ----------
    cage : Cage
        Of the room that the task allows.
    request : dict
        See :func:`dhlab.grading.judging.questions.call_request`.
    notebook : bytes
    exercise : Function
    number : int
        The seed of the inputs.

    Returns
    -------
    Asked
    """
    cases = exercise.cases(number)
    answers: list[Any] = []
    closed: set[str] = set()
    absent: set[str] = set()
    with cage.talk(request, notebook, cage.limits.seconds) as talk:
        line = talk.ask()
        to_make_it, single, made = _closed(line), bool(line and line.get("single")), 0
        while line is not None and ("ready" in line or "value" in line):
            if "value" in line:
                answers.append(_plain(line["value"]))
                made = line["made"] if isinstance(line.get("made"), int) else 0
            if len(answers) > len(cases):
                break
            case = cases[len(answers) % len(cases)]  # the first once more at the end
            watched = exercise.watched and len(answers) == len(cases)
            line = talk.ask({"case": [pack(value) for value in case], "watched": watched})
            closed |= _closed(line)
            absent |= {name for name in _named(line, "absent") if name in PACKAGES}
    complete = len(answers) > len(cases)
    called, stopped = Called(), ""
    if complete:
        called = Called(tuple(answers[:-1]), answers[-1], single=single, made=made)
    elif line is None:
        stopped = talk.stopped
    elif isinstance(line.get("fault"), dict):
        called = _told(line["fault"], exercise, lacking=any(_named(line, "absent")))
    else:
        stopped = next((word for word in ("stub", "nothing") if word in line), "timed out")
    wanted = closed if complete else closed | to_make_it
    return Asked(called, stopped, tuple(sorted(wanted)), talk.seconds, absent=tuple(sorted(absent)))


def _plain(sent):
    try:
        return decode(sent)
    except DECODED:
        return None


def _closed(line):
    last = {name.rpartition(".")[2] for name in _named(line, "closed")}
    return {name if name in PARTS else "its kinematics" for name in last}


def _named(line, what):
    named = line.get(what) if line else ()
    return map(str, named) if isinstance(named, list) else ()


def _told(fault, exercise, lacking):
    """What stopped a program, as the course says it; ``lacking`` where it used a module that is not
    there.
    """
    names = ", ".join(exercise.names)
    said: dict[Any, Callable[[], CallFault]] = {
        "signature": lambda: CallFault(
            f"the function cannot be called with {len(exercise.names)} arguments ({names})",
            next=f"Give it the arguments {names}, in this order.",
        ),
        "changed": lambda: CallFault(
            "the function changes the numbers it was given",
            next="Work on a copy, or write x = x + … in place of x += …",
            mistake="inputs-changed",
        ),
        "absent": lambda: CallFault(
            "the function returns what a module gives that is not there where it is graded",
            next=ABSENT,
        ),
    }
    make = said.get(fault.get("kind") if isinstance(fault.get("kind"), str) else None)
    return Called(fault=make() if make else _stopped(fault, lacking))


def _stopped(fault, lacking):
    line = fault.get("line")
    known = type(line) is int and 0 < line < 10_000
    error = error_name(fault.get("error"))
    return CallFault(
        f"the function stops with {error}",
        f"line {line} of the function" if known else "",
        ABSENT
        if lacking or error == "ModuleNotFoundError"
        else "Call it yourself and read the last line of the message.",
    )
