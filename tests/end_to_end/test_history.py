"""The history of a board's settings: compare and restore snapshots."""

from datetime import timedelta

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox

from tests.support.pages.settings import HistoryDialog, ReviewDialog
from tests.support.program import trex
from tests.support.simulator import SimulatedDevice
from tests.support.snapshots import take
from tests.support.window import WindowDriver
from trex_gui.ui.devices.connection import ConnectionState


def open_history(window: WindowDriver) -> HistoryDialog:
    window.trigger("history")  # which makes the dialog at first
    dialog = HistoryDialog(window)
    dialog.open()
    return dialog


def pending(window: WindowDriver) -> dict[str, int]:
    return dict(window.device.parameters.values.pending)


def test_snapshots_are_restored_partly_and_completely(
    connected_window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    window = connected_window
    before = quick_simulator.show()["parameters"]
    window.apply(serial_timeout=5, motor1_acceleration=9)
    window.apply(serial_timeout=7, motor2_acceleration=8)
    dialog = open_history(window)
    assert dialog.count() == 2
    dialog.select_snapshot(1)
    dialog.wait(lambda: len(dialog.values()) == 3)
    assert dialog.values()["serial_timeout"] == ("0.7 s", "off")

    dialog.click("restoreButton")
    assert len(pending(window)) == 3
    dialog.wait_for_text("comparisonSummary", "matches this snapshot")
    assert not dialog.is_enabled("restoreButton")
    window.device.draft.undo.undo()
    assert not pending(window), "restoring is one step"
    dialog.wait(lambda: dialog.is_enabled("restoreButton"))

    dialog.check_only("Serial Timeout")
    dialog.click("restoreButton")
    assert pending(window) == {"serial_timeout": 0}
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 7
    review = ReviewDialog(window)
    assert review.root.isVisible()
    window.apply()
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 0
    assert quick_simulator.show()["parameters"]["motor1_acceleration"] == 9
    review.root.close()
    dialog.wait(lambda: dialog.count() == 3)

    dialog.wait(lambda: set(dialog.values()) == {"motor1_acceleration", "motor2_acceleration"})
    dialog.click("tickAllButton")
    dialog.click("restoreButton")
    window.apply()
    assert quick_simulator.show()["parameters"] == before


def test_edits_count_as_current_settings(connected_window: WindowDriver) -> None:
    window, edit = connected_window, connected_window.device.parameters.edit
    window.apply(serial_timeout=5)
    dialog = open_history(window)
    assert dialog.values() == {"serial_timeout": ("0.5 s", "off")}
    edit("serial_timeout", 9)
    dialog.wait(lambda: dialog.values() == {"serial_timeout": ("0.9 s", "off")})
    edit("serial_timeout", 0)
    dialog.wait(lambda: not dialog.values())

    edit("serial_timeout", 9)
    edit("motor1_acceleration", 9)
    dialog.wait(lambda: len(dialog.values()) == 2)
    dialog.check_only("Serial Timeout")
    edit("motor2_acceleration", 4)
    dialog.wait(lambda: len(dialog.values()) == 3)
    dialog.click("restoreButton")
    assert pending(window) == {
        "serial_timeout": 0,  # restored
        "motor1_acceleration": 9,
        "motor2_acceleration": 4,
    }


def test_snapshot_of_another_board_shows_a_note(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    history = window.device.writer.history
    take(history, timedelta(hours=1), device_number=9)
    take(history, model="trexjr")
    dialog = open_history(window)
    assert "No board is connected" in dialog.text("restoreNote")

    window.connect(quick_simulator.url)
    dialog.wait_for_text("restoreNote", "of a TReX Jr, and the board here is a TReX")
    assert not dialog.is_enabled("restoreButton")
    dialog.select_snapshot(1)
    dialog.wait_for_text("restoreNote", "device number 9, the board here is number 7")
    assert dialog.is_enabled("restoreButton")

    dialog.click("deleteSnapshotButton")
    assert dialog.has("historyQuestion")
    assert dialog.root.windowModality() is Qt.WindowModality.NonModal
    with window.qtbot.waitSignal(window.motors.stop_requested):
        window.click("stopButton")

    window.window.close()
    assert not dialog.root.isVisible()


def test_history_dialog_follows_connection_state(
    connected_window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    window, device = connected_window, connected_window.device
    window.apply(serial_timeout=5)
    window.apply(serial_timeout=7)
    dialog = open_history(window)
    combo = dialog.find(QComboBox, "compareWithCombo")
    assert combo.currentText().startswith("the board")

    quick_simulator.do("line mute on")
    window.wait(lambda: device.link is ConnectionState.NOT_RESPONDING)
    dialog.wait_for_text("restoreNote", "does not respond")
    assert not dialog.is_enabled("restoreButton")
    assert dialog.values() == {"serial_timeout": ("0.7 s", "0.5 s")}
    quick_simulator.do("line mute off")
    dialog.wait(lambda: dialog.is_enabled("restoreButton"))

    quick_simulator.do("line unplug")
    dialog.wait(lambda: not dialog.is_enabled("restoreButton"))
    window.wait(lambda: device.link is not ConnectionState.CONNECTED)
    trex(window.program).controller.leave()
    dialog.wait_for_text("restoreNote", "No board is connected")
    dialog.wait(lambda: combo.currentText().startswith("snapshot of"))
    dialog.wait(lambda: dialog.values() == {"serial_timeout": ("off", "0.5 s")})
    window.connect(quick_simulator.do("line plug").split()[-1])
    dialog.wait(lambda: dialog.is_enabled("restoreButton"))
    dialog.wait(lambda: dialog.values() == {"serial_timeout": ("0.7 s", "0.5 s")})
