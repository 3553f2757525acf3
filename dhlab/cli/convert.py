"""The verb ``dhlab convert``: the same arm in the other convention."""

from ..robots import load
from .common import ArmName, Convention, Json, NewTable, give

__all__ = ["convert"]


def convert(arm: ArmName, to: Convention, out: NewTable = "", as_json: Json = False) -> None:
    """The same arm in the other convention: the same pose for every q, exactly."""
    give(load(arm).to(to), out, as_json)
