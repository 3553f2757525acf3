"""What is found in a program here does not depend on how fast the machine is."""

import pytest

from dhlab.doctor.programs import functions
from dhlab.doctor.programs.source import singles

PATIENCE = 3  # times the seconds that a learner waits at most


@pytest.fixture(autouse=True)
def patient(monkeypatch):
    """Searches that come to their end also on a machine that is slow, or busy with other tests."""
    for module, name in (
        (functions, "SECONDS"),
        (functions, "AS_ARM"),
        (functions, "KEPT"),
        (singles, "EACH"),
    ):
        monkeypatch.setattr(module, name, PATIENCE * getattr(module, name))
