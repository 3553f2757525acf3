"""What a program defines, called from outside with arguments that are not known."""

import re

from ..held.budget import FAILURES, Raised
from ..held.values import Class, Function, Instance, Module, Native, Unknown
from ..library.toolbox import keep_robot
from .expressions import evaluate
from .linking import tables_in

__all__ = ["INLINE", "call_all"]

INLINE = "_inline"  # begins the names of functions that have none
AT_ONCE = 12_000  # steps of one function
MOST_CALLED = 30
TABLE = re.compile(r"(?!n_|num|len|max).*(?:table|params|links|rows|dh$)", re.IGNORECASE)
LATER = ("plot", "draw", "show", "anim", "inv", "ik", "jac", "test", "traj", "main", "run")


def call_all(run, named, thorough):
    """Call what the program defines, with unknown arguments; what its functions name, ``named``,
    only where nobody called it yet, unless ``thorough``.
    """
    defined = [value for value in run.scope.names.values() if isinstance(value, Function | Class)]
    made = {id(one.cls) for one in run.instances}
    asked: list = []
    for value in defined:
        if isinstance(value, Function):
            if value.name.startswith(INLINE):  # it stands within an expression
                continue
            asked.append((value, None))
        elif id(value) not in made:
            _guarded(run, lambda cls=value: _instance(run, cls))
    for one in run.instances[:6]:
        methods = [part for part in one.cls.attributes.values() if isinstance(part, Function)]
        asked += [(part, one) for part in methods if part.name[:2] != "__" and not part.kind]
    asked.sort(key=lambda pair: (pair[0].name in named, _is_later(pair[0].name)))
    run.called.clear()
    for function, owner in asked[:MOST_CALLED]:
        if function.name in named and id(function.node) in run.called:
            run.skipped = True
            if not thorough:
                continue
        _guarded(run, lambda f=function, o=owner: _asked(run, f, o))


def _is_later(name):
    return any(word in name.lower() for word in LATER)


def _asked(run, function, owner):
    run.samples.stored.clear()
    found = run.call(function, *_arguments(run, function, owner))
    keep_robot(run, found)
    run.keep_list(found)


def _guarded(run, act):
    mark = run.marked()
    try:
        with run.budget.at_most(AT_ONCE):
            act()
    except (Raised, *FAILURES):
        run.back_to(mark)


def _instance(run, cls):
    start = cls.find("__init__")
    if isinstance(start, Function):
        args, kwargs = _arguments(run, start, Instance(cls))
        run.call(cls, args[1:], kwargs)
    else:
        run.call(cls, [], {})


def _meant(run, name, annotation):
    """What a parameter is meant for, whatever its name: the program's one table, or an object of a
    class that needs nothing; None of others.
    """
    cls = run.scope.names.get(getattr(annotation, "id", ""))
    if isinstance(cls, Class) and cls.fields and not cls.find("__init__"):
        whole = all(cls.find(field) is not None for field in cls.fields)
        return run.call(cls, [], {}) if whole else None
    tables = {id(rows): rows for _, rows in tables_in(run)} if TABLE.match(name) else {}
    return next(iter(tables.values())) if len(tables) == 1 else None


def _arguments(run, function, owner):
    """(positional, by name): what is called as the program's own names is these, the rest is not
    known.
    """
    signature = function.node.args
    names = [one.arg for one in (*signature.posonlyargs, *signature.args)]
    usual = names[len(names) - len(signature.defaults) :]
    annotations = {one.arg: one.annotation for one in signature.args}
    args = []
    for k, name in enumerate(names):
        if k == 0 and (owner is not None or name == "self") and function.kind != "staticmethod":
            args.append(run.me if owner is None else owner)
            continue
        known = run.scope.names.get(name)
        if known is None:
            known = _meant(run, name, annotations.get(name))
        held = known is not None and not isinstance(known, Function | Class | Module | Native)
        if run.is_joint(name):
            args.append(Unknown(name, run.samples))
        elif name in usual:
            args.append(evaluate(run, signature.defaults[usual.index(name)], function.scope))
        else:
            args.append(known if held else Unknown(name, run.samples))
    return args, {}
