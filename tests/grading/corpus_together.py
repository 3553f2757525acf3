"""Attacks of the corpus that do not touch each other, several in one notebook: each notebook costs
as much as a student does.
"""

from corpus import answer, first

MOST = 12  # that only look, in one notebook
# the first two change numpy for all that is run after them; the last must come after another
APART = {"numpy patched, answer wrong", "builtins patched", "looks for what was left"}


def together(cases):
    """The cases, those that only look in few notebooks, and those that spoil one answer alone in
    as few as there are answers to the same exercise.

    A notebook's name is its cases' names. Of those that only look, the number of one that gets at
    something is what 05.2 is answered with, from 0.
    """
    groups = []
    for case in cases:
        family, part = _family(case)
        for known, parts, group in groups if family else ():
            if known == family and part not in parts and len(group) < MOST:
                parts.add(part)
                group.append(case)
                break
        else:
            groups.append((family, {part}, [case]))
    return [_one(family, group) if len(group) > 1 else group[0] for family, _, group in groups]


def _family(case):
    """(what kind of case may stand beside it, what may stand there once)."""
    name, make, lost = case
    if name in APART:
        return None, name
    if hasattr(make, "looks"):
        return "looks", name
    if hasattr(make, "answers") and lost == {make.answers}:
        return "answers", make.answers
    return None, name


def _one(family, group):
    names = "; ".join(name for name, _, _ in group)
    makes = [make for _, make, _ in group]
    lost = frozenset().union(*(lost for _, _, lost in group))
    return names, _looking(makes) if family == "looks" else _each(makes), lost


def _each(makes):
    return lambda notebook, facts: [make(notebook, facts) for make in makes] and None


def _looking(makes):
    def make(notebook, facts):
        for number, one in reversed(list(enumerate(makes))):
            source = one.looks.replace("FACTS[", "known[")
            first(f"leaked = False\n{source}\nif leaked: got.append({number})")(notebook, facts)
        first("got, known = [], FACTS")(notebook, facts)
        answer("05.2", "rule = str(got[0]) if got else rule")(notebook, facts)

    return make
