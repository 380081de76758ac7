"""Options of `trex-sim` for TReX boards, and the demonstration mode."""

import math
import os
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import click

from trex_gui.core.command_io import FileName
from trex_gui.core.simulator.plugin import Simulation, SimulatorPlugin
from trex_gui.core.simulator.timeline import Timeline
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.simulator.channels import Signal, SignalKind
from trex_gui.devices.trex.simulator.control import control
from trex_gui.devices.trex.simulator.firmware import MODE_JUMPERS, Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.simulator.memory import Eeprom

_MODELS = [model.key for model in device_table().models]
_FIRMWARE = sorted({version for model in device_table().models for version in model.firmware})

_PERIOD = 0.02  # seconds between two pulses of a standard receiver

# Channel → (period in seconds, amplitude as a fraction of the stick's travel). The periods have no
# small common multiple, so that the motion does not repeat. The amplitude of channel 5 is too small
# to activate the serial override.
_SWINGS = {1: (7.0, 0.8), 2: (11.0, 0.7), 3: (17.0, 0.6), 4: (23.0, 0.3), 5: (29.0, 0.2)}


def demonstrate(board: Board, timeline: Timeline) -> None:
    """Load the motors, and move the sticks that no control line has set."""
    for physics in board.physics:
        physics.load = physics.initial_load = physics.constants.light_load
    signals = board.channels.signals.copy()

    def move_sticks() -> None:
        for channel, (period, amplitude) in _SWINGS.items():
            current = board.channels.signals[channel]
            if current == signals[channel] or current.kind is SignalKind.REST:
                position = amplitude * math.sin(2 * math.pi * board.now / period)
                signal = Signal.voltage(2.5 + 2.5 * position)
                if board.channels.source is InputSource.RC:
                    signal = Signal.pulses(1500 + 500 * position)
                signals[channel] = board.channels.signals[channel] = signal
        timeline.at(timeline.now + _PERIOD, move_sticks)

    move_sticks()


@dataclass(frozen=True, slots=True)
class DeviceOption:
    number: int | None = None
    model: str | None = None


def _read_device(text: str) -> DeviceOption:
    number, _, model = text.partition(":")
    if not (number.isascii() and number.isdigit() and int(number) <= 127):
        raise click.BadParameter(f"a device number must be 0 to 127, not {number!r}")
    if model and model not in _MODELS:
        raise click.BadParameter(f"a model must be {' or '.join(_MODELS)}, not {model!r}")
    return DeviceOption(int(number), model or None)


def _check_numbers(
    _context: click.Context, _option: click.Parameter, devices: tuple[DeviceOption, ...]
) -> tuple[DeviceOption, ...]:
    if len({device.number for device in devices}) < len(devices):
        raise click.UsageError(
            "each --device needs a different number, which begins its control lines"
        )
    return devices


def simulate(
    *,
    model: str = "trex",
    firmware: str = "1.2",
    mode: str = "serial",
    mix: bool = False,
    echo: bool = False,
    paced: bool = True,
    eeprom: Path | None = None,
    error_shutdown: str = "on",
    timeout_needs_shutdown: str = "off",
    unknown_parameter: str = "silent",
    rejected_write: str = "quiet",
    devices: Sequence[DeviceOption] = (),
    seed: int = 0,
    demo: bool = False,
) -> Simulation:
    boards = []
    for index, device in enumerate(devices or [DeviceOption()]):
        key = device.model or model
        stored = _eeprom(eeprom, device, key, len(devices), error_shutdown=error_shutdown == "on")
        board = Board(key, firmware, eeprom=stored, mode=mode, mix=mix, seed=seed + index)
        board.timeout_needs_shutdown = timeout_needs_shutdown == "on"
        board.unknown_reply = b"" if unknown_parameter == "silent" else b"\xff"
        board.rejection_is_error = rejected_write == "error"
        boards.append(board)
    line = SimulatedBoards(boards, echo=echo, paced=paced, seed=seed)
    if demo:
        for board in boards:
            demonstrate(board, line.timeline)
    return Simulation(line, partial(control, line))


def _eeprom(
    path: Path | None, device: DeviceOption, model: str, count: int, *, error_shutdown: bool
) -> Eeprom:
    """Return the EEPROM of a board. A device number in the file overrides the option."""
    if path is not None and count > 1:
        path = path.with_name(f"{path.stem}-{device.number}{path.suffix}")
    is_new = path is None or not os.path.exists(path)  # noqa: PTH110 - never raises
    create = Eeprom if path is None else partial(Eeprom.open, path)
    eeprom = create(model, error_shutdown=error_shutdown)
    stored = eeprom[ParameterKey.DEVICE_NUMBER]
    if device.number is None or device.number == stored:
        return eeprom
    if is_new:
        eeprom.write(ParameterKey.DEVICE_NUMBER, device.number)
    else:
        click.echo(f"{path} contains device {stored}; --device is ignored", err=True)
    return eeprom


def _choice(name: str, values: Sequence[str], default: str, help_text: str) -> click.Option:
    return click.Option(
        [name], type=click.Choice(values), default=default, show_default=True, help=help_text
    )


SIMULATOR = SimulatorPlugin(
    help="Control lines: channel, jumper, power, load, current, fault, battery, eeprom, accept, "
    "factory, line, show, quit; a command with missing arguments replies with its usage. With "
    'several devices, a control line begins with a device number, as in "@9 power cycle".',
    options=(
        _choice("--model", _MODELS, "trex", "Model of the board."),
        _choice("--firmware", _FIRMWARE, "1.2", "Firmware version."),
        _choice("--mode", MODE_JUMPERS, "serial", "Mode jumper."),
        click.Option(["--mix"], is_flag=True, help="Set the mix jumper."),
        click.Option(
            ["--echo"],
            is_flag=True,
            help="Echo the bytes from the host, as the RS-232 connector does.",
        ),
        click.Option(
            ["--eeprom"],
            type=FileName(path_type=Path, dir_okay=False),
            help="File for the board's EEPROM. With several devices, each device has a file "
            "with its number before the suffix.",
        ),
        _choice(
            "--error-shutdown",
            ("on", "off"),
            "on",
            "Factory default of `uart_error_shutdown`, which no source mentions.",
        ),
        _choice(
            "--timeout-needs-shutdown",
            ("on", "off"),
            "off",
            "Let the serial timeout stop motors only while `uart_error_shutdown` is on. The "
            "behaviour of a real TReX is unknown.",
        ),
        _choice(
            "--unknown-parameter",
            ("silent", "byte"),
            "silent",
            "Reply to a read of an unknown parameter: no byte (inferred) or the byte FF (twin).",
        ),
        _choice(
            "--rejected-write",
            ("quiet", "error"),
            "quiet",
            "Effect of a rejected write: no error bit (inferred) or a format error (twin).",
        ),
        click.Option(
            ["--device", "devices"],
            type=_read_device,
            metavar="NUMBER[:MODEL]",
            multiple=True,
            callback=_check_numbers,
            help="Add a board with this device number. Repeat the option for several boards on one "
            "line.",
        ),
        click.Option(["--demo"], is_flag=True, help="Move the sticks gently and load the motors."),
    ),
    build=simulate,
)
