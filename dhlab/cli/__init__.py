"""The ``dhlab`` command: a module for each verb; what they share is in ``common``."""

from .app import app, main

__all__ = ["app", "main"]
