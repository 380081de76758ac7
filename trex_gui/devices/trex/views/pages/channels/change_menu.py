"""Menu of actions on whole calibrations: copy, equal travel, reset, settings files."""

from collections.abc import Sequence
from datetime import datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import Signal, Slot
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QFileDialog, QMenu, QWidget

from trex_gui.core.errors import BadRequest, StudioError
from trex_gui.core.files import load
from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.calibration_moves import symmetric, why_not_symmetric
from trex_gui.devices.trex.model.channel_text import CHANNEL_NAMES
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.document import put_calibrations, set_calibrations
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.ui.files import in_background, save_in_background
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.translations import error_sentence
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.builders import Trigger, action, plain


class ChangeMenu(QMenu):
    """Actions on the calibration of one channel. Each edit is one undo step."""

    discard_requested = Signal()  # the user wants to discard the edits of the channel

    def __init__(self, device: Device, parent: QWidget) -> None:
        super().__init__(parent)
        self._device = device
        self._window = parent
        self._channel = 1
        self.setObjectName("calibrationMenu")
        self.setToolTipsVisible(True)

        self._copies = self.addMenu(tr("&Copy to"))
        set_icon(self._copies.menuAction(), "copy")
        for channel in CHANNELS:
            text = tr("Channel {0}: {1}").format(channel, tr(CHANNEL_NAMES[channel]))
            copy = partial(self._copy_to, (channel,))
            self._add(self._copies, f"copyTo{channel}Action", text, copy)
        self._copies.addSeparator()
        text = tr("&All other channels")
        self._add(self._copies, "copyToAllAction", text, partial(self._copy_to, CHANNELS))

        ends = self.addMenu(tr("&Equal travel to both ends"))
        ends.setToolTipsVisible(True)
        shorter, longer = tr("As on the &shorter side"), tr("As on the &longer side")
        equalize = self._set_symmetric
        self._equals = {
            False: self._add(ends, "symmetricSmallerAction", shorter, partial(equalize, False)),
            True: self._add(ends, "symmetricLargerAction", longer, partial(equalize, True)),
        }
        text = tr("&Reset to factory defaults")
        reset = self._add(self, "resetCalibrationAction", text, self._reset, icon="default")
        reset.setToolTip(tr("Assumed values: Pololu publishes no factory defaults"))
        text = tr("&Discard the edits of this channel")
        discard = self.discard_requested.emit
        self._discard = self._add(self, "discardChannelAction", text, discard, icon="undo")
        self.addSeparator()
        text = tr("&Load calibrations from a file…")
        self._add(self, "loadCalibrationsAction", text, self._prompt_and_load, icon="open")
        text, save = tr("&Save calibrations to a file…"), self._prompt_and_save
        self._save = self._add(self, "saveCalibrationsAction", text, save, icon="save")

    @staticmethod
    def _add(menu: QMenu, name: str, text: str, handler: Trigger, icon: str = "") -> QAction:
        made = action(menu, name, text, icon=icon, on_trigger=handler)
        menu.addAction(made)
        return made

    def show_channel(self, channel: int, *, editable: bool, edited: bool) -> None:
        """Set the channel to act on. If it is not editable, only saving is enabled."""
        self._channel = channel
        for change in self.actions():
            change.setEnabled(editable or change is self._save)
        self._discard.setEnabled(edited)
        for copy in self._copies.actions():
            copy.setVisible(copy.objectName() != f"copyTo{channel}Action")
        calibrations = self._device.calibrations
        shown = calibrations.shown(channel)
        for larger, equal in self._equals.items():
            reason = ""
            if shown is not None:
                made = symmetric(shown, calibrations.source, larger=larger)
                reason = why_not_symmetric(made, calibrations.source)
            equal.setEnabled(not reason)
            equal.setToolTip(plain(reason))

    def _copy_to(self, channels: Sequence[int]) -> None:
        calibrations = self._device.calibrations
        wanted = calibrations.shown(self._channel)
        if wanted is None or wanted.problem():
            return
        text = tr("Copy of the calibration of channel {0}").format(self._channel)
        with self._device.draft.one_edit(text):
            for channel in set(channels) - {self._channel}:
                calibrations.edit(channel, wanted)

    def _set_symmetric(self, larger: bool) -> None:
        calibrations = self._device.calibrations
        shown = calibrations.shown(self._channel)
        if shown is not None and not shown.problem() and self._equals[larger].isEnabled():
            calibrations.edit(self._channel, symmetric(shown, calibrations.source, larger=larger))

    @Slot()
    def _reset(self) -> None:
        calibrations = self._device.calibrations
        calibrations.edit(self._channel, DEFAULT_CALIBRATION[calibrations.source])

    # --- Settings files -----------------------------------------------------------------

    def _prompt_and_load(self) -> None:
        title = title_of(tr("&Load calibrations from a file…"))
        path = file_questions.prompt_to_open(self._window, title)
        if path:
            file_questions.remember_folder(path)
            self.load_file(path)

    def _prompt_and_save(self) -> None:
        chosen, _ = QFileDialog.getSaveFileName(
            self._window,
            title_of(tr("&Save calibrations to a file…")),
            str(file_questions.last_folder() / "calibrations.txt"),
            file_questions.file_filter(),
            options=QFileDialog.Option.DontConfirmOverwrite,  # saving replaces only calibrations
        )
        if chosen:
            file_questions.remember_folder(Path(chosen))
            self.save_file(Path(chosen))

    def load_file(self, path: Path) -> None:
        def on_failed(error: StudioError) -> None:
            text = tr("{0} could not be loaded: {1}")
            self._device.notifier.error.emit(text.format(path.name, error_sentence(error)))

        def on_read(settings: Settings) -> None:
            title = tr("Calibrations of {0}").format(path.name)
            try:
                count, left_out = set_calibrations(self._device.draft, settings, title)
            except BadRequest as error:
                on_failed(error)
                return
            loaded = tr("Calibrations loaded from {0} as edits: {1}.")
            text = loaded if count else tr("{0} has the same calibrations.")
            self._device.notifier.info.emit(" ".join([text.format(path.name, count), *left_out]))

        in_background(self, lambda: read_settings(load(path), path.name)[0], on_read, on_failed)

    def save_file(self, path: Path) -> None:
        shown = self._device.draft.shown
        if shown is None:
            return
        now = datetime.now().astimezone().strftime("%Y-%m-%d %H:%M")
        title = f"Calibrations, saved by TReX Studio, {now}."
        saved = tr("The calibrations shown were saved in {0}.").format(path)
        work = partial(put_calibrations, shown, path, title)
        save_in_background(self, work, self._device.notifier, saved)
