"""The program offers to restore lost settings and unapplied edits."""

from pathlib import Path

import pytest

from tests.support.program import trex
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.window import WindowDriver
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_files import BoardIdentity, EditFiles
from trex_gui.devices.trex.settings.history import SettingsHistory
from trex_gui.devices.trex.views.changes.dialog import ChangesDialog


def question_text(window: WindowDriver) -> str:
    return window.window.question.text


def reconnect(window: WindowDriver, url: str) -> None:
    window.disconnect()
    window.connect(url)
    window.wait(lambda: window.device.records.files.is_idle)


def test_lost_settings_of_a_board_are_shown_and_restored(
    window: WindowDriver, quick_simulator: SimulatedDevice, start_simulator: StartSimulator
) -> None:
    lost = start_simulator()  # like the same board after it lost its settings
    window.connect(quick_simulator.url)
    assert not question_text(window), "nothing was applied yet"
    window.apply(serial_timeout=15, motor1_acceleration=3)
    reconnect(window, quick_simulator.url)
    assert not question_text(window)

    reconnect(window, lost.url)
    assert "of this TReX differ from the last applied values (20" in question_text(window)
    window.click("questionCancel")
    reconnect(window, lost.url)
    window.click("showDiffering")
    dialog = window.find(ChangesDialog, "loadSettingsDialog")
    assert {row.key for row in dialog.ticked} == {"serial_timeout", "motor1_acceleration"}
    window.click("takeChangesButton")
    window.apply()
    assert lost.show()["parameters"]["serial_timeout"] == 15
    reconnect(window, lost.url)
    assert not question_text(window)


def test_snapshot_includes_calibrations_that_the_board_hides(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("jumper mode analog", "power cycle")
    window.connect(quick_simulator.url)
    window.disconnect()
    quick_simulator.do("jumper mode serial", "power cycle")
    window.connect(quick_simulator.url)
    window.wait(lambda: window.device.records.files.is_idle)
    window.apply(serial_timeout=15)
    (snapshot,) = SettingsHistory().snapshots()
    assert len(SettingsHistory().load(snapshot).calibrations) == 10
    assert "# analog calibrations: read 20" in Path(snapshot.path).read_text()


TREX = device_table().model("trex")
BOARD = BoardIdentity(TREX, "1.2", 7)


def saved_edits() -> dict[str, int]:
    saved = EditFiles().load(BOARD)
    return {} if saved is None else dict(saved.settings.parameters)


def test_edits_of_a_crashed_run_are_offered_and_restored(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    edits = {"serial_timeout": 15, "motor1_acceleration": 3}
    EditFiles().save(BOARD, Settings(TREX, "1.2", edits))
    window.connect(quick_simulator.url)
    window.wait(lambda: question_text(window))
    assert question_text(window).startswith(
        "Edited earlier but not applied: 2 settings of this TReX ("
    )
    window.click("questionCancel")
    assert window.device.draft.pending == 0

    window.disconnect()
    window.connect(quick_simulator.url)
    window.wait(lambda: question_text(window))
    window.click("restoreEdits")
    assert not question_text(window)
    assert dict(window.device.parameters.values.pending) == edits
    assert window.is_enabled("applyButton")


@pytest.mark.parametrize(
    ("button", "saved"), [("keepAndClose", {"serial_timeout": 15}), ("closeYes", {})]
)
def test_closing_saves_or_discards_edits(
    connected_window: WindowDriver, button: str, saved: dict[str, int]
) -> None:
    connected_window.device.parameters.edit("serial_timeout", 15)
    assert not connected_window.window.close()
    connected_window.click(button)
    assert not connected_window.window.isVisible()
    assert saved_edits() == saved


def test_edits_after_cancelled_closing_are_saved(
    connected_window: WindowDriver, monkeypatch: pytest.MonkeyPatch
) -> None:
    window, workspace = connected_window, trex(connected_window.program).workspace
    window.device.parameters.edit("serial_timeout", 15)
    monkeypatch.setattr(workspace.files, "may_close", lambda _leave: False)
    assert not window.window.close()
    window.click("closeYes")
    assert window.window.isVisible()
    window.device.parameters.edit("serial_timeout", 20)
    window.program.device_manager.shut_down()
    assert window.program.shut_down()
    assert saved_edits() == {"serial_timeout": 20}, "the program was ended from outside"
    workspace.prepare_to_close()
    workspace.finish()
    assert saved_edits() == {"serial_timeout": 20}
