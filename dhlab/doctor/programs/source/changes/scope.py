"""The names around an expression, and what they hold."""

import ast
from dataclasses import dataclass, field, replace

__all__ = ["Scope", "in_loop", "scope_of", "scope_of_text"]


@dataclass(frozen=True)
class Scope:
    """The names that may stand in an expression: ``parameters`` of the function, ``names`` that
    hold something there, ``constants`` of the whole text, ``functions`` of the text with how many
    arguments they take, the ``attributes`` of its objects, by object what else stands ``beside``
    one, what is ``unused``, the names of ``rows``, of what counts in loops and in the loops
    ``around``, the ``words`` that stand in the text; and ``kinds``, what a name was seen to hold.
    """

    parameters: tuple = ()
    names: tuple = ()
    constants: tuple = ()
    functions: dict = field(default_factory=dict)
    attributes: tuple = ()
    beside: dict = field(default_factory=dict)
    unused: tuple = ()
    rows: tuple = ()
    counters: tuple = ()
    around: tuple = ()
    words: tuple = ()
    kinds: dict = field(default_factory=dict)

    def are_alike(self, one, other):
        """Whether two names may hold the same kind of thing: nobody takes a function for a number,
        and numpy does not stand one in a matrix.
        """
        kinds = [self.kinds.get(name) for name in (one, other)]
        return None in kinds or bool(kinds[0] & kinds[1])


def scope_of_text(text, kinds):
    """The Scope of a text outside its functions.

    Parameters
    ----------
    text : Text
    kinds : dict of sets
        By name, as :func:`..held.kinds_of` gives it.
    """
    nodes = list(text.nodes())
    called = {id(node.func) for node in nodes if isinstance(node, ast.Call)}
    attributes = [n for n in nodes if isinstance(n, ast.Attribute) and id(n) not in called]
    fields = [
        statement.target.id
        for node in nodes
        for statement in (node.body if isinstance(node, ast.ClassDef) else ())
        if isinstance(statement, ast.AnnAssign)
    ]
    stored = [node.attr for node in attributes if isinstance(node.ctx, ast.Store)]
    beside = {}
    for node in attributes:
        if text.of(node.value) not in text.space:
            beside.setdefault(text.of(node.value), {})[node.attr] = None
    return Scope(
        functions={name: len(defined.args.args) for name, defined in text.functions.items()},
        constants=tuple(_constants(text)),
        attributes=tuple(dict.fromkeys((*stored, *fields))),
        beside={base: tuple(names) for base, names in beside.items()},
        words=tuple(_words(nodes)),
        kinds=kinds,
    )


def _constants(text):
    """The names of numbers that the text sets outside its functions."""
    for block in text.blocks:
        if isinstance(block, ast.Assign):
            for node in ast.walk(ast.Tuple(block.targets)):
                if isinstance(node, ast.Name) and _is_number(text.space.get(node.id)):
                    yield node.id


def _is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _words(nodes):
    values = [n.value for n in nodes if isinstance(n, ast.Constant) and isinstance(n.value, str)]
    return dict.fromkeys(value for value in values if value.isidentifier())


def scope_of(function, around):
    """The Scope inside a function.

    Parameters
    ----------
    function : ast.FunctionDef or ast.Lambda
    around : Scope
        What it stands in.
    """
    if isinstance(function, ast.Lambda):
        inside = tuple(argument.arg for argument in function.args.args)
        return replace(around, names=tuple(dict.fromkeys((*inside, *around.names))))
    parameters = tuple(argument.arg for argument in function.args.args if argument.arg != "self")
    names = [node for node in ast.walk(function) if isinstance(node, ast.Name)]
    stored = [node.id for node in names if isinstance(node.ctx, ast.Store)]
    inside = [node for statement in function.body for node in ast.walk(statement)]
    used = {n.id for n in inside if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Load)}
    known = tuple(dict.fromkeys((*parameters, *stored)))
    rows = dict.fromkeys(
        node.value.id
        for node in ast.walk(function)
        if isinstance(node, ast.Subscript)
        and isinstance(node.value, ast.Name)
        and isinstance(node.slice, ast.Constant)
    )
    return replace(
        around,
        parameters=parameters,
        names=known,
        unused=tuple(name for name in known if name not in used),
        rows=tuple(rows),
        counters=tuple(_counters(function)),
        around=(),
    )


def in_loop(loop, scope):
    """The Scope inside a loop, or what is made one by one.

    Parameters
    ----------
    loop : ast node
    scope : Scope
        What it stands in.
    """
    parts = [loop, *getattr(loop, "generators", ())]
    return replace(
        scope, around=(*scope.around, *_counters(*parts, inside=isinstance(loop, ast.While)))
    )


def _counters(*nodes, inside=True):
    """The names that range and enumerate count with, and those that are counted up."""
    for node in (part for one in nodes for part in (ast.walk(one) if inside else (one,))):
        if isinstance(node, (ast.For, ast.comprehension)) and isinstance(node.iter, ast.Call):
            called = getattr(node.iter.func, "id", "")
            target = node.target.elts[0] if isinstance(node.target, ast.Tuple) else node.target
            if called in ("range", "enumerate") and isinstance(target, ast.Name):
                yield target.id
        if isinstance(node, ast.AugAssign) and isinstance(node.value, ast.Constant):
            yield from (name.id for name in (node.target,) if isinstance(name, ast.Name))
