"""The library's pages: a gallery of all arms, the page of each, and arms in other pages."""

import re
from html import escape
from pathlib import Path

import numpy as np
from armpage import best, explorer, page, short
from armpicture import picture, posture

import dhlab as dh
from dhlab.robots import entry

__all__ = ["library", "linked", "with_arms"]

FOLDER = Path(__file__).parent
MEASURED = re.compile(r"^\| (\S+) \| .*? \| (.*?) \| (.*?) \| (.*?) \| (.*?) \| .*? \|$", re.M)


def library():
    """Every page of the library, ``{name: Markdown}``; the gallery is ``robots/index.md``."""
    arms = {key: entry(key) for key in dh.robots()}
    text = (FOLDER / "arms.md").read_text(encoding="utf-8")
    measured = {key: found for key, *found in MEASURED.findall(text)}
    poses = {key: posture(best(one)) for key, one in arms.items()}
    gallery = (FOLDER / "robots" / "index.md").read_text(encoding="utf-8")
    order = sorted(arms.values(), key=_place)
    cards = "\n".join(_card(one, poses[one.key]) for one in order)
    found = {"robots/index.md": gallery.replace("{cards}", cards).replace("{n}", str(len(arms)))}
    for key, one in arms.items():
        found[f"robots/{key}.md"] = page(one, poses[key], measured.get(key))
    return found


def linked(text):
    """The table of sources with each arm's name leading to its page."""
    keys = set(dh.robots())
    return re.sub(
        r"^\| (\S+) \|",
        lambda row: f"| [{row[1]}](robots/{row[1]}.md) |" if row[1] in keys else row[0],
        text,
        flags=re.MULTILINE,
    )


def with_arms(text):
    """A page with the explorer of an arm where it says ``{arm} name q1 q2 ...``, in degrees."""

    def shown(found):
        key, *q = found[1].split()
        one = entry(key)
        html = explorer(one, best(one), np.deg2rad(np.array(q, dtype=float)))
        return f"```{{raw}} html\n{html}\n```"

    return re.sub(r"^\{arm\} (.+)$", shown, text, flags=re.MULTILINE)


def _card(one, q):
    arm = best(one)
    words = " ".join([one.key, one.name, one.maker, *one.also, one.topology])
    return (
        f'<a class="arm-card" href="{one.key}.html" data-words="{escape(words.lower())}"'
        f' data-maker="{escape(one.maker)}" data-joints="{len(arm)}">{picture(arm, q)}'
        f"<b>{escape(short(one))}</b><span>{escape(one.maker or 'the course')}</span>"
        f"<span>{_joints(arm)}</span></a>"
    )


def _place(one):
    """By maker and name, numbers by their size; the course's own arms come last."""
    numbers = [
        (not part.isdigit(), int(part) if part.isdigit() else 0, part)
        for part in re.split(r"(\d+)", short(one).casefold())
    ]
    return not one.maker, one.maker.casefold(), numbers


def _joints(arm):
    slides = arm.table.joints.count("P")
    words = f"{len(arm)} joints"
    return f"{words}, {slides} sliding" if slides else words
