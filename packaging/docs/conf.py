"""How Sphinx builds the site; see `packaging/docs.py`."""

from trex_gui.version import __version__

project = "TReX Studio"
author = "the makers of TReX Studio"
release = __version__
extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx.ext.viewcode",
    "sphinx_click",
]
exclude_patterns = ["help/README.md"]  # the title page of the help is ours
html_theme = "furo"
html_title = f"{project} {release}"
html_favicon = "trex-studio.svg"
html_copy_source = False
myst_heading_anchors = 4  # as the window and forges name them
autodoc_member_order = "bysource"
autodoc_typehints_format = "short"
python_use_unqualified_type_names = True
default_role = "code"  # single backticks in docstrings
