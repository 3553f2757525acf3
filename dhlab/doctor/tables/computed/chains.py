"""The chain of links that a program multiplies: the program is run, and run again with other
numbers for what is not known.
"""

import ast
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache

from .held.budget import Budget, Stopped
from .held.values import Samples, Shift
from .interpreting.calling import call_all
from .interpreting.linking import called_in, linked
from .interpreting.running import Run
from .languages.known import statements_in
from .shown import different, shown_in

__all__ = ["chain_of", "tables_of"]

RUNS = 4
SAME = 1e-9
LENGTHS = 11, 10, 9, 8, 7, 6, 5, 4, 3, 2


def chain_of(text):
    """(Links, posed) of the chain that a program computes; ``posed`` are the joints' values that
    it holds itself, by name. None where it computes none, or more than one.

    Examples
    --------
    >>> links, _ = chain_of('''
    ... import numpy as np
    ... def turn(q, a):
    ...     c, s = np.cos(q), np.sin(q)
    ...     return np.array([[c, -s, 0, a * c], [s, c, 0, a * s], [0, 0, 1, 0], [0, 0, 0, 1]])
    ... def fk(q1, q2):
    ...     return turn(q1, 0.4) @ turn(q2 + np.pi / 2, 0.3)
    ... ''')
    >>> [row[2] for row in links.rows], round(links.rows[1][0], 4)
    ([0.4, 0.3], 1.5708)
    """
    way = _way(text)
    if not way.statements:
        return None
    for posing, thorough in ((False, False), (False, True), (True, True)):
        try:
            found = _tried(replace(way, posing=posing, thorough=thorough) if thorough else way)
        except Stopped:
            return None
        if found or found is False:
            return found or None
    return None


def tables_of(text, seed):
    """The Tables that a program holds in a run."""
    way = _way(text)
    try:
        return [*way.run(seed, LENGTHS[0]).watched.tables()] if way.statements else []
    except Stopped:
        return []


@lru_cache(4)
def _way(text):
    """The usual way to run a program."""
    statements, dialect, whole = statements_in(text)
    return Way(statements, Budget(), dialect=dialect, whole=whole)


@dataclass(eq=False)
class Way:
    """How a program is run: whether joints' values that it holds are taken for not known, and
    whether functions are called from outside that others call; ``dialect`` is what its language
    has otherwise than Python, and ``likely`` whether conditions of which nobody knows whether they
    hold go their usual way; where a text is not ``whole``, what it only lists is no chain.
    """

    statements: list
    budget: Budget
    posing: bool = False
    thorough: bool = False
    dialect: object = None
    whole: bool = True
    likely: bool = True
    runs: dict = field(default_factory=dict, init=False)

    def run(self, seed, length, given=()):
        """A Run with the numbers of a seed, and lists of a length where nothing says it."""
        if given or length != LENGTHS[0]:
            return self._run(seed, length, given)
        if seed not in self.runs:
            self.runs[seed] = self._run(seed, length, given)
        return self.runs[seed]

    def _run(self, seed, length, given):
        samples = Samples(seed, dict(given), length, likely=self.likely)
        run = Run(self.budget, samples, self.posing, self.dialect)
        run.program(self.statements)
        call_all(run, self.named, self.thorough)
        return run

    def linked(self, run):
        """What link functions that nobody calls give in a run."""
        if run.linked is None:
            run.linked = linked(run, self.called)
        return run.linked

    @cached_property
    def called(self):
        """The names of functions that the program calls."""
        return called_in(self.statements)

    @cached_property
    def named(self):
        """The names that functions of the program speak of."""
        functions = [
            node
            for statement in self.statements
            for node in ast.walk(statement)
            if isinstance(node, ast.FunctionDef)
        ]
        inside = (
            node for function in functions for part in function.body for node in ast.walk(part)
        )
        return {getattr(node, "id", getattr(node, "attr", "")) for node in inside}


def _tried(way):
    """The chain; None without one, False where there are several."""
    first = way.run(1, LENGTHS[0])
    if (way.posing and not first.posed) or (way.thorough and not (way.posing or first.skipped)):
        return None  # nothing is otherwise than before
    found = _chain(way, first, LENGTHS[0])
    if not first.samples.asked:
        return _undoubted(way, found, LENGTHS[0]) if first.samples.doubted else found
    unbound = any(len(one) == LENGTHS[0] for one in first.factors.products)
    if found is None and unbound and not first.failed:
        return None  # a link for each of as many joints as anybody likes, and none that is known
    for length in _lengths(way.statements) if found is None else LENGTHS[1:2]:
        run = way.run(1, length)
        shorter = _chain(way, run, length)
        if found is None and shorter is not None:
            return _undoubted(way, shorter, length) if run.samples.doubted else shorter
        if found is not None:  # as many joints as anybody likes
            same = shorter and found and len(shorter[0].rows) == len(found[0].rows)
            return found if same else False
    return None


def _undoubted(way, found, length):
    """The chain, unless another comes out where conditions that nobody knows go the other way."""
    if not found or not way.likely:
        return found
    other = replace(way, likely=False)
    against = _chain(other, other.run(1, length), length)
    if against is None:
        return found
    return False if against is False or len(different([found[0], against[0]])) > 1 else found


def _lengths(statements):
    """How long lists of joints' values may be: as long as other lists, or as loops."""
    sizes = set()
    for statement in statements:
        for node in ast.walk(statement):
            if isinstance(node, ast.List | ast.Tuple):
                sizes.add(len(node.elts))
            elif isinstance(node, ast.Call | ast.Compare):  # range(6), i < 6
                parts = node.args if isinstance(node, ast.Call) else node.comparators
                sizes |= {one.value for one in parts if isinstance(one, ast.Constant)}
    return [length for length in LENGTHS[1:] if length in sizes]


def _told(way, first, length):
    """What a program says later of its letters: their numbers, and what is added to joints' values;
    a joint's own number is where it stands, unless others stay as they are beside it.
    """
    told = {name: value for name, value in first.told.items() if not first.is_joint(name)}
    joints = first.told.keys() - told.keys()
    other = way.run(2, length) if joints else first
    for name in joints & other.told.keys():
        one, two = first.told[name], other.told[name]
        if one == two and first.stays:
            told[name] = one
        by = one - first.samples.of(name)
        if one != two and abs(two - other.samples.of(name) - by) < SAME and abs(by) > SAME:
            told[name] = Shift(by)
    return told


def _chain(way, first, length):
    """(Links, posed) from a run and others like it; None without a chain, False with several."""
    told = _told(way, first, length)
    kept = first.factors.products or first.robots or first.listed() or first.loose_links()
    if not (kept or way.linked(first)):
        return None
    seeds = range(1 if told else 2, RUNS + 2)
    runs = [] if told else [first]
    for seed in seeds:
        runs.append(way.run(seed, length, told))
        if len(runs) == 2 and not shown_in(way, runs):
            return None  # what two runs do not show, more of them do not
    found = different(shown_in(way, runs))
    if len(found) > 1:
        return False
    return (found[0], dict(runs[0].posed)) if found else None
