"""Headings, edits of both motors, files, and texts of parameters."""

from itertools import pairwise

import pytest
from PySide6.QtCore import QModelIndex, Qt
from PySide6.QtGui import QUndoStack
from pytestqt.modeltest import ModelTester
from pytestqt.qtbot import QtBot

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.model.linter import SettingsLinter
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel, ParameterRole
from trex_gui.devices.trex.model.parameters.text import (
    ParameterColumn,
    frequency_code,
    frequency_codes,
    frequency_wires,
)
from trex_gui.devices.trex.model.settings.draft import SettingsDraft, diff_against_draft
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.settings.comparison import compare
from trex_gui.devices.trex.settings.document import Settings

SPECS = parameters_of("trexjr", "1.2")
FACTORY = {spec.key: spec.default for spec in SPECS.readable}
ACCESSIBLE_TEXT = Qt.ItemDataRole.AccessibleTextRole


@pytest.fixture
def undo(qtbot: QtBot) -> QUndoStack:
    return QUndoStack()


@pytest.fixture
def model(undo: QUndoStack) -> ParameterModel:
    model = ParameterModel(undo=undo)
    model.load(SPECS, FACTORY, {}, power_cycled=True)
    return model


@pytest.fixture
def file(undo: QUndoStack) -> ParameterModel:
    """Parameters of a file with two parameters."""
    model = ParameterModel(undo=undo)
    content = {"serial_timeout": 5, "motor1_current_limit": 10}
    model.load(SPECS, content, {}, power_cycled=True, open_ended=True)
    return model


def text(model: ParameterModel, key: str, role: int = Qt.ItemDataRole.DisplayRole) -> str:
    return str(model.index_of(key).data(role))


def heading(model: ParameterModel, group: str) -> QModelIndex:
    rows = (model.index(row, 0) for row in range(model.rowCount()))
    return next(row for row in rows if row.data(ParameterRole.GROUP) == group)


# --- Headings ---------------------------------------------------------------------------


def test_headings_are_listed_in_order(model: ParameterModel) -> None:
    rows = (model.index(row, 0) for row in range(model.rowCount()))
    titles = [row.data() for row in rows if row.data(ParameterRole.GROUP) is not None]
    assert titles == ["Motors and speed ramp", "Braking", "Current", "PWM", "Inputs", "Serial"]


def test_heading_counts_modified_parameters(model: ParameterModel, qtbot: QtBot) -> None:
    current = heading(model, "current")
    changes: list[QModelIndex] = []
    model.dataChanged.connect(lambda first, _last: changes.append(first))
    model.edit("motor1_current_limit", 9)
    model.edit("motor2_current_limit", 1)
    assert current.data() == "Current (2 modified)"
    assert current in changes
    model.discard_edits()
    assert current.data() == "Current"


def test_heading_has_no_parameter_data_and_is_not_editable(model: ParameterModel) -> None:
    serial = heading(model, "serial")
    for role in ParameterRole:
        if role is not ParameterRole.GROUP:
            assert serial.data(role) is None
    value = serial.siblingAtColumn(ParameterColumn.MOTOR1)
    assert value.data() is None
    assert not serial.flags()
    assert not model.setData(value, 3)


def test_model_passes_qt_model_tester_through_changes(
    model: ParameterModel, file: ParameterModel, qtmodeltester: ModelTester
) -> None:
    other = parameters_of("trex", "1.2")
    empty = ParameterModel()
    for tested in (empty, model, file):
        qtmodeltester.check(tested, force_py=True)  # type: ignore[no-untyped-call] # of pytest-qt
        if tested is empty:
            tested.load(SPECS, FACTORY, {}, power_cycled=True)
        tested.edit("motor_mode", 1)
        tested.both_motors = True
        tested.reset("motor1_current_limit")
        tested.remove("serial_timeout")
        tested.record_stored({"motor_mode": 1})
        values = {spec.key: spec.default for spec in other.readable}
        tested.load(other, values, {}, power_cycled=True)
        tested.discard_edits()


# --- Reset and restore ------------------------------------------------------------------


