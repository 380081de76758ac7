"""Control lines of `trex-sim` for TReX boards and their serial line."""

import json
from dataclasses import asdict
from functools import partial
from typing import Any

from trex_gui.core.simulator.control_lines import (
    WIRE_USAGE,
    Command,
    WrongUsage,
    amount,
    execute,
    number_of,
    real,
    run_line_command,
    show_wire,
)
from trex_gui.core.simulator.sampling import ReceiveError
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.simulator.channels import Signal
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards

_FLASH = 0.3  # seconds for each of the five flashes at power-up, inferred


def leds(board: Board) -> dict[str, str]:
    """Return the state of the LEDs: `on`, `off` or the name of a pattern.

    In serial control, red is on, and green is on from the first to the last byte of a packet.
    Channel control swaps the LEDs.
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
    if since % _FLASH > _FLASH / 2:
        return "off", "off"
    learned = board.eeprom.learned(board.mode.source) >> int(since / _FLASH) & 1
    return ("off", "on") if learned else ("on", "off")


def report(board: Board) -> dict[str, Any]:
    """Return the state of a board for JSON. Currents are in A. An invalid `raw` is `None`."""
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
                "stall": round(physics.constants.stall_current, 1),
                "rpm": round(physics.rpm),
            }
            for number, motor, physics in zip((1, 2), board.motors, board.physics, strict=True)
        ],
        "aux": {"speed": board.aux.speed, "target_speed": board.aux.target_speed},
        "channels": [
            {"raw": raw, "remapped": remapped, "signal": board.channels.signals[channel].text}
            for channel, raw, remapped in zip(
                CHANNELS, board.channels.raw, board.remapped, strict=True
            )
        ],
        "jumpers": {"mode": board.mode_jumper, "mix": board.mix, "so_ground": board.so_ground},
        "battery": board.machine.battery,
        "supply": round(board.machine.volts, 2),
        "parameters": memory.stored(),
        "calibrations": {
            f"{source.value.lower()}_channel_{channel}": asdict(
                board.eeprom.calibration(source, channel)
            )
            for source in InputSource
            for channel in CHANNELS
        },
        "learned": {source.value.lower(): board.eeprom.learned(source) for source in InputSource},
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


def control(line: SimulatedBoards, text: str) -> str:
    """Execute a control line. Return `ok …` or `error …`, without a newline.

    With several boards, the line begins with the initial device number of a board, as in
    `@9 power cycle`. Commands for the wire need no number.
    """
    name = ""
    if text.strip().startswith("@"):
        name, _, text = text.strip().partition(" ")
    board = _board(line, name)
    commands: dict[str, Command] = {"line": (_WIRE_USAGE, partial(_wire, line))}
    on_board: dict[str, Command] = {**_COMMANDS, "show": ("show", partial(_show, line))}
    for key, (usage, run) in on_board.items():
        bound = partial(_no_board, line, name) if board is None else partial(run, board)
        commands[key] = (usage, bound)
    return execute(text, commands)


def _board(line: SimulatedBoards, name: str) -> Board | None:
    if not name and len(line.boards) == 1:
        return line.boards[0]
    boards = zip(line.numbers, line.boards, strict=True)
    return next((board for number, board in boards if name == f"@{number}"), None)


def _no_board(line: SimulatedBoards, name: str, *_words: str) -> str:
    names = ", ".join(f"@{number}" for number in line.numbers)
    if name:
        raise ValueError(f"there is no board {name}; the boards are {names}")
    raise ValueError(f"begin the line with a board: {names}")


def _channel(board: Board, channel: str, value: str, *more: str) -> str:
    number = number_of(channel, CHANNELS, "a channel")
    signal = Signal.parse(" ".join((value, *more)), board.channels.source)
    board.channels.signals[number] = signal
    return f"channel {number} gets {signal.text}"


def _jumper(board: Board, which: str, state: str) -> str:
    match which, state:
        case "mode", ("serial" | "rc" | "analog"):
            board.mode_jumper = state
            return f"mode jumper {state}; read at power-up"
        case "mix", ("on" | "off"):
            board.mix = state == "on"
            return f"mix jumper {state}"
        case "so-ground", ("on" | "off"):
            board.so_ground = state == "on"
            effect = "; read at power-up, and no reply is sent until it is off"
            return f"so-ground jumper {state}{effect if board.so_ground else ''}"
    raise WrongUsage


def _power(board: Board, state: str) -> str:
    switches = {"on": board.power_on, "off": board.power_off, "cycle": board.power_cycle}
    if state not in switches:
        raise WrongUsage
    switches[state]()
    if board.is_starved:
        return "power on, but the battery is too low for the board to start"
    return "power on" if board.powered else "power off"


def _motor(text: str) -> int:
    return number_of(text, (1, 2), "a motor")


def _amperes(text: str) -> float:
    return real(text.removesuffix("a"), "a current in A", highest=1000)


def _load(board: Board, motor: str, amps: str) -> str:
    number, amperes = _motor(motor), _amperes(amps)
    board.physics[number - 1].load = amperes
    return f"motor {number} draws {amperes:g} A at full speed"


def _current(board: Board, motor: str, amps: str) -> str:
    number = _motor(motor)
    amperes = None if amps == "auto" else _amperes(amps)
    board.force_current(number, amperes)
    return f"current {number} " + ("is measured" if amperes is None else f"reads {amperes:g} A")


def _fault(board: Board, motor: str, state: str) -> str:
    if state not in {"on", "off"}:
        raise WrongUsage
    number = _motor(motor)
    board.set_fault(number, fault=state == "on")
    return f"fault {number} {state}"


def _battery(board: Board, voltage: str, resistance: str | None = None) -> str:
    volts = real(voltage.removesuffix("v"), "a battery in V", highest=24)
    if resistance is not None:
        board.machine.resistance = real(resistance, "a resistance in ohm", highest=100)
    board.machine.battery = volts
    if not board.powered:
        board.machine.volts = volts  # nothing draws current
    return f"battery {volts:g} V, {board.machine.resistance:g} ohm"


def _eeprom(board: Board, key: str, value: str) -> str:
    try:
        board.eeprom.write(key, int(value, 0))
    except KeyError:
        raise ValueError(f"there is no parameter {key!r}") from None
    _require_saved(board)
    return f"{key} is {board.eeprom[key]}; takes effect after a power cycle"


def _accept(board: Board, key: str, highest: str, mask: str = "127") -> str:
    """Accept values outside an inferred limit. The firmware stores only the bits in `mask`."""
    spec = board.memory.parameters[key]
    limits = int(highest, 0), int(mask, 0)
    if not spec.is_open(limits[0]):
        raise ValueError(f"{spec.key}: {limits[0]} is not outside an inferred limit")
    board.memory.accepted[spec.key] = limits
    return f"{spec.key} is accepted up to {limits[0]} and stored with the mask {limits[1]}"


def _factory(board: Board) -> str:
    board.factory_reset()
    _require_saved(board)
    return "the board is in its initial state"


def _require_saved(board: Board) -> None:
    if board.eeprom.unsaved is not None:
        raise ValueError(f"done, but not saved: {board.eeprom.unsaved}")


def _show(line: SimulatedBoards, board: Board) -> str:
    state = report(board)
    state["counters"]["line"] = dict(line.faults.counters)
    state["line"] = show_wire(line)
    return json.dumps(state)


def _wire(line: SimulatedBoards, *words: str) -> str:
    match words:
        case ["error", "off"]:
            line.faults.errors.clear()
            return "no byte will have an error"
        case ["error", ("framing" | "parity" | "overrun") as name, *rest] if len(rest) < 2:
            count = amount(rest[0], highest=10_000) if rest else 1
            line.faults.errors.extend([ReceiveError(name)] * count)
            note = " (undetected by a board without parity)" if name == "parity" else ""
            return f"bytes from the host that will have a {name} error{note}: {count}"
    return run_line_command(line, *words)


_WIRE_USAGE = f"{WIRE_USAGE}, line error framing|parity|overrun [N], line error off"
_COMMANDS: dict[str, Command] = {
    "channel": ("channel N COUNTS|1500us|2.5V|invalid|silent|rest [noise 2us] [lost P]", _channel),
    "jumper": ("jumper mode serial|rc|analog, jumper mix on|off, jumper so-ground on|off", _jumper),
    "power": ("power on|off|cycle", _power),
    "load": ("load MOTOR AMPS", _load),
    "current": ("current MOTOR AMPS|auto", _current),
    "fault": ("fault MOTOR on|off", _fault),
    "battery": ("battery VOLTS [OHMS]", _battery),
    "eeprom": ("eeprom KEY VALUE", _eeprom),
    "accept": ("accept KEY HIGHEST [MASK]", _accept),
    "factory": ("factory", _factory),
}
