"""The control lines of trex-sim: what people and tests do to boards and wire.

One line in, one line out: `ok ...` or `error ...`. Nothing in here raises.
"""

import json
from collections.abc import Callable
from functools import partial

from trex_gui.core.simulator.control_lines import (
    SWITCH,
    ControlError,
    amount,
    answer,
    goodbye,
    number_of,
    real,
    require_no_more,
    wire,
)
from trex_gui.devices.trex.protocol.flags import CHANNELS, UartError
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedLine
from trex_gui.devices.trex.simulator.signals import Signal

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


def control(line: SimulatedLine, text: str) -> str:
    """Obey one control line and return the answer, without a line end.

    With several boards the line begins with the device number that a board was started with,
    as in `@9 power cycle`; lines about the wire need none. `quit` only gets its answer,
    `serving.GOODBYE`.
    """
    return answer(partial(_obey, line), text)


def _obey(line: SimulatedLine, words: list[str]) -> str:
    board = None
    if words and words[0].startswith("@"):
        board = _named_board(line, words[0])
        words = words[1:]
    if not words:
        raise ControlError(f"nothing to do; {_usage()}")
    word, rest = words[0].lower(), words[1:]
    if word in _LINE_COMMANDS:
        return _LINE_COMMANDS[word](line, rest)
    if word not in _BOARD_COMMANDS:
        raise ControlError(f"{words[0]!r} is unknown; {_usage()}")
    if board is None:
        board = _only_board(line)
    done = _BOARD_COMMANDS[word](board, rest)
    return _show(line, board) if word == "show" else done


def _usage() -> str:
    return "known are " + ", ".join([*_BOARD_COMMANDS, *_LINE_COMMANDS])


def _named_board(line: SimulatedLine, name: str) -> Board:
    for number, board in zip(line.numbers, line.boards, strict=True):
        if name[1:] == str(number):
            return board
    names = ", ".join(f"@{number}" for number in line.numbers)
    raise ControlError(f"there is no board {name}, but {names}")


def _only_board(line: SimulatedLine) -> Board:
    if len(line.boards) > 1:
        names = ", ".join(f"@{number}" for number in line.numbers)
        raise ControlError(f"say which board first: {names}")
    return line.boards[0]


def _channel(board: Board, words: list[str]) -> str:
    if len(words) < 2:
        raise ControlError("channel NUMBER then counts, 1500us, 2.5V, invalid, silent or rest")
    number = number_of(words[0], CHANNELS, "a channel")
    try:
        signal = Signal.parse(" ".join(words[1:]), board.channels.source)
    except ValueError as error:
        raise ControlError(str(error)) from error
    board.connect(number, signal)
    return f"channel {number} gets {signal.text}"


def _jumper(board: Board, words: list[str]) -> str:
    match [word.lower() for word in words]:
        case ["mode", ("serial" | "rc" | "analog") as mode]:
            board.mode_jumper = mode
            return f"mode jumper {mode}; read at power-up"
        case ["mix", ("on" | "off") as state]:
            board.mix = SWITCH[state]
            return f"mix jumper {state}"
        case ["so-ground", ("on" | "off") as state]:
            board.so_ground = SWITCH[state]
            if board.so_ground:
                return (
                    "so-ground jumper on; read at power-up, and no answer gets out until it is off"
                )
            return "so-ground jumper off"
    raise ControlError("jumper mode serial|rc|analog, jumper mix on|off or jumper so-ground on|off")


def _power(board: Board, words: list[str]) -> str:
    match [word.lower() for word in words]:
        case ["on"]:
            board.power_on()
        case ["off"]:
            board.power_off()
        case ["cycle"]:
            board.power_cycle()
        case _:
            raise ControlError("power on, power off or power cycle")
    if board.is_starved:
        return "power on, but the battery is too low for the board to start"
    return "power on" if board.powered else "power off"


