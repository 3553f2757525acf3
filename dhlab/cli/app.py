"""The command line: one verb each. Errors are one plain sentence on standard error, exit status
2.
"""

import os
import sys
from typing import Annotated

import typer

from .. import __version__
from .compare import compare
from .convert import convert
from .course import course
from .doctor import doctor
from .export import export
from .fk import fk
from .from_axes import from_axes
from .from_urdf import from_urdf
from .generate import generate
from .grade import grade
from .ik import ik
from .lab import lab
from .paste import paste
from .release import release
from .review import review
from .robots import list_robots
from .to_urdf import to_urdf

__all__ = ["app", "main"]

LONGEST = 1500  # letters of an error

app = typer.Typer(
    help="Learn, teach and debug Denavit-Hartenberg kinematics.",
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
)


@app.callback(invoke_without_command=True)
def _top(
    context: typer.Context,
    version: Annotated[bool, typer.Option("--version", help="Print the version.")] = False,
) -> None:
    if context.invoked_subcommand is None:
        print(__version__ if version else context.get_help())


# as the README groups them: for who learns, who teaches, who has an arm
app.command()(lab)
app.command()(release)
app.command()(grade)
app.command()(review)
app.add_typer(export, name="export")
app.add_typer(course, name="course")
app.command()(doctor)
app.command()(paste)
app.command()(fk)
app.command()(ik)
app.command(name="from-urdf")(from_urdf)
app.command(name="from-axes")(from_axes)
app.command(name="to-urdf")(to_urdf)
app.command()(convert)
app.command()(compare)
app.command()(generate)
app.command(name="robots")(list_robots)


def _printable(sentence):
    """Without what a terminal would obey, and no longer than anybody reads: a file's name or a
    value in it may hold anything.
    """
    plain = "".join(c if c.isprintable() else ascii(c)[1:-1] for c in sentence)
    return plain if len(plain) <= LONGEST else f"{plain[:LONGEST]} …"


def main() -> None:
    """The entry point of the ``dhlab`` command."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")  # a terminal without θ still gets an answer
    try:
        sys.exit(app(standalone_mode=False))
    except (KeyboardInterrupt, typer.Abort):
        sys.exit(130)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
    except Exception as error:
        # a usage error; Typer's class for it has moved between versions
        usage = getattr(error, "format_message", None)
        if not usage and not isinstance(error, ValueError):
            raise
        sentence = f"{usage()} See dhlab --help for what there is." if usage else str(error)
        print(f"dhlab: {_printable(' '.join(sentence.split()))}", file=sys.stderr)
        sys.exit(2)
