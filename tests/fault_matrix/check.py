"""Conditions that must hold during and after a fault."""

import csv
from collections.abc import Callable, Collection
from pathlib import Path

from tests.devices.trex.recording.samples import read_file
from tests.fault_matrix.cases import timeout_needs_shutdown
from tests.fault_matrix.faults import FAULTS, Effect, Fault
from tests.fault_matrix.harness import FaultHarness, Stored
from tests.fault_matrix.moments import APPLYING, DRIVING, MOMENTS
from tests.support.simulator import StartSimulator
from tests.support.window import WindowDriver
from trex_gui.devices.trex.protocol.calibration import CalibrationKey
from trex_gui.ui.devices.connection import ConnectionState

HOLD_SECONDS = 3.0
"""Duration of a fault. Longer than the timeouts of a jammed port and of a stop."""

HEAL_SECONDS = 1.0
"""Time in which the window shows the end of a fault."""

SETTLE_MS = 10_000
"""Milliseconds in which the program must repair the effects of a fault."""

# --- Messages ---------------------------------------------------------------------------

GONE = "is gone. Plug"
NOT_RESPONDING = "The board has stopped responding"
NO_BOARD = "No TReX responds"
NOT_VERIFIED = "Not verified: "
WRITTEN = "written and verified"
NOTHING_WRITTEN = "Nothing was written"
NOTHING_ELSE = "Nothing else was written"
READ_FAILED = "could not be read again"
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

Alternatives = tuple[str, ...]  # parts of messages, of which one is enough

_WITHOUT_FAULT: dict[str, tuple[Alternatives, ...]] = {
    **dict.fromkeys(APPLYING, ((WRITTEN,),)),
    "recording": ((RECORDED,),),
    "export": ((EXPORTED,),),
    "find": ((FOUND,),),
    "connect": ((CONNECTED,),),
}


def _messages_of_loss(
    lost: Alternatives, connecting: Alternatives, finding: Alternatives
) -> dict[str, tuple[Alternatives, ...]]:
    return {
        **dict.fromkeys(MOMENTS, (lost,)),
        "connect": (connecting,),
        "read_all": (lost, (READ_FAILED,)),
        **dict.fromkeys(APPLYING, (lost, (NOT_VERIFIED, NOTHING_ELSE))),
        "apply_verified": (lost, (WRITTEN,)),
        "learning": (lost, (NOTHING_CHANGED,)),
        "driving": (lost, (MAY_TURN,)),
        "recording": (lost, (RECORDED,)),
        "export": (lost, (EXPORTED,)),
        "find": (finding,),
        "closing": ((UNCONFIRMED,),),
    }


REQUIRED: dict[Effect, dict[str, tuple[Alternatives, ...]]] = {
    Effect.NONE: _WITHOUT_FAULT,
    # `_check_applied` checks the messages of Apply.
    Effect.BRIEF: {
        **_WITHOUT_FAULT,
        **dict.fromkeys(APPLYING, ()),
        "connect": ((CONNECTED, NO_BOARD, NO_TREX, ECHO_ONLY, DIFFER),),
    },
    Effect.SILENT: _messages_of_loss((NOT_RESPONDING,), (NO_BOARD,), (FOUND,)),
    Effect.GONE: _messages_of_loss((GONE,), (GONE,), (GONE,)),
    Effect.VANISHED: _messages_of_loss((NOT_RESPONDING, GONE), (NO_BOARD, GONE), (FOUND, GONE)),
}
"""Required messages by effect and moment: one message of each group."""

