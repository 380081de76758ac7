"""How a board will be reached once it has been switched off and on."""

from collections.abc import Mapping
from dataclasses import replace

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.framing import check_polynomial
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey, parameters_of

REACH = (ParameterKey.DEVICE_NUMBER, ParameterKey.CRC7_POLYNOMIAL, ParameterKey.UART_SETTINGS)
"""The parameters that decide where a board is."""

POLYNOMIAL_BIT = 0x80
"""The highest bit of a CRC-7 polynomial; it is always set, and a board does not store it."""


def reconnect_candidates(
    link: ConnectionSettings, before: Mapping[str, int], after: Mapping[str, int], firmware: str
) -> tuple[ConnectionSettings, ...]:
    """Return the settings at which a board may be if its power fails during a write.

    A value that was being stored is the factory default then. The default line settings are left
    out, since they are always probed.

    Args:
        link: how it is reached now.
        before: wire values by key that it stores.
        after: those that it is to store.
        firmware: version.
    """
    specs = {spec.key: spec for spec in parameters_of("trex", firmware).readable}
    changed = [key for key in REACH if key in before and after.get(key) not in {None, before[key]}]
    ends = [before, {**before, **after}]
    half_way = [{**end, key: specs[key].default} for end in ends for key in changed]
    places = dict.fromkeys(
        place
        for stored in [*reversed(ends), *half_way]
        if (place := after_power_cycle(link, stored, firmware)) is not None
    )
    places.pop(link, None)
    return tuple(places)


def after_power_cycle(
    link: ConnectionSettings, stored: Mapping[str, int], firmware: str
) -> ConnectionSettings | None:
    """Return how to reach a board that stores these parameters from its next start on.

    Args:
        link: how it is reached now; what `stored` does not say stays as it is.
        stored: wire values by key.
        firmware: version; before 1.2 two baud rates come out at half.

    Returns:
        The settings, with the rate that really is on the line; `None` when the board stores a
        value that names no baud rate or no polynomial.
    """
    line, polynomial = link.line, link.polynomial
    try:
        if ParameterKey.UART_SETTINGS in stored:
            kept = LineSettings.from_wire(stored[ParameterKey.UART_SETTINGS])
            line = replace(kept, baud=kept.real_baud(firmware))
        if ParameterKey.CRC7_POLYNOMIAL in stored:
            polynomial = check_polynomial(stored[ParameterKey.CRC7_POLYNOMIAL] | POLYNOMIAL_BIT)
    except BadRequest:
        return None
    number = link.device_number
    if number is not None:
        number = stored.get(ParameterKey.DEVICE_NUMBER, number)
    return replace(link, line=line, polynomial=polynomial, device_number=number)
