"""User interface shared by all kinds of devices. Requires Qt."""

import contextlib
import importlib

import PySide6  # noqa: F401 - imports `shibokensupport`

# PySide searches the source of each imported module for `__feature__`. This program does not
# use it, and the search takes 20 MB and a sixth of the start time.
with contextlib.suppress(ImportError):
    feature = importlib.import_module("shibokensupport.feature")
    vars(feature).update(_mod_uses_pyside=lambda _module: False)
