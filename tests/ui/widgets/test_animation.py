"""Frames of animated drawings."""

import pytest
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from tests.support.virtual_time import VirtualRuntime
from trex_gui.ui.widgets.painted import Animation


class Drawing:
    def __init__(self, qtbot: QtBot, runtime: VirtualRuntime) -> None:
        self.widget = QWidget()
        qtbot.addWidget(self.widget)
        self.steps: list[float] = []
        self.motion = Animation(self.widget, self.steps.append)
        self.runtime = runtime

    def frames(self) -> int:
        """Return the frames of one second."""
        self.steps.clear()
        for _ in range(100):
            self.runtime.advance(0.01)
        return len(self.steps)


@pytest.fixture
def drawing(qtbot: QtBot, virtual_time: VirtualRuntime) -> Drawing:
    return Drawing(qtbot, virtual_time)


def test_visible_motion_takes_less_than_thirty_frames_a_second(drawing: Drawing) -> None:
    drawing.widget.show()
    drawing.motion.run(True)
    assert 20 <= drawing.frames() <= 30
    assert sum(drawing.steps) == pytest.approx(1, abs=0.1)


def test_still_or_hidden_drawing_takes_no_frame(drawing: Drawing) -> None:
    drawing.motion.run(True)
    assert not drawing.frames(), "not shown yet"
    drawing.widget.show()
    drawing.motion.run(True)
    assert drawing.frames()
    drawing.motion.run(False)
    assert not drawing.frames()
    drawing.motion.run(True)
    drawing.widget.hide()
    assert not drawing.frames()


def test_system_without_motion_gets_none(drawing: Drawing) -> None:
    drawing.widget.setStyleSheet("QWidget { widget-animation-duration: 0 }")
    drawing.widget.show()
    drawing.motion.run(True)
    assert not drawing.motion.is_enabled
    assert not drawing.frames()
