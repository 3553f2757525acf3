"""The verb ``dhlab convert``: the same arm in the other convention."""

from .common import ArmName, Convention, Json, NewTable, arm_of, give

__all__ = ["convert"]


def convert(arm: ArmName, to: Convention, out: NewTable = "", as_json: Json = False) -> None:
    """The same arm in the other convention: the same pose for every q, exactly."""
    give(arm_of(arm).to(to), out, as_json)
