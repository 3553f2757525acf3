"""Which parameter a heading or a name means."""

import re
import unicodedata
from functools import lru_cache

from .letters import KEPT, unified

__all__ = ["ROLES", "kind_said", "role_of", "unit_in"]

ROLES = ("theta", "d", "a", "alpha")
PREVIOUS = re.compile(
    r"\(?(?:(?<![a-z])|(?<=[a-z]))[ijkn]\s*-\s*1\)?|(?<![a-z])(?:previous|prev)(?![a-z])|_i?_?m_?1\b"
)
LOST_MINUS = re.compile(r"^(alpha|theta|[adr]) ?([ijn]) 1\b")  # a page without its signs
# a - length along x, d along z
EXPLAINED = re.compile(
    r"(?!theta.*off)(alpha|theta|[adr])(?:_?[ijkn])? "
    r"(?:- |: |along |about |around |\((?=[a-z]{4}))[a-z]"
)
FOREIGN_UNITS = {
    **dict.fromkeys(
        "grad grados graus gradi degrés stopnie stupně graden derece độ derajat град градусы"
        " градусов 度 도".split(),
        "deg",
    ),
    **dict.fromkeys(
        "radianes radianos radianti radiani radiany рад радианы 弧度 라디안".split(), "rad"
    ),
    **dict.fromkeys("milímetros millimètres millimetri мм 毫米 ミリ 밀리미터".split(), "mm"),
    **dict.fromkeys("centímetros см 厘米".split(), "cm"),
    **dict.fromkeys("metros mètres metri meter metre metres meters metrů м 米 미터".split(), "m"),
}
UNIT = re.compile(
    rf"[\[(/,_]\s*(deg|degrees?|°|rad|radians?|mm|cm|m|inch|in|{'|'.join(FOREIGN_UNITS)})\s*[\])]?\s*$"
    r"|\s(?:in\s+)?(deg|degrees?|°|rad|radians?|mm|cm|m)\s*$|(°)$",
    re.IGNORECASE,
)
UNIT_OF = {
    "degrees": "deg",
    "degree": "deg",
    "°": "deg",
    "radians": "rad",
    "radian": "rad",
    **FOREIGN_UNITS,
}
MARKS = {chr(k) for k in range(0x300, 0x370)}  # on Latin letters
FOREIGN = (  # as :func:`_without_accents` leaves them
    (r"verdreh|verwind|torsion|torsione|torcao|skrecen|zkrut|burulma|скручив|кручен|扭|连杆转角"
     r"|連桿轉角|ねじれ|비틀림", "alpha"),
    (r"gelenkwinkel|drehwinkel|angle articulaire|angle de (l'|la )|angulo (de|da|do|articular)"
     r"|angolo (di|del)|kat (przegub|obrot|zlacz)|uhel kloubu|(eklem|mafsal) ac[iı]"
     r"|угол (поворот|сочлен|в )"
     r"|关节(转)?角|關節(轉)?角|関節角|관절 ?각", "theta"),
    (r"versatz|decalage|desplazamiento|deslocamento|przesuni|posunut|kayma|otele|смещени|偏距|偏置"
     r"|偏移|オフセット|リンク間|오프셋", "d"),
    (r"lange\b|laenge\b|longueur|longitud|lunghezza|comprimento|dlugosc|długosc|delka|uzunlu|длина"
     r"|杆(件)?长|桿(件)?長|リンク長|リンクの長|링크 ?길이", "a"),
    (r"^winkel\b|转角|轉角|^angle$|^angulo$", "theta"),
    (r"achsrichtung|drehrichtung|方向", "direction"),
)  # fmt: skip
PHRASES = (  # the first that fits
    (r"\balphas?\b|\balfas?\b|\balp\b|\btwist", "alpha"),
    (
        r"\b(theta|th|joint)_?\s*off(set)?s?\b(?!.*\bd(?:\b|_))|\boffset_?\s*(theta|angle|q)\b"
        r"|\bq\w*_?offset\b",
        "offset",
    ),
    (r"\b(?:theta|th|q)_?(?:min(?:imum)?|lower)\b|\bmin(?:imum)?_?(?:theta|th|q)\b", "low"),
    (r"\b(?:theta|th|q)_?(?:max(?:imum)?|upper)\b|\bmax(?:imum)?_?(?:theta|th|q)\b", "high"),
    (r"\bphi(?:\b|_)", "theta"),
    (r"\bthetas?_?0?\b|\bjoint angle|\bth\b", "theta"),
    (
        r"^dist\.?$|^disp(?:lacement)?s?$|\blink offset|\bjoint distance|\blink[- ]?distance"
        r"|\bjoint offset.*\bd(?:\b|_)",
        "d",
    ),
    (r"\blink length|\bcommon normal", "a"),
    (r"^rot(?:ation|ate)? ?(?:about |around )?z$|^rotz$", "theta"),
    (r"^rot(?:ation|ate)? ?(?:about |around )?x$|^rotx$", "alpha"),
    (r"^trans(?:lation|late|l)? ?(?:along |in )?z$|^transz$", "d"),
    (r"^trans(?:lation|late|l)? ?(?:along |in )?x$|^transx$", "a"),
    (
        r"^(sign|dir|direction|rot\w* dir\w*|joint dir\w*|motor dir\w*|sense|axis dir\w*|polarity"
        r"|rotation|turns)$",
        "sign",
    ),
    (r"^(inverted|invert|reversed?|flip(ped)?|negated?)$", "turned"),
    (r"\b(axis|direction)\b", "direction"),
    (r"\b(sigma|prismatic)\b", "sigma"),
    (r"\b(joint)?[ _]?type\b|^p/r$|^r/p$|^(gelenk)?typ$|^tipo\b|类型|類型|種類|種別", "type"),
    (r"\blower\b|\bmin(imum)?\b|\bqmin\b", "low"),
    (r"\bupper\b|\bmax(imum)?\b|\bqmax\b", "high"),
    (r"\b(qlim|limits?|range|bounds?)\b", "limits"),
    (r"\boffsets?\b", "offset"),
)
LETTERS = {
    **dict.fromkeys(("d", "dz", "dd"), "d"),
    **dict.fromkeys(("a", "dx", "aa"), "a"),
    "r": "r",
    **dict.fromkeys(("q", "t", "tt", "v"), "theta"),  # ϑ is typed as v
    **dict.fromkeys(("al", "alf"), "alpha"),
}
LABELS = (
    "i j k n no # link joint row name frame axis linki frames links joints transformation"
    " gelenk achse glied nr articulation liaison axe articulacion eje giunto 关节 轴 连杆 关节号"
    " bemerkung kommentar beschreibung remark remarks note notes comment comments description"
    " observaciones remarque 备注 说明 звено сустав 備考 序号 khop 關節 軸 関節 リンク".split()
)
NUMBERED = re.compile(  # Joint i, Axis no., Link number
    r"(?:link|joint|frame|axis|row|segment|sr|s|gelenk|achse)s?[ ./]*"
    r"(?:[ijkn]|n[or]s?|num(?:ber)?|id|#|idx|index|name)\.?"
)
KINDS_BY_FLAG = {  # what True says, and False
    "fixed": ("fixed", ""),
    **dict.fromkeys(("movable", "actuated", "active"), ("", "fixed")),
    "revolute": ("R", "P"),
    "prismatic": ("P", "R"),
}
FILLER = re.compile(
    r"\b(dh|mdh|sdh|params?|parameters?|vals?|values?|list|arr|array|vec|vector|robot|self|this|std"
    r"|nominal|i|j|n|in|arm|my|the|column|link|const|double|float|constants?|config|table)\b"
)


