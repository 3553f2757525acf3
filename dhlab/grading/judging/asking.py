"""A student's program, called where it cannot reach the library's own: what it gave, in the words
of the course. Nothing that the program chose is among these words.
"""

from collections.abc import Callable, Mapping
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from typing import Any

from ...course.kinds import Function
from ...doctor.programs.running.calling import Called, CallFault
from ..cage.cage import Cage
from ..cage.talk import Talk
from ..inside.wire import DECODED, decode, encode, error_name

__all__ = ["Asked", "Asking"]

PROGRAM = "call", "names", "cell", "whole"  # what a request says of one program

PARTS = frozenset(
    """Arm DHTable assign_frames calibrate_offsets diagnose diagnose_function equivalent explore
    fit_circles forward frames from_xyz_rpy generate inverse jacobian link_matrices load read_poses
    read_urdf recognise_table robots rot_x rot_y rot_z solve symbolic to trans trans_x trans_z
    transform workspace""".split()
)


@dataclass(frozen=True)
class Asked:
    """What a program gave: the answers to every call, or the fault that stopped it; ``stopped`` is
    "timed out" or "crashed" where it gave none, "stub" where it is still to be written, "nothing"
    where there is no program; ``closed`` names what it wanted of dhlab and was not there;
    ``right_with_library`` says that it is right where that is there; ``in_company`` that other
    programs of the student had run in its process.
    """

    called: Called = field(default_factory=Called)
    stopped: str = ""
    closed: tuple[str, ...] = ()
    right_with_library: bool = False
    in_company: bool = False

    @property
    def missing(self) -> bool:
        """Whether a name or the whole program was missing."""
        fault = self.called.fault
        return self.stopped == "nothing" or (fault is not None and "NameError" in fault.headline)


class Asking:
    """Asks the programs of one student, one call at a time. Those of one notebook are asked in one
    process as long as each answers; whoever doubts what came out asks again, ``alone``.

    ``seconds``: of processor, of all the processes that are over.
    """

    def __init__(self) -> None:
        self.seconds = 0.0
        self._open = ExitStack()
        self._talk: Talk | None = None
        self._key: Any = None

    def ask(
        self,
        cage: Cage,
        request: Mapping[str, Any],
        notebook: bytes,
        exercise: Function,
        number: int,
        alone: bool = False,
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
        alone : bool
            In a process of its own.

        Returns
        -------
        Asked
        """
        program = {name: request[name] for name in PROGRAM}
        # what may be used is the same for all in one process
        key = cage, notebook, {name: request[name] for name in request if name not in PROGRAM}
        company = not alone and self._talk is not None and self._key == key
        if not company:
            self.close()
            self._talk = self._open.enter_context(cage.talk(request, notebook, cage.limits.seconds))
            self._key = key
        talk, cases = self._talk, exercise.cases(number)
        line, answers = _heard(talk, {"program": program} if company else None, cases)
        if len(answers) <= len(cases):
            self.close()
        return replace(_of(talk, line, answers, cases, exercise), in_company=company)

    def close(self) -> None:
        """End the process that is open, if there is one."""
        if self._talk is not None:
            self._open.close()
            self.seconds += self._talk.seconds
            self._talk = self._key = None


def _heard(talk, program, cases):
    """(the last line, the answers) of one program."""
    answers: list[Any] = []
    line = talk.begin(program)
    while line is not None and ("ready" in line or "value" in line):
        if "value" in line:
            answers.append(_plain(line["value"]))
        if len(answers) > len(cases):
            break
        case = cases[len(answers) % len(cases)]  # the first once more at the end
        line = talk.ask({"case": [encode(value) for value in case]})
    return line, answers


def _of(talk, line, answers, cases, exercise):
    """What these lines say."""
    closed = _closed(line)
    if line is None:
        return Asked(stopped=talk.stopped, closed=closed)
    if len(answers) > len(cases):
        return Asked(Called(tuple(answers[:-1]), answers[-1]), closed=closed)
    if isinstance(line.get("fault"), dict):
        return Asked(_told(line["fault"], exercise), closed=closed)
    stopped = next((word for word in ("stub", "nothing") if word in line), "timed out")
    return Asked(stopped=stopped, closed=closed)


def _plain(sent):
    try:
        return decode(sent)
    except DECODED:
        return None


def _closed(line):
    named = line.get("closed") if line else ()
    last = [str(name).rpartition(".")[2] for name in named] if isinstance(named, list) else []
    return tuple(sorted({name if name in PARTS else "its kinematics" for name in last}))


def _told(fault, exercise):
    """What stopped a program, as the course says it."""
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
    }
    make = said.get(fault.get("kind") if isinstance(fault.get("kind"), str) else None)
    return Called(fault=make() if make else _stopped(fault))


def _stopped(fault):
    line = fault.get("line")
    known = type(line) is int and 0 < line < 10_000
    return CallFault(
        f"the function stops with {error_name(fault.get('error'))}",
        f"line {line} of the function" if known else "",
        "Call it yourself and read the last line of the message.",
    )
