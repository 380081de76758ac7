"""What the LEDs and the state of the simulated board mean, in short sentences."""

from PySide6.QtCore import QCoreApplication

from trex_gui.devices.trex.model.demo.snapshot import DemoMotor, DemoSnapshot
from trex_gui.devices.trex.protocol.flags import Mode, channels_in
from trex_gui.ui.devices.demo.rows import Columns

PACKETS = "with packets"
"""What a LED shows that lights while a packet comes in; not a pattern of the simulator's."""


def tr(text: str) -> str:
    """Translate a text of the panel."""
    return QCoreApplication.translate("demo", text)


def columns() -> Columns:
    """Return the longest texts in the columns of the panel."""
    return Columns(tr("5 override"), "2100\u00a0µs", (tr("No signal"),))


def led_patterns(snapshot: DemoSnapshot) -> tuple[str, str]:
    """Return what the red and the green LED show, in words that do not flicker with packets."""
    red, green = snapshot.leds.red, snapshot.leds.green
    if snapshot.power and not snapshot.special_start:
        if snapshot.serial_controls and green in {"on", "off"}:
            green = PACKETS
        elif not snapshot.serial_controls and red in {"on", "off"}:
            red = PACKETS
    return red, green


def led_meaning(snapshot: DemoSnapshot, pattern: str) -> str:
    """Say what a LED shows and why."""
    if not snapshot.power:
        return tr("off: the power is off")
    if snapshot.special_start:
        return f"{pattern}. {state_text(snapshot)}"
    return {
        PACKETS: tr("lights while a packet comes in"),
        "fast flash": tr("fast flash: safe-start, the motors wait"),
        "on": tr("on: serial commands control the motors")
        if snapshot.serial_controls
        else tr("on: the channels control the motors"),
    }.get(pattern, pattern)


def state_text(snapshot: DemoSnapshot) -> str:
    """Say what the board does, and what it waits for."""
    if not snapshot.power:
        return tr("The power is off: nothing answers.")
    if snapshot.special_start:
        return _special_text(snapshot.special_start)
    mode = {
        Mode.RC: tr("RC mode."),
        Mode.ANALOG: tr("Analog mode."),
        Mode.SERIAL_RC: tr("Serial mode."),
        Mode.SERIAL_ANALOG: tr("Serial mode, inputs read as voltages."),
    }[snapshot.mode]
    if snapshot.safe_start:
        doing = _safe_start_text(snapshot)
    elif snapshot.mode.is_serial:
        doing = tr("Serial commands control the motors.")
    elif snapshot.serial_controls:
        doing = tr("Channel 5 hands control to serial commands.")
    else:
        doing = tr("The sticks control the motors.")
    return f"{mode} {doing}"


def _safe_start_text(snapshot: DemoSnapshot) -> str:
    """Say what keeps the motors waiting."""
    missing = [
        str(channel)
        for channel in channels_in(snapshot.required if snapshot.mode is Mode.RC else 0)
        if snapshot.channels[channel - 1].raw is None
    ]
    if missing:
        return tr("Safe-start: the motors wait for a signal on input {0}.").format(
            ", ".join(missing)
        )
    if snapshot.override:
        return tr("Safe-start: the motors wait until channel 5 stops calling for override.")
    return tr("Safe-start: the motors wait until the sticks are centred.")


def _special_text(name: str) -> str:
    """Say what to do at a step of learning or of the boot loader."""
    return {
        "learning: take the mix jumper off": tr("Learning: take the Mix jumper off to begin."),
        "learning: waiting for a signal": tr("Learning: waits for a signal on any input."),
        "learning: neutrals": tr("Learning: leave the sticks in the middle for two seconds."),
        "learning: neutrals learned": tr("Learning: one flash an input; green is learned."),
        "learning: extremes": tr("Learning: hold each stick at both ends, ten seconds in all."),
        "learning: done": tr("Learned; green is good. Take SO–G off, then power cycle."),
        "waiting for firmware upgrade": tr("Boot loader: take Mix off, then SO–G."),
        "boot loader": tr("Boot loader: waits for firmware. Power cycle to leave."),
    }.get(name, f"{name[:1].upper()}{name[1:]}.")


def jumper_hint(snapshot: DemoSnapshot) -> str:
    """Say what a power cycle would change; empty when nothing."""
    jumpers = snapshot.jumpers
    if snapshot.special_start:
        return ""
    when = tr("Power cycle") if snapshot.power else tr("Power on")
    if jumpers.mix and jumpers.so_ground:
        if jumpers.mode == "serial":
            return tr("{0} to start the boot loader.").format(when)
        return tr("{0} to learn the inputs.").format(when)
    if jumpers.mode != snapshot.mode_jumper_in_force:
        wanted = {"serial": tr("serial"), "rc": tr("RC"), "analog": tr("analog")}
        return tr("{0} to enter {1} mode.").format(when, wanted.get(jumpers.mode, jumpers.mode))
    if jumpers.so_ground:
        return tr("SO–G holds the serial output to ground: no answer gets out.")
    return ""


def input_roles(snapshot: DemoSnapshot | None) -> tuple[str, ...]:
    """Return what each input is for, in a word or two."""
    mixed = snapshot is not None and snapshot.jumpers.mix
    first = (tr("turn"), tr("forward")) if mixed else (tr("motor 1"), tr("motor 2"))
    return *first, tr("auxiliary"), tr("flip"), tr("override")


def motor_text(motor: DemoMotor) -> str:
    """Return what a motor does now: `forward 64, 3.1 A`."""
    direction = {
        "forward": tr("forward"),
        "reverse": tr("reverse"),
        "brake": tr("brake") if motor.speed else tr("coast"),
    }.get(motor.direction, motor.direction)
    speed = f" {motor.speed}" if motor.speed else ""
    return f"{direction}{speed}, {motor.current:.1f}\u00a0A"
