"""One array per parameter: ``a = [0, 0.4]; alpha = …``, ARTE's ``robot.DH.a``, urcontrol.conf."""

import re

from ..cells import cell_of
from ..language.roles import ROLES, role_of
from ..pasted import Pasted
from .called.functions import own_calls
from .flat import arrays_in

__all__ = ["read"]

OF_AN_END = re.compile(r"tool|grip|tcp|base|flange|camera", re.IGNORECASE)
ADDED = re.compile(r"\b(?:theta|th|q)\w*[\[(]\w+[\])]\s*([-+])\s*THIS\[")  # q[i] + zeros[i]
MOVED_ON = re.compile(r"\s*(\w+[\[(]\w+[\])])\s*=\s*\1")


def read(source, nominal=None):
    """The Pasted table of arrays named after the parameters; None when d, a and alpha are not
    there.
    """
    twice: set = set()
    notes: list = []
    by_role = _by_role(source, twice, notes)
    if "alpha" not in by_role and {"d", "a"} <= set(by_role):
        name, by_role["alpha"] = _twists(source, len(by_role["a"]))
        notes.append(f"{name} is taken for alpha: it holds the angles")
    if not all(by_role.get(role) for role in ("d", "a", "alpha")):
        return None
    again = [name for name in sorted(twice) if role_of(name)[0] in ("d", "a", "alpha", "r")]
    if again:
        raise ValueError(
            f"recognise_table: expected one arm, found two: {', '.join(again)} given twice with"
            " other numbers; paste one of them"
        )
    n = len(by_role["alpha"])
    if len(by_role.get("theta", ())) != n and len(by_role["d"]) == len(by_role["a"]) == n:
        by_role.pop("theta", None)  # where the joints stand, or some of them
    roles = [role for role in (*ROLES, "offset") if role in by_role]
    if any(len(by_role[role]) != n for role in roles):
        lengths = ", ".join(f"{len(by_role[role])} of {role}" for role in ("d", "a", "alpha"))
        raise ValueError(
            f"recognise_table: expected as many numbers of each parameter, found {lengths}; fill in"
            " what is missing"
        )
    columns = [[cell_of(value, text) for value, text in by_role[role]] for role in roles]
    if "theta" not in roles and "offset" not in roles:
        roles.insert(0, "theta")
        columns.insert(0, [cell_of(source.value("0"))] * n)
    signs = tuple(-1 if value.number < 0 else 1 for value, _ in by_role.get("sign", ()))
    return Pasted(
        tuple(zip(*columns)),
        tuple(roles),
        "as the names of the arrays say",
        labels=("",) * n,
        kinds=_kinds(source, n, by_role.get("sigma", ())),
        signs=signs if len(signs) == n else (1,) * n,
        notes=tuple(notes),
        **_known_form(source),
    )


def _by_role(source, twice, notes):
    """{role: numbers} of the arrays by their names; by the comments beside them where the names
    would make a length of an angle.
    """
    found: dict = {}
    named: dict = {}
    unread: dict = {}
    arrays = _unnumbered(arrays_in(source, twice, unread))
    said = {**_twists_named_a(arrays), **_taken_by_calls(source, arrays)}
    said.update(_said_beside(source, arrays))
    for name, values in arrays.items():
        if re.search(r"delta_", name):
            continue
        role = source.role(re.sub(r"([a-z])([A-Z])", r"\1_\2", name))
        role = "r" if re.fullmatch(r"links?|l", name.lower()) else role
        role = "offset" if re.fullmatch(r"t(?:h|heta)?_?0_?", name.lower()) else role
        role = "sign" if re.search(r"joint_direction|sign", name.lower()) else role
        if role == "offset" and OF_AN_END.search(name):
            continue  # where an end is, no zero
        added = _added(name, source) if role is None else ""
        if added:
            role = "offset"
            notes.append(f"{name} is added to theta")
        if added == "-":
            values = [(value.times(-1.0), f"-({text})") for value, text in values]
        role = said.get(name, None if "home" in name.lower() else role)
        stand = role == "theta" and _moves(values) and not _moves(found.get(role, ()))
        if role in ("d", "a", "alpha"):
            named.setdefault(role, {})[name] = values
        if role and (role not in found or stand or _fills(values, found[role], role)):
            found[role] = values  # q = [0, 0] is where the joints stand
    _require_zeros(unread, found)
    _require_one(named)
    missing = [role for role in ("a", "d") if role not in found]
    if len(missing) == 1 and "r" in found:
        found[missing[0]] = found.pop("r")
    return found


def _fills(values, letters, role):
    """Whether lengths or twists are numbers for letters of another list, equal to it elsewhere."""
    same = (b.letters or abs(a.number - b.number) < 1e-9 for (a, _), (b, _) in zip(values, letters))
    whole = role in ("d", "a", "alpha") and len(values) == len(letters) and not _moves(values)
    return whole and _moves(letters) and all(same)


