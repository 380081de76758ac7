"""Disk that needs seconds for each file, in virtual time."""

import os
from pathlib import Path

import greenlet
import pytest

from trex_gui.core import files
from trex_gui.ui.runtime import runtime

SECONDS = 1.5


class SlowDisk:
    """Delays the check and the save of each file by `SECONDS`.

    Attributes:
        stalls: delayed actions in the thread of the window.
    """

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.stalls: list[str] = []
        self._window = greenlet.getcurrent()
        check, sync = files.check_ordinary, os.fsync

        def slow_check(path: Path) -> None:
            self._delay(f"check of {path.name}")
            check(path)

        def slow_sync(handle: int) -> None:
            self._delay("save")
            sync(handle)

        monkeypatch.setattr(files, "check_ordinary", slow_check)
        monkeypatch.setattr(os, "fsync", slow_sync)

    def _delay(self, action: str) -> None:
        if greenlet.getcurrent() is self._window:
            self.stalls.append(action)
        runtime().sleep(SECONDS)
