"""How long a stranger's program may run: seconds of processor, so that a right program does not
fail on a busy machine; and an end to what only sleeps.
"""

import signal
import time
from collections.abc import Callable
from typing import Any

try:
    import resource
except ImportError:  # Windows, which has no cage, reads WAIT all the same
    resource = None  # type: ignore[assignment]

__all__ = ["TimeLimit", "limited", "WAIT"]

WAIT = 6  # times the seconds of processor, on the wall's clock, whatever the machine is busy with
IDLE = 0.02  # who takes less of a processor than this is waiting, not working
TICK = 0.2
KERNEL = 1  # seconds later the kernel ends what does not listen


class TimeLimit(BaseException):
    """A cell took too long; not an Exception, so that a learner's ``except Exception`` lets it
    through.
    """


def limited(act: Callable[[], Any], seconds: float) -> tuple[str, str] | None:
    """None when ``act`` came to its end; otherwise ("timed out", "") or ("error", what it says)."""
    used, begun = time.process_time(), time.monotonic()

    def tick(signal_number, frame):
        took, passed = time.process_time() - used, time.monotonic() - begun
        if took >= seconds or passed >= WAIT * seconds:
            raise TimeLimit
        if passed >= seconds and took < IDLE * passed:
            raise TimeLimit

    try:
        _end_by_kernel(used + seconds + KERNEL)
        signal.signal(signal.SIGALRM, tick)
        signal.setitimer(signal.ITIMER_REAL, min(TICK, seconds / 4), TICK)
        act()
    except TimeLimit:
        return "timed out", ""
    except BaseException as error:  # SystemExit and KeyboardInterrupt end a cell, not the notebook
        return "error", _message(error)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
    return None


def _end_by_kernel(seconds):
    _, most = resource.getrlimit(resource.RLIMIT_CPU)
    wanted = int(seconds) + 1
    resource.setrlimit(resource.RLIMIT_CPU, (wanted if most < 0 else min(wanted, most), most))


def _message(error):
    try:
        return f"{type(error).__name__}: {error}"[:300]
    except BaseException:
        return "an error that cannot be shown"
