"""The page to keep: whole, escaped, the same for the same data, asking nothing of the outside,
never over another file.
"""

import os
import re
from html.parser import HTMLParser

import numpy as np
import pytest

import dhlab as dh
from dhlab.course import report
from dhlab.robots import example

NASTY = "<script>alert(\"x\")</script> & 'arm'\n</title>"
VOID = {"meta", "img", "br"}


class Page(HTMLParser):
    """Tags in order, the text, and whether every tag that opens closes."""

    def __init__(self, html):
        super().__init__()
        self.open, self.tags, self.attributes, self.text, self.sound = [], [], [], [], True
        self.feed(html)

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        self.attributes += attributes
        self.open += [] if tag in VOID else [tag]

    def handle_endtag(self, tag):
        self.sound &= bool(self.open) and self.open.pop() == tag

    def handle_data(self, data):
        self.text.append(data)


@pytest.fixture(scope="module")
def sick():
    """A table with α6 wrong, measured poses, and what the doctor says."""
    q, poses = dh.read_poses(example("ar4-measured.csv"), 6, length="mm", angle="deg")
    rows = dh.load("ar4").table.rows
    rows[5, 3] = np.pi
    arm = dh.Arm(
        dh.DHTable.craig(rows, angle="rad"), sign=[-1, 1, 1, 1, 1, 1], name=NASTY, source=NASTY
    )
    return arm, dh.diagnose(arm, q, poses, noise=(5e-4, 2e-3))


@pytest.fixture(scope="module")
def page(sick):
    return report(*sick)


def test_the_page_is_whole_and_says_everything(page, sick):
    parsed = Page(page.html)
    words = " ".join(" ".join(parsed.text).split())
    assert (
        parsed.sound
        and parsed.open == []
        and parsed.tags.count("h1") == 1
        and parsed.tags.count("img") == 2
    )
    for wanted in (
        "The table",
        "The check",
        "10 poses, position and rotation compared",
        "The doctor's words",
        "The repaired table",
        *(text for _, text in sick[1]._lines()),
    ):
        assert " ".join(wanted.split()) in words, wanted
    assert words.count("0.16977") >= 2 and "180" in words and "−90" in words


def test_pictures_have_words(page):
    alts = [value for name, value in Page(page.html).attributes if name == "alt"]
    assert len(alts) == 2 and all(len(alt.split()) > 15 for alt in alts)


def test_what_a_user_wrote_is_only_text(page):
    parsed = Page(page.html)
    assert (
        "script" not in parsed.tags
        and parsed.tags.count("title") == 1
        and 'alert("x")' in " ".join(parsed.text)
    )
    assert not any(name.startswith("on") for name, _ in parsed.attributes)


def test_nothing_is_asked_of_the_outside(page):
    assert not re.search(
        r"https?://|//[a-z]|@import|url\(",
        re.sub(r"data:image/png;base64,[A-Za-z0-9+/=]+", "", page.html),
    )
    sources = [value for name, value in Page(page.html).attributes if name in ("src", "href")]
    assert sources and all(source.startswith("data:image/png;base64,") for source in sources)


def test_the_same_data_give_the_same_bytes(page, sick, tmp_path):
    page.save(tmp_path / "one.html")
    report(sick[0], sick[1]).save(tmp_path / "two.html")
    assert (tmp_path / "one.html").read_bytes() == (tmp_path / "two.html").read_bytes()
    assert not re.search(
        rb"/(tmp|work|home|root|Users)/|20[0-9][0-9]-[0-9][0-9]-",
        (tmp_path / "one.html").read_bytes().split(b"base64")[0],
    )


def test_an_existing_page_is_kept(page, tmp_path):
    file = tmp_path / "arm.html"
    file.write_text("my page of last year")
    with pytest.raises(ValueError, match="expected a new file"):
        page.save(file)
    assert file.read_text() == "my page of last year" and os.listdir(tmp_path) == ["arm.html"]
    page.save(file, overwrite=True)
    assert file.read_text(encoding="utf-8") == page.html


def test_in_a_notebook_it_stands_below_the_notebooks_headings(page):
    parsed = Page(page._repr_html_())
    assert (
        parsed.sound
        and not {"h1", "h2", "html", "body"} & set(parsed.tags)
        and {"h3", "h4"} <= set(parsed.tags)
    )


def test_positions_alone_are_said_to_be_that():
    arm = dh.load("cobra600")
    q = np.array([[0.3, 0.5, 0.1, 0.4], [0.0, 0.6, 0.0, -0.7], [-0.4, -0.8, 0.15, 1.2]])
    page = report(arm, dh.diagnose(arm, q, arm.forward(q)[:, :3, 3], noise=1e-3))
    assert (
        "3 poses, positions compared, rotations not; every joint away from 0 and right angles in 2"
        " of them." in str(page)
    )
    assert "The repaired table" not in page.html and "The table agrees" in page.html


def test_an_arm_without_a_name():
    arm = dh.Arm(dh.load("ur5e").table)
    q = np.full((1, 6), 0.4)
    assert "An arm without a name" in str(
        report(arm, dh.diagnose(arm, q, arm.forward(q)))
    ) and "1 pose," in str(report(arm, dh.diagnose(arm, q, arm.forward(q))))


@pytest.mark.parametrize("name", ["arm.pdf", "arm", "arm.html.txt"])
def test_another_ending_is_refused(page, tmp_path, name):
    with pytest.raises(ValueError, match="ends in .html"):
        page.save(tmp_path / name)
    assert os.listdir(tmp_path) == []


def test_a_missing_folder_is_one_sentence(page, tmp_path):
    with pytest.raises(ValueError, match="choose another folder"):
        page.save(tmp_path / "nowhere" / "arm.html")


def test_wrong_arguments(sick):
    arm, diagnosis = sick
    for bad in (
        (arm.table, diagnosis),
        (arm, None),
        (arm, "agrees"),
        (arm, dh.doctor.Diagnosis("agrees", "Yes.")),
    ):
        with pytest.raises(ValueError, match="^report: expected"):
            report(*bad)
    with pytest.raises(ValueError, match="another table"):
        report(dh.load("ur5e"), diagnosis)
