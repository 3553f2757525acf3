"""Questions as cards that are clicked, dragged or chosen by keys."""

from .widget import Cards, inline

__all__ = ["Cards", "inline"]
