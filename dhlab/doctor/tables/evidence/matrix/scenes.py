"""Elementary moves of nested groups, as a program that draws an arm has them: each group moves or
turns along one axis within the group that it is added to.
"""

import re

__all__ = ["nested_moves"]

MOVED = re.compile(
    r"\b(\w+)(?:\[\w+\])?\.(position|rotation)\.([xz])\s*=(?!=)"
)  # dz.position.z = link.d
ADDED = re.compile(r"\b(\w+)\.add\(\s*(\w+)\s*\)")
KEPT = re.compile(r"\b(\w+)\.push\(\s*(\w+)\s*\)")  # joints.push(turn): joints[i] is the group


def nested_moves(code):
    """The moves of the one chain of four groups, the outer first; [] without one.

    Examples
    --------
    >>> nested_moves("p.add(t); t.add(u); u.add(o); o.add(w); ts.push(t); u.position.z = d;"
    ...     "o.position.x = a; w.rotation.x = alpha; ts[i].rotation.z = q[i]")
    ['Rz', 'Tz', 'Tx', 'Rx']
    """
    kept, moves = dict(KEPT.findall(code)), {}
    for name, what, axis in MOVED.findall(code):
        move = {"position": "T", "rotation": "R"}[what] + axis
        moves.setdefault(kept.get(name, name), set()).add(move)
    pairs = {(outer, inner) for outer, inner in ADDED.findall(code) if {outer, inner} <= {*moves}}
    inside = dict(pairs)
    first = [name for name in inside if name not in inside.values()]
    if len(first) != 1 or len(inside) != len(pairs):
        return []
    chain = [first[0]]
    while chain[-1] in inside and len(chain) < len(moves):
        chain.append(inside[chain[-1]])
    found = [move for name in chain for move in moves[name]]
    return found if len(found) == len(chain) == 4 else []
