"""What is said of programs in place of the catalogue's words, which are about tables and poses, and
of tables in place of those that are about more than a row.
"""

from dataclasses import replace

from ..exercise import Said

__all__ = [
    "IN_DEGREES",
    "OF_CRAIG",
    "OF_TABLES",
    "OF_LINKS",
    "OF_OTHERS",
    "OF_POSES",
    "OF_PROGRAMS",
]

OF_POSES = frozenset(  # mistakes whose titles are about poses and tables
    (
        "base-height-missing-or-twice",
        "joint-index-off-by-one",
        "pose-inverted",
        "product-reversed",
        "rotation-transposed",
        "tool-missing",
        "translations-not-rotated",
        "wrong-frame-compared",
    )
)
OF_OTHERS = {  # by family: mistakes whose titles are about other programs than these
    "jacobian": OF_POSES
    | {"columns-misread", "elementwise-product", "error-sign", "joint-reversed"}
}
IN_DEGREES = Said(
    "the answers are in degrees; radians are asked",
    next="np.deg2rad makes radians of degrees. Convert once, and all angles.",
)
ONE_AT_A_TIME = "Give one argument at a time, the other three 0: which move does it make?"
OF_LINKS = {  # where the catalogue tells of tables that are misread or measured wrongly
    "alpha-value": Said("alpha does not turn as it should", next=ONE_AT_A_TIME),
    "length-sign": Said("a length shifts against its arrow", next=ONE_AT_A_TIME),
    "length-value": Said("a length does not shift as it should", next=ONE_AT_A_TIME),
    "offset-value": Said("theta does not turn as it should", next=ONE_AT_A_TIME),
}
OF_PROGRAMS = {
    **{
        mistake: replace(said, next="Call it with one row in which one number is not 0.")
        for mistake, said in OF_LINKS.items()
    },
    "lengths-made-positive": Said(
        "a negative length is used as a positive one",
        why="d and a are coordinates along an axis: against it they are negative.",
        next="Give a negative length: does the frame go against the arrow?",
    ),
}
OF_TABLES = {  # where the title is about more than a row
    "tool-missing": Said(
        "the length along the last axis is left out, or counted twice",
        next="How far is it along the last axis to the end, and in which row does that stand?",
    ),
    "a-alpha-from-previous-row": Said(
        "a and alpha come from the row before",
        why="An index off by one, or half of a conversion from Craig's convention.",
        next="Take row 1 alone: which link have its a and its α been taken from?",
    ),
}
OF_CRAIG = {  # where the catalogue's reason is that of a standard row
    "alpha-sign": Said(
        "alpha has the wrong sign",
        why="Row i of Craig's table holds α_{i-1}: about x_{i-1}, from z_{i-1} to z_i.",
        next="Thumb along x_{i-1}: do the fingers turn z_{i-1} into z_i?",
    ),
    "z-flip-incomplete": Said(
        "A z axis was turned round, but not everything that hangs on it",
        why="z_i turned round changes α_{i-1} and α_i, which stand in rows i and i + 1, d_i, θ_i"
        " and the way joint i counts.",
        next="Go through the entries of rows i and i + 1 that are about or along this z axis.",
    ),
}
