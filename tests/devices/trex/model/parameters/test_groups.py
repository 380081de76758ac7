"""Headings, both motors as one, what a file leaves out, and what rows say in words."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QModelIndex, Qt
from PySide6.QtGui import QUndoStack
from pytestqt.modeltest import ModelTester
from pytestqt.qtbot import QtBot

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.model.linter import SettingsLinter
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel, Role
from trex_gui.devices.trex.model.parameters.text import ParameterColumn
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.parameters import motor_name, other_motor_key, parameters_of
from trex_gui.devices.trex.settings.comparison import compare
from trex_gui.devices.trex.settings.document import Settings

SPECS = parameters_of("trexjr", "1.2")
FACTORY = {spec.key: spec.default for spec in SPECS.readable}
TIP = Qt.ItemDataRole.ToolTipRole


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
    """The parameters of a file that gives two of them."""
    model = ParameterModel(undo=undo)
    given = {"serial_timeout": 5, "motor1_current_limit": 10}
    model.load(SPECS, given, {}, power_cycled=True, open_ended=True)
    return model


def said(model: ParameterModel, key: str, column: ParameterColumn, role: int = 0) -> str:
    return str(model.index_of(key, column).data(role))


# --- Headings ---------------------------------------------------------------------------


def test_groups_are_listed_in_order_with_counts(model: ParameterModel) -> None:
    texts = [model.index(row, 0).data() for row in range(model.rowCount())]
    assert texts == ["Motors (17)", "Channels (5)", "Serial (6)"]
    assert list(model.groups) == ["motors", "channels", "serial"]


def test_heading_counts_modified_parameters(model: ParameterModel, qtbot: QtBot) -> None:
    heading = model.index_of_group("motors")
    reports: list[QModelIndex] = []
    model.dataChanged.connect(lambda first, _last: reports.append(first))
    model.edit("motor1_current_limit", 9)
    model.edit("motor_mode", 1)
    assert heading.data() == "Motors (17, 2 modified)"
    assert heading in reports
    model.discard_edits()
    assert heading.data() == "Motors (17)"


def test_heading_has_no_parameter_data_and_is_read_only(model: ParameterModel) -> None:
    heading = model.index_of_group("serial")
    assert heading.data(Role.GROUP) == "serial"
    for role in Role:
        if role is not Role.GROUP:
            assert heading.data(role) is None
    assert heading.siblingAtColumn(ParameterColumn.VALUE).data() is None
    assert not heading.flags() & Qt.ItemFlag.ItemIsEditable
    assert not model.setData(heading.siblingAtColumn(ParameterColumn.VALUE), 3)
    assert not model.index_of_group("nonsense").isValid()


def test_rows_have_their_group_as_parent(model: ParameterModel) -> None:
    for spec in SPECS.readable:
        assert model.index_of(spec.key).parent() == model.index_of_group(spec.group)


def test_grouped_model_passes_qt_model_tester(
    model: ParameterModel, file: ParameterModel, qtmodeltester: ModelTester
) -> None:
    for each in (model, file):
        qtmodeltester.check(each, force_py=True)  # type: ignore[no-untyped-call] # of pytest-qt
        each.edit("motor_mode", 1)
        each.both_motors = True
        each.reset("motor1_current_limit")
        each.leave_out("serial_timeout")
        each.load(SPECS, FACTORY, {}, power_cycled=True)


# --- Back to the default, to what is stored ---------------------------------------------


def test_reset_to_default_is_an_edit(model: ParameterModel, undo: QUndoStack) -> None:
    model.load(SPECS, FACTORY | {"serial_timeout": 15}, {}, power_cycled=True)
    assert (
        said(model, "serial_timeout", ParameterColumn.RESET, Role.RESET)
        == "Reset to default: 0 (off)"
    )
    model.reset("serial_timeout")
    assert dict(model.pending) == {"serial_timeout": 0}
    assert model.index_of("serial_timeout").data(Role.RESET) is None
    undo.undo()
    assert not model.pending


def test_restoring_the_stored_value_is_one_undo_step(
    model: ParameterModel, undo: QUndoStack
) -> None:
    model.edit("device_number", 9)
    assert "Stored: 7." in said(model, "device_number", ParameterColumn.VALUE, TIP)
    model.restore("device_number")
    assert not model.pending
    undo.undo()
    assert dict(model.pending) == {"device_number": 9}


# --- Both motors ------------------------------------------------------------------------


def test_each_motor_parameter_has_a_counterpart(model: ParameterModel) -> None:
    for spec in SPECS.readable:
        other_motor = model.other_motor_of(spec.key)
        assert (other_motor is not None) == (spec.subject in {"motor1", "motor2"})
        if other_motor is not None:
            assert model.other_motor_of(other_motor) == spec.key
    assert other_motor_key("aux_acceleration") is None
    assert motor_name("motor2_acceleration") == "Motor 2"
    assert motor_name("serial_timeout") == ""


def test_edit_of_both_motors_is_one_undo_step(model: ParameterModel, undo: QUndoStack) -> None:
    model.both_motors = True
    model.edit("motor2_current_limit", 25)
    assert dict(model.pending) == {"motor1_current_limit": 25, "motor2_current_limit": 25}
    assert undo.undoText() == "Motors 1 and 2 Current Limit"
    undo.undo()
    assert not model.pending
    undo.redo()
    assert len(model.pending) == 2


def test_reset_and_restore_apply_to_both_motors(model: ParameterModel, undo: QUndoStack) -> None:
    stored = FACTORY | {"motor1_current_limit": 10, "motor2_current_limit": 20}
    model.load(SPECS, stored, {}, power_cycled=True)
    model.both_motors = True
    model.reset("motor1_current_limit")
    assert dict(model.pending) == {"motor1_current_limit": 0, "motor2_current_limit": 0}
    model.restore("motor2_current_limit")
    assert not model.pending
    assert undo.count() == 2


def test_parameter_without_counterpart_is_edited_alone(model: ParameterModel) -> None:
    model.both_motors = True
    model.edit("aux_acceleration", 4)
    model.edit("serial_timeout", 4)
    assert dict(model.pending) == {"aux_acceleration": 4, "serial_timeout": 4}


def test_unread_counterpart_is_not_edited(model: ParameterModel) -> None:
    stored = {key: wire for key, wire in FACTORY.items() if key != "motor2_acceleration"}
    model.load(SPECS, stored, {"motor2_acceleration": "No answer."}, power_cycled=True)
    model.both_motors = True
    model.edit("motor1_acceleration", 4)
    assert dict(model.pending) == {"motor1_acceleration": 4}


def test_unchanged_value_does_not_change_the_other_motor(model: ParameterModel) -> None:
    model.edit("motor1_acceleration", 4)
    model.both_motors = True
    model.edit("motor1_acceleration", 4)
    assert dict(model.pending) == {"motor1_acceleration": 4}


def test_invalid_value_changes_neither_motor(model: ParameterModel) -> None:
    model.both_motors = True
    with pytest.raises(BadRequest):
        model.edit("motor1_pwm_prescaler", 9)
    assert not model.pending


def test_differing_motor_value_is_shown_and_can_be_copied(model: ParameterModel) -> None:
    assert "differs" not in said(model, "motor1_current_limit", ParameterColumn.VALUE, TIP)
    model.edit("motor2_current_limit", 25)
    assert "Motor 2 differs: 2 A." in said(
        model, "motor1_current_limit", ParameterColumn.VALUE, TIP
    )
    model.copy_to_other_motor("motor2_current_limit")
    assert model.value_of("motor1_current_limit") == 25


def test_staged_settings_keep_motors_separate_in_both_mode(qtbot: QtBot) -> None:
    draft = SettingsDraft()
    before = Settings(SPECS.model, "1.2", FACTORY)
    draft.parameters.load(SPECS, FACTORY, {}, power_cycled=True)
    draft.parameters.both_motors = True
    values = {"motor1_current_limit": 10, "motor2_current_limit": 20}
    after = Settings(SPECS.model, "1.2", FACTORY | values)
    draft.stage(compare(before, after).rows, "Open settings file")
    assert dict(draft.parameters.pending) == values
    draft.parameters.discard_edits()
    assert not draft.parameters.pending


def test_accepted_finding_changes_both_motors_in_one_step(qtbot: QtBot) -> None:
    draft = SettingsDraft()
    stored = FACTORY | {"motor1_current_limit": 10, "motor1_current_limit_p": 0}
    draft.take_settings(Settings(SPECS.model, "1.2", stored))
    draft.parameters.both_motors = True
    linter = SettingsLinter(draft)
    hint = next(a for a in linter.findings if "motor1_current_limit_p" in a.change)
    draft.parameters.edit("motor2_current_limit_p", 9, alone=True)
    steps = draft.undo.count()
    linter.accept(hint)
    assert draft.parameters.value_of("motor1_current_limit_p") == 5
    assert draft.parameters.value_of("motor2_current_limit_p") == 5
    assert draft.undo.count() == steps + 1
    draft.undo.undo()
    assert draft.parameters.value_of("motor2_current_limit_p") == 9


# --- A file -----------------------------------------------------------------------------


def test_adding_a_parameter_to_a_file_can_be_undone(file: ParameterModel, undo: QUndoStack) -> None:
    assert said(file, "motor_mode", ParameterColumn.VALUE) == "not given"
    assert said(file, "motor_mode", ParameterColumn.WIRE) == ""
    assert file.index_of("motor_mode").data(Role.RESET) is None
    file.edit("motor_mode", 0)
    assert dict(file.pending) == {"motor_mode": 0}
    assert file.all_shown["motor_mode"] == 0
    undo.undo()
    assert said(file, "motor_mode", ParameterColumn.VALUE) == "not given"
    assert not file.modified
    assert "motor_mode" not in file.all_shown


def test_leaving_out_a_parameter_of_a_file_can_be_undone(
    file: ParameterModel, undo: QUndoStack, qtbot: QtBot
) -> None:
    with qtbot.waitSignal(file.pending_changed) as changed:
        file.leave_out("serial_timeout")
    assert changed.args == [1]
    assert list(file.modified) == ["serial_timeout"]
    assert list(file.modified) == ["serial_timeout"]
    assert file.is_modified("serial_timeout")
    assert not file.pending
    assert "serial_timeout" not in file.all_shown
    assert file.all_stored["serial_timeout"] == 5
    assert file.index_of("serial_timeout").data(Role.DIRTY) is True
    undo.undo()
    assert not file.modified
    undo.redo()
    assert list(file.modified) == ["serial_timeout"]
    file.discard_edits()
    assert not file.modified


def test_leaving_out_applies_to_both_motors(file: ParameterModel, undo: QUndoStack) -> None:
    file.both_motors = True
    file.edit("motor1_current_limit", 12)
    assert file.value_of("motor2_current_limit") == 12
    file.leave_out("motor2_current_limit")
    assert file.value_of("motor1_current_limit") is None
    undo.undo()
    assert file.value_of("motor1_current_limit") == 12


def test_leave_out_reset_and_restore_ignore_invalid_keys(
    model: ParameterModel, undo: QUndoStack
) -> None:
    model.leave_out("serial_timeout")
    model.reset("nonsense")
    model.restore("nonsense")
    assert model.value_of("serial_timeout") == FACTORY["serial_timeout"]
    assert not undo.canUndo()


def test_left_out_parameter_counts_as_pending(qtbot: QtBot) -> None:
    draft = SettingsDraft()
    draft.take_settings(Settings(SPECS.model, "1.2", {"serial_timeout": 5}))
    assert draft.can_edit("motor_mode")
    draft.parameters.leave_out("serial_timeout")
    draft.parameters.edit("motor_mode", 1)
    assert draft.pending == 2
    assert draft.shown is not None
    assert draft.shown.parameters == {"motor_mode": 1}
    draft.discard_edits()
    assert draft.pending == 0


# --- In words ---------------------------------------------------------------------------


def test_values_are_shown_in_physical_units(model: ParameterModel) -> None:
    for key, wire, text in (
        ("motor1_current_limit", 25, "2 A"),
        ("motor1_acceleration", 4, "3.2 s to full speed"),
        ("motor1_acceleration", 127, "0.1 s to full speed"),
        ("motor1_acceleration", 0, "no ramp"),
        ("motor1_pwm_maximum", 63, "127 (2441 Hz)"),
        ("motor1_pwm_prescaler", 1, "clock / 64 (2441 Hz)"),
        ("motor1_brake_duration", 12, "120 ms"),
        ("motor1_deadband_brake_pwm", 127, "100 %"),
        ("serial_timeout", 15, "1.5 s"),
        ("uart_settings", 5, "19200 baud, no error detection, 1 stop bit"),
        ("crc7_polynomial", 9, "0x89"),
        ("required_channels", 5, "channels 1, 3"),
    ):
        model.edit(key, wire)
        assert said(model, key, ParameterColumn.VALUE) == text
        assert said(model, key, ParameterColumn.WIRE) == str(wire)


def test_prescaler_edit_updates_the_pwm_maximum_row(model: ParameterModel) -> None:
    reports: list[str] = []
    model.dataChanged.connect(
        lambda first, _last: reports.append(first.siblingAtColumn(ParameterColumn.NAME).data())
    )
    model.edit("motor1_pwm_prescaler", 0)
    assert "Motor 1 PWM Maximum" in reports


def test_unknown_prescaler_shows_no_frequency(model: ParameterModel) -> None:
    model.load(SPECS, FACTORY | {"motor1_pwm_prescaler": 9}, {}, power_cycled=True)
    assert said(model, "motor1_pwm_maximum", ParameterColumn.VALUE) == "127"
    assert said(model, "motor1_pwm_prescaler", ParameterColumn.VALUE) == "wire 9"


def test_source_column_names_what_is_inferred(model: ParameterModel) -> None:
    for key, text, reports in (
        ("device_number", "range inferred", "default is confirmed"),
        ("serial_timeout", "default inferred", "range is confirmed"),
        ("motor1_current_limit", "inferred", "The board rejects any value"),
        ("uart_settings", "inferred", "The meaning of the wire values is inferred"),
    ):
        assert said(model, key, ParameterColumn.SOURCE) == text
        assert reports in said(model, key, ParameterColumn.SOURCE, TIP)


def test_fully_confirmed_parameter_has_vendor_as_source(model: ParameterModel) -> None:
    spec = replace(SPECS["serial_timeout"], inferred=frozenset())
    assert model.text.source(spec) == "vendor"
    assert "confirm" in model.text.origin(spec)
    assert "last word" not in model.text.origin(spec)


def test_tool_tips_give_details_of_each_column(model: ParameterModel) -> None:
    assert "wire value 0 to 127" in said(model, "motor1_acceleration", ParameterColumn.RANGE, TIP)
    assert "0.1 to 12.7 s" in said(model, "motor1_acceleration", ParameterColumn.RANGE, TIP)
    assert "5 (19200 baud" in said(model, "uart_settings", ParameterColumn.DEFAULT, TIP)
    assert "off and on" in said(model, "motor_mode", ParameterColumn.EFFECT, TIP)
    assert "as soon as" in said(model, "serial_timeout", ParameterColumn.EFFECT, TIP)
    assert "Motor 1 Current Limit" in said(model, "motor1_current_limit", ParameterColumn.NAME, TIP)
    assert model.index_of("serial_timeout", ParameterColumn.RESET).data(TIP) is None
    model.edit("serial_timeout", 15)
    assert said(model, "serial_timeout", ParameterColumn.RESET, TIP) == "Reset to default: 0 (off)"
    spoken = Qt.ItemDataRole.AccessibleTextRole
    assert (
        said(model, "serial_timeout", ParameterColumn.RESET, spoken) == "Reset to default: 0 (off)"
    )
