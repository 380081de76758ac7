"""Conditions that must hold during and after a fault."""

import csv
from collections.abc import Callable, Collection
from pathlib import Path

from tests.devices.trex.recording.samples import read_file
from tests.fault_matrix.cases import timeout_needs_shutdown
from tests.fault_matrix.faults import FAULTS, Effect, Fault
from tests.fault_matrix.moments import APPLYING, DRIVING, MOMENTS
from tests.fault_matrix.scene import Scene, Stored
from tests.support.simulator import StartSimulator
from tests.support.window import WindowDriver
from trex_gui.core.errors import StudioError
from trex_gui.devices.trex.protocol.calibration import CalibrationKey
from trex_gui.ui.devices.connection import ConnectionState

HOLD_SECONDS = 3.0
"""Duration of a fault: longer than a jammed port or a stop."""

HEAL_SECONDS = 1.0
"""Time in which the user sees the end of a fault."""

SETTLE_MS = 10_000
"""Milliseconds until the effects of a fault are repaired."""

# --- Messages ---------------------------------------------------------------------------

GONE = "is gone. Plug the adapter in"
NOT_RESPONDING = "The board has stopped responding"
NO_BOARD = "No TReX responds"
NOT_STORED = "Not verified: "
WRITTEN = "written and verified"
NOTHING_WRITTEN = "Nothing was written"
NOTHING_MORE = "Nothing else was written"
READ_FAILED = "The settings could not be read again"
MAY_TURN = "may still be turning"
UNCONFIRMED = "The stop is not confirmed"
NOTHING_CHANGED = "Nothing was changed"
RECORDED = "Recorded to"
UNWRITABLE = "cannot be written"
NOT_EXPORTED = "was not written"
EXPORTED = "written to"
INTERNAL = "Internal error"
CONNECTED = ", device 7"
NO_TREX = "not like a TReX"
ECHO_ONLY = "comes back, and nothing else"
DIFFER = "differ each time"
CONNECTION_LOST = "The connection was lost."
FOUND = "1 board found."

Words = tuple[str, ...]

_USUAL: dict[str, tuple[Words, ...]] = {
    **dict.fromkeys(APPLYING, ((WRITTEN,),)),
    "recording": ((RECORDED,),),
    "export": ((EXPORTED,),),
    "find": ((FOUND,),),
    "connect": ((CONNECTED,),),
}


def _said_when_lost(
    lost: Words, at_connecting: Words, at_finding: Words
) -> dict[str, tuple[Words, ...]]:
    return {
        **dict.fromkeys(MOMENTS, (lost,)),
        "connect": (at_connecting,),
        "read_all": (lost, (READ_FAILED,)),
        **dict.fromkeys(APPLYING, (lost, (NOT_STORED, NOTHING_MORE))),
        "apply_verified": (lost, (WRITTEN,)),
        "learning": (lost, (NOTHING_CHANGED,)),
        "driving": (lost, (MAY_TURN,)),
        "recording": (lost, (RECORDED,)),
        "export": (lost, (EXPORTED,)),
        "find": (at_finding,),
        "closing": ((UNCONFIRMED,),),
    }


SAID: dict[Effect, dict[str, tuple[Words, ...]]] = {
    Effect.NONE: _USUAL,
    # `_check_applied` checks the messages of Apply.
    Effect.BRIEF: {
        **_USUAL,
        **dict.fromkeys(APPLYING, ()),
        "connect": ((CONNECTED, NO_BOARD, NO_TREX, ECHO_ONLY, DIFFER),),
    },
    Effect.SILENT: _said_when_lost((NOT_RESPONDING,), (NO_BOARD,), (FOUND,)),
    Effect.GONE: _said_when_lost((GONE,), (GONE,), (GONE,)),
    Effect.LOST: _said_when_lost((NOT_RESPONDING, GONE), (NO_BOARD, GONE), (FOUND, GONE)),
}
"""Required messages by event on the line: one of each group."""

