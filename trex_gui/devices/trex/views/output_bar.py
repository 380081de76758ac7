"""The bar of what comes out: a remapped channel, a motor's speed, the auxiliary output."""

from PySide6.QtCore import QRect, QRectF, Qt
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import QWidget

from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.ui.widgets.bar import Bar, with_sign

_OVERSHOOT = 2


class OutputBar(Bar):
    """Shows -127 to 127 from the centre, or 0 to 127 from the left.

    `color` and `negative` are names of the theme; a motor's bar takes its motor's colour.
    """

    def __init__(
        self,
        parent: QWidget | None = None,
        *,
        label: str = "",
        bipolar: bool = True,
        color: str = "bar",
        negative: str | None = None,
    ) -> None:
        self._label = label
        self._bipolar = bipolar
        self._value: int | None = None
        super().__init__(color, negative or ("bar_negative" if color == "bar" else color), parent)
        self.setAccessibleName(label or self.tr("Output"))
        self._refresh()

    def set_label(self, label: str) -> None:
        """Write this to the left of the bar."""
        self._label = label
        self.setAccessibleName(label or self.tr("Output"))
        self._forget_layout()
        self.updateGeometry()
        self.update()

    def set_value(self, value: int | None) -> None:
        """Show a value, kept within the bar; `None` means that there is no valid signal."""
        if self._heard and value == self._value:
            return
        self._heard = True
        self._value = value
        self._refresh()

    @property
    def value(self) -> int | None:
        return self._value

    def x_of(self, value: float) -> float:
        """Return where a value lies, in pixels from the left of the widget."""
        track = self._track()
        low = -FULL_SCALE if self._bipolar else 0
        part = min(max((value - low) / (FULL_SCALE - low), 0.0), 1.0)
        return track.left() + part * track.width()

    def _forget_value(self) -> None:
        self._value = None

    def _has_signal(self) -> bool:
        return self._value is not None

    def _value_text(self) -> str:
        if self._value is None:
            return ""
        return with_sign(self._value) if self._bipolar else str(self._value)

    def _spoken_value(self) -> str:
        return self.tr("{value} of {full}").format(value=self._value_text(), full=FULL_SCALE)

    def _widest_value(self) -> str:
        return with_sign(-FULL_SCALE) if self._bipolar else str(FULL_SCALE)

    def _height(self) -> int:
        return self.fontMetrics().height() + 2 + 2 * _OVERSHOOT + 2

    def _label_column(self) -> int:
        if not self._label:
            return 0
        metrics = self.fontMetrics()
        return metrics.horizontalAdvance(self._label) + metrics.averageCharWidth()

    def _lay_out(self) -> QRect:
        height = self.fontMetrics().height() + 2
        left = self._label_column() + 1
        width = self.width() - left - self._value_column() - 2
        return QRect(left, (self.height() - height) // 2, max(width, 1), height)

    def _look(self) -> tuple[object, ...]:
        return (self._label, self._bipolar)

    def _paint_static(self, painter: QPainter, track: QRect) -> None:
        painter.setPen(self._marks.text)
        if self._label:
            box = QRect(0, track.top(), self._label_column(), track.height())
            painter.drawText(box, Qt.AlignmentFlag.AlignVCenter, self._label)
        if not self._caption():
            self._paint_zero(painter, track)

    def _paint_zero(self, painter: QPainter, track: QRect) -> None:
        x = self._snap(self.x_of(0) - 0.5)
        top, height = track.top() - _OVERSHOOT, track.height() + 2 * _OVERSHOOT
        painter.fillRect(QRectF(x, top, 1, height), self._marks.mark)

    def _paint_live(self, painter: QPainter, track: QRect) -> None:
        value = self._value
        if value is None:
            return
        color = self._marks.fill if value > 0 else self._marks.negative
        self._paint_fill(painter, track, self.x_of(0), self.x_of(value), color)
        self._paint_zero(painter, track)
        self._paint_pointer(painter, track, self.x_of(value), 0)
