"""What control lines have in common, whatever is simulated: words, numbers, faults of a wire."""

import math
from collections.abc import Callable, Sequence
from typing import Protocol

from trex_gui.core.errors import StudioError
from trex_gui.core.simulator.server import GOODBYE

SWITCH = {"on": True, "off": False}
_MANY = 999_999_999
_MOST_GARBAGE = 10_000


class ControlError(Exception):
    """The control line cannot be obeyed; the sentence says why."""


def answer(obey: Callable[[list[str]], str], text: str) -> str:
    """Obey the words of one control line and return the answer, without a line end."""
    try:
        done = obey(text.split())
    except (ControlError, StudioError) as error:
        return "error " + " ".join(str(error).split())
    return f"ok {done}".rstrip()


def require_no_more(name: str, words: Sequence[str]) -> None:
    """Refuse words behind a command that takes none.

    Raises:
        ControlError: there are some.
    """
    if words:
        raise ControlError(f"{name} takes nothing more")


def goodbye(words: Sequence[str]) -> str:
    """Return the answer to `quit`.

    Raises:
        ControlError: there are words behind it.
    """
    require_no_more("quit", words)
    return GOODBYE.removeprefix("ok ")


def number_of(text: str, allowed: Sequence[int], what: str) -> int:
    """Return which of the allowed numbers, one after the other, a word is.

    Raises:
        ControlError: none of them; `what` says of what.
    """
    for number in allowed:
        if text == str(number):
            return number
    raise ControlError(f"{what} is {allowed[0]} to {allowed[-1]}, not {text!r}")


def real(text: str, what: str, highest: float) -> float:
    """Return the number that a word is, 0 to `highest`.

    Raises:
        ControlError: it is none, or out of range; `what` says of what.
    """
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 <= value <= highest:
        raise ControlError(f"{what} is 0 to {highest:g}, not {text!r}")
    return value


def amount(text: str, what: str = "a number of bytes", highest: int = _MANY) -> int:
    """Return the whole number that a word of digits is, 0 to `highest`.

    Raises:
        ControlError: it is none, or out of range; `what` says of what.
    """
    if not (text.isascii() and text.isdigit() and len(text) <= 9) or int(text) > highest:
        raise ControlError(f"{what} is 0 to {highest}, not {text!r}")
    return int(text)


class WireFaults(Protocol):
    """What goes wrong with the bytes on a wire."""

    mute: bool
    to_drop: int
    to_drop_sent: int
    noise: float


class Cable(Protocol):
    """A wire that can be pulled, and told to carry what nobody sent."""

    def inject(self, data: bytes) -> None:
        """Put bytes on the wire to the host."""
        ...

    def unplug(self) -> None:
        """Pull it."""
        ...

    def plug(self) -> None:
        """Put it back in."""
        ...


def wire(cable: Cable, faults: WireFaults, words: Sequence[str], *more: str) -> str:
    """Do to a wire what the words behind `line` say; `more` is what it knows beside these.

    Raises:
        ControlError: the words are none of these.
    """
    match [word.lower() for word in words]:
        case ["mute", ("on" | "off") as state]:
            faults.mute = SWITCH[state]
            return f"line mute {state}"
        case ["drop", number]:
            faults.to_drop = amount(number)
            return f"the next {faults.to_drop} bytes to the host get lost"
        case ["drop", number, "sent"]:
            faults.to_drop_sent = amount(number)
            return f"the next {faults.to_drop_sent} bytes from the host get lost"
        case ["garbage", *digits] if digits:
            data = _garbage("".join(digits))
            cable.inject(data)
            return f"{len(data)} bytes on their way to the host"
        case ["noise", probability]:
            faults.noise = real(probability, "a probability", 1)
            return f"noise {faults.noise:g}"
        case ["unplug"]:
            cable.unplug()
            return "unplugged"
        case ["plug"]:
            cable.plug()
            return "plugged"
    known = ("line mute on|off", "line drop N [sent]", *more, "line garbage HEX", "line noise P")
    raise ControlError(", ".join((*known, "line unplug or line plug")))


def _garbage(text: str) -> bytes:
    try:
        data = bytes.fromhex(text)
    except ValueError:
        raise ControlError(f"{text!r} is not a row of bytes such as FF80") from None
    if len(data) > _MOST_GARBAGE:
        raise ControlError(f"garbage is at most {_MOST_GARBAGE} bytes, not {len(data)}")
    return data
