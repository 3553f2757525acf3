"""What a pasted thing is: the readers of all dialects asked in turn."""

import re
from dataclasses import replace

import numpy as np

from .completing.accounted import require_accounted
from .completing.alike import holds, repeats, same_arm
from .completing.lists import with_lists
from .completing.turns import with_turns
from .completing.uses import with_uses
from .completing.words import OF_ANGLES, with_words
from .computed.changed import with_changes
from .dialects import arrays, keyed, numbered
from .dialects.bracketed import rows
from .dialects.called import calls, functions
from .dialects.chains import opw, segments, sequences, universal
from .dialects.lined import lines
from .dialects.lined.grid import NoRows, from_grid
from .dialects.lined.heading import header
from .dialects.lined.widths import NotFour
from .evidence.axes import axes_in
from .evidence.ending import require_closed, require_whole
from .evidence.ends import with_ends
from .evidence.poses import require_pose
from .evidence.several import require_one_value
from .evidence.source import source_of
from .language.expressions import key
from .language.letters import unified
from .language.wrapping.comments import uncommented
from .language.wrapping.notebook import without_notebook
from .meaning.beside import APART, with_added, with_types
from .meaning.columns import NAMED, is_a_table
from .meaning.joint_types import with_made_joints, with_sigma
from .pasted import Pasted

__all__ = ["take_apart"]

READERS = (
    universal.read,
    opw.read,
    segments.read,
    calls.read,
    arrays.read,
    rows.read,
    functions.read,
    keyed.read,
    numbered.read,
    sequences.read,
    lines.read,
)
LISTS_READ = (
    universal.read,
    arrays.read,
)  # these give lists beside the columns a meaning themselves
OTHERS = re.compile(  # four numbers each, and no links
    r"way_?p|point|traj|path|target|goal|test|vert|obstacle|colou?r|box|face", re.IGNORECASE
)
FEWEST = 3  # rows of a second arm
# of all links: robot.offset = [0 1]
OFFSETS = re.compile(r"^\s*\w+\.offset\s*=\s*\[", re.MULTILINE)


def take_apart(given, values=None, nominal=None, length=None):
    """The Pasted table in a text, or in rows of numbers and texts; a list of Readings where the
    text describes an arm otherwise.

    Raises
    ------
    ValueError
        One sentence with the line: expected, found, what to do.
    """
    if isinstance(given, str):
        return _from_text(given, values, nominal, length)
    if isinstance(given, (bytes, dict)) or not np.iterable(given):
        raise ValueError(
            "recognise_table: expected a text or rows of four numbers, found"
            f" {type(given).__name__}; paste the table as text"
        )
    cells = [
        list(row) if np.iterable(row) and not isinstance(row, (str, bytes, dict)) else [row]
        for row in given
    ]
    return from_grid([(f"row {i}", row) for i, row in enumerate(cells, 1)])


def _require_used(text, values):
    """A value is given for a letter of the text, or it does nothing."""
    written = {key(name) for name in re.findall(r"[^\W\d]\w*", unified(text))}
    for name in values or ():
        if re.fullmatch(r"\w+", str(name)) and key(unified(str(name))) not in written:
            raise ValueError(
                f"recognise_table: values: expected a letter of the text, found {str(name)[:30]!r},"
                " which is not in it; write it as the text does"
            )


def _from_text(text, values, nominal, length):
    text = without_notebook(text)
    require_closed(text)
    _require_used(text, values)
    try:
        return _read(source_of(text, values), nominal, length)
    except ValueError as error:
        plain = uncommented(text) if isinstance(error, NoRows) else None
        if plain is None:
            raise
        try:
            found = _read(source_of(plain, values), nominal, length)
        except ValueError:
            raise error from None
        if not isinstance(found, Pasted):
            return found
        return replace(found, notes=(*found.notes, "it was read from the comments"))


def _read(source, nominal, length):
    source.asked_length, stumbled = length or "", None
    for read in READERS:
        if nominal is not None and read is not universal.read:
            raise ValueError(
                "recognise_table: nominal: expected a calibration that holds differences to it,"
                " found none in the text; leave it out"
            )
        try:
            found = read(source, nominal)
        except ValueError as error:
            if isinstance(error, NotFour) and read is rows.read:
                stumbled = error  # some other list: the links may be written otherwise
                continue
            if said := axes_in(source):
                raise ValueError(said) from None
            raise (stumbled or error) from None
        if read in (rows.read, functions.read) and found is not None:
            found = _larger(found, source)
        elif read in (keyed.read, numbered.read) and found is not None:
            found = _drawn(source, found) or found
        if stumbled and found is not None and not _is_likelier(found, read):
            raise stumbled
        if found is not None:
            lines = found.lines if isinstance(found, Pasted) else ()
            require_whole(source, lines[-1] if lines else 0)
            return _completed(found, read, source) if isinstance(found, Pasted) else found
    raise AssertionError  # the last reader answers or raises


def _is_likelier(found, read):
    """Whether what stands beside a list of another width is a table: rows with names, or calls."""
    if not isinstance(found, Pasted):
        return True
    return len(found.rows) > 1 and (found.roles is not None or read is not lines.read)


