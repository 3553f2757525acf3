"""The files that the lessons read: URDF files of three arms, and a file of measured poses."""

from pathlib import Path

__all__ = ["example"]

FOLDER = Path(__file__).parent / "files"


def example(name: str) -> Path:
    """The path of a file that came with the course.

    Parameters
    ----------
    name : str
        Such as ``"ur5e.urdf"``.

    Returns
    -------
    Path

    Raises
    ------
    ValueError
        There is no such file; the sentence lists those there are.

    Examples
    --------
    >>> example("ur5e.urdf").name
    'ur5e.urdf'
    """
    known = sorted(path.name for path in FOLDER.iterdir() if path.suffix in (".urdf", ".csv"))
    if name not in known:
        raise ValueError(
            f"example: expected one of {', '.join(known)}, found {name!r}; a file of your own is"
            " named by its path, without example()"
        )
    return FOLDER / name
