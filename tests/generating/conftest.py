"""gcc, for what is compiled here."""

import os
import shutil

import pytest


@pytest.fixture(scope="session")
def gcc():
    """The path of gcc; what needs it is skipped, saying so, where there is none."""
    found = shutil.which("gcc")
    if found is None:
        if os.environ.get("CI"):
            pytest.fail("CI needs gcc: apt-get install gcc")
        pytest.skip("no gcc here, so no generated C was compiled")
    return found
