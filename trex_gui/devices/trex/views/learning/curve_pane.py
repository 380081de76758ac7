"""The curve of a channel before and after, with the live dot."""

from PySide6.QtCore import QPointF, QSize, Qt, Signal, Slot
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QHBoxLayout, QLabel, QVBoxLayout, QWidget

from trex_gui.devices.trex.model.learning.channel import LearnedChannel
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.views.learning.parts import Muted
from trex_gui.devices.trex.views.pages.calibration.curve_plot import CurvePlot
from trex_gui.ui.theme.theme import theme

_LEAST_LINES = 13
_LEAST_CHARACTERS = 40


class LineSample(QWidget):
    """A piece of a line as the plot draws it."""

    def __init__(self, color: str, *, dashed: bool, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._color = color
        self._dashed = dashed
        self.setFixedSize(self.fontMetrics().height() * 3 // 2, self.fontMetrics().height())
        theme().changed.connect(self.update)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002 - it is small
        style = Qt.PenStyle.DashLine if self._dashed else Qt.PenStyle.SolidLine
        middle = self.height() / 2
        with QPainter(self) as painter:
            painter.setPen(QPen(theme().color(self._color), 1 if self._dashed else 2, style))
            painter.drawLine(QPointF(0, middle), QPointF(self.width(), middle))


class CurvePane(QWidget):
    """What one channel makes of its input: with what is chosen, and dashed as it was.

    The handles change what is chosen, as the numbers do.

    Signals:
        wished: the calibration that a released handle left.
    """

    wished = Signal(object)

    def __init__(self, learning: Learning, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._learning = learning
        self._channel: LearnedChannel | None = None

        self._plot = CurvePlot(self)
        self._plot.setObjectName("learnCurve")
        self._plot.setMinimumHeight(_LEAST_LINES * self.fontMetrics().lineSpacing())
        self._after_line = LineSample("motor1", dashed=False, parent=self)
        self._after = QLabel(self.tr("proposed"), self)
        self._before_line = LineSample("muted", dashed=True, parent=self)
        self._before = QLabel(self)
        self._before.setObjectName("learnCurveBefore")
        self._live = Muted("", self)
        self._live.setObjectName("learnCurveLive")

        key = QHBoxLayout()
        for widget in (self._after_line, self._after, self._before_line, self._before):
            key.addWidget(widget)
        key.addStretch(1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(key)
        layout.addWidget(self._plot, 1)
        layout.addWidget(self._live)

        self._plot.wished.connect(self.wished)
        learning.measured.connect(self._on_measured)

    @property
    def plot(self) -> CurvePlot:
        """The plot itself."""
        return self._plot

    def minimumSizeHint(self) -> QSize:
        least = super().minimumSizeHint()
        least.setWidth(_LEAST_CHARACTERS * self.fontMetrics().averageCharWidth())
        return least

    def show_channel(self, channel: LearnedChannel) -> None:
        """Show this channel as it is chosen now."""
        self._channel = channel
        before, after = channel.curve_before, channel.curve_after
        choice = channel.choice
        editable = choice is not None and choice.included
        self._plot.show_channel(channel.number, channel.source, before, after, editable=editable)
        for widget in (self._after_line, self._after):
            widget.setVisible(after is not None)
        is_same = before == after
        self._before_line.setVisible(before is not None and not is_same)
        if before is None:
            self._before.setText("")
        else:
            self._before.setText(self.tr("as it was, too") if is_same else self.tr("as it was"))
        self._on_measured()

    @Slot()
    def _on_measured(self) -> None:
        channel = self._channel
        if channel is None or not self.isVisibleTo(self.window()):
            return
        self._plot.set_raw(channel.raw)
        self._plot.set_trace(*self._learning.trace(channel.number))
        self._live.setText(self._live_text(channel))

    def _live_text(self, channel: LearnedChannel) -> str:
        if channel.raw is None:
            return self.tr("No signal now: the output is 0.")
        outputs = []
        for text, curve in (
            (self.tr("proposed {0}"), channel.curve_after),
            (self.tr("as it was {0}"), channel.curve_before),
        ):
            if curve is not None:
                value = f"{curve.output(channel.raw):+d}".replace("-", "−").replace("+0", "0")
                outputs.append(text.format(value))
        where = self.tr("Input now {0}; output {1}.")
        return where.format(channel.source.text(channel.raw), ", ".join(outputs))
