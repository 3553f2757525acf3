"""The package as a user meets it: its name, what is in the wheel, and the commands from the wheel
alone.
"""

import email
import importlib.metadata
import os
import pathlib
import re
import socket
import subprocess
import sys
import sysconfig
import tarfile
import time
import urllib.request
import venv
import zipfile

import pytest

import dhlab
from dhlab.grading.exports.gradescope import export_gradescope

ROOT = pathlib.Path(__file__).parents[1]
NAME = "dhlab-kinematics"
OURS = ("dhlab", "lessons")
NOT_SHIPPED = ("__pycache__", "node_modules", "js")


def canonical(requirement):
    """The name of a distribution in a requirement, as PyPI compares names."""
    return re.sub(r"[-_.]+", "-", re.match(r"[\w.-]+", requirement)[0]).lower()


@pytest.fixture(scope="session")
def built(tmp_path_factory):
    """The folder with the sdist, and the wheel that was made of it."""
    for tool in ("build", "hatchling", "twine"):
        pytest.importorskip(tool, reason=f"{tool} is not installed; the extra package has it")
    out = tmp_path_factory.mktemp("dist")
    run([sys.executable, "-m", "build", "--no-isolation", "--outdir", str(out), str(ROOT)])
    return out


@pytest.fixture(scope="session")
def wheel(built):
    """The wheel's file."""
    return next(built.glob("*.whl"))


@pytest.fixture(scope="session")
def python(wheel, tmp_path_factory):
    """An environment with the wheel; its other packages are those of these tests, dhlab is not."""
    home = tmp_path_factory.mktemp("installed") / "venv"
    venv.create(home)
    scripts = home / ("Scripts" if os.name == "nt" else "bin")
    program = scripts / pathlib.Path(sys.executable).name
    program = program if program.exists() else scripts / "python"
    pip = [sys.executable, "-m", "pip", "--python", str(program), "install", "--quiet"]
    run([*pip, "--no-deps", "--no-index", "--no-compile", str(wheel)])
    purelib = run([str(program), "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"])
    shared = {sysconfig.get_path("purelib"), sysconfig.get_path("platlib")}
    pathlib.Path(purelib.strip(), "shared.pth").write_text("\n".join(shared), encoding="utf-8")
    return program


def clean(**more):
    """The environment of a user who has set nothing."""
    return {k: v for k, v in os.environ.items() if not k.startswith("PYTHON")} | more


