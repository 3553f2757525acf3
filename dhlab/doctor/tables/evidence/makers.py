"""Functions and classes of known libraries that take a table of numbers: in which order, of which
convention.
"""

import re

__all__ = ["made_by"]

# function or class: (order, convention, what its own words are for the convention, form)
MAKERS = {
    "setfixedtransform": (
        "a alpha d theta",
        None,
        "setFixedTransform of the Robotics System Toolbox",
    ),
    "pybotics": ("alpha a theta d", "craig", "pybotics"),
    "mdhkinematicchain": ("alpha a theta d", "craig", "pybotics"),
    "robotserial": ("d a alpha theta", None, "visual_kinematics"),
    "nlinkarm": ("theta alpha a d", "standard", "PythonRobotics"),
    "robotdef": ("alpha a d theta", None, "SymPyBotics"),
    "dq_kinematics": ("theta d a alpha", None, "DQ Robotics"),
    "dq_serialmanipulatordh": ("theta d a alpha", "standard", "DQ Robotics"),
    "dq_serialmanipulatormdh": ("theta d a alpha", "craig", "DQ Robotics"),
    "revolutemdh": ("", "craig", "the Robotics Toolbox"),
    "revolutedh": ("", "standard", "the Robotics Toolbox"),
    "seriallink": ("theta d a alpha", None, "SerialLink of the Robotics Toolbox"),
}
NAMED = (
    (r"[\"']mdh[\"']|modified", "craig"),
    (r"[\"']dh[\"']|[\"'](normal|standard)[\"']", "standard"),
)


def made_by(source):
    """(order, convention, form) of a maker whose name stands in the text."""
    low = source.text.lower()
    for name, (order, convention, form) in MAKERS.items():
        if re.search(rf"(?<![a-z_]){name}(?![a-z])", low):
            said = [kind for words, kind in NAMED if re.search(words, low)]
            said += ["standard"] if name == "seriallink" else []  # its default
            return tuple(order.split()) or None, convention or (said[0] if said else None), form
    return None, None, ""
