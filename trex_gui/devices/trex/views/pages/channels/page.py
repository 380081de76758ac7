"""Page of the channels: live strips, and the calibration of the selected channel."""

from collections.abc import Callable, Sequence
from functools import partial

from PySide6.QtCore import Signal, Slot
from PySide6.QtGui import QAction, QShowEvent
from PySide6.QtWidgets import QMenu, QSizePolicy, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model import channel_text
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.linter import BoardLinter
from trex_gui.devices.trex.protocol.calibration import (
    DEFAULT_CALIBRATION,
    Calibration,
    CalibrationKey,
)
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, channels_in
from trex_gui.devices.trex.views.findings_list import FindingsList
from trex_gui.devices.trex.views.pages.channels.card import ChannelCard
from trex_gui.devices.trex.views.pages.channels.controls import CHANNEL_OPTIONS, OtherSource
from trex_gui.devices.trex.views.pages.channels.strips import ChannelStrips
from trex_gui.ui.plotting.page import PlotPage
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.theme.theme import set_look, set_style_property
from trex_gui.ui.units import units
from trex_gui.ui.widgets.behaviour import only_when_visible
from trex_gui.ui.widgets.builders import Trigger, action, button, column, label, named, plain, row
from trex_gui.ui.widgets.labels import PAGE_MARGINS, ElidedLabel, LiveLabel, PageHead