SAID_OF: dict[tuple[str, str], tuple[Words, ...]] = {
    # The power fails while the line settings are stored: they become the default, and are written.
    ("other_uart", "apply_line_settings"): ((WRITTEN, NOT_STORED),),
    # Echoed requests can pass for measurements.
    ("echo", "driving"): ((NOT_RESPONDING,), (MAY_TURN,)),
    ("changed_files", "recording"): ((RECORDED, UNWRITABLE),),
    ("full_disk", "apply_snapshot"): ((NOTHING_WRITTEN,),),
    ("full_disk", "recording"): ((UNWRITABLE,),),
    ("full_disk", "export"): ((NOT_EXPORTED,),),
    ("read_only_disk", "apply_snapshot"): ((NOTHING_WRITTEN,),),
    ("read_only_disk", "export"): ((NOT_EXPORTED,),),
    # The other program does not receive every byte, so the stop may be confirmed.
    ("stolen_port", "closing"): (),
}
"""The same for single cases."""

NOT_SAID: dict[Effect, Words] = {
    Effect.NONE: (GONE, NOT_RESPONDING, NO_BOARD, UNCONFIRMED, NOT_STORED, INTERNAL),
    Effect.BRIEF: (GONE, INTERNAL),
    Effect.SILENT: (GONE, INTERNAL),
    Effect.GONE: (INTERNAL,),
    Effect.LOST: (INTERNAL,),
}
"""Wrong messages."""


def missing_messages(fault: str, moment: str, said: Collection[str]) -> list[Words]:
    """Return the missing messages."""
    effect = FAULTS[fault].effect
    wanted = SAID_OF.get((fault, moment), SAID[effect].get(moment, ()))
    return [words for words in wanted if not any(word in text for word in words for text in said)]


def wrong_messages(fault: str, said: Collection[str]) -> list[str]:
    """Return the wrong messages."""
    wrong = NOT_SAID[FAULTS[fault].effect]
    return [text for text in said if any(word in text for word in wrong)]


# --- The check --------------------------------------------------------------------------


Starved = Callable[[float, float], float]
"""Seconds between two times in which this process did not run."""


def never(begin: float, end: float) -> float:
    """Virtual time has no such pauses."""
    del begin, end
    return 0.0


def always(begin: float, end: float) -> float:
    """Pauses are unknown while other tests run."""
    return end - begin


def run_case(
    fault_name: str,
    moment_name: str,
    window: WindowDriver,
    start: StartSimulator,
    folder: Path,
    starved: Starved = never,
) -> None:
    """Run a fault at a moment. Fail if a condition does not hold."""
    fault, moment = FAULTS[fault_name], MOMENTS[moment_name]
    scene = Scene(
        window,
        start,
        folder,
        other_boards=fault.other_boards,
        needs_shutdown=timeout_needs_shutdown(fault_name, moment_name),
    )

    def inject() -> None:
        scene.start_watching()
        fault.inject(scene)

    healed = False
    try:
        moment.begin(scene, inject)
        scene.let_pass(HOLD_SECONDS)
        if not fault.hides_board:
            _check_motors(scene, fault)
        if fault_name == "unplug" and moment_name in DRIVING:
            _check_silence(scene)
        fault.heal(scene)
        healed = True
        scene.let_pass(HEAL_SECONDS)
        moment.end(scene)
    finally:
        if not healed:
            fault.heal(scene)
    said = tuple(scene.said)
    assert missing_messages(fault_name, moment_name, said) == [], said
    assert wrong_messages(fault_name, said) == []
    if moment_name in APPLYING:
        _check_applied(scene, fault_name, said)
    if scene.window.window.isVisible():
        _recover(scene, fault)
        _check_settings(scene, fault)
        _check_close(scene)
    else:
        assert not scene.motors_turn()
    longest_gap = max((end - begin - starved(begin, end) for begin, end in scene.gaps), default=0.0)
    assert longest_gap <= moment.longest_gap
    _check_other_boards(scene)
    _check_snapshots(scene)
    _check_files(scene, fault_name, said)


def _check_motors(scene: Scene, fault: Fault) -> None:
    """Motors run as commanded and reported, or a message warns that they may run."""
    if scene.window.device.may_move:
        return
    if fault.forges:  # a query can have become a command, until the idle motors are refreshed
        scene.window.wait(lambda: not scene.motors_turn(), SETTLE_MS)
    assert not scene.motors_turn()


def _check_silence(scene: Scene) -> None:
    """A board without a line stops at its serial timeout, or `SAID` warns of it."""
    assert scene.motors_turn() is scene.needs_shutdown


