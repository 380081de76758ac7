"""Faults and their repair."""

import random
import sys
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

import pytest

from tests.fault_matrix.harness import FIRST, JUNIOR, OTHER, FaultHarness
from tests.support.simulator import PortFault
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.ui.runtime import new_timer

Action = Callable[[FaultHarness], object]

_POWER_OFF_MS = 500
"""Milliseconds without power in a power cycle, and without a board while boards are exchanged."""


class Effect(Enum):
    """Effect of a fault on the line."""

    NONE = "nothing"
    BRIEF = "some transactions fail, or none"
    SILENT = "the board does not respond until the end of the fault"
    GONE = "the port is gone until the end of the fault"
    VANISHED = "either silent or gone, depending on the system"


@dataclass(frozen=True, slots=True)
class Fault:
    """Fault of the line, a board or the disk.

    Attributes:
        effect: effect that a message must report.
        inject, heal: functions that begin and end the fault.
        other_boards: true if the fault requires more than one board.
        hides_board: true if the test cannot read the board during the fault.
        forges: true if undetected corruption can turn a request into a motor command.
        cuts_power: true if the board can lose a value while it stores the value.
    """

    effect: Effect
    inject: Action
    heal: Action
    other_boards: bool = False
    hides_board: bool = False
    forges: bool = False
    cuts_power: bool = False


def _control(*commands: str) -> Action:
    """Return a function that sends control lines to the simulator."""
    return lambda harness: harness.board.do(*commands)


def _swap(new: int, old: int) -> Action:
    """Replace the board on the line with another board."""

    def swap(harness: FaultHarness) -> None:
        harness.switch(old, "off")
        _after_power_off(harness, lambda: harness.switch(new, "on"))

    return swap


def _after_power_off(harness: FaultHarness, action: Callable[[], object]) -> None:
    new_timer(harness.window.window, _POWER_OFF_MS, action, single_shot=True).start()


def _change_uart(harness: FaultHarness) -> None:
    """Restart the board with line settings that the connection does not use."""
    harness.uart_settings = harness.board.show()["parameters"]["uart_settings"]
    other = LineSettings(38400, stop_bits=2).to_wire()
    _control("power off", f"eeprom uart_settings {other}")(harness)
    _after_power_off(harness, lambda: harness.board.do("power on"))


def _restore_uart(harness: FaultHarness) -> None:
    _control("power off", f"eeprom uart_settings {harness.uart_settings}")(harness)
    _after_power_off(harness, lambda: harness.board.do("power on"))


def _replace_files(harness: FaultHarness) -> None:
    """Overwrite the files that are being written, and add a damaged snapshot."""
    noise = random.Random(0).randbytes(5000)
    snapshot = harness.data / "snapshots" / "20260101T000000Z-trex-1.2.txt"
    snapshot.parent.mkdir(exist_ok=True)
    harness.foreign += [*harness.files, snapshot]
    for path in harness.foreign:
        path.write_bytes(noise)


def _noise(probability: float) -> Fault:
    return Fault(
        Effect.BRIEF, _control(f"line noise {probability}"), _control("line noise 0"), forges=True
    )


def _port(effect: Effect, fault: PortFault) -> Fault:
    return Fault(
        effect,
        lambda harness: harness.line.set_port_fault(fault),
        lambda harness: harness.line.set_port_fault(PortFault.NONE),
        hides_board=fault is PortFault.JAMMED,
    )


def _limit_files(size: int | None) -> Action:
    """Prevent files from growing beyond `size` bytes, as on a full disk. `None`: no limit."""

    def limit(_harness: FaultHarness) -> None:
        if sys.platform == "win32":
            pytest.skip("needs resource limits of POSIX")
        import resource

        _, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
        resource.setrlimit(resource.RLIMIT_FSIZE, (hard if size is None else size, hard))

    return limit


def _lock_folders(harness: FaultHarness) -> None:
    """Replace the folders of user and program with a folder that accepts no files."""
    for folder in (harness.folder, harness.data):
        folder.rename(_moved(folder))
        folder.symlink_to("/sys", target_is_directory=True)


def _unlock_folders(harness: FaultHarness) -> None:
    for folder in (harness.folder, harness.data):
        folder.unlink()
        _moved(folder).rename(folder)


def _moved(folder: Path) -> Path:
    return folder.with_name(f"{folder.name} moved")


def _nothing(_harness: FaultHarness) -> None:
    pass


FAULTS: dict[str, Fault] = {
    "unplug": Fault(Effect.GONE, _control("line unplug"), _control("line plug")),
    "mute": Fault(Effect.SILENT, _control("line mute on"), _control("line mute off")),
    "dropped": Fault(Effect.BRIEF, _control("line drop 3"), _control("line drop 0")),
    "swallowed": Fault(Effect.BRIEF, _control("line drop 40"), _control("line drop 0")),
    "dropped_sent": Fault(Effect.BRIEF, _control("line drop 3 sent"), _control("line drop 0 sent")),
    "duplicated": Fault(Effect.BRIEF, _control("line double 3"), _control("line double 0")),
    "corrupted": Fault(Effect.BRIEF, _control("line corrupt 3"), _control("line corrupt 0")),
    "late": Fault(Effect.BRIEF, _control("line delay 0.3"), _control("line delay 0")),
    "noise_0.1": _noise(0.001),
    "noise_1": _noise(0.01),
    "noise_5": _noise(0.05),
    "framing": Fault(Effect.BRIEF, _control("line error framing 5"), _control("line error off")),
    "garbage": Fault(Effect.BRIEF, _control("line garbage " + "00FF55C2" * 20), _nothing),
    "power_cut": Fault(Effect.SILENT, _control("power off"), _control("power on"), cuts_power=True),
    "other_uart": Fault(Effect.SILENT, _change_uart, _restore_uart, cuts_power=True),
    "brown_out": Fault(
        Effect.SILENT, _control("battery 3"), _control("battery 12"), cuts_power=True
    ),
    "other_board": Fault(
        Effect.BRIEF, _swap(OTHER, FIRST), _swap(FIRST, OTHER), other_boards=True, cuts_power=True
    ),
    "other_model": Fault(
        Effect.BRIEF, _swap(JUNIOR, FIRST), _swap(FIRST, JUNIOR), other_boards=True, cuts_power=True
    ),
    "echo": Fault(Effect.BRIEF, _control("line echo on"), _control("line echo off")),
    "stolen_port": _port(Effect.VANISHED, PortFault.STOLEN),
    "slow_port": _port(Effect.BRIEF, PortFault.SLOW),
    "jammed_port": _port(Effect.VANISHED, PortFault.JAMMED),
    "full_disk": Fault(Effect.NONE, _limit_files(1), _limit_files(None)),
    "read_only_disk": Fault(Effect.NONE, _lock_folders, _unlock_folders),
    "changed_files": Fault(Effect.NONE, _replace_files, _nothing),
}
