"""The status, get and boards commands, which change no settings."""

import json
from typing import Any

import click

from trex_gui.core.cli import (
    CommandFailed,
    Interruption,
    ProgressLine,
    json_option,
    print_json,
    say,
)
from trex_gui.core.events import Event
from trex_gui.devices.trex.board.drive_status import AUXILIARY, DriveInputs, motor_setpoint
from trex_gui.devices.trex.board.keeper import Keeper
from trex_gui.devices.trex.board.mirror import BoardMirror
from trex_gui.devices.trex.cli.changes import say_warning
from trex_gui.devices.trex.cli.common import (
    PHYSICAL_KEYS,
    complete_parameter,
    identify,
    link_options,
    link_settings,
    open_line,
    physical_value,
    row_of,
    specs_of,
)
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import DeviceState, query, read_everything, read_reliably
from trex_gui.devices.trex.client.telemetry import (
    Currents,
    LatchedStatus,
    Raw,
    Remapped,
    StatusReader,
)
from trex_gui.devices.trex.discovery import NUMBERS, boards_by_number
from trex_gui.devices.trex.driving.blockers import Effect
from trex_gui.devices.trex.driving.board_reasons import (
    LED_TEXTS,
    SAFE_START_FLASH,
    SAFE_START_NOTE,
    board_reasons,
    led_patterns,
)
from trex_gui.devices.trex.protocol.commands import (
    GetCurrents,
    GetParameter,
    GetRawChannels,
    GetRemappedChannels,
)
from trex_gui.devices.trex.protocol.descriptions import MODE_TEXT
from trex_gui.devices.trex.protocol.flags import CHANNELS, Status, UartError, bit_names
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.session.messages import Batch, Connected, ReadReason
from trex_gui.devices.trex.settings.board_records import utc_now

_LATCH_TIME = 0.05
"""Seconds until a persistent error is latched again. Shorter than any serial timeout.

Inferred: the board checks faults and limits whenever it updates its ramps, at 100 Hz.
"""

_TITLES = {
    "product": "Product",
    "firmware": "Firmware",
    "mode_text": "Mode",
    "in_control": "In control",
}

_ERROR_TITLES = {False: "Errors", True: "Earlier errors, perhaps from a search for the board"}


@click.command()
@link_options
@json_option
def status(as_json: bool, **options: Any) -> None:
    """Show the state of the board, its measurements and its parameters.

    Shows the errors that occurred since they were last read. Reading clears them in the board. The
    measured currents may be off by 20 % (twin), as documented for a board with the same motor
    drivers. In the vendor's document, channel 3 has six bits (0 to 63). The program reads seven
    bits (inferred).

    With --json, measurements are numbers with the unit in the key, as in `trexcmd stream` and in
    recordings. The motor currents are `motor_1_current_A` and `motor_2_current_A`. Each channel has
    `raw` (counts), `pulse_us` or `voltage_V`, and `remapped` (-127 to 127). Without a valid signal,
    the first two are null. `mode` is R or A for RC or analog mode, and r or a for serial mode with
    these inputs. Each error has a text and the name of its column in recordings. `is_earlier` marks
    line errors that an earlier search for the board may have caused. Each parameter has its wire
    value and a text.

    `motors` lists the reasons why the motors do not follow serial commands. The effect of a reason
    is `stops` (the motors are or may be off), `blocks` (serial commands have no effect), `limits`
    (the speed is lower than commanded) or `note`. Past errors are not listed. `leds` contains the
    pattern that the board shows in this state. If a channel commands a speed and no current flows,
    safe-start may hold the motors (inferred), but a motor without load looks the same.

    `setpoints` contains the speeds (-127 to 127) at which motors 1, 2 and 3 (auxiliary) are set to
    turn. The source of a speed is `channel`, `safe_start` (safe-start holds the motor), `joint`
    (motor 2 works with motor 1), `not_armed` (serial commands control the motors, and this command
    sends none) or `unknown`. `events` contains the entries of the window's log, such as serial
    errors.
    """
    with open_line(link_settings(options)) as client:
        identify(client)
        state = read_everything(client.request, has_crc=client.has_crc)
        report = board_report(client, state)
    if as_json:
        print_json(report)
        return
    for key, title in _TITLES.items():
        click.echo(f"{title + ':':22}{report[key]}")
    click.echo(
        "LEDs:".ljust(22)
        + ", ".join(f"{led} {LED_TEXTS[pattern]}" for led, pattern in report["leds"].items())
    )
    if SAFE_START_FLASH in report["leds"].values():
        click.echo(" " * 22 + SAFE_START_NOTE)
    for motor in (1, 2):
        click.echo(f"Motor {motor} current:      {report[f'motor_{motor}_current_A']:.2f} A")
    for row in report["setpoints"]:
        name = "Auxiliary" if row["motor"] == AUXILIARY else f"Motor {row['motor']}"
        source = row["source"].replace("_", " ")
        click.echo(f"{name + ' setpoint:':22}{row['speed']} ({source})")
    click.echo("Motors:")
    if all(row["effect"] == Effect.NOTE.name.lower() for row in report["motors"]):
        click.echo("  Nothing prevents the motors from following serial commands.")
    for row in report["motors"]:
        click.echo(f"  {row['text']} {row['remedy']}".rstrip())
    click.echo("Channels:")
    for row in report["channels"]:
        raw = row["raw"]
        text = "no signal" if raw is None else f"{state.source.text(raw)} ({raw})"
        click.echo(f"  {row['channel']}  {text}, remapped {row['remapped']}")
    for is_earlier, title in _ERROR_TITLES.items():
        names = [row["text"] for row in report["errors"] if row["is_earlier"] is is_earlier]
        if names or not is_earlier:
            click.echo(f"{title}: {', '.join(names) or 'none'}")
    click.echo("Log:")
    for row in report["events"]:
        click.echo(f"  {row['text']}")
    click.echo("Parameters:")
    for key, row in report["parameters"].items():
        click.echo(f"  {key:28}{row['value']:>4}  {row['text']}")


