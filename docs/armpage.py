"""The page of an arm of the library, made of its file alone."""

import base64
import json
import re
import zlib

import numpy as np
from armpicture import picture

import dhlab as dh
from dhlab.printing import number, table_html
from dhlab.transform import to_xyz_rpy
from dhlab.view.explorer.content import arm_data
from dhlab.view.explorer.page import wrapped

__all__ = ["best", "explorer", "page", "short"]

CONVENTIONS = {"standard": "standard", "craig": "Craig's"}


def best(one):
    """The arm with the first of its tables, which is the one to use."""
    return next(iter(one.tables.values()))


def short(one):
    """The name without its maker, which stands beside it, and without what it is explained by."""
    name = one.name.removeprefix(one.maker).strip() or one.name
    return re.sub(r" \([^)]*\)$|, .*$", "", name) if len(name) > 24 else name


def page(one, q, measured):
    """One arm in Markdown: ``q`` is how it stands, ``measured`` its row of ``arms.md``."""
    arm, name = best(one), next(iter(one.tables))
    parts = [
        "---\norphan: true\n---",
        f"```{{index}} {', '.join(f'! {name}' for name in sorted(_called(one)))}\n```",
        f"# {one.name}",
        _lead(one, arm),
        f"```{{raw}} html\n{explorer(one, arm, q)}\n```",
        "## Its table",
        _origin_of(one, name),
        _both(arm),
        "## Load it",
        _code(one.key, arm),
        "## Where it stands, and how far it goes",
        _stands(one),
        _limits(arm),
        _checks(one, name),
        _others(one),
        "## Where the numbers come from",
        _sources(one, arm, measured),
        "[All arms](index.md) · [How the arms were checked](../arms.md)",
    ]
    return "\n\n".join(part for part in parts if part) + "\n"


def _called(one):
    """What the site's search finds the page by, besides its words."""
    names = {one.key, one.name, short(one), one.key.replace("_", " "), *one.also}
    return {re.sub(r"[,;:!]", "", name) for name in names}


def _lead(one, arm):
    also = [name for name in one.also if name not in one.name]
    words = [f"{one.topology or arm.table.joints}."]
    if one.maker:
        words.insert(0, f"Made by {one.maker};")
    if also:
        words.append(f"Also known as {', '.join(also)}.")
    words.append(f"Its name in the library is `{one.key}`.")
    return " ".join(words)


def explorer(one, arm, q):
    """The explorer of an arm without a kernel, with the small picture until it is alive."""
    title = one.name
    alt = f"{title} with its frames: {len(arm)} joints, {one.topology or arm.table.joints}"
    data = {"mode": "arm", "title": title, "alt": alt, "arm": arm_data(arm), "instrument": True}
    state = {
        "q": q.tolist(),
        "row": [0, 0, 0, 0],
        "convention": arm.table.convention,
        "step": 0,
        "_answer": {},
    }
    return wrapped(picture(arm, q, f"{alt}, drawn as links and joint axes"), data, state)


def _origin_of(one, name):
    """What kind of table the best one is, in a sentence."""
    convention = CONVENTIONS[one.tables[name].table.convention]
    if name.startswith("derived"):
        return (
            f"Derived from the joint axes of a URDF, in {convention} DH, and beside it the same arm"
            " in the other convention."
        )
    return (
        f"As published, in {convention} DH (the library calls this table `{name}`), and beside it"
        " the same arm in the other convention."
    )


def _table(*arms):
    """Tables of arms beside each other, each with its base and tool below it."""
    html = "".join(_grid(arm) for arm in arms)
    return f'```{{raw}} html\n<div class="arm-tables">{html}</div>\n```'


def _grid(arm):
    rates = arm.sign if arm.coupling is None else arm.coupling * arm.sign
    ends = "".join(f"<p>{line}</p>" for line in _ends(arm))
    table = table_html(arm.table, rates, length="mm")
    return f'<div class="arm-table" tabindex="0">{table}{ends}</div>'


def _ends(arm):
    for name in ("base", "tool"):
        pose = getattr(arm, name)
        if not np.array_equal(pose, np.eye(4)):
            xyz, rpy = to_xyz_rpy(pose)
            place = ", ".join(number(1000 * v, 4) for v in xyz)
            turn = ", ".join(number(v, 4) for v in np.rad2deg(rpy))
            yield f"{name}: ({place}) mm; roll, pitch, yaw ({turn})°".replace("-", "−")


def _both(arm):
    other = arm.to("craig" if arm.table.convention == "standard" else "standard")
    return f"{_table(arm, other)}\n\nBoth give the same pose for every q."


