"""Names and what they stand for, in a program and its functions."""

from dataclasses import dataclass, field

__all__ = ["Scope"]

MISSING = object()


@dataclass(eq=False)
class Scope:
    """The names of a function, or of the program; ``outer`` the scope around it."""

    names: dict = field(default_factory=dict)
    outer: object = None
    of_program: object = None
    elsewhere: dict = field(default_factory=dict)  # names declared global or nonlocal
    owner: object = None  # the class whose method runs
    me: object = None  # its object

    def find(self, name):
        """What a name stands for; MISSING where nothing says it."""
        scope = self
        while scope is not None:
            if name in scope.names:
                return scope.names[name]
            scope = scope.outer
        return MISSING

    def put(self, name, value):
        """Let a name stand for something."""
        self.elsewhere.get(name, self).names[name] = value

    def declare(self, name, everywhere):
        """A name that belongs to the program, or to the function around."""
        scope = self
        while scope.outer is not None and (everywhere or scope is self or name not in scope.names):
            scope = scope.outer
        self.elsewhere[name] = scope
