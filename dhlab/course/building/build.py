"""Building the course: ``solutions/NN-name.md`` becomes an executed solution and the lesson that is
handed out.

Run it as a module::

    python -m dhlab.course.building.build            # lint, then rebuild everything
    python -m dhlab.course.building.build 04         # lint and rebuild one lesson
    python -m dhlab.course.building.build --check    # say what differs from what is committed,
                                                     # change nothing
"""

import argparse
import sys
from collections.abc import Sequence

import nbformat

from ...formats.files import write_text
from . import contract, reading
from .discussion import discussion
from .faults.runs import refuse_runs
from .faults.sources import refuse_sources
from .notebooks import lesson_notebook, ran, solution_notebook, without_outputs
from .reading import read_source, sources

__all__ = ["build", "stale"]


def build(only: Sequence[str] = ()) -> None:
    """Rebuild the lessons named by number, or all.

    Raises
    ------
    ValueError
        A source that cannot become a lesson, a broken line of the contract, a solution that its
        checks do not find right, an answer that would be handed out; of this lesson, then, nothing
        is written.
    """
    try:
        refuse_sources(sources(only))
    except ValueError as error:
        raise ValueError(f"nothing was built:\n{error}") from None
    _, failures = contract.report(only)
    if failures:
        raise ValueError(
            "the lessons break their contract, nothing was built:\n" + "\n".join(failures)
        )
    reading.LESSONS.mkdir(exist_ok=True)
    for path in sources(only):
        notebook = read_source(path)
        lesson, solution = lesson_notebook(notebook), solution_notebook(notebook)
        refuse_runs(path, solution, ran(lesson))
        write_text(
            reading.LESSONS / f"{path.stem}.ipynb", nbformat.writes(lesson) + "\n", overwrite=True
        )
        write_text(
            reading.SOLUTIONS / f"{path.stem}.ipynb",
            nbformat.writes(solution) + "\n",
            overwrite=True,
        )
        print(f"built {path.stem}")
    glossary = reading.SOLUTIONS / "glossary.md"
    write_text(
        reading.LESSONS / "glossary.md", glossary.read_text(encoding="utf-8"), overwrite=True
    )
    write_text(reading.DISCUSSION, discussion(), overwrite=True)


def stale(only: Sequence[str] = ()) -> list[str]:
    """Which committed files a rebuild would change (outputs apart)."""
    differing = []
    for path in sources(only):
        notebook = read_source(path)
        for committed, wanted in (
            (reading.LESSONS / f"{path.stem}.ipynb", lesson_notebook(notebook)),
            (reading.SOLUTIONS / f"{path.stem}.ipynb", notebook),
        ):
            found = (
                nbformat.writes(without_outputs(nbformat.read(committed, as_version=4)))
                if committed.exists()
                else ""
            )
            if found != nbformat.writes(wanted):
                differing.append(str(committed.relative_to(reading.ROOT)))
    glossary = reading.SOLUTIONS / "glossary.md", reading.LESSONS / "glossary.md"
    if not glossary[1].exists() or glossary[0].read_bytes() != glossary[1].read_bytes():
        differing.append("lessons/glossary.md")
    if (
        not reading.DISCUSSION.exists()
        or reading.DISCUSSION.read_text(encoding="utf-8") != discussion()
    ):
        differing.append("dhlab/course/discussion.yaml")
    return differing


def main() -> None:
    """The command line of this module."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("lessons", nargs="*", help="numbers such as 05; all when left out")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    try:
        if options.check:
            differing = stale(options.lessons)
            print(
                "\n".join(
                    f"{name}: not what its source gives; run make lessons" for name in differing
                )
                or "all lessons are what their sources give"
            )
            sys.exit(bool(differing))
        build(options.lessons)
    except ValueError as error:
        sys.exit(str(error))


if __name__ == "__main__":
    main()
