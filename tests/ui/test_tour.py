"""Tour that writes pictures of the window."""

from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from trex_gui.ui.program import Program
from trex_gui.ui.tour import Tour, TourStep


@pytest.mark.parametrize("raises", [False, True])
def test_tour_fails_if_a_picture_cannot_be_written_or_a_step_raises(
    program: Program, qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, raises: bool
) -> None:
    def fail() -> None:
        raise RuntimeError

    def steps(tour: Tour) -> Iterator[TourStep]:
        yield lambda: None
        yield fail if raises else partial(tour.write, program.window.menuBar(), "board", "light")

    monkeypatch.setattr(Tour, "_create_steps", steps)
    (tmp_path / "board-light.png").mkdir()
    tour = Tour(program, tmp_path)
    with (
        qtbot.captureExceptions() as errors,
        qtbot.waitSignal(tour.finished, timeout=60_000) as finished,
    ):
        tour.start()
    assert finished.args == [False]
    assert [kind for kind, *_ in errors] == [RuntimeError] * raises
