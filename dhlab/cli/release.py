"""The verb ``dhlab release``: lessons for a class."""

from pathlib import Path
from typing import Annotated

import typer

from .common import Course, Roster, class_of, settings_of

__all__ = ["release"]


def release(
    out: Annotated[
        Path,
        typer.Option(
            "--out", metavar="DIR", help="Where the lessons go; nothing in it is overwritten."
        ),
    ],
    roster: Roster = "",
    course: Course = "",
    key: Annotated[
        str,
        typer.Option(
            metavar="FILE",
            help=(
                "Your key; teacher.key beside the roster when left out. Made when it is not there."
            ),
        ),
    ] = "",
    same: Annotated[
        bool, typer.Option("--same", help="The same numbers for everybody; no key.")
    ] = False,
) -> None:
    """Hand out: a folder of lessons per student, each with the student's own numbers; without a
    roster, one folder for all.
    """
    from ..grading.handing_out.release import KEY_NAME, key_of
    from ..grading.handing_out.release import release as hand_out

    if key and (same or not roster):
        raise ValueError(
            "release: --key draws each student's own numbers; it goes with --roster and without"
            " --same"
        )
    students, settings = class_of(roster), settings_of(course)
    place = Path(key) if key else Path(roster).parent / KEY_NAME
    secret, new = (None, False) if same or not students else key_of(place, out)
    written, kept = hand_out(
        out, students, secret, tuple(settings.lessons), place if new else None, settings.items
    )
    print(
        f"{len(students) or 1} {'folders' if len(students) > 1 else 'folder'} in {out}: {written}"
        f" files written, {kept} there already."
    )
    if secret:
        print(
            f"{'Your new key' if new else 'Your key'}: {place}. Keep it, and keep it to yourself:"
            " without it nobody can grade these lessons, with it anybody can tell everyone's"
            " numbers."
        )
