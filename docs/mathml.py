"""A Sphinx extension: formulas become MathML while the site is built, so that a page needs no
script to show them.
"""

import xml.etree.ElementTree as ET

from docutils import nodes
from latex2mathml.converter import convert
from sphinx.util import logging

__all__ = ["mathml", "setup"]

NAMESPACE = "http://www.w3.org/1998/Math/MathML"
THIN = "0.167em"
ET.register_namespace("", NAMESPACE)
log = logging.getLogger(__name__)


def mathml(tex, display="inline"):
    """The ``<math>`` element for a formula, with the thin spaces round cos and sin that a printer
    would set.

    Raises
    ------
    ValueError
        latex2mathml does not know a command, or the formula is not complete.
    """
    try:
        root = ET.fromstring(convert(tex, display=display))
    except Exception as error:  # latex2mathml raises many kinds
        raise ValueError(
            f"formula {tex!r}: expected LaTeX that latex2mathml knows, found"
            f" {type(error).__name__}; write it more simply"
        ) from None
    unknown = [text for text in root.itertext() if "\\" in text]
    if unknown:
        raise ValueError(
            f"formula {tex!r}: latex2mathml does not know {unknown[0].strip()}; write it without"
        )
    for parent in list(root.iter()):
        if parent.tag.endswith(("mrow", "mtd")):
            _space_functions(parent)
    return ET.tostring(root, encoding="unicode")


def _space_functions(parent):
    """``a cos θ``, not ``acosθ``: a space after a function's name, and before it when something is
    multiplied by it.
    """
    children = list(parent)
    for before, child in zip([None, *children], children):
        if not _is_function(child):
            continue
        if before is not None and not before.tag.endswith("mo"):
            _insert_space(parent, child)
        if child is not children[-1]:
            _insert_space(parent, children[children.index(child) + 1])


def _is_function(element):
    return element.tag.endswith("mi") and len(element.text or "") > 1


def _insert_space(parent, element):
    """A thin space in front of an element, unless there is one."""
    place = list(parent).index(element)
    if place == 0 or not parent[place - 1].tag.endswith("mspace"):
        parent.insert(place, ET.Element(f"{{{NAMESPACE}}}mspace", width=THIN))


def _visit(translator, node):
    display = "block" if isinstance(node, nodes.math_block) else "inline"
    try:
        html = mathml(node.astext(), display)
    except ValueError as error:
        log.warning("%s", error, location=node)
        raise nodes.SkipNode from None
    translator.body.append(f'<div class="math">{html}</div>' if display == "block" else html)
    raise nodes.SkipNode


def setup(app):
    """Called by Sphinx."""
    app.add_html_math_renderer("mathml", (_visit, None), (_visit, None))
    app.config.html_math_renderer = "mathml"
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
