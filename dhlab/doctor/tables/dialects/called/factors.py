"""What calls of a link function are multiplied by: ``DH(…).DH(…).Rz(-90)``."""

import re
from dataclasses import replace

from ...cells import Cell, cell_of
from ...meaning.columns import orders as orders_of

__all__ = ["with_factors"]

JOIN = r"\s*[.*@·]\s*"
FACTOR = r"(?:t?rot|r|t|transl?)_?[xyz]\s*\([^()]*\)"
PARTS = re.compile(r"([a-z_]+)\s*\(([^()]*)\)", re.IGNORECASE)
MOVES_OF = {"rz": "theta", "tz": "d", "tx": "a", "rx": "alpha"}


def with_factors(table, name, source):
    """The table with what its calls are multiplied by: ``DH(…).DH(…).Rz(-90)``.

    Raises
    ------
    ValueError
        It is more than elementary moves, or it is not said in which column one is.
    """
    product = rf"(?<!\w){re.escape(name)}\s*\((?:[^()]|\([^()]*\))*\)"
    behind = rf"{product}(?P<moves>(?:{JOIN}{FACTOR})*)"
    other = rf"{behind}\s*[*@]\s*(?!{re.escape(name)}\b|{FACTOR})(?P<what>[A-Za-z][\w.]*)"
    if left := re.search(other, source.code, re.IGNORECASE):
        raise ValueError(
            f"recognise_table: the product goes on with {left['what'][:30]} behind the calls of"
            f" {name}; which row is it? Write it as a row without a joint, or leave it out"
        )
    if within := re.search(
        rf"{product}{JOIN}({FACTOR}){JOIN}(?:{FACTOR}{JOIN})*{product}", source.code, re.I
    ):
        raise ValueError(
            f"recognise_table: the product has {within[1][:30]} between two calls of {name}; to"
            " which row does it belong? Write it as a row without a joint"
        )
    before = re.search(rf"(?P<moves>(?:{FACTOR}{JOIN})+){product}", source.code, re.IGNORECASE)
    after = next(
        (one for one in re.finditer(behind, source.code, re.IGNORECASE) if one["moves"]), None
    )
    first, last = (
        _still(found["moves"] if found else "", table, name, source) for found in (before, after)
    )
    rows = (*first, *table.rows, *last)
    if len(rows) == len(table.rows):
        return table
    kinds = (*("fixed" for _ in first), *table.kinds, *("fixed" for _ in last))
    n = len(rows)
    return replace(table, rows=rows, kinds=kinds, labels=("",) * n, signs=(1,) * n)


def _still(moves, table, name, source):
    """A row without a joint for each elementary move of a product.

    Raises
    ------
    ValueError
        One is no move along or about x or z by a number, or the columns may have several orders.
    """
    rows = []
    for move, of in PARTS.findall(moves):
        letters = re.sub("^trot", "rot", move.lower())
        value, role = source.value(of), MOVES_OF.get(letters[0] + letters[-1])
        place = {one.roles.index(role) for one in orders_of(table, None) if role in one.roles}
        if value is None or value.letters or len(place) != 1:
            raise ValueError(
                f"recognise_table: the product has {move}({of[:30]}) beside the calls of {name};"
                " which row is it? Write it as a row without a joint"
            )
        row = [Cell(0.0)] * len(table.rows[0])
        row[place.pop()] = cell_of(value, of)
        rows.append(tuple(row))
    return rows
