"""State of a board as `show` reports it, with its LEDs."""

from typing import Any

from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.simulator.eeprom import CALIBRATION_FIELDS
from trex_gui.devices.trex.simulator.firmware import Board

_FLASH = 0.3  # inferred: seconds for each of the five flashes at power-up


def leds(board: Board) -> dict[str, str]:
    """Return the state of the LEDs: `on`, `off` or the name of a pattern.

    In serial control, red is on and green lights from the first to the last byte of a packet;
    in channel control the LEDs are swapped.
    """
    if not board.powered:
        red = green = "off"
    elif board.boot_mode is not None:
        red, green = board.boot_mode.leds
    elif (since := board.now - board.powered_at) < _FLASH * len(CHANNELS):
        red, green = _learned_flash(board, since)
    else:
        packet = "on" if board.receiving else "off"
        if board.serial.in_control:
            red, green = "on", packet
        else:
            red, green = packet, "fast flash" if board.sticks.safe_start else "on"
    return {"red": red, "green": green}


def _learned_flash(board: Board, since: float) -> tuple[str, str]:
    """Return one flash for each channel: green if learned, red for a default."""
    if since % _FLASH > _FLASH / 2:
        return "off", "off"
    learned = board.memory.learned(board.mode.source) >> int(since / _FLASH) & 1
    return ("off", "on") if learned else ("on", "off")


def report(board: Board) -> dict[str, Any]:
    """Return the state for JSON; currents in A, `raw` is `None` if invalid."""
    memory = board.memory
    return {
        "model": board.model.key,
        "firmware": board.firmware,
        "power": board.powered,
        "mode": board.mode.value,
        "serial_controls": board.serial.in_control,
        "override": board.sticks.override,
        "safe_start": board.sticks.safe_start,
        "boot_mode": board.boot_mode.name if board.boot_mode else None,
        "motors": [
            {
                "direction": motor.direction.value,
                "speed": motor.speed,
                "target_direction": motor.target_direction.value,
                "target_speed": motor.target_speed,
                "current": round(physics.current, 3),
                "fault": physics.fault,
                "pwm_hz": round(memory.pwm_frequency(number), 1),
                "load": physics.load,
                "stall": round(physics.constants.stall, 1),
                "rpm": round(physics.rpm),
            }
            for number, motor, physics in zip((1, 2), board.motors, board.physics, strict=True)
        ],
        "aux": {"speed": board.aux.speed, "target_speed": board.aux.target_speed},
        "channels": [
            {"raw": raw, "remapped": remapped, "signal": board.channels.signal(channel).text}
            for channel, raw, remapped in zip(
                CHANNELS, board.channels.raw, board.remapped, strict=True
            )
        ],
        "jumpers": {"mode": board.mode_jumper, "mix": board.mix, "so_ground": board.so_ground},
        "battery": board.machine.battery,
        "supply": round(board.machine.volts, 2),
        "parameters": memory.stored(),
        "calibrations": _calibrations(board),
        "learned": {source.value.lower(): memory.learned(source) for source in InputSource},
        "active_uart": {
            "baud": memory.baud,
            "parity": memory.line_settings.parity.name.lower(),
            "stop_bits": memory.line_settings.stop_bits,
            "crc": memory.crc_polynomial is not None,
        },
        "leds": leds(board),
        "counters": {
            **board.counters,
            "uart_errors": board.serial.errors,
            "eeprom_writes": memory.writes,
        },
    }


def _calibrations(board: Board) -> dict[str, dict[str, int]]:
    """Return both sets in counts, keyed `rc_channel_1` … `analog_channel_5`."""
    return {
        f"{source.value.lower()}_channel_{channel}": {
            field: getattr(board.memory.calibration(source, channel), field)
            for field in CALIBRATION_FIELDS
        }
        for source in InputSource
        for channel in CHANNELS
    }
