"""What is said of programs in place of the catalogue's words, which are about tables and poses."""

from dataclasses import replace

from .exercise import Said

__all__ = ["IN_DEGREES", "OF_LINKS", "OF_OTHERS", "OF_POSES", "OF_PROGRAMS"]

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
