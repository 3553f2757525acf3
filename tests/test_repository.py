"""The files that a repository's visitors and its machines read: they are of their kind, and agree
with the package.
"""

import pathlib
import re
import tomllib

import pytest
from ruamel.yaml import YAML

import dhlab

ROOT = pathlib.Path(__file__).parents[1]
GITHUB = ROOT / ".github"
pytestmark = pytest.mark.skipif(not GITHUB.exists(), reason="no clone")


def read(path):
    return YAML(typ="safe").load(path.read_text(encoding="utf-8"))


def test_the_citation_names_this_version():
    assert read(ROOT / "CITATION.cff")["version"] == dhlab.__version__


def test_the_newest_changes_come_first():
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    versions = re.findall(r"^## \[(.+?)\]", text, re.MULTILINE)
    assert versions[0] == "Unreleased"
    assert versions[1:] == sorted(versions[1:], reverse=True)
    kinds = set(re.findall(r"^### (.+)", text, re.MULTILINE))
    assert kinds <= {"Added", "Changed", "Deprecated", "Removed", "Fixed", "Security"}


@pytest.mark.parametrize("name", ["bug", "wrong-feedback", "wrong-table"])
def test_a_form_asks_and_says_what_it_needs(name):
    form = read(GITHUB / "ISSUE_TEMPLATE" / f"{name}.yml")
    assert {"name", "description", "body"} <= form.keys()
    assert all(field["attributes"]["label"] for field in form["body"])
    assert len({field["id"] for field in form["body"]}) == len(form["body"])
    assert any(field.get("validations", {}).get("required") for field in form["body"])


@pytest.mark.parametrize("name", ["ci", "pages"])
def test_a_workflow_pins_its_actions_and_calls_what_we_call(name):
    jobs = read(GITHUB / "workflows" / f"{name}.yml")["jobs"]
    steps = [step for job in jobs.values() for step in job["steps"]]
    assert all(
        re.fullmatch(r"actions/[\w-]+@v\d+", step["uses"]) for step in steps if "uses" in step
    )
    assert all(job["timeout-minutes"] for job in jobs.values())
    commands = " ".join(step["run"] for step in steps if "run" in step)
    assert {"ci": ".ci/run", "pages": "make site"}[name] in commands
    for path in re.findall(r"\b(?:tests|dhlab|lessons)\b[\w/.]*", commands):
        assert (ROOT / path).exists(), path


def test_contributing_shows_the_rooms_as_they_are():
    """Its table, read from below, is the import checker's contract."""
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    table = text.partition("| room | what is in it |\n|---|---|\n")[2].partition("\n\n")[0]
    shown = [sorted(re.findall(r"`([\w]+)/?`", row.split("|")[1])) for row in table.splitlines()]
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    layers = settings["tool"]["importlinter"]["contracts"][0]["layers"]
    assert shown == [sorted(layer.split(" | ")) for layer in reversed(layers)]


def test_the_files_that_contributing_opens_are_there():
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    named = re.findall(r"`((?:dhlab|tests|docs|geometry|doctor|course|grading)/[\w/.]+)`", text)
    assert len(named) > 10
    for path in named:
        path = path.replace("NN", "05")
        assert (ROOT / path).exists() or (ROOT / "dhlab" / path).exists(), path
