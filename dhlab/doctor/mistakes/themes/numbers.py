"""The numbers themselves: their signs and their units."""

import numpy as np

from ..changes import (
    ALL,
    EACH,
    JointChange,
    MeasuredChange,
    PoseChange,
    RowChange,
    of_numbers,
    scaled,
)
from ..registry import SIGN, UNITS, mistake

__all__ = ["ANGLES", "DEG", "LENGTHS", "angles", "in_programs"]

DEG = 180 / np.pi
INCH = 25.4e-3  # m
LENGTHS, ANGLES = ("d", "a"), ("theta", "alpha")


def angles():
    """What may go wrong with one angle or with both: (place in words, names)."""
    yield from (("theta", ("theta",)), ("alpha", ("alpha",)), ("theta and alpha", ANGLES))


def in_programs(names, change, place):
    """What only programs do to the arguments of their link matrix, each number by itself."""
    return RowChange(of_numbers(names, change), rows=(), argument=place)


# ---- angles in the other unit


@mistake("degrees-in-sin-cos")
def degrees_in_sin_cos():
    yield RowChange(
        scaled(theta=DEG, alpha=DEG),
        rows=(),
        argument="theta and alpha",
        reading="the angles of the rows",
    )
    yield RowChange(scaled(theta=DEG), rows=(), argument="theta")
    yield JointChange(lambda n: DEG * np.eye(n), reading="q", measured="q is in degrees")


@mistake("alpha-in-degrees")
def alpha_in_degrees():
    yield RowChange(scaled(alpha=DEG), "alpha", argument="", within=1e-3 * DEG)


@mistake("converted-to-radians-twice")
def converted_to_radians_twice():
    yield RowChange(
        scaled(theta=1 / DEG, alpha=1 / DEG),
        rows=(),
        argument="theta and alpha",
        reading="the angles of the rows",
    )
    yield RowChange(scaled(theta=1 / DEG), rows=(), argument="theta", reading="the theta column")
    yield RowChange(scaled(alpha=1 / DEG), rows=(), argument="alpha")
    yield JointChange(lambda n: np.eye(n) / DEG, reading="q", measured="q was converted twice")


@mistake("angle-unit")
def angle_unit():
    for factor in (DEG, 1 / DEG):
        yield RowChange(scaled(theta=factor, alpha=factor), rows=(ALL,), place="all angles")
    yield RowChange(scaled(alpha=1 / DEG), rows=(ALL,), place="all alpha")
    for factor in (1 / DEG, DEG):
        yield RowChange(scaled(theta=factor), rows=(ALL,), place="all theta")


@mistake("angle-factor")
def angle_factor():
    for place, names in angles():
        yield in_programs(names, lambda x: 2 * x, f"{place}: twice the angle")
        yield in_programs(names, lambda x: x / 2, f"{place}: half the angle")


# ---- signs


@mistake("row-vector-convention")
def row_vector_convention():
    yield RowChange(scaled(theta=-1, alpha=-1), rows=(), argument="")
    yield RowChange(scaled(theta=-1), rows=(), argument="the turn about z")


@mistake("alpha-sign", preference=SIGN)
def alpha_sign():
    yield RowChange(scaled(alpha=-1), "alpha", argument="the turn about x")


@mistake("length-sign", preference=SIGN)
def length_sign():
    for name in LENGTHS:
        change = scaled(**{name: -1})
        yield RowChange(change, name, rows=(EACH,), argument=name, within=1e-6)


@mistake("lengths-made-positive")
def lengths_made_positive():
    yield RowChange(of_numbers(LENGTHS, np.abs), rows=(ALL,), place="", argument="")
    yield RowChange(of_numbers((*LENGTHS, "alpha"), np.abs), rows=(ALL,), typed=())
    for name in LENGTHS:
        yield RowChange(of_numbers((name,), np.abs), rows=(), argument=name)


# ---- lengths in another unit


@mistake("length-unit", preference=UNITS)
def length_unit():
    inches = [factor for unit in (1, 1e2, 1e3) for factor in (unit * INCH, 1 / INCH / unit)]
    for factor in (1000, 1e-3, 10, 0.1, 100, 0.01, *inches):
        both, in_programs = scaled(d=factor, a=factor), "" if factor in (1000, 1e-3) else None
        yield RowChange(both, rows=(ALL,), place="all lengths", argument=in_programs)
    for name in LENGTHS:
        for factor in (1000, 1e-3):
            yield RowChange(scaled(**{name: factor}), name, place=f"all {name}", argument=name)
        for factor in (1 / INCH, 1e-3 / INCH):
            yield RowChange(scaled(**{name: factor}), name, rows=())
    yield PoseChange(_in_millimetres, "the position, in mm", each_link=False)
    yield MeasuredChange(_in_another_unit)


def _in_millimetres(T):
    return T * np.where(np.arange(4) == 3, [[1000], [1000], [1000], [1]], 1)


def _in_another_unit(n):
    for factor, place in (
        (1000, "the poses are 1000 times too small"),
        (1e-3, "the poses are in mm"),
        (INCH, "the poses are in inches"),
    ):
        yield None, place, lambda q, p, R, factor=factor: (q, p * factor, R)
