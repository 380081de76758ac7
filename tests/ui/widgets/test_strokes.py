"""Strokes of thin lines, by the resolution of the screen."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import QPointF
from PySide6.QtGui import QImage, QPainter

from trex_gui.ui.widgets.behaviour import strokes


@pytest.fixture
def painter() -> Iterator[QPainter]:
    image = QImage(10, 10, QImage.Format.Format_RGB32)
    with QPainter(image) as painter:
        yield painter


def test_line_has_one_stroke_at_normal_resolution(painter: QPainter) -> None:
    assert len(list(strokes(painter))) == 1


def test_line_has_three_strokes_on_a_screen_of_double_resolution() -> None:
    image = QImage(20, 20, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(2)
    with QPainter(image) as painter:
        offsets = [painter.deviceTransform().map(QPointF()) for _ in strokes(painter)]
        assert sorted(point.toTuple() for point in offsets) == [(0, 0), (0, 1), (1, 0)]
        assert painter.worldTransform().isIdentity()


def test_line_has_no_stroke_on_a_device_without_height(painter: QPainter) -> None:
    painter.scale(1, 0)
    assert list(strokes(painter)) == []
