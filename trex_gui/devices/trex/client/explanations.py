"""Sentences about a board that follow from what it reported."""

from trex_gui.devices.trex.protocol.flags import Mode

MODE_TEXT = {
    Mode.RC: "RC mode: a radio receiver drives the motors.",
    Mode.ANALOG: "Analog mode: voltages (joysticks, potentiometers) drive the motors.",
    Mode.SERIAL_RC: "Serial mode, with inputs read as RC pulses.",
    Mode.SERIAL_ANALOG: "Serial mode, with inputs read as voltages.",
}

CHANNEL_ROLES = {
    1: "motor 1 (mixed: turn)",
    2: "motor 2 (mixed: forward)",
    3: "auxiliary motor",
    4: "flip switch",
    5: "serial override switch",
}
"""What each channel does in RC and analog mode; in serial mode they are only measured."""


BEYOND_A_STOP = (
    "The stop was sent, but channels control the motors, and it waits in the board until channel "
    "5 hands over. Let go of the sticks, or cut the power."
)
"""A stop is a serial command like any other: what channels drive, it does not end."""


def who_controls(mode: Mode, by_serial: bool, *, joint: bool) -> str:
    """Say who controls the motors, and what to do when it is not this program."""
    note = " Joint mode: both drivers work together as motor 1, motor 2 is ignored."
    if not joint:
        note = ""
    if mode.is_serial and by_serial:
        return "Serial commands control the motors (serial mode)." + note
    if by_serial:
        return "Serial commands control the motors: channel 5 overrides the other inputs." + note
    channels = "RC" if mode is Mode.RC else "analog"
    return (
        f"The {channels} channels control the motors. Serial commands wait in the board until "
        "channel 5 hands over; for serial mode, switch the board off, take the mode jumper off, "
        "switch it on." + note
    )