class ChannelsPage(PlotPage):
    learn_requested = Signal(object)  # channels (1 to 5) to learn from stick movements
    test_requested = Signal()
    power_cycle_requested = Signal()

    def __init__(self, device: Device, linter: BoardLinter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("channelsPage")
        self._device = device
        self.source = InputSource.RC  # input source of the calibrations on this page
        self._followed: InputSource | None = None  # active source at the last automatic selection
        self._serial_controls: bool | None = None  # `board.serial_controls` in the visible texts
        self._failures: dict[int, tuple[Calibration | None, str]] = {}
        self._rejection = ""

        learn_all = button(self, "learnAllButton", tr("Learn a&ll…"))
        set_look(learn_all, "primary")
        test = button(self, "testSticksButton", tr("Test stic&ks…"), on_click=self.test_requested)
        self._head = PageHead(tr("Channels"), self, learn_all, test)
        self._strips = ChannelStrips(device, self)

        self._card = card = ChannelCard(device.draft, self)
        self._options = card.options
        self._learned = named(ElidedLabel("", card), "learnedLabel")
        self._learned.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self._role = label(card, "channelDoes", wrap=True, size="caption")
        self._findings = FindingsList("calibration", card.sources, card, is_wide=True)
        self._other = OtherSource(device, card)
        self._live = LiveLabel("channelLive", tr("Live value"), card)
        # Changing values must not change the minimum width of the page.
        self._live.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        set_style_property(self._live, "textSize", "caption")
        self._learn = button(card, "learnButton", tr("Learn &this channel…"))
        self._menu = ChangeMenu(device, self._discard, self)
        self._change = button(card, "changeButton", tr("Cop&y and reset"))
        self._change.setMenu(self._menu)
        set_look(self._change, "link")
        self._head_buttons = (learn_all, test)

        above = self._role, self._findings, self._other
        card.lay_out(self._learned, above, self._live, self._learn, self._change)
        parts = self._head, (row((self._strips, 3), (card, 5), spacing=12), 1)
        column(*parts, into=self, margins=PAGE_MARGINS, spacing=8)

        self._strips.chosen.connect(self._refresh)
        learn_all.clicked.connect(lambda: self.learn_requested.emit(CHANNELS))
        self._learn.clicked.connect(lambda: self.learn_requested.emit((self.channel,)))
        # Show only findings about options. The note shows the `calibration_warning`.
        self._findings.follow(
            linter, lambda finding: not CHANNEL_OPTIONS.keys().isdisjoint(finding.keys)
        )
        card.source_chosen.connect(self._on_source_chosen)
        card.released.connect(self._refresh)
        card.rejected.connect(self._on_rejected)
        self._other.power_cycle_requested.connect(self.power_cycle_requested)
        device.mix_jumper.changed.connect(self._show_texts)
        for changed in (device.link_changed, device.state_changed):
            changed.connect(self._on_device_changed)
        device.applied.connect(self._on_applied)
        device.telemetry.frame_due.connect(self._on_frame_due)
        device.telemetry.text_due.connect(self._on_text_due)
        device.calibrations.changed.connect(self._refresh)
        device.records.changed.connect(self._show_channel)
        device.parameters.pending_changed.connect(self._refresh)
        units().changed.connect(self._on_text_due)
        self._on_device_changed()

    @property
    def channel(self) -> int:
        return self._strips.channel

    @property
    def _is_active(self) -> bool:
        return self.source is self._device.calibrations.source

    @property
    def _is_editable(self) -> bool:
        device = self._device
        return device.is_writable and self._is_active and not device.writer.is_rejected

    def _calibration(self) -> Calibration | None:
        calibrations = self._device.calibrations
        if self._is_active:
            return calibrations.shown(self.channel)
        return self._device.board.memory.hidden_calibration(self.channel, self.source)[0]

    # --- The selected channel -----------------------------------------------------------

    @Slot()
    def _on_device_changed(self) -> None:
        state = self._device.state
        if state is not None and state.source is not self._followed:
            self.source = self._followed = state.source
        self._strips.redraw()
        self._show_channel()

    @Slot()
    def _refresh(self) -> None:
        self._rejection = ""
        self._show_channel()

    def _show_channel(self) -> None:
        channel, editable, is_active = self.channel, self._is_editable, self._is_active
        shown = self._calibration()
        after = self._options.curve(channel, shown)
        before = self._device.draft.stored_curve(channel) if is_active else after
        key = CalibrationKey.of(self.source, channel)
        self._card.show_channel(key, shown, before, after, editable=editable)
        self._show_texts()
        self._show_marks()
        self._show_actions()
        state = self._device.state
        self._other.setVisible(not is_active and state is not None)
        if not is_active and state is not None:
            known = self._device.board.memory.hidden_calibration(channel, self.source)[1]
            self._other.show_source(self.source, state.mode, known)
        self._show_note()
        self._on_frame_due()
        self._on_text_due()

    @Slot()
    def _show_texts(self) -> None:
        device, channel, state = self._device, self.channel, self._device.state
        self._serial_controls = device.board.serial_controls
        self._head.show_state(self._state_text())
        learned = role = ""
        if state is not None:
            if self._is_active:
                is_learned = channel in channels_in(state.calibrated)
                learned = tr("learned") if is_learned else tr("factory calibration")
            role = channel_text.function_text(
                channel,
                state.mode,
                self._options.curve(channel, self._calibration()),
                self.source,
                joint=device.board.is_joint,
                overridden=bool(self._serial_controls) and not state.mode.is_serial,
                mixed=device.mix_jumper.is_on,
            )
        self._learned.show_text(learned)
        self._role.setText(role)

    def _state_text(self) -> str:
        device, state = self._device, self._device.state
        if state is None or not device.is_connected:
            if device.calibrations.stored(1) is None:
                return tr("Connect to a board to see and change its calibrations.")
            return tr(
                "No board responds. Your edits are saved for the next board of the same model."
            )
        source = tr(channel_text.SOURCE_NAMES[state.source])
        text = tr("Inputs are read as {0}. They control the motors.")
        if state.mode.is_serial:
            text = tr("Inputs are read as {0}. In serial mode they are only shown.")
        elif self._serial_controls:
            text = tr("Inputs are read as {0}. Serial commands override them now.")
        return text.format(source)

    def _show_actions(self) -> None:
        is_connected, blocker = self._device.is_connected, self._device.writer.blocker
        reason = blocker
        if not self._is_active:
            state = self._device.state
            reason = channel_text.source_instructions(self.source, state.mode) if state else ""
        for widget in self._head_buttons:
            widget.setEnabled(is_connected and not blocker)
            widget.setToolTip(plain(blocker))
        self._learn.setEnabled(is_connected and not reason)
        self._learn.setToolTip(plain(reason))
        self._options.show_channel(self.channel, self.source, editable=is_connected, blocker=reason)
        self._findings.set_can_accept(is_connected and not reason)
        self._change.setEnabled(self._device.is_writable and self._is_active)
        edited = self._is_edited(self.channel)
        self._menu.show_channel(self.channel, editable=self._is_editable, edited=edited)

    def _is_edited(self, channel: int) -> bool:
        calibrations = self._device.calibrations
        shown = calibrations.shown(channel)
        differs = shown is not None and shown != calibrations.stored(channel)
        return differs or self._options.is_edited(channel)

    def _show_marks(self) -> None:
        calibrations = self._device.calibrations
        for channel, strip in self._strips.by_channel.items():
            shown = calibrations.shown(channel)
            strip.set_curve(calibrations.source, self._options.curve(channel, shown))
            problem = self._failure(channel)
            if shown is not None and not problem:
                problem = channel_text.calibration_warning(shown, calibrations.source)
            mark = "warning" if problem else "edited" if self._is_edited(channel) else ""
            strip.show_mark(mark, problem)

    def _failure(self, channel: int) -> str:
        failed, reason = self._failures.get(channel, (None, ""))
        return reason if failed == self._device.calibrations.shown(channel) else ""

    def _show_note(self) -> None:
        problem = self._problem_text()
        is_connected = self._is_active and self._device.is_connected
        hint = self._device.writer.blocker if is_connected else ""
        self._card.note.show_note(problem or hint, alarming=bool(problem))

    def _problem_text(self) -> str:
        """Return a rejection, a write failure or a warning, or else an empty text."""
        if self._rejection or not self._is_active:
            return self._rejection
        if failure := self._failure(self.channel):
            return failure
        calibration = self._calibration()
        if calibration is None or not self._device.is_connected or self._device.writer.is_rejected:
            return ""
        return channel_text.calibration_warning(calibration, self.source)

    # --- Live values --------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._show_channel()

    def add_plot(self) -> None:
        self._card.add_plot()

    @Slot()
    @only_when_visible
    def _on_frame_due(self) -> None:
        if self._card.plot is not None:
            self._card.plot.set_raw(self._raw)

    @Slot()
    @only_when_visible
    def _on_text_due(self) -> None:
        if self._device.board.serial_controls is not self._serial_controls:
            self._show_texts()
        text, plot = "", self._card.plot
        if self._device.telemetry.raw is not None and self._is_active:
            curve = None if plot is None else plot.curve
            text = channel_text.live_text(self.source, self._raw, curve)
        self._live.setText(text)

    @property
    def _raw(self) -> int | None:
        return self._device.telemetry.raw_of(self.channel) if self._is_active else None

    # --- Edits --------------------------------------------------------------------------

    @Slot(object)
    def _on_source_chosen(self, source: InputSource) -> None:
        self.source = source
        self._refresh()

    @Slot(str)
    def _on_rejected(self, reason: str) -> None:
        self._rejection = reason
        self._show_note()

    def _discard(self) -> None:
        text = tr("Discard edits of channel {0}").format(self.channel)
        with self._device.draft.one_edit(text):
            self._device.calibrations.restore(self.channel)
            self._options.restore(self.channel)

    @Slot(object)
    def _on_applied(self, results: tuple[WriteResult, ...]) -> None:
        for result in results:
            if (channel := result.channel) is None:
                continue
            self._failures.pop(channel, None)
            if result.error is not None:
                reason = channel_text.write_failure(result.error)
                self._failures[channel] = self._device.calibrations.shown(channel), reason
        self._show_channel()


class ChangeMenu(QMenu):
    """Actions on the calibration of one channel. Each edit is one undo step."""

    def __init__(self, device: Device, discard: Callable[[], object], parent: QWidget) -> None:
        super().__init__(parent)
        self._device = device
        self._channel = 1
        self.setObjectName("calibrationMenu")
        self.setToolTipsVisible(True)

        self._copies = self.addMenu(tr("&Copy to"))
        set_icon(self._copies.menuAction(), "copy")
        for channel in CHANNELS:
            text = tr("Channel {0}: {1}").format(channel, tr(channel_text.CHANNEL_NAMES[channel]))
            copy = partial(self._copy_to, (channel,))
            self._add(self._copies, f"copyTo{channel}Action", text, copy)
        self._copies.addSeparator()
        text = tr("&All other channels")
        self._add(self._copies, "copyToAllAction", text, partial(self._copy_to, CHANNELS))

        text = tr("&Reset to factory defaults")
        reset = self._add(self, "resetCalibrationAction", text, self._reset, icon="default")
        reset.setToolTip(tr("Assumed values: Pololu publishes no factory defaults"))
        text = tr("&Discard the edits of this channel")
        self._discard = self._add(self, "discardChannelAction", text, discard, icon="undo")

    @staticmethod
    def _add(menu: QMenu, name: str, text: str, handler: Trigger, icon: str = "") -> QAction:
        new_action = action(menu, name, text, icon=icon, on_trigger=handler)
        menu.addAction(new_action)
        return new_action

    def show_channel(self, channel: int, *, editable: bool, edited: bool) -> None:
        self._channel = channel
        for menu_action in self.actions():
            menu_action.setEnabled(editable)
        self._discard.setEnabled(edited)
        for copy in self._copies.actions():
            copy.setVisible(copy.objectName() != f"copyTo{channel}Action")

    def _copy_to(self, channels: Sequence[int]) -> None:
        calibrations = self._device.calibrations
        calibration = calibrations.shown(self._channel)
        if calibration is None or calibration.problem():
            return
        text = tr("Copy calibration of channel {0}").format(self._channel)
        with self._device.draft.one_edit(text):
            for channel in set(channels) - {self._channel}:
                calibrations.edit(channel, calibration)

    @Slot()
    def _reset(self) -> None:
        calibrations = self._device.calibrations
        calibrations.edit(self._channel, DEFAULT_CALIBRATION[calibrations.source])
