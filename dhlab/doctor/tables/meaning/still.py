"""Which rows of a pasted table have no joint: those of a base, a flange or a fixed frame; and what
a row of numbers only may be among rows of variables.
"""

import re

from .columns import IMPLIED
from .joints import MOVES, by_number, named_alone

__all__ = ["on_one_axis", "unwritten"]

FEWEST = 4  # rows, of which one may be no joint

BASE = re.compile(r"(?:0 *)?\(?(?:base|world|ground)\b.*|world *(?:->|-|to|/) *\w+")
# 6->T, 3-E, or T alone below rows that are counted
FLANGE = re.compile(
    r"flange|tool|\btcp\b|\bee\b|\bend\b|^end|\bfin(?:al)?\b|(?:^|->|→|-|\bto |/) *[teghnf]$"
    r"|工具|末端|法兰|플랜지|말단|툴|\bflens|\bbrida\b|\bbride\b|\bflangia|ko[łl]nierz|narz[ęe]dzi|fl[aâ]n[sș]"
    r"|ツール|werkzeug|herramienta|\boutil|strumento|ferramenta|инструмент|фланец"
)
NONE = re.compile(
    r"\b(?:fixed|static|no joint|not a joint|fest(?:er?)?|kein gelenk|fij[oa]|fixe|fiss[oa]|fixo)\b"
    r"|固定|неподвиж"
)
GRASPS = re.compile(
    r"hand\b|grip|claw|finger|pinza|greifer|garra|夹爪|手爪|схват"
)  # a tool, or the joint of one
OF_JOINTS = re.compile(r"joint|axis|gelenk|achse|articula|junta|motor|servo|^[jq] *_?\d")
TURNS = re.compile(
    r"\b(?:roll|pitch|yaw|rotat|twist|spin|swivel|turn|dreh|rotaci|giro)|回转|旋转|俯仰|回転|회전"
)  # a motor
COUNTED = re.compile(r"\d|^$")
PARTS = re.compile(r"shoulder|elbow|waist|torso|upper|fore|lower")  # the base turns in such tables


def unwritten(table, columns, right):
    """What the rows may be of which nothing says whether they have a joint, the likeliest first.

    Parameters
    ----------
    table : Pasted
    columns : dict of str to list of Cell
    right : Arm or None
        The arm that it should be.

    Returns
    -------
    list of tuple of (int, str)
        Each tuple holds row numbers from 0 with "" (no joint), "R" or "P".
    """
    n = len(table.rows)
    kinds = table.kinds or ("",) * n
    labels = [str(label).lower() for label in table.labels or ("",) * n]
    moves = [
        (kinds[i] or by_number(columns, i)) in ("R", "P")
        or not (columns["theta"][i].is_constant or _is_flange_without_theta(columns, labels, i))
        or columns["d"][i].variable in MOVES["d"]
        for i in range(n)
    ]
    fixed = [
        i for i in range(n) if kinds[i] == "fixed" or (NONE.search(labels[i]) and not moves[i])
    ]
    if fixed or n < 2:
        return [_fixed(fixed)]
    if 0 < 2 * sum(moves) < n:  # where most are numbers, theta is 0 and not without a joint
        found = _by_labels(table, columns, labels, right)
        found += [one for one in _among_moving(table, columns, moves) if one not in found]
    elif any(moves):
        found = _among_moving(table, columns, moves)
    else:
        found = [*_sliding(table, columns), *_by_labels(table, columns, labels, right)]
    return _counted(found, table, moves)


def _is_flange_without_theta(columns, labels, i):
    """Whether a row of a table without a column theta is called the flange."""
    flange = FLANGE.search(labels[i]) and not OF_JOINTS.search(labels[i])
    return columns["theta"][i] == IMPLIED and bool(flange)


def on_one_axis(table, columns, convention, found, either=False):
    """What is found, and before it the rows at the ends that would turn about the axis of the joint
    beside them, as no arm has it: they are a base or a flange. Where the rows may be for ``either``
    convention, those of the other one look so, too: standard rows, whose last has neither a nor
    alpha, and Craig's, whose first has not. That is no sign of a row without a joint.
    """
    n = len(table.rows)
    guessed = table.why == "as their names say" and not table.form and "P" not in table.kinds
    typed = any(table.kinds) and not guessed
    if (
        n < FEWEST
        or n in table.worded
        or table.each
        or typed
        or "sigma" in columns
        or () not in found
    ):
        return found
    flat = [not any(_said(columns[role][i]) for role in ("a", "alpha")) for i in range(n)]
    numbers = [columns["theta"][i].is_constant and columns["d"][i].is_constant for i in range(n)]
    first = 0 if convention == "standard" else 1  # the row whose a and alpha part joints 1 and 2
    last = n - 2 if convention == "standard" else n - 1
    ends = [0] if flat[first] and numbers[0] and numbers[1] else []
    ends += [n - 1] if flat[last] and numbers[-1] and numbers[-2] else []
    if either and flat[0] != flat[-1]:
        ends = [i for i in ends if i != (0 if convention == "standard" else n - 1)]
    labels = [str(label).lower() for label in table.labels or ("",) * n]
    ends = [i for i in ends if not OF_JOINTS.search(labels[i])]
    more = [_fixed(ends), *(_fixed([i]) for i in ends)] if ends else []
    return [*dict.fromkeys(one for one in more if one not in found), *found]


