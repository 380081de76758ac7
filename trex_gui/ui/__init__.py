"""Shared by all devices, with Qt."""

import contextlib
import importlib

import PySide6  # noqa: F401 - brings its support package


def _clear_sources() -> None:
    """Keep PySide from reading the source of every module that is imported.

    It looks there for a sign of its optional feature `__feature__`, which nothing here uses, and
    Python keeps what it has read: 20 MB, and a sixth of the time to the window.
    """
    with contextlib.suppress(ImportError):
        feature = importlib.import_module("shibokensupport.feature")
        vars(feature).update(_mod_uses_pyside=lambda _module: False)


_clear_sources()
