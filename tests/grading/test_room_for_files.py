"""What a submission may leave on the disk: a limit for all its files together, at each level, and
no longer once it is gone.
"""

import json
import os
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import corpus

from dhlab.grading.cage import cage
from dhlab.grading.judging.questions import Course, request
from dhlab.grading.settings import Limits, Settings

LIMITS = Limits(cell_seconds=10, seconds=20, files_mb=4)
MANY_BYTES = """import time
for n in range(100):
    with open(f"f{n}", "wb") as file: file.write(bytes(1 << 20))
    time.sleep(0.02)
"""
MANY_NAMES = """import os, time
for n in range(5_600): os.close(os.open(f"f{n}", os.O_CREAT))
time.sleep(5)  # until it is seen that these are too many
"""
HIDDEN = """import os
try:
    for n in range(300): os.mkdir("d" * 200); os.chdir("d" * 200)
    os.chmod(".", 0)
except OSError: pass
"""


@pytest.mark.cage
@pytest.mark.parametrize("level", ["bubblewrap", "landlock", "rlimits"])
def test_files_are_counted_together_and_gone_afterwards(level):
    try:
        room = cage.Cage(level, LIMITS)
    except ValueError:
        pytest.skip(f"{level} does not work on this machine")
    asked = request(Course(("05",), Settings(limits=LIMITS), {}), 0)
    with room:
        for source in (MANY_BYTES, MANY_NAMES, HIDDEN):
            cells = [corpus.code(source), corpus.code("import os\nprint(os.listdir('.'))")]
            run = room.run(asked, json.dumps({"cells": cells}).encode(), LIMITS.seconds)
            own_file_system = level == "bubblewrap" and source == MANY_BYTES
            if own_file_system:  # it is full, and the cell stops with an error
                assert any(line.get("ended") == "error" for line in run.lines)
            elif source != HIDDEN:
                assert run.ended == "crashed" and run.cell == 0, run
            if level != "bubblewrap" and room._folder is not None:
                assert os.listdir(room._folder.work) == []
        left = corpus.code("import os\nassert not os.listdir('.'), os.listdir('.')")
        run = room.run(asked, json.dumps({"cells": [left]}).encode(), LIMITS.seconds)
        assert run.ended == "done" and not any("ended" in line for line in run.lines)
