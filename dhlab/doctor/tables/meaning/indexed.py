"""What headings that all carry the index i say of the convention, together with the numbers."""

from dataclasses import replace

__all__ = ["with_index"]


def with_index(table):
    """The table, standard where its last row has neither a nor alpha, or where it is planar; as it
    is elsewhere.
    """
    if _ends_as_standard(table):
        because = "the last row has neither a nor alpha"
    elif _is_planar(table):
        because = "each row of the planar arm has a length"
    else:
        return table
    because = f"since all headings carry the index i, and {because}"
    return replace(table, convention="standard", because=because)


def _ends_as_standard(table):
    if table.roles is None or not {"a", "alpha"} <= set(table.roles):
        return False
    at = [table.roles.index("a"), table.roles.index("alpha")]
    first, last = ([table.rows[k][j] for j in at] for k in (0, -1))
    return any(c.value or c.letters for c in first) and not any(c.value or c.letters for c in last)


def _is_planar(table):
    """Whether all axes are parallel and each row has a length a: the last one leads from the last
    joint to the tip, as in standard rows, and the first one is no step before the first joint.
    """
    if table.roles is None or not {"a", "alpha", "theta"} <= set(table.roles):
        return False
    column = {role: [row[k] for row in table.rows] for k, role in enumerate(table.roles)}
    parallel = all(c.is_constant and not c.value for c in column["alpha"])
    turning = not any(c.is_constant for c in column["theta"])
    return parallel and turning and all(c.value or c.letters for c in column["a"])
