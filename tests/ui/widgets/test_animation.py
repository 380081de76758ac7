"""Frames of animated drawings."""

import pytest
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from tests.support.virtual_time import VirtualRuntime
from trex_gui.ui.widgets.painted import Animation


class DrawingHarness:
    """Animated widget with the steps of its animation."""

    def __init__(self, qtbot: QtBot, runtime: VirtualRuntime) -> None:
        self.widget = QWidget()
        qtbot.addWidget(self.widget)
        self.steps: list[float] = []
        self.animation = Animation(self.widget, self.steps.append)
        self.runtime = runtime

    def frames(self) -> int:
        """Let one second pass. Return the number of frames."""
        self.steps.clear()
        for _ in range(100):
            self.runtime.advance(0.01)
        return len(self.steps)


@pytest.fixture
def drawing(qtbot: QtBot, virtual_time: VirtualRuntime) -> DrawingHarness:
    return DrawingHarness(qtbot, virtual_time)


def test_visible_animation_draws_20_to_30_frames_a_second(drawing: DrawingHarness) -> None:
    drawing.widget.show()
    drawing.animation.run(True)
    assert 20 <= drawing.frames() <= 30
    assert sum(drawing.steps) == pytest.approx(1, abs=0.1)


def test_stopped_or_hidden_animation_draws_no_frame(drawing: DrawingHarness) -> None:
    drawing.animation.run(True)
    assert not drawing.frames(), "the widget is not shown yet"
    drawing.widget.show()
    drawing.animation.run(True)
    assert drawing.frames()
    drawing.animation.run(False)
    assert not drawing.frames()
    drawing.animation.run(True)
    drawing.widget.hide()
    assert not drawing.frames()


def test_animation_is_disabled_if_the_system_disables_animations(drawing: DrawingHarness) -> None:
    drawing.widget.setStyleSheet("QWidget { widget-animation-duration: 0 }")
    drawing.widget.show()
    drawing.animation.run(True)
    assert not drawing.animation.is_enabled
    assert not drawing.frames()
