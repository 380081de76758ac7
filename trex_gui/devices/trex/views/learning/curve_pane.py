"""The curve of a channel before and after, with the live dot."""

from PySide6.QtCore import QSize, Qt, Signal, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.devices.trex.model.learning.channels import LearnedChannel
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.views.pages.calibration.curve_plot import CurvePlot
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.bar import MINUS
from trex_gui.ui.widgets.builders import column, row
from trex_gui.ui.widgets.labels import LegendKey, Muted

_MIN_LINES = 13
_MIN_CHARACTERS = 40


class CurvePane(QWidget):
    """The curve of one channel: solid as proposed, dashed as it was.

    Its handles change the proposal, as the numbers do.

    Signals:
        edited: the calibration that a released handle left.
    """

    edited = Signal(object)

    def __init__(self, learning: Learning, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._learning = learning
        self._channel: LearnedChannel | None = None

        self.plot = ui.named(CurvePlot(self), "learnCurve")
        self.plot.setMinimumHeight(_MIN_LINES * self.fontMetrics().lineSpacing())
        self._after = LegendKey("", "motor1", self)
        self._before = ui.named(
            LegendKey(self.tr("as it was"), "muted", self, Qt.PenStyle.DashLine), "learnCurveBefore"
        )
        self._live = ui.named(Muted("", self), "learnCurveLive")
        key = row(self._after, self._before, 1)
        column(key, (self.plot, 1), self._live, into=self, margins=0)

        self.plot.edited.connect(self.edited)
        learning.measured.connect(self._on_measured)

    def minimumSizeHint(self) -> QSize:
        least = super().minimumSizeHint()
        least.setWidth(_MIN_CHARACTERS * self.fontMetrics().averageCharWidth())
        return least

    def show_channel(self, channel: LearnedChannel) -> None:
        """Show this channel as it is chosen now."""
        self._channel = channel
        before, after = channel.curve_before, channel.curve_after
        choice = channel.choice
        editable = choice is not None and choice.included
        self.plot.show_channel(channel.number, channel.source, before, after, editable=editable)
        same = before == after
        self._after.setVisible(after is not None)
        self._after.setText(self.tr("proposed, as it was") if same else self.tr("proposed"))
        self._before.setVisible(before is not None and not same)
        self._on_measured()

    @Slot()
    def _on_measured(self) -> None:
        channel = self._channel
        if channel is None or not self.isVisibleTo(self.window()):
            return
        self.plot.set_raw(channel.raw)
        self.plot.set_trace(*self._learning.trace(channel.number))
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
                value = f"{curve.output(channel.raw):+d}".replace("-", MINUS).replace("+0", "0")
                outputs.append(text.format(value))
        where = self.tr("Input now {0}; output {1}.")
        return where.format(channel.source.text(channel.raw), ", ".join(outputs))
