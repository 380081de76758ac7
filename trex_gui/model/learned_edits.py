"""What was learned and chosen, as edits that wait for Apply."""

from collections.abc import Sequence

from trex_gui.model.device import Device
from trex_gui.model.learned_channel import LearnedChannel
from trex_gui.protocol.flags import channel_mask, channels_in

_REVERSED = "reversed_channels"


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
