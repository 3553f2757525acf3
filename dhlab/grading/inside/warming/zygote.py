"""The warm parent inside the cage: it loads what the lessons need, once, and is copied for every
submission. It never reads a submission.

Started by its ``main`` with one line of JSON as its argument; speaks with the grader
through a socket: two open files arrive for each submission (what to run, where to write), one byte
says that it is over, one line answers how it ended.
"""

import contextlib
import gc
import json
import os
import re
import select
import signal
import socket
import sys
import time

from dhlab.grading.inside.clock import IDLE
from dhlab.grading.inside.confining import landlock, process, seccomp
from dhlab.grading.inside.warming import later
from dhlab.grading.inside.warming.ending import clean, end
from dhlab.grading.inside.warming.examples import used_once

LOADED = re.compile(r"""\bdh\.load\(["']([\w.-]+)["']\)""")
LOOK = 0.03  # seconds between two looks at what a submission writes
MOST_FILES = 5000  # files of a submission, and what Python keeps there itself
MOST_THREADS = 300  # more on the machine than before, which nothing honest starts meanwhile


def main() -> None:
    """Confine this process, load, then copy it once for each request until the grader hangs up."""
    config = json.loads(sys.argv[1])
    control = socket.socket(fileno=config["control"])
    problem = _confine(config)
    # where Python itself stands below it, which nobody here can write to
    kept = set(os.listdir(config["work"]))
    lessons = _line(control)
    if not problem:
        _warm(config["warm"], lessons)
    # here and not in the copies: to look at all the names there copies the pages they stand on
    warm = frozenset(sys.modules)
    control.sendall(json.dumps({"ready": not problem, "problem": problem}).encode())
    while not problem:
        message, files, _, _ = socket.recv_fds(control, 1 << 16, 2)
        if not message or len(files) != 2:
            return
        if wanted := json.loads(message):
            _load(wanted)
            warm = frozenset(sys.modules)
        config["limits"]["in_use"] = process.memory_in_use()
        child = os.fork()
        if child == 0:
            control.close()
            _submission(config, warm, *files)
        for file in files:
            os.close(file)
        late = _late_when_it_is_over(control, child, config)
        if late is None:
            return
        status, seconds = end(child, config["own_processes"])
        status = -signal.SIGXCPU if late else status
        emptied = clean(config["work"], kept)
        said = {"status": status, "seconds": round(seconds, 3), "clean": emptied}
        control.sendall(json.dumps(said).encode())


def _late_when_it_is_over(control, child, config):
    """Wait until the grader says so; None when it has hung up. Who leaves more files than there
    is room for, starts threads without number, or does nothing but wait, is stopped meanwhile;
    whether it was the last.
    """
    watched, late, before, begun = True, False, process.threads_of_all(), time.monotonic()
    while not select.select([control], [], [], LOOK)[0]:
        late = late or (watched and _only_waits(child, begun, config["limits"]["seconds"]))
        if watched and (late or _too_many_files(config) or _too_many_threads(config, before)):
            os.kill(child, signal.SIGKILL)
            watched = False
    return late if control.recv(1) else None


def _only_waits(child, begun, seconds):
    """Whether a submission has had its time on the wall's clock and hardly used a processor: the
    clock within, which it may have put away, would have ended that.
    """
    passed = time.monotonic() - begun
    return passed > seconds and process.seconds_of(child, passed) < IDLE * passed


def _too_many_threads(config, before):
    """Whether the machine has many more threads than ``before``. Where the user is the grader's own
    the kernel's limit would count the teacher's too, and root's not at all.
    """
    if config["limits"]["own_user"]:
        return False
    more = (process.threads_of_all() - before) % 65536  # the system counts no further
    return MOST_THREADS < more < 32768


def _too_many_files(config):
    """Whether the folder that can be written to holds more than the limits allow. A file system of
    its own says how many files it has; its size it keeps itself.
    """
    if config["level"] == "bubblewrap":
        told = os.statvfs(config["work"])
        return told.f_files - told.f_ffree > MOST_FILES
    files, size, folders = 0, 0, [config["work"]]
    while folders:
        try:
            for entry in os.scandir(folders.pop()):
                files += 1
                status = entry.stat(follow_symlinks=False)
                size += status.st_blocks * 512
                if entry.is_dir(follow_symlinks=False):
                    folders.append(entry.path)
                if files > MOST_FILES or size > config["limits"]["files_mb"] << 20:
                    return True
        except FileNotFoundError:
            continue
        except OSError:  # closed to us, or deeper than a path: what is in it cannot be counted
            return True
    return False


def _confine(config):
    """What cannot be done on this machine, as text; empty when everything could."""
    try:
        os.umask(0o077)
        if config["user"] is not None:
            (
                os.chown(config["work"], config["user"], config["user"])
                if config["level"] != "bubblewrap"
                else None
            )
            process.drop_to(config["user"])
        elif hasattr(os, "geteuid") and os.geteuid() == 0:
            process.drop_capabilities()
        process.no_new_privileges()
        process.libc and process.libc.prctl(36, 1, 0, 0, 0)  # PR_SET_CHILD_SUBREAPER
        process.look_at_memory()
        config["calls"] = _filter(config["level"])
        if config["level"] == "landlock":
            if not config["calls"] or not landlock.landlock_version():
                return "no Landlock or no libseccomp"
            landlock.restrict_files(config["readable"], [config["work"], "/dev/null"])
        os.chdir(config["work"])
    except OSError as error:
        return str(error)
    return ""


def _filter(level):
    """What keeps a submission from the kernel's calls, made once for all of them; empty where
    there is none.
    """
    library = seccomp.libseccomp()
    if not library or level == "rlimits":
        return b""
    return seccomp.filter_of_calls(library, own_user=level != "landlock")


def _line(control):
    """The cells of the lessons as they were handed out, which every student has."""
    found = b""
    while not found.endswith(b"\n"):
        more = control.recv(1 << 16)
        if not more:
            sys.exit()
        found += more
    return json.loads(found)


def _warm(modules, lessons):
    """Load what submissions will ask for, and read the cells that most of them hold unchanged and
    the arms that these load; what this machine does not have is passed over.
    """
    later.let_wait()
    import dhlab
    from dhlab.grading.inside.reading import slices
    from dhlab.grading.inside.warming import rehearsal

    for source in lessons:
        slices.statements(0, source)
    _load(modules)
    for arm in sorted(set(LOADED.findall("\n".join(lessons)))):
        with contextlib.suppress(Exception):
            dhlab.load(arm)
    rehearsal.rehearse()
    _settle()


def _load(modules):
    """Load modules once, for all submissions from now on, and use those that read more when they
    are used.
    """
    loaded = []
    for name in modules:
        with contextlib.suppress(Exception):
            loaded.append(later.load(name))
    for module in loaded:
        with contextlib.suppress(Exception):
            used_once(module)
    if modules:
        _settle()


def _settle():
    """Nothing that is here now is looked at again by the copies, and what is free goes back."""
    gc.collect()
    gc.freeze()
    process.give_back()


def _submission(config, warm, request, answers):
    """In the copy: the last limits, then the stranger's program; this never returns."""
    try:
        os.setsid()
        nothing = os.open(os.devnull, os.O_WRONLY)
        for file in (1, 2):  # no file that a later submission could read
            os.dup2(nothing, file)
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        process.no_new_privileges()
        process.restrict_resources(config["limits"])
        if config["calls"]:
            seccomp.restrict_calls(config["calls"])
        from dhlab.grading.inside import runner

        runner.run(request, answers, warm)
    finally:
        os._exit(0)


if __name__ == "__main__":
    main()
