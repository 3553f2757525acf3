"""What the catalogue says of programs, why and what next: a pattern, and whether it holds."""

from .facts import (
    arrows_are_columns,
    left_hands_count_backwards,
    one_keeps_its_row,
    only_standard_ends_with_a_link,
    product_from_one,
    right_factor_in_new_frame,
    same_rows_another_arm,
    turns_look_alike,
)
from .programs import Program


def fact(holds):
    return lambda e, answer, variant: callable(answer) and holds()


def chains(*families):
    return lambda e, answer, variant: e.family in (families or ("forward_kinematics",))


def of_links(e, answer, variant):
    """A program for a link or a chain, and a wrong one."""
    if len(getattr(e, "names", ())) not in (2, 4):
        return e.id == "05.1"
    program = Program(answer, e.family == "forward_kinematics")
    return not program.gives(program.right)


def only_row(k):
    """The program gives the matrix of the first row alone, or of the last."""
    return lambda e, answer, variant: Program(answer, True).of_links(lambda links: [links[k]])


def twice(e, answer, variant):
    """The first link, or the last, is multiplied in once more."""
    program = Program(answer, True)
    return program.of_links(lambda links: [links[0], *links]) or program.of_links(
        lambda links: [*links, links[-1]]
    )


CATALOGUED = [
    (r"In Craig's convention row i holds a and alpha of the link before; .+",
     fact(same_rows_another_arm)),
    (r"In the standard convention the last row ends with its own link, .+|In Craig's there is"
     r" none\.", fact(only_standard_ends_with_a_link)),
    (r"(The move that is made first stands on the left, .+|The second shift is written in the first"
     r" frame's axes|It must be turned by R_01 before it is added: .+|Each new frame is written in"
     r" the frame before it, so its matrix goes on the right: .+)\.?",
     fact(right_factor_in_new_frame)),
    (r"A product starts from 1, and for matrices that is np\.eye\(4\); .+", fact(product_from_one)),
    (r"Angles were counted as a left hand counts them\.|Here they grow as the fingers of the right"
     r" hand curl, thumb along z\.|Check one matrix alone: rot_z\(90°\) must carry x to y\."
     r"|The sign of an angle is the other one, or a formula for row vectors .+",
     fact(left_hands_count_backwards)),
    (r"x, y and z must form a right hand: z = x × y\.|Here the origin is the last column and the"
     r" last row is 0 0 0 1\.|Some programs store matrices by column\.|Transpose it, or build it"
     r" row by row\.|T_ab and T_ba are both poses between the same two frames\.|The subscripts say"
     r" which one is asked\.", fact(arrows_are_columns)),
    (r"They belong to the axis that stays\.", fact(one_keeps_its_row)),
    (r"(The three elementary rotations look alike|In that about y the sine with the minus stands"
     r" below)\.", fact(turns_look_alike)),
    (r"One of the two columns was converted, the other not\.|Tables print alpha as 90; programs"
     r" want 1\.5708\.|A slip of the pen, or cos\(90°\) remembered as 1\.|The closed form has eight"
     r" long entries, and a sign or a letter is quickly lost\.|Tx\(a\) was multiplied in before"
     r" Rz\(θ\), or the closed form was copied without .+", of_links),
    (r"Each turn of the loop throws the product away: write T = T @ A in"
     r" it, and T = np\.eye\(4\) before it\.", only_row(-1)),
    (r"It belongs behind it\.", only_row(0)),
    (r"The product was started from A_1 and the loop began with A_1 again, or .+", twice),
    (r"In the loop, swap the two sides of @\.|The offset is added to q: .+|Use q\[i\] alone in row"
     r" i\.|q_i is measured against the link before, not against the base\.|range\(n - 1\), or a"
     r" loop that returns inside itself\.|θ_i = q_i \+ offset_i, and q has been left out\.|The θ"
     r" column was left in degrees while q is in radians\.", chains()),
]  # fmt: skip
