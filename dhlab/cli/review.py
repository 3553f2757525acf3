"""The verb ``dhlab review``: each answer beside its verdict, for the teacher to decide."""

from pathlib import Path
from typing import Annotated

import typer

from .common import Course, Roster, class_of, settings_of

__all__ = ["review"]


def review(
    graded: Annotated[
        Path, typer.Argument(metavar="GRADED", help="The folder that dhlab grade wrote to.")
    ],
    roster: Roster = "",
    course: Course = "",
    port: Annotated[int, typer.Option(min=0, max=65535, help="A free one when left out.")] = 0,
    no_browser: Annotated[
        bool, typer.Option("--no-browser", help="Only print the address; open nothing.")
    ] = False,
) -> None:
    """Look through a class's answers in a page on this machine; decide, comment, hold."""
    import webbrowser

    from ..grading.reviewing.desk import Desk
    from ..grading.reviewing.server import serve

    settings_of(course)  # makes the teacher's own items known
    server, address = serve(Desk(graded, class_of(roster)), port)
    print(
        f"{address}\nOnly this machine can open it. What you decide is in"
        f" {graded / 'decisions.yaml'}; it counts after the next dhlab grade. Ctrl+C ends this.",
        flush=True,
    )
    if not no_browser:
        webbrowser.open(server.once)
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        print("dhlab: review: ended; every decision was saved when it was made")
    finally:
        server.server_close()