def test_impossible_changes_are_ignored(model: ParameterModel, undo: QUndoStack) -> None:
    model.remove("serial_timeout")  # only possible in a file
    model.reset("nonsense")
    model.restore("nonsense")
    assert model.values.value_of("serial_timeout") == FACTORY["serial_timeout"]
    assert not undo.canUndo()


def test_reset_to_default_is_an_edit(model: ParameterModel, undo: QUndoStack) -> None:
    model.load(SPECS, FACTORY | {"serial_timeout": 15}, {}, power_cycled=True)
    assert text(model, "serial_timeout", ParameterRole.RESET) == "Reset to default: 0 (off)"
    model.reset("serial_timeout")
    assert dict(model.values.pending) == {"serial_timeout": 0}
    assert model.index_of("serial_timeout").data(ParameterRole.RESET) is None
    undo.undo()
    assert not model.values.pending


def test_restoring_the_stored_value_is_one_undo_step(
    model: ParameterModel, undo: QUndoStack
) -> None:
    model.edit("device_number", 9)
    assert model.text.change("device_number") == "9, was 7"
    model.restore("device_number")
    assert not model.values.pending
    undo.undo()
    assert dict(model.values.pending) == {"device_number": 9}


# --- Both motors ------------------------------------------------------------------------


def test_edit_of_both_motors_is_one_undo_step(model: ParameterModel, undo: QUndoStack) -> None:
    model.both_motors = True
    model.edit("motor2_current_limit", 25)
    assert dict(model.values.pending) == {"motor1_current_limit": 25, "motor2_current_limit": 25}
    assert undo.undoText() == "Motors 1 and 2 Current Limit"
    undo.undo()
    assert not model.values.pending
    undo.redo()
    assert len(model.values.pending) == 2


def test_reset_and_restore_apply_to_both_motors(model: ParameterModel, undo: QUndoStack) -> None:
    stored = FACTORY | {"motor1_current_limit": 10, "motor2_current_limit": 20}
    model.load(SPECS, stored, {}, power_cycled=True)
    model.both_motors = True
    model.reset("motor1_current_limit")
    assert dict(model.values.pending) == {"motor1_current_limit": 0, "motor2_current_limit": 0}
    model.restore("motor2_current_limit")
    assert not model.values.pending
    assert undo.count() == 2


def test_second_motor_is_unchanged_if_it_cannot_be_edited(model: ParameterModel) -> None:
    stored = {key: wire for key, wire in FACTORY.items() if key != "motor2_acceleration"}
    model.load(SPECS, stored, {"motor2_acceleration": "No reply."}, power_cycled=True)
    model.edit("motor1_current_limit", 4)
    model.both_motors = True
    model.edit("motor1_current_limit", 4)  # unchanged
    model.edit("motor1_acceleration", 4)  # motor 2 was not read
    model.edit("aux_acceleration", 4)  # the auxiliary motor has no counterpart
    expected = {"motor1_current_limit": 4, "motor1_acceleration": 4, "aux_acceleration": 4}
    assert dict(model.values.pending) == expected
    with pytest.raises(BadRequest):
        model.edit("motor1_pwm_prescaler", 9)
    assert dict(model.values.pending) == expected


def test_staged_settings_of_each_motor_stay_different(qtbot: QtBot) -> None:
    draft = SettingsDraft()
    before = Settings(SPECS.model, "1.2", FACTORY)
    draft.parameters.load(SPECS, FACTORY, {}, power_cycled=True)
    draft.parameters.both_motors = True
    values = {"motor1_current_limit": 10, "motor2_current_limit": 20}
    after = Settings(SPECS.model, "1.2", FACTORY | values)
    draft.stage(compare(before, after).rows, "Open settings file")
    assert dict(draft.parameters.values.pending) == values
    draft.parameters.discard_edits()
    assert not draft.parameters.values.pending


def test_setting_that_was_not_read_is_left_out_by_name(qtbot: QtBot) -> None:
    draft = SettingsDraft()
    draft.load_settings(Settings(SPECS.model, "1.2", {}))
    draft.parameters.load(SPECS, {}, {"serial_timeout": "No reply."}, power_cycled=True)
    comparison = diff_against_draft(draft, Settings(SPECS.model, "1.2", {"serial_timeout": 5}))
    assert comparison.left_out == (
        "Serial Timeout is left out because it could not be read from the board.",
    )


