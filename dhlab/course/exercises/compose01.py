"""What lesson 01 says of a program that composes two poses."""

from ..kinds import Said

__all__ = ["COMPOSED"]

WHOLE = "One matrix product of the two whole 4×4 matrices makes both."

MEET = "The inner subscripts must meet: a·b, b·c."

COMPOSED = {
    "elementwise-product": Said(
        "the two poses are multiplied entry by entry, with * in place of @",
        next="@ takes each row of the left one against each column of the right one.",
    ),
    "rotation-transposed": Said(
        "the place is right, and the rotation is the transpose of the right one",
        next="Rows and columns of the 3×3 block have changed places.",
    ),
    "product-reversed": Said(
        "the two poses are multiplied in the reverse order",
        why="The right-hand pose is written in the frame that the left-hand one leads to.",
        next=MEET,
    ),
    "translations-not-rotated": Said(
        "the shifts were added up, and the second was not turned",
        why="The second shift is written in frame b's arrows.",
        next="One matrix product of the whole 4×4 matrices turns and shifts.",
    ),
    "pose-inverted": Said(
        "a pose was inverted, and none needs to be",
        next="Say them aloud: b written in a, c written in b. Asked is c written in a.",
    ),
    "matrix-transposed": Said(
        "T_ab was transposed, the whole 4×4",
        why="A pose has its origin in the last column and 0 0 0 1 below.",
        next="Multiply the two as they are.",
    ),
    ("product-reversed", "the two rotations; the position is right"): Said(
        "the place is right, and the turns are multiplied in the reverse order", next=WHOLE
    ),
    ("product-reversed", "the position; the rotation is right"): Said(
        "the turn is right, and the place is that of the reverse order", next=WHOLE
    ),
    ("product-reversed", "the second shift is added before it is turned"): Said(
        "the turn is right, and in the place p_ab is turned as well",
        why="p_ab is written in frame a already: R_ab turns p_bc alone.",
        next=WHOLE,
    ),
    ("product-starts-late", "in the position: p_ab is left out"): Said(
        "the turn is right, and p_ab is left out of the place", next=WHOLE
    ),
    ("product-stops-early", "in the position: p_bc is left out"): Said(
        "the turn is right, and p_bc is left out of the place", next=WHOLE
    ),
    ("length-sign", "the turned p_bc is taken off, not added"): Said(
        "the turn is right, and in the place R_ab p_bc is taken off, not added", next=WHOLE
    ),
    ("rotation-transposed", "R_ab, where it turns p_bc"): Said(
        "the turn is right, and in the place p_bc is turned by the transpose of R_ab", next=WHOLE
    ),
    ("translations-not-rotated", "and the rotations are reversed"): Said(
        "the shifts were added without a turn, and the turns multiplied in the reverse order",
        next=WHOLE,
    ),
    ("translations-not-rotated", "whole matrices added"): Said(
        "the two matrices were added, not multiplied", next=MEET
    ),
    ("pose-inverted", "the first pose"): Said(
        "T_ab was inverted, and no inverse is needed", next=MEET
    ),
    ("pose-inverted", "the second pose"): Said(
        "T_bc was inverted, and no inverse is needed", next=MEET
    ),
    ("pose-inverted", ""): Said("this is T_ca, the inverse of what is asked", next=MEET),
    ("matrix-transposed", ""): Said(
        "this is the transpose of the right 4×4",
        why="A pose has its origin in the last column and 0 0 0 1 below.",
        next="Multiply the two as they are.",
    ),
    "product-stops-early": Said("this is T_ab alone, T_bc was not used", next=MEET),
    "product-starts-late": Said("this is T_bc alone, T_ab was not used", next=MEET),
}
