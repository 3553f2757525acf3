"""The links that several runs of a program show: what it multiplies, a toolbox's robot, matrices
that it lists, or link functions that it has.
"""

from dataclasses import replace

import numpy as np

from .links import Links, links_of

__all__ = ["different", "shown_in"]

FEWEST = 2  # joints of an arm


def shown_in(way, runs):
    """The Links that runs show."""
    multiplied = _from_products(runs) or _from_robots([run.robots for run in runs])
    if multiplied or not way.whole:
        return multiplied
    listed = _from_lists(runs) or _from_robots([run.loose_links() for run in runs])
    return listed or _from_functions([way.linked(run) for run in runs], runs)


def _from_products(runs):
    """The Links of what the runs multiply."""
    if len({len(run.factors.products) for run in runs}) > 1:
        return []
    lists = [{one.tobytes() for one in row} for row in runs[0].listed()]
    places = [k for k in _longest(runs[0]) if not _leaves_out(runs[0].factors.products[k], lists)]
    return _as_links(runs, [[run.factors.products[k] for run in runs] for k in places])


def _leaves_out(product, lists):
    """Whether a product has some matrices of a list and others not: the program goes on, or was cut
    off.
    """
    held = {one.tobytes() for one in product}
    return any(held & row and row - held for row in lists)


def _from_robots(runs):
    """The Links of a toolbox's robots, of each run, whose numbers are the same in all."""
    if len(set(map(len, runs))) > 1:
        return []
    found = []
    for same in zip(*runs):
        rows = {tuple(link.row for link in robot) for robot in same}
        if any(None in row for row in rows):
            return []
        if len(rows) == 1 and len(same[0]) >= FEWEST:
            found.append(_of_robot(same[0]))
    return found


def _from_lists(runs):
    """The Links of matrices that are listed, or numbered, and not multiplied."""
    lists = [run.listed() for run in runs]
    if len({len(one) for one in lists}) > 1:
        return []
    held = [{one.tobytes() for one in row} for row in lists[0]]
    whole = [k for k, row in enumerate(held) if not any(row < other for other in held)]
    return _as_links(runs, [[one[k] for one in lists] for k in whole])


def _from_functions(linked, runs):
    """The Links of link functions that nobody calls, for the rows of a table."""
    drawn = [run.samples.drawn for run in runs]
    found = []
    for key in linked[0]:
        if all(key in one and len(one[key]) == len(linked[0][key]) for one in linked):
            links = links_of([tuple(one[key]) for one in linked], drawn)
            if links is None or links.joints < FEWEST:
                continue
            if not key[0]:  # a function for each link, which has its joint for a parameter
                found.append(links)
            elif links.joints == len(links.rows):
                found.append(replace(links, of_function=True))
    return found


def _as_links(runs, chains):
    found = []
    drawn = [run.samples.drawn for run in runs]
    for samples in chains:
        makers = [runs[0].factors.makers.get(one.tobytes()) for one in samples[0]]
        links = links_of(samples, drawn, makers)
        if links is not None and links.joints >= FEWEST:
            found.append(links)
    return found


def _longest(run):
    """The places of the products that are no part of another, and have no unknown part."""
    keys = [tuple(one.tobytes() for one in product) for product in run.factors.products]
    broken = [tuple(one.tobytes() for one in product) for product in run.factors.broken]
    kept: dict = {}
    for k, product in enumerate(keys):
        kept.setdefault(product, k)
    for product, k in kept.items():
        others = [other for other in kept if len(other) > len(product)]
        if not any(_within(product, other) for other in (*others, *broken)):
            yield k


def _within(part, whole):
    n = len(part)
    return any(whole[at : at + n] == part for at in range(len(whole) - n + 1))


def _of_robot(links):
    """The Links of a toolbox's robot."""
    return Links(
        links[0].convention if len({one.convention for one in links}) == 1 else "",
        tuple(one.row for one in links),
        tuple(one.letter for one in links),
        tuple(one.sign for one in links),
        tuple(f"q{k}" for k in range(len(links))),
        of_toolbox=True,
    )


def different(found):
    """The chains without those that are another once more, or a part of it."""
    kept: list = []
    for one in sorted(found, key=lambda links: -len(links.rows)):
        if not one.convention:
            continue
        rows = [tuple(row) for row in one.rows]
        same = [other for other in kept if other.convention == one.convention]
        if not any(_is_part(rows, other) for other in same):
            kept.append(one)
    return kept


def _is_part(rows, other):
    n = len(rows)
    return any(
        np.allclose(rows, other.rows[at : at + n], rtol=0, atol=1e-9)
        for at in range(len(other.rows) - n + 1)
    )
