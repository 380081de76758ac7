"""The channel's bits of the channel masks, as check boxes."""

from functools import partial

from PySide6.QtCore import QSignalBlocker, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.devices.trex.model.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.ui.widgets.builders import check_box, row, set_bold


class ChannelOptions(QWidget):
    """Reversed, parabolic, ignored, required: each a bit of a parameter."""

    def __init__(self, parameters: ParameterModel, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._parameters = parameters
        self._channel = 1
        self._editable = False
        self._blocker = ""
        options = {
            ParameterKey.REVERSED_CHANNELS: (
                self.tr("Re&versed"),
                self.tr("The output changes its sign: forward and reverse are swapped"),
            ),
            ParameterKey.PARABOLIC_CHANNELS: (
                self.tr("&Parabolic"),
                self.tr("Gentle near neutral, steep near the ends"),
            ),
            ParameterKey.IGNORED_CHANNELS: (
                self.tr("I&gnored"),
                self.tr("Held at neutral at any input; for channels without a cable"),
            ),
            ParameterKey.REQUIRED_CHANNELS: (
                self.tr("Re&quired in RC mode"),
                self.tr("The motors stop when its pulses are missing for half a second"),
            ),
        }
        self._tips = {key: tip for key, (_, tip) in options.items()}
        self._boxes = {
            key: check_box(
                self,
                key.removesuffix("_channels") + "Box",
                title,
                accessible=title.replace("&", ""),
                on_toggle=partial(self._on_toggled, key),
            )
            for key, (title, _) in options.items()
        }
        row(*self._boxes.values(), 1, into=self, margins=0, spacing=18)
        parameters.dataChanged.connect(self._refresh)
        parameters.modelReset.connect(self._refresh)
        self._refresh()

    def show_channel(
        self, channel: int, source: InputSource, *, editable: bool, blocker: str = ""
    ) -> None:
        """Show the bits of a channel that matter for an input source.

        `blocker` explains why they cannot be edited, when the reason is not a missing board.
        """
        self._channel, self._editable = channel, editable and not blocker
        self._blocker = blocker
        self._boxes[ParameterKey.REQUIRED_CHANNELS].setVisible(source is InputSource.RC)
        self._refresh()

    def curve(
        self, channel: int, calibration: Calibration | None, *, stored: bool
    ) -> ChannelCurve | None:
        """Return a calibration with the bits that are stored, or would be after Apply."""
        if calibration is None:
            return None
        keys = (
            ParameterKey.REVERSED_CHANNELS,
            ParameterKey.PARABOLIC_CHANNELS,
            ParameterKey.IGNORED_CHANNELS,
        )
        return ChannelCurve(calibration, *(self._bit(key, channel, stored=stored) for key in keys))

    def _bit(self, key: str, channel: int, *, stored: bool = False) -> bool:
        """Return a channel's bit of a mask; False when the mask was not read."""
        parameters = self._parameters
        if not parameters.knows(key):
            return False
        wire = parameters.stored_of(key) if stored else parameters.value_of(key)
        return bool((wire or 0) >> (channel - 1) & 1)

    def is_edited(self, channel: int) -> bool:
        """Return whether Apply would change one of a channel's bits."""
        return any(
            self._bit(key, channel) != self._bit(key, channel, stored=True) for key in self._boxes
        )

    def restore(self, channel: int) -> None:
        """Go back to the stored bits of a channel."""
        for key in self._boxes:
            self._set(key, channel, self._bit(key, channel, stored=True))

    @Slot()
    def _refresh(self) -> None:
        """Show the bits as they would be after Apply, the edited ones in bold."""
        for key, box in self._boxes.items():
            now = self._bit(key, self._channel)
            with QSignalBlocker(box):
                box.setChecked(now)
            box.setEnabled(self._editable and self._parameters.knows(key))
            box.setToolTip(self._blocker or self._tips[key])
            set_bold(box, now != self._bit(key, self._channel, stored=True))

    def _on_toggled(self, key: str, checked: bool) -> None:
        self._set(key, self._channel, checked)

    def _set(self, key: str, channel: int, wanted: bool) -> None:
        if self._parameters.knows(key):
            bit = 1 << (channel - 1)
            wire = self._parameters.value_of(key) or 0
            self._parameters.edit(key, wire | bit if wanted else wire & ~bit)