def _completed(found, read, source):
    """The table that one reader found, with what the rest of the text says of it."""
    later = READERS[READERS.index(read) + 1 :]
    if _lacks_values(found):  # rows of numbers say more than rows of names
        n = (len(found.rows), len(found.rows) + 1)
        others = (one for one in _tables(later, source) if len(one.rows) in n)
        found = next((one for one in others if not _lacks_values(one)), found)
    table = with_words(with_changes(found, source.pasted), source)
    listed = table.form != calls.ROBOTICS_TOOLBOX or OFFSETS.search(source.code)
    if read not in LISTS_READ and listed:
        table = with_lists(table, source)
    table = with_sigma(with_types(with_made_joints(table, source), source), source)
    table = with_ends(with_turns(with_added(table, source), source), source)
    require_one_value(table, source)
    require_pose(table, source)
    _require_one_table(table, source)
    table = with_uses(table, source)
    others = () if _lacks_values(table) else _tables(later, source, in_the_end=True)
    require_accounted(table, source, others)
    return table


def _require_one_table(table, source):
    """No second table stands in the rest of the text.

    Raises
    ------
    ValueError
        One does, with other numbers.
    """
    first, last = table.lines or (0, 0)
    text, code = source.text.split("\n"), source.code.split("\n")
    if not 0 < first <= last <= len(code) or len(text) != len(code):
        return
    empty = [re.sub(r"[^()\[\]{}]", " ", line) for line in code[first - 1 : last]]
    try:
        rest = source_of("\n".join([*text[: first - 1], *empty, *text[last:]]))
    except ValueError:
        return
    other = next(_tables(READERS, rest), None)
    if other is None or len(other.rows) < FEWEST or not other.lines:
        return
    lines = [line for line in rest.text.split("\n")[: other.lines[0]] if re.search(r"\w", line)]
    named = other.roles is not None and other.why.startswith(NAMED)
    of_angles = rest.lines[other.lines[0] - 1 : other.lines[1]]
    if any(OF_ANGLES.search(line) for line in of_angles):
        return  # the links' matrices, written out
    apart = not named and any(APART.search(line) or OTHERS.search(line) for line in lines[-2:])
    if not apart and is_a_table(other) and not holds(table, other):
        raise ValueError(
            f"recognise_table: expected one table, found two: lines {first} to {last} and lines"
            f" {other.lines[0]} to {other.lines[1]}; which one is meant? Leave the other out"
        )


def _lacks_values(table):
    """Whether a length or a twist is a letter without a value."""
    kept = [k for k, role in enumerate(table.roles or ()) if role in ("a", "r", "alpha")]
    return any(not row[k].is_constant for row in table.rows for k in kept)


def _tables(readers, source, in_the_end=False):
    """The Pasted tables that readers find in a text; perhaps with their last numbers."""
    for read in readers:
        found = _read_or_none(read, source)
        if isinstance(found, Pasted) and in_the_end:
            found = _read_or_none(lambda _, one=found: with_changes(one, source.pasted), source)
        if isinstance(found, Pasted):
            yield found


def _larger(found, source):
    """A table with a heading and more rows, where a program stands beside it (what answers of
    assistants end with is often only the beginning of it); or all rows of a file of which only some
    stand in braces.
    """
    alone = len(found.rows) == 1
    if found.roles is None and (named := _read_or_none(numbered.read, source)):
        return named  # numbers with names say more than a list without
    if found.form.startswith("calls") and (named := _with_zeros(found, source)):
        return named
    called = _read_or_none(functions.read, source) if alone else None
    if called:
        return called
    named = keyed.read(source) if alone or found.why == "as their names say" else None
    if named is None and (alone or found.form.startswith("calls")):
        named = _read_or_none(numbered.read, source)
    if named is not None and len(named.rows) > len(found.rows) and not repeats(named, found):
        return named
    try:
        other = lines.read(source)
    except ValueError:
        return found
    return other if other.roles is not None and len(other.rows) > len(found.rows) else found


def _with_zeros(found, source):
    """The numbers that a dictionary has for the letters of calls, ``q2: q2 - pi/2``, where these
    have no zeros; None without them.
    """
    named = _read_or_none(numbered.read, source)
    if named is None or len(named.rows) != len(found.rows) or not same_arm(named, found):
        return None
    own, theirs = (
        [row[table.roles.index("theta")].value for row in table.rows]
        for table in (found, named)
        if "theta" in (table.roles or ())
    )
    return named if any(theirs) and not any(own) else None


def _drawn(source, found):
    """A table drawn with bars and a heading, of which the numbers named in the text are the
    letters' values, or remarks; None without one of so many rows.

    Raises
    ------
    ValueError
        Both are tables, with other numbers.
    """
    if not any("|" in line and header(line.strip(" |").split("|")) for line in source.lines):
        return None
    table = _read_or_none(lines.read, source)
    if table is None or table.roles is None or len(table.rows) < len(found.rows):
        return None
    if is_a_table(found) and is_a_table(table) and not (holds(table, found) or holds(found, table)):
        raise ValueError(
            "recognise_table: expected one table, found a list of links and a table with other"
            " numbers; which one is meant? Leave the other out"
        )
    return table


def _read_or_none(read, source):
    """What a reader makes of a text that another one has read; None where it stumbles."""
    try:
        return read(source)
    except ValueError:
        return None
