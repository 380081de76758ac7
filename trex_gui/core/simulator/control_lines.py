"""Control lines of all simulated devices: execution, number parsing, line faults."""

import math
from collections.abc import Callable, Mapping, Sequence
from inspect import signature
from typing import Any

from trex_gui.core.errors import StudioError
from trex_gui.core.simulator.line import SimulatedLine
from trex_gui.core.texts import counted

GOODBYE = "ok bye"  # reply to `quit`, after which the server ends
_MAX_COUNT = 999_999_999
_MAX_GARBAGE = 10_000
_LONGEST_DELAY = 60.0  # seconds


class WrongUsage(Exception):  # noqa: N818 - the reply is the usage
    """The words after a command's name do not match its usage."""


Command = tuple[str, Callable[..., str]]
"""Usage and function of a command.

The function receives the words after the command's name, in lower case. It returns the reply, or
raises a ValueError with the reason for the failure."""


def execute(text: str, commands: Mapping[str, Command]) -> str:
    """Execute a control line. Return `ok …` or `error …`, without a line end."""
    commands = {**commands, "quit": ("quit", lambda: GOODBYE.removeprefix("ok "))}
    name, *words = text.lower().split() or [""]
    if name not in commands:
        problem = f"{name!r} is not a command" if name else "no command"
        return f"error {problem}; commands are {', '.join(commands)}"
    usage, run = commands[name]
    try:
        signature(run).bind(*words)
    except TypeError:
        return f"error usage: {usage}"
    try:
        return f"ok {run(*words)}".rstrip()
    except WrongUsage:
        return f"error usage: {usage}"
    except (StudioError, ValueError) as error:
        return "error " + " ".join(str(error).split())


def number_of(text: str, allowed: Sequence[int], noun: str) -> int:
    """Parse a number from a range. `allowed`: consecutive numbers. Raises ValueError."""
    if text in map(str, allowed):
        return int(text)
    raise ValueError(f"{noun} must be {allowed[0]} to {allowed[-1]}, not {text!r}")


def real(text: str, noun: str, highest: float) -> float:
    """Parse a number from 0 to `highest`. Raises ValueError."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 <= value <= highest:
        raise ValueError(f"{noun} must be 0 to {highest:g}, not {text!r}")
    return value


def amount(text: str, noun: str = "the number of bytes", highest: int = _MAX_COUNT) -> int:
    """Parse a whole number from 0 to `highest`. Raises ValueError."""
    if not (text.isascii() and text.isdigit() and len(text) <= 9) or int(text) > highest:
        raise ValueError(f"{noun} must be 0 to {highest}, not {text!r}")
    return int(text)


WIRE_USAGE = (
    "line mute on|off, line drop N [sent], line corrupt N, line double N, line delay SECONDS, "
    "line garbage HEX, line noise P, line echo on|off, line unplug, line plug"
)


def run_line_command(line: SimulatedLine, *words: str) -> str:
    """Run the command `line`. Return the reply. `WIRE_USAGE` lists the possible words."""
    faults = line.faults
    match words:
        case ["mute", ("on" | "off") as state]:
            faults.mute = state == "on"
            return f"line mute {state}"
        case [("drop" | "corrupt" | "double") as fault, number]:
            count = amount(number)
            setattr(faults, f"to_{fault}", count)
            verb = "lose" if fault == "drop" else fault
            return f"bytes to {verb} on the way to the host: {count}"
        case ["drop", number, "sent"]:
            faults.to_drop_sent = amount(number)
            return f"bytes to lose on the way from the host: {faults.to_drop_sent}"
        case ["delay", seconds]:
            faults.delay = real(seconds, "the delay in s", _LONGEST_DELAY)
            return f"bytes to the host are {faults.delay:g} s late"
        case ["echo", ("on" | "off") as state]:
            line.echo = state == "on"
            return f"line echo {state}"
        case ["garbage", *digits] if digits:
            data = _garbage("".join(digits))
            line.inject(data)
            return f"{counted(len(data), 'byte')} on the way to the host"
        case ["noise", probability]:
            faults.noise = real(probability, "the probability", 1)
            return f"noise {faults.noise:g}"
        case ["unplug"]:
            line.unplug()
            return "unplugged"
        case ["plug"]:
            line.plug()
            return "plugged"
    raise WrongUsage


def show_wire(line: SimulatedLine) -> dict[str, Any]:
    faults = line.faults
    return {"plugged": faults.plugged, "mute": faults.mute, "noise": faults.noise}


def _garbage(text: str) -> bytes:
    try:
        data = bytes.fromhex(text)
    except ValueError:
        raise ValueError(f"{text!r} is not a sequence of hexadecimal bytes such as FF80") from None
    if len(data) > _MAX_GARBAGE:
        raise ValueError(f"garbage must be at most {_MAX_GARBAGE} bytes, not {len(data)}")
    return data
