"""Broken files: one plain sentence each, from a terminal and from Python. The cases are made in
``benchmarks/bad_input.py``, which tries all of them; here some of every file.
"""

import importlib.util
from pathlib import Path

import pytest
from draws import few

import dhlab as dh

HOME = Path(__file__).parents[1] / "benchmarks" / "bad_input.py"
pytestmark = pytest.mark.skipif(not HOME.exists(), reason="no clone")
if HOME.exists():
    made = importlib.util.spec_from_file_location("bad_input", HOME)
    bad_input = importlib.util.module_from_spec(made)
    made.loader.exec_module(bad_input)
    CASES = few(bad_input.cases(), 50)
else:
    CASES = []


@pytest.mark.parametrize("name, file, raw, line", CASES, ids=[case[0][:90] for case in CASES])
@pytest.mark.filterwarnings("ignore")
def test_a_broken_file_is_one_plain_sentence(name, file, raw, line, tmp_path):
    assert list(bad_input.faults(name, file, raw, line, tmp_path)) == []


def test_what_is_only_unusual_is_read(tmp_path):
    for file, texts in bad_input.READ.items():
        for raw in texts:
            (tmp_path / file).write_bytes(raw)
            assert len(dh.load(tmp_path / file)) == 2
    (tmp_path / "arm.urdf").write_bytes(bad_input.READ["arm.urdf"][0])
    assert dh.load(tmp_path / "arm.urdf").name == "zwö"
