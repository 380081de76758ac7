"""Menu of actions on whole calibrations: copy, equalize, reset, settings files."""

from collections.abc import Sequence
from datetime import datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, QSettings, Slot
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QFileDialog, QMenu, QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.core.files import SettingsError
from trex_gui.devices.trex.model.calibration.moves import symmetric, why_not_symmetric
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.document import put_calibrations, take_calibrations
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION
from trex_gui.devices.trex.protocol.channel_text import CHANNEL_NAMES
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.builders import Handler, action


class ChangeMenu(QMenu):
    """Actions on the calibration of one channel; each is one edit to undo."""

    def __init__(self, device: Device, parent: QWidget) -> None:
        super().__init__(parent)
        self._device = device
        self._channel = 1
        self.files = CalibrationFiles(device, parent)
        self.setObjectName("calibrationMenu")
        self.setToolTipsVisible(True)

        self._copies = self.addMenu(self.tr("&Copy to"))
        self._copies.setObjectName("copyMenu")
        set_icon(self._copies.menuAction(), "copy")
        for channel in CHANNELS:
            text = self.tr("Channel {0} ({1})").format(channel, CHANNEL_NAMES[channel])
            name = f"copyTo{channel}Action"
            self._add(self._copies, name, text, partial(self._copy_to, (channel,)))
        self._copies.addSeparator()
        text = self.tr("&All other channels")
        self._add(self._copies, "copyToAllAction", text, partial(self._copy_to, CHANNELS))

        ends = self.addMenu(self.tr("&Equal travel to both ends"))
        ends.setToolTipsVisible(True)
        self._equals = {
            larger: self._add(ends, name, text, partial(self._make_symmetric, larger))
            for larger, text, name in (
                (False, self.tr("As on the &shorter side"), "symmetricSmallerAction"),
                (True, self.tr("As on the &longer side"), "symmetricLargerAction"),
            )
        }
        reset = self._add(
            self,
            "resetCalibrationAction",
            self.tr("&Reset to factory defaults"),
            self._reset,
            icon="default",
        )
        reset.setToolTip(self.tr("The maker gives no factory defaults: these are assumed"))
        self.addSeparator()
        self._add(
            self,
            "loadCalibrationsAction",
            self.tr("&Load calibrations from a file…"),
            self.files.ask_and_load,
            icon="open",
        )
        self._add(
            self,
            "saveCalibrationsAction",
            self.tr("&Save calibrations to a file…"),
            self.files.ask_and_save,
            icon="save",
        )

    @staticmethod
    def _add(menu: QMenu, name: str, text: str, handler: Handler, icon: str = "") -> QAction:
        made = action(menu, name, text, icon=icon, on_trigger=handler)
        menu.addAction(made)
        return made

    def show_channel(self, channel: int) -> None:
        """Act on a channel; what is impossible is disabled, with the reason as its tool tip."""
        self._channel = channel
        for copy in self._copies.actions():
            copy.setVisible(copy.objectName() != f"copyTo{channel}Action")
        calibrations = self._device.calibrations
        shown = calibrations.shown(channel)
        for larger, equal in self._equals.items():
            reason = ""
            if shown is not None:
                reason = why_not_symmetric(shown, calibrations.source, larger=larger)
            equal.setEnabled(not reason)
            equal.setToolTip(reason)

    def _copy_to(self, channels: Sequence[int], _checked: bool = False) -> None:
        calibrations = self._device.calibrations
        wanted = calibrations.shown(self._channel)
        if wanted is None or wanted.problem():
            return
        text = self.tr("Copy of the calibration of channel {0}").format(self._channel)
        with self._device.draft.one_edit(text):
            for channel in channels:
                if channel != self._channel:
                    calibrations.edit(channel, wanted)

    def _make_symmetric(self, larger: bool, _checked: bool = False) -> None:
        calibrations = self._device.calibrations
        shown = calibrations.shown(self._channel)
        if shown is not None and not shown.problem() and self._equals[larger].isEnabled():
            wanted = symmetric(shown, calibrations.source, larger=larger)
            calibrations.edit(self._channel, wanted)

    @Slot()
    def _reset(self) -> None:
        calibrations = self._device.calibrations
        calibrations.edit(self._channel, DEFAULT_CALIBRATION[calibrations.source])


class CalibrationFiles(QObject):
    """Loads calibrations from settings files and saves them there; reports the result."""

    def __init__(self, device: Device, window: QWidget) -> None:
        super().__init__(window)
        self._device = device
        self._window = window
        self._notifier = device.notifier
        self._store = QSettings(self)

    @Slot()
    def ask_and_load(self) -> None:
        """Let the user choose a file and load its calibrations."""
        chosen, _ = QFileDialog.getOpenFileName(
            self._window,
            self.tr("Load calibrations"),
            str(file_questions.last_folder(self._store)),
            file_questions.file_filter(),
        )
        if chosen:
            self.load_file(Path(chosen))

    @Slot()
    def ask_and_save(self) -> None:
        """Let the user choose a file and save the calibrations in it."""
        chosen, _ = QFileDialog.getSaveFileName(
            self._window,
            self.tr("Save calibrations"),
            str(file_questions.last_folder(self._store) / "calibrations.txt"),
            file_questions.file_filter(),
            options=QFileDialog.Option.DontConfirmOverwrite,  # only the calibrations change
        )
        if chosen:
            self.save_file(Path(chosen))

    def load_file(self, path: Path) -> None:
        """Take the calibrations of a file as edits."""
        try:
            count, left_out = take_calibrations(
                self._device.draft, path, self.tr("Calibrations of {0}").format(path.name)
            )
        except (SettingsError, BadRequest) as error:
            self._notifier.error.emit(
                self.tr("{0} was not taken: {1}.").format(path.name, _plain(error))
            )
            return
        file_questions.remember_folder(self._store, path)
        words = [self.tr("{0} has the same calibrations.").format(path.name)]
        if count:
            one = self.tr("{0} calibration of {1} is an edit now.")
            several = self.tr("{0} calibrations of {1} are edits now.")
            words = [(one if count == 1 else several).format(count, path.name)]
        self._notifier.info.emit(" ".join([*words, *left_out]))

    def save_file(self, path: Path) -> None:
        """Save the calibrations that are shown."""
        shown = self._device.draft.shown
        if shown is None:
            return
        now = datetime.now().astimezone().strftime("%Y-%m-%d %H:%M")
        title = f"Calibrations, saved by TReX Studio, {now}."
        try:
            put_calibrations(shown, path, title)
        except (SettingsError, BadRequest, UnicodeDecodeError) as error:
            self._notifier.error.emit(
                self.tr("{0} was not saved: {1}.").format(path.name, _plain(error))
            )
            return
        file_questions.remember_folder(self._store, path)
        self._notifier.info.emit(self.tr("The calibrations shown were saved in {0}.").format(path))


def _plain(error: Exception) -> str:
    return str(error).rstrip(". ")
