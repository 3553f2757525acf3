"""``Explorer``: what :func:`dhlab.explore` returns, a widget in a notebook and a picture that moves
on a page.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import anywidget
import numpy as np
from numpy.typing import ArrayLike
from traitlets import Dict, Enum, Int, observe, validate

from ...arm import Arm
from ...placing.words import Judgement
from ...table import CONVENTIONS, DHTable
from ...transform import require_pose
from .content import Numbers, pose_data
from .meshes import Part, triangles
from .page import wrapped
from .placing import Placing

__all__ = ["Explorer"]

MODULE = Path(__file__).with_name("explorer.js")


class Explorer(anywidget.AnyWidget):
    """A 3D view whose state can be read and set from Python; hands on its sliders change the same
    state.

    Attributes
    ----------
    mode : str
        "arm", "link", "conventions", "compare", "branches", "place" or "pose".
    arm : Arm or None
        The arm shown; in mode "place" the finished one, None until then; None in mode "pose".
    q : array (n,)
        Radians, metres for a prismatic joint. Set it and the view follows.
    row : array (4,)
        Mode "link": theta, d, a, alpha as shown, joint variable included; radians and metres.
    poses : array (k, 4, 4)
        Mode "pose": plate 1 seen from frame 0, and plate 2 seen from plate 1.
    convention : str
        Mode "link": the order in which the four moves are made; else the arm's.
    step : int
        Which move is done (mode "link", 0 to 4), which pose or solution is shown
        ("compare", "branches", from 1), how far a worked placement is ("place").

    Notes
    -----
    ``explorer.observe(f, "q")`` calls ``f`` with ``change.new`` whenever q changes, from whichever
    side; "row", "poses", "convention" and "step" likewise.

    Examples
    --------
    >>> import dhlab as dh
    >>> explorer = dh.explore(dh.load("article-6r"))
    >>> explorer.q = [np.pi / 2, 0, 0, 0, 0, 0]
    >>> float(explorer.table.theta[0])
    1.5707963267948966
    """

    _esm = MODULE
    _data = Dict().tag(sync=True)
    q = Numbers()
    row = Numbers()
    poses = Numbers()
    convention = Enum(list(CONVENTIONS), "standard").tag(sync=True)
    step = Int().tag(sync=True)
    _answer = Dict().tag(sync=True)

    def __init__(
        self,
        mode: str,
        arm: Arm | None,
        data: dict[str, Any],
        still: Any,
        *,
        state: dict[str, Any],
        placing: Placing | None = None,
        parts: Sequence[Part] = (),
    ) -> None:
        self.mode, self._arm, self._still, self.placing = mode, arm, still, placing
        self.parts = parts
        self.counts = {name: np.shape(state[name]) for name in ("q", "row", "poses")}
        super().__init__(_data=data, **state)
        if placing is not None:
            self._answer = placing.answer()
        self.on_msg(lambda widget, message, buffers: self._heard(message))

    @property
    def arm(self) -> Arm | None:
        """The arm shown; in mode "place" the finished one, None until then."""
        if self.placing is None:
            return self._arm
        return self.placing.placement.arm if self.placing.placement.finished else None

    @property
    def table(self) -> DHTable | None:
        """The numbers as they are shown, joint variables included, as a DHTable; in mode "link" one
        row, in mode "place" None until it is finished.
        """
        if self._arm is not None and self.mode == "link":
            theta, d, a, alpha = self.row[:, None]
            letter = self._arm.table.joints[self._data["index"] - 1]
            return DHTable(self.convention, theta, d, a, alpha, letter)
        arm = self.arm
        if arm is None or self.mode == "place":
            return None if arm is None else arm.table
        moved, table = arm.joint_values(self.q), arm.table
        return DHTable(
            table.convention,
            table.theta + np.where(table.prismatic, 0, moved),
            table.d + np.where(table.prismatic, moved, 0),
            table.a,
            table.alpha,
            table.joints,
        )

    def place(self, step: str, value: ArrayLike, point: ArrayLike | None = None) -> Judgement:
        """Mode "place": make a step as hands would, and see it in the view.

        Parameters
        ----------
        step : str
            "z1", "o1", "x1", ...
        value : array (3,)
            A direction for z and x, a point in metres for an origin.
        point : array (3,), optional
            A point of the line of z.

        Returns
        -------
        Judgement
        """
        if self.placing is None:
            raise ValueError(
                f'explorer.place: expected mode "place", found {self.mode!r}; open one with'
                ' dhlab.explore(arm, mode="place")'
            )
        judgement = self.placing.make(step, value, point)
        self._answer = self.placing.answer(judgement)
        return judgement

    @validate("poses")
    def _checked_poses(self, proposal):
        for k, T in enumerate(proposal.value):
            require_pose(T, f"explorer.poses[{k}]")
        return proposal.value

    @validate("step")
    def _checked_step(self, proposal):
        low, high = self._data.get("steps", (0, 0))
        if not low <= proposal.value <= high:
            raise ValueError(
                f"explorer.step: expected a number from {low} to {high}, found {proposal.value}"
            )
        return proposal.value

    @observe("step")
    def _stepped(self, change):
        """The pose that is shown decides where the arm stands."""
        if "qs" in self._data:
            self.q = self._data["qs"][change.new - 1]

    def _heard(self, message):
        """What the view asks for: the still picture, where it has no WebGL; the links' shapes; a
        new start; a step taken back; a step that hands made.
        """
        if message.get("still"):
            self.send({"still": self._still()._repr_mimebundle_()["text/html"]})
        elif message.get("meshes"):  # as a message, which no notebook keeps
            told = [{"frame": part.frame, "pose": pose_data(part.pose)} for part in self.parts]
            shapes = [
                (triangles(part.file) * part.scale).astype("<f4").tobytes() for part in self.parts
            ]
            self.send({"parts": told}, shapes)
        elif self.placing and message.get("again"):
            self.placing.start_over()
            self._answer = self.placing.answer()
        elif self.placing and message.get("back"):
            self.placing.back()
            self._answer = self.placing.answer()
        else:
            self.place(message["step"], message["value"], message.get("point"))

    def state(self) -> dict[str, Any]:
        """What a page without a kernel starts from."""
        state = {
            "q": self.q.tolist(),
            "row": self.row.tolist(),
            "convention": self.convention,
            "step": self.step,
            "_answer": self._answer,
        }
        if self.poses.size:  # a page says nothing of what is not there
            state["poses"] = self.poses.tolist()
        return state

    def __repr__(self) -> str:
        return f"<Explorer, mode {self.mode}: {self._data['title']}>"

    def _repr_mimebundle_(self, *, still: Any = None, **keywords: Any) -> Any:
        live: Any = super()._repr_mimebundle_(**keywords)
        still = still or self._still()._repr_mimebundle_()
        stored = {
            "text/html": wrapped(still["text/html"], self._data, self.state()),
            "text/plain": still["text/plain"],
        }
        return ({**live[0], **stored}, live[1]) if isinstance(live, tuple) else {**live, **stored}
