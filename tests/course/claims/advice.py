"""What is asserted by the reason and the next step of a verdict, and whether it holds.

A question and a request assert nothing, but take something for granted: a drawing, a loop, a unit.
``GRANTED`` says of such words where they are in place. Any other sentence, and every reason, needs
an entry in ``ASSERTED``: a predicate of the exercise and its answer, or a fact that is computed.
"""

import re

import numpy as np

from dhlab.course.kinds.frames.placed import Frames

from .catalogued import CATALOGUED
from .facts import (
    arrows_are_columns,
    last_column_of_standard,
    last_row_carries,
    lies,
    new_z_after_tipping,
    no_quadrant,
    order_counts,
    reaches,
    right_factor_in_new_frame,
    star_is_by_entries,
    straight_line_of_a_bend,
    sum_of_d_counts,
    turn_back_from_goal,
    whole_numbers_cut,
    x_hangs_on_four,
    z_hangs_on_five,
    z_of_craig,
)
from .tasks import OF_FRAMES, TASKS

CHAINS = ("forward_kinematics", "jacobian", "inverse_kinematics", "branches")
ASKS = re.compile(
    "(Add|Ask|Begin|Call|Change|Compare|Compute|Convert|Copy|Count|Derive|Divide|Draw|Give|Go|"
    "Hand|Keep|Look|Make|Move|Multiply|One|Pick|Point|Print|Put|Read|Round|Run|Say|Set|Sight|Solve|"
    "Start|Take|Thumb|Try|Turn|Use|Write|For each length) ?.*"
)
HINT = re.compile(r'hint\("[0-9.]+"\) gives a first hint\.')


def of(*keys):
    """In these exercises alone, of whose task it speaks."""
    return lambda e, answer, variant: e.id in keys


def convention(e):
    """The convention of the arm or the program that is asked for; "" where there is none."""
    if hasattr(e, "right_arm"):
        return e.right_arm(0).table.convention
    family = getattr(e, "family", "")
    return {"craig_transform": "craig"}.get(family, "standard" if family else "")


def standard(e, answer, variant):
    return convention(e) == "standard"


def craig(e, answer, variant):
    return convention(e) == "craig"


def program(e, answer, variant):
    return callable(answer)


def table(e, answer, variant):
    return hasattr(e, "right_arm")


def frames(e, answer, variant):
    return isinstance(e, Frames)


def of_chain(e, answer, variant):
    return getattr(e, "family", "") in CHAINS


def fact(holds):
    """What is always so: computed, by products of turns and shifts."""
    return lambda e, answer, variant: holds()


def degrees(e, variant):
    """The right table's rows, degrees and metres."""
    return e.right_arm(variant).table.rows * [180 / np.pi, 1, 1, 180 / np.pi]


def not_so(case):
    """The first pair that is told lies otherwise than ``case``, which the answer says of it."""

    def holds(e, answer, variant):
        first = next(k for k, given in enumerate(answer, 1) if given != lies(k))
        return answer[first - 1] == case

    return holds


def dot_and_cross():
    """One number of two vectors, and three."""
    u, v = np.array([1.0, 2, 3]), np.array([0.3, -1, 2])
    return np.ndim(np.dot(u, v)) == np.ndim(u @ v) == 0 and np.shape(np.cross(u, v)) == (3,)


def inverse_shrinks():
    """Ten times as large a J makes the damped step smaller, and times J Jᵀ a step larger."""
    rng = np.random.default_rng(1)
    J, e, k = rng.normal(size=(6, 6)), rng.normal(size=6), 0.1
    of = {s: (s * J, s * s * J @ J.T + k**2 * np.eye(6)) for s in (1, 10)}
    by_inverse, by_product = (
        [np.linalg.norm(J.T @ step(A)) for J, A in of.values()]
        for step in (lambda A: np.linalg.solve(A, e), lambda A: A @ e)
    )
    solved = np.allclose(np.linalg.solve(of[1][1], e), np.linalg.inv(of[1][1]) @ e)
    return solved and by_inverse[1] < by_inverse[0] and by_product[1] > by_product[0]


