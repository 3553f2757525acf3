"""Ask apt for what the tests need beyond Python: Chromium, bubblewrap and npm. Where that cannot be
done, say which tests will be skipped.

Called by ``make test-deps``. Exit status 1 only in CI, where nothing may be skipped.
"""

import os
import shutil
import subprocess
import sys

NEEDED = {
    "chromium": ("chromium", "pages and JupyterLab looked at in a browser"),
    "bwrap": ("bubblewrap", "programs run in a cage"),
    "gcc": ("gcc", "generated C compiled"),
    "npm": ("npm", "the explorer's JavaScript built again and its pages checked with axe"),
}
CHROMIUMS = "chromium", "chromium-browser", "google-chrome"
# also installed where apt has it: in it the same pages take a third less of the processor
WINDOWLESS = "chromium-headless-shell"


def found(program):
    """Whether a program is there, under one of its names."""
    names = CHROMIUMS if program == "chromium" else [program]
    return any(shutil.which(name) for name in names)


def spared():
    """Whether apt, by the lists that it has, could install the Chromium without windows."""
    if shutil.which(WINDOWLESS) or shutil.which("apt-cache") is None:
        return False
    known = subprocess.run(["apt-cache", "show", WINDOWLESS], capture_output=True)
    return known.returncode == 0


def install(packages):
    """Install with apt where this user may; silence on failure, since what is missing is named
    afterwards.
    """
    if shutil.which("apt-get") is None:
        return
    root = hasattr(os, "geteuid") and os.geteuid() == 0
    prefix = [] if root else ["sudo", "-n"]
    if not root and (
        shutil.which("sudo") is None
        or subprocess.call(["sudo", "-n", "true"], stderr=subprocess.DEVNULL) != 0
    ):
        return
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}

    def apt(*command):
        command = [*prefix, "apt-get", *command]
        subprocess.call(command, env=environment, stdout=subprocess.DEVNULL)

    apt("update", "-qq")
    more = [WINDOWLESS] if spared() else []
    apt("install", "-y", "-qq", "--no-install-recommends", *packages, *more)


def main():
    """Install what is missing, then name what still is."""
    missing = [program for program in NEEDED if not found(program)]
    if missing or spared():
        install([NEEDED[program][0] for program in missing])
    still = [program for program in missing if not found(program)]
    for program in still:
        package, tests = NEEDED[program]
        print(
            f"{package} is not here and could not be installed: SKIPPED will be the tests of"
            f" {tests}. To run them: apt install {package}"
        )
    sys.exit(bool(still and os.environ.get("CI")))


if __name__ == "__main__":
    main()
