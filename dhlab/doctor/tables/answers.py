"""What somebody answers to the questions of a pasted table, checked."""

from .meaning.columns import LENGTHS

__all__ = ["require_answers"]


def require_answers(order, convention, angle, length):
    """Each answer is one that its question has.

    Raises
    ------
    ValueError
        One sentence: which one is not.

    Examples
    --------
    >>> require_answers("theta d a alpha", "craig", None, "mm")
    """
    for name, value, known in (
        ("convention", convention, ("standard", "craig")),
        ("angle", angle, ("deg", "rad")),
        ("length", length, LENGTHS),
    ):
        if value is not None and value not in known:
            raise ValueError(
                f"recognise_table: {name}: expected {' or '.join(known)}, found {value!r}; leave it"
                " out when you do not know"
            )
    if order is not None and (
        not isinstance(order, str) or sorted(order.split()) != ["a", "alpha", "d", "theta"]
    ):
        raise ValueError(
            "recognise_table: order: expected the names theta, d, a, alpha in some order, found"
            f' {order!r}; as in "a alpha d theta"'
        )
