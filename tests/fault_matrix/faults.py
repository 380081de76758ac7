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

_OFF_MS = 500
"""Milliseconds without power in a power cycle, and without a board while boards are exchanged."""


class Effect(Enum):
    """Effect of a fault on the line."""

    NONE = "nothing"
    BRIEF = "some transactions fail, or none"
    SILENT = "the board does not respond until the end of the fault"
    GONE = "the port is gone until the end of the fault"
    LOST = "either silent or gone, depending on the system"


@dataclass(frozen=True, slots=True)
class Fault:
    """Fault of the line, a board or the disk.

    Attributes:
        effect: effect that a message must report.
        inject, heal: functions that begin and end the fault.
        other_boards: true if the fault requires more than one board.
        hides_board: true if the test cannot read the board during the fault.
        forges: true if undetected corruption can turn another request into a motor command.
        cuts_power: true if the board can lose a value while it stores the value.
    """

    effect: Effect
    inject: Action
    heal: Action
    other_boards: bool = False
    hides_board: bool = False
    forges: bool = False
    cuts_power: bool = False


def _lines(*lines: str) -> Action:
    def run_lines(harness: FaultHarness) -> None:
        harness.board.do(*lines)

    return run_lines


def _swap(new: int, old: int) -> Action:
    """Replace the board on the line by another board."""

    def swap(harness: FaultHarness) -> None:
        harness.switch(old, "off")
        _soon(harness, lambda: harness.switch(new, "on"))

    return swap


def _soon(harness: FaultHarness, action: Callable[[], object]) -> None:
    new_timer(harness.window.window, _OFF_MS, action, single_shot=True).start()


def _change_uart(harness: FaultHarness) -> None:
    """Restart the board with settings that no scan probes."""
    harness.uart_settings = harness.board.show()["parameters"]["uart_settings"]
    other = LineSettings(38400, stop_bits=2).to_wire()
    _lines("power off", f"eeprom uart_settings {other}")(harness)
    _soon(harness, lambda: harness.board.do("power on"))


def _restore_uart(harness: FaultHarness) -> None:
    _lines("power off", f"eeprom uart_settings {harness.uart_settings}")(harness)
    _soon(harness, lambda: harness.board.do("power on"))


def _replace_files(harness: FaultHarness) -> None:
    """Overwrite the file that is being written, and add a damaged snapshot."""
    noise = random.Random(0).randbytes(5000)
    snapshot = harness.data / "snapshots" / "20260101T000000Z-trex-1.2.txt"
    snapshot.parent.mkdir(exist_ok=True)
    harness.foreign += [*harness.files, snapshot]
    for path in harness.foreign:
        path.write_bytes(noise)


def _noise(probability: float) -> Fault:
    return Fault(
        Effect.BRIEF, _lines(f"line noise {probability}"), _lines("line noise 0"), forges=True
    )


def _port(effect: Effect, fault: PortFault) -> Fault:
    return Fault(
        effect,
        lambda harness: harness.line.set_port_fault(fault),
        lambda harness: harness.line.set_port_fault(PortFault.NONE),
        hides_board=fault is PortFault.JAMMED,
    )


def _limit_files(size: int | None) -> Action:
    """Prevent files from growing, as on a full disk."""

    def limit(_harness: FaultHarness) -> None:
        if sys.platform == "win32":
            pytest.skip("needs resource limits of POSIX")
        import resource

        _, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
        resource.setrlimit(resource.RLIMIT_FSIZE, (hard if size is None else size, hard))

    return limit


def _lock_folders(harness: FaultHarness) -> None:
    """Replace the folders of user and program by a folder that accepts no files."""
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
    "unplug": Fault(Effect.GONE, _lines("line unplug"), _lines("line plug")),
    "mute": Fault(Effect.SILENT, _lines("line mute on"), _lines("line mute off")),
    "dropped": Fault(Effect.BRIEF, _lines("line drop 3"), _lines("line drop 0")),
    "swallowed": Fault(Effect.BRIEF, _lines("line drop 40"), _lines("line drop 0")),
    "dropped_sent": Fault(Effect.BRIEF, _lines("line drop 3 sent"), _lines("line drop 0 sent")),
    "duplicated": Fault(Effect.BRIEF, _lines("line double 3"), _lines("line double 0")),
    "corrupted": Fault(Effect.BRIEF, _lines("line corrupt 3"), _lines("line corrupt 0")),
    "late": Fault(Effect.BRIEF, _lines("line delay 0.3"), _lines("line delay 0")),
    "noise_0.1": _noise(0.001),
    "noise_1": _noise(0.01),
    "noise_5": _noise(0.05),
    "framing": Fault(Effect.BRIEF, _lines("line error framing 5"), _lines("line error off")),
    "garbage": Fault(Effect.BRIEF, _lines("line garbage " + "00FF55C2" * 20), _nothing),
    "power_cut": Fault(Effect.SILENT, _lines("power off"), _lines("power on"), cuts_power=True),
    "other_uart": Fault(Effect.SILENT, _change_uart, _restore_uart, cuts_power=True),
    "brown_out": Fault(Effect.SILENT, _lines("battery 3"), _lines("battery 12"), cuts_power=True),
    "other_board": Fault(
        Effect.BRIEF, _swap(OTHER, FIRST), _swap(FIRST, OTHER), other_boards=True, cuts_power=True
    ),
    "other_model": Fault(
        Effect.BRIEF, _swap(JUNIOR, FIRST), _swap(FIRST, JUNIOR), other_boards=True, cuts_power=True
    ),
    "echo": Fault(Effect.BRIEF, _lines("line echo on"), _lines("line echo off")),
    "stolen_port": _port(Effect.LOST, PortFault.STOLEN),
    "slow_port": _port(Effect.BRIEF, PortFault.SLOW),
    "jammed_port": _port(Effect.LOST, PortFault.JAMMED),
    "full_disk": Fault(Effect.NONE, _limit_files(1), _limit_files(None)),
    "read_only_disk": Fault(Effect.NONE, _lock_folders, _unlock_folders),
    "changed_files": Fault(Effect.NONE, _replace_files, _nothing),
}
