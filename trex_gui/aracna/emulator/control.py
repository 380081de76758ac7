"""The control lines of `trex-sim --aracna`: what people and tests do to robot and wire.

One line in, one line out: `ok ...` or `error ...`. Nothing in here raises.
"""

import json
import math
from collections.abc import Callable
from typing import Any

from trex_gui.aracna.emulator.line import AracnaLine
from trex_gui.aracna.emulator.servos import Register, Servo
from trex_gui.emulator.serving import GOODBYE

_MANY = 10_000
_SWITCH = {"on": True, "off": False}
_SERVO_USAGE = (
    "servo N dead|alive|block|free, servo N load F, servo N lose moving|position|speed [TIMES] "
    "or servo power off|on"
)


class _ControlError(Exception):
    """The control line cannot be obeyed; the sentence says why."""


def control(line: AracnaLine, text: str) -> str:
    """Obey one control line and return the answer, without a line end.

    `quit` only gets its answer, `GOODBYE`.
    """
    words = text.split()
    try:
        answer = _obey(line, words)
    except _ControlError as error:
        return "error " + " ".join(str(error).split())
    return f"ok {answer}".rstrip()


def _obey(line: AracnaLine, words: list[str]) -> str:
    known = "known are " + ", ".join(_COMMANDS)
    if not words:
        raise _ControlError(f"nothing to do; {known}")
    obey = _COMMANDS.get(words[0].lower())
    if obey is None:
        raise _ControlError(f"{words[0]!r} is unknown; {known}")
    return obey(line, [word.lower() for word in words[1:]])


def _reset(line: AracnaLine, words: list[str]) -> str:
    _require_no_more("reset", words)
    if not line.station.powered:
        raise _ControlError("the board has no power; power on starts it")
    line.station.reset()
    return "the board starts anew; the servos go on"


def _power(line: AracnaLine, words: list[str]) -> str:
    """Switch board and servos, as the robot's own switch does."""
    match words:
        case ["on"]:
            _power_on(line)
        case ["off"]:
            _power_off(line)
        case ["cycle"]:
            _power_off(line)
            _power_on(line)
        case _:
            raise _ControlError("power on, power off or power cycle")
    return "power on" if line.station.powered else "power off"


def _power_on(line: AracnaLine) -> None:
    _servo_power(line, on=True)
    line.station.power_on()


def _power_off(line: AracnaLine) -> None:
    line.station.power_off()
    _servo_power(line, on=False)


def _servo_power(line: AracnaLine, *, on: bool) -> None:
    for servo in line.servos:
        servo.set_power(on=on)


def _servo(line: AracnaLine, words: list[str]) -> str:
    match words:
        case ["power", ("on" | "off") as state]:
            _servo_power(line, on=_SWITCH[state])
            return f"servo power {state}"
        case [name, *rest] if name != "power" and rest:
            servo = line.servos[_motor(line, name)]
            return f"servo {name} {_one_servo(servo, rest)}"
    raise _ControlError(_SERVO_USAGE)


def _one_servo(servo: Servo, words: list[str]) -> str:
    match words:
        case [("dead" | "alive") as state]:
            servo.alive = state == "alive"
            return state
        case [("block" | "free") as state]:
            servo.blocked = state == "block"
            return "blocked" if servo.blocked else "free"
        case ["load", part]:
            servo.load = _part(part, "a load")
            return f"loses {servo.load:g} of its speed"
        case ["lose", ("moving" | "position" | "speed") as name]:
            return _lose(servo, Register(name), 1)
        case ["lose", ("moving" | "position" | "speed") as name, times]:
            return _lose(servo, Register(name), _amount(times, "a number of readings"))
    raise _ControlError(_SERVO_USAGE)


def _lose(servo: Servo, register: Register, times: int) -> str:
    servo.to_fail[register] = times
    return f"does not answer the next {times} readings of {register.value}"


def _wire(line: AracnaLine, words: list[str]) -> str:
    faults = line.faults
    match words:
        case ["mute", ("on" | "off") as state]:
            faults.mute = _SWITCH[state]
            return f"line mute {state}"
        case ["drop", number]:
            faults.to_drop = _amount(number)
            return f"the next {faults.to_drop} bytes to the host get lost"
        case ["drop", number, "sent"]:
            faults.to_drop_sent = _amount(number)
            return f"the next {faults.to_drop_sent} bytes from the host get lost"
        case ["garbage", *digits] if digits:
            data = _hex("".join(digits))
            line.inject(data)
            return f"{len(data)} bytes on their way to the host"
        case ["noise", probability]:
            faults.noise = _part(probability, "a probability")
            return f"noise {faults.noise:g}"
        case ["unplug"]:
            line.unplug()
            return "unplugged"
        case ["plug"]:
            line.plug()
            return "plugged"
    raise _ControlError(
        "line mute on|off, line drop N [sent], line garbage HEX, line noise P, line unplug "
        "or line plug"
    )


def _show(line: AracnaLine, words: list[str]) -> str:
    _require_no_more("show", words)
    return json.dumps(state(line))


def _quit(_line: AracnaLine, words: list[str]) -> str:
    _require_no_more("quit", words)
    return GOODBYE.removeprefix("ok ")


def state(line: AracnaLine) -> dict[str, Any]:
    """Return what `show` shows: board, servos, wire and what was counted."""
    firmware, faults = line.station.firmware, line.faults
    return {
        "aracna": True,
        "version": firmware.version,
        "motors": len(line.servos),
        "state": firmware.state.value,
        "boots": firmware.boots,
        "led": firmware.led,
        "servos": [_state_of(servo) for servo in line.servos],
        "counters": {
            "board": {**firmware.counters, "bytes_missed": line.station.holding.lost},
            "line": dict(faults.counters),
        },
        "line": {"plugged": faults.plugged, "mute": faults.mute, "noise": faults.noise},
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


def _require_no_more(name: str, words: list[str]) -> None:
    if words:
        raise _ControlError(f"{name} takes nothing more")


def _motor(line: AracnaLine, text: str) -> int:
    for number in range(len(line.servos)):
        if text == str(number):
            return number
    raise _ControlError(f"a servo is 0 to {len(line.servos) - 1}, not {text!r}")


def _part(text: str, what: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 <= value <= 1:
        raise _ControlError(f"{what} is 0 to 1, not {text!r}")
    return value


def _amount(text: str, what: str = "a number of bytes") -> int:
    highest = 999_999_999
    if not (text.isascii() and text.isdigit() and len(text) <= 9):
        raise _ControlError(f"{what} is 0 to {highest}, not {text!r}")
    return int(text)


def _hex(text: str) -> bytes:
    try:
        data = bytes.fromhex(text)
    except ValueError:
        raise _ControlError(f"{text!r} is not a row of bytes such as FF80") from None
    if len(data) > _MANY:
        raise _ControlError(f"garbage is at most {_MANY} bytes, not {len(data)}")
    return data


_COMMANDS: dict[str, Callable[[AracnaLine, list[str]], str]] = {
    "reset": _reset,
    "power": _power,
    "servo": _servo,
    "line": _wire,
    "show": _show,
    "quit": _quit,
}
