"""What is wrong with a learner's program, found by calling it."""

from .explain import WRONG_VERSIONS, explain_function

__all__ = ["WRONG_VERSIONS", "explain_function"]
