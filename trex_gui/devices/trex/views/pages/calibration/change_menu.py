"""What can be done with a whole calibration: copy, make symmetric, reset, files."""

from collections.abc import Sequence
from functools import partial

from PySide6.QtCore import Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QWidget

from trex_gui.devices.trex.model.calibration.moves import symmetric, why_not_symmetric
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION
from trex_gui.devices.trex.protocol.channel_text import CHANNEL_NAMES
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.ui.theme.icons import set_icon


class ChangeMenu(QMenu):
    """Each entry is one edit to undo.

    Signals:
        load_requested, save_requested: a settings file, of which the calibrations matter.
    """

    load_requested = Signal()
    save_requested = Signal()

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._channel = 1
        self.setObjectName("calibrationMenu")
        self.setToolTipsVisible(True)

        self._copies = self.addMenu(self.tr("&Copy to"))
        self._copies.setObjectName("copyMenu")
        set_icon(self._copies.menuAction(), "copy")
        for channel in CHANNELS:
            text = self.tr("Channel {0} ({1})").format(channel, CHANNEL_NAMES[channel])
            action = self._copies.addAction(text)
            action.setObjectName(f"copyTo{channel}Action")
            action.triggered.connect(partial(self._copy_to, (channel,)))
        self._copies.addSeparator()
        everywhere = self._copies.addAction(self.tr("&All other channels"))
        everywhere.setObjectName("copyToAllAction")
        everywhere.triggered.connect(partial(self._copy_to, CHANNELS))

        ends = self.addMenu(self.tr("&Equal travel to both ends"))
        ends.setToolTipsVisible(True)
        self._equals: dict[bool, QAction] = {}
        for larger, text, name in (
            (False, self.tr("As on the &shorter side"), "symmetricSmallerAction"),
            (True, self.tr("As on the &longer side"), "symmetricLargerAction"),
        ):
            action = ends.addAction(text)
            action.setObjectName(name)
            action.triggered.connect(partial(self._make_symmetric, larger))
            self._equals[larger] = action
        reset = self.addAction(self.tr("&Reset to the factory's"))
        reset.setObjectName("resetCalibrationAction")
        reset.setToolTip(self.tr("The maker gives no factory values: these are assumed ones"))
        set_icon(reset, "default")
        reset.triggered.connect(self._reset)
        self.addSeparator()
        load = self.addAction(self.tr("&Load calibrations from a file…"))
        load.setObjectName("loadCalibrationsAction")
        set_icon(load, "open")
        save = self.addAction(self.tr("&Save calibrations to a file…"))
        save.setObjectName("saveCalibrationsAction")
        set_icon(save, "save")
        load.triggered.connect(self.load_requested)
        save.triggered.connect(self.save_requested)

    def show_channel(self, channel: int) -> None:
        """Let the entries be about a channel; those that would spoil it are greyed, with why."""
        self._channel = channel
        for action in self._copies.actions():
            action.setVisible(action.objectName() != f"copyTo{channel}Action")
        calibrations = self._device.calibrations
        shown = calibrations.shown(channel)
        for larger, action in self._equals.items():
            why = ""
            if shown is not None:
                why = why_not_symmetric(shown, calibrations.source, larger=larger)
            action.setEnabled(not why)
            action.setToolTip(why)

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

    def _reset(self) -> None:
        calibrations = self._device.calibrations
        calibrations.edit(self._channel, DEFAULT_CALIBRATION[calibrations.source])
