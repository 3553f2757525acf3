"""Grading on a Dask cluster: the same tasks and the same cage, on each worker; a lost worker's
tasks go to another.
"""

from collections.abc import Iterable, Iterator
from typing import Any

from .judging.questions import Course
from .judging.work import Task, work
from .results.marks import Graded

__all__ = ["over_cluster"]

# tasks a worker has in hand, so that it never waits and the scheduler never holds the whole class
AHEAD = 4
RETRIES = 3


def over_cluster(address: str, todo: Iterable[tuple[Task, Course]]) -> Iterator[Graded]:
    """Graded, as they come, from the workers of a scheduler.

    Parameters
    ----------
    address : str
        Such as ``tcp://10.0.0.5:8786``. Its workers need dhlab, and one thread each.
    todo : iterable of (Task, Course)

    Yields
    ------
    Graded

    Raises
    ------
    ValueError
        Dask is not installed, or nobody answers at this address.
    """
    client = _client(address)
    from distributed import as_completed

    todo = iter(todo)
    given: dict[Any, tuple[Task, Course]] = {}
    with client:
        ahead = max(2, AHEAD * len(client.scheduler_info(n_workers=-1)["workers"]))
        done = as_completed()
        while True:
            while len(given) < ahead and (entry := next(todo, None)) is not None:
                given |= {_submit(client, entry, done): entry}
            if not given:
                return
            future = next(done)
            entry = given.pop(future)
            if future.status == "error":
                raise ValueError(
                    f"grade: expected {entry[0].student!r} to be graded, found that the worker"
                    f" stopped ({future.exception()}); run again to grade the rest"
                ) from None
            yield future.result()


def _submit(client, entry, done):
    future = client.submit(work, *entry, pure=False, retries=RETRIES)
    done.add(future)
    return future


def _client(address):
    try:
        from distributed import Client
    except ImportError:
        raise ValueError(
            "grade: --scheduler: expected Dask, found that it is not installed; run: pip install"
            ' "dhlab-kinematics[teach]"'
        ) from None
    try:
        return Client(address, timeout=10)
    except (OSError, ValueError, TypeError):
        raise ValueError(
            f"grade: --scheduler: {address}: expected a Dask scheduler there, found that none"
            " answers; start one with dask scheduler"
        ) from None
