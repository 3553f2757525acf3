"""Which answers make a program while they run, from a text, from bytes or from a file that they
write: what runs then stands nowhere in the notebook, and is compared with nobody's.
"""

import re
import sys
from collections.abc import Mapping

from .alike import APART, tokens_of

__all__ = ["made_while_running"]

# functions and modules that make programs, or reach those that do; as attributes of something else,
# as in re.compile, they are other things
MAKERS = frozenset(
    """exec eval compile marshal pickle dill cloudpickle FunctionType CodeType __import__ importlib
    import_module runpy run_path run_module linecache ctypes builtins __builtins__ get_ipython
    _getframe codeop cProfile bdb pdb doctest get_type_hints""".split()
)
# the same of whatever it is an attribute
INNER = frozenset(
    """__code__ __globals__ __subclasses__ __builtins__ allow_pickle modules runctx runsource
    runcode InteractiveInterpreter InteractiveConsole get_type_hints""".split()
)
# what only asks whether a package is there, or brings one: Colab's notebooks often begin so
ASKS = re.compile(
    r"""\bin\s+sys\.modules\b(?![\s\\]*[.\[])
    | \bimportlib\.util\.find_spec\(\s*["'][\w.]+["']\s*\)(?=\s*(?:is\b|:))
    | \bimportlib\.metadata\.version\b
    | ^[ \t]*import[ \t]+(?:sys[ \t]*,[ \t]*)?importlib\.(?:util|metadata)[ \t]*$
    | \bget_ipython\(\)\.(?:system\(|run_line_magic\(\s*["'](?:matplotlib|config|pip)["'])""",
    re.MULTILINE | re.VERBOSE,
)
# names of these that are imported, and need no attribute
IMPORTED = re.compile(
    r"^[ \t]*from[ \t]+(?:sys[ \t]+import[ \t]*\*|[\w.]+[ \t]+import\b(?:[^\n(]*|[ \t]*\([^()]*)"
    rf"\b(?:{'|'.join(sorted(INNER))})\b)",
    re.MULTILINE,
)
WRITERS = frozenset("open Path write_text write_bytes tofile savetxt dump".split())
IMPORT = re.compile(r"^[ \t]*(?:from[ \t]+(\w+)|import[ \t]+([^\n#]+))", re.MULTILINE)
# beside Python's own
PACKAGES = frozenset(
    """IPython PIL dhlab google ipywidgets matplotlib numba numpy pandas plotly scipy seaborn sympy
    tqdm""".split()
)


def made_while_running(codes: Mapping[str, str]) -> list[str]:
    """The exercises whose code makes a program while it runs, in their order.

    Parameters
    ----------
    codes : mapping of str to str
        The code of each exercise, as :func:`dhlab.grading.reports.alike.answers` gives it.

    Examples
    --------
    >>> made_while_running({"05.4": "exec(f'{a}')", "05.6": "p = re.compile('exec')"})
    ['05.4']
    >>> made_while_running({"05.4": "open('m.py', 'w').write(a)", "05.6": "from m import f"})
    ['05.4', '05.6']
    """
    read = {exercise: tokens_of(ASKS.sub("0", code)) for exercise, code in codes.items()}
    makes = {
        exercise
        for exercise, found in read.items()
        if any(text in (MAKERS if kind == "name" else INNER) for kind, text in found)
        or IMPORTED.search(codes[exercise])
    }
    writes = {
        exercise
        for exercise, found in read.items()
        if not WRITERS.isdisjoint(text for _, text in found)
    }
    imports = {exercise for exercise, code in codes.items() if _imports_its_own(code)}
    if writes and imports:
        makes |= writes | imports
    return [exercise for exercise in codes if exercise in makes]


def _imports_its_own(code):
    """Whether it imports what is neither Python's nor a package that lessons are done with."""
    named = " , ".join(one or more for one, more in IMPORT.findall(code.replace(APART, "\n")))
    modules = {words.split()[0].partition(".")[0] for words in named.split(",") if words.strip()}
    return not modules <= sys.stdlib_module_names | PACKAGES
