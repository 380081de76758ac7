"""The control lines of trex-sim: what people and tests do to boards and wire.

One line in, one line out: `ok ...` or `error ...`. Nothing in here raises.
"""

import json
import math
from collections.abc import Callable

from trex_gui.emulator.firmware import Board
from trex_gui.emulator.line import Line
from trex_gui.emulator.serving import GOODBYE
from trex_gui.emulator.signals import Signal
from trex_gui.protocol.errors import TrexError
from trex_gui.protocol.flags import CHANNELS, UartError

_HIGHEST_CURRENT = 1000.0
_HIGHEST_VOLTAGE = 24.0
_HIGHEST_RESISTANCE = 100.0
_MANY = 10_000
_NOTICED = {"framing": "", "overrun": "", "parity": ", which a board without parity does not see"}
_UART_ERRORS = {
    "framing": UartError.FRAMING,
    "parity": UartError.PARITY,
    "overrun": UartError.DATA_OVERRUN,
}
_SWITCH = {"on": True, "off": False}


class _ControlError(Exception):
    """The control line cannot be obeyed; the sentence says why."""


def control(line: Line, text: str) -> str:
    """Obey one control line and return the answer, without a line end.

    With several boards the line begins with the device number that a board was started with,
    as in `@9 power cycle`; lines about the wire need none. `quit` only gets its answer,
    `GOODBYE`.
    """
    try:
        answer = _obey(line, text.split())
    except (_ControlError, TrexError) as error:
        return "error " + " ".join(str(error).split())
    return f"ok {answer}".rstrip()


def _obey(line: Line, words: list[str]) -> str:
    board = None
    if words and words[0].startswith("@"):
        board = _named_board(line, words[0])
        words = words[1:]
    if not words:
        raise _ControlError(f"nothing to do; {_usage()}")
    word, rest = words[0].lower(), words[1:]
    if word in _LINE_COMMANDS:
        return _LINE_COMMANDS[word](line, rest)
    if word not in _BOARD_COMMANDS:
        raise _ControlError(f"{words[0]!r} is unknown; {_usage()}")
    if board is None:
        board = _only_board(line)
    answer = _BOARD_COMMANDS[word](board, rest)
    if word == "show":
        return _show(line, board)
    return answer


def _usage() -> str:
    return "known are " + ", ".join([*_BOARD_COMMANDS, *_LINE_COMMANDS])


def _named_board(line: Line, name: str) -> Board:
    for number, board in zip(line.numbers, line.boards, strict=True):
        if name[1:] == str(number):
            return board
    names = ", ".join(f"@{number}" for number in line.numbers)
    raise _ControlError(f"there is no board {name}, but {names}")


def _only_board(line: Line) -> Board:
    if len(line.boards) > 1:
        names = ", ".join(f"@{number}" for number in line.numbers)
        raise _ControlError(f"say which board first: {names}")
    return line.boards[0]


def _channel(board: Board, words: list[str]) -> str:
    if len(words) < 2:
        raise _ControlError("channel NUMBER then counts, 1500us, 2.5V, invalid, silent or rest")
    number = _number_of(words[0], CHANNELS, "a channel")
    try:
        signal = Signal.parse(" ".join(words[1:]), board.channels.source)
    except ValueError as error:
        raise _ControlError(str(error)) from error
    board.connect(number, signal)
    return f"channel {number} gets {signal.text}"


def _jumper(board: Board, words: list[str]) -> str:
    match [word.lower() for word in words]:
        case ["mode", ("serial" | "rc" | "analog") as mode]:
            board.mode_jumper = mode
            return f"mode jumper {mode}; read at power-up"
        case ["mix", ("on" | "off") as state]:
            board.mix = _SWITCH[state]
            return f"mix jumper {state}"
        case ["so-ground", ("on" | "off") as state]:
            board.so_ground = _SWITCH[state]
            if board.so_ground:
                return (
                    "so-ground jumper on; read at power-up, and no answer gets out until it is off"
                )
            return "so-ground jumper off"
    raise _ControlError(
        "jumper mode serial|rc|analog, jumper mix on|off or jumper so-ground on|off"
    )


def _power(board: Board, words: list[str]) -> str:
    match [word.lower() for word in words]:
        case ["on"]:
            board.power_on()
        case ["off"]:
            board.power_off()
        case ["cycle"]:
            board.power_cycle()
        case _:
            raise _ControlError("power on, power off or power cycle")
    if board.is_starved:
        return "power on, but the battery is too low for the board to start"
    return "power on" if board.powered else "power off"


def _load(board: Board, words: list[str]) -> str:
    if len(words) != 2:
        raise _ControlError("load MOTOR AMPS")
    number = _number_of(words[0], (1, 2), "a motor")
    amperes = _amperes(words[1])
    board.physics[number - 1].load = amperes
    return f"motor {number} draws {amperes:g} A at full speed"


def _current(board: Board, words: list[str]) -> str:
    if len(words) != 2:
        raise _ControlError("current MOTOR AMPS or current MOTOR auto")
    number = _number_of(words[0], (1, 2), "a motor")
    if words[1].lower() == "auto":
        board.force_current(number, None)
        return f"current {number} is measured"
    amperes = _amperes(words[1])
    board.force_current(number, amperes)
    return f"current {number} reads {amperes:g} A"


def _fault(board: Board, words: list[str]) -> str:
    if len(words) != 2 or words[1].lower() not in _SWITCH:
        raise _ControlError("fault MOTOR on or fault MOTOR off")
    number = _number_of(words[0], (1, 2), "a motor")
    state = words[1].lower()
    board.set_fault(number, fault=_SWITCH[state])
    return f"fault {number} {state}"