def list_of_four(e, answer, variant):
    return np.shape(answer(*e.cases(variant)[0])) == (4, *e.shape)


def throws_away(e, answer, variant):
    """Of a chain with another first row the same comes out."""
    rows, q = next(case for case in e.cases(variant) if len(case[1]) > 1)
    others = np.vstack([np.add(rows[0], 0.1), rows[1:]])
    return np.allclose(answer(rows, q), answer(others, q))


def differs_by(flips, slid):
    """The impostor's three rows are the right ones, but for whole turns, these x axes turned over
    and, where the second origin slid along its axis, a length that one d gives to the next.
    """

    def holds(e, answer, variant):
        if e.id != "07.4":
            return False
        table = e.right_arm(variant).table
        rows = np.column_stack([np.degrees(table.theta), table.d, table.a, np.degrees(table.alpha)])
        for i in flips:
            rows[i - 1] *= [1, 1, -1, -1]
            rows[[i - 1, i], 0] += 180
        off = np.array(answer, dtype=float) - rows
        off[:, [0, 3]] = (off[:, [0, 3]] + 180) % 360 - 180
        off[1:, 1] -= off[1, 1] * np.array([1, -1]) * slid
        return np.allclose(off, 0, atol=1e-6)

    return holds


ASSERTED = [
    (r"np\.dot and @ of two vectors give one number, np\.cross gives three\.",
     fact(dot_and_cross)),
    (r"A list of 4 comes back, and one is asked: .+", list_of_four),
    (r"The parts have different lengths, or one entry is an array and not a number: .+", program),
    (r"Each turn of the loop throws the product away: .+", throws_away),
    *((pattern, of(*keys)) for pattern, keys in TASKS),
    *CATALOGUED,
    (r"x_i turned round changes a_i, (alpha|α)_i, (theta|θ)_i and (theta|θ)_\{i\+1\}.*",
     fact(x_hangs_on_four)),
    (r"With one of them forgotten it is another arm\.", fact(x_hangs_on_four)),
    (r"z_i turned round changes (alpha|α)_i, (alpha|α)_\{i\+1\}.*", lambda *case: (
        standard(*case) and z_hangs_on_five())),
    (r"z_i turned round changes α_\{i-1\} and α_i, which stand in rows i and i \+ 1.*",
     lambda *case: craig(*case) and z_of_craig()),
    (r"α is measured about x_i from z_\{i-1\} to z_i, counter-clockwise seen against x_i\.",
     standard),
    (r"Row i of Craig's table holds α_\{i-1\}: about x_\{i-1\}, from z_\{i-1\} to z_i\.", craig),
    (r"In Craig's matrix it is α_\{i-1\}: .+", craig),
    (r"θ_i is measured about z_i, from x_\{i-1\} to x_i\.", craig),
    (r"(Moves are made in the current frame: )?[aA] turn changes the direction of every later shift"
     r" across its axis(, so the order counts)?\.", fact(order_counts)),
    (r"A step along x that is made first does not swing with θ\.", fact(order_counts)),
    (r"After Rx\((α|alpha)\) the z axis is a new one(, and d goes along it)?\.",
     fact(new_z_after_tipping)),
    (r"The row 0 0 0 1 carries the shift .+", fact(last_row_carries)),
    (r"The three must stay at right angles, and z = x × y\.", fact(arrows_are_columns)),
    (r"(An arrow that is turned keeps its length|A frame's axes have length 1 .+|The arrows of a"
     r" frame stand at right angles.+|x, y and z must form a right hand)\.?",
     fact(arrows_are_columns)),
    (r"The columns of the block are the new frame's axes\.", fact(arrows_are_columns)),
    (r"Written as rows they say where the old axes are in the new frame\.",
     fact(arrows_are_columns)),
    (r"The rows say where the base's arrows are, seen from the plate\.", of("01.1")),
    (r"The right-hand pose is written in the frame that the left-hand one leads to\.",
     fact(right_factor_in_new_frame)),
    (r"(The second shift is written in frame b's arrows|p_ab is written in frame a already: R_ab"
     r" turns p_bc alone|p_12 is written in plate 1's arrows|p_01 is written in the base's arrows"
     r" already, and needs no turn|The tool's shift is written in the flange's arrows|The flange's"
     r" place is written in the base already, and needs no turn|One way follows the other, and"
     r" neither is walked back)\.",
     fact(right_factor_in_new_frame)),
    (r"\(x, y, z\) is written in the base\.", of("01.2")),
    (r"(y / x forgets both signs|np\.arccos forgets the sign)\.", fact(no_quadrant)),
    (r"atan2\(y, x\) keeps them, in this order\.", fact(no_quadrant)),
    (r"sqrt\(1 - sin²\), acos and asin know no quadrant: .+", fact(no_quadrant)),
    (r"np\.arctan2\(y, x\) keeps the signs of both; a quotient y / x forgets them\.",
     fact(no_quadrant)),
    (r"For numpy arrays \* multiplies entries; @ is the matrix product\.",
     fact(star_is_by_entries)),
    (r"@ (takes each row of|multiplies entry by entry and adds up).+", fact(star_is_by_entries)),
    (r"np\.array\(\[\[1, 0\], …\]\) of ints has an integer type.+", fact(whole_numbers_cut)),
    (r"An array of whole numbers cuts off what is written into it.+", fact(whole_numbers_cut)),
    (r"(R_goalᵀ R is the turn from the goal to here|Rᵀ R_goal is the turn as the tool sees it).+",
     fact(turn_back_from_goal)),
    (r"Where a link has an elbow of some millimetres, a is the straight line .+",
     fact(straight_line_of_a_bend)),
    (r"numpy.+ take(s)? (angles in )?radians\.", fact(lambda: np.isclose(np.sin(np.pi / 2), 1))),
    (r"(np\.deg2rad was applied to numbers that are radians already|This course's functions take"
     r" radians)\.", lambda e, answer, variant: program(e, answer, variant)),
    (r"Write np\.deg2rad around every angle that is given in degrees\.", of("05.9")),
    (r"Half angles belong to quaternions, whole ones to matrices; .+", program),
    (r"The name stands in the def line, and in no cosine and no sine\.", program),
    (r"1\.57 for π/2, or np\.round inside the function: the error grows along the chain\.",
     lambda *case: table(*case) or program(*case)),
    (r"A pose has its origin in the last column and 0 0 0 1 below\.", program),
    (r"α goes from z0 to z1, counted about x1 as the fingers of the right hand curl\.",
     of("02.3", "02.4")),
    (r"d and a are coordinates.+", lambda e, answer, variant: (
        program(e, answer, variant)
        or (degrees(e, variant)[:, 1:3] < 0).any()
        or (np.asarray(answer)[:, 1:3] < 0).any())),
    (r"Between parallel axes the common normal may stand anywhere\.", table),
    (r"Only the sum of the d along them counts, .+", fact(sum_of_d_counts)),
    (r"np\.rad2deg makes degrees of radians\.", fact(lambda: np.isclose(np.rad2deg(np.pi), 180))),
    (r"np\.deg2rad makes radians of degrees\.", fact(lambda: np.isclose(np.deg2rad(180), np.pi))),
    (r"These lengths were divided by 1000 once too often\.",
     lambda *case: large(*case, 1e-3)),
    (r"(d goes along z, a along x|θ turns about z, α about x|Then ask along which axis the length"
     r" runs|The turn about z does)\.", lambda *case: table(*case) or program(*case)),
    (r"That line is z\.", lambda *case: table(*case) or frames(*case) or of("04.1")(*case)),
    (r"Walk over rows and q together with zip\(rows, q\)\.", of_chain),
    *((said, frames) for said in OF_FRAMES),
    (r"The position is right\.", lambda e, answer, variant: reaches(answer, e.given(variant)["T"])),
    (r"Tables print millimetres; here lengths are metres, unless a unit is named\.",
     lambda *case: table(*case) or program(*case)),
    (r"An index off by one, or half of a conversion from Craig's convention\.",
     lambda *case: table(*case) or of_chain(*case)),
    (r"(Every tool has its own order: MATLAB a α d θ, this course θ d a α|The order of the columns"
     r" differs between books: θ, d, a, α here)\.", lambda *case: table(*case) or program(*case)),
    (r"(z is easily drawn along the link or the motor's body|It belongs on the line the joint turns"
     r" about)\.", lambda *case: table(*case) or frames(*case)),
    (r"(The height of joint 1 can stand in d1 or in the base transform|It belongs in one of"
     r" them)\.",
     table),
    (r"θ and d belong to the joint( and stay; a and α belong to a link and move together|, a and α"
     r" together to the link behind it)\.", of("03.7", "03.8", "03.9", "09.7")),
    (r"The arm's zero is not the table's zero: θ_i = q_i \+ offset\.",
     lambda *case: table(*case) or of_chain(*case)),
    (r"The offset stands in the table and was added to q as well, or two different zeros.+",
     lambda *case: table(*case) or of_chain(*case)),
    (r"Row i belongs to joint i; counting from 0 puts the offset one row too low\.", table),
    (r"θ_i = q_i \+ offset_i: ask where θ stands when the encoder reads 0\.",
     lambda *case: table(*case) or of_chain(*case)),
    (r"a is the distance between the two axes\.", table),
    (r"Where they meet it is 0, and the way to the next origin is a d\.", table),
    (r"The number was misread or measured wrongly, is missing, or belongs to another arm of the"
     r" family\.", table),
    (r"(A digit was misread, or the angle was measured to another axis|A digit was misread,"
     r" or the arm"
     r" was set to zero in another pose than the table's)\.", table),
    (r"(Row 1 takes q\[0\], row 2 q\[1\], and so on|The index was shifted, turned round or left"
     r" fixed|A fixed index in place of i, or functions made in a loop that all see the loop's last"
     r" row|range\(1, n\) skips row 0; or the running product is begun anew at each link, and what"
     r" was there is lost)\.", of_chain),
    (r"“.+” would look like this: .+\.|Does symptom \d say that\?", of("07.1")),
    *(
        (
            ("All that differs is free in a table: " if flips or slid else "All that differs is ")
            + "".join(f"(?{'=' if i in flips else '!'}.*x{i} flipped)" for i in (1, 2))
            + f"(?{'=' if slid else '!'}.*o2 slid)"
            + ("[ox].+" if flips or slid else r"whole turns, which change nothing\."),
            differs_by(flips, slid),
        )
        for flips in ((), (1,), (2,), (1, 2))
        for slid in (False, True)
    ),
    (r"(In the standard convention joint i turns about the z axis of the frame before|v = ω ×"
     r" r, and r"
     r" runs from the axis to what moves|The end swings about the joint's own axis, so the lever"
     r" begins there, at o|It holds v, which has not been made yet|The cross product needs z, o and"
     r" p)\.", of("08.10")),
    (r"(Joint speeds go into J; the hand's velocity comes out|It slides: its value is in metres)\.",
     of("08.9")),
    (r"(Every step begins where the last one ended|Near a singularity the plain inverse asks for"
     r" enormous joint steps|Everything else needs the frames of this q|The step must go from here"
     r" to the goal)\.", of("08.5", "08.6")),
    (r"The name arm, from the first cell, is the article's arm, whatever rows are\.",
     of("08.6")),
    (r"(Where J is large a small step is enough; times J Jᵀ it becomes a large one|"
     r"np\.linalg\.solve\(A, e\) is the inverse of A, times e)\.", fact(inverse_shrinks)),
    (r"In a call or a formula one name stands where another is meant\.", program),
    (r"T_ab and T_ba are both poses between the same two frames\.|The subscripts say which one is"
     r" asked\.", fact(arrows_are_columns)),
    (r"Of standard rows the last column is a cos θ, a sin θ, d\.", fact(last_column_of_standard)),
    (r"p and p_goal are written in the base, and so is their difference\.", of("08.4", "08.6")),
    (r"\(J Jᵀ \+ λ² 1\)⁻¹ e is no step of the joints yet: .+|dq is J\.T @ what you have\.",
     of("08.6")),
    (r"Parallel axes have the same direction or the opposite one: these two have not\.",
     not_so("parallel")),
    (r"Skew axes differ in direction: these two do not\.", not_so("skew")),
    (r"Axes on one line have all points in common: these two have not\.", not_so("line")),
    (r"Axes that meet have a point in common: these two have none\.", not_so("meet")),
    (r"The points given are somewhere on the axes, and lines go on beyond them\.", of("04.11")),
    (r"Link i runs from the axis of joint i to that of joint i\+1, the last one to where no joint"
     r" is\.", of("03.1")),
]  # fmt: skip

