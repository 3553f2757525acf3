"""One page about one arm, to keep: its table, its picture, the check against data, what the doctor
says.
"""

from functools import cached_property
from html import escape
from pathlib import Path
from typing import Any

import numpy as np

from ..arm import Arm
from ..doctor import Diagnosis
from ..formats import files
from ..printing import arm_html

__all__ = ["report", "Report"]

STYLE = """
.dhlab-report {
  font: 15px/1.4 system-ui, sans-serif; color: #1b1f24; background: #fff;
  max-width: 72em; margin: 0 auto; padding: 1em 1.2em;
}
.dhlab-report .sides {
  display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 24em), 1fr));
  gap: 0 2em; align-items: start;
}
.dhlab-report :is(h1, h3) { font-size: 1.5em; margin: 0 0 .2em }
.dhlab-report :is(h2, h4) {
  font-size: 1.1em; margin: .8em 0 .3em; border-bottom: 1px solid #d0d7de;
}
.dhlab-report table {
  border-collapse: collapse; font-variant-numeric: tabular-nums; background: #fff;
}
.dhlab-report caption { text-align: left; color: #57606a; padding: .2em 0 }
.dhlab-report :is(th, td) {
  text-align: right; padding: .1em .7em; border-bottom: 1px solid #eaeef2;
}
.dhlab-report p { margin: .3em 0 }
.dhlab-report figure { margin: .4em 0; overflow-x: auto }
.dhlab-report img { max-width: 100%; height: auto }
.dhlab-report dl { margin: .3em 0 }
.dhlab-report dt { font-weight: 600 }
.dhlab-report dd { margin: 0 0 .3em 1.2em }
.dhlab-report .verdict { border-left: 4px solid #0b62c4; padding: .2em .8em; font-weight: 600 }
@media print {
  .dhlab-report { font-size: 10px; padding: 0 }
  .dhlab-report .sides { grid-template-columns: 2fr 3fr }
  .dhlab-report summary { display: none }
}
"""
NEAR = np.deg2rad(2)  # of 0 or a right angle: such a joint value tests little


def report(arm: Arm, diagnosis: Diagnosis) -> "Report":
    """One page about an arm: table, picture, the check against data, what the doctor says.

    Parameters
    ----------
    arm : Arm
    diagnosis : Diagnosis
        What ``dhlab.diagnose(arm, q, poses)`` said of this arm.

    Returns
    -------
    Report
        A notebook shows it; ``.save("my-arm.html")`` keeps it as one page that needs nothing else.

    Raises
    ------
    ValueError
        No arm, no diagnosis, or the diagnosis of another table.

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("ur5e")
    >>> q = np.random.default_rng(1).uniform(-2, 2, (6, 6))
    >>> page = report(arm, dh.diagnose(arm, q, arm.forward(q)))
    >>> print(page)
    Universal Robots UR5e: The table agrees with the measurements.
    6 poses, position and rotation compared; every joint away from 0 and right angles in 5 of them.
    """
    if not isinstance(arm, Arm):
        raise ValueError(
            f"report: expected an Arm first, found {type(arm).__name__}; make one with dhlab.Arm,"
            " dhlab.assign_frames or dhlab.load"
        )
    if not isinstance(diagnosis, Diagnosis) or diagnosis.compared is None:
        raise ValueError(
            "report: expected what dhlab.diagnose(arm, q, poses) said, found"
            f" {type(diagnosis).__name__}; call it with this arm first"
        )
    if diagnosis.compared[0].table != arm.table:
        raise ValueError(
            "report: expected the diagnosis of this arm, found that of another table; call"
            " dhlab.diagnose again with this arm"
        )
    return Report(arm, diagnosis)