def _battery(board: Board, words: list[str]) -> str:
    if len(words) not in {1, 2}:
        raise _ControlError("battery VOLTS or battery VOLTS OHMS")
    volts = _float(words[0].lower().removesuffix("v"), "a battery in V", _HIGHEST_VOLTAGE)
    if len(words) == 2:
        board.machine.resistance = _float(words[1], "a resistance in ohm", _HIGHEST_RESISTANCE)
    board.machine.battery = volts
    if not board.powered:
        board.machine.volts = volts  # nothing draws a current
    return f"battery {volts:g} V, {board.machine.resistance:g} ohm"


def _eeprom(board: Board, words: list[str]) -> str:
    """Write a cell past the firmware, as a programmer would; it acts at the next power-up."""
    if len(words) != 2:
        raise _ControlError("eeprom KEY VALUE")
    key, text = words
    try:
        board.eeprom.write(key, int(text, 0))
    except KeyError:
        raise _ControlError(f"there is no parameter {key!r}") from None
    except ValueError as error:
        raise _ControlError(str(error)) from error
    _require_saved(board)
    return f"{key} is {board.eeprom[key]}; power cycle to use it"


def _factory(board: Board, words: list[str]) -> str:
    if words:
        raise _ControlError("factory takes nothing more")
    board.make_new()
    _require_saved(board)
    return "as new"


def _require_saved(board: Board) -> None:
    if board.eeprom.unsaved is not None:
        raise _ControlError(f"done, but not saved: {board.eeprom.unsaved}")


def _no_words(_board: Board, words: list[str]) -> str:
    if words:
        raise _ControlError("show takes nothing more")
    return ""


def _show(line: Line, board: Board) -> str:
    shown = board.show()
    shown["counters"]["line"] = dict(line.counters)
    shown["line"] = {"plugged": line.plugged, "mute": line.mute, "noise": line.noise}
    return json.dumps(shown)


def _wire(line: Line, words: list[str]) -> str:
    match [word.lower() for word in words]:
        case ["mute", ("on" | "off") as state]:
            line.mute = _SWITCH[state]
            return f"line mute {state}"
        case ["drop", number]:
            line.to_drop = _amount(number)
            return f"the next {line.to_drop} bytes to the host get lost"
        case ["drop", number, "sent"]:
            line.to_drop_sent = _amount(number)
            return f"the next {line.to_drop_sent} bytes from the host get lost"
        case ["error", "off"]:
            line.to_spoil.clear()
            return "no byte has an error"
        case ["error", ("framing" | "parity" | "overrun") as name]:
            line.to_spoil.append(_UART_ERRORS[name])
            return f"the next byte from the host has a {name} error{_NOTICED[name]}"
        case ["error", ("framing" | "parity" | "overrun") as name, number]:
            amount = _amount(number, _MANY)
            line.to_spoil.extend([_UART_ERRORS[name]] * amount)
            return f"the next {amount} bytes from the host have a {name} error{_NOTICED[name]}"
        case ["garbage", *digits] if digits:
            data = _hex("".join(digits))
            if len(data) > _MANY:
                raise _ControlError(f"garbage is at most {_MANY} bytes, not {len(data)}")
            line.inject(data)
            return f"{len(data)} bytes on their way to the host"
        case ["noise", probability]:
            line.noise = _probability(probability)
            return f"noise {line.noise:g}"
        case ["unplug"]:
            line.unplug()
            return "unplugged"
        case ["plug"]:
            line.plug()
            return "plugged"
    raise _ControlError(
        "line mute on|off, line drop N [sent], line error framing|parity|overrun [N], "
        "line error off, "
        "line garbage HEX, line noise P, line unplug or line plug"
    )


def _quit(_line: Line, words: list[str]) -> str:
    if words:
        raise _ControlError("quit takes nothing more")
    return GOODBYE.removeprefix("ok ")


def _number_of(text: str, allowed: tuple[int, ...], what: str) -> int:
    for number in allowed:
        if text == str(number):
            return number
    raise _ControlError(f"{what} is {allowed[0]} to {allowed[-1]}, not {text!r}")


def _float(text: str, what: str, highest: float) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 <= value <= highest:
        raise _ControlError(f"{what} is 0 to {highest:g}, not {text!r}")
    return value


def _amperes(text: str) -> float:
    return _float(text.lower().removesuffix("a"), "a current in A", _HIGHEST_CURRENT)


def _probability(text: str) -> float:
    return _float(text, "a probability", 1.0)


def _amount(text: str, highest: int = 999_999_999) -> int:
    if not (text.isascii() and text.isdigit() and len(text) <= 9) or int(text) > highest:
        raise _ControlError(f"a number of bytes is 0 to {highest}, not {text!r}")
    return int(text)


def _hex(text: str) -> bytes:
    try:
        return bytes.fromhex(text)
    except ValueError:
        raise _ControlError(f"{text!r} is not a row of bytes such as FF80") from None


_BOARD_COMMANDS: dict[str, Callable[[Board, list[str]], str]] = {
    "channel": _channel,
    "jumper": _jumper,
    "power": _power,
    "load": _load,
    "current": _current,
    "fault": _fault,
    "battery": _battery,
    "eeprom": _eeprom,
    "factory": _factory,
    "show": _no_words,
}

_LINE_COMMANDS: dict[str, Callable[[Line, list[str]], str]] = {"line": _wire, "quit": _quit}
