"""The site's settings: Sphinx with myst-nb and furo, and nothing that a reader's browser would
fetch from elsewhere.

Built by ``docs/build.py``, which hands in pages whose cells have been run already.
"""

import sys
from functools import cache
from pathlib import Path

from sphinx.search.en import SearchEnglish

import dhlab

sys.path.insert(0, str(Path(__file__).parent))  # for mathml

project = "dhlab"
author = "the dhlab authors"
release = version = dhlab.__version__
language = "en"

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.napoleon",
    "sphinx_copybutton",
    "sphinx_design",
    "mathml",
]
exclude_patterns = ["_build", "benchmarks"]  # parts of a page, included there
myst_enable_extensions = ["dollarmath", "colon_fence", "deflist"]
myst_heading_anchors = 3
nb_execution_mode = "off"
nb_merge_streams = True
smartquotes_action = "D"  # dashes; quotation marks stay as they were typed

autodoc_member_order = "bysource"
autosummary_generate = False
autodoc_typehints = "none"
add_module_names = False
toc_object_entries_show_parents = "hide"
napoleon_google_docstring = False
napoleon_use_rtype = False
napoleon_use_ivar = True

copybutton_prompt_text = r">>> |\.\.\. "
copybutton_prompt_is_regexp = True
copybutton_exclude = ".linenos, .gp, .go"

html_theme = "furo"
html_title = "dhlab"
html_favicon = "_static/favicon.svg"
html_static_path = [
    "_static",
    "../dhlab/view/explorer/explorer.js",
    "../dhlab/view/explorer/instrument.js",
    "../dhlab/view/explorer/gif.js",
]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sourcelink = False
html_show_copyright = False
html_domain_indices = False

SearchEnglish.stem = cache(SearchEnglish.stem)  # a word once, not once for each page
trees = {}  # of the pages that no tree of contents names, by folder


def setup(app):
    """Scripts go to the pages that need them."""
    app.connect("html-page-context", with_explorer)
    app.connect("html-page-context", with_shared_tree, priority=400)  # before furo asks for it


def with_shared_tree(app, pagename, templatename, context, doctree):
    """The arms' pages stand in no tree of contents, so what is beside them all is made once."""
    if "orphan" in (context.get("meta") or {}):
        folder = pagename.rpartition("/")[0]
        context["toctree"] = trees.setdefault(folder, cache(context["toctree"]))


def with_explorer(app, pagename, templatename, context, doctree):
    # first: what is folded is unfolded for the paper before explorers draw themselves for it
    if "cell_output" in context.get("body", ""):
        app.add_js_file("reading.js", loading_method="defer")
    if 'class="dhlab-explorer"' in context.get("body", ""):
        app.add_js_file("explorer.js", type="module")