class Report:
    """What :func:`report` returns.

    Attributes
    ----------
    html : str
        The whole page, the same for the same arm and data; every text of the user's is escaped.
    """

    def __init__(self, arm: Arm, diagnosis: Diagnosis) -> None:
        self._arm, self._diagnosis = arm, diagnosis
        self._compared: Any = diagnosis.compared
        self._name = arm.name or "An arm without a name"

    @property
    def html(self) -> str:
        return (
            f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<meta'
            f' name="viewport" content="width=device-width">\n'
            f"<title>{escape(self._name)}</title>\n</head>\n<body>\n{self._article('h1', 'h2')}\n"
            "</body>\n</html>\n"
        )

    def save(self, file: str | Path, overwrite: bool = False) -> None:
        """Write the page: the whole file or nothing.

        Parameters
        ----------
        file : str or path
            Its name ends in ``.html``.
        overwrite : bool
            Replace an existing file; it is kept, with an error, otherwise.

        Raises
        ------
        ValueError
            Another ending, a file that exists, a folder that cannot be written.
        """
        path = Path(file)
        if path.suffix.lower() not in (".html", ".htm"):
            raise ValueError(
                f"{path}: expected a name that ends in .html, found {path.suffix!r}; choose another"
                " name"
            )
        files.write_text(path, self.html, overwrite=overwrite)

    def __str__(self) -> str:
        return f"{self._name}: {self._diagnosis.headline}\n{self._evidence()}"

    __repr__ = __str__

    def _repr_html_(self):
        return self._article("h3", "h4")  # below the headings of the notebook

    def _article(self, large, small):
        """Words and tables on the left, pictures on the right; one below the other where there is
        no room.
        """
        repaired = self._repaired()
        words = [
            (small, "The table"),
            arm_html(self._arm),
            (small, "The doctor's words"),
            self._words(),
        ]
        words += [(small, "The repaired table"), arm_html(repaired)] if repaired else []
        check, frames = self._figures
        pictures = [
            (small, "The check"),
            f"<p>{escape(self._evidence())}</p>",
            check,
            (small, "The arm and its frames"),
            frames,
        ]
        top = [(large, self._name), f'<p class="verdict">{escape(self._diagnosis.headline)}</p>']
        return (
            f'<style>{STYLE}</style>\n<article class="dhlab-report">\n{_html(top)}\n<div'
            f' class="sides">\n<section>\n{_html(words)}\n</section>\n'
            f"<section>\n{_html(pictures)}\n</section>\n</div>\n</article>"
        )

    def _evidence(self):
        """What was compared, and how much that proves."""
        _, q, measured = self._compared
        slides = self._arm.table.prismatic
        general = int((np.abs(np.sin(2 * q)) > np.sin(2 * NEAR))[:, ~slides].all(axis=1).sum())
        what = (
            "position and rotation compared"
            if measured.ndim == 3
            else "positions compared, rotations not"
        )
        return (
            f"{len(q)} pose{'s' if len(q) > 1 else ''}, {what}; every joint away from 0 and right"
            f" angles in {general} of them."
        )

    def _words(self):
        lines = "".join(
            f"<dt>{escape(label)}</dt><dd>{escape(text)}</dd>"
            for label, text in self._diagnosis._lines()
        )
        return f"<p>{escape(self._diagnosis.headline)}</p>\n<dl>{lines}</dl>"

    def _repaired(self):
        """The repaired arm, where the doctor has one that differs."""
        repair = self._diagnosis.findings[0].repair if self._diagnosis.findings else None
        return None if repair == self._arm else repair

    @cached_property
    def _figures(self):
        """The check and the arm, drawn once for all pages: nearly all that a page takes."""
        return _figure(self._diagnosis.picture), _figure(self._picture())

    def _picture(self):
        """The arm where it is stretched furthest, of the poses at hand."""
        from ..view import arm as picture_of  # matplotlib takes long to load

        q = self._compared[1]
        reach = np.ptp(self._arm.frames(q)[..., :3, 3], axis=1).max(axis=-1)
        return picture_of(self._arm, q[np.argmax(reach)], side=False)


def _html(parts):
    """Headings, given as (tag, text), and what is HTML already."""
    return "\n".join(
        part if isinstance(part, str) else f"<{part[0]}>{escape(part[1])}</{part[0]}>"
        for part in parts
    )


def _figure(picture):
    return picture._repr_mimebundle_()["text/html"].replace(
        '<figure class="dhlab-picture">', "<figure>"
    )
