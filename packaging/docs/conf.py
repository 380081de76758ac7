"""Configuration of Sphinx for `packaging/docs.py`."""

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
exclude_patterns = ["help/README.md"]  # index.md replaces the title page of the help
html_theme = "furo"
html_title = f"{project} {release}"
html_favicon = "trex-studio.svg"
html_copy_source = False
myst_heading_anchors = 4  # the window and code hosts use the same anchors
autodoc_member_order = "bysource"
autodoc_typehints_format = "short"
python_use_unqualified_type_names = True
default_role = "code"  # single backticks in docstrings
