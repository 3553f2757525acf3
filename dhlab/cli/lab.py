"""The verb ``dhlab lab``: the course in JupyterLab."""

from pathlib import Path
from typing import Annotated

import typer

__all__ = ["lab"]


def lab(
    folder: Annotated[
        Path, typer.Argument(help="Your own folder for the course; made when it is not there.")
    ] = Path("my-course"),
    port: Annotated[
        int, typer.Option(help="The port JupyterLab listens on; a free one when left out.")
    ] = 0,
    browser: Annotated[bool, typer.Option(help="Open a browser window.")] = True,
) -> None:
    """Open the course in JupyterLab, on your own copy of the lessons."""
    from ..course.workspace import open_lab

    raise typer.Exit(open_lab(folder, port=port or None, browser=browser))
