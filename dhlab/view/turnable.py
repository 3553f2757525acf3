"""``view.axes`` and ``view.frames``: pictures that a notebook shows as views to be turned."""

from collections.abc import Callable
from functools import wraps
from typing import Any, ParamSpec

import numpy as np

from .explorer.widget import Explorer
from .given import spread
from .picture import Picture
from .pictures import arm as arms
from .pictures import axes as bare

__all__ = ["axes", "frames"]

P = ParamSpec("P")
NOWHERE = {"q": (), "row": (0, 0, 0, 0), "poses": (), "convention": "standard", "step": 0}
BOX = 8  # corners of a sliding joint, as it is drawn


class Turnable(Picture):
    """A Picture that stands still in a file and in a terminal, and in a notebook can be turned."""

    def __init__(self, still: Picture) -> None:
        self.__dict__.update(still.__dict__)
        self.still = still

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> Any:
        from IPython import get_ipython

        if getattr(get_ipython(), "kernel", None) is None:
            return self.still._repr_mimebundle_()
        return self.explorer()._repr_mimebundle_()

    def explorer(self) -> Explorer:
        """The view that a notebook shows."""
        data = {"mode": "turn", "alt": self.alt, "metres": True, **self._seen()}
        return Explorer("turn", None, data, lambda: self.still, state=NOWHERE)

    def _seen(self):
        """What the picture shows, as numbers for the view; found in what was drawn."""
        lines = [
            {"ends": ends.tolist(), "name": f"joint {k}", **_housing(self.points[f"joint:{k}"])}
            for k, ends in self._named("axis:")
        ]
        frames = [_frame(name, self.points) for name, _ in self._named("z-axis:")]
        places = [point for one in lines for point in one["ends"]]
        places += [np.reshape(one["pose"], (4, 4))[:3, 3] for one in frames]
        titles = [text.get_text() for text in self.figure.texts]
        return {
            "lines": lines,
            "normals": [ends.tolist() for _, ends in self._named("normal:")],
            "frames": frames,
            "size": spread(np.array([*places, np.zeros(3)])) or 0.3,
            "title": " ".join(titles) or ("Joint axes" if lines else "Frames"),
            "summary": self.still.summary,
            "table": self.cells,
        }

    def _named(self, kind):
        """Names and points of all that was drawn of one kind, in order."""
        return [(key[len(kind) :], at) for key, at in self.points.items() if key.startswith(kind)]


def _housing(corners):
    return {"at": corners.mean(axis=0).tolist(), "slides": len(corners) == BOX}


def _frame(name, points):
    pose = np.eye(4)
    for k, letter in enumerate("xyz"):
        start, tip = points[f"{letter}-axis:{name}"]
        pose[:3, k], pose[:3, 3] = (tip - start) / np.linalg.norm(tip - start), start
    written = f"{{{name}}}" if name.isdigit() else name
    # a word as a subscript stands off
    return {
        "pose": pose.ravel().tolist(),
        "name": name if name.isdigit() else f" {name}",
        "title": written,
    }


def _turnable(draw: Callable[P, Picture]) -> Callable[P, Picture]:
    @wraps(draw)
    def drawn(*args: P.args, **keywords: P.kwargs) -> Picture:
        return Turnable(draw(*args, **keywords))

    return drawn


axes = _turnable(bare.axes)
frames = _turnable(arms.frames)
