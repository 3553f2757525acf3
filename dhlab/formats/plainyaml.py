"""YAML 1.2 read strictly: every value knows its line, a number is a number, a text is a text, every
key stands once.

Anchors, aliases, merge keys and tags are refused: a table needs none, and they can make a small
file fill the memory.
"""

import difflib
import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

from ruamel.yaml import YAML
from ruamel.yaml.error import MarkedYAMLError, YAMLError
from ruamel.yaml.nodes import MappingNode, ScalarNode, SequenceNode

from .files import read_text

Made = TypeVar("Made")

__all__ = ["Item", "read", "parse", "shown", "fields", "entries", "number", "text", "placed"]

# the core schema of YAML 1.2, section 10.3.2, decimal numbers only
INTEGER = re.compile(r"[-+]?[0-9]+\Z")
FLOAT = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?\Z")
RESOLVED = {"str", "int", "float", "bool", "null", "map", "seq", "timestamp", "merge"}
CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]")  # what a terminal obeys
LONGEST = 10_000  # letters of a text; sources are sentences
EXAMPLES = {"units": "units: {length: mm, angle: deg}", "convention": "convention: standard"}
SPECIAL = re.compile(r"([-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN))\Z")


@dataclass
class Item:
    """A value and the place it was read from: ``value`` is a dict of Items, a list of Items, str,
    int, float, bool or None.
    """

    value: Any
    where: str

    def plain(self) -> Any:
        """The value without places, as Python dicts, lists and scalars."""
        if isinstance(self.value, dict):
            return {key: item.plain() for key, item in self.value.items()}
        if isinstance(self.value, list):
            return [item.plain() for item in self.value]
        return self.value


def read(path: str | Path, what: str = "a table file") -> Item:
    """The top Item of a YAML file; ValueError with file and line when it is not plain YAML."""
    return parse(read_text(path, what), str(path))


def parse(text: str, name: str) -> Item:
    """The top Item of a YAML text; ``name`` stands for the file in errors.

    Examples
    --------
    >>> parse("a: 1e-3", "t.yaml").plain()
    {'a': 0.001}
    >>> parse("{a: 1, a: 2}", "t.yaml")
    Traceback (most recent call last):
    ...
    ValueError: t.yaml: line 1: expected every key once, found "a" twice; take one out
    """
    try:
        node = YAML(typ="safe", pure=True).compose(text)
        return _item(node, name)
    except MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line = f" line {mark.line + 1}:" if mark else ""
        raise ValueError(
            f"{name}:{line} this is no YAML ({error.problem or error.context}); check indents,"
            " brackets and colons"
        ) from None
    except YAMLError as error:
        reached = text.count("\n", 0, getattr(error, "position", 0)) + 1
        raise ValueError(
            f"{name}: line {reached}: expected YAML text, found {str(error).splitlines()[0]}; save"
            " it as plain UTF-8 text"
        ) from None
    except RecursionError:
        raise ValueError(
            f"{name}: expected a table, found brackets nested hundreds deep; is it the right file?"
        ) from None


def _item(node, name):
    if node is None:
        return Item(None, name)
    where = f"{name}: line {node.start_mark.line + 1}"
    if node.anchor is not None:
        raise ValueError(
            f"{where}: expected plain values, found the anchor or alias {node.anchor!r}; write the"
            " value out"
        )
    if _tagged(node):
        raise ValueError(
            f"{where}: expected a plain value, found the tag {_tagged(node)}; take the tag out"
        )
    if isinstance(node, MappingNode):
        return Item(_mapping(node, name), where)
    if isinstance(node, SequenceNode):
        return Item([_item(child, name) for child in node.value], where)
    return Item(_scalar(node, where), where)


def _mapping(node, name):
    items = {}
    for key_node, value_node in node.value:
        where = f"{name}: line {key_node.start_mark.line + 1}"
        if not isinstance(key_node, ScalarNode) or key_node.value == "<<":
            raise ValueError(
                f"{where}: expected a name before the colon, found a merge key or a list; write the"
                " keys out"
            )
        key = key_node.value
        if key in items:
            raise ValueError(
                f'{where}: expected every key once, found "{key[:40]}" twice; take one out'
            )
        items[key] = _item(value_node, name)
        if items[key].value is None:  # nothing stands after the colon, perhaps lines further on
            items[key].where = where
    return items


