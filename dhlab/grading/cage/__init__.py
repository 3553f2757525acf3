"""Where a stranger's notebook runs: what it may see of this machine, and how it is locked in."""
