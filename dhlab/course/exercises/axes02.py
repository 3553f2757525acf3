"""What 02.1 asks: about and along which arrow each of the four numbers is measured."""

from ..kinds import Known, Said
from .answers02 import ENTRIES

__all__ = ["MEASURED", "explain_axes"]

MEASURED = ["about-old-z", "along-old-z", "along-new-x", "about-new-x"]  # θ, d, a, α

ANGLES = ("about-old-z", "about-new-x", "about-new-z")

LEFT_OVER = {"about-new-z": "θ", "along-old-x": "a"}  # with the number that each imitates


def explain_axes(order: list[str]) -> Known | None:
    given = dict(zip(ENTRIES, order))
    wrong = [name for name, way, wanted in zip(ENTRIES, order, MEASURED) if way != wanted]
    imitated = [name for name in wrong if LEFT_OVER.get(given[name]) == name]
    if imitated == wrong:
        return "measured-in-other-frame", Said(
            "the right kind of number, on the wrong plate",
            place=", ".join(imitated),
            next="θ and d share one arrow, a and α another. Which plate's?",
        )
    exchanged = [
        name
        for name, way, wanted in zip(ENTRIES, order, MEASURED)
        if (way in ANGLES) != (wanted in ANGLES)
    ]
    if exchanged:
        return "columns-misread", Said(
            "an angle stands for a length, or a length for an angle",
            place=", ".join(exchanged),
            next="Greek letters are angles, Latin ones are lengths.",
        )
    theta, d, a, alpha = MEASURED
    if order == [alpha, d, a, theta]:
        return "theta-alpha-exchanged", Said(
            "θ and α have changed places", next="Which of the two turns about old z?"
        )
    if order == [theta, a, d, alpha]:
        return "a-d-exchanged", Said(
            "d and a have changed places", next="Which of the two goes along old z?"
        )
    return "columns-misread", Said(
        "the right kinds of numbers, along or about the wrong arrows",
        place=", ".join(wrong),
        next="Read the four lines below the picture once more.",
    )
