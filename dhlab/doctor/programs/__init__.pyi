from .explain import WRONG_VERSIONS as WRONG_VERSIONS
from .explain import explain_function as explain_function
