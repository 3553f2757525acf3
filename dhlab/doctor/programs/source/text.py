"""The text that a function stands in, and the function again with some of the text replaced."""

import ast
import copy
import inspect
import linecache
from dataclasses import dataclass

import numpy as np

from .calculating import calls_only_known, is_risky, only_calculates
from .memory import remembering

__all__ = ["CODE", "Edit", "Text", "text_of"]

CODE = "<learner, edited>"  # the name of the file that the edited text would be
DEFINITIONS = (ast.FunctionDef, ast.ClassDef)
ASSIGNMENTS = (ast.Assign, ast.AnnAssign, ast.AugAssign)


@dataclass(frozen=True)
class Edit:
    """Bytes ``start`` to ``end`` of a text replaced by ``new``; ``rank`` 0 is what goes wrong most
    often.
    """

    start: int
    end: int
    new: bytes
    rank: int = 1


class Text:
    """A file or a notebook's cell, and the function in it that is looked at.

    Parameters
    ----------
    text : str
    name : str
        The function's name.
    space : dict
        The names that the text finds around it; its values are not changed.

    Raises
    ------
    SyntaxError
        The text is no Python.
    """

    def __init__(self, text, name, space):
        self.data, self.name = text.encode(), name
        self.tree = ast.parse(self.data)
        self._lines = [0]
        for line in self.data.splitlines(keepends=True):
            self._lines.append(self._lines[-1] + len(line))
        self.space = {key: _copied(value) for key, value in space.items()}
        self.defined = {s.name: s for s in self.tree.body if isinstance(s, DEFINITIONS)}
        self.blocks = self._needed([s for s in self.tree.body if self._is_plain(s)], name)
        self._compiled, self._needs = {}, {}

    @property
    def entry(self):
        """The definition of the function; None where its name is set to something."""
        defined = self.defined.get(self.name)
        return defined if isinstance(defined, ast.FunctionDef) else None

    def nodes(self):
        """Every node of what the function needs."""
        for block in self.blocks:
            yield from ast.walk(block)

    def edit(self, node, new, rank=1):
        """The Edit that puts a text in place of a node."""
        return Edit(*self.span(node), new.encode(), rank)

    def span(self, node):
        """The first and the last byte of a node."""
        return (
            self._lines[node.lineno - 1] + node.col_offset,
            self._lines[node.end_lineno - 1] + node.end_col_offset,
        )

    def lines_of(self, statement):
        """The first and the last byte of the lines that a statement stands in, with what decorates
        it.
        """
        first = min([statement, *getattr(statement, "decorator_list", ())], key=lambda s: s.lineno)
        return self._lines[first.lineno - 1], self._lines[statement.end_lineno]

    def of(self, node):
        """What a node's text is."""
        start, end = self.span(node)
        return self.data[start:end].decode()

    def line_at(self, byte):
        """The number of the line, from 1, in which a byte stands."""
        return int(np.searchsorted(self._lines, byte, side="right"))

    def line(self, number):
        """A line of the text, without what surrounds it."""
        return self.data.splitlines()[number - 1].decode().strip()

    def edited(self, edits):
        """The whole text with edits that do not overlap."""
        data = self.data
        for edit in sorted(edits, key=lambda edit: -edit.start):
            data = data[: edit.start] + edit.new + data[edit.end :]
        return data.decode()

    def function(self, edits=(), memory=None):
        """The function of the edited text, made anew.

        Parameters
        ----------
        edits : tuple of Edit
        memory : dict, optional
            What functions that the edits do not reach gave before; it is looked up, and added to.

        Raises
        ------
        Exception
            Whatever the text raises; SyntaxError where an edit makes no Python.
        """
        space = dict(self.space)
        for block in self.blocks:
            start, end = self.lines_of(block)
            inside = tuple(edit for edit in edits if start <= edit.start < end)
            methods = self._edited_methods(block, inside) if inside else {}
            exec(self._code(block, () if methods else inside), space)
            if memory is not None and self._is_untouched(block, edits):
                space[block.name] = remembering(space[block.name], memory)
            for method, changed in methods.items():  # the rest of the class stays compiled
                made = {}
                exec(self._code(method, changed), space, made)
                setattr(space[block.name], method.name, made[method.name])
        return space[self.name]

    def _is_untouched(self, block, edits):
        """Whether a block is another function, and does what it did whatever the edits change."""
        if not isinstance(block, ast.FunctionDef) or block.name == self.name:
            return False
        needed = [self.lines_of(other) for other in self._blocks_of(block.name)]
        return not any(a <= edit.start < b for a, b in needed for edit in edits)

    def _blocks_of(self, name):
        """The statements that a name needs."""
        if name not in self._needs:
            self._needs[name] = self._needed(self.blocks, name)
        return self._needs[name]

    def _edited_methods(self, block, edits):
        """The edits by the method of a class that they stand in; empty where one stands in none."""
        if not isinstance(block, ast.ClassDef) or block.bases or b"super(" in self.data:
            return {}
        found = {}
        for edit in edits:
            home = next((m for m in block.body if self._holds(m, edit)), None)
            if home is None:
                return {}
            found[home] = (*found.get(home, ()), edit)
        return found

    def _holds(self, method, edit):
        if not isinstance(method, ast.FunctionDef) or method.decorator_list:
            return False
        start, end = self.span(method)
        return start < edit.start and edit.end <= end

    def _code(self, statement, edits):
        """A top statement, or a method by itself, compiled with its edits."""
        key = statement, edits
        if key not in self._compiled:
            start, end = self.lines_of(statement)
            data = self.data[start:end]
            for edit in sorted(edits, key=lambda edit: -edit.start):
                data = data[: edit.start - start] + edit.new + data[edit.end - start :]
            code = compile(b"if 1:\n" + data if statement.col_offset else data, CODE, "exec")
            if len(edits) > 1:  # seldom asked for again
                return code
            self._compiled[key] = code
        return self._compiled[key]

    @staticmethod
    def _needed(statements, name):
        """The statements that a name needs, in order."""
        made = [(_made_by(s), _used_by(s)) for s in statements]
        needed, size = {name}, 0
        while size != len(needed):
            size = len(needed)
            needed |= {name for names, used in made if names & needed for name in used}
        return [s for s, (names, _) in zip(statements, made) if names & needed]

    def _is_plain(self, statement):
        """Whether a statement of the text only defines or calculates."""
        if isinstance(statement, DEFINITIONS):
            return True
        return isinstance(statement, ASSIGNMENTS) and calls_only_known(
            statement, self.space, self.defined
        )

    @property
    def functions(self):
        """The functions of the text that may be called: those that are needed, and what only
        calculates.
        """
        return {
            name: defined
            for name, defined in self.defined.items()
            if isinstance(defined, ast.FunctionDef)
            and (defined in self.blocks or only_calculates(defined, self.space, self.defined))
        }


