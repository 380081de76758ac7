"""Headings, both motors as one, what a file leaves out, and what rows say in words."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QModelIndex, Qt
from PySide6.QtGui import QUndoStack
from pytestqt.modeltest import ModelTester
from pytestqt.qtbot import QtBot

from trex_gui.model.adviser import Adviser
from trex_gui.model.parameters import Column, ParameterModel, Role
from trex_gui.model.settings_draft import SettingsDraft
from trex_gui.model.twins import motor_name, twin_key
from trex_gui.protocol.errors import BadRequest
from trex_gui.protocol.parameters import parameters_of
from trex_gui.settings.comparison import compare
from trex_gui.settings.document import Settings

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


def said(model: ParameterModel, key: str, column: Column, role: int = 0) -> str:
    return str(model.index_of(key, column).data(role))


# --- Headings ---------------------------------------------------------------------------


def test_groups_stand_in_their_order_with_their_counts(model: ParameterModel) -> None:
    texts = [model.index(row, 0).data() for row in range(model.rowCount())]
    assert texts == ["Motors (17)", "Channels (5)", "Serial (6)"]
    assert model.groups == ("motors", "channels", "serial")


def test_a_heading_counts_what_is_modified(model: ParameterModel, qtbot: QtBot) -> None:
    heading = model.index_of_group("motors")
    told: list[QModelIndex] = []
    model.dataChanged.connect(lambda first, _last: told.append(first))
    model.edit("motor1_current_limit", 9)
    model.edit("motor_mode", 1)
    assert heading.data() == "Motors (17, 2 modified)"
    assert heading in told
    model.discard_edits()
    assert heading.data() == "Motors (17)"


def test_a_heading_is_no_parameter(model: ParameterModel) -> None:
    heading = model.index_of_group("serial")
    assert heading.data(Role.GROUP) == "serial"
    for role in Role:
        if role is not Role.GROUP:
            assert heading.data(role) is None
    assert heading.siblingAtColumn(Column.VALUE).data() is None
    assert not heading.flags() & Qt.ItemFlag.ItemIsEditable
    assert not model.setData(heading.siblingAtColumn(Column.VALUE), 3)
    assert not model.index_of_group("nonsense").isValid()


def test_rows_know_their_heading(model: ParameterModel) -> None:
    for spec in SPECS.readable:
        assert model.index_of(spec.key).parent() == model.index_of_group(spec.group)


def test_qt_finds_nothing_wrong_with_groups(
    model: ParameterModel, file: ParameterModel, qtmodeltester: ModelTester
) -> None:
    for each in (model, file):
        qtmodeltester.check(each, force_py=True)  # type: ignore[no-untyped-call] # of pytest-qt
        each.edit("motor_mode", 1)
        each.set_both_motors(True)
        each.reset("motor1_current_limit")
        each.leave_out("serial_timeout")
        each.load(SPECS, FACTORY, {}, power_cycled=True)


# --- Back to the default, to what is stored ---------------------------------------------


def test_going_back_to_the_default_is_an_edit(model: ParameterModel, undo: QUndoStack) -> None:
    model.load(SPECS, FACTORY | {"serial_timeout": 15}, {}, power_cycled=True)
    assert said(model, "serial_timeout", Column.RESET, Role.RESET) == "Back to default: 0 (off)"
    model.reset("serial_timeout")
    assert dict(model.pending) == {"serial_timeout": 0}
    assert model.index_of("serial_timeout").data(Role.RESET) is None
    undo.undo()
    assert not model.pending


def test_going_back_to_what_is_stored_is_one_step(model: ParameterModel, undo: QUndoStack) -> None:
    model.edit("device_number", 9)
    assert "Stored: 7." in said(model, "device_number", Column.VALUE, TIP)
    model.restore("device_number")
    assert not model.pending
    undo.undo()
    assert dict(model.pending) == {"device_number": 9}


# --- Both motors ------------------------------------------------------------------------


def test_every_parameter_of_one_motor_has_its_twin(model: ParameterModel) -> None:
    for spec in SPECS.readable:
        twin = model.twin_of(spec.key)
        assert (twin is not None) == (spec.subject in {"motor1", "motor2"})
        if twin is not None:
            assert model.twin_of(twin) == spec.key
    assert twin_key("aux_acceleration") is None
    assert motor_name("motor2_acceleration") == "Motor 2"
    assert motor_name("serial_timeout") == ""


def test_one_edit_for_both_motors_is_one_step(model: ParameterModel, undo: QUndoStack) -> None:
    model.set_both_motors(True)
    model.edit("motor2_current_limit", 25)
    assert dict(model.pending) == {"motor1_current_limit": 25, "motor2_current_limit": 25}
    assert undo.undoText() == "Motors 1 and 2 Current Limit"
    undo.undo()
    assert not model.pending
    undo.redo()
    assert len(model.pending) == 2


def test_resetting_and_going_back_serve_both_motors(
    model: ParameterModel, undo: QUndoStack
) -> None:
    stored = FACTORY | {"motor1_current_limit": 10, "motor2_current_limit": 20}
    model.load(SPECS, stored, {}, power_cycled=True)
    model.set_both_motors(True)
    model.reset("motor1_current_limit")
    assert dict(model.pending) == {"motor1_current_limit": 0, "motor2_current_limit": 0}
    model.restore("motor2_current_limit")
    assert not model.pending
    assert undo.count() == 2


def test_what_has_no_twin_is_edited_alone(model: ParameterModel) -> None:
    model.set_both_motors(True)
    model.edit("aux_acceleration", 4)
    model.edit("serial_timeout", 4)
    assert dict(model.pending) == {"aux_acceleration": 4, "serial_timeout": 4}


def test_a_twin_that_was_not_read_is_left_alone(model: ParameterModel) -> None:
    stored = {key: wire for key, wire in FACTORY.items() if key != "motor2_acceleration"}
    model.load(SPECS, stored, {"motor2_acceleration": "No answer."}, power_cycled=True)
    model.set_both_motors(True)
    model.edit("motor1_acceleration", 4)
    assert dict(model.pending) == {"motor1_acceleration": 4}


def test_an_editor_left_as_it_was_does_not_touch_the_other_motor(model: ParameterModel) -> None:
    model.edit("motor1_acceleration", 4)
    model.set_both_motors(True)
    model.edit("motor1_acceleration", 4)
    assert dict(model.pending) == {"motor1_acceleration": 4}


def test_a_value_that_neither_motor_takes_changes_neither(model: ParameterModel) -> None:
    model.set_both_motors(True)
    with pytest.raises(BadRequest):
        model.edit("motor1_pwm_prescaler", 9)
    assert not model.pending


def test_motors_that_differ_say_so(model: ParameterModel) -> None:
    assert model.index_of("motor1_current_limit").data(Role.TWIN) is None
    model.edit("motor2_current_limit", 25)
    assert said(model, "motor1_current_limit", Column.VALUE, Role.TWIN) == "Motor 2 differs: 2 A."
    assert "Motor 2 differs: 2 A." in said(model, "motor1_current_limit", Column.VALUE, TIP)
    model.copy_to_twin("motor2_current_limit")
    assert model.value_of("motor1_current_limit") == 25


def test_files_and_boards_keep_motors_apart_when_both_are_edited_as_one(qtbot: QtBot) -> None:
    draft = SettingsDraft()
    before = Settings(SPECS.model, "1.2", FACTORY)
    draft.parameters.load(SPECS, FACTORY, {}, power_cycled=True)
    draft.parameters.set_both_motors(True)
    values = {"motor1_current_limit": 10, "motor2_current_limit": 20}
    after = Settings(SPECS.model, "1.2", FACTORY | values)
    draft.stage(compare(before, after).rows, "Open settings file")
    assert dict(draft.parameters.pending) == values
    draft.parameters.discard_edits()
    assert not draft.parameters.pending


def test_an_accepted_proposal_serves_both_motors_in_one_step(qtbot: QtBot) -> None:
    draft = SettingsDraft()
    stored = FACTORY | {"motor1_current_limit": 10, "motor1_current_limit_p": 0}
    draft.take_settings(Settings(SPECS.model, "1.2", stored))
    draft.parameters.set_both_motors(True)
    adviser = Adviser(draft)
    advice = next(a for a in adviser.advice if "motor1_current_limit_p" in a.change)
    draft.parameters.edit("motor2_current_limit_p", 9, alone=True)
    steps = draft.undo.count()
    adviser.accept(advice)
    assert draft.parameters.value_of("motor1_current_limit_p") == 5
    assert draft.parameters.value_of("motor2_current_limit_p") == 5
    assert draft.undo.count() == steps + 1
    draft.undo.undo()
    assert draft.parameters.value_of("motor2_current_limit_p") == 9


# --- A file -----------------------------------------------------------------------------


def test_what_a_file_does_not_give_can_be_given_and_undone(
    file: ParameterModel, undo: QUndoStack
) -> None:
    assert said(file, "motor_mode", Column.VALUE) == "not given"
    assert said(file, "motor_mode", Column.WIRE) == ""
    assert file.index_of("motor_mode").data(Role.RESET) is None
    file.edit("motor_mode", 0)
    assert dict(file.pending) == {"motor_mode": 0}
    assert file.all_shown["motor_mode"] == 0
    undo.undo()
    assert said(file, "motor_mode", Column.VALUE) == "not given"
    assert not file.modified
    assert "motor_mode" not in file.all_shown


def test_what_a_file_gives_can_be_left_out_and_undone(
    file: ParameterModel, undo: QUndoStack, qtbot: QtBot
) -> None:
    with qtbot.waitSignal(file.pending_changed) as changed:
        file.leave_out("serial_timeout")
    assert changed.args == [1]
    assert list(file.removed) == ["serial_timeout"]
    assert list(file.modified) == ["serial_timeout"]
    assert file.is_modified("serial_timeout")
    assert not file.pending
    assert "serial_timeout" not in file.all_shown
    assert file.all_stored["serial_timeout"] == 5
    assert file.index_of("serial_timeout").data(Role.DIRTY) is True
    undo.undo()
    assert not file.modified
    undo.redo()
    assert list(file.removed) == ["serial_timeout"]
    file.discard_edits()
    assert not file.modified


def test_leaving_out_serves_both_motors(file: ParameterModel, undo: QUndoStack) -> None:
    file.set_both_motors(True)
    file.edit("motor1_current_limit", 12)
    assert file.value_of("motor2_current_limit") == 12
    file.leave_out("motor2_current_limit")
    assert file.value_of("motor1_current_limit") is None
    undo.undo()
    assert file.value_of("motor1_current_limit") == 12


def test_what_cannot_be_left_out_stays(model: ParameterModel, undo: QUndoStack) -> None:
    model.leave_out("serial_timeout")
    model.reset("nonsense")
    model.restore("nonsense")
    assert model.value_of("serial_timeout") == FACTORY["serial_timeout"]
    assert not undo.canUndo()


def test_a_draft_of_a_file_counts_what_is_left_out(qtbot: QtBot) -> None:
    draft = SettingsDraft()
    draft.take_settings(Settings(SPECS.model, "1.2", {"serial_timeout": 5}))
    assert draft.knows("motor_mode")
    draft.parameters.leave_out("serial_timeout")
    draft.parameters.edit("motor_mode", 1)
    assert draft.pending == 2
    assert draft.shown is not None
    assert draft.shown.parameters == {"motor_mode": 1}
    draft.discard_edits()
    assert draft.pending == 0


# --- In words ---------------------------------------------------------------------------


def test_values_are_in_units_that_a_person_knows(model: ParameterModel) -> None:
    for key, wire, text in (
        ("motor1_current_limit", 25, "2 A"),
        ("motor1_acceleration", 4, "3.2 s to full speed"),
        ("motor1_acceleration", 127, "100 ms to full speed"),
        ("motor1_acceleration", 0, "no ramp"),
        ("motor1_pwm_maximum", 63, "127 (2441 Hz)"),
        ("motor1_pwm_prescaler", 1, "clock / 64 (2441 Hz)"),
        ("motor1_brake_duration", 12, "120 ms"),
        ("motor1_deadband_brake_pwm", 127, "100 %"),
        ("serial_timeout", 15, "1.5 s"),
        ("uart_settings", 5, "19200 baud, no check, 1 stop bit"),
        ("crc7_polynomial", 9, "0x89"),
        ("required_channels", 5, "channels 1, 3"),
    ):
        model.edit(key, wire)
        assert said(model, key, Column.VALUE) == text
        assert said(model, key, Column.WIRE) == str(wire)


def test_another_prescaler_announces_the_frequency_of_the_maximum(model: ParameterModel) -> None:
    told: list[str] = []
    model.dataChanged.connect(
        lambda first, _last: told.append(first.siblingAtColumn(Column.NAME).data())
    )
    model.edit("motor1_pwm_prescaler", 0)
    assert "Motor 1 PWM Maximum" in told


def test_a_board_with_an_unknown_prescaler_shows_no_frequency(model: ParameterModel) -> None:
    model.load(SPECS, FACTORY | {"motor1_pwm_prescaler": 9}, {}, power_cycled=True)
    assert said(model, "motor1_pwm_maximum", Column.VALUE) == "127"
    assert said(model, "motor1_pwm_prescaler", Column.VALUE) == "wire 9"


def test_the_source_tells_what_the_maker_confirms(model: ParameterModel) -> None:
    for key, text, told in (
        ("device_number", "range inferred", "default is confirmed"),
        ("serial_timeout", "default inferred", "range is confirmed"),
        ("motor1_current_limit", "inferred", "the board has the last word"),
        ("uart_settings", "inferred", "So is what a wire value means"),
    ):
        assert said(model, key, Column.SOURCE) == text
        assert told in said(model, key, Column.SOURCE, TIP)


def test_a_confirmed_parameter_is_the_vendors(model: ParameterModel) -> None:
    spec = replace(SPECS["serial_timeout"], inferred=frozenset())
    assert model.text.source(spec) == "vendor"
    assert "confirm" in model.text.origin(spec)
    assert "last word" not in model.text.origin(spec)


def test_every_tool_tip_says_what_the_column_has_no_room_for(model: ParameterModel) -> None:
    assert "wire value 0 to 127" in said(model, "motor1_acceleration", Column.RANGE, TIP)
    assert "0.1 to 12.7 s" in said(model, "motor1_acceleration", Column.RANGE, TIP)
    assert "5 (19200 baud" in said(model, "uart_settings", Column.DEFAULT, TIP)
    assert "off and on" in said(model, "motor_mode", Column.EFFECT, TIP)
    assert "as soon as" in said(model, "serial_timeout", Column.EFFECT, TIP)
    assert "Motor 1 Current Limit" in said(model, "motor1_current_limit", Column.NAME, TIP)
    assert model.index_of("serial_timeout", Column.RESET).data(TIP) is None
    model.edit("serial_timeout", 15)
    assert said(model, "serial_timeout", Column.RESET, TIP) == "Back to default: 0 (off)"
    spoken = Qt.ItemDataRole.AccessibleTextRole
    assert said(model, "serial_timeout", Column.RESET, spoken) == "Back to default: 0 (off)"