GRANTED = [  # words that take something for granted, and where it is there
    (r"(?<!such as a )\bdrawing\b|data sheet|the part itself", table),
    (r"the maker", of("02.7", "03.1", "09.2", "09.3")),
    (r"\bdoctor\b|dh\.diagnose", of("07.8", "09.1", "09.3")),
    (r"\bsheet\b", lambda *case: of("09.2", "09.3", "09.4")(*case) or table(*case)),
    (r"\bpicture\b", of("02.1", "05.3", "06.1")),
    (r"\bsketch\b|\btube\b", of("02.8")),
    (r"leftovers", of("02.6")),
    (r"dh\.equivalent", of("03.6")),
    (r"irb120", of("06.10")),
    (r"of the pen:", of("08.11")),
    (r"in the loop|zip\(rows|each link really|of n rows", of_chain),
    (r"out of the function|the other three 0", program),
    (r"Sight along x_i|Thumb along x:|from x_\{i-1\} to x_i do you see", standard),
    (r"Thumb along x_\{i-1\}", craig),
    (r"does the link go|which way does the link go", table),
    (r"above the table", lambda *case: table(*case) or of_chain(*case)),
    (r"millimetres by 1000", lambda e, answer, variant: large(e, answer, variant, 1000)),
    (r"centimetres by 100", lambda e, answer, variant: large(e, answer, variant, 100)),
]


