"""A xacro file expanded into plain URDF, by the package xacro (extra ``[urdf]``)."""

from __future__ import annotations

import contextlib
import io
from collections.abc import Mapping
from pathlib import Path

__all__ = ["expanded"]

INSTALL = "pip install xacro, or expand it elsewhere: xacro file.urdf.xacro > file.urdf"


def expanded(
    path: str | Path,
    arguments: Mapping[str, object] | None = None,
    packages: Mapping[str, str | Path] | None = None,
) -> str:
    """The URDF text that xacro makes of a file.

    Parameters
    ----------
    path : str or path
    arguments : dict, optional
        What ``$(arg name)`` stands for.
    packages : dict, optional
        From the name in ``$(find name)`` to its folder; others are looked for above the file and
        beside the folders above it, where a workspace has them.

    Raises
    ------
    ValueError
        xacro is not installed, or cannot expand the file: one sentence.
    """
    try:
        import xacro
        from xacro import substitution_args
    except ImportError:
        raise ValueError(
            f"{path}: expected a URDF file, found xacro macros in it; to have them expanded,"
            f" {INSTALL}"
        ) from None
    folders = {name: Path(folder) for name, folder in (packages or {}).items()}
    before = substitution_args._eval_find, substitution_args._eval_dict["find"]

    unfound: list[str] = []

    def find(name):
        folder = _folder(name, Path(path), folders)
        if folder is None:  # harmless in the name of a mesh; an include will miss it
            unfound.append(name)
            return f"/package/{name}"
        return str(folder)

    # xacro asks ROS where a package is; here there may be no ROS, and the file's own place tells
    substitution_args._eval_find = substitution_args._eval_dict["find"] = find
    given = {name: str(value) for name, value in (arguments or {}).items()}
    try:
        with contextlib.redirect_stderr(io.StringIO()):  # its warnings are for the file's author
            return xacro.process_file(str(path), mappings=given).toxml()
    except Exception as error:  # of any kind: the file's expressions are evaluated
        raise ValueError(f"{path}: {_said(error, unfound)}") from None
    finally:
        substitution_args._eval_find, substitution_args._eval_dict["find"] = before


def _folder(name, path, known):
    if name in known:
        return known[name]
    for above in path.resolve().parents:
        for folder in (above, above / name):
            if folder.name == name and folder.is_dir():
                return folder
    return None


def _said(error, unfound):
    """What went wrong in xacro, and what to do."""
    inner = error
    while getattr(inner, "exc", None) is not None:
        inner = inner.exc
    if unfound:
        return (
            f"expected the package {unfound[-1]} in a folder of that name above the file or beside"
            " it, found none; say where it is:"
            f" --package {unfound[-1]}=FOLDER (packages= in Python)"
        )
    if type(inner).__name__ in (
        "ArgException",
        "UndefinedArgument",
    ) or "Undefined substitution" in (str(inner)):
        name = str(inner).split()[-1]
        return (
            f"expected a value for the xacro argument {name}, found none; give it: --arg"
            f" {name}=VALUE (arguments= in Python)"
        )
    words = " ".join(str(error).split())[:200] or type(inner).__name__
    return (
        f"expected a file that xacro can expand, found that it cannot: {words}; correct the file,"
        " or expand it elsewhere"
    )
