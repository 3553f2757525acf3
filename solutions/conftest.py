"""nbval runs the solutions in kernels that are forked, as those of the site are."""

import sys
from pathlib import Path

import nbval.kernel

sys.path.insert(0, str(Path(__file__).parents[1] / "docs"))
from kernels import ForkedInStep

nbval.kernel.KernelManager = ForkedInStep
