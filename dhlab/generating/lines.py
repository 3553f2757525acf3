"""Formulas as lines of source text, in the arithmetic that C and Python share."""

from __future__ import annotations

from collections import Counter

from .formulas import Formulas
from .operations import Value

__all__ = ["Lines"]

SHORT = 36  # characters; a longer part of a formula gets a line and a name of its own
LABEL = 12  # characters; C99 tells names apart by their first 63 only
SUMS = ("plus", "minus", "shift")


class Lines:
    """``assignments``, pairs of a name and its formula in order; ``rows`` of texts, the results.

    Parameters
    ----------
    formulas : Formulas

    Examples
    --------
    >>> from dhlab import DHTable, Arm
    >>> from dhlab.generating.formulas import forward_formulas
    >>> arm = Arm(DHTable.standard([[0, 0, 0.4, 0], [0, 0, 0.3, 0]], angle="deg"))
    >>> for name, formula in Lines(forward_formulas(arm)).assignments:
    ...     print(name, "=", formula)
    c1 = cos(q[0])
    s1 = sin(q[0])
    q12 = q[0] + q[1]
    c12 = cos(q12)
    s12 = sin(q12)
    """

    def __init__(self, formulas: Formulas):
        self._program = formulas.program
        self._names: dict[int, str] = {}
        self._labels: dict[int, str] = {}
        self.assignments: list[tuple[str, str]] = []
        needed = self._program.needed(formulas.entries)
        uses = Counter(k for node in needed for k in self._program.operands(node))
        uses.update(entry.node for entry in formulas.entries if isinstance(entry, Value))
        for node in needed:
            self._labels[node] = self._label(node)
            if self._program.nodes[node][0] != "q":
                self._assign(node, uses[node])
        self.rows = [[self._text(entry) for entry in row] for row in formulas.rows]

    def _assign(self, node, uses):
        """A name for what is used twice, is long, or is a sine or cosine."""
        text = self._sum(node, False)
        if uses > 1 or len(text) > SHORT or self._program.nodes[node][0] in ("cos", "sin"):
            self._names[node] = self._name(node)
            self.assignments.append((self._names[node], text))

    def _name(self, node):
        """As in a textbook: c23 for cos(q[1] + q[2]) and q23 for the sum; for others t1, t2, …"""
        kind, first, *_ = self._program.nodes[node]
        turns = kind in ("cos", "sin")
        label = self._labels[first if turns else node]
        name = (kind[0] if turns else "q") + label
        taken = self._names.values()
        if label and name not in taken:
            return name
        return f"t{1 + sum(other[0] == 't' for other in taken)}"

    def _label(self, node):
        """ "23" for q[1] + q[2], "2m3" for q[1] - q[2], "2o" for q[1] and a constant offset; ""
        for anything else.
        """
        kind, *rest = self._program.nodes[node]
        if kind == "q":
            return f"{rest[0] + 1}"
        labels = [self._labels[k] for k in self._program.operands(node)]
        if kind not in SUMS or not all(labels):
            return ""
        label = "m".join(labels) if kind == "minus" else "".join(labels)
        label += "o" if kind == "shift" else ""
        return label if len(label) <= LABEL else ""

    def _text(self, entry):
        if isinstance(entry, Value):
            return self._sum(entry.node, entry.negative)
        return repr(float(entry) + 0.0)  # no -0.0

    def _sum(self, node, negative):
        """What is subtracted last, so that few lines begin with a minus."""
        terms = sorted(self._terms(node, negative), key=lambda term: term[0])
        first, *others = [("-" if minus else "", text) for minus, text in terms]
        return "".join([*first, *(f" {sign or '+'} {text}" for sign, text in others)])

    def _terms(self, node, negative):
        """Pairs: whether it is subtracted, and the text."""
        kind, *rest = self._program.nodes[node]
        if node in self._names or kind not in SUMS:
            return [(negative, self._product(node))]
        terms = self._terms(rest[0], negative)
        if kind == "shift":
            return [*terms, ((rest[1] < 0) != negative, repr(abs(rest[1])))]
        return terms + self._terms(rest[1], negative != (kind == "minus"))

    def _product(self, node):
        """A name, a variable, a function or a product."""
        if node in self._names:
            return self._names[node]
        kind, *rest = self._program.nodes[node]
        if kind == "q":
            return f"q[{rest[0]}]"
        if kind in ("cos", "sin"):
            return f"{kind}({self._sum(rest[0], False)})"
        if kind == "scale":
            return f"{rest[1]!r}*{self._factor(rest[0])}"
        return "*".join(self._factor(k) for k in rest)

    def _factor(self, node):
        if node not in self._names and self._program.nodes[node][0] in SUMS:
            return f"({self._sum(node, False)})"
        return self._product(node)
