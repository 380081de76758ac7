"""What was learned and chosen, as edits that wait for Apply, and those that wait there already."""

from collections.abc import Sequence

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.channel import LearnedChannel
from trex_gui.devices.trex.protocol.flags import channel_mask, channels_in
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey

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
    return device.pending - own


def _has_calibration(device: Device, number: int) -> bool:
    return any(channel == number for channel, _ in device.calibrations.pending)


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
