"""A million poses take little more memory than their result."""

import tracemalloc

import numpy as np
import pytest

import dhlab as dh


@pytest.mark.parametrize("question", ["forward", "frames", "jacobian"])
def test_the_peak_is_the_result_and_little_more(question, monkeypatch):
    monkeypatch.setenv("DHLAB_NUMBA", "0")  # its modules take memory of their own
    arm, q = dh.load("article-6r"), np.zeros((200_000, 6))
    tracemalloc.start()
    try:
        result = getattr(arm, question)(q)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    # a few megabytes of rows in the cache beside it, however many poses there are
    assert result.nbytes <= peak < result.nbytes + 6e6
