"""``dhlab doctor program.py``: what is wrong with the programs for link matrices and forward
kinematics in a file.
"""

import contextlib
import io
import json
import traceback
from dataclasses import replace
from functools import partial
from types import ModuleType

import numpy as np

from ..formats.files import read_text
from ..table import DHTable
from .common import arm_of

__all__ = ["diagnose_program"]

# under these names programs are looked for
NAMES = {
    "dh_transform": ("dh_transform", "dh_matrix", "link_matrix", "link_transform"),
    "forward_kinematics": ("forward_kinematics", "fkine", "fk"),
}


def diagnose_program(path: str, arm: str, convention: str, as_json: bool) -> None:
    """Print what is wrong with each program of a file; ``arm`` is the name or the file of the one
    that it is written for, or empty; ``convention`` the one that it is to compute.
    """
    from ..doctor import diagnose_function

    module = _loaded(path)
    model = arm_of(arm) if arm else None

    def ask(f, kind):
        said = partial(diagnose_function, f, kind, convention=convention or "standard")
        answer = said(arm=model)
        if answer or model is None or answer.lines or len(answer.findings) == 1:
            return answer
        in_mm = said(arm=_in_millimetres(model))
        if not in_mm and in_mm.verdict != "explained":
            return answer
        return replace(in_mm, notes=(*in_mm.notes, MILLIMETRES))

    found = {
        name: ask(getattr(module, name), kind)
        for kind, names in NAMES.items()
        for name in names
        if callable(getattr(module, name, None))
    }
    if not found:
        raise ValueError(
            f"doctor: {path}: expected a function dh_transform(theta, d, a, alpha) or"
            " forward_kinematics(rows, q), found neither; give it that name"
        )
    if as_json:
        print(json.dumps({k: v.to_dict() for k, v in found.items()}, ensure_ascii=False))
        return
    print("\n\n".join(f"{name}: {answer}" for name, answer in found.items()))


MILLIMETRES = "The program reckons in millimetres, and was compared with the arm in millimetres."


def _in_millimetres(arm):
    """The arm with every length a thousand times as large."""
    t, far = arm.table, np.ones((4, 4))
    far[:3, 3] = 1000
    table = DHTable(t.convention, t.theta, 1000 * t.d, 1000 * t.a, t.alpha, t.joints)
    return replace(arm, table=table, base=far * arm.base, tool=far * arm.tool)


def _loaded(path):
    """The module in a file; what it prints is not shown, and what stops it is one sentence."""
    module, text = ModuleType("program"), read_text(path, "a program")
    module.__file__ = path
    try:
        with contextlib.redirect_stdout(io.StringIO()):
            exec(compile(text, path, "exec"), vars(module))
    except SyntaxError as error:
        raise ValueError(
            f"doctor: {path}, line {error.lineno}: Python cannot read this: {error.msg}; look at"
            " the brackets and commas there and in the line before"
        ) from None
    except (Exception, SystemExit) as error:
        lines = [f for f in traceback.extract_tb(error.__traceback__) if f.filename == path]
        where = f", line {lines[-1].lineno}" if lines else ""
        raise ValueError(
            f"doctor: {path}{where}: the file stops with {type(error).__name__}: {error}; a file"
            " that only defines functions can be looked at"
        ) from None
    return module
