"""Faults and their repair."""

import random
import sys
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

import pytest

from tests.fault_matrix.scene import FIRST, JUNIOR, OTHER, Scene
from tests.support.simulator import PortFault
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.ui.runtime import new_timer

Act = Callable[[Scene], object]

_OFF_MS = 500
"""Milliseconds without power in a power cycle, and without a board in an exchange."""


class Effect(Enum):
    """Effect of a fault on the line."""

    NONE = "nothing"
    BRIEF = "some transactions fail, or none"
    SILENT = "the board does not respond until it is over"
    GONE = "the port is gone until it is over"
    LOST = "one of the two, as the system likes"


@dataclass(frozen=True, slots=True)
class Fault:
    """Something that goes wrong.

    Attributes:
        effect: what the user is to be told of the line.
        inject, heal: begin and end it.
        other_boards: whether it takes more than one board.
        hides_board: whether the board cannot be looked at meanwhile.
        forges: whether undetected damage can make a motor command of another request.
        cuts_power: whether the board can lose a value that it is storing.
    """

    effect: Effect
    inject: Act
    heal: Act
    other_boards: bool = False
    hides_board: bool = False
    forges: bool = False
    cuts_power: bool = False


def _lines(*lines: str) -> Act:
    def obey(scene: Scene) -> None:
        scene.board.do(*lines)

    return obey


def _swap(here: int, gone: int) -> Act:
    """Replace the board on the line by another board."""

    def swap(scene: Scene) -> None:
        scene.switch(gone, "off")
        _soon(scene, lambda: scene.switch(here, "on"))

    return swap


def _soon(scene: Scene, act: Callable[[], object]) -> None:
    new_timer(scene.window.window, _OFF_MS, act, single_shot=True).start()


def _change_uart(scene: Scene) -> None:
    """Restart the board with settings that no scan probes."""
    scene.uart_settings = scene.shown()["parameters"]["uart_settings"]
    other = LineSettings(38400, stop_bits=2).to_wire()
    _lines("power off", f"eeprom uart_settings {other}")(scene)
    _soon(scene, lambda: scene.board.do("power on"))


def _restore_uart(scene: Scene) -> None:
    _lines("power off", f"eeprom uart_settings {scene.uart_settings}")(scene)
    _soon(scene, lambda: scene.board.do("power on"))


def _replace_files(scene: Scene) -> None:
    """Write other data over the written file and into the folder of the snapshots."""
    noise = random.Random(0).randbytes(5000)
    snapshot = scene.data / "snapshots" / "20260101T000000Z-trex-1.2.txt"
    snapshot.parent.mkdir(exist_ok=True)
    scene.foreign += [*scene.files, snapshot]
    for path in scene.foreign:
        path.write_bytes(noise)


def _noise(probability: float) -> Fault:
    return Fault(
        Effect.BRIEF, _lines(f"line noise {probability}"), _lines("line noise 0"), forges=True
    )


def _port(effect: Effect, fault: PortFault) -> Fault:
    return Fault(
        effect,
        lambda scene: scene.line.set_port_fault(fault),
        lambda scene: scene.line.set_port_fault(PortFault.NONE),
        hides_board=fault is PortFault.JAMMED,
    )


def _limit_files(size: int | None) -> Act:
    """Prevent files from growing, as on a full disk."""

    def limit(_scene: Scene) -> None:
        if sys.platform == "win32":
            pytest.skip("needs limits of POSIX")
        import resource

        _, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
        resource.setrlimit(resource.RLIMIT_FSIZE, (hard if size is None else size, hard))

    return limit


def _lock_folders(scene: Scene) -> None:
    """Replace the user's folder by a folder that accepts no files."""
    for folder in (scene.folder, scene.data):
        folder.rename(_moved(folder))
        folder.symlink_to("/sys", target_is_directory=True)


def _unlock_folders(scene: Scene) -> None:
    for folder in (scene.folder, scene.data):
        folder.unlink()
        _moved(folder).rename(folder)


def _moved(folder: Path) -> Path:
    return folder.with_name(f"{folder.name} moved")


def _nothing(_scene: Scene) -> None:
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
