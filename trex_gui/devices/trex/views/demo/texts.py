"""Texts for the LEDs and the state of the simulated board."""

from PySide6.QtCore import QCoreApplication

from trex_gui.devices.trex.model.demo import BootStep, DemoMotor, DemoSnapshot
from trex_gui.devices.trex.protocol.flags import Mode, channels_in

PACKETS = "with packets"
"""Pattern of a LED that lights during a packet; the simulator reports on or off."""


def tr(text: str) -> str:
    """Translate a text of the panel."""
    return QCoreApplication.translate("demo", text)


def led_patterns(snapshot: DemoSnapshot) -> tuple[str, str]:
    """Return the patterns of the red and the green LED, steady while packets arrive."""
    red, green = snapshot.leds.red, snapshot.leds.green
    if snapshot.power and snapshot.boot_mode is None:
        if snapshot.serial_controls and green in {"on", "off"}:
            green = PACKETS
        elif not snapshot.serial_controls and red in {"on", "off"}:
            red = PACKETS
    return red, green


def led_meaning(snapshot: DemoSnapshot, pattern: str) -> str:
    """Return what a pattern of a LED means."""
    if not snapshot.power:
        return tr("off: the power is off")
    if snapshot.boot_mode is not None:
        return f"{pattern}. {state_text(snapshot)}"
    return {
        PACKETS: tr("lights while a packet comes in"),
        "fast flash": tr("fast flash: safe-start, the motors wait"),
        "on": tr("on: serial commands control the motors")
        if snapshot.serial_controls
        else tr("on: the channels control the motors"),
    }.get(pattern, pattern)


def state_text(snapshot: DemoSnapshot) -> str:
    """Return what the board does, and what it waits for."""
    if not snapshot.power:
        return tr("The power is off: the board does not reply.")
    if snapshot.boot_mode is not None:
        return _boot_text(snapshot.boot_mode)
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
    """Return what safe-start waits for."""
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
        return tr("Safe-start: the motors wait until channel 5 no longer requests override.")
    return tr("Safe-start: the motors wait until the sticks are centred.")


def _boot_text(step: BootStep) -> str:
    """Return what to do at a step of a boot mode."""
    return {
        BootStep.LEARN_READY: tr("Learning: take the Mix jumper off to begin."),
        BootStep.LEARN_WAITING: tr("Learning: waits for a signal on any input."),
        BootStep.LEARN_NEUTRALS: tr("Learning: leave the sticks centred for two seconds."),
        BootStep.LEARN_NEUTRALS_SHOWN: tr("Learning: one flash per input; green is learned."),
        BootStep.LEARN_EXTREMES: tr("Learning: hold each stick at both ends, ten seconds in all."),
        BootStep.LEARN_DONE: tr("Learned; green is good. Take SO–G off, then power cycle."),
        BootStep.UPGRADE_REQUESTED: tr("Boot loader: take Mix off, then SO–G."),
        BootStep.UPGRADE_READY: tr("Boot loader: waits for firmware. Power cycle to leave."),
    }[step]


def jumper_hint(snapshot: DemoSnapshot) -> str:
    """Return what a power cycle would change; empty if nothing."""
    jumpers = snapshot.jumpers
    if snapshot.boot_mode is not None:
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
        return tr("SO–G holds the serial output to ground: no reply gets out.")
    return ""


def input_roles(snapshot: DemoSnapshot | None) -> tuple[str, ...]:
    """Return the role of each input."""
    mixed = snapshot is not None and snapshot.jumpers.mix
    first = (tr("turn"), tr("forward")) if mixed else (tr("motor 1"), tr("motor 2"))
    return *first, tr("auxiliary"), tr("flip"), tr("override")


def motor_text(motor: DemoMotor) -> str:
    """Return what a motor does: `forward 64, 3.1 A`."""
    direction = {
        "forward": tr("forward"),
        "reverse": tr("reverse"),
        "brake": tr("brake") if motor.speed else tr("coast"),
    }.get(motor.direction, motor.direction)
    speed = f" {motor.speed}" if motor.speed else ""
    return f"{direction}{speed}, {motor.current:.1f}\u00a0A"
