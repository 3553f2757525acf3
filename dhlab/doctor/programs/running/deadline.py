"""A limit of time for what a learner wrote: seconds of the processor where the system counts them,
seconds of the clock elsewhere.
"""

import signal
import sys
import threading
import time

__all__ = ["OutOfTime", "limited"]

AGAIN = 0.05  # s; the first time may fall where nothing can be raised
PATIENCE = 3  # a clock runs on while the processor does something else


class OutOfTime(BaseException):
    """The time is up; not an Exception, so that a learner's ``except Exception`` lets it through.

    Examples
    --------
    >>> issubclass(OutOfTime, Exception)
    False
    """


def limited(seconds, f, *given):
    """What a function gives, unless it takes too long.

    Where the system has a timer that counts the processor's time, that is used (it acts in the main
    thread only); elsewhere the function runs in a thread that is given up after three times as many
    seconds of the clock; and where there are no threads, as in a browser, the clock is looked at
    while it runs.

    Parameters
    ----------
    seconds : float
        Of the processor.
    f : callable
    *given
        Its arguments.

    Raises
    ------
    OutOfTime
        The time was up; and whatever ``f`` raises.

    Examples
    --------
    >>> limited(1, max, 3, 5)
    5
    """
    if _has_timer():
        return _timed(seconds, f, *given)
    return _in_a_thread(seconds * PATIENCE, f, *given)


def _has_timer():
    return (
        hasattr(signal, "setitimer")
        and sys.platform != "emscripten"
        and threading.current_thread() is threading.main_thread()
    )


def _timed(seconds, f, *given):
    traced, before = sys.gettrace(), signal.signal(signal.SIGVTALRM, _stop)
    running = signal.setitimer(signal.ITIMER_VIRTUAL, seconds, AGAIN)
    try:
        return f(*given)
    finally:
        sys.settrace(traced)  # first: what follows would be stopped as well
        signal.setitimer(signal.ITIMER_VIRTUAL, *running)
        signal.signal(signal.SIGVTALRM, before)


def _stop(_, frame):
    """Stop here, and at the next line of who catches even that."""
    while frame is not None and frame.f_code is not _timed.__code__:
        frame.f_trace = _stop_there
        frame = frame.f_back
    sys.settrace(_stop_there)
    raise OutOfTime


def _stop_there(frame, event, argument):
    if event == "exception":  # the one that is under way
        return _stop_there
    raise OutOfTime


def _in_a_thread(seconds, f, *given):
    """The function in a thread of its own, which is asked to end when the time is up."""
    came = []

    def run():
        try:
            came.append((f(*given), None))
        except BaseException as error:
            came.append((None, error))

    worker = threading.Thread(target=run, daemon=True)
    try:
        worker.start()
    except RuntimeError:  # no threads here
        return _watched(seconds, f, *given)
    worker.join(seconds)
    if not came:
        _end(worker)
        raise OutOfTime
    answer, error = came[0]
    if error is not None:
        raise error
    return answer


def _watched(seconds, f, *given):
    """The function, with a look at the clock at every call, and at every line that stands in no
    file: a learner's, from a cell or a text.
    """
    traced, end = sys.gettrace(), time.perf_counter() + seconds

    def look(frame, event, argument):
        if event in ("call", "line") and time.perf_counter() > end:
            raise OutOfTime
        return look if frame.f_code.co_filename.startswith("<") else None

    sys.settrace(look)
    try:
        return f(*given)
    finally:
        sys.settrace(traced)


def _end(worker):
    """Python raises OutOfTime in the thread at its next step; a step that never ends goes on."""
    import ctypes  # not everywhere

    ctypes.pythonapi.PyThreadState_SetAsyncExc(
        ctypes.c_ulong(worker.ident), ctypes.py_object(OutOfTime)
    )