REQUIRED_OF_CASE: dict[tuple[str, str], tuple[Alternatives, ...]] = {
    # The power fails during the write of the line settings, which then have their default value.
    ("other_uart", "apply_line_settings"): ((WRITTEN, NOT_VERIFIED),),
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
"""Required messages by fault and moment, for cases that differ from `REQUIRED`."""

WRONG: dict[Effect, Alternatives] = {
    Effect.NONE: (GONE, NOT_RESPONDING, NO_BOARD, UNCONFIRMED, NOT_VERIFIED, INTERNAL),
    Effect.BRIEF: (GONE, INTERNAL),
    Effect.SILENT: (GONE, INTERNAL),
    Effect.GONE: (INTERNAL,),
    Effect.VANISHED: (INTERNAL,),
}
"""Messages that must not be shown, by effect."""


def missing_messages(fault: str, moment: str, messages: Collection[str]) -> list[Alternatives]:
    """Return each group of required messages of which no message was shown."""
    effect = FAULTS[fault].effect
    required = REQUIRED_OF_CASE.get((fault, moment), REQUIRED[effect].get(moment, ()))
    return [
        words for words in required if not any(word in text for word in words for text in messages)
    ]


def wrong_messages(fault: str, messages: Collection[str]) -> list[str]:
    """Return the shown messages that are wrong."""
    wrong = WRONG[FAULTS[fault].effect]
    return [text for text in messages if any(word in text for word in wrong)]


# --- Checks -----------------------------------------------------------------------------


Pauses = Callable[[float, float], float]
"""Returns the seconds between two times in which the computer did not run this process."""


def no_pauses(begin: float, end: float) -> float:
    """Return 0, because virtual time has no pauses."""
    del begin, end
    return 0.0


def unknown_pauses(begin: float, end: float) -> float:
    """Count every gap as a pause, because other tests run at the same time."""
    return end - begin


def run_case(
    fault_name: str,
    moment_name: str,
    window: WindowDriver,
    start: StartSimulator,
    folder: Path,
    pauses: Pauses = no_pauses,
) -> None:
    """Inject a fault at a moment. Fail if a condition does not hold."""
    fault, moment = FAULTS[fault_name], MOMENTS[moment_name]
    harness = FaultHarness(
        window,
        start,
        folder,
        other_boards=fault.other_boards,
        needs_shutdown=timeout_needs_shutdown(fault_name, moment_name),
    )

    def inject() -> None:
        harness.clear_messages()
        fault.inject(harness)

    healed = False
    try:
        moment.start(harness, inject)
        harness.window.wait_seconds(HOLD_SECONDS)
        if not fault.hides_board:
            _check_motors(harness, fault)
        if fault_name == "unplug" and moment_name in DRIVING:
            # The board stops at its serial timeout, unless that needs UART-Error Shutdown.
            assert harness.motors_run() is harness.needs_shutdown
        fault.heal(harness)
        healed = True
        harness.window.wait_seconds(HEAL_SECONDS)
        moment.end(harness)
    finally:
        if not healed:
            fault.heal(harness)
    messages = tuple(harness.messages)
    assert missing_messages(fault_name, moment_name, messages) == [], messages
    assert wrong_messages(fault_name, messages) == []
    if moment_name in APPLYING:
        _check_applied(harness, fault_name, messages)
    if harness.window.window.isVisible():
        _recover(harness, fault)
        _check_settings(harness, fault)
        _check_close(harness)
    else:
        assert not harness.motors_run()
    longest_gap = max(
        (end - begin - pauses(begin, end) for begin, end in harness.gaps), default=0.0
    )
    assert longest_gap <= moment.longest_gap
    assert harness.other_boards() == harness.other_boards_before
    _check_snapshots(harness)
    _check_files(harness, fault_name, messages)


def _check_motors(harness: FaultHarness, fault: Fault) -> None:
    """Motors are stopped, or the window shows that they may run."""
    if harness.window.device.may_move:
        return
    if fault.forges:  # a corrupted query can start a motor until the next refresh
        harness.window.wait(lambda: not harness.motors_run(), SETTLE_MS)
    assert not harness.motors_run()


def _recover(harness: FaultHarness, fault: Fault) -> None:
    """Reconnect if necessary, then stop the motors."""
    window = harness.window
    unsettled = {ConnectionState.CONNECTING, ConnectionState.DISCONNECTING}
    window.wait(lambda: harness.link not in unsettled)
    if harness.link is ConnectionState.DISCONNECTED:
        window.connect(harness.url)
    window.wait(lambda: harness.link is ConnectionState.CONNECTED)
    _check_motors(harness, fault)
    window.wait(lambda: not window.motors.armed or harness.motor_targets() == harness.targets)
    window.program.device_manager.press_stop()
    window.wait(lambda: not window.device.may_move)
    window.wait(lambda: not harness.motors_run())


def _check_applied(harness: FaultHarness, fault: str, messages: Collection[str]) -> None:
    """The result of each edit agrees with the stored value."""
    stored = harness.stored()
    if fault == "other_uart":  # the fault has written this value
        stored["uart_settings"] = harness.edits["uart_settings"]
    name_of = harness.window.device.draft.name_of
    missing = {name_of(key) for key, value in harness.edits.items() if stored[key] != value}
    rejected = [text for text in messages if text.startswith(NOT_VERIFIED)]
    aborted = [text for text in messages if NOTHING_ELSE in text or NOTHING_WRITTEN in text]
    is_written = any(WRITTEN in text for text in messages)
    is_lost = any(text == CONNECTION_LOST for text in messages)
    assert is_written + bool(rejected) + bool(aborted) + is_lost == 1, messages
    assert not (is_written and missing), missing
    unnamed = {name for name in missing if not any(name in text for text in rejected)}
    assert not (rejected and unnamed), unnamed


def _check_settings(harness: FaultHarness, fault: Fault) -> None:
    """The window shows the stored values. Edits are stored or pending, other values unchanged."""
    device = harness.window.device

    def check_shown() -> None:
        assert device.state is not None
        stored = harness.stored()
        shown: Stored = {**device.state.parameters}
        for channel, calibration in device.state.calibrations.items():
            shown[CalibrationKey.of(device.state.source, channel)] = calibration
        wrong = {key: (shown[key], stored[key]) for key in shown if shown[key] != stored[key]}
        assert wrong == {}, wrong

    # After a failed write, everything is read again.
    harness.window.qtbot.waitUntil(check_shown, timeout=SETTLE_MS)
    stored = harness.stored()

    def lost() -> list[str]:
        pending: Stored = dict(device.parameters.values.pending)
        pending.update(device.calibrations.pending)
        return [
            key for key, value in harness.edits.items() if pending.get(key, stored[key]) != value
        ]

    harness.window.wait(lambda: not lost() or device.edit_backup.offer is not None, SETTLE_MS)
    if lost():  # another board was connected in between
        harness.window.click("restoreEdits")
    assert lost() == []
    assert device.state is not None
    before = harness.stored_before
    wrong = {
        key: stored[key]
        for key in before
        if stored[key] not in {before[key], harness.edits.get(key, before[key])}
    }
    most = 1 if fault.cuts_power else 0  # a power cut during a write resets the value
    assert len(wrong) <= most, wrong
    specs = device.state.specs
    assert all(key in harness.edits and value == specs[key].default for key, value in wrong.items())


def _check_close(harness: FaultHarness) -> None:
    """The window closes without a message about motors."""
    harness.window.device.draft.discard_edits()
    assert harness.window.window.close()
    assert not harness.window.program.device_manager.unconfirmed_stop


def _check_snapshots(harness: FaultHarness) -> None:
    """A snapshot with the previous settings exists before anything is written."""
    history = harness.window.device.writer.history
    own = [each for each in history.snapshots() if each.path not in harness.foreign]
    assert all(history.load(snapshot) == harness.before for snapshot in own)
    stored = harness.stored()
    assert own or not any(stored[key] == value for key, value in harness.edits.items())


def _check_files(harness: FaultHarness, fault: str, messages: Collection[str]) -> None:
    """A recording is complete. An export is complete or does not exist."""
    if fault == "changed_files":
        return  # another program has overwritten the files
    for path in harness.files:
        if path.suffix == ".trexrec":
            _, records, problems = read_file(path)
            assert len(records) > 50
            assert fault == "full_disk" or problems == []
        elif path.exists() or any(EXPORTED in text for text in messages):
            with path.open(newline="") as file:
                rows = list(csv.reader(file))
            assert {len(row) for row in rows} == {len(rows[0])}
