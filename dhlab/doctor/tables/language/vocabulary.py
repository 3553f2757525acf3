"""Words of the grammar of expressions: constants, units, functions, arrays of joint values."""

import math
import re

__all__ = [
    "CALLED",
    "CONSTANTS",
    "FUNCTIONS",
    "INVERSE",
    "JOINT_VALUES",
    "PLAIN",
    "TO_RADIANS",
    "UNITS",
]

HALF = math.pi / 2
CONSTANTS = {
    **dict.fromkeys(("pi", "m_pi", "kpi", "const_pi"), math.pi),
    **dict.fromkeys(("m_pi_2", "pi_2", "half_pi", "halfpi", "pi_half", "frac_pi_2"), HALF),
    **dict.fromkeys(("m_pi_4", "pi_4", "frac_pi_4"), math.pi / 4),
    "frac_pi_3": math.pi / 3,
    "frac_pi_6": math.pi / 6,
    **dict.fromkeys(("tau", "two_pi"), 2 * math.pi),
    **dict.fromkeys(
        "deg2rad d2r dtr deg_to_rad deg_2_rad degtorad to_rad torad rad_per_deg degree_to_rad"
        " degrees_to_radians deg2radians radians_per_degree".split(),
        math.pi / 180,
    ),
}
UNITS = {
    **dict.fromkeys(("deg", "degs", "degree", "degrees", "grad"), "deg"),
    **dict.fromkeys(("rad", "rads", "radian", "radians"), "rad"),
    **dict.fromkeys(("mm", "millimeter", "millimeters", "millimetre", "millimetres"), "mm"),
    **dict.fromkeys(("cm", "centimeters", "centimetres"), "cm"),
    **dict.fromkeys(("m", "meter", "meters", "metre", "metres"), "m"),
    **dict.fromkeys(("in", "inch", "inches"), "in"),
}
TO_RADIANS = (
    "deg2rad radians rad d2r torad to_rad toradians to_radians degtorad deg_to_rad deg_2_rad dtor"
    " degrees_to_radians radian deg"
).split()
PLAIN = (
    "float float64 float32 double int rational integer s sympify mpf n number sym sp_float"
    " nsimplify"
).split()
FUNCTIONS = {
    "sqrt": math.sqrt,
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "sind": lambda degrees: math.sin(math.radians(degrees)),
    "cosd": lambda degrees: math.cos(math.radians(degrees)),
    "c": math.cos,
    "s": math.sin,
    "abs": abs,
    "fabs": abs,
    "hypot": math.hypot,
}
INVERSE = {
    **dict.fromkeys(("atan", "arctan"), math.atan),
    **dict.fromkeys(("atan2", "arctan2"), math.atan2),
    **dict.fromkeys(("asin", "arcsin"), math.asin),
    **dict.fromkeys(("acos", "arccos"), math.acos),
}


CALLED = {*TO_RADIANS, *PLAIN, *FUNCTIONS, *INVERSE, "degrees", "rad2deg", "r2d"}
# arrays of joint values, as MATLAB indexes them: q(1), jA(1), config(1)
JOINT_VALUES = re.compile(r"q\w{0,3}|th|theta\w{0,3}|ja?|joints?|angles?|conf\w*|phi|jointangles?")
