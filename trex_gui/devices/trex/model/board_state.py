"""What a board holds, by what it said and what was written since; pure functions."""

from collections.abc import Sequence
from dataclasses import replace

from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION, Calibration
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.flags import InputSource, channel_mask, channels_in
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey


def after_writing(state: DeviceState, results: Sequence[WriteResult]) -> DeviceState:
    """Return the state with the values that were read back after they were written."""
    parameters, calibrations = dict(state.parameters), dict(state.calibrations)
    learned = set(channels_in(state.calibrated))
    for result in results:
        channel = result.channel
        if isinstance(result.stored, Calibration) and channel is not None:
            calibrations[channel] = result.stored
            is_own = result.stored != DEFAULT_CALIBRATION[state.source]
            learned = (learned - {channel}) | ({channel} if is_own else set())
        elif isinstance(result.stored, int) and result.what in parameters:
            parameters[result.what] = result.stored
    return replace(
        state, parameters=parameters, calibrations=calibrations, calibrated=channel_mask(learned)
    )


def in_force(state: DeviceState, link: ConnectionSettings | None) -> dict[str, int]:
    """Return what is surely in force now of what acts only after a power cycle.

    The line itself shows the UART settings, the mode the input source; stored values
    may differ from them until the power is cycled.
    """
    shown: dict[str, int] = {}
    if link is not None:
        shown[ParameterKey.UART_SETTINGS] = link.line.to_wire()
        if link.framing.polynomial is not None:
            shown[ParameterKey.CRC7_POLYNOMIAL] = link.polynomial & 0x7F
    if state.mode.is_serial:
        shown[ParameterKey.CHANNEL_INPUT_SOURCE] = int(state.source is InputSource.ANALOG)
    return shown
