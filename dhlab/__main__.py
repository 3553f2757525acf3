"""``python -m dhlab`` is the ``dhlab`` command."""

from .cli import main

main()