def _used_by(statement):
    return {node.id for node in ast.walk(statement) if isinstance(node, ast.Name)}


def _made_by(statement):
    """The names that a definition or an assignment makes or changes."""
    if isinstance(statement, DEFINITIONS):
        return {statement.name}
    targets = getattr(statement, "targets", None) or [statement.target]
    return {name for target in targets for name in _used_by(target)}


def _copied(value):
    if isinstance(value, (np.ndarray, list, dict)):
        try:
            return copy.deepcopy(value)
        except Exception:
            return value
    return value


def text_of(f):
    """The Text that a function stands in; None where it cannot be had, or does more than calculate.

    Parameters
    ----------
    f : callable

    Returns
    -------
    Text or None

    Examples
    --------
    >>> text_of(abs) is None, text_of(_used_by).of(text_of(_used_by).defined["_used_by"])[:14]
    (True, 'def _used_by(s')
    """
    f = inspect.unwrap(f) if callable(f) else f
    called = f if hasattr(f, "__code__") else getattr(type(f), "__call__", None)  # noqa: B004
    code = getattr(called, "__code__", None)
    if code is None or not hasattr(called, "__globals__"):
        return None
    linecache.checkcache(code.co_filename)  # it may have been written anew
    lines = linecache.getlines(code.co_filename, called.__globals__)
    try:
        text = Text("".join(lines), _name_of(f, called), called.__globals__)
    except (SyntaxError, ValueError):  # magics of a notebook
        return None
    return text if text.blocks and not is_risky(text.blocks) else None


def _name_of(f, called):
    """The name that a function, or an object that is called, has in its file."""
    if called is f and f.__qualname__ == f.__code__.co_name != "<lambda>":
        return f.__name__
    return next((name for name, value in called.__globals__.items() if value is f), "")
