"""One run of a program with numbers for what is not known."""

from operator import itemgetter

import numpy as np

from ..held.budget import FAILURES, Budget, Raised, Unsupported
from ..held.factors import Factors, is_known_pose
from ..held.operators import whole
from ..held.scopes import Scope
from ..held.tables import Watched
from ..held.values import (
    Class,
    Function,
    Instance,
    Method,
    Native,
    Samples,
    Unknown,
    is_number,
    items_of,
    number_of,
    plain,
)  # fmt: skip
from ..library.methods import attribute, from_library
from ..library.toolbox import Link, links_in
from .binding import bind
from .expressions import YIELDED, evaluate
from .naming import JOINT, NO_JOINT, has_zero, numbered
from .products import OwnProducts
from .statements import body

__all__ = ["Run"]

DEEPEST_CALL = 24
MOST_AT_ONCE = 12_000


class Run:
    """The state of one run: names, what is multiplied, what is left of the budget."""

    def __init__(self, budget: Budget, samples: Samples, posing=False, dialect=None):
        self.budget, self.samples, self.posing = budget, samples, posing
        self.dialect = dialect
        self.factors, self.scope, self.watched = Factors(), Scope(), Watched()
        self.robots, self.posed, self.told = [], {}, {}
        self.lists: list = []
        self.outermost: list = []
        self.instances: list = []
        self.tickets = self.calls = self.failed = 0
        self.skipped, self.stays, self.own_products = False, False, OwnProducts()
        self.called: set = set()
        self.linked: dict | None = None
        self.me = Instance(None, path="self")
        self.scope.names["self"] = self.me

    def program(self, statements):
        """Carry out the statements of a program, each with its share of the budget."""
        for node in statements:
            mark = self.marked()
            try:
                with self.budget.at_most(MOST_AT_ONCE):
                    body(self, [node], self.scope)
            except (Raised, Unsupported):
                self.back_to(mark)
        self.watched.settle()

    def ticket(self):
        """A number that no other thing has, the same in every run."""
        self.tickets += 1
        return self.tickets

    def unknown(self, what):
        """Something new that is not known."""
        return Unknown(f"?{what}{self.ticket()}", self.samples)

    def marked(self):
        """How much was multiplied until now."""
        return len(self.factors.products), len(self.robots)

    def back_to(self, mark):
        """Forget what was multiplied since."""
        del self.factors.products[mark[0] :]
        del self.robots[mark[1] :]

    def keep_list(self, value):
        """Keep a list of matrices, the links' perhaps."""
        least = 3 if isinstance(value, tuple) else 2  # a pair is two results
        if (
            isinstance(value, list | tuple)
            and len(value) >= least
            and all(map(is_known_pose, value))
        ):
            self.lists.append(value)

    def listed(self):
        """The factors of matrices that are listed, or numbered, in their order; none where some
        are multiplied with something unknown.
        """
        if self.factors.broken:
            return []
        rows: dict = {}
        for k, scope in enumerate([self.scope, *self.outermost]):
            for name, value in scope.names.items():
                self.keep_list(value)
                stem, number = numbered(name)
                if number and is_known_pose(value):
                    rows.setdefault((k, stem), []).append((number, value))
        found = [[value for _, value in sorted(one, key=itemgetter(0))] for one in rows.values()]
        lists = [*self.lists, *(one for one in found if len(one) > 1)]
        return [tuple(part for one in row for part in self.factors.of(one)) for row in lists]

    def loose_links(self):
        """The links of a toolbox that have names and make no robot, in their order, as one list."""
        held = [] if self.robots else list(self.scope.names.values())
        found = [one for value in held for one in links_in(value)]
        return [tuple(found)] if len(found) > 1 else []

    def is_joint(self, name):
        """Whether a name is one of joints' values."""
        return bool(JOINT.match(name)) and not NO_JOINT.search(name)

    def over(self, value):
        """What a loop goes over."""
        found = self.dialect.listed(value) if self.dialect else None
        return items_of(value) if found is None else found

    def held(self, name, value):
        """What a name holds: where names never share a value, a copy of it."""
        if self.dialect and isinstance(value, np.ndarray | dict):
            return value.copy()
        return value

    def attribute(self, value, name):
        """What stands behind a dot."""
        found = self.dialect.attribute(self, value, name) if self.dialect else None
        return attribute(self, value, name) if found is None else found

    def imported(self, module, name):
        """What a program imports, as far as it is in the list; None of others."""
        return from_library(name, module)

    def above(self, scope):
        """What ``super()`` is: the object, as its class's base sees it."""
        while scope is not None and scope.owner is None:
            scope = scope.outer
        bases = scope.owner.bases if scope is not None else ()
        known = next((base for base in bases if isinstance(base, Class)), None)
        if known is None:
            robot = next((base for base in bases if isinstance(base, Native)), None)
            return Instance(Class("above", (), {"__init__": robot or Native("", _nothing)}, []))
        view = Instance(known, scope.me.attributes if scope.me else {})
        return view

    def call(self, function, args, kwargs):
        """The value of a call."""
        self.budget.step()
        if isinstance(function, Method):
            if isinstance(function.function, Native):
                return self.call(function.function, args, kwargs)
            return self.call(function.function, [function.owner, *args], kwargs)
        if self.dialect and self.dialect.is_index(function, args):
            return self.dialect.picked(function, args)
        if isinstance(function, Unknown):
            if any(isinstance(one, str) and has_zero(one) for one in args):
                raise Unsupported("somebody else's reading of an expression in quotes")
            if sum(map(is_known_pose, args)) > 1:  # somebody else's product
                self.factors.spoil(*args)
            return Unknown(f"{function.path}()", self.samples) if not args else self.unknown("call")
        if isinstance(function, Native):
            return self._native(function, args, kwargs)
        if isinstance(function, Class):
            return self._made(function, args, kwargs)
        if isinstance(function, Function):
            return self._called(function, args, kwargs)
        if isinstance(function, Instance):
            return self.call(attribute(self, function, "__call__"), args, kwargs)
        raise Unsupported("no function")

    def _native(self, function, args, kwargs):
        try:
            return self.budget.checked(function.call(self, args, kwargs))
        except (Unsupported, RecursionError, MemoryError):
            raise
        except FAILURES:
            raise Unsupported(function.name) from None

    def _made(self, cls, args, kwargs):
        made = Instance(cls, path=cls.name)
        self.instances.append(made)
        start = cls.find("__init__")
        if isinstance(start, Function):
            self.call(start, [made, *args], kwargs)
            return made
        for base in cls.bases:
            if isinstance(base, Native):
                return self.call(base, args, kwargs)
        fields = [
            name for one in (*reversed(cls.bases), cls) for name in getattr(one, "fields", ())
        ]
        given = dict(zip(fields, args)) | kwargs
        if (args or kwargs) and not fields:
            raise Unsupported("no such object")
        for name in fields:
            value = given.get(name, cls.find(name))
            made.attributes[name] = self.unknown("field") if value is None else value
        after = cls.find("__post_init__")
        if isinstance(after, Function):
            self.call(after, [made], {})
        return made

    def _called(self, function, args, kwargs):
        if self.calls >= DEEPEST_CALL:
            raise Unsupported("too deep")
        self.budget.step(10)
        node = function.node
        known = self.own_products.again(self, node, args)
        if known is not None:
            return known[0]
        self.called.add(id(node))
        scope = Scope(outer=function.scope, owner=function.owner)
        if function.owner is not None and args and function.kind != "staticmethod":
            scope.me = args[0] if isinstance(args[0], Instance) else None
        bind(self, function, scope, args, kwargs)
        if not self.calls:
            self.outermost.append(scope)
        self.calls += 1
        try:
            with self.budget:
                if isinstance(node.body, list):
                    ended = body(self, node.body, scope)
                    result = ended[1] if ended and ended[0] == "return" else None
                    result = scope.names.get(YIELDED, result)
                else:
                    result = evaluate(self, node.body, scope)
        finally:
            self.calls -= 1
        self.own_products.look_at(self, node, args, result)
        return result

    def store(self, held, key, value):
        """Let an item of a list, an array or a dictionary be a value."""
        if self.dialect and not isinstance(held, Unknown):
            key = self.dialect.key(held, key)
        if isinstance(held, Unknown):
            self._store_in_unknown(held, key, value)
            return
        if isinstance(held, dict) and isinstance(key, str | int | float | tuple):
            held[key] = value
        elif isinstance(held, np.ndarray):
            held[whole(key)] = _filling(value, held[whole(key)])
        elif isinstance(held, list) and isinstance(key, tuple) and len(key) > 1:  # C#: m[i, j]
            self.store(held[whole(key[0])], key[1] if len(key) == 2 else key[1:], value)
        elif isinstance(held, list) and self.dialect and key == len(held):
            held.append(value)
        elif isinstance(held, list):
            held[whole(key)] = value
        else:
            raise Unsupported("no items")
        self.budget.checked(held)

    def _store_in_unknown(self, held, key, value):
        if isinstance(key, str):
            held.put(f"[{key!r}]", value)
            return
        at = self.dialect.from_one(key) if self.dialect else key
        at = whole(at)
        if not isinstance(at, int):
            raise Unsupported("a part of something that is not known")
        held.put(f"[{at + held.samples.many() if at < 0 else at}]", value)

    def set_attribute(self, held, name, value):
        """Let an attribute be a value."""
        if self.dialect and self.dialect.set_attribute(held, name, value):
            return
        if isinstance(held, Instance | Class):
            held.attributes[name] = value
        elif isinstance(held, Unknown):
            if is_number(value):
                held.put(f".{name}", value)
        elif isinstance(held, Link):
            held.put(name, value)
        else:
            raise Unsupported("no attribute")


def _filling(value, place):
    """What fills a place of an array: numbers, or as many of an unknown list as it has."""
    if isinstance(value, Unknown):
        return plain(value.items(len(place))) if np.ndim(place) == 1 else number_of(value)
    found = plain(value)
    return found.reshape(np.shape(place)) if found.size == np.size(place) else found


def _nothing(run, args, kwargs):
    return None