def _scalar(node, where):
    text = node.value
    if node.style is not None:
        return text
    if text in ("", "~", "null", "Null", "NULL"):
        return None
    if text.lower() in ("true", "false"):
        return text.lower() == "true"
    if INTEGER.match(text):
        return int(text) if len(text) < 40 else float(text)
    if FLOAT.match(text) or SPECIAL.match(text):
        return float(re.sub(r"\.(inf|nan)", r"\1", text.lower()))
    return text


def _tagged(node):
    """A tag that YAML's own resolution does not give, or None."""
    tag = str(node.tag)
    return None if tag.removeprefix("tag:yaml.org,2002:") in RESOLVED else tag


def fields(item: Item, what: str, *, required: set[str], allowed: set[str]) -> dict[str, Item]:
    """The dict of Items in ``item`` when its keys are right; otherwise a sentence that names the
    key and the place.
    """
    if not isinstance(item.value, dict):
        raise ValueError(
            f"{item.where}: {what}: expected {', '.join(sorted(allowed))} with a colon each, found"
            f" {_found(item)}{_such_as(what)}"
        )
    for key, value in item.value.items():
        if key not in allowed:
            near = difflib.get_close_matches(key, allowed, 1)
            todo = (
                f'did you mean "{near[0]}"?' if near else f"known are {', '.join(sorted(allowed))}"
            )
            if key.isdigit():
                todo = "is that a decimal comma? Write 0.425, not 0,425"
            raise ValueError(f'{value.where}: {what}: unknown key "{key[:40]}"; {todo}')
    for key in sorted(required - item.value.keys()):
        raise ValueError(
            f"{item.where}: {what}: no {key}; expected {', '.join(sorted(required))}"
            f"{_such_as(key if key in EXAMPLES else what)}"
        )
    return item.value


def _such_as(what):
    """How a part of a file is written, where there is an example of it."""
    return f", such as {EXAMPLES[what]}" if what in EXAMPLES else ""


def number(item: Item, what: str) -> float:
    """The finite number in ``item``, or a sentence."""
    value = item.value
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise ValueError(
            f"{item.where}: {what}: expected a number, found {_found(item)}; write it as digits"
            " with a decimal point, without quotes or units"
        )
    if not math.isfinite(value):
        raise ValueError(f"{item.where}: {what}: expected a finite number, found {value}")
    return value


def text(item: Item, what: str) -> str:
    """The text in ``item``, or a sentence."""
    if not isinstance(item.value, str):
        todo = "write it after the colon" if item.value is None else "put it in quotes"
        raise ValueError(f"{item.where}: {what}: expected text, found {_found(item)}; {todo}")
    if CONTROL.search(item.value) or len(item.value) > LONGEST:
        found = "control characters" if CONTROL.search(item.value) else f"{len(item.value)} letters"
        raise ValueError(
            f"{item.where}: {what}: expected a short text that can be printed, found {found}; write"
            " it anew"
        )
    return item.value


def entries(item: Item, what: str, length: int | None = None) -> list[Item]:
    """The list of Items in ``item``, of ``length`` entries when given, or a sentence."""
    if not isinstance(item.value, list):
        raise ValueError(f"{item.where}: {what}: expected a list in brackets, found {_found(item)}")
    if length is not None and len(item.value) != length:
        raise ValueError(
            f"{item.where}: {what}: expected {length} entries, found {len(item.value)}"
        )
    return item.value


def _found(item):
    value = item.value
    if value is None:
        return "nothing"
    if isinstance(value, (dict, list)):
        return "a list" if isinstance(value, list) else "a mapping"
    return f"the text {shown(value)}" if isinstance(value, str) else shown(value)


def shown(value: object, most: int = 60) -> str:
    """A value as it is quoted in a sentence: no longer than a line, nothing a terminal obeys.

    Examples
    --------
    >>> shown("x" * 10), shown("x" * 1000, 10)
    ("'xxxxxxxxxx'", "'xxxxxxxxxx…'")
    """
    if isinstance(value, str):
        return repr(value if len(value) <= most else value[:most] + "…")
    text = repr(value)
    return text if len(text) <= most else text[:most] + "…"


def placed(where: object, make: Callable[[], Made]) -> Made:
    """``make()``, with the place put before what it complains of."""
    try:
        return make()
    except ValueError as error:
        raise ValueError(f"{where}: {error}") from None
