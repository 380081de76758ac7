"""Learned values as edits, until they are stored or withdrawn."""

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.channels import LearnedChannel
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import channel_mask, channels_in
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.ui.devices.connection_state import ConnectionState

_REVERSED = ParameterKey.REVERSED_CHANNELS


def edit_what_is_chosen(device: Device, channels: Sequence[LearnedChannel], name: str) -> None:
    """Make edits of what is chosen for these channels; one step to undo, with this name."""
    reversed_ = set(channels_in(device.parameters.value_of(_REVERSED) or 0))
    with device.draft.one_edit(name):
        for channel in channels:
            if channel.choice is None:
                continue
            device.calibrations.edit(channel.number, channel.choice.calibration)
            reversed_.discard(channel.number)
            if channel.choice.reversed_:
                reversed_.add(channel.number)
        if device.parameters.knows(_REVERSED):
            device.parameters.edit(_REVERSED, channel_mask(reversed_), alone=True)


def has_edit(device: Device, number: int) -> bool:
    """Whether an edit of a channel's calibration or of its direction waits."""
    return _has_calibration(device, number) or number in _turned(device)


def other_edits(device: Device, numbers: Sequence[int]) -> int:
    """Return how many edits wait that are not of these channels."""
    own = sum(_has_calibration(device, number) for number in numbers)
    turned = _turned(device)
    if turned and turned <= set(numbers):
        own += 1
    return device.draft.pending - own


def _has_calibration(device: Device, number: int) -> bool:
    return any(key.channel == number for key, _ in device.calibrations.pending)


def _turned(device: Device) -> set[int]:
    """Channels whose direction an edit that waits would change."""
    stored, wanted = (
        set(channels_in(mask or 0))
        for mask in (
            device.parameters.stored_of(_REVERSED),
            device.parameters.value_of(_REVERSED),
        )
    )
    return stored ^ wanted


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
        device.draft.pending_changed.connect(self._on_pending_changed)

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
        is_turned = any(result.key == _REVERSED for result in good)
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
