"""Functions and classes of known libraries that take a table of numbers: in which order, of which
convention; and what a call of any of them says of it, ``Robot(dh, dh_type="modified")``.
"""

import re

from ..language.brackets import groups

__all__ = ["called_convention", "made_by"]

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
DEFINED = re.compile(r"\b(?:def|function|fn|func)\s+\w+\s*\((?:[^()]|\([^()]*\))*\)")
# dh_type="normal", convention: Convention.CRAIG, 'dh_convention', 'standard'
KEYWORD = re.compile(
    r"[({,]\s*['\"]?(?:\w*(?:convention|notation)|(?:dh|param\w*)_?(?:type|kind|mode|form|variant))"
    r"['\"]?\s*[=:,](?!=)\s*(?:\w+(?:\.|::))*['\"]?([\w -]+)",
    re.IGNORECASE,
)
# Robot(dh, "modified"), Robot(dh, DHType.STANDARD)
BARE = re.compile(
    r",\s*(?:['\"](standard|modified|craig|classic|mdh|sdh|stdh)(?:[ _-]?dh)?['\"]"
    r"|\w*(?:dh|convention|notation)\w*(?:\.|::)(\w+))\s*(?=[,)])",
    re.IGNORECASE,
)
FLAG = re.compile(  # modified=True, use_mdh: false, 'modified', 1
    r"[({,]\s*['\"]?(?:is_?|use_?)?(?P<what>modified|mdh|craig|proximal|standard|classic)"
    r"(?:_?(?:dh|convention))?['\"]?\s*[=:,](?!=)\s*(?P<on>true|false|[01](?![\w.]))",
    re.IGNORECASE,
)
MEANT = (
    ("craig", re.compile(r"modif\w*|mod|m_?dh\w*|craig\w*|proximal|khalil", re.IGNORECASE)),
    (
        "standard",
        re.compile(r"normal|standard|std_?(?:dh)?|s?dh|classic(?:al)?|distal|original", re.I),
    ),
)


def called_convention(code):
    """The convention that the arguments of calls name, "" where they name none, or both. What a
    definition has as its default is none of a call.

    Examples
    --------
    >>> called_convention('robot = RobotSerial(dh_params, dh_type="normal")')
    'standard'
    >>> called_convention("arm = Arm(rows, modified=True)")
    'craig'
    """
    code = DEFINED.sub(" ", code)
    words = [*KEYWORD.findall(code), *("".join(both) for both in BARE.findall(code))]
    found = {_meant(word) for word in words}
    for flag in FLAG.finditer(code):
        meant = _meant(flag["what"])
        turned = {"craig": "standard", "standard": "craig"}[meant]
        found.add(meant if flag["on"].lower() in ("true", "1") else turned)
    found.discard("")
    return found.pop() if len(found) == 1 else ""


def _meant(word):
    first = re.split(r"[ -]", word.strip())[0]
    return next((name for name, words in MEANT if words.fullmatch(first)), "")


def made_by(source):
    """(order, convention, form) of a maker whose name stands in the text."""
    low = source.text.lower()
    for name, (order, convention, form) in MAKERS.items():
        if re.search(rf"(?<![a-z_]){name}(?![a-z])", low):
            said = [called_convention(source.code)] if called_convention(source.code) else []
            said += _named_in(_calls(name, source.code)) or _named_in(low)
            said += ["standard"] if name == "seriallink" else []  # its default
            return tuple(order.split()) or None, convention or (said[0] if said else None), form
    return None, None, ""


def _calls(name, code):
    """The arguments of the calls of a maker, in small letters."""
    calls = (one for one in groups(code) if one.mark == "(")
    return " ".join(one.text.lower() for one in calls if one.name.lower().endswith(name))


def _named_in(text):
    return [kind for words, kind in NAMED if re.search(words, text)]