def kind_said(name, said):
    """The kind of joint, "R", "P", "fixed" or "", that a named flag or type says.

    Examples
    --------
    >>> kind_said("fixed", "True"), kind_said("joint_type", "'prismatic'"), kind_said("d", "1")
    ('fixed', 'P', '')
    """
    name, said = name.lower().replace("_", ""), said.strip(" '\"").lower()
    if name in ("type", "jointtype", "kind"):
        return {"r": "R", "p": "P", "f": "fixed"}.get(said[:1], "")
    yes, no = KINDS_BY_FLAG.get(name.removeprefix("is"), ("", ""))
    return yes if said in ("true", "1", "yes") else no if said in ("false", "0", "no") else ""


def _without_accents(text):
    """``länge`` as ``lange``: letters without the marks on them."""
    apart = unicodedata.normalize("NFKD", text)
    return unicodedata.normalize("NFC", "".join(c for c in apart if c not in MARKS)).strip()


def unit_in(text):
    """The unit that a heading names, "" when it names none.

    Examples
    --------
    >>> unit_in("alpha (deg)"), unit_in("d [mm]"), unit_in("a_i")
    ('deg', 'mm', '')
    """
    found = UNIT.search(text.strip())
    if not found:
        return ""
    said = next(part for part in found.groups() if part).lower()
    return UNIT_OF.get(said, said)


