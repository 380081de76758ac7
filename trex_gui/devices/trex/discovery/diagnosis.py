"""Why a line does not talk: one sentence and what to look at, from what was seen on it."""

from trex_gui.core.errors import BadReply, NoReply, StudioError
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings

_STRANGE, _ECHO, _NOBODY = "Something answers on", "Everything sent on", "No TReX answers on"


def suggests_scan(text: str) -> bool:
    """Whether a sentence of this module leaves open that the board has other settings."""
    return text.startswith((_STRANGE, _ECHO, _NOBODY))


def diagnose(settings: ConnectionSettings, *, echo: bool, error: StudioError) -> StudioError:
    """Return an error that tells a person why no TReX was found, and what to check.

    `error` is what the first question ended in; its type is kept.
    """
    where = settings.text()
    if isinstance(error, BadReply):
        return BadReply(
            f"{_STRANGE} {where}, but not as a TReX does. {error} "
            "Most often the baud rate, parity or CRC is not the one set in the board; "
            "or another device is connected."
        )
    if not isinstance(error, NoReply):
        return error
    if echo:
        return NoReply(
            f"{_ECHO} {where} comes back, and nothing else. "
            "Either this is the RS-232 side of a board that is off or set to another baud rate, "
            "or the adapter's TX and RX are joined."
        )
    address = ""
    if settings.device_number is not None:
        address = f", its device number is {settings.device_number}"
    return NoReply(
        f"{_NOBODY} {where}. Check that the board has power (an LED is lit), that the "
        "adapter's TX goes to SI and its RX to SO (or both RS-232 pins, never mixed), that "
        f"ground is connected, and that the board's serial settings are these{address}."
    )