def _code(key, arm):
    zeros = ", ".join("0" for _ in range(len(arm)))
    asked = {"arm": key, "do": "fk", "q": zeros}
    return f"""```python
import dhlab as dh

arm = dh.load("{key}")
arm.forward([{zeros}])
```

```{{code-block}} bash
dhlab robots {key}
```

<a href="../bench/index.html#{_case(asked)}">Ask the bench about this arm</a>: its end for your
joint values, another table beside it, or what is wrong with measured poses."""


def _case(asked):
    """What the bench's links hold behind their #."""
    packer = zlib.compressobj(9, wbits=-15)
    packed = packer.compress(json.dumps(asked).encode()) + packer.flush()
    return base64.urlsafe_b64encode(packed).decode().rstrip("=")


def _stands(one):
    return " ".join(_sentence(said) for said in (one.zero, one.flange) if said)


def _limits(arm):
    if arm.limits is None:
        return "No limits are stated for its joints."
    rows = ["| joint | from | to |", "| --- | --- | --- |"]
    for i, pair in enumerate(arm.limits):
        unit, factor = ("°", 180 / np.pi) if arm.table.joints[i] == "R" else (" mm", 1000)
        ends = (
            ("free", "free") if pair is None else [f"{number(v * factor, 2)}{unit}" for v in pair]
        )
        rows.append(f"| {i + 1} | {ends[0]} | {ends[1]} |".replace("-", "−").replace("−−−", "---"))
    return "\n".join(rows)


def _checks(one, name):
    """The poses that a program with this table must give."""
    slides = one.tables[name].table.prismatic
    said = ["A program with this table must give:", ""]
    said += ["| q | end (mm) | roll, pitch, yaw | from |", "| --- | --- | --- | --- |"]
    for check in one.checks[name]:
        q = [
            f"{number(1000 * v, 3)} mm" if p else f"{number(np.rad2deg(v), 4)}°"
            for v, p in zip(check.q, slides, strict=True)
        ]
        place = ", ".join(number(1000 * v, 4) for v in check.xyz)
        turn = "not published" if check.R is None else _turn(check.R)
        numbers = f"| {', '.join(q)} | {place} | {turn} |".replace("-", "−")
        said.append(f"{numbers} {_plain(check.source)} |")
    return "\n".join(said)


def _turn(R):
    T = np.eye(4)
    T[:3, :3] = R
    return ", ".join(f"{number(v, 4)}°" for v in np.rad2deg(to_xyz_rpy(T)[1]))


def _others(one):
    """The tables that others publish, each with what differs."""
    (_, best), *rest = one.tables.items()
    if not rest and not one.ambiguity:
        return ""
    parts = ["## What others publish differently"]
    if one.ambiguity:
        parts.append(f"{_plain(_sentence(one.ambiguity))}")
    for name, arm in rest:
        note = one.notes[name]
        compared = str(dh.compare(best, arm).message)
        parts += [
            f"### `{one.key}.{name}`",
            _plain(_sentence(note)) if note else "",
            f"Compared with the table above (a): {_plain(compared[0].lower() + compared[1:])}",
            _table(arm),
            f"Source: {_plain(arm.source)}" if arm.source else "",
        ]
    return "\n\n".join(part for part in parts if part)


def _sources(one, arm, measured):
    lines = [f"- The table: {_plain(arm.source)}" if arm.source else ""]
    if one.second:
        lines.append(f"- Second source: {_plain(one.second)}")
    if measured:
        first, gap, second, other = measured
        if gap:
            lines.append(f"- Against the source ({_plain(first)}): {_apart(gap)}")
        if other:
            lines.append(f"- Against {_plain(second)}: {_apart(other)}")
    if one.licence:
        lines.append(f"- Licence of what was read: {_plain(one.licence)}")
    lines += [f"- <{link}>" for link in one.links]
    return "\n".join(line for line in lines if line)


def _apart(gap):
    """A cell of the table of sources as words."""
    numbers, _, fitted = gap.partition(" (")
    fitted = f", with {' and '.join(fitted.rstrip(')').rsplit(', ', 1))} fitted" if fitted else ""
    return f"at most {numbers} apart over 200 joint values{fitted}"


def _sentence(text):
    """A text with a full stop and, where it begins with a word and no symbol, a capital."""
    first, _, rest = text.partition(" ")
    if first.isalpha() and first.islower() and (len(first) > 1 or rest[:1].isalpha()):
        text = text[0].upper() + text[1:]
    return text if text.endswith(".") else f"{text}."


def _plain(text):
    """A text from a file, with nothing in it that Markdown would read as its own."""
    return re.sub(r"([\\`*_\[\]<>#$|~])", r"\\\1", text)
