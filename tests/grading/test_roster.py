"""The roster: as spreadsheets write it, and what is wrong with one in a sentence with its line."""

import csv
import io

import pytest

from dhlab.grading.intake.roster import Student, read_roster
from dhlab.grading.results.csvtext import csv_text


def roster(tmp_path, text, encoding="utf-8"):
    path = tmp_path / "roster.csv"
    path.write_bytes(text.encode(encoding))
    return read_roster(path)


@pytest.mark.parametrize(
    "text, encoding",
    [
        ("student,name,email,language\nada,Ada L.,ada@x.org,zh-CN\nbo,,,\n", "utf-8"),
        ("\ufeffstudent;name;email;language\r\nada;Ada L.;ada@x.org;zh\r\nbo;;;\r\n", "utf-8"),
        ("sep=;\r\nstudent;name;email;language\r\nada;Ada L.;ada@x.org;zh\r\nbo;;;\r\n", "utf-8"),
        (
            'Name, Student ,group,EMAIL,language\n"Ada L.", ada ,3,ada@x.org,zh_CN\n\n,bo,,,\n',
            "utf-8-sig",
        ),
    ],
)
def test_what_spreadsheets_write_is_read(tmp_path, text, encoding):
    assert roster(tmp_path, text, encoding) == (
        Student("ada", "Ada L.", "ada@x.org", "zh_CN"),
        Student("bo"),
    )


def test_names_may_be_anything(tmp_path):
    text = (
        "student,name\ns1,<script>alert(1)</script>\ns2,\"=cmd|'/c"
        ' calc\'!A1"\ns3,"Line\nbreak"\n李,李小龙\nada@x.org,"O\'Neil, ""Bo"""\n'
    )
    found = roster(tmp_path, text)
    assert [s.student for s in found] == ["s1", "s2", "s3", "李", "ada@x.org"] and found[
        4
    ].name == 'O\'Neil, "Bo"'


@pytest.mark.parametrize(
    "text, words",
    [
        ("", "column names"),
        ("student,Name,name\nada,Lovelace,Ada\n", "line 1: expected every column once"),
        ("sep=;\nstudent;name\na/b;Ada\n", "line 3"),
        ("name\nada\n", 'one column "student"'),
        ("student,student\na,b\n", 'one column "student"'),
        ("student\n", "found none"),
        ("student\nada\nADA\n", "every id once"),
        ("student\n1\n1\n", "every id once"),
        ("student,name\n,Ada\n", "line 2"),
        ("student\n../../etc/passwd\n", "names files"),
        ("student\na/b\n", "names files"),
        ("student\n.hidden\n", "names files"),
        ("student\nends.\n", "names files"),
        ("student\n-rf\n", "names files"),
        ("student\n=1+1\n", "names files"),
        ("student\na\0b\n", "expected"),
        ("student\n" + "a" * 101 + "\n", "names files"),
        ("student\nCON:\n", "names files"),
        ("student,language\nada,klingon!\n", "language"),
        (
            "Student,ID,SIS Login ID,Section,05\n    Points Possible,,,,12\nCher,77,cher,A,\n",
            'Canvas\'s gradebook, where it holds names; call it "name"',
        ),
    ],
)
def test_what_is_wrong_is_said_in_one_sentence(tmp_path, text, words):
    with pytest.raises(ValueError, match=words) as error:
        roster(tmp_path, text)
    assert "\n" not in str(error.value) and str(error.value).startswith(str(tmp_path))


def test_other_encodings_are_named(tmp_path):
    with pytest.raises(ValueError, match="UTF-8"):
        roster(tmp_path, "student,name\nli,李小龙\n", "gbk")


@pytest.mark.parametrize(
    "text",
    [
        "=1+1",
        "+1",
        "-1",
        "@SUM(A1)",
        "\t=1",
        "\r=1",
        "\n=1",
        " =1",
        '=HYPERLINK("http://x")',
        "＝1+1",
    ],
)
def test_no_cell_is_a_formula(text):
    [[cell, number]] = csv.reader(io.StringIO(csv_text([[text, -1.5]]), newline=""))
    assert cell[0] == "'" and number == "-1.5"
    assert cell.replace("'", "") == text.replace("\r", "\n").replace("'", "")


def test_plain_cells_stay_as_they_are():
    rows = [["ada", "Ada, L.", 'say "a"', "李", "a=b", "", "1-2"]]
    assert list(csv.reader(io.StringIO(csv_text(rows), newline=""))) == rows