def _said(cell):
    return cell.value or cell.letters


def _fixed(rows):
    return tuple((i, "") for i in rows)


def _among_moving(table, columns, moves):
    """Rows of numbers among rows of variables: at the ends base and flange, within a fixed frame or
    a joint whose variable is not written.
    """
    still = [i for i, moving in enumerate(moves) if not moving]
    inner = [
        i for i in still if (any(moves[:i]) and any(moves[i + 1 :])) or named_alone(columns, i)
    ]
    sliding = [
        i for i in (still if table.slides else inner)
        if not columns["theta"][i].value and (table.slides or columns["d"][i].value)
    ]  # fmt: skip
    slid = "P" in table.kinds or any(
        moving and cell.is_constant for moving, cell in zip(moves, columns["theta"])
    )
    sliding = sliding if len(sliding) == 1 and not slid else []
    found = [_fixed(still)]
    if inner:
        found.append(_fixed(i for i in still if i not in inner))
    for i in sliding:
        found.insert(0 if table.slides else 1, (*_fixed(k for k in still if k != i), (i, "P")))
    return found


def _sliding(table, columns):
    """Each row of numbers that may be the sliding joint of such an arm: it has no length a."""
    if table.slides != "arm" or "P" in table.kinds:
        return []
    angles = [(columns["theta"][i].value, columns["a"][i].value) for i in range(len(table.rows))]
    return [((i, "P"),) for i, held in enumerate(angles) if not any(held)]


def _are_counted(labels):
    """Whether the labels number the rows from 1 to the last one: link 5 -> 6, link 6 -> end."""
    numbers = [re.search(r"\d+", label) for label in labels]
    return [one and int(one[0]) for one in numbers] == [*range(1, len(labels) + 1)]


def _turns_elsewhere(table, columns):
    """Whether the last row turns about another axis than the joint before it, as no flange does."""
    i = {"standard": -2, "craig": -1}.get(table.convention)
    return i is not None and any(_said(columns[role][i]) for role in ("a", "alpha"))


def _by_labels(table, columns, labels, right):
    """Rows of numbers only: by what stands before or behind them."""
    n = len(labels)
    last, first = _fixed([n - 1]), _fixed([0])
    counted = all(COUNTED.search(label) or OF_JOINTS.search(label) for label in labels[1:-1])
    if BASE.fullmatch(labels[0]) and not any(PARTS.search(label) for label in labels):
        return [first] if counted else [(), first]
    turns = OF_JOINTS.search(labels[-1]) and TURNS.search(labels[-1])  # J6 tool roll
    if FLANGE.search(labels[-1]) and not FLANGE.search(labels[0]) and not turns:
        if _are_counted(labels):
            return [()] if _turns_elsewhere(table, columns) else [(), last]
        return [(), last] if OF_JOINTS.search(labels[-1]) else [last] if counted else [last, ()]
    if GRASPS.search(labels[-1]):
        joints = [bool(OF_JOINTS.search(label)) for label in labels]
        return [(), last] if joints[-1] else [last] if all(joints[:-1]) else [last, ()]
    if right is not None and n == len(right) + 1:
        return [first, last]
    return [(), first] if labels[0] == "0" and table.form == "" else [()]


def _counted(found, table, moves):
    """What is found, and what else makes as many joints as the text says that there are."""
    n = len(moves)
    counts = [n - sum(not letter for _, letter in one) for one in found]
    if not table.joints or set(counts) & set(table.joints):
        return found
    ends = [i for i in (n - 1, 0) if not moves[i]]
    more = [()] if n in table.joints and not all(moves) else []
    more += [_fixed([i]) for i in ends if n - 1 in table.joints]
    if n - 2 in table.joints and len(ends) == 2:
        more.append(_fixed(sorted(ends)))
    return [*(one for one in more if one not in found), *found]
