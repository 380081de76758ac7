"""The box beside the cursor: the time, and the values there."""

import math
from collections.abc import Collection

from PySide6.QtCore import QRectF, Qt, Slot
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QLabel, QWidget

from trex_gui.ui.plotting.axes import clock_text
from trex_gui.ui.plotting.data.traces import Traces
from trex_gui.ui.plotting.number_format import value_text
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.bar import MINUS

_BESIDE = 8
"""Pixels between the cursor and the box."""


class Readout(QLabel):
    """Lies over a plot and lets the mouse through."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("cursorReadout")
        self.setAutoFillBackground(True)
        self.setMargin(3)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()
        theme().changed.connect(self._on_theme_changed)
        self._on_theme_changed()

    def text_at(
        self,
        source: Traces,
        time: float,
        mark: float | None,
        origin: float,
        shown: Collection[str],
    ) -> str:
        """Take the values of a source at a time, counted from `origin`; return them as a text."""
        lines = [clock_text(time - origin)]
        if mark is not None:
            since = f"{time - mark:+.3f} s".replace("-", MINUS)
            lines[0] += self.tr(" ({0} from the mark)").format(since)
        for trace in source.traces:
            value = source.value_at(trace.name, time)
            if trace.name in shown and math.isfinite(value):
                lines.append(f"{trace.label}: {value_text(value, trace.unit)}")
        text = "\n".join(lines)
        if text != self.text():
            self.setText(text)
            self.adjustSize()
        return text

    def show_beside(self, x: float, frame: QRectF) -> None:
        """Stand right of a pixel, or left of it where there is no room, within the frame."""
        left = x + _BESIDE
        if left + self.width() > frame.right():
            left = x - _BESIDE - self.width()
        self.move(int(max(left, frame.left())), int(frame.top()) + 4)
        self.show()

    @Slot()
    def _on_theme_changed(self) -> None:
        palette = QPalette()
        palette.setColor(QPalette.ColorRole.Window, theme().color("tool_tip_base"))
        palette.setColor(QPalette.ColorRole.WindowText, theme().color("tool_tip_text"))
        self.setPalette(palette)
