"""``python -m dhlab`` is the ``dhlab`` command."""

from .cli.app import main

main()
