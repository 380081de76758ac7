"""Progress in a terminal, and interruption by signals."""

import io
import signal
import sys

import pytest

from trex_gui.core.cli import Interruption, ProgressLine


def test_progress_uses_one_line_and_clears_it(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = io.StringIO()
    monkeypatch.setattr(terminal, "isatty", lambda: True)
    monkeypatch.setattr(sys, "stderr", terminal)
    with ProgressLine("Writing") as line:
        line(1, 4, "Serial Timeout")
        line(4, 4, "done")
    first, second, *_, last = terminal.getvalue().split("\r")[1:]
    assert first == "Writing [#####...............] 1/4 Serial Timeout"
    assert second.rstrip() == "Writing [####################] 4/4 done"
    assert len(second) == len(first)
    assert not last
    assert "\n" not in terminal.getvalue()


def test_progress_is_silent_without_a_terminal(capsys: pytest.CaptureFixture[str]) -> None:
    with ProgressLine("Writing") as line:
        line(1, 2, "something")
    assert capsys.readouterr().err == ""


def test_second_interrupt_raises_keyboard_interrupt() -> None:
    before = signal.getsignal(signal.SIGINT)
    with Interruption() as interrupted:
        assert not interrupted
        signal.raise_signal(signal.SIGINT)
        assert interrupted
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
    assert signal.getsignal(signal.SIGINT) is before


def test_interrupts_of_work_that_must_finish_are_recorded() -> None:
    with Interruption(must_finish=True) as interrupted:
        for _ in range(3):
            signal.raise_signal(signal.SIGINT)
        assert interrupted