def _misspelt(word):
    """The Greek letter of which a word differs in one letter, or in the order of two; "" of none.

    Examples
    --------
    >>> _misspelt("aplha"), _misspelt("thetha"), _misspelt("beta")
    ('alpha', 'theta', '')
    """
    for name in ("alpha", "theta"):
        if word[:1] != name[0] or abs(len(word) - len(name)) > 1:
            continue
        longer, shorter = sorted((word, name), key=len, reverse=True)
        if len(longer) > len(shorter):
            near = any(longer[:k] + longer[k + 1 :] == shorter for k in range(len(longer)))
        else:
            near = sum(a != b for a, b in zip(word, name)) == 1 or sorted(word) == sorted(name)
        if near:
            return name
    return ""


def role_of(text):
    """(role, whether it is the previous row's) that a heading or a name means; role None when none.

    The roles are theta, d, a, alpha, r (the length beside d, or the offset beside d), offset, sign,
    direction, type, sigma, low, high, limits and label.

    Examples
    --------
    >>> role_of("alpha_{i-1} [rad]"), role_of("link length"), role_of("self.theta_offset")
    (('alpha', True), ('a', False), ('offset', False))
    """
    return _role_of(str(text))


@lru_cache(KEPT)
def _role_of(text):
    text = unified(text).strip(" *`'\"$:").lower()
    text = LOST_MINUS.sub(r"\1 \2-1", text)
    if told := EXPLAINED.match(text):
        return told[1], False
    if re.match(r"(?:cos|sin|tan)[ _({]*(?:alpha|theta)", text):
        return "room", False  # the twist once more
    if text in LABELS or not text.strip("-") or NUMBERED.fullmatch(text):
        return "label", False
    found = UNIT.search(text)
    bare = text[: found.start()] if found and found.start() else text
    previous = bool(PREVIOUS.search(bare)) and len(bare) < 24
    bare = PREVIOUS.sub(" ", bare) if previous else bare
    words = re.sub(r"[\[\](){}_,;:./|*'\"]+", " ", bare)
    words = re.sub(r"(?<=[a-z])0?[ijk]\b", "", words) if len(words) < 8 else words
    whole, words = words, " ".join(FILLER.sub(" ", words).split())
    if words in LABELS:
        return "label", False
    foreign = _without_accents(bare)
    if foreign in LABELS or re.sub(r"(?<=[^\x00-\x7f])[ijn]$", "", foreign) in LABELS:
        return "label", False
    if not re.search(r"\b(theta|alpha|[adr])\b", words):  # a letter beside it says it better
        for pattern, role in FOREIGN:
            if re.search(pattern, foreign):
                return role, previous
    for pattern, role in PHRASES:
        if any(re.search(pattern, said) for said in (words, bare, whole)):
            return role, previous
    if words in LETTERS:
        return LETTERS[words], previous
    if meant := _misspelt(words.rstrip("0123456789_")):
        return meant, previous
    first = words.split(" ")
    if len(first) > 1 and len(first[-1]) <= 2 and first[-1] in LETTERS:
        return LETTERS[first[-1]], previous  # "link distance d", "ur5 a"
    if words in ("distance", "offset d"):
        return "d", previous
    return (LETTERS["a"], previous) if words == "length" else (None, previous)
