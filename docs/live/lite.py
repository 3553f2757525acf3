"""JupyterLite with the course: JupyterLab in the browser, whole, from this site's files alone.

``make site LIVE=1`` builds it into ``html/lab``; its Python takes the packages of ``html/live`` and
adds what IPython and widgets need. All of it is pinned in ``packages.toml``.
"""

import hashlib
import json
import re
import shutil
import sys
import tempfile
import venv
import zipfile
from pathlib import Path

import gather

__all__ = ["lite"]

KERNEL = "@jupyterlite/pyodide-kernel-extension"
UNWINDOWED = {"windowingMode": "none"}
OWN = ("piplite-", "ipykernel-", "pyodide_kernel-", "widgetsnbextension-4")
# what a page fetches of dhlab, and the modules that a notebook's widgets read
LEFT_OUT = re.compile(r"(^|/)(grading|building|js|node_modules|__pycache__)/")


def lite(html, lock):
    """JupyterLite into ``html/lab``, once ``html/live`` is there."""
    tools, out = _tools(lock["lite"]), html / "lab"
    gather.fetch_pure(lock["wheels"]["lite"])
    shutil.rmtree(out, ignore_errors=True)
    with tempfile.TemporaryDirectory() as folder:
        lessons = Path(folder, "files")
        shutil.copytree(gather.PACKAGE.parent / "lessons", lessons)
        packages = _python(html, out / "pyodide", tools, lock)
        shutil.move(out / "pyodide", Path(folder, "pyodide"))
        _say(Path(folder, "jupyter-lite.json"), packages)
        command = [tools / "bin" / "jupyter", "lite", "build", "--lite-dir", ".", "--no-sourcemaps"]
        gather.run([*map(str, command), "--contents", "files", "--output-dir", str(out)], folder)
        shutil.move(Path(folder, "pyodide"), out / "pyodide")


def _tools(wanted):
    """An environment with what builds JupyterLite, made once for these versions."""
    digest = hashlib.sha256(json.dumps(wanted).encode()).hexdigest()[:8]
    folder = gather.CACHE.parent / f"lite-{digest}"
    if not (folder / "done").exists():
        venv.create(folder, clear=True, with_pip=True)
        pip = [str(folder / "bin" / "python"), "-m", "pip", "install", "--quiet"]
        gather.run([*pip, *wanted["tools"]], folder)
        gather.run([*pip, "--no-deps", *wanted["views"]], folder)
        (folder / "done").touch()
    return folder


def _python(html, out, tools, lock):
    """Pyodide as it was published, and a lock file of every wheel; the names of all packages."""
    out.mkdir(parents=True)
    for name in gather.CORE:
        shutil.copy(gather.CACHE / name, out)
    for file, _ in lock["wheels"]["lite"].values():
        shutil.copy(gather.CACHE / file, out)
    own = tools / "share" / "jupyter" / "labextensions" / KERNEL / "static" / "pypi"
    for path in own.glob("*.whl"):
        if path.name.startswith(OWN):
            shutil.copy(path, out)
    files = {
        path.relative_to(gather.PACKAGE.parent).as_posix(): path.read_bytes()
        for path in sorted(gather.PACKAGE.rglob("*"))
        if path.is_file()
    }
    gather.zipped(
        out / "dhlab-0-own.zip", {n: d for n, d in files.items() if not LEFT_OUT.search(n)}
    )
    found = [*out.glob("*.whl"), *out.glob("*.zip"), *(html / "live").glob("*.whl")]
    packages = dict(_entry(path, out) for path in sorted(found) if path.name not in gather.CORE)
    info = {"abi_version": "2026_0", "arch": "wasm32", "platform": "emscripten_5_0_3"}
    info |= {"python": "3.14.0", "version": lock["pyodide"]["npm"].rpartition("@")[2]}
    text = json.dumps({"info": info, "packages": packages}, indent=1)
    (out / "pyodide-lock.json").write_text(text, encoding="utf-8")
    return sorted(packages)


def _entry(path, out):
    """What Pyodide's lock file says of a wheel."""
    name, version = path.name.split("-")[:2]
    with zipfile.ZipFile(path) as held:
        imports = {
            re.sub(r"(/__init__)?\.py$", "", entry)
            for entry in held.namelist()
            if re.fullmatch(r"[A-Za-z_]\w*(/__init__)?\.py", entry)
        }
    name = re.sub(r"[-_.]+", "-", name).lower()
    return name, {
        "name": name,
        "version": version,
        "file_name": path.name if path.parent == out else f"../../live/{path.name}",
        "install_dir": "site",
        "sha256": hashlib.sha256(path.read_bytes()).hexdigest(),
        "package_type": "package",
        "imports": sorted(imports),
        "depends": [],
        "unvendored_tests": False,
    }


def _say(path, packages):
    """JupyterLite's settings: Python from here, with all packages, and nothing from PyPI."""
    kernel = {
        "pyodideUrl": "./pyodide/pyodide.mjs",
        "disablePyPIFallback": True,
        "loadPyodideOptions": {"packages": packages},
    }
    settings = {"appName": "dhlab", "litePluginSettings": {f"{KERNEL}:kernel": kernel}}
    # an explorer that is scrolled out of sight stays as hands left it
    settings["settingsOverrides"] = {"@jupyterlab/notebook-extension:tracker": UNWINDOWED}
    data = {"jupyter-lite-schema-version": 0, "jupyter-config-data": settings}
    path.write_text(json.dumps(data), encoding="utf-8")


if __name__ == "__main__":
    lite(Path(sys.argv[1]).resolve(), gather.pinned())
