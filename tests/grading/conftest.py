"""What the tests of grading share."""

import pytest

from dhlab.grading import grade
from dhlab.grading.judging import running


@pytest.fixture(scope="module")
def kept_cages():
    """The cages of one class serve the next one of the file, where the lessons are the same: a
    cage is made for submissions that know nothing of each other, and to start two of them takes
    longer than to run a class of ten. Without this fixture ``grade`` closes its cages, by what this
    gives.
    """
    close = running.close
    with pytest.MonkeyPatch.context() as patched:
        for module in (grade, running):
            patched.setattr(module, "close", lambda: None)
        yield close
    close()
