"""The learner's log: a line per check, only ever appended to, in ``.dhlab/progress.jsonl`` of the
course folder.

Where there is no course folder nothing is written; a line that cannot be read is passed over, never
removed.
"""

import json
from collections.abc import Mapping
from datetime import UTC, datetime
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..printing import grid_text
from .route import SITTINGS, file_of
from .verdict import MARKS, NOT_ATTEMPTED, RECORDED, RIGHT, WRONG, Verdict

if TYPE_CHECKING:
    from .kinds import Exercise

__all__ = ["Log", "Progress", "course_folder", "MARKER"]

MARKER = ".dhlab"
HEAD = ["No.", "exercise", "status", "points"]
RANK = {NOT_ATTEMPTED: 0, WRONG: 1, RECORDED: 2, RIGHT: 2}


def course_folder() -> Path | None:
    """The folder of the course that this notebook lives in, or None: the nearest one upwards that
    holds ``.dhlab``.
    """
    here = Path.cwd()
    return next((folder for folder in (here, *here.parents) if (folder / MARKER).is_dir()), None)


class Log:
    """What has been checked: in this session, and on disk when there is a course folder, that of
    the notebook unless another is given.
    """

    def __init__(self, folder: Path | None = None) -> None:
        self.session: list[dict[str, Any]] = []
        self.folder = folder

    def add(self, verdict: Verdict) -> None:
        """Note a verdict; a folder that cannot be written to costs the learner nothing but the
        note.
        """
        entry = {
            "time": datetime.now(UTC).isoformat(timespec="seconds"),
            "exercise": verdict.exercise,
            "status": verdict.status,
            "mistake": verdict.mistake,
            "points": verdict.points,
        }
        entry |= {} if verdict.known is None else {"known": verdict.known}
        self.session.append(entry)
        folder = course_folder()
        if folder is None or verdict.status == NOT_ATTEMPTED:
            return
        try:
            with open(folder / MARKER / "progress.jsonl", "a", encoding="utf-8") as file:
                file.write(json.dumps(entry) + "\n")
        except OSError:
            pass

    def wrong_tries(self, exercise: str) -> int:
        """How many wrong answers to an exercise were checked in this session."""
        return sum(
            entry["exercise"] == exercise and entry["status"] == WRONG for entry in self.session
        )

    def entries(self) -> list[dict[str, Any]]:
        """Every entry, oldest first: the file's, then this session's that are not in it."""
        folder = self.folder or course_folder()
        return [*(_read(folder / MARKER / "progress.jsonl") if folder else []), *self.session]

    def best(self) -> dict[str, tuple[str, float]]:
        """The best status of each exercise: {id: (status, points)}."""
        best: dict[str, tuple[str, float]] = {}
        for entry in self.entries():
            status, key = entry["status"], entry["exercise"]
            before = RANK.get(best[key][0], -1) if key in best else -1
            if status in RANK and RANK[status] >= before:
                best[key] = (status, entry["points"])
        return best

    def known_at_first(self) -> dict[str, bool]:
        """Of each question of the pre-test, whether its first answer was right: {id: bool}."""
        first: dict[str, bool] = {}
        for entry in self.entries():
            if isinstance(entry.get("known"), bool):
                first.setdefault(entry["exercise"], entry["known"])
        return first


def _read(path):
    try:
        lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError:
        return
    for line in lines:
        try:
            entry = json.loads(line)
        except json.JSONDecodeError:
            continue
        if (
            isinstance(entry, dict)
            and {"exercise", "status", "points"} <= entry.keys()
            and isinstance(entry["points"], (int, float))
        ):
            yield entry


class Progress:
    """Every exercise and how it stands; shown as a table, those of *More practice* below the others
    and summed apart, with the way to the sitting after it.
    """

    def __init__(
        self,
        exercises: "Mapping[str, Exercise]",
        best: Mapping[str, tuple[str, float]],
        following: str = "",
    ) -> None:
        self._following = following
        self._rows: dict[str, dict[str, Any]] = {
            key: {
                "title": exercise.title,
                "status": best.get(key, (NOT_ATTEMPTED, 0))[0],
                "points": best.get(key, (NOT_ATTEMPTED, 0))[1],
                "of": exercise.points,
                "practice": exercise.practice,
            }
            for key, exercise in exercises.items()
        }

    def to_dict(self) -> dict[str, dict[str, Any]]:
        """{id: {title, status, points, of, practice}}."""
        return self._rows

    def _parts(self):
        """(caption, its rows): the exercises that finish a lesson, and *More practice* if any."""
        for practice in (False, True):
            rows = {key: row for key, row in self._rows.items() if row["practice"] == practice}
            earned, of = (sum(row[name] for row in rows.values()) for name in ("points", "of"))
            if rows or not practice:
                yield f"{'More practice: ' * practice}{earned:g} of {of:g} points", _cells(rows)

    def __str__(self) -> str:
        return "\n".join(f"{grid_text(HEAD, rows)}\n {said}" for said, rows in self._parts())

    __repr__ = __str__

    def _repr_html_(self):
        return "".join(_table(said, rows) for said, rows in self._parts()) + self._link()

    def _link(self):
        """The way to the next sitting."""
        name = self._following
        if not name:
            return ""
        title = SITTINGS[name][1]
        return f'<p><a href="{file_of(name)}">Next: {name} {escape(title)} →</a></p>'


def _cells(rows):
    """The rows as they are shown."""
    return [
        [
            key,
            row["title"],
            "{} {}".format(*MARKS[row["status"]]).lower(),
            f"{row['points']:g} of {row['of']:g}",
        ]
        for key, row in rows.items()
    ]


def _table(said, rows):
    """An HTML table with a caption."""
    head = "".join(f'<th scope="col" style="text-align:left">{name}</th>' for name in HEAD)
    body = "".join(
        "<tr>"
        + "".join(f'<td style="text-align:left">{escape(cell)}</td>' for cell in cells)
        + "</tr>"
        for cells in rows
    )
    return (
        f"<table><caption>{said}</caption><thead><tr>{head}</tr></thead>"
        f"<tbody>{body}</tbody></table>"
    )