def _recover(scene: Scene, fault: Fault) -> None:
    """Reconnect if necessary, then stop."""
    window = scene.window
    moving = {ConnectionState.CONNECTING, ConnectionState.DISCONNECTING}
    window.wait(lambda: scene.link not in moving)
    if scene.link is ConnectionState.DISCONNECTED:
        window.connect(scene.url)
    window.wait(lambda: scene.link is ConnectionState.CONNECTED)
    _check_motors(scene, fault)
    window.wait(lambda: not window.motors.armed or scene.driven() == scene.targets)
    window.program.device_manager.press_stop()
    window.wait(lambda: not window.device.may_move)
    window.wait(lambda: not scene.motors_turn())


def _check_applied(scene: Scene, fault: str, said: Collection[str]) -> None:
    """The result of each edit agrees with the stored value."""
    stored = scene.stored()
    if fault == "other_uart":  # another program has written them
        stored["uart_settings"] = scene.edits["uart_settings"]
    name_of = scene.window.device.draft.name_of
    missing = {name_of(key) for key, value in scene.edits.items() if stored[key] != value}
    refused = [text for text in said if text.startswith(NOT_STORED)]
    aborted = [text for text in said if NOTHING_MORE in text or NOTHING_WRITTEN in text]
    is_written = any(WRITTEN in text for text in said)
    is_lost = any(text == CONNECTION_LOST for text in said)
    assert is_written + bool(refused) + bool(aborted) + is_lost == 1, said
    assert not (is_written and missing), missing
    unnamed = {name for name in missing if not any(name in text for text in refused)}
    assert not (refused and unnamed), unnamed


def _check_settings(scene: Scene, fault: Fault) -> None:
    """Every edit is stored or pending, other values are unchanged, and the window is correct."""
    device = scene.window.device

    def check_shown() -> None:
        assert device.state is not None
        stored = scene.stored()
        shown: Stored = {**device.state.parameters}
        for channel, calibration in device.state.calibrations.items():
            shown[CalibrationKey.of(device.state.source, channel)] = calibration
        untrue = {key: (shown[key], stored[key]) for key in shown if shown[key] != stored[key]}
        assert untrue == {}, untrue

    # After a failed write, everything is read again.
    scene.window.qtbot.waitUntil(check_shown, timeout=SETTLE_MS)
    stored = scene.stored()

    def lost() -> list[str]:
        pending: Stored = dict(device.parameters.values.pending)
        pending.update(device.calibrations.pending)
        return [key for key, value in scene.edits.items() if pending.get(key, stored[key]) != value]

    scene.window.wait(lambda: not lost() or device.edit_backup.offer is not None, SETTLE_MS)
    if lost():  # another board was connected meanwhile
        scene.window.click("restoreEdits")
    assert lost() == []
    assert device.state is not None
    before = scene.stored_before
    wrong = {
        key: stored[key]
        for key in before
        if stored[key] not in {before[key], scene.edits.get(key, before[key])}
    }
    # A power cut while a value is stored leaves its default.
    assert len(wrong) <= fault.cuts_power, wrong
    specs = device.state.specs
    assert all(key in scene.edits and value == specs[key].default for key, value in wrong.items())


def _check_other_boards(scene: Scene) -> None:
    """The other boards have not written anything."""
    assert scene.others() == scene.others_before


def _check_close(scene: Scene) -> None:
    """The window closes without a message about motors."""
    scene.window.device.draft.discard_edits()
    assert scene.window.window.close()
    assert not scene.window.program.device_manager.unconfirmed_stop


def _check_snapshots(scene: Scene) -> None:
    """A snapshot with the previous settings exists before anything is written."""
    history = scene.window.device.writer.history
    own = [one for one in history.snapshots() if one.path not in scene.foreign]
    assert all(history.load(snapshot) == scene.before for snapshot in own)
    stored = scene.stored()
    assert own or not any(stored[key] == value for key, value in scene.edits.items())


def _check_files(scene: Scene, fault: str, said: Collection[str]) -> None:
    """A recording or an export is complete, or does not exist."""
    for path in scene.files:
        if fault == "changed_files":
            continue  # somebody else has written there
        if path.suffix == ".trexrec":
            _check_recording(path, is_cut=fault == "full_disk")
        elif path.exists() or any(EXPORTED in text for text in said):
            with path.open(newline="") as file:
                rows = list(csv.reader(file))
            assert {len(row) for row in rows} == {len(rows[0])}


def _check_recording(path: Path, *, is_cut: bool) -> None:
    try:
        _, records, problems = read_file(path)
    except StudioError:
        assert is_cut
        raise
    assert len(records) > 50
    assert is_cut or problems == []
