"""Card of one channel, for a board or a file: curve, fields, options and note."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QSignalBlocker, Qt, Signal, Slot
from PySide6.QtWidgets import QTabBar, QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.model.channel_text import CHANNEL_NAMES
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.views.note_field import NoteField
from trex_gui.devices.trex.views.pages.channels.controls import CalibrationFields, ChannelOptions
from trex_gui.ui.theme.theme import set_look
from trex_gui.ui.translations import error_sentence
from trex_gui.ui.widgets.builders import Card, column, label, named, row, tab_order
from trex_gui.ui.widgets.labels import LegendKey, Note

if TYPE_CHECKING:
    from trex_gui.devices.trex.views.pages.channels.curve_plot import CurvePlot

_SOURCES = (InputSource.RC, InputSource.ANALOG)


class ChannelCard(Card):
    source_chosen = Signal(object)  # `InputSource` of the tab that the user has opened
    released = Signal()  # the user released a handle of the curve
    rejected = Signal(str)  # reason why an edit was rejected, for the user

    def __init__(self, draft: SettingsDraft, parent: QWidget) -> None:
        super().__init__("", parent)
        self.setObjectName("channelCard")
        self._draft = draft
        self._key = CalibrationKey.RC_CHANNEL_1
        self._is_editable = False
        self._before: ChannelCurve | None = None
        self.plot: CurvePlot | None = None
        self._title = label(self, "channelTitle", size="heading")
        self.sources = named(QTabBar(self), "sourceTabs", accessible=tr("Input source"))
        set_look(self.sources, "switch")
        self.sources.setDrawBase(False)
        self.sources.setUsesScrollButtons(False)
        self.sources.addTab(tr("RC pulses"))
        self.sources.addTab(tr("Analog"))
        self._legend = (
            LegendKey(tr("edited"), "pointer", self),
            LegendKey(tr("stored"), "muted", self, Qt.PenStyle.DashLine),
        )
        self.note = named(Note(1, self), "calibrationNote")
        self._fields = CalibrationFields(self)
        self.options = ChannelOptions(draft.parameters, self)
        self._note_field = NoteField(draft.notes, "channelNoteEdit", self, lines=1)
        self.sources.currentChanged.connect(lambda tab: self.source_chosen.emit(_SOURCES[tab]))
        self._fields.edited.connect(self._on_edited)
        self._fields.rejected.connect(self.rejected)

    def lay_out(
        self, beside: QWidget, above: Sequence[QWidget], live: QWidget, start: QWidget, end: QWidget
    ) -> None:
        """Place the page's widgets beside the title, above the curve and around the note field."""
        title = row(self._title, (beside, 1), self.sources, spacing=12)
        legend = row((live, 1), *self._legend, spacing=16)
        below = row(start, (self._note_field, 1), end, spacing=8)
        parts = column(title, *above, legend, spacing=4), self.note, self._fields, self.options
        self._inside = column(*parts, below, into=self, spacing=6)
        for widget in (*above, self._fields, self.options, start, self._note_field, end):
            widget.raise_()  # for `tab_order`, which follows the order of the children
        tab_order(self)

    def add_plot(self) -> None:
        """Add the curve plot. This imports pyqtgraph."""
        from trex_gui.devices.trex.views.pages.channels.curve_plot import CurvePlot  # noqa: PLC0415

        self.plot = plot = CurvePlot(self)
        plot.setObjectName("curvePlot")
        plot.previewed.connect(self._on_previewed)
        plot.released.connect(self.released)
        plot.edited.connect(self._on_edited)
        self._inside.insertWidget(1, plot, 1)

    def show_channel(
        self,
        key: CalibrationKey,
        shown: Calibration | None,
        before: ChannelCurve | None,
        after: ChannelCurve | None,
        *,
        editable: bool,
    ) -> None:
        channel, name = key.channel, tr(CHANNEL_NAMES[key.channel])
        self._key, self._before, self._is_editable = key, before, editable
        self._title.setText(f"{channel}  {name}")
        self.setAccessibleName(tr("Channel {0}: {1}").format(channel, name))
        with QSignalBlocker(self.sources):
            self.sources.setCurrentIndex(_SOURCES.index(key.source))
        self._fields.show_calibration(key.source, shown, editable=editable)
        self._note_field.show_note_on(key, tr("the calibration of {0}").format(key.label))
        self._show_legend(before != after)
        if self.plot is not None:
            self.plot.show_channel(channel, key.source, before, after, editable=editable)

    def _show_legend(self, differs: bool) -> None:
        for key in self._legend:
            key.setVisible(differs)

    @Slot(object)
    def _on_previewed(self, calibration: Calibration) -> None:
        self._fields.show_calibration(self._key.source, calibration, editable=self._is_editable)
        self._show_legend(self.plot is not None and self.plot.curve != self._before)

    @Slot(object)
    @Slot(object, object)
    def _on_edited(self, calibration: Calibration, run: object = None) -> None:
        try:
            self._draft.calibrations.edit(self._key, calibration, run=run)
        except BadRequest as error:
            self.rejected.emit(error_sentence(error))
