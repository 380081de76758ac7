"""Values that were learned and taken, until they are in the board or wished for no more."""

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.channel import LearnedChannel
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import channels_in
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey
from trex_gui.ui.devices.connection_state import ConnectionState

_REVERSED = ParameterKey.REVERSED_CHANNELS


@dataclass(frozen=True, slots=True)
class _Value:
    calibration: Calibration
    reversed_: bool


class PendingLearnedValues(QObject):
    """Tells when what was taken has been written; an edit that is taken back is forgotten.

    So is everything when the line goes, or another board comes.

    Signals:
        stored: the channels whose values have just been written and read back.
    """

    stored = Signal(object)

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._waiting: dict[int, _Value] = {}

        device.applied.connect(self._on_applied)
        device.link_changed.connect(self._on_link_changed)
        device.pending_changed.connect(self._on_pending_changed)

    def wait_for(self, channels: Sequence[LearnedChannel]) -> None:
        """Wait for what is chosen for these channels, which are edits now."""
        self._waiting = {
            channel.number: _Value(channel.choice.calibration, channel.choice.reversed_)
            for channel in channels
            if channel.choice is not None
        }

    def forget(self) -> None:
        """Wait for nothing any more."""
        self._waiting = {}

    @Slot(object)
    def _on_applied(self, results: tuple[WriteResult, ...]) -> None:
        good = [result for result in results if result.error is None]
        written = {result.channel for result in good}
        is_turned = any(result.what == _REVERSED for result in good)
        found = tuple(
            number
            for number, value in self._waiting.items()
            if (number in written or is_turned)
            and self._device.calibrations.stored(number) == value.calibration
        )
        for number in found:
            del self._waiting[number]
        if found:
            self.stored.emit(found)

    @Slot()
    def _on_link_changed(self) -> None:
        if self._device.link is not ConnectionState.CONNECTED:
            self.forget()

    @Slot()
    def _on_pending_changed(self) -> None:
        calibrations, parameters = self._device.calibrations, self._device.parameters
        reversed_ = channels_in(parameters.value_of(_REVERSED) or 0)
        self._waiting = {
            number: value
            for number, value in self._waiting.items()
            if calibrations.shown(number) == value.calibration
            and (not parameters.knows(_REVERSED) or (number in reversed_) is value.reversed_)
        }