def run(command, **options):
    """What a command prints; the test fails with its words when it does."""
    done = subprocess.run(command, capture_output=True, text=True, env=clean(), **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def installed(python, folder, *words, **environment):
    """``dhlab`` with these words, from the wheel, in a folder."""
    script = python.with_name("dhlab.exe" if os.name == "nt" else "dhlab")
    return subprocess.run(
        [str(script), *words], cwd=folder, capture_output=True, text=True, env=clean(**environment)
    )


def needed(name, seen):
    """Every distribution that one asks for, whatever the extra or the machine, and theirs."""
    try:
        lines = importlib.metadata.requires(name) or []
    except importlib.metadata.PackageNotFoundError:
        return
    for other in {canonical(line) for line in lines} - seen:
        seen.add(other)
        needed(other, seen)


def test_no_other_dhlab_is_ever_asked_for(wheel):
    with zipfile.ZipFile(wheel) as archive:
        name = next(name for name in archive.namelist() if name.endswith("/METADATA"))
        metadata = email.message_from_bytes(archive.read(name))
    assert metadata["Name"] == NAME
    assert metadata["Version"] == dhlab.__version__
    lines, extras = metadata.get_all("Requires-Dist"), metadata.get_all("Provides-Extra")
    names = {canonical(line) for line in lines}
    for other in tuple(names - {NAME}):
        needed(other, names)
    assert "dhlab" not in names, "on PyPI that is another project"
    assert {"numpy", "jupyterlab"} <= names
    for line in lines:
        if canonical(line) == NAME:
            assert set(re.search(r"\[(.*?)\]", line)[1].split(",")) <= set(extras), line


def test_gradescope_asks_for_no_other_dhlab(tmp_path):
    export_gradescope(tmp_path / "autograder.zip")
    with zipfile.ZipFile(tmp_path / "autograder.zip") as archive:
        lines = archive.read("requirements.txt").decode().splitlines()
        assert "dhlab/__init__.pyi" in archive.namelist(), "the library reads its names from it"
    names = {canonical(line) for line in lines}
    assert {"numpy", "scipy", "lazy-loader", "sympy"} <= names
    assert not names & {"dhlab", NAME}, "the library itself lies in the archive"
    assert all(re.fullmatch(r"[\w.-]+==\S+", line) for line in lines)


def test_no_text_tells_to_install_the_other_project():
    pages = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *(ROOT / "docs").rglob("*.md")]
    pages += [path for folder in ("dhlab", "docs") for path in (ROOT / folder).rglob("*.py")]
    pages += [*(ROOT / "solutions").glob("*.md")]
    other = re.compile(r"""pip install\b[^\n`;]*?["' ]dhlab(?![-_\w])|version\(["']dhlab["']\)""")
    assert all(other.search(text) for text in ("pip install 'dhlab[lab]'", "pip install -U dhlab"))
    found = {p.name: other.findall(p.read_text(encoding="utf-8")) for p in pages}
    assert {name: words for name, words in found.items() if words} == {}
    assert f"pip install {NAME}" in (ROOT / "README.md").read_text(encoding="utf-8")


def test_both_files_pass_twine(built):
    files = [str(path) for path in sorted(built.iterdir())]
    assert [re.sub(r".*0", "", file) for file in files] == ["-py3-none-any.whl", ".tar.gz"]
    assert run([sys.executable, "-m", "twine", "check", "--strict", *files]).count("PASSED") == 2


def test_the_sdist_and_the_clone_make_the_same_wheel(wheel, tmp_path):
    command = [sys.executable, "-m", "build", "--no-isolation", "--wheel"]
    run([*command, "--outdir", str(tmp_path), str(ROOT)])
    with zipfile.ZipFile(wheel) as one, zipfile.ZipFile(tmp_path / wheel.name) as other:
        assert {i.filename: i.CRC for i in one.infolist()} == {
            i.filename: i.CRC for i in other.infolist()
        }


def test_the_wheel_has_the_library_and_the_lessons_and_no_solutions(wheel):
    wanted = {
        path.relative_to(ROOT).as_posix()
        for folder in OURS
        for path in (ROOT / folder).rglob("*")
        if path.is_file() and not set(path.parts) & set(NOT_SHIPPED)
    }
    with zipfile.ZipFile(wheel) as archive:
        names = {name for name in archive.namelist() if ".dist-info/" not in name}
        for path in (ROOT / "lessons").iterdir():
            assert archive.read(f"dhlab/lessons/{path.name}") == path.read_bytes()
    assert names == {re.sub(r"^lessons/", "dhlab/lessons/", name) for name in wanted}
    assert not [name for name in names if set(name.split("/")[:-1]) & {"solutions", "teacher"}]


def test_the_sdist_has_what_makes_the_wheel(built):
    with tarfile.open(next(built.glob("*.tar.gz"))) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    top = {name.split("/")[0] for name in names}
    files = {"README.md", "LICENSE", "CHANGELOG.md", "CITATION.cff", "constraints.txt"}
    assert top == {*OURS, *files, "pyproject.toml", "PKG-INFO", ".gitignore"}
    assert "dhlab/view/explorer/js/package.json" in names
    assert not [name for name in names if "node_modules" in name or "__pycache__" in name]