def test_accepted_finding_changes_both_motors_in_one_step(qtbot: QtBot) -> None:
    draft = SettingsDraft()
    stored = FACTORY | {"motor1_current_limit": 10, "motor1_current_limit_p": 0}
    draft.load_settings(Settings(SPECS.model, "1.2", stored))
    draft.parameters.both_motors = True
    linter = SettingsLinter(draft)
    finding = next(each for each in linter.findings if "motor1_current_limit_p" in each.change)
    draft.parameters.edit("motor2_current_limit_p", 9, alone=True)
    steps = draft.undo.count()
    linter.accept(finding)
    assert draft.parameters.values.value_of("motor1_current_limit_p") == 4
    assert draft.parameters.values.value_of("motor2_current_limit_p") == 4
    assert draft.undo.count() == steps + 1
    draft.undo.undo()
    assert draft.parameters.values.value_of("motor2_current_limit_p") == 9


# --- Files ------------------------------------------------------------------------------


def test_adding_a_parameter_to_a_file_can_be_undone(file: ParameterModel, undo: QUndoStack) -> None:
    assert text(file, "motor_mode") == "not given"
    assert file.index_of("motor_mode").data(ParameterRole.RESET) is None
    file.edit("motor_mode", 0)
    assert dict(file.values.pending) == {"motor_mode": 0}
    assert file.values.all_shown["motor_mode"] == 0
    undo.undo()
    assert text(file, "motor_mode") == "not given"
    assert not file.values.modified
    assert "motor_mode" not in file.values.all_shown


def test_removing_a_parameter_from_a_file_can_be_undone(
    file: ParameterModel, undo: QUndoStack, qtbot: QtBot
) -> None:
    with qtbot.waitSignal(file.pending_changed):
        file.remove("serial_timeout")
    assert list(file.values.modified) == ["serial_timeout"]
    assert "serial_timeout" not in file.values.all_shown
    assert file.values.all_stored["serial_timeout"] == 5
    assert file.index_of("serial_timeout").data(ParameterRole.DIRTY) is True
    undo.undo()
    assert not file.values.modified
    undo.redo()
    assert list(file.values.modified) == ["serial_timeout"]
    file.discard_edits()
    assert not file.values.modified


def test_removing_applies_to_both_motors(file: ParameterModel, undo: QUndoStack) -> None:
    file.both_motors = True
    file.edit("motor1_current_limit", 12)
    assert file.values.value_of("motor2_current_limit") == 12
    file.remove("motor2_current_limit")
    assert file.values.value_of("motor1_current_limit") is None
    undo.undo()
    assert file.values.value_of("motor1_current_limit") == 12


def test_removed_parameter_counts_as_pending(qtbot: QtBot) -> None:
    draft = SettingsDraft()
    draft.load_settings(Settings(SPECS.model, "1.2", {"serial_timeout": 5}))
    assert draft.can_edit("motor_mode")
    draft.parameters.remove("serial_timeout")
    draft.parameters.edit("motor_mode", 1)
    assert draft.pending == 2
    assert draft.shown is not None
    assert draft.shown.parameters == {"motor_mode": 1}
    draft.discard_edits()
    assert draft.pending == 0


# --- Texts ------------------------------------------------------------------------------


def test_side_panel_explains_wire_value_default_and_source(model: ParameterModel) -> None:
    about = model.text.about
    for key, words in (
        ("device_number", "Range: 0 to 127 (inferred). Default: 7. "),
        ("device_number", "(inferred): not confirmed by any document."),
        ("serial_timeout", "(twin): documented for Pololu's qik 2s12v10"),
        ("uart_error_shutdown", "The default of on is doubtful: public programs"),
        ("uart_settings", "Wire value: 5 (19200 baud, "),
        ("motor1_acceleration", "0.1 to 12.7 s to full speed, or no ramp (wire value 0 to 127)"),
    ):
        assert words in " ".join(about(key)), key
    for key, is_delayed in (("motor_mode", True), ("serial_timeout", False)):
        delayed = "when the board is switched off and on" in model.text.description(key)
        assert delayed is is_delayed
    for key, limits, summary in (
        ("device_number", "0 to 127 · default: 7", "wire 7 · 0x00 · inferred"),
        ("motor1_current_limit", "off to 10.16 A · default: off", "wire 0 · 0x13 · twin"),
    ):
        assert (model.text.limits(key), model.text.summary(key)) == (limits, summary)


