"""Whether a piece of a learner's text only calculates, and may so be called again and again."""

import ast
import builtins

__all__ = ["calls_only_known", "is_risky", "only_calculates"]

# who names these does more than calculate
RISKY = {
    "open", "exec", "eval", "compile", "input", "breakpoint", "__import__", "os", "sys", "shutil",
    "subprocess", "KeyboardInterrupt", "socket", "requests", "urllib", "pathlib", "Path",
    "threading", "check", "serial",
}  # fmt: skip
PLAIN = {
    "numpy", "math", "builtins", "functools", "itertools", "operator", "cmath", "types", "copy",
    "collections", "dataclasses", "enum", "fractions", "decimal", "typing",
}  # fmt: skip


def is_risky(statements):
    """Whether statements name something that does more than calculate."""
    return any(
        isinstance(node, ast.Name) and node.id in RISKY
        for statement in statements
        for node in ast.walk(statement)
    )


def calls_only_known(statement, space, defined):
    """Whether all that a statement calls is the text's own or of a library that calculates.

    Parameters
    ----------
    statement : ast.stmt
    space : dict
        The names that the text finds around it.
    defined : container of str
        The names that the text itself defines.

    Examples
    --------
    >>> import numpy, os
    >>> around = {"np": numpy, "os": os}
    >>> calls_only_known(ast.parse("x = np.cos(turned(1))"), around, {"turned"})
    True
    >>> calls_only_known(ast.parse("x = os.getcwd()"), around, {"turned"})
    False
    """
    return all(
        _is_known(node.func, space, defined)
        for node in ast.walk(statement)
        if isinstance(node, ast.Call)
    )


def only_calculates(function, space, defined):
    """Whether a definition, which may stand beside what is looked at, only calculates."""
    plain = not (function.decorator_list or is_risky([function]))
    return plain and calls_only_known(function, space, defined)


def _is_known(called, space, defined):
    while isinstance(called, (ast.Attribute, ast.Call, ast.Subscript)):
        called = getattr(called, "value", None) or called.func
    if not isinstance(called, ast.Name):
        return True  # a method of a literal
    name = called.id
    value = space.get(name, getattr(builtins, name, None))
    home = getattr(value, "__name__", "") if isinstance(value, type(ast)) else ""
    home = home or getattr(value, "__module__", None) or type(value).__module__
    return name in defined or home.split(".")[0] in PLAIN