@click.command("get")
@link_options
@click.argument("name", shell_complete=complete_parameter)
@json_option
def get_command(name: str, as_json: bool, **options: Any) -> None:
    """Show the wire value of a parameter, such as serial_timeout, and its meaning."""
    if not (known := specs_of(name)[0]).readable:
        raise click.UsageError(f"{known.name} can only be written.")
    with open_line(link_settings(options)) as client:
        board = identify(client)
        spec = parameters_of(board.model.key, board.firmware)[name]
        wire = read_reliably(client.request, GetParameter(spec.number), has_crc=client.has_crc)
    if as_json:
        click.echo(json.dumps({"name": spec.key, "value": wire, "text": spec.text(wire)}))
    else:
        click.echo(f"{wire}\t{spec.text(wire)}")


@click.command()
@link_options
@json_option
def boards(as_json: bool, **options: Any) -> None:
    """List the boards that share the line, with the options that reach each board.

    Probes every device number at the line settings of the options. No motor moves and no setting
    changes. Boards that are off or share a number are not listed. `trexcmd find` also probes other
    line settings.
    """
    link = link_settings(options)
    progress = ProgressLine("Probing")
    with open_line(link) as client, Interruption() as interrupted, progress as line:
        reachable = boards_by_number(
            client,
            lambda number: line(number, NUMBERS, f"device number {number}"),
            interrupted.__bool__,
        )
    if as_json:
        print_json([{"device_number": board.device_number, **row_of(board)} for board in reachable])
    else:
        for board in reachable:
            click.echo(f"{board.device_number}\t{board.signature}\t{row_of(board)['options']}")
    if not reachable:
        raise CommandFailed(f"No board replies to a device number on {link.text()}.")


def board_report(client: TrexClient, state: DeviceState) -> dict[str, Any]:
    reader = StatusReader(client.transport.clock)
    earlier = reader.read(client.request)  # errors since the last read
    raw = query(client.request, GetRawChannels())
    remapped = query(client.request, GetRemappedChannels())
    currents = query(client.request, GetCurrents())
    unit = state.signature.model.current_unit
    client.transport.wait(_LATCH_TIME)
    active = reader.read(client.request)
    now = client.transport.clock()
    samples = (
        Raw(now, tuple(raw.values())),
        Remapped(now, tuple(remapped.values())),
        Currents(now, currents),
        *([earlier] if earlier else []),
        LatchedStatus(now, active.status, active.uart),
    )
    board = BoardMirror(Keeper(say, say_warning).memory)
    connected = Connected(state, client.echo, ReadReason.OPENED, client.settings)
    events = [
        event
        for report in (connected, Batch(samples, client.counters))
        for event in board.handle(report, now, utc_now())
    ]
    inputs = board.inputs(now)
    assert inputs is not None  # noqa: S101 - the status was just read
    red, green = led_patterns(inputs)
    return {
        "product": state.signature.model.name,
        "firmware": state.signature.firmware,
        "mode": state.mode.value,
        "mode_text": MODE_TEXT[state.mode],
        "in_control": board.control_text,
        "serial_controls": state.serial_controls,
        "motors": [
            {
                "name": reason.blocker.name.lower(),
                "effect": reason.blocker.effect.name.lower(),
                "text": reason.text(),
                "remedy": reason.remedy(),
            }
            for reason in board_reasons(inputs)
        ],
        "leds": {"red": red, "green": green},
        "motor_1_current_A": round(currents[0] * unit, 4),
        "motor_2_current_A": round(currents[1] * unit, 4),
        "setpoints": [
            {"motor": motor, "source": setpoint.source.name.lower(), "speed": setpoint.speed}
            for motor in (1, 2, AUXILIARY)
            for setpoint in [motor_setpoint(motor, DriveInputs(board=inputs), board.newest, 0)]
        ],
        "channels": [
            {
                "channel": channel,
                "raw": raw[channel],
                PHYSICAL_KEYS[state.source]: physical_value(state.source, raw[channel]),
                "remapped": remapped[channel],
            }
            for channel in CHANNELS
        ],
        "errors": _errors(earlier, active),
        "events": [
            {"kind": event.kind.value, "text": event.text, "is_problem": event.is_problem}
            for event in events
            if isinstance(event, Event)
        ],
        "parameters": {
            key: {"value": wire, "text": state.specs[key].text(wire)}
            for key, wire in state.parameters.items()
        },
    }


def _errors(before: LatchedStatus, active: LatchedStatus) -> list[dict[str, str | bool]]:
    """Return a row for each set bit. A search for the board may have caused `is_earlier` errors."""
    status, uart = before.status | active.status, before.uart | active.uart
    earlier = before.uart & ~active.uart & ~UartError.TIMEOUT
    is_announced = bool(earlier) and earlier == uart  # the status bit reports no newer error
    rows: list[tuple[str, Status | UartError, bool]] = [
        *(("status", bit, bit is Status.UART_ERROR and is_announced) for bit in status),
        *(("uart", bit, bool(bit & earlier)) for bit in uart),
    ]
    return [
        {"name": f"{byte}_{bit.name}".lower(), "text": bit_names(bit)[0], "is_earlier": is_earlier}
        for byte, bit, is_earlier in rows
    ]
