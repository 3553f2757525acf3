"""What a cage may see of this machine: the system, Python and its packages; never dhlab itself, and
in the room ``OWN`` no other library that may know kinematics.
"""

import contextlib
import os
import re
import site
import sys
import sysconfig
from collections.abc import Iterable
from functools import cache
from pathlib import Path

__all__ = [
    "OPEN",
    "OWN",
    "SYSTEM",
    "packages",
    "packages_of_others",
    "readable",
    "hidden",
    "kept",
    "readable_without",
]

# the two rooms: one with the library, and one where kinematics is to be written oneself
OPEN, OWN = "open", "own"
PACKAGE = Path(__file__).parents[2]
# what may be imported in the second, with all that these need
ALLOWED = ("numpy", "scipy", "sympy", "matplotlib", "pandas", "ipython")
# large folders of a system in which no Python has its packages
WITHOUT_PYTHON = {"doc", "fonts", "help", "icons", "include", "locale", "man", "src", "zoneinfo"}
SYSTEM = (
    "/usr",
    "/lib",
    "/lib64",
    "/lib32",
    "/bin",
    "/etc/ld.so.cache",
    "/etc/localtime",
    "/etc/fonts",
)


def packages() -> list[str]:
    """The folders that Python finds packages in, those of this user left out."""
    found = [sysconfig.get_path("purelib"), sysconfig.get_path("platlib"), *site.getsitepackages()]
    return [
        folder for folder in dict.fromkeys(map(os.path.abspath, found)) if os.path.isdir(folder)
    ]


@cache
def packages_of_others() -> tuple[str, ...]:
    """The folders of packages of the machine's other Pythons, among what is readable: what stands
    there may know kinematics, and whoever names the folder could import it.
    """
    own = set(map(os.path.realpath, packages()))
    roots = {os.path.realpath(root) for root in readable()}
    tops = [root for root in roots if not any(str(p) in roots for p in Path(root).parents)]
    found = {folder for top in tops for folder in _packages_below(top)} - own
    found |= {folder for root in roots for folder in _checked_out(root)}
    return tuple(sorted({_covering(folder, own | roots) for folder in found}))


def _checked_out(root):
    """What pip has fetched from repositories and installed where it stands, in src of a Python."""
    with contextlib.suppress(OSError), os.scandir(os.path.join(root, "src")) as entries:
        for entry in entries:
            if entry.is_dir(follow_symlinks=False) and not _holds(entry.path, str(PACKAGE)):
                yield entry.path


def _holds(folder, path):
    return path == folder or path.startswith(folder + os.sep)


def _covering(folder, needed):
    """What the cage covers so that a folder is out of sight: where conda has it among hundreds, in
    ``pkgs`` or ``envs``, all of that at once, unless something that is needed stands there too. A
    cage cannot cover thousands one by one.
    """
    for parent in map(str, reversed(Path(folder).parents)):
        if os.path.basename(parent) in ("pkgs", "envs") and not any(
            one.startswith(parent + os.sep) for one in needed
        ):
            return parent
    return folder


def _packages_below(folder):
    """The folders of packages in a folder, wherever they stand: one Python has them in lib, conda
    in pkgs and envs too, pipx in venvs, and many a program brings a Python along.
    """
    left = [folder]
    while left:
        with contextlib.suppress(OSError), os.scandir(left.pop()) as entries:
            for entry in entries:
                if entry.name in WITHOUT_PYTHON or not entry.is_dir(follow_symlinks=False):
                    continue
                if entry.name.endswith("-packages"):
                    yield entry.path
                else:
                    left.append(entry.path)


@cache
def kept() -> tuple[str, ...]:
    """What stands in the folders of packages and may be seen in the room ``OWN``: what is allowed
    and what it needs, not what only an extra of theirs asks for (their own tests, and half of all
    there is).
    """
    found, wanted, known = {"__pycache__"}, [*ALLOWED], _installed()
    while wanted:
        path = known.pop(_plain(wanted.pop()), None)
        if path is not None:
            needed = [text for text in _requires(path) if "extra" not in text.partition(";")[2]]
            wanted += [re.split(r"[^\w.-]", text)[0] for text in needed]
            found |= _tops(path)
    return tuple(
        entry.path for folder in packages() for entry in os.scandir(folder) if entry.name in found
    )


def _installed():
    """Where each package's own account of itself stands, by its plain name; only those that are
    wanted are read, since all of them are long.
    """
    return {
        _plain(entry.name.partition("-")[0]): entry.path
        for folder in packages()
        for entry in os.scandir(folder)
        if entry.name.endswith((".dist-info", ".egg-info"))
    }


def _requires(path):
    """What a package needs. Of what it says of itself only the head is read, where there is one:
    what follows may be a book.
    """
    try:
        with open(os.path.join(path, "METADATA"), encoding="utf-8") as told:
            head = told.read().partition("\n\n")[0]
    except OSError:
        return _account(path).requires or ()
    return re.findall(r"^Requires-Dist: *(.+)", head, re.MULTILINE)


def _tops(path):
    """The files and folders that a package has put among the others. Thousands of lines list what
    is in them: only the beginnings are kept.
    """
    try:
        with open(os.path.join(path, "RECORD"), encoding="utf-8") as record:
            return {line.lstrip('"').partition("/")[0].partition(",")[0] for line in record}
    except OSError:
        return {file.parts[0] for file in _account(path).files or ()}


def _account(path):
    """What a package says of itself in another form than wheels do."""
    from importlib import metadata  # 1.6 MB, and hardly any package needs it

    return metadata.Distribution.at(path)


def _plain(name):
    return re.sub(r"[-_.]+", "-", name).lower()


def readable() -> list[str]:
    """What a submission may read besides the staged library: the system, Python, its packages;
    never the installed dhlab.
    """
    roots = [
        *SYSTEM,
        sys.base_prefix,
        sys.prefix,
        os.path.dirname(os.path.realpath(sys.executable)),
    ]
    # where Python was started by a path relative to this folder, the cage would not find it
    return [root for root in dict.fromkeys(map(os.path.abspath, roots)) if os.path.exists(root)]


def hidden() -> list[str]:
    """Where dhlab itself stands among what is readable, and what must therefore be covered."""
    roots = [os.path.realpath(root) for root in readable()]
    wanted = [str(PACKAGE), *(str(PACKAGE.parent / name) for name in ("solutions", "lessons"))]
    return [
        path
        for path in wanted
        if os.path.isdir(path)
        and any(os.path.realpath(path).startswith(root + os.sep) for root in roots)
    ]


def readable_without(covered: Iterable[str]) -> list[str]:
    """The readable paths with folders spread out wherever something in them must not be read:
    Landlock only allows.
    """
    real = {os.path.realpath(path) for path in covered}
    above = {str(parent) for path in real for parent in Path(path).parents}
    return [found for root in readable() for found in _spread(os.path.realpath(root), real, above)]


def _spread(path, covered, above):
    if path in covered:
        return []
    if path not in above:
        return [path]
    found = []
    for entry in os.scandir(path):
        real = os.path.realpath(entry.path)
        # lib64 is a link to lib: what is allowed by the one name is allowed by the other
        if not (entry.is_symlink() and real in above):
            found += _spread(real, covered, above)
    return found
