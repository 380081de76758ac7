"""History of a board's settings, and notes about settings."""

from datetime import timedelta
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QTabBar

from tests.support.pages.settings import HistoryDialog, ReviewDialog
from tests.support.program import trex
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.snapshots import create_snapshot
from tests.support.window import WidgetDriver, WindowDriver
from trex_gui.core.files import data_folder, load
from trex_gui.devices.trex.settings.history import SettingsHistory
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.views.changes.dialog import ChangesDialog
from trex_gui.devices.trex.views.comparison_view import ComparisonView
from trex_gui.devices.trex.views.note_field import NoteField
from trex_gui.devices.trex.views.pages.parameters.page import ParametersPage
from trex_gui.devices.trex.views.settings_editor.pdf import settings_html
from trex_gui.ui.devices.connection import ConnectionState


def open_history(window: WindowDriver) -> HistoryDialog:
    window.trigger("history")  # creates the dialog
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
    dialog.wait_for_text("comparisonSummary", "No setting differs")
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
    dialog.tick_all(True)
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


def test_snapshot_of_another_board_shows_a_warning(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    history = window.device.writer.history
    create_snapshot(history, timedelta(hours=1), device_number=9)
    create_snapshot(history, model="trexjr")
    dialog = open_history(window)
    assert "No board is connected" in dialog.text("restoreNote")

    window.connect(quick_simulator.url)
    dialog.wait_for_text("restoreNote", "from a TReX Jr, but the connected board is a TReX")
    assert not dialog.is_enabled("restoreButton")
    dialog.select_snapshot(1)
    dialog.wait_for_text("restoreNote", "device number 9, and the connected board has number 7")
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
    trex(window.program).controller.disconnect_device()
    dialog.wait_for_text("restoreNote", "No board is connected")
    dialog.wait(lambda: dialog.values() == {"serial_timeout": ("off", "0.5 s")})
    window.connect(quick_simulator.do("line plug").split()[-1])
    dialog.wait(lambda: dialog.is_enabled("restoreButton"))
    dialog.wait(lambda: dialog.values() == {"serial_timeout": ("0.7 s", "0.5 s")})


NOTE = "The radio drops out\nbehind the barn."
KEY = "serial_timeout"


def wait_for_records(window: WindowDriver) -> None:
    window.wait(lambda: window.device.board.memory.record is not None)
    window.wait(lambda: window.device.records.files.is_idle)


def test_note_is_saved_wherever_its_value_is_saved(
    window: WindowDriver,
    quick_simulator: SimulatedDevice,
    start_simulator: StartSimulator,
    tmp_path: Path,
) -> None:
    other, draft = start_simulator("--device", "9"), window.device.draft
    window.connect(quick_simulator.url)
    wait_for_records(window)
    window.open_page("parametersPage")
    window.find(ParametersPage, "parametersPage").table.show_parameter(KEY)
    field = window.find(NoteField, "noteEdit")
    field.setFocus()
    QTest.keyClicks(field, "The radio drops out\r behind the barn. ")
    assert draft.notes.of(KEY) == NOTE
    window.trigger("undo")
    assert not field.toPlainText(), "continuous typing is one step"
    window.trigger("redo")
    assert field.toPlainText() == NOTE
    assert draft.pending == 0, "a note needs no Apply"

    window.device.parameters.edit(KEY, 15)
    window.trigger("apply")
    review = window.dialog("reviewDialog").find_only(ComparisonView).table
    assert "Note: The radio drops out / behind the barn." in review.index(0, 0).data()
    with window.qtbot.waitSignal(window.device.applied):
        window.dialog("reviewDialog").click("writeButton")
    (snapshot,) = SettingsHistory().snapshots()
    assert SettingsHistory().load(snapshot).notes == {KEY: NOTE}
    window.dialog("reviewDialog").root.close()

    path = tmp_path / "board.txt"
    files = trex(window.program).workspace.files
    files.saver.save_file(path)
    window.wait(path.exists)
    assert read_settings(load(path))[0].notes == {KEY: NOTE}
    shown = draft.shown
    assert shown is not None
    assert "Note: The radio drops out<br>behind the barn." in settings_html(shown, "x")

    number_12 = data_folder() / "boards" / "trex-1.2-12.txt"
    number_12.write_text("of another board", encoding="utf-8")
    window.device.parameters.edit("device_number", 12)
    with window.qtbot.waitSignal(window.device.records.files.replaced):
        window.device.writer.apply()
    (replaced,) = number_12.parent.glob("*.replaced-1.txt")
    assert replaced.read_text(encoding="utf-8") == "of another board"
    window.disconnect()
    window.connect(other.url)
    wait_for_records(window)
    assert not field.toPlainText(), "another board has no note"
    draft.undo.undo()
    assert not draft.notes.all
    files.open_file(path)
    window.wait(lambda: window.has("takeChangesButton"))
    dialog = window.find(ChangesDialog, "loadSettingsDialog")
    assert KEY in {row.key for row in dialog.ticked}
    window.click("takeChangesButton")
    assert draft.notes.all == {KEY: NOTE}
    window.disconnect()
    window.connect(quick_simulator.url)
    wait_for_records(window)
    assert field.toPlainText() == NOTE, "saved under the new number"


def test_calibrations_have_notes_on_page_and_in_editor(
    window: WindowDriver, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    window.connect(quick_simulator.url)
    wait_for_records(window)
    page = window.open_page("channelsPage")
    page.click("channel2Strip")
    field = page.find(NoteField, "channelNoteEdit")
    field.setFocus()
    QTest.keyClicks(field, "Learned with the new stick.")
    notes = window.device.draft.notes
    assert notes.all == {"rc_channel_2": "Learned with the new stick."}
    page.find(QTabBar, "sourceTabs").setCurrentIndex(1)
    assert not field.toPlainText(), "each input source has its own note"
    page.find(QTabBar, "sourceTabs").setCurrentIndex(0)
    assert field.toPlainText() == notes.of("rc_channel_2")

    path = tmp_path / "board.txt"
    path.write_text(
        "product: TReX\n# Note on rc_channel_2: by hand\n"
        "rc_channel_2: {minimum: 2500, neutral: 3750, maximum: 5000, deadband: 75}\n",
        encoding="utf-8",
    )
    files = trex(window.program).workspace.files
    files.edit_file(path)
    window.wait(lambda: files.editors)
    editor = WidgetDriver(files.editors[0], window.qtbot)
    editor.button("channel2Strip").setChecked(True)
    field = editor.find(NoteField, "channelNoteEdit")
    assert field.toPlainText() == "by hand"
    field.setPlainText("by hand, twice")
    assert "# Note on rc_channel_2: by hand, twice\n" in files.editors[0].document.text
    files.editors[0].document.draft.undo.undo()
    assert field.toPlainText() == "by hand"