def large(e, answer, variant, factor):
    """Some number of the answer is so many times one of the right ones; of programs, not asked, and
    of arms that are placed, whose own numbers the answer does not hold.
    """
    if callable(answer) or hasattr(answer, "forward"):
        return True
    right = degrees(e, variant) if table(e, answer, variant) else e.answer(**e.given(variant))
    given, right = np.ravel(answer).astype(float), np.ravel(np.asarray(right, dtype=float))
    right = right[np.abs(right) > 1e-9]  # which may stand in another's place as well
    return bool(np.isclose(given[:, None], factor * right, rtol=0.02, atol=1e-9).any())


def unfounded(exercise, verdict, answer, variant):
    """The sentences of a verdict's reason and next step that no predicate knows, or that are not
    true of the answer, or take for granted what is not there.
    """
    case = exercise, answer, variant
    for text, reason in ((verdict.why, True), (verdict.next, False)):
        for said in filter(None, re.split(r"(?<=[.?])\s+", text)):
            asserted = [holds for pattern, holds in ASSERTED if re.fullmatch(pattern, said)]
            asks = said.endswith("?") or ASKS.fullmatch(said) or HINT.fullmatch(said)
            granted = [holds for words, holds in GRANTED if re.search(words, said)]
            if not (asserted or (asks and not reason)):
                yield f"no predicate: {said}"
            elif not all(holds(*case) for holds in [*asserted, *granted]):
                yield f"not in place: {said}"
