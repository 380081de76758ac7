import io
import sys

import pytest

from trex_gui.core.cli import ProgressLine


def test_progress_fits_the_width_of_the_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = io.StringIO()
    monkeypatch.setattr(terminal, "isatty", lambda: True)
    monkeypatch.setattr(sys, "stderr", terminal)
    monkeypatch.setenv("COLUMNS", "60")
    ProgressLine("Searching")(1, 4, "TReX at 115200 baud, even parity, at most 25 s left")
    assert len(terminal.getvalue().removeprefix("\r")) == 59
