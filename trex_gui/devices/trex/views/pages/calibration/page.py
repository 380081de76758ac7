"""Page to calibrate channels: the curve with handles, the live input, the numbers."""

from typing import TYPE_CHECKING

from PySide6.QtCore import Signal, Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model import channel_text
from trex_gui.devices.trex.model.calibration_moves import Handle
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.linter import BoardLinter
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.settings.writer import calibration_text
from trex_gui.devices.trex.views.findings_list import FindingsList
from trex_gui.devices.trex.views.note_field import NoteField
from trex_gui.devices.trex.views.pages.calibration.change_menu import ChangeMenu
from trex_gui.devices.trex.views.pages.calibration.fields import (
    CHANNEL_OPTIONS,
    CalibrationFields,
    ChannelOptions,
)
from trex_gui.devices.trex.views.pages.calibration.heading import (
    ChannelHeading,
    ChannelList,
    CurveLegend,
    OtherSource,
)
from trex_gui.ui.plotting.page import PlotPage
from trex_gui.ui.translations import error_sentence
from trex_gui.ui.units import units
from trex_gui.ui.widgets.bar import MINUS
from trex_gui.ui.widgets.behaviour import only_when_visible
from trex_gui.ui.widgets.builders import button, column, label, named, plain, row
from trex_gui.ui.widgets.labels import ElidedLabel, Note

if TYPE_CHECKING:
    from trex_gui.devices.trex.views.pages.calibration.curve_plot import CurvePlot


_HANDLES = {
    "minimum": Handle.MINIMUM,
    "neutral": Handle.NEUTRAL,
    "maximum": Handle.MAXIMUM,
    "deadband": Handle.DEADBAND_HIGH,
}


