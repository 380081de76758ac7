"""The slider of a joint, and spin boxes for speeds."""

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRect, QSignalBlocker, QSize, Qt, QTimer, Slot
from PySide6.QtGui import QFocusEvent, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.aracna.model.texts import speed_text
from trex_gui.devices.aracna.protocol.joints import HIGHEST, Limits
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.sliders import PressSlider

_WEDGE = 7


class JointSlider(PressSlider):
    """A slider 0-1023: the handle is the goal, the wedge below is the present position.

    Beyond the limits the groove is thin and grey.
    """

    room_below = _WEDGE

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(0, HIGHEST, parent)
        self._limits = Limits()
        self._present: int | None = None
        self.setSingleStep(4)
        self.setPageStep(50)

    def spoken_state(self) -> str:
        if self._present is None:
            return tr("Present position unknown")
        return tr("Present position {0}").format(self._present)

    def set_limits(self, limits: Limits) -> None:
        if limits != self._limits:
            self._limits = limits
            self.update()

    def set_present(self, present: int | None) -> None:
        if present != self._present:
            self._present = present
            self.update()

    def sizeHint(self) -> QSize:
        hint = super().sizeHint()
        return QSize(max(hint.width(), 200), hint.height() + _WEDGE)

    def minimumSizeHint(self) -> QSize:
        return QSize(70, self.sizeHint().height())

    def paint_groove(self, painter: QPainter, handle: QRect) -> None:
        middle = handle.center().y()
        left, right = self.x_of(0, handle), self.x_of(HIGHEST, handle)
        painter.setPen(QPen(theme().color("track_edge")))
        painter.setBrush(theme().color("track_off"))
        painter.drawRect(QRect(left, middle - 3, right - left, 7))
        start, end = self.x_of(self._limits.low, handle), self.x_of(self._limits.high, handle)
        painter.setBrush(theme().color("track" if self.isEnabled() else "track_off"))
        painter.setPen(QPen(theme().color("neutral")))
        painter.drawRect(QRect(start, middle - 4, max(end - start, 1), 9))

    def paint_below(self, painter: QPainter, handle: QRect) -> None:
        if self._present is None:
            return
        x, bottom = self.x_of(self._present, handle) + 0.5, float(self.height())
        top = handle.bottom() + 1.0
        wedge = [QPointF(x, top), QPointF(x - 4.5, bottom), QPointF(x + 4.5, bottom)]
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme().color("bar"))
        painter.drawPolygon(QPolygonF(wedge))


class SpeedBox(ui.SpinBox):
    """A speed setting, 0-1023, and its meaning; 0 is unlimited."""

    def __init__(self, name: str, accessible: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        ui.named(self, name, accessible=accessible)
        self.setLocale(ui.UNGROUPED)
        self.setRange(0, HIGHEST)
        self.setSingleStep(10)
        self.setKeyboardTracking(False)
        self.setToolTip(
            tr(
                "Speed setting 1-1023, 0.669 °/s each; 0 is unlimited, not “stopped”. "
                "Above about 870 (AX-18A) or 530 (AX-12A) a servo gets no faster."
            )
        )
        self.valueChanged.connect(self.update_suffix)
        self.update_suffix()

    @Slot()
    def update_suffix(self) -> None:
        """Show the meaning of a value that was set with signals blocked."""
        value = self.value()
        self.setSuffix(f" = {speed_text(value)}" if value else tr(" = fastest"))


class CommonSpeedBox(SpeedBox):
    """The speed that all motors share; if they differ, it says so until one is chosen."""

    _DIFFER = -1

    def __init__(self, name: str, accessible: str, parent: QWidget | None = None) -> None:
        super().__init__(name, accessible, parent)
        self.setMinimumWidth(self.sizeHint().width())  # does not change when they differ

    @property
    def differ(self) -> bool:
        return self.value() == self._DIFFER

    def show_speeds(self, speeds: Sequence[int]) -> None:
        """Show the speeds of all motors without a signal; keep what the user is typing."""
        value = speeds[0] if len(set(speeds)) == 1 else self._DIFFER
        lowest = min(value, 0)
        if (value, lowest) == (self.value(), self.minimum()):
            return
        with QSignalBlocker(self):
            self.setMinimum(lowest)
            self.setSpecialValueText(tr("differ") if value == self._DIFFER else "")
            self.setValue(value)
        self.update_suffix()

    def stepBy(self, steps: int) -> None:
        if not self.differ:
            super().stepBy(steps)
        elif steps > 0:
            self.setValue(steps * self.singleStep())

    def focusInEvent(self, event: QFocusEvent) -> None:
        """Let the user type a speed over the text, also after a click."""
        super().focusInEvent(event)
        if self.differ:
            QTimer.singleShot(0, self, self.selectAll)
