"""What is in force in a board now; pure functions."""

from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.parameters import ParameterKey


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
