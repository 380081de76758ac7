"""A person opens and saves settings files; the board is simulated, in a process of its own."""

from pathlib import Path

import pytest
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatorProcess
from trex_gui.export.language import Language
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.protocol.calibration import Calibration
from trex_gui.window import Program


@pytest.fixture
def connected(program: Program, qtbot: QtBot, simulator: SimulatorProcess) -> Program:
    program.device.connect_to(LinkSettings(simulator.url))
    qtbot.waitUntil(lambda: program.device.link is Link.UP)
    return program


def banner(program: Program) -> str:
    label = program.window.findChild(QLabel, "bannerText")
    assert label is not None
    return label.text()


def test_what_was_saved_opens_as_no_change(connected: Program, tmp_path: Path) -> None:
    path = tmp_path / "board.txt"
    connected.window.files.save_file(path)
    assert path.read_text(encoding="utf-8").startswith("product: TReX\n")
    connected.window.files.open_file(path)
    assert "28 parameters: 0 will change, 28 match" in banner(connected)
    assert "5 calibrations: 0 will change, 5 match" in banner(connected)
    assert connected.device.pending == 0


def test_a_file_becomes_edits_and_apply_writes_them(
    connected: Program, qtbot: QtBot, simulator: SimulatorProcess, tmp_path: Path
) -> None:
    path = tmp_path / "rover.txt"
    path.write_text(
        "product: TReX\n"
        "serial_timeout: 5\n"
        "motor1_acceleration: 0\n"
        "rc_channel_2: {minimum: 2600, neutral: 3700, maximum: 4900, deadband: 60}\n",
        encoding="utf-8",
    )
    connected.window.files.open_file(path)
    assert "parameters: 1 will change, 1 match" in banner(connected)
    assert "calibrations: 1 will change, 0 match" in banner(connected)
    assert simulator.show()["parameters"]["serial_timeout"] == 0
    connected.device.apply()
    qtbot.waitUntil(lambda: connected.device.pending == 0)
    assert simulator.show()["parameters"]["serial_timeout"] == 5
    stored = connected.device.calibrations.stored(2)
    assert stored is not None
    assert (stored.minimum, stored.deadband) == (2600, 60)


def test_a_file_with_mistakes_changes_nothing_and_names_the_lines(
    connected: Program, tmp_path: Path
) -> None:
    path = tmp_path / "wrong.txt"
    path.write_text("product: TReX\nserial_timeot: 5\nmotor_mode: 9\n", encoding="utf-8")
    connected.window.files.open_file(path)
    assert "line 2" in banner(connected)
    assert "serial_timeout" in banner(connected)
    assert "line 3" in banner(connected)
    assert connected.device.pending == 0


def test_a_file_for_another_model_changes_nothing(connected: Program, tmp_path: Path) -> None:
    path = tmp_path / "junior.txt"
    path.write_text("product: TReX Jr\nserial_timeout: 5\n", encoding="utf-8")
    connected.window.files.open_file(path)
    assert "settings of a TReX Jr" in banner(connected)
    assert connected.device.pending == 0


def test_analog_calibrations_are_left_out_and_named_while_inputs_are_rc(
    connected: Program, tmp_path: Path
) -> None:
    path = tmp_path / "analog.txt"
    path.write_text(
        "product: TReX\n"
        "analog_channel_1: {minimum: 10, neutral: 500, maximum: 1000, deadband: 9}\n",
        encoding="utf-8",
    )
    connected.window.files.open_file(path)
    assert "analog calibrations are left out" in banner(connected)


def test_a_missing_file_is_a_sentence(connected: Program, tmp_path: Path) -> None:
    connected.window.files.open_file(tmp_path / "nowhere.txt")
    assert "was not opened" in banner(connected)


def action(program: Program, name: str) -> QAction:
    found = program.window.findChild(QAction, f"{name}Action")
    assert found is not None
    return found


def test_edits_are_undone_and_redone_from_the_menu_whatever_page_made_them(
    connected: Program, tmp_path: Path
) -> None:
    undo, redo = action(connected, "undo"), action(connected, "redo")
    assert not undo.isEnabled()
    connected.device.parameters.edit("serial_timeout", 5)
    connected.device.calibrations.edit(2, Calibration(2600, 3700, 4900, 60))
    assert undo.text().endswith("Calibration of channel 2")
    undo.trigger()
    assert undo.text().endswith("Serial Timeout")
    undo.trigger()
    assert connected.device.pending == 0
    assert not undo.isEnabled()
    redo.trigger()
    redo.trigger()
    assert connected.device.pending == 2


def test_a_file_that_was_opened_is_one_step_to_undo(connected: Program, tmp_path: Path) -> None:
    path = tmp_path / "rover.txt"
    path.write_text("product: TReX\nserial_timeout: 5\nmotor_mode: 1\n", encoding="utf-8")
    connected.window.files.open_file(path)
    assert connected.device.pending == 2
    action(connected, "undo").trigger()
    assert connected.device.pending == 0


def test_what_was_stored_before_an_apply_comes_back_from_its_snapshot(
    connected: Program, qtbot: QtBot, simulator: SimulatorProcess
) -> None:
    connected.device.parameters.edit("serial_timeout", 5)
    connected.device.apply()
    qtbot.waitUntil(lambda: connected.device.pending == 0)
    (snapshot,) = connected.device.history.snapshots()
    connected.window.files.open_file(snapshot.path, remember=False)
    assert connected.device.parameters.pending == (("serial_timeout", 0),)
    connected.device.apply()
    qtbot.waitUntil(lambda: connected.device.pending == 0)
    assert simulator.show()["parameters"]["serial_timeout"] == 0
    assert len(connected.device.history.snapshots()) == 2


@pytest.mark.parametrize("language", list(Language))
def test_the_settings_shown_are_exported_as_code(
    connected: Program, tmp_path: Path, language: Language
) -> None:
    connected.device.parameters.edit("serial_timeout", 5)
    path = tmp_path / f"board{language.suffix}"
    connected.window.files.export_file(path, language)
    text = path.read_text(encoding="utf-8")
    assert "Serial Timeout" in text
    assert "0.5 s" in text
    assert "applies and checks" in banner(connected)


def test_a_place_that_cannot_be_written_is_told(connected: Program, tmp_path: Path) -> None:
    connected.window.files.export_file(tmp_path / "missing" / "board.py", Language.PYTHON)
    assert "was not written" in banner(connected)