class CalibrationPage(PlotPage):
    """The channels, and curve, numbers and switches of the selected one."""

    learn_requested = Signal(object)  # the channels, 1 to 5, to learn from the user's movements
    power_cycle_requested = Signal()

    def __init__(self, device: Device, linter: BoardLinter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("calibrationPage")
        self._device = device
        self.source = InputSource.RC  # the input source whose calibrations are shown
        self._followed: InputSource | None = None
        self._failures: dict[int, tuple[Calibration | None, str]] = {}
        self._rejection = ""
        self._plot: CurvePlot | None = None

        text = tr("Connect to a board to see and change its calibrations.")
        self._empty = label(self, "calibrationEmpty", text)
        self._body = body = QWidget(self)
        self._channels = ChannelList(body)
        self._heading = ChannelHeading(device, body)
        self._other = OtherSource(device, body)
        self._legend = CurveLegend(body)
        self._findings = FindingsList("calibration", self._heading, body, is_wide=True)
        self._fields = CalibrationFields(body)
        self._both = named(ElidedLabel("", body), "otherSetLabel")
        self._note = named(Note(2, body), "calibrationNote")
        self._why = NoteField(device.draft.notes, "channelNoteEdit", body, lines=2)
        why = label(body, text=tr("&Note:"), buddy=self._why)
        self._options = ChannelOptions(device.parameters, body)
        self._learn = button(body, "learnButton", tr("Learn &this channel…"), icon="calibrate")
        self._learn_all = button(body, "learnAllButton", tr("Learn a&ll…"))
        self._menu = ChangeMenu(device, self)
        self.files = self._menu.files
        self._change = button(body, "changeButton", tr("Cop&y, reset, files"))
        self._change.setMenu(self._menu)
        text, tip = tr("Di&scard"), tr("Discard the edits of this channel")
        self._discard = button(body, "discardChannelButton", text, icon="undo", tip=tip)

        # Findings are at the top: on a low screen what is below the plot may have to be scrolled.
        above = column(self._heading, self._findings, self._other, self._legend)
        buttons = row(self._learn, self._learn_all, 1, self._change, self._discard, spacing=2)
        notes = row((self._note, 2), why, (self._why, 1))
        self._right = column(above, self._fields, self._both, notes, self._options, buttons)
        row(self._channels, (self._right, 1), into=body, margins=0)
        layout = column(self._empty, (body, 1), 0, into=self)
        margins = layout.contentsMargins()
        layout.setContentsMargins(4, margins.top(), 4, 2)

        self._learn.clicked.connect(lambda: self.learn_requested.emit((self.channel,)))
        self._learn_all.clicked.connect(lambda: self.learn_requested.emit(CHANNELS))
        self._discard.clicked.connect(self._on_discard_clicked)
        # `concern` is about the calibration that is shown; these are about the options.
        self._findings.follow(linter, lambda found: not CHANNEL_OPTIONS.isdisjoint(found.keys))
        self._channels.chosen.connect(self._refresh)
        self._heading.source_chosen.connect(self._on_source_chosen)
        self._fields.edited.connect(self._on_edited)
        self._fields.rejected.connect(self._on_rejected)
        self._other.power_cycle_requested.connect(self.power_cycle_requested)
        device.mix_jumper.changed.connect(self._show_heading)
        for changed in (device.link_changed, device.state_changed):
            changed.connect(self._on_device_changed)
        device.applied.connect(self._on_applied)
        device.telemetry.frame_due.connect(self._on_frame_due)
        device.telemetry.text_due.connect(self._on_text_due)
        device.calibrations.changed.connect(self._refresh)
        device.kept.changed.connect(self._show_channel)
        device.parameters.pending_changed.connect(self._refresh)
        self._on_device_changed()

    @property
    def channel(self) -> int:
        """The chosen channel, 1 to 5."""
        return self._channels.channel

    @property
    def _is_active(self) -> bool:
        """Whether the board reads the input source that is shown."""
        return self.source is self._device.calibrations.source

    @property
    def _editable(self) -> bool:
        device = self._device
        return device.is_writable and self._is_active and not device.writer.is_rejected

    def _calibration(self) -> Calibration | None:
        calibrations = self._device.calibrations
        if self._is_active:
            return calibrations.shown(self.channel)
        return self._device.board.memory.hidden_calibration(self.channel, self.source)[0]

    @Slot()
    def _on_device_changed(self) -> None:
        state = self._device.state
        if state is not None and state.source is not self._followed:
            self.source = self._followed = state.source
        known = self._device.calibrations.stored(1) is not None
        self._empty.setVisible(not known)
        self._body.setVisible(known)
        self._show_channel()

    @Slot()
    def _refresh(self) -> None:
        """Show the channel without a message about a rejected value."""
        self._clear_rejection()
        self._show_channel()

    def _show_channel(self) -> None:
        channel, editable, is_active = self.channel, self._editable, self._is_active
        shown = self._calibration()
        after = self._options.curve(channel, shown)
        before = self._device.draft.stored_curve(channel) if is_active else after
        self._fields.show_calibration(self.source, shown, editable=editable)
        key = CalibrationKey.of(self.source, channel)
        self._why.show_note_on(key, tr("the calibration of {0}").format(key.label))
        self._show_actions()
        self._menu.show_channel(channel, editable=editable)
        self._change.setEnabled(self._device.is_writable and is_active)
        self._show_heading()
        self._legend.set_curves(shown is not None, differs=before != after, live=is_active)
        self._other.setVisible(not is_active)
        if not is_active:
            known = self._device.board.memory.hidden_calibration(channel, self.source)[1]
            self._other.show_source(self.source, known)
        if self._plot is not None:
            self._plot.show_channel(channel, self.source, before, after, editable=editable)
            self._plot.trace.setVisible(is_active)
        self._both.show_text(self._other_set_text())
        self._show_marks()
        self._show_note()
        self._on_frame_due()
        self._on_text_due()

    def _other_set_text(self) -> str:
        """Return the calibration for the input source that is not shown, on one line."""
        source = InputSource.ANALOG if self.source is InputSource.RC else InputSource.RC
        name, calibrations = tr(channel_text.SOURCE_NAMES[source]), self._device.calibrations
        calibration, known = calibrations.shown(self.channel), None
        if source is not calibrations.source:
            calibration, known = self._device.board.memory.hidden_calibration(self.channel, source)
        if calibration is None:
            return tr("For {0}: not read yet").format(name)
        values = calibration_text(source, calibration)
        if known is None:
            return tr("For {0}: {1}").format(name, values)
        return tr("For {0}, {1}: {2}").format(name, channel_text.known_text(known), values)

    @Slot()
    def _show_heading(self) -> None:
        channel, shown = self.channel, self._calibration()
        self._heading.show_channel(
            channel,
            self.source,
            self._options.curve(channel, shown),
            edited=self._is_active and shown != self._device.calibrations.stored(channel),
            mixed=self._device.mix_jumper.is_on,
        )

    def _show_actions(self) -> None:
        is_connected, reason = self._device.is_connected, self._device.writer.blocker
        if not self._is_active:
            read = tr(channel_text.SOURCE_NAMES[self._device.calibrations.source])
            shown = tr(channel_text.SOURCE_NAMES[self.source])
            reason = tr(
                "The board reads {0} now. Open their tab, or make the board read {1} first, as "
                "described above."
            ).format(read, shown)
        for learn in (self._learn, self._learn_all):
            learn.setEnabled(is_connected and not reason)
            learn.setToolTip(plain(reason))
        self._options.show_channel(self.channel, self.source, editable=is_connected, blocker=reason)
        self._findings.set_can_accept(is_connected and not reason)

    def _show_marks(self) -> None:
        calibrations = self._device.calibrations
        for channel in CHANNELS:
            shown = calibrations.shown(channel)
            edited = self._options.is_edited(channel) or (
                shown is not None and shown != calibrations.stored(channel)
            )
            problem = self._failure(channel)
            if shown is not None and not problem:
                problem = channel_text.concern(shown, calibrations.source)
            self._channels.set_mark(channel, edited=edited, problem=problem)
            if channel == self.channel:
                self._discard.setEnabled(edited and self._device.is_writable and self._is_active)

    def _failure(self, channel: int) -> str:
        failed, why = self._failures.get(channel, (None, ""))
        return why if failed == self._device.calibrations.shown(channel) else ""

    def _show_note(self) -> None:
        problem = self._problem_text()
        self._note.show_note(problem or self._hint_text(), alarming=bool(problem))

    def _problem_text(self) -> str:
        """Return why a value was rejected or not stored, or a concern; empty: none."""
        if self._rejection or not self._is_active:
            return self._rejection
        if failure := self._failure(self.channel):
            return failure
        calibration = self._calibration()
        if calibration is None or not self._device.is_connected or self._device.writer.is_rejected:
            return ""
        return channel_text.concern(calibration, self.source)

    def _hint_text(self) -> str:
        if not self._is_active:
            return ""
        if not self._device.is_connected:
            return tr(
                "No board responds. Edits are kept until a board of the same kind is connected."
            )
        if blocker := self._device.writer.blocker:
            return blocker
        values, counts = f"1500 µs, {Number(1.5)} ms", "3750"
        if self.source is InputSource.ANALOG:
            values, counts = f"{Number(2.5)} V, 2500 mV", "512"
        return tr(
            "Drag a handle of the curve, or type {0} or {1} counts. Nothing is written until you "
            "click Apply."
        ).format(values, counts)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._show_channel()

    def add_plot(self) -> None:
        from trex_gui.devices.trex.views.pages.calibration.curve_plot import CurvePlot  # noqa: PLC0415

        self._plot = plot = CurvePlot(self._body)
        plot.setObjectName("curvePlot")
        plot.previewed.connect(self._on_previewed)
        plot.released.connect(self._refresh)
        plot.edited.connect(self._on_edited)
        self._right.insertWidget(1, plot, 1)

    @Slot()
    @only_when_visible
    def _on_frame_due(self) -> None:
        if self._plot is not None:
            self._plot.set_raw(self._raw)
            if self._is_active:
                inputs = self._device.telemetry.inputs
                values = inputs.values(self.channel - 1)
                self._plot.trace.set_samples(inputs.times, values, self._device.telemetry.latest)

    @Slot()
    @only_when_visible
    def _on_text_due(self) -> None:
        telemetry, source = self._device.telemetry, self._device.calibrations.source
        for channel in CHANNELS:
            raw = telemetry.raw_of(channel)
            text = tr("N/A") if telemetry.raw is None else tr("no signal")
            self._channels.set_input(channel, text if raw is None else source.text(raw))
        self._legend.set_live(self._live_text(self._raw))

    @property
    def _raw(self) -> int | None:
        """The raw count of the chosen channel, if the board measures it now."""
        return self._device.telemetry.raw_of(self.channel) if self._is_active else None

    def _live_text(self, raw: int | None) -> str:
        if not self._is_active:
            return tr("no live value: the board reads the other source")
        if self._device.telemetry.raw is None:
            return tr("no live value")
        if raw is None:
            return tr("no signal now: the output is 0")
        curve = self._plot.curve if self._plot is not None else None
        output = curve.output(raw) if curve is not None else 0
        counts = tr("%n count(s)", "", raw)
        return tr("input now {0} ({1}), output {2}").format(
            *units().ordered(self.source.text(raw), counts), f"{output}".replace("-", MINUS)
        )

    @Slot(object)
    def _on_source_chosen(self, source: InputSource) -> None:
        self.source = source
        self._refresh()

    @Slot(object)
    def _on_previewed(self, calibration: Calibration) -> None:
        """Show the numbers of a held handle, and why it cannot move further."""
        self._fields.show_calibration(self.source, calibration, editable=self._editable)
        if self._plot is not None:
            self._rejection = self._plot.handles.message
            differs = self._plot.curve != self._device.draft.stored_curve(self.channel)
            self._legend.set_curves(True, differs=differs, live=True)
        self._show_note()

    @Slot(object)
    @Slot(object, object)
    def _on_edited(self, calibration: Calibration, run: object = None) -> None:
        try:
            self._device.calibrations.edit(self.channel, calibration, run=run)
        except BadRequest as error:
            self._on_rejected(error_sentence(error))

    @Slot(str, str)
    def _on_rejected(self, why: str, field: str = "") -> None:
        self._clear_rejection()
        self._rejection = why
        if self._plot is not None and field in _HANDLES:
            self._plot.show_message(_HANDLES[field], why)
        self._show_note()

    def _clear_rejection(self) -> None:
        self._rejection = ""
        if self._plot is not None:
            self._plot.show_message(None, "")

    @Slot()
    def _on_discard_clicked(self) -> None:
        text = tr("Discard edits of channel {0}").format(self.channel)
        with self._device.draft.one_edit(text):
            self._device.calibrations.restore(self.channel)
            self._options.restore(self.channel)

    @Slot(object)
    def _on_applied(self, results: tuple[WriteResult, ...]) -> None:
        """Remember why the board did not store a calibration."""
        for result in results:
            if (channel := result.channel) is None:
                continue
            self._failures.pop(channel, None)
            if result.error is not None:
                why = channel_text.write_failure(result.error)
                self._failures[channel] = self._device.calibrations.shown(channel), why
        self._show_channel()
