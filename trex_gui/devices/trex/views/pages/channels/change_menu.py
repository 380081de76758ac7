"""Menu of actions on whole calibrations: copy, reset, discard."""

from collections.abc import Callable, Sequence
from functools import partial

from PySide6.QtCore import Slot
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.channel_text import CHANNEL_NAMES
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.widgets.builders import Trigger, action


class ChangeMenu(QMenu):
    """Actions on the calibration of one channel. Each edit is one undo step."""

    def __init__(self, device: Device, discard: Callable[[], object], parent: QWidget) -> None:
        """Create the menu. `discard` discards the edits of the channel."""
        super().__init__(parent)
        self._device = device
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

        text = tr("&Reset to factory defaults")
        reset = self._add(self, "resetCalibrationAction", text, self._reset, icon="default")
        reset.setToolTip(tr("Assumed values: Pololu publishes no factory defaults"))
        text = tr("&Discard the edits of this channel")
        self._discard = self._add(self, "discardChannelAction", text, discard, icon="undo")

    @staticmethod
    def _add(menu: QMenu, name: str, text: str, handler: Trigger, icon: str = "") -> QAction:
        made = action(menu, name, text, icon=icon, on_trigger=handler)
        menu.addAction(made)
        return made

    def show_channel(self, channel: int, *, editable: bool, edited: bool) -> None:
        self._channel = channel
        for change in self.actions():
            change.setEnabled(editable)
        self._discard.setEnabled(edited)
        for copy in self._copies.actions():
            copy.setVisible(copy.objectName() != f"copyTo{channel}Action")

    def _copy_to(self, channels: Sequence[int]) -> None:
        calibrations = self._device.calibrations
        wanted = calibrations.shown(self._channel)
        if wanted is None or wanted.problem():
            return
        text = tr("Copy of the calibration of channel {0}").format(self._channel)
        with self._device.draft.one_edit(text):
            for channel in set(channels) - {self._channel}:
                calibrations.edit(channel, wanted)

    @Slot()
    def _reset(self) -> None:
        calibrations = self._device.calibrations
        calibrations.edit(self._channel, DEFAULT_CALIBRATION[calibrations.source])
