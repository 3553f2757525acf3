"""The verb ``dhlab robots``: the arms of the library, those that a word or a table names, and a
new one.
"""

import json
from dataclasses import replace
from pathlib import Path
from textwrap import fill
from typing import Annotated

import typer

from ..printing import grid_text
from ..robots import entry, known_as, load, robots, search
from .common import Json, described

__all__ = ["list_robots"]

WIDTH = 100  # characters of a line


def list_robots(
    name: Annotated[
        str, typer.Argument(help="One arm, such as ur5e or piper.sdk_old; all when left out.")
    ] = "",
    search_for: Annotated[
        str, typer.Option("--search", metavar="WORD", help="Only arms called so, or made by it.")
    ] = "",
    like: Annotated[
        str, typer.Option(metavar="TABLE", help="Which arm is this table file? A name also serves.")
    ] = "",
    add: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Write a new arm from a URDF or table file.")
    ] = None,
    source: Annotated[
        str, typer.Option(metavar="URL", help="With --add: where the file is from.")
    ] = "",
    key: Annotated[
        str, typer.Option(help="With --add: the arm's short name; the file's when left out.")
    ] = "",
    title: Annotated[
        str, typer.Option(help="With --add: maker and model; the file's name when left out.")
    ] = "",
    base: Annotated[str, typer.Option(help="With --add: the URDF chain's first link.")] = "",
    tip: Annotated[str, typer.Option(help="With --add: the URDF chain's last link.")] = "",
    second: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="With --add: another publisher's URDF or table."),
    ] = None,
    second_tip: Annotated[str, typer.Option(help="With --add: the last link there.")] = "",
    licence: Annotated[str, typer.Option(help="With --add: the licence of the source.")] = "",
    out: Annotated[Path, typer.Option(help="With --add: the folder to write to.")] = Path("."),
    as_json: Json = False,
) -> None:
    """The arms of the library, or the table, source and limits of one."""
    asked = [bool(name), bool(search_for), bool(like), add is not None]
    if sum(asked) > 1:
        raise ValueError(
            "robots: expected one of NAME, --search, --like and --add, found several; ask one at a"
            " time"
        )
    if name:
        arm = load(name)
        print(json.dumps(described(arm), ensure_ascii=False) if as_json else _one(name, arm))
    elif like:
        _like(like, as_json)
    elif add is not None:
        from ..robots.adding import add as write

        if not source:
            raise ValueError("robots: --add: expected --source, found none; say where FILE is from")
        path = write(
            add,
            key=key or add.stem.lower(),
            name=title or add.stem,
            source=source,
            base=base or None,
            tip=tip or None,
            second=second,
            second_tip=second_tip or None,
            licence=licence,
            folder=out,
        )
        print(json.dumps({"file": str(path)}) if as_json else f"Written: {path}")
    else:
        _list(search(search_for) if search_for else robots(), as_json, search_for)


def _one(name, arm):
    """The arm's table, and what the library says of its zero pose, its end and its doubtful parts;
    the latter of its best table, which they were written of.
    """
    key = known_as(name)
    if not key:
        return str(arm)
    said = entry(key)
    told = (("zero pose", said.zero), ("end", said.flange), ("careful", said.ambiguity))
    notes = [
        fill(f"{what}: {words}", WIDTH, subsequent_indent="  ") for what, words in told if words
    ]
    return "\n".join([str(arm), *notes])


_OTHER = {"standard": "Craig's", "craig": "the standard"}


def _misread(arm):
    """The same rows, put into the other convention's matrix."""
    table = arm.table
    convention = "craig" if table.convention == "standard" else "standard"
    return replace(arm, table=replace(table, convention=convention))


def _like(table, as_json):
    from ..robots.likeness import like

    arm = load(table)
    found, other = like(arm), ""
    if not found:
        found, other = like(_misread(arm)), _OTHER[arm.table.convention]
    if found and other and not as_json:
        print(f"None as the table says; with its rows in {other} matrix:")
    if as_json:
        items = [
            {
                "name": one.name,
                "title": one.title,
                "length": one.length,
                "angle": one.angle,
                "words": str(one),
            }
            for one in found
        ]
        print(json.dumps(items, ensure_ascii=False))
        return
    for one in found:
        print(one)
    if not found:
        print(f"None of the {len(robots())} arms of the library is this table.")


def _list(keys, as_json, searched):
    if as_json:
        print(json.dumps([_item(entry(key)) for key in keys], ensure_ascii=False))
        return
    if not keys:
        print(
            f"No arm of the library is called {searched}; dhlab robots lists them all. Where you"
            " have its URDF, xacro or MJCF, dhlab from-urdf FILE gives its table."
        )
        return
    from ..robots.index import summary

    rows = []
    for key in keys:
        said = summary(key)
        best = next(iter(said["tables"].values()))
        tables = ", ".join(said["tables"])
        rows.append([key, len(best["joints"]), best["convention"], tables, said["name"]])
    print(grid_text(["name", "joints", "convention", "tables, the best first", ""], rows))


def _item(e):
    return {
        "name": e.key,
        "title": e.name,
        "maker": e.maker,
        "also": list(e.also),
        "tables": list(e.tables),
        "topology": e.topology,
        "zero": e.zero,
        "flange": e.flange,
        "ambiguity": e.ambiguity,
        "licence": e.licence,
        "links": list(e.links),
        "second": e.second,
    }
