"""Page with the calibrations in a settings file."""

from functools import partial

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.channel_text import calibration_warning
from trex_gui.devices.trex.model.linter import SettingsLinter
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION, CalibrationKey
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.views.findings_list import FindingsList
from trex_gui.devices.trex.views.pages.channels.card import ChannelCard
from trex_gui.devices.trex.views.pages.channels.strips import ChannelStrips
from trex_gui.ui.plotting.page import PlotPage
from trex_gui.ui.widgets.builders import button, row
from trex_gui.ui.widgets.labels import ElidedLabel


class DocumentChannels(PlotPage):
    def __init__(self, draft: SettingsDraft, linter: SettingsLinter, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("editorChannelsPage")
        self._draft = draft
        self._source = InputSource.RC
        self._strips = ChannelStrips(None, self)
        self._card = card = ChannelCard(draft, self)
        self._absence = ElidedLabel("", card)
        self._findings = FindingsList("calibration", card.sources, card, is_wide=True)
        self._add = button(card, "addCalibrationButton", tr("&Add to the file"))
        self._leave_out = button(card, "leaveOutCalibrationButton", tr("Leave out of the fi&le"))
        above, live = (self._findings,), QWidget(card)  # a file has no live value
        card.lay_out(self._absence, above, live, self._add, self._leave_out)
        row((self._strips, 3), (card, 5), into=self, margins=16, spacing=16)

        self._strips.chosen.connect(self._show_channel)
        self._findings.follow(linter, lambda finding: self._key in finding.keys)
        self._add.clicked.connect(self._on_add)
        self._leave_out.clicked.connect(lambda: draft.calibrations.remove(self._key))
        card.source_chosen.connect(self._on_source_chosen)
        card.released.connect(self._show_channel)
        card.rejected.connect(partial(card.note.show_note, alarming=True))
        for changed in (draft.calibrations.changed, draft.parameters.pending_changed):
            changed.connect(self._show_channel)
        self._show_channel()

    @property
    def _key(self) -> CalibrationKey:
        return CalibrationKey.of(self._source, self._strips.channel)

    def add_plot(self) -> None:
        self._card.add_plot()
        self._show_channel()

    @Slot()
    def _show_channel(self) -> None:
        calibrations, options = self._draft.calibrations, self._card.options
        for channel, strip in self._strips.by_channel.items():
            key = CalibrationKey.of(self._source, channel)
            shown = calibrations.shown(key)
            problem = "" if shown is None else calibration_warning(shown, self._source)
            edited = shown != calibrations.stored(key) or options.is_edited(channel)
            strip.set_curve(self._source, options.curve(channel, shown))
            strip.show_mark("warning" if problem else "edited" if edited else "", problem)
        key, shown = self._key, calibrations.shown(self._key)
        after = options.curve(self._strips.channel, shown)
        before = self._draft.stored_curve(key)
        options.show_channel(self._strips.channel, self._source, editable=True)
        self._card.show_channel(key, shown, before, after, editable=shown is not None)
        self._card.note.show_note("")
        self._absence.show_text(
            "" if shown else tr("Not in the file: the board keeps its own calibration.")
        )
        self._add.setEnabled(shown is None)
        self._leave_out.setEnabled(shown is not None)
        self._findings.refresh()

    @Slot(object)
    def _on_source_chosen(self, source: InputSource) -> None:
        self._source = source
        self._show_channel()

    @Slot()
    def _on_add(self) -> None:
        self._draft.calibrations.edit(self._key, DEFAULT_CALIBRATION[self._source])
