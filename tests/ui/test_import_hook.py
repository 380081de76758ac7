"""Import hook of PySide6."""

import linecache
import sys
from pathlib import Path

import pytest

import trex_gui.ui  # noqa: F401 - installs the hook


def test_imported_modules_are_not_read_as_source(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source = tmp_path / "uses_pyside.py"
    source.write_text("from PySide6.QtCore import QObject\n", encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    try:
        __import__("uses_pyside")  # like an import statement
        assert str(source) not in linecache.cache
    finally:
        sys.modules.pop("uses_pyside", None)
