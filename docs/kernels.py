"""Kernels for the notebooks of the site, and for the solutions when they are tested
(`solutions/conftest.py`), forked from one process that has imported and drawn once what nearly all
of them import and draw: that is a third of what they take of the processor.
"""

import json
import math
import os
import signal
import subprocess
import sys
from contextlib import suppress
from functools import cache
from threading import Lock

from ipykernel.kernelapp import launch_new_instance
from jupyter_client import AsyncKernelManager, KernelManager
from jupyter_client.provisioning import LocalProvisioner

__all__ = ["Forked", "ForkedInStep"]

LOCK = Lock()


class _Forks:
    """What makes a manager one of a kernel that is forked; on Windows, where nothing can be, it is
    started as any other.
    """

    def __init__(self, **settings):
        super().__init__(**settings)
        if hasattr(os, "fork"):
            self.provisioner = Provisioner(
                parent=self, kernel_id=self.kernel_id, kernel_spec=self.kernel_spec
            )


class Forked(_Forks, AsyncKernelManager):
    """The manager of a kernel that is forked."""


class ForkedInStep(_Forks, KernelManager):
    """The same, for who waits for each of its answers."""


class Provisioner(LocalProvisioner):
    """Has the warm process fork where others start a command."""

    async def launch_kernel(self, cmd, cwd, env, **_):
        self.process = Process(_forked(cmd, cwd, env))
        self.pid, self.cwd = self.process.pid, cwd
        return self.connection_info


class Process:
    """A forked kernel, with what a provisioner asks of a ``Popen``; it is a child of the warm
    process, and gone once it has ended.
    """

    stdin = stdout = stderr = None

    def __init__(self, pid):
        self.pid = pid

    def poll(self):
        try:
            os.kill(self.pid, 0)
        except ProcessLookupError:
            return 0

    wait = poll  # called once it has ended

    def send_signal(self, number):
        os.kill(self.pid, number)


def _forked(*how):
    """The number of a new kernel's process."""
    with LOCK:
        warm = _warm()
        print(json.dumps(how), file=warm.stdin, flush=True)
        return int(warm.stdout.readline())


@cache
def _warm():
    """The warm process, which ends with this one."""
    settings = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "start_new_session": True}
    # two kernels at a time: threads in products of matrices would take the cores from each other
    settings["env"] = os.environ | {"OPENBLAS_NUM_THREADS": "1"}
    return subprocess.Popen([sys.executable, __file__], text=True, **settings)


# ---- in the warm process


def main():
    """Fork a kernel for each line from the build; end with the build, and all kernels with both."""
    import dhlab as dh
    import dhlab.view.explorer.widget
    import dhlab.view.turnable
    from dhlab import view
    from dhlab.course.exercises import exercises
    from dhlab.doctor import budget

    budget.SILENT = math.inf  # what a search says on its way depends on how fast the machine is
    arm = dh.load("ur5e")
    for picture in (view.sketch("right hand"), view.arm(arm)):
        picture._repr_mimebundle_()
    arm.solve(arm.forward([0.3] * 6))
    exercises()
    signal.signal(signal.SIGCHLD, wait)
    for line in sys.stdin:
        pid = os.fork()
        if not pid:
            become_kernel(*json.loads(line))
        print(pid, flush=True)
    os.killpg(0, signal.SIGKILL)


def wait(*_):
    """Let those go that have ended."""
    with suppress(ChildProcessError):
        while os.waitpid(-1, os.WNOHANG)[0]:
            pass


def become_kernel(command, folder, environment):
    """In a fork: what the command would do, in that folder."""
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    nothing = os.open(os.devnull, os.O_RDWR)
    for file in (0, 1):  # the pipes to the build
        os.dup2(nothing, file)
    os.chdir(folder)
    os.environ.clear()
    os.environ.update(environment)
    sys.path[0] = ""  # as python -m has it
    try:
        launch_new_instance(argv=command[command.index("-f") :])
    finally:
        os._exit(0)


if __name__ == "__main__":
    main()