def _require_one(named):
    """Two lists of different numbers for two of the parameters are two arms."""
    several = [
        list(lists)
        for lists in named.values()
        if len({tuple(round(v.number, 6) for v, _ in values) for values in lists.values()}) > 1
        and len({len(values) for values in lists.values()}) == 1
    ]
    if len(several) > 1:
        names = " and ".join(several[0][:2])
        raise ValueError(
            f"recognise_table: expected one arm, found {names} with different numbers; which one is"
            " meant? Paste the arrays of one arm"
        )


def _added(name, source):
    """How a program adds an array to the joint angles, "+" or "-"; "" where it does not, or only
    moves the joints on, as in ``q[i] = q[i] + step[i]``.
    """
    code = re.sub(rf"\b{re.escape(name)}[\[(]", "THIS[", source.code)
    lines = (line for line in code.split("\n") if not MOVED_ON.match(line))
    return next((found[1] for line in lines if (found := ADDED.search(line))), "")


def _require_zeros(unread, found):
    """Zeros that are given and cannot be read must not be taken for none."""
    for name, cell in unread.items():
        zeros = role_of(name)[0] == "offset" and not OF_AN_END.search(name)
        if zeros and "offset" not in found:
            raise ValueError(
                f"recognise_table: {name}: expected numbers, found {cell[:40]!r}; write the number,"
                " or what its letters are"
            )


def _moves(values):
    return any(value.letters for value, _ in values)


def _taken_by_calls(source, arrays):
    """{name: role} of the lengths and twists by the place in which the text's own link function
    takes them, ``link(d[i], alpha[i], r[i], q[i])``, whatever they are called.
    """
    said = {}
    for call, roles in own_calls(source):
        for item, role in zip(call.items, roles):
            taken = re.fullmatch(r"([A-Za-z_][\w.]*)[\[(]\s*\w+\s*[\])]", item.text)
            name = taken[1].split(".")[-1] if taken else ""
            name = next((one for one in (name, name.lower()) if one in arrays), "")
            if name and role in ("d", "a", "alpha"):
                said[name] = role
    return said


def _twists_named_a(arrays):
    """{name: role} where lists d and r of lengths stand beside a list a of angles."""
    d, r, a = (arrays.get(name, ()) for name in "dra")
    angles = any(value.unit in ("rad", "deg") for value, _ in a) and len(a) == len(d) == len(r)
    return {"a": "alpha", "r": "a"} if angles and not {"alpha", "alphas"} & set(arrays) else {}


def _said_beside(source, arrays):
    """{name: role} as the comments behind the arrays say, where an array named after a length holds
    multiples of pi.
    """
    odd = [name for name in arrays if source.role(name) in ("a", "d")]
    if not any(value.unit == "rad" for name in odd for value, _ in arrays[name]):
        return {}
    lines, said = source.text.split("\n"), {}
    for number, comment in source.comments:
        target = re.match(r"\s*(\w+)\s*=", lines[number - 1]) if number <= len(lines) else None
        role = role_of(" ".join(comment.split()[:2]))[0]
        if target and target[1] in arrays and role in ("alpha", "a", "d"):
            said[target[1]] = role
    return said


def _twists(source, n):
    """(name, numbers) of the one array, of those whose name says nothing, that holds multiples of
    pi; ("", None) where none or several do.
    """
    angles = {
        name: values
        for name, values in arrays_in(source).items()
        if len(values) == n and source.role(name) is None
        if any(value.unit in ("rad", "deg") for value, _ in values)
        if not any(value.letters for value, _ in values)
    }
    return next(iter(angles.items())) if len(angles) == 1 else ("", None)


def _unnumbered(arrays):
    """The arrays by their names, without an ending of d, a and alpha: ``d_test``, ``ds``."""
    if {"ds", "as"} <= set(arrays):
        return {re.sub(r"(?<=^[adrq])s$", "", name): values for name, values in arrays.items()}
    for ending in dict.fromkeys(name.partition("_")[2] for name in arrays):
        own = {f"{one}_{ending}" for one in ("d", "a", "alpha")}
        if ending and own <= set(arrays):
            return {
                name.removesuffix(f"_{ending}"): values
                for name, values in arrays.items()
                if name.endswith(f"_{ending}")
            }
    return arrays


def _kinds(source, n, sigma):
    """ARTE's robot.kind, or sigma, which is 1 of a joint that slides."""
    found = re.search(r"kind\s*=\s*\[([^\]]*)\]", source.code)
    letters = re.findall(r"[RP]", found[1]) if found else []
    letters = letters or ["P" if value.number == 1 else "R" for value, _ in sigma]
    return tuple(letters) if len(letters) == n else ("",) * n


def _known_form(source):
    if re.search(r"robot\.DH\.\w+|\bARTE\b", source.text):
        return {"form": "ARTE", "convention": "standard", "because": "as ARTE has it"}
    if re.search(
        r"\bdelta_(?:theta|d|a|alpha)\b|^\s*\[DH\](?=[^\[]*=\s*\[)|\bdh_theta\s*[:=]\s*\[[^,\]]*\]|joint_checksum",
        source.pasted,
        re.MULTILINE,
    ):
        return {
            "form": "a Universal Robots controller's file",
            "convention": "standard",
            "because": "as Universal Robots has it",
            "length": "m",
        }
    return {}
