"""Links made one by one, by classes of toolboxes: RevoluteDH(…), Link([…]), Revolute('d', …),
DHLink(…), RevoluteMDHLink(…), Frame::DH(…).
"""

import re
from collections import Counter
from dataclasses import replace

from ...cells import cell_of
from ...evidence.several import apart, in_parts
from ...language.brackets import Item, cells_in, groups, left_open
from ...language.roles import kind_said, role_of
from ...meaning.columns import misplaced
from ...pasted import Pasted, Row, from_rows
from .arguments import by_order, cell_in, limits_in, pairs_in
from .functions import definitions
from .own import member_of, own_classes
from .used import made_here, of_the_robot

__all__ = ["read"]

ROBOTICS_TOOLBOX = "links of the Robotics Toolbox"
# (name, form, convention, order of numbers without names)
CLASSES = (
    (r"(revolute|prismatic)mdhlink", "pybotics", "craig", "alpha a theta d"),
    (r"revolutemdh", ROBOTICS_TOOLBOX, "craig", "d a alpha offset"),
    (r"prismaticmdh", ROBOTICS_TOOLBOX, "craig", "theta a alpha offset"),
    (r"revolutedh", ROBOTICS_TOOLBOX, "standard", "d a alpha offset"),
    (r"prismaticdh", ROBOTICS_TOOLBOX, "standard", "theta a alpha offset"),
    (r"revolute|prismatic", ROBOTICS_TOOLBOX, "standard", ""),
    (r"dhlink|dhrobotlink", "DHLink", "", "d a alpha theta"),
    (r"link", ROBOTICS_TOOLBOX, "", "theta d a alpha sigma offset"),
)
OLD_LINK = "alpha a theta d sigma offset"
NAMED = ("theta", "d", "a", "alpha", "r", "offset")
# DH(i,:), DH(i,2), dh[i][2]: one call makes all links
OF_A_ROW = re.compile(r"\b[A-Za-z]\w*(?:\([a-z]\w*\s*,\s*[:\d]\)|\[[a-z]\w*\]\[\d\])")
# Link(d=link.d, a=link.a)
OF_LINKS = re.compile(r"\bd\s*=\s*(\w+)\.d\b.*\balpha\s*=\s*\1\.alpha\b", re.DOTALL)
TOOLBOX = re.compile(
    r"rtb|robotic|toolbox|seriallink|dhrobot|corke|revolute(?:m?dh)\b|prismatic(?:m?dh)\b",
    re.IGNORECASE,
)
LOOPED = re.compile(r"\b([A-Za-z_]\w*)\[([ijk])\]")
LATER = re.compile(r"\b([A-Za-z_]\w*)\s*(?:([({[])(\d+)[)}\]])?\.(\w+)\s*=(?!=)\s*([^;\n=]+)")


def read(source, nominal=None):
    """The Pasted table of calls of link classes; None when there are none."""
    made, forms, notes = [], [], []
    named: dict = {}
    own = {
        _name(group): definitions(source).get(_name(group))
        for group in groups(source.code)
        if group.mark == "(" and _defines(group)
    }
    three = own_classes(source.text)
    for group in _unrolled(groups(source.code), source):
        name = member_of(_name(group), three)
        known = next((one for one in CLASSES if re.fullmatch(one[0], name.lower())), None)
        known = known or ((name, "", "", "") if name in three else None)
        if known is None or group.mark != "(" or _is_inner(group) or OF_A_ROW.search(group.text):
            continue
        if OF_LINKS.search(group.text):
            continue  # links made of links, one by one
        if known[1] == "DHLink" and not own.get(name) and source.order:
            known = (*known[:3], " ".join(source.order[0]))
        if not own.get(name) and made_here(name, source.code):
            # it keeps its theta, which the toolbox's does not
            known = (known[0], "", "", " ".join(three.get(name, ())))
        if own.get(name):  # a class of the text's own: its order is the one that it defines
            known = (known[0], "", "", " ".join(str(role) for role in own[name]))
            if _defines(group):
                continue
        row, said = _row(group, name, known, source, notes, len(made) + 1)
        if row is None:
            continue
        made.append((group, row, said or known[2]))
        named[group.target] = row
        forms.append(known[1])
    if made:
        _refuse_half_a_link(source)
    made = _of_one_arm(made, notes, source.code)
    rows, conventions = [row for _, row, _ in made], {said for _, _, said in made}
    if not rows or (len(rows) == 1 and (not rows[0].cells or _is_of_a_loop(rows[0]))):
        return None
    _changed_later(named, rows, source, conventions)
    conventions.discard("")
    if len(conventions) > 1:
        raise ValueError(
            "recognise_table: expected links of one convention, found standard and modified ones;"
            " paste one arm"
        )
    said = conventions.pop() if conventions else _default(source, forms)
    if forms[0] == "DHLink" and (columns := _contradicted(rows)):
        return Pasted(
            columns, form="DHLink", convention=said or None, labels=("",) * len(rows),
            kinds=tuple(row.kind for row in rows), signs=(1,) * len(rows),
            notes=("the numbers contradict the order of that class in other programs",),
        )  # fmt: skip
    return from_rows(
        rows,
        lines=(made[0][0].line, made[-1][0].line + made[-1][0].text.count("\n")),
        why=source.order[2] if forms[0] == "DHLink" and source.order else "as their names say",
        form=forms[0],
        convention=said or None,
        because=f"as {forms[0]} {'has' if forms[0] == 'pybotics' else 'have'} it" if said else "",
        notes=tuple(dict.fromkeys(notes)),
    )