def test_side_panel_shows_the_grade_of_each_range_and_default(model: ParameterModel) -> None:
    for key in FACTORY:
        specs = [model.values.specs[member] for member in model.text.keys_of(key)]
        for word, fields in ("Range: ", ("min", "max")), ("Default: ", ("default",)):
            (sentence,) = (text for text in model.text.about(key) if text.startswith(word))
            assert sentence.endswith(f"{max(spec.grade(*fields) for spec in specs).mark}."), key
            assert sentence.count("inferred") + sentence.count("twin") <= 1


# --- PWM frequency ----------------------------------------------------------------------


def test_prescaler_and_maximum_are_edited_as_one_frequency(
    model: ParameterModel, undo: QUndoStack, qtbot: QtBot
) -> None:
    cell = model.index_of("motor1_pwm_prescaler")
    assert cell == model.index_of("motor1_pwm_maximum")
    assert cell.siblingAtColumn(ParameterColumn.NAME).data() == "PWM Frequency"
    assert cell.data() == "2441 Hz"
    assert model.setData(cell, frequency_code(0, 127))
    assert dict(model.values.pending) == {"motor1_pwm_prescaler": 0, "motor1_pwm_maximum": 127}
    assert (cell.data(), undo.count(), undo.undoText()) == ("9766 Hz", 1, "Motor 1 PWM Frequency")
    assert model.text.change("motor1_pwm_maximum") == "9766 Hz, was 2441 Hz"
    with qtbot.waitSignal(model.rejected):
        assert not model.setData(cell, frequency_code(9, 63))
    assert model.setData(model.index_of("motor2_pwm_maximum"), frequency_code(0, 127))
    assert text(model, "motor2_pwm_maximum") == "9766 Hz"
    model.both_motors = True
    model.reset("motor2_pwm_prescaler")
    assert not model.values.pending
    assert undo.undoText() == "Motors 1 and 2 PWM Frequency"
    undo.undo()
    assert len(model.values.pending) == 4
    model.restore("motor1_pwm_maximum")
    assert dict(model.values.pending) == {}

    rows: list[int] = []
    model.dataChanged.connect(lambda first, _last: rows.append(first.row()))
    model.edit("motor1_pwm_prescaler", 0, alone=True)  # like an edit by a file or a finding
    assert cell.data() == "19531 Hz"
    assert cell.row() in rows
    assert cell.data(ParameterRole.DIRTY) is True


def test_frequency_outside_the_choices_is_shown_unchanged(model: ParameterModel) -> None:
    for prescaler, maximum, shown in (
        (9, 63, "prescaler 9, maximum 63"),
        (0, 0, "1250000 Hz"),
        (3, 3, "2441 Hz"),
    ):
        values = {"motor1_pwm_prescaler": prescaler, "motor1_pwm_maximum": maximum}
        model.load(SPECS, FACTORY | values, {}, power_cycled=True)
        cell = model.index_of("motor1_pwm_maximum")
        assert cell.data() == shown
        assert frequency_wires(cell.data(Qt.ItemDataRole.EditRole)) == (prescaler, maximum)
    unread = {key: wire for key, wire in FACTORY.items() if key != "motor1_pwm_prescaler"}
    model.load(SPECS, unread, {"motor1_pwm_prescaler": "No reply."}, power_cycled=True)
    cell = model.index_of("motor1_pwm_maximum")
    assert (cell.data(), cell.data(ParameterRole.PROBLEM)) == ("not read", "No reply.")
    assert not cell.flags() & Qt.ItemFlag.ItemIsEditable


def test_choices_are_frequencies_that_suit_the_driver() -> None:
    junior, large = (
        [device_table().pwm.frequency(*frequency_wires(code)) for code in frequency_codes(model)]
        for model in device_table().models[::-1]
    )
    for hertz, highest in ((junior, 10_000), (large, 20_000)):
        assert hertz == sorted(set(hertz))
        assert max(hertz) <= highest
        assert max(after / before for before, after in pairwise(hertz)) < 1.07