def _load(board: Board, words: list[str]) -> str:
    if len(words) != 2:
        raise ControlError("load MOTOR AMPS")
    number = number_of(words[0], (1, 2), "a motor")
    amperes = _amperes(words[1])
    board.physics[number - 1].load = amperes
    return f"motor {number} draws {amperes:g} A at full speed"


def _current(board: Board, words: list[str]) -> str:
    if len(words) != 2:
        raise ControlError("current MOTOR AMPS or current MOTOR auto")
    number = number_of(words[0], (1, 2), "a motor")
    if words[1].lower() == "auto":
        board.force_current(number, None)
        return f"current {number} is measured"
    amperes = _amperes(words[1])
    board.force_current(number, amperes)
    return f"current {number} reads {amperes:g} A"


def _fault(board: Board, words: list[str]) -> str:
    if len(words) != 2 or words[1].lower() not in SWITCH:
        raise ControlError("fault MOTOR on or fault MOTOR off")
    number = number_of(words[0], (1, 2), "a motor")
    state = words[1].lower()
    board.set_fault(number, fault=SWITCH[state])
    return f"fault {number} {state}"


def _battery(board: Board, words: list[str]) -> str:
    if len(words) not in {1, 2}:
        raise ControlError("battery VOLTS or battery VOLTS OHMS")
    volts = real(words[0].lower().removesuffix("v"), "a battery in V", _HIGHEST_VOLTAGE)
    if len(words) == 2:
        board.machine.resistance = real(words[1], "a resistance in ohm", _HIGHEST_RESISTANCE)
    board.machine.battery = volts
    if not board.powered:
        board.machine.volts = volts  # nothing draws a current
    return f"battery {volts:g} V, {board.machine.resistance:g} ohm"


def _eeprom(board: Board, words: list[str]) -> str:
    """Write a cell past the firmware, as a programmer would; it acts at the next power-up."""
    if len(words) != 2:
        raise ControlError("eeprom KEY VALUE")
    key, text = words
    try:
        board.eeprom.write(key, int(text, 0))
    except KeyError:
        raise ControlError(f"there is no parameter {key!r}") from None
    except ValueError as error:
        raise ControlError(str(error)) from error
    _require_saved(board)
    return f"{key} is {board.eeprom[key]}; power cycle to use it"


def _factory(board: Board, words: list[str]) -> str:
    require_no_more("factory", words)
    board.make_new()
    _require_saved(board)
    return "as new"


def _require_saved(board: Board) -> None:
    if board.eeprom.unsaved is not None:
        raise ControlError(f"done, but not saved: {board.eeprom.unsaved}")


def _no_words(_board: Board, words: list[str]) -> str:
    require_no_more("show", words)
    return ""


def _show(line: SimulatedLine, board: Board) -> str:
    shown = board.show()
    shown["counters"]["line"] = dict(line.counters)
    shown["line"] = {"plugged": line.plugged, "mute": line.mute, "noise": line.noise}
    return json.dumps(shown)


def _wire(line: SimulatedLine, words: list[str]) -> str:
    match [word.lower() for word in words]:
        case ["error", "off"]:
            line.to_spoil.clear()
            return "no byte has an error"
        case ["error", ("framing" | "parity" | "overrun") as name]:
            line.to_spoil.append(_UART_ERRORS[name])
            return f"the next byte from the host has a {name} error{_NOTICED[name]}"
        case ["error", ("framing" | "parity" | "overrun") as name, number]:
            count = amount(number, highest=_MANY)
            line.to_spoil.extend([_UART_ERRORS[name]] * count)
            return f"the next {count} bytes from the host have a {name} error{_NOTICED[name]}"
    return wire(line, line, words, "line error framing|parity|overrun [N]", "line error off")


def _quit(_line: SimulatedLine, words: list[str]) -> str:
    return goodbye(words)


def _amperes(text: str) -> float:
    return real(text.lower().removesuffix("a"), "a current in A", _HIGHEST_CURRENT)


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

_LINE_COMMANDS: dict[str, Callable[[SimulatedLine, list[str]], str]] = {
    "line": _wire,
    "quit": _quit,
}