def _refuse_half_a_link(source):
    """A text that was cut off inside a link would lose it without a word."""
    for group in left_open(source.code):
        if group.mark == "(" and any(re.fullmatch(c[0], _name(group).lower()) for c in CLASSES):
            raise ValueError(
                f"recognise_table: line {group.line}: expected a whole link, found {_name(group)}("
                " without its closing bracket; what else stands in it? Paste it to its end"
            )


def _of_one_arm(made, notes, code):
    """The links without one that is made again under its name, as programs do it.

    Raises
    ------
    ValueError
        Two arms are made.
    """
    listed = [group.outer for group, *_ in made if group.outer and group.outer.mark in "[{"]
    lists = Counter(map(id, listed))
    places = [f"{group.target}{group.index}" for group, *_ in made]
    places = [
        place if re.search(r"\d", place) else f"{place} {k}" for k, place in enumerate(places)
    ]
    parts = apart([(group.line, row) for group, row, _ in made], code)
    in_parts(parts, lambda row: sorted((k, cell.value) for k, cell in row.cells.items()), "links")
    again = [place for place, times in Counter(places).items() if times > 1]
    if len(again) > 1 or sum(times > 1 for times in lists.values()) > 1:
        what = " and ".join(again[:2]) + " made twice" if again[1:] else "two lists of links"
        raise ValueError(
            f"recognise_table: expected one arm, found {what}; which one is meant? Paste the links"
            " of one arm"
        )
    if again:
        notes.append(f"{again[0]} is made twice, and the last counts")
    made = [one for k, one in enumerate(made) if places[k] not in places[k + 1 :]]
    used, note = of_the_robot([f"{group.target}{group.index}" for group, *_ in made], code)
    notes += [note] if note else []
    return [made[k] for k in used]


def _unrolled(found, source):
    """The groups; a call in a loop, ``Link(d=d[i])``, once for each number of its lists."""
    for group in found:
        counted = set(LOOPED.findall(group.text))
        known = any(re.fullmatch(one[0], _name(group).lower()) for one in CLASSES)
        lists = [name for name, _ in counted if role_of(name)[0] in NAMED]
        lengths = {sum(key.startswith(f"{name}[") for key in source.known) for name in lists}
        if not (known and group.mark == "(" and len(lengths) == 1 and any(lengths)):
            yield group
            continue
        for k in range(*lengths):
            texts = [LOOPED.sub(lambda m, k=k: f"{m[1]}[{k}]", item.text) for item in group.items]
            yield replace(group, items=[Item(text, line=group.line) for text in texts])


def _is_of_a_loop(row):
    """Whether one call makes all links, of each row's numbers: ``Link(d=row[0], a=row[1])``."""
    letters = [letter for cell in row.cells.values() for letter, _ in cell.letters]
    return len(letters) > 2 and len({letter.partition("[")[0] for letter in letters}) == 1


def _contradicted(rows):
    """The rows as they stand, four numbers each, where the order of their class would make lengths
    of multiples of pi; () where it does not.
    """
    order = CLASSES[-2][3].split()
    if any(list(row.cells)[:4] != order for row in rows):
        return ()
    odd = misplaced({role: [row.cells[role] for row in rows] for role in order})
    return tuple(tuple(row.cells[role] for role in order) for row in rows) if odd else ()


def _defines(group):
    """Whether these are the names of a definition: ``DHLink(double a, double alpha, …)``."""
    texts = [item.text.split(":")[0].strip() for item in group.items]
    plain = [text for text in texts if re.fullmatch(r"[\w\s*&<>.]+", text)]
    return sum(role_of(re.split(r"\s+|[*&]", text)[-1])[0] in NAMED for text in plain) >= 4


def _name(group):
    return re.split(r"\.|::", group.name)[-1]


