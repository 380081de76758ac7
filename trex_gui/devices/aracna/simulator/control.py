"""Options and control lines of `trex-sim --aracna`."""

import json
from functools import partial
from typing import Any

import click

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
from trex_gui.core.simulator.plugin import Simulation, SimulatorPlugin
from trex_gui.core.texts import counted
from trex_gui.devices.aracna.protocol.joints import MOTORS
from trex_gui.devices.aracna.simulator.line import AracnaLine
from trex_gui.devices.aracna.simulator.servos import Register, Servo


def control(line: AracnaLine, text: str) -> str:
    commands = {name: (usage, partial(run, line)) for name, (usage, run) in _COMMANDS.items()}
    return execute(text, commands)


def _reset(line: AracnaLine) -> str:
    if not line.station.powered:
        raise ValueError("the board has no power; switch the power on first")
    line.station.reset()
    return "the board restarts; the servos continue"


def _power(line: AracnaLine, state: str) -> str:
    if state not in {"on", "off", "cycle"}:
        raise WrongUsage
    if state != "on":
        line.station.power_off()
        _servo_power(line, on=False)
    if state != "off":
        _servo_power(line, on=True)
        line.station.power_on()
    return "power on" if line.station.powered else "power off"


def _servo_power(line: AracnaLine, *, on: bool) -> None:
    for servo in line.servos:
        servo.set_power(on=on)


def _servo(line: AracnaLine, *words: str) -> str:
    match words:
        case ["power", ("on" | "off") as state]:
            _servo_power(line, on=state == "on")
            return f"servo power {state}"
        case [name, *rest] if name != "power" and rest:
            servo = line.servos[number_of(name, range(len(line.servos)), "a servo")]
            return f"servo {name} {_set_servo(servo, rest)}"
    raise WrongUsage


def _set_servo(servo: Servo, words: list[str]) -> str:
    match words:
        case [("dead" | "alive") as state]:
            servo.alive = state == "alive"
            return state
        case [("block" | "free") as state]:
            servo.blocked = state == "block"
            return "blocked" if servo.blocked else "free"
        case ["load", fraction]:
            servo.load = real(fraction, "a load", 1)
            return f"loses {servo.load:g} of its speed"
        case ["lose", ("moving" | "position" | "speed") as name, *times] if len(times) < 2:
            count = amount(times[0], "a number of reads") if times else 1
            servo.to_fail[Register(name)] = count
            return f"does not reply to the next {counted(count, 'read')} of {name}"
    raise WrongUsage


def _wire(line: AracnaLine, *words: str) -> str:
    match words:
        case ["cut", "off"]:
            line.faults.to_cut = None
            return "no reply is cut"
        case ["cut", number]:
            line.faults.to_cut = count = amount(number)
            return f"the rest of a line is lost after {counted(count, 'byte')}"
    return run_line_command(line, *words)


def state(line: AracnaLine) -> dict[str, Any]:
    firmware = line.station.firmware
    return {
        "aracna": True,
        "version": firmware.version,
        "motors": len(line.servos),
        "state": firmware.state.value,
        "boots": firmware.boots,
        "led": firmware.led,
        "servo_power": all(servo.powered for servo in line.servos),
        "dead": [number for number, servo in enumerate(line.servos) if not servo.alive],
        "servos": [_state_of(servo) for servo in line.servos],
        "counters": {
            "board": {**firmware.counters, "bytes_missed": line.station.bytes_missed},
            "line": dict(line.faults.counters),
        },
        "line": show_wire(line),
    }


def _state_of(servo: Servo) -> dict[str, Any]:
    return {
        "position": round(servo.position),
        "goal": servo.goal,
        "speed": servo.speed,
        "moving": servo.moving,
        "torque": servo.torque,
        "alive": servo.answers,
        "blocked": servo.blocked,
        "load": servo.load,
    }


_SERVO_USAGE = (
    "servo N dead|alive|block|free, servo N load F, servo N lose moving|position|speed [TIMES], "
    "servo power off|on"
)
_COMMANDS: dict[str, Command] = {
    "reset": ("reset", _reset),
    "power": ("power on|off|cycle", _power),
    "servo": (_SERVO_USAGE, _servo),
    "line": (f"{WIRE_USAGE}, line cut N|off", _wire),
    "show": ("show", lambda line: json.dumps(state(line))),
}


def simulate(*, motors: int | None = None, paced: bool = True, seed: int = 0) -> Simulation:
    line = AracnaLine(motors or MOTORS, paced=paced, seed=seed)
    return Simulation(line, partial(control, line))


SIMULATOR = SimulatorPlugin(
    help="Simulate an Aracna at 38400 baud instead of a TReX. Control lines of the Aracna: reset, "
    "power, servo, line, show, quit.",
    options=(
        click.Option(
            ["--motors"],
            type=click.IntRange(1, MOTORS),
            help="Number of motors. A robot with 2 motors has firmware version 0.  [default: 8]",
        ),
    ),
    build=simulate,
)
