"""Link functions that a program has and does not call, called from outside for each of its rows."""

import ast
import re

import numpy as np

from ..held.budget import FAILURES, Raised
from ..held.factors import is_known_pose
from ..held.values import Class, Function, Instance, Unknown, plain
from .expressions import evaluate

__all__ = ["called_in", "linked", "tables_in"]

AT_ONCE = 3_000  # steps of one call
MOST_TRIED = 40
MOST_LINKS = 10


def called_in(statements):
    """The names of functions that a program calls, or speaks of within a function."""
    found = set()
    for statement in statements:
        for node in ast.walk(statement):
            if isinstance(node, ast.Call):
                found.add(getattr(node.func, "id", getattr(node.func, "attr", "")))
    return found


def linked(run, called):
    """The matrices of links by (function, parameter, rows): what each function that nobody calls
    gives for the rows of a table, or for their numbers; all its other arguments are not known.
    """
    found: dict = {}
    tables = [*tables_in(run)]
    tried = 0
    for function, owner in _functions(run):
        if function.name in called or function.name[:2] == "__":
            continue
        signature = function.node.args
        names = [one.arg for one in (*signature.posonlyargs, *signature.args)]
        if function.owner is None and names[:1] == ["self"]:
            owner = run.me  # a method whose class does not stand in the text
        first = int(owner is not None and function.kind != "staticmethod")
        for at in range(first, len(names)):
            rows = [(name, table) for name, table in tables if not run.is_joint(names[at])]
            for name, table in [("", None), *rows]:
                tried += 1
                if tried > MOST_TRIED:
                    return found
                call = _Call(run, function, owner, names, at)
                matrices = call.of_rows(table) if table else call.of_numbers()
                if matrices:
                    found[function.name, at, name] = matrices
        if owner is None and function.owner is not None:
            for name, table in tables:
                if all(isinstance(one, Instance) and one.cls is function.owner for one in table):
                    matrices = _Call(run, function, None, names, 0).of_rows(table)
                    if matrices:
                        found[function.name, 0, name] = matrices
    return found | _one_for_each(run, called)


def _one_for_each(run, called):
    """The matrices of functions that nobody calls and that make a link each, ``T_12(q)``, by
    ("", 0, what their names have in common).
    """
    alike: dict = {}
    for function in [*run.scope.names.values()]:
        if not isinstance(function, Function) or function.name in called:
            continue
        names = [one.arg for one in function.node.args.args]
        numbered = re.fullmatch(r"(.*_|[A-Za-z]*)(?=\w*\d)[^_]+", function.name)
        if numbered and len(names) < 2 and not function.node.args.defaults:
            alike.setdefault(numbered[1], []).append((function, names))
    found = {}
    for stem, functions in alike.items():
        calls = [_Call(run, one, None, names, -1) for one, names in functions]
        matrices = [call.matrix(None, k) for k, call in enumerate(calls)]
        if len(matrices) > 1 and not any(one is None for one in matrices):
            found["", 0, stem] = matrices
    return found


def _functions(run):
    """(function, its object or None) of the program."""
    for value in [*run.scope.names.values()]:
        if isinstance(value, Function):
            yield value, None
        elif isinstance(value, Class):
            yield from (
                (one, None) for one in value.attributes.values() if isinstance(one, Function)
            )
    for one in run.instances[:6]:
        yield from (
            (part, one) for part in one.cls.attributes.values() if isinstance(part, Function)
        )


def tables_in(run):
    """(name, rows) of what the program holds."""
    places = [run.scope.names, *(one.attributes for one in run.instances[:6])]
    for names in places:
        for name, value in [*names.items()]:
            items = [*value.values()] if isinstance(value, dict) else value
            if isinstance(items, np.ndarray) and items.ndim == 2:
                items = [*items]
            if (
                isinstance(items, list | tuple)
                and 2 <= len(items) <= MOST_LINKS
                and len({type(one) for one in items}) == 1
                and isinstance(items[0], list | tuple | dict | np.ndarray | Instance)
                and not any(map(is_known_pose, items))
            ):
                yield name, items


class _Call:
    """Calls of a function, whose parameter at a place is a row, or its number."""

    def __init__(self, run, function, owner, names, at):
        self.run, self.function, self.owner = run, function, owner
        self.names, self.at = names, at
        self.usual = len(names) - len(function.node.args.defaults)

    def of_rows(self, table):
        """The matrices of all rows; none where one is none."""
        found: list = []
        for k, row in enumerate(table):
            matrix = self.matrix(row, k)
            if matrix is None:
                return []
            found.append(matrix)
        return found

    def of_numbers(self):
        """The matrices of the numbers of rows until there is no such row; none where it goes on, or
        where the first row is the last one once more, as for a number less one.
        """
        found: list = []
        start = int(getattr(self.run.dialect, "counts_from_one", False))
        for k in range(start, start + MOST_LINKS):
            matrix = self.matrix(k, k)
            if matrix is None:
                break
            found.append(matrix)
        else:
            return []
        if len(found) < 2:
            return []
        again = self.matrix(start, start + len(found) - 1)
        return [] if again is None or np.array_equal(again, found[-1]) else found

    def matrix(self, row, k):
        """The matrix of one row, the k-th; None where the call gives none."""
        run, failed = self.run, self.run.failed
        args = [] if self.owner is None else [self.owner]
        try:
            with run.budget.at_most(AT_ONCE):
                for place in range(len(args), len(self.names)):
                    name = self.names[place]
                    if place == self.at:
                        args.append(row)
                    elif place >= self.usual and not run.is_joint(name):
                        default = self.function.node.args.defaults[place - self.usual]
                        args.append(evaluate(run, default, self.function.scope))
                    else:
                        args.append(Unknown(f"{name}[{k}]", run.samples))
                result = run.call(self.function, args, {})
            if run.failed > failed or not is_known_pose(result):
                return None
            return np.asarray(plain(result)) + 0.0
        except (Raised, *FAILURES):
            return None