def _changed_later(named, rows, source, conventions):
    """``L(2).offset = -pi/2`` and its like, after the links were made."""
    for name, mark, index, field, text in LATER.findall(source.code):
        row = named.get(name)
        if index:
            at = int(index) - (mark != "[")  # MATLAB counts from 1
            row = rows[at] if 0 <= at < len(rows) else None
        role, value = role_of(field)[0], source.value(text.strip())
        if row is None:
            continue
        if role in NAMED and value is not None and (role != "theta" or row.kind == "P"):
            row.cells["a" if role == "r" else role] = cell_of(value, text.strip())
        elif field.lower() == "flip" and text.strip().lower() in ("1", "true"):
            row.sign = -1
        elif field.lower() in ("mdh", "modified") and text.strip().lower() in ("1", "true"):
            conventions.add("craig")


def _default(source, forms):
    """Links of the toolbox that say nothing are standard ones, unless the text says otherwise."""
    if re.search(r"modified|\bmdh\b|craig", source.text, re.IGNORECASE):
        return ""
    named = re.search(r"\bLink\(\s*(?:\w+\s*=|-?[\d.]+\s*,)", source.code)  # anybody's class
    if named and not TOOLBOX.search(source.text):
        return ""
    return "standard" if forms[0] == ROBOTICS_TOOLBOX else ""


def _is_inner(group):
    """A call within another link's brackets, as in KDL's Segment(Joint(…), …)."""
    return group.outer is not None and group.outer.name.split("::")[-1].lower() in ("segment",)


def _row(group, name, known, source, notes, number):
    cells, said, limits, sign, kind, label = {}, "", None, 1, "", ""
    order = OLD_LINK if name == "link" and known[0] == "link" else known[3]
    items = [item.text for item in group.items]
    pairs, loose = pairs_in(items)
    for key, text in pairs:
        role = role_of(key)[0]
        if key.lower() in ("qlim", "bounds", "limits"):
            limits = limits_in(text, source)
        elif key.lower() == "flip":
            sign = -1 if text.lower() in ("true", "1") else 1
        elif key.lower() in ("mdh", "modified"):
            said = "craig" if text.lower() in ("true", "1") else ""
        elif key.lower() in ("name", "label"):
            label = text.strip("'\"")
        elif one := kind_said(key, text):
            kind = one
        elif key.lower() in ("sigma", "jointtype", "type", "joint_type"):
            kind = "P" if text.strip("'\"").lower()[:1] in ("p", "1") else "R"
        elif role in NAMED and not (role == "r" and text[:1] in "[("):  # a centre of mass
            cells[role] = cell_in(text, source, number, role)
    for text, word in ((text, text.strip("'\"").lower()) for text in loose):
        if word == "prismatic":
            kind = "P"
        elif word == "flip":
            sign = -1
        elif word in ("modified", "mdh", "standard", "dh", "stdh"):
            said = "craig" if word in ("modified", "mdh") else "standard"
        elif text[:1] in "'\"":
            label = label or text.strip("'\"")
        elif text[:1] in "[{":
            numbers = {**source.assigned, **source.known}  # no variables: the toolbox has its own
            known_here = replace(source, known=numbers) if known[1] == ROBOTICS_TOOLBOX else source
            cells.update(by_order(_vector(text), order, known_here, number))
    numbers = [text for text in loose if text[:1] not in "[{'\"" and source.value(text) is not None]
    elsewhere = known[0] == "link" and (known[1] or name.islower())
    if not cells and len(numbers) >= 3 and elsewhere:
        return None, ""  # somebody's own class: the toolbox takes names or one vector
    if not cells and len(numbers) >= 3 and order:
        left = order.replace("apart", "").strip() if len(numbers) == 3 else order
        cells.update(by_order(numbers, left, source, number))
    if not cells and not pairs and (group.items or known[0] == "link"):
        return None, ""
    if sigma := cells.pop("sigma", None):
        kind = "P" if sigma.value else "R"
    of_joints = known[1] not in ("DHLink", "")  # other classes may hold a flange
    kind = kind or ("P" if name.lower().startswith("prismatic") else "R" if of_joints else "")
    _ignore_theta(cells, kind, known, notes, number)
    if "r" in cells:
        cells["a"] = cells.pop("r")
    return Row(cells, kind, label, sign, limits), said


def _vector(text):
    """The numbers of ``[theta1 0 0 -pi/2, 0, 0]``, where MATLAB's spaces and commas stand for one
    another.
    """
    cells = cells_in(text.strip("[]{}"))
    return cells if len(cells) > 3 else [cell for part in cells for cell in cells_in(part)]


def _ignore_theta(cells, kind, known, notes, number):
    """The toolbox takes q + offset for the angle of a turning joint; theta counts for nothing."""
    theta = cells.get("theta")
    if known[1] != ROBOTICS_TOOLBOX or kind == "P" or theta is None or not theta.is_constant:
        return
    if theta.value:
        notes.append(
            f"theta = {theta.text} of link {number} is left out, as the toolbox does: the joint's"
            " value takes its place; a zero offset is written offset"
        )
    del cells["theta"]
