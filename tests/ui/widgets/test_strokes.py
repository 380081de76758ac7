"""Strokes of thin lines, by the resolution of the screen."""

from collections.abc import Iterator

import pytest
from PySide6.QtGui import QImage, QPainter

from trex_gui.ui.widgets.behaviour import strokes


@pytest.fixture
def painter() -> Iterator[QPainter]:
    image = QImage(10, 10, QImage.Format.Format_RGB32)
    with QPainter(image) as painter:
        yield painter


def test_line_has_one_stroke_at_normal_resolution(painter: QPainter) -> None:
    assert len(list(strokes(painter))) == 1


def test_line_has_no_stroke_on_a_device_without_height(painter: QPainter) -> None:
    painter.scale(1, 0)
    assert list(strokes(painter)) == []
