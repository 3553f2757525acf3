"""The programs that are tried: with one slip, with two; a block of them at a time.

A block is (slips of candidate k, a function of k; poses of all candidates (m, 4, 4)).
"""

from functools import lru_cache

import numpy as np

from ...mistakes.entries import slips_of_the_pen, wrong_entries
from ...mistakes.themes.links import mistyped
from .steps import chain_product, right_link, slips
from .trial import Trial, columns, read

__all__ = ["one_slip", "two_slips"]


def _with_entries(table, candidates):
    """Links (m, ..., n, 4, 4): the closed form with one entry replaced by each of m candidates."""
    row = columns(table)
    right = right_link(*row)
    links = np.broadcast_to(right, (len(candidates), *right.shape)).copy()
    for k, (entry, monomial) in enumerate(candidates):
        links[(k, ..., *entry)] = monomial(*row)
    return links


def _grid(firsts, seconds):
    """Names of the candidates of a block in which every first meets every second, the second index
    running fastest.
    """
    return lambda k: (*firsts[k // len(seconds)], *seconds[k % len(seconds)])


def _flat(poses):
    return poses.reshape(-1, 4, 4)


def _tuples(made):
    return [(slip,) for slip in made]


def one_slip(trial):
    """Blocks of programs with one slip, the likeliest first."""
    return _one_slip(trial.kind, trial.rows.shape, trial.rows.tobytes(), trial.q.tobytes())


@lru_cache(maxsize=1)
def _one_slip(kind, shape, rows, q):
    """The same, of a first case that is given by its bytes: kept for the next try at the same
    exercise.
    """
    rows, q = np.frombuffer(rows).reshape(shape), np.frombuffer(q)
    case = (rows, q) if kind == "forward_kinematics" else rows[0]
    return [*_with_one_slip(Trial((), [case], kind, 0))]


def _with_one_slip(trial):
    yield lambda k: trial.early[1 + k], chain_product(right_link(*columns(trial.table[1:])))
    right = trial.table[0]
    yield from _late(trial, [()], right_link(*columns(right))[None])
    yield (
        _tuples(slips("link")).__getitem__,
        np.stack([chain_product(slip.change(*columns(right))) for slip in slips("link")]),
    )
    candidates = wrong_entries()
    yield (lambda k: (mistyped(*candidates[k]),), chain_product(_with_entries(right, candidates)))


def _late(trial, names, links):
    """One slip after the links are made: each link finished wrongly, multiplied wrongly, or the
    result finished wrongly.
    """
    if trial.product:
        yield (
            _grid(names, _tuples(trial.product)),
            _flat(np.stack([slip.change(links) for slip in trial.product], axis=1)),
        )
    poses, result = chain_product(links), slips("result")
    yield (
        _grid(names, _tuples(result)),
        _flat(np.stack([slip.change(poses) for slip in result], axis=1)),
    )
    if trial.each:
        yield (
            _grid(names, _tuples(trial.each)),
            _flat(np.stack([chain_product(slip.change(links)) for slip in trial.each], axis=1)),
        )


def two_slips(trial):
    """Blocks of programs with two slips."""
    early, right = trial.early[1:], trial.table[0]
    yield from _late(trial, early, right_link(*columns(trial.table[1:])))
    link = slips("link")
    yield from _late(trial, _tuples(link), np.stack([s.change(*columns(right)) for s in link]))
    pen = list(slips_of_the_pen())
    pen_names = [(mistyped(*candidate),) for candidate in pen]
    yield from _late(trial, pen_names, _with_entries(right, pen))
    links = np.stack([slip.change(*columns(trial.table[1:])) for slip in link])
    yield _grid(_tuples(link), early), _flat(chain_product(links))
    yield _grid(pen_names, early), _flat(chain_product(_with_entries(trial.table[1:], pen)))
    yield from _two_early(trial)
    yield from _two_entries(right, pen, pen_names)
    yield from _two_late(trial, right_link(*columns(right)))


def _two_early(trial):
    """A second slip of reading or of arguments on top of each first one."""
    arguments = slips("arguments")
    if trial.is_chain:
        rows, q = (
            np.stack(parts)
            for parts in zip(*(slip.change(trial.rows, trial.q) for slip in trial.reading))
        )
        for second in trial.reading + arguments:
            links = right_link(*columns(read((second,), rows, q)))
            yield _grid(_tuples(trial.reading), [(second,)]), chain_product(links)
    firsts = trial.table[-len(arguments) :]
    for second in arguments:
        links = right_link(*second.change(*columns(firsts)))
        yield _grid(_tuples(arguments), [(second,)]), chain_product(links)


def _two_entries(right, pen, pen_names):
    links = _with_entries(right, pen)
    row = columns(right)
    for k, (entry, monomial) in enumerate(pen):
        second = links[k + 1 :].copy()
        second[(..., *entry)] = monomial(*row)
        later = [j for j in range(k + 1, len(pen)) if pen[j][0] != entry]
        if later:
            keep = np.array(later) - k - 1
            yield (
                (lambda i, k=k, later=later: (*pen_names[k], *pen_names[later[i]])),
                chain_product(second[keep]),
            )


def _two_late(trial, links):
    """Two slips after the links are made."""
    result = slips("result")
    makers = [
        *((slip, chain_product(slip.change(links))) for slip in trial.each),
        *((slip, slip.change(links)) for slip in trial.product),
        *((slip, slip.change(chain_product(links))) for slip in result),
    ]
    for first, poses in makers:
        yield _grid([(first,)], _tuples(result)), np.stack([slip.change(poses) for slip in result])
    for first in trial.each:
        yield (
            _grid([(first,)], _tuples(trial.product)),
            np.stack([slip.change(first.change(links)) for slip in trial.product]),
        )
