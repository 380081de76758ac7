"""Control lines that all simulated devices share: dispatch, numbers, faults of the wire."""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from trex_gui.core.errors import StudioError
from trex_gui.core.simulator.line import SimulatedLine

SWITCH = {"on": True, "off": False}
GOODBYE = "ok bye"
"""Answer to `quit`; the server ends after it."""

_MAX_COUNT = 999_999_999
_MAX_GARBAGE = 10_000


class ControlError(Exception):
    """A control line cannot be executed; the text says why."""


Command = Callable[[list[str]], str]
"""Executes the words after a command's name and returns the answer; raises `ControlError`."""


def execute(text: str, commands: Mapping[str, Command]) -> str:
    """Execute a control line; return `ok …` or `error …`, without a line end."""
    try:
        done = _execute(text.split(), {**commands, "quit": _quit})
    except (ControlError, StudioError) as error:
        return "error " + " ".join(str(error).split())
    return f"ok {done}".rstrip()


def _execute(words: Sequence[str], commands: Mapping[str, Command]) -> str:
    usage = f"commands are {', '.join(commands)}"
    if not words:
        raise ControlError(f"no command; {usage}")
    command = commands.get(words[0].lower())
    if command is None:
        raise ControlError(f"{words[0]!r} is not a command; {usage}")
    return command(list(words[1:]))


def _quit(words: Sequence[str]) -> str:
    require_no_more("quit", words)
    return GOODBYE.removeprefix("ok ")


def require_no_more(name: str, words: Sequence[str]) -> None:
    """Raise a `ControlError` if a command without arguments got some."""
    if words:
        raise ControlError(f"{name} takes no argument")


def number_of(text: str, allowed: Sequence[int], what: str) -> int:
    """Return one of the allowed consecutive numbers.

    Raises:
        ControlError: it is none of them; `what` names it.
    """
    for number in allowed:
        if text == str(number):
            return number
    raise ControlError(f"{what} is {allowed[0]} to {allowed[-1]}, not {text!r}")


def real(text: str, what: str, highest: float) -> float:
    """Return a number from 0 to `highest`.

    Raises:
        ControlError: it is not a number, or out of range; `what` names it.
    """
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 <= value <= highest:
        raise ControlError(f"{what} is 0 to {highest:g}, not {text!r}")
    return value


def amount(text: str, what: str = "a number of bytes", highest: int = _MAX_COUNT) -> int:
    """Return a whole number from 0 to `highest`.

    Raises:
        ControlError: it is not one; `what` names it.
    """
    if not (text.isascii() and text.isdigit() and len(text) <= 9) or int(text) > highest:
        raise ControlError(f"{what} is 0 to {highest}, not {text!r}")
    return int(text)


def wire(line: SimulatedLine, words: Sequence[str], *more: str) -> str:
    """Execute what follows `line`; `more` is the usage of commands that the device adds.

    Raises:
        ControlError: the words are no command.
    """
    faults = line.faults
    match [word.lower() for word in words]:
        case ["mute", ("on" | "off") as state]:
            faults.mute = SWITCH[state]
            return f"line mute {state}"
        case ["drop", number]:
            faults.to_drop = amount(number)
            return f"the next {faults.to_drop} bytes to the host are lost"
        case ["drop", number, "sent"]:
            faults.to_drop_sent = amount(number)
            return f"the next {faults.to_drop_sent} bytes from the host are lost"
        case ["garbage", *digits] if digits:
            data = _garbage("".join(digits))
            line.inject(data)
            return f"{len(data)} bytes on their way to the host"
        case ["noise", probability]:
            faults.noise = real(probability, "a probability", 1)
            return f"noise {faults.noise:g}"
        case ["unplug"]:
            line.unplug()
            return "unplugged"
        case ["plug"]:
            line.plug()
            return "plugged"
    usage = ("line mute on|off", "line drop N [sent]", *more, "line garbage HEX", "line noise P")
    raise ControlError(", ".join((*usage, "line unplug or line plug")))


def show_wire(line: SimulatedLine) -> dict[str, Any]:
    """Return the state of the wire for `show`."""
    faults = line.faults
    return {"plugged": faults.plugged, "mute": faults.mute, "noise": faults.noise}


def _garbage(text: str) -> bytes:
    try:
        data = bytes.fromhex(text)
    except ValueError:
        raise ControlError(f"{text!r} is not hexadecimal bytes such as FF80") from None
    if len(data) > _MAX_GARBAGE:
        raise ControlError(f"garbage is at most {_MAX_GARBAGE} bytes, not {len(data)}")
    return data
