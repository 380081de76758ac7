"""What a board said of itself, as settings."""

from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.settings.document import Settings


def settings_of(state: DeviceState) -> Settings:
    """Return what the board stores, even values that it would not take back.

    The calibrations are those of the input source in force; the board hides the others.
    """
    stored = state.parameters
    return Settings(
        product=state.signature.model,
        firmware=state.signature.firmware,
        parameters={s.key: stored[s.key] for s in state.specs.readable if s.key in stored},
        calibrations={
            (state.source, channel): calibration
            for channel, calibration in sorted(state.calibrations.items())
        },
    )