def test_the_commands_from_the_wheel_in_any_folder(python, tmp_path):
    found = run([str(python), "-c", "import dhlab; print(dhlab.__file__)"], cwd=tmp_path)
    assert pathlib.Path(found.strip()).is_relative_to(python.parents[1])
    assert installed(python, tmp_path, "--version").stdout.strip() == dhlab.__version__
    fk = installed(python, tmp_path, "fk", "ur5e", "--q", "0,0,0,0,0,0", "--deg")
    assert "-0.8172" in fk.stdout, fk.stderr
    dhlab.load("article-6r").save(tmp_path / "arm.yaml")
    poses = "q1,q2,q3,q4,q5,q6,x,y,z\n" + "".join(
        ",".join(map(repr, [*q, *dhlab.load("article-6r").forward(q)[:3, 3].tolist()])) + "\n"
        for q in ([0.1 * k, 0.2, -0.3 * k, 0.4, 0.1 * k * k, 0.5] for k in range(8))
    )
    (tmp_path / "poses.csv").write_text(poses, encoding="utf-8")
    doctor = installed(python, tmp_path, "doctor", "arm.yaml", "poses.csv", "--units", "m,rad")
    assert "agree" in doctor.stdout, doctor.stdout + doctor.stderr


def answered(address, process, log):
    """The status of the first answer from a server that is starting."""
    for _ in range(600):
        try:
            with urllib.request.urlopen(address, timeout=60) as answer:
                return answer.status
        except OSError:
            assert process.poll() is None, log.read_text(encoding="utf-8")
            time.sleep(0.2)
    return pytest.fail(log.read_text(encoding="utf-8"))


def test_the_lab_from_the_wheel(python, tmp_path):
    """It opens on a folder with the lessons, and hands one out."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    script = str(python.with_name("dhlab.exe" if os.name == "nt" else "dhlab"))
    command = [script, "lab", "course", "--no-browser", "--port", str(port)]
    environment, log = clean(JUPYTER_TOKEN="open"), tmp_path / "lab.log"
    with open(log, "w") as out:
        process = subprocess.Popen(command, cwd=tmp_path, stdout=out, stderr=out, env=environment)
    try:
        lesson = f"http://127.0.0.1:{port}/api/contents/05-link-matrix.ipynb?content=0&token=open"
        assert answered(lesson, process, log) == 200
    finally:
        process.terminate()
        process.wait(60)
    with socket.socket() as asked:
        assert asked.connect_ex(("127.0.0.1", port)) != 0, "the lab outlives its command"
    names = {path.name for path in (tmp_path / "course").glob("*.ipynb")}
    assert names == {path.name for path in (ROOT / "lessons").glob("*.ipynb")}


def test_the_lab_without_its_extra_is_one_sentence(python, tmp_path):
    (tmp_path / "sitecustomize.py").write_text("import sys; sys.modules['jupyterlab'] = None\n")
    done = installed(python, tmp_path, "lab", PYTHONPATH=str(tmp_path))
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.strip().splitlines() == [
        "dhlab: lab: expected JupyterLab, found that it is not installed; run: pip install"
        f' "{NAME}[lab]"'
    ]
    assert not (tmp_path / "my-course").exists()


@pytest.mark.slow
def test_jupyter_works_without_what_make_lab_leaves_out():
    """With these modules out of reach, what the lab starts is still there, and a name completed."""
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    spared = re.search(r"^SPARED := (.+)$", makefile, re.MULTILINE)[1].split()
    assert {"jedi", "debugpy"} <= set(spared)
    code = f"""
import sys
sys.modules.update(dict.fromkeys({spared}))
import ipykernel.kernelapp, jupyter_lsp, jupyter_server_terminals, jupyterlab.labapp, nbconvert
from IPython.core.interactiveshell import InteractiveShell
shell = InteractiveShell.instance()
shell.run_cell("import dhlab as dh; arm = dh.load('ur5e'); widget = dh.explore(arm)").raise_error()
print(shell.complete("arm.table.alph")[1])
"""
    told = run([sys.executable, "-c", code])
    assert ".alpha'" in told.splitlines()[-1]
