"""The verb ``dhlab robots``: the arms of the library."""

import json
from typing import Annotated

import typer

from ..printing import grid_text
from ..robots import entry, load, robots
from .common import Json, described

__all__ = ["list_robots"]


def list_robots(
    name: Annotated[
        str, typer.Argument(help="One arm, such as ur5e or piper.sdk_old; all when left out.")
    ] = "",
    as_json: Json = False,
) -> None:
    """The arms of the library, or the table, source and limits of one."""
    if name:
        arm = load(name)
        print(json.dumps(described(arm), ensure_ascii=False) if as_json else arm)
        return
    entries = [entry(key) for key in robots()]
    if as_json:
        print(
            json.dumps(
                [
                    {
                        "name": e.key,
                        "title": e.name,
                        "tables": list(e.tables),
                        "topology": e.topology,
                        "ambiguity": e.ambiguity,
                    }
                    for e in entries
                ],
                ensure_ascii=False,
            )
        )
        return
    rows = [
        [
            e.key,
            len(best := next(iter(e.tables.values()))),
            best.table.convention,
            ", ".join(e.tables),
            e.name,
        ]
        for e in entries
    ]
    print(grid_text(["name", "joints", "convention", "tables, the best first", ""], rows))
