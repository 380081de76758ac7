"""The channel's bits of the channel masks, as check boxes."""

from functools import partial

from PySide6.QtCore import QSignalBlocker, Slot
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QWidget

from trex_gui.devices.trex.model.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey


class ChannelOptions(QWidget):
    """Reversed, parabolic, ignored, required: each a bit of a parameter, edited as such."""

    def __init__(self, parameters: ParameterModel, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._parameters = parameters
        self._channel = 1
        self._editable = False
        self._why_not = ""
        self._helps: dict[str, str] = {}
        self._boxes: dict[str, QCheckBox] = {}
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(18)
        for key, title, help_text in (
            (
                ParameterKey.REVERSED_CHANNELS,
                self.tr("Re&versed"),
                self.tr("The output changes its sign: forward and reverse change places"),
            ),
            (
                ParameterKey.PARABOLIC_CHANNELS,
                self.tr("&Parabolic"),
                self.tr("Gentle near neutral, steep near the ends"),
            ),
            (
                ParameterKey.IGNORED_CHANNELS,
                self.tr("I&gnored"),
                self.tr("Held at neutral, whatever comes in; for channels without a cable"),
            ),
            (
                ParameterKey.REQUIRED_CHANNELS,
                self.tr("Re&quired in RC mode"),
                self.tr("The motors stop when its pulses are missing for half a second"),
            ),
        ):
            box = QCheckBox(title, self)
            box.setObjectName(key.removesuffix("_channels") + "Box")
            box.setAccessibleName(title.replace("&", ""))
            self._helps[key] = help_text
            box.toggled.connect(partial(self._on_toggled, key))
            layout.addWidget(box)
            self._boxes[key] = box
        layout.addStretch(1)
        parameters.dataChanged.connect(self.renew)
        parameters.modelReset.connect(self.renew)
        self.renew()

    def show_channel(
        self, channel: int, source: InputSource, *, editable: bool, why_not: str = ""
    ) -> None:
        """Show the bits of a channel that matter for an input source.

        `why_not` says why they are greyed and what to do, when there is more to say than that
        no board answers.
        """
        self._channel, self._editable = channel, editable and not why_not
        self._why_not = why_not
        self._boxes[ParameterKey.REQUIRED_CHANNELS].setVisible(source is InputSource.RC)
        self.renew()

    def curve(
        self, channel: int, calibration: Calibration | None, *, stored: bool
    ) -> ChannelCurve | None:
        """Return a calibration with the bits that are stored, or would be after Apply."""
        if calibration is None:
            return None
        bits = [
            self.is_set(key, channel, stored=stored)
            for key in (
                ParameterKey.REVERSED_CHANNELS,
                ParameterKey.PARABOLIC_CHANNELS,
                ParameterKey.IGNORED_CHANNELS,
            )
        ]
        return ChannelCurve(calibration, *bits)

    def is_set(self, key: str, channel: int, *, stored: bool = False) -> bool:
        """Whether a channel's bit of a mask is set; not when the mask was not read."""
        parameters = self._parameters
        if not parameters.knows(key):
            return False
        wire = parameters.stored_of(key) if stored else parameters.value_of(key)
        return bool((wire or 0) >> (channel - 1) & 1)

    def is_edited(self, channel: int) -> bool:
        """Whether one of a channel's bits would be another after Apply."""
        return any(
            self.is_set(key, channel) != self.is_set(key, channel, stored=True)
            for key in self._boxes
        )

    def restore(self, channel: int) -> None:
        """Go back to the stored bits of a channel."""
        for key in self._boxes:
            self._set(key, channel, self.is_set(key, channel, stored=True))

    @Slot()
    def renew(self) -> None:
        """Show the bits as they would be after Apply; those that are edited stand out."""
        for key, box in self._boxes.items():
            known = self._parameters.knows(key)
            now = self.is_set(key, self._channel)
            with QSignalBlocker(box):
                box.setChecked(now)
            box.setEnabled(self._editable and known)
            box.setToolTip(self._why_not or self._helps[key])
            font = box.font()
            font.setBold(known and now != self.is_set(key, self._channel, stored=True))
            box.setFont(font)

    def _on_toggled(self, key: str, checked: bool) -> None:
        self._set(key, self._channel, checked)

    def _set(self, key: str, channel: int, wanted: bool) -> None:
        if not self._parameters.knows(key):
            return
        bit = 1 << (channel - 1)
        wire = self._parameters.value_of(key) or 0
        self._parameters.edit(key, wire | bit if wanted else wire & ~bit)
