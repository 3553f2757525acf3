"""The verb ``dhlab course``: for who writes exercises."""

import subprocess
import sys
import time
from pathlib import Path
from typing import Annotated

import typer

__all__ = ["course"]

course = typer.Typer(help="For who writes exercises.", no_args_is_help=True)
LOOK = 0.4  # seconds between two looks at the files


@course.callback()
def _course() -> None:
    """For who writes exercises."""


@course.command()
def preview(
    exercise: Annotated[str, typer.Argument(metavar="ID", help='Such as "05.2".')],
    variant: Annotated[int, typer.Option(min=0, help="Whose numbers; 0 for those of all.")] = 0,
    items: Annotated[
        str, typer.Option(metavar="FILE.py", help="A file of questions of your own.")
    ] = "",
    watch: Annotated[
        bool, typer.Option("--watch", help="Show it again whenever its file changes.")
    ] = False,
) -> None:
    """Show one exercise: what is asked, its numbers, and what is said of each answer it knows."""
    if watch:
        _again_and_again(exercise, variant, items)
        return
    from ..course.exercises import exercises
    from ..course.preview import preview as previewed

    if items:
        from ..grading.own_items import read_items

        read_items(items)
    if exercise not in exercises():
        raise ValueError(
            f'course: preview: expected the number of an exercise, such as "05.2", found'
            f" {exercise!r}; is it listed in EXERCISES?"
        )
    print(previewed(exercises()[exercise], variant))


def _again_and_again(exercise, variant, items):
    """Each time in a new process, which reads the files anew."""
    folder = Path(__file__).parents[1] / "course"
    words = ["course", "preview", exercise, "--variant", str(variant)]
    words += ["--items", items] if items else []
    seen = None
    try:
        while True:
            watched = [*folder.rglob("*.py"), *([Path(items)] if items else [])]
            now = max(path.stat().st_mtime_ns for path in watched)
            if now != seen:
                seen = now
                print("\033[2J\033[H" if sys.stdout.isatty() else "", end="", flush=True)
                subprocess.run([sys.executable, "-m", "dhlab", *words], check=False)
            time.sleep(LOOK)
    except KeyboardInterrupt:
        return
