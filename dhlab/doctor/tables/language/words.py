"""Words that stand in cells of pasted tables: kinds of joints, senses, directions, ranges."""

import re

__all__ = ["KINDS", "NO_UNIT", "RANGE", "ROOM", "SIGNS", "STILL", "TOTAL", "TURNED"]

TURNED = {"yes": -1, "true": -1, "1": -1, "y": -1, "x": -1, "no": 1, "false": 1, "0": 1, "n": 1}
ROOM = re.compile(
    r"[-+]?[xyz][-+]?|\(?\s*-?\d[\d.]*(\s*[,; ]\s*-?\d[\d.]*){2}\s*\)?"
    r"|up|down|left|right|forward|backward|vertical|horizontal"
)
NO_UNIT = ("", "-", "1", *"unit units einheit einheiten unite unité unidad 单位 單位".split())
KINDS = {
    "revolute": "R", "r": "R", "rotational": "R", "rev": "R", "rotary": "R", "hinge": "R",
    "prismatic": "P", "p": "P", "linear": "P", "pris": "P", "t": "P", "sliding": "P",
    "dreh": "R", "drehgelenk": "R", "rotativa": "R", "rotoide": "R", "旋转": "R", "转动": "R",
    "回転": "R", "schub": "P", "schubgelenk": "P", "prismatica": "P", "移动": "P", "平移": "P",
    "直動": "P", "prismática": "P",
    "fixed": "fixed", "f": "fixed", "static": "fixed",
}  # fmt: skip
STILL = ("fixed", "const", "constant", "static", "locked", "none")  # in place of a joint's variable
RANGE = re.compile(  # of a joint's values, in the place of its variable: -180..180, ±90°
    r"\W*-?\d[\d.]*\s*(?:°|deg)?\s*(?:\.{2,3}|…|to|~|bis|<|≤)\W*-?\d[\d.]*\W*(?:deg)?\W*"
    r"|[(\[]?\s*(?:±|\+/-)\s*\d[\d.]*\W*(?:deg)?\W*|\[\s*-?\d[\d.]*\s*[,;]\s*-?\d[\d.]*\s*\]"
)
TOTAL = re.compile(  # below the rows
    r"[\W_]*(?:total|sum|summe|gesamt|somme|suma|合计|总计)(?: (?:length|reach|height))?[\W_]*",
    re.IGNORECASE,
)
SIGNS = {
    **dict.fromkeys(("+", "+1", "1", "+z", "z+", "z", "ccw", "positive", "normal"), 1),
    **dict.fromkeys(("-", "-1", "-z", "z-", "cw", "negative", "reversed", "inverted"), -1),
}
