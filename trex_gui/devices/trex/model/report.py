"""Parts of a support report about the board."""

from collections.abc import Callable
from functools import partial

from trex_gui.core.texts import counted
from trex_gui.devices.trex.board.drive_status import drive_statuses
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import drive_inputs
from trex_gui.devices.trex.protocol.descriptions import MODE_TEXT
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.settings.writer import write_settings


def status_text(device: Device) -> str:
    lines = [f"State: {device.status}"]
    if (settings := device.settings) is not None:
        number = settings.device_number
        packets = "compact" if number is None else f"expanded, to device {number}"
        lines += [f"Line: {settings.text()}", f"Packets: {packets}"]
    counters = device.board.counters
    lines.append(
        f"Requests: {counters.requests}, replies: {counters.replies}, timeouts: "
        f"{counters.missing}, corrupted replies: {counters.corrupted}, unsolicited bytes: "
        f"{counters.unsolicited}, slowest reply: {1000 * counters.slowest:.0f} ms"
    )
    lines += [
        f"{entry.name}: {counted(entry.count, 'time')}, last {entry.last:%Y-%m-%d %H:%M:%S}"
        for entry in device.board.errors.entries
        if entry.last is not None
    ]
    statuses = drive_statuses(drive_inputs(device))
    lines += [f"Motors: {status.text} {status.remedy}".rstrip() for status in statuses]
    state, telemetry = device.state, device.telemetry
    if state is None:
        return "\n".join([*lines, ""])
    lines += [
        f"Board: {device.board_name}",
        f"Mode: {MODE_TEXT[state.mode]}",
        f"In control: {device.board.control_text}",
        f"Echo: {_yes_or_no(device.board.echo)}",
        f"Guardian: {_yes_or_no(device.connection.is_guarded)}",
        f"Armed: {_yes_or_no(device.motors.armed)}, may be moving: {_yes_or_no(device.may_move)}",
        f"Currents (A): {telemetry.motor_currents}",
    ]
    lines += [
        f"Channel {channel}: raw {telemetry.raw_of(channel)}, "
        f"remapped {telemetry.remapped_of(channel)}"
        for channel in CHANNELS
    ]
    lines += [f"Not read: {key}: {reason}" for key, reason in state.unread.items()]
    return "\n".join([*lines, ""])


def _yes_or_no(value: bool) -> str:
    return "yes" if value else "no"


def settings_parts(device: Device) -> dict[str, Callable[[], str]]:
    stored, shown = device.draft.stored, device.draft.shown
    parts: dict[str, Callable[[], str]] = {}
    if stored is not None:
        parts["settings.txt"] = partial(write_settings, stored)
    if shown is not None and device.draft.pending:
        parts["settings_edited.txt"] = partial(write_settings, shown)
    return parts
