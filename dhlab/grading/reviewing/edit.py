"""Changes of ``decisions.yaml`` that keep everything else in it: comments, order, quotes."""

import io
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ruamel.yaml import YAML
from ruamel.yaml.comments import CommentedMap, CommentedSeq
from ruamel.yaml.nodes import ScalarNode
from ruamel.yaml.resolver import VersionedResolver
from ruamel.yaml.scalarstring import DoubleQuotedScalarString

from ...formats import files
from ..results.decisions import read_decisions

__all__ = ["decide", "hold"]

INDENTED = re.compile(r"^( +)[^\s#]", re.MULTILINE)


class _Plain(VersionedResolver):
    """Everything that is written there stays the text that it is: dates and numbers, and a key such
    as ``05.4``, ``1001`` or ``null``, which is an exercise or a student.
    """

    def resolve(self, kind, value, implicit):
        tag = super().resolve(kind, value, implicit)
        return (
            tag if kind is not ScalarNode or not value else super().resolve(kind, "text", implicit)
        )


def decide(
    path: str | Path,
    student: str,
    exercise: str,
    said: Mapping[str, float | str | list[int] | None],
) -> None:
    """Write what is decided of one exercise of one student; None or an empty text takes it back.

    Parameters
    ----------
    path : str or path
        ``decisions.yaml``; read anew each time, so that what was written by hand meanwhile stays.
    student, exercise : str
    said : mapping
        ``points``, ``comment``, ``was``, ``answer`` and ``ticks``, as in the file.

    Raises
    ------
    ValueError
        The file cannot be read, or would not be one that grading takes; it is as it was then.
    """
    _change(path, ("students", student, "exercises", exercise), said)


def hold(path: str | Path, student: str, reason: str) -> None:
    """Hold back all marks of a student, with the reason; an empty one lets them go."""
    _change(path, ("students", student), {"hold": reason})


def _change(path, keys, said):
    path = Path(path)
    read_decisions(path)  # a file that grading refuses is not ours to mend
    old = files.read_text(path, "a teacher's decisions") if path.exists() else ""
    first = INDENTED.search(old)
    yaml = YAML()
    yaml.Resolver = _Plain
    yaml.preserve_quotes, yaml.width, yaml.map_indent = True, 100_000, len(first[1]) if first else 2
    top = yaml.load(old)
    top = CommentedMap() if top is None else top
    _set(top, keys, said)
    out = io.StringIO()
    if top:
        yaml.dump(top, out)
    _write(path, out.getvalue() or "{}\n")


def _set(top, keys, said):
    """Set or take out the values under a path of keys; what is empty then goes too."""
    chain: list[tuple[Any, str]] = []
    here = top
    for key in keys:
        if not isinstance(here.get(key), Mapping):  # nothing, in one of YAML's words for it
            here[_key(key)] = CommentedMap()
        chain.append((here, key))
        here = here[key]
    for key, value in said.items():
        if value is None or value == "" or value == []:
            here.pop(key, None)
        else:
            here[key] = _value(value)
    for above, key in reversed(chain):
        if not above[key]:
            del above[key]


def _key(key):
    """``05.4`` would be a number."""
    return DoubleQuotedScalarString(key) if not key.isidentifier() else key


def _value(value):
    if isinstance(value, list):
        listed = CommentedSeq(map(str, value))
        listed.fa.set_flow_style()  # [1, 3]
        return listed
    if isinstance(value, str):
        return DoubleQuotedScalarString(value)
    return str(int(value) if value == int(value) else value)


def _write(path, text):
    """Whole or not at all, and only what grading reads."""
    trial = path.with_name(f".{path.name}.new")
    try:
        files.write_text(trial, text, overwrite=True)
        read_decisions(trial)
        trial.replace(path)
    finally:
        trial.unlink(missing_ok=True)
