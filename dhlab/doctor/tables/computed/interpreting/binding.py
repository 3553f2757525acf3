"""Which parameter of a function holds what."""

from ..held.budget import Unsupported
from .expressions import evaluate

__all__ = ["bind"]


def bind(run, function, scope, args, kwargs):
    """Let the parameters of a function hold what it is called with."""
    signature = function.node.args
    names = [one.arg for one in (*signature.posonlyargs, *signature.args)]
    defaults = getattr(function, "defaults", None)
    if defaults is None:
        defaults = [evaluate(run, one, function.scope) for one in signature.defaults]
    last = dict(zip(names[len(names) - len(signature.defaults) :], defaults))
    by_word = defaults[len(signature.defaults) :]
    last |= dict(zip([one.arg for one in signature.kwonlyargs], by_word))
    if len(args) > len(names) and signature.vararg is None:
        raise Unsupported("too many arguments")
    given = dict(zip(names, args))
    unused = {key: value for key, value in kwargs.items() if key not in (*names, *last)}
    if signature.vararg:
        scope.put(signature.vararg.arg, list(args[len(names) :]))
    if signature.kwarg:
        scope.put(signature.kwarg.arg, unused)
    elif unused and not all(one.arg in kwargs for one in signature.kwonlyargs):
        raise Unsupported("no such argument")
    for name in [*names, *(one.arg for one in signature.kwonlyargs)]:
        if name in given:
            scope.put(name, given[name])
        elif name in kwargs:
            scope.put(name, kwargs[name])
        elif name in last:
            scope.put(name, last[name])
        else:
            raise Unsupported("an argument is missing")
