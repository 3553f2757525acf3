"""Notebooks on their way to a file: what only a running kernel can show is taken out, and the
explorer's ``text/html`` stays.
"""

from typing import Any

__all__ = ["without_widgets"]

LIVE = "application/vnd.jupyter.widget-view+json"


def without_widgets(notebook: Any) -> Any:
    """Take the live views, which name a kernel's objects by random ids, out of a notebook's
    outputs, and their state out of its metadata.

    Parameters
    ----------
    notebook : nbformat notebook
        Changed in place.

    Returns
    -------
    The same notebook.
    """
    notebook.metadata.pop("widgets", None)
    for cell in notebook.cells:
        for output in cell.get("outputs", []):
            if "text/html" in output.get("data", {}):
                output["data"].pop(LIVE, None)
    return notebook
