"""Parameter table as a Qt model."""

from collections.abc import Mapping

import pytest
from PySide6.QtCore import QModelIndex, Qt
from pytestqt.qtbot import QtBot

from trex_gui.core.errors import NoReply
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel, ParameterRole
from trex_gui.devices.trex.model.parameters.text import ParameterColumn
from trex_gui.devices.trex.protocol.calibration import CalibrationKey
from trex_gui.devices.trex.protocol.parameters import ParameterSet, parameters_of

SPECS = parameters_of("trex", "1.2")
JUNIOR = parameters_of("trexjr", "1.2")


def factory(specs: ParameterSet = SPECS) -> dict[str, int]:
    return {spec.key: spec.default for spec in specs.readable}


def load(
    model: ParameterModel,
    stored: Mapping[str, int] | None = None,
    specs: ParameterSet = SPECS,
    *,
    unread: Mapping[str, str] | None = None,
    power_cycled: bool = True,
) -> None:
    values = factory(specs) if stored is None else stored
    model.load(specs, values, unread or {}, power_cycled=power_cycled)


@pytest.fixture
def model(qtbot: QtBot) -> ParameterModel:
    model = ParameterModel()
    load(model)
    return model


def text(model: ParameterModel, key: str) -> str:
    return str(model.index_of(key).data())


def edit(model: ParameterModel, key: str, wire: object) -> bool:
    return model.setData(model.index_of(key), wire)


def data(model: ParameterModel, key: str, role: int) -> object:
    value: object = model.index_of(key).data(role)
    return value


# --- Qt model ---------------------------------------------------------------------------


def test_each_parameter_has_a_cell_and_each_column_a_name(model: ParameterModel) -> None:
    cells = {model.index_of(spec.key) for spec in SPECS.readable}
    assert len(cells) == len(SPECS.readable) - 2, "prescaler and maximum of a motor share a cell"
    rows = {(cell.row(), cell.column()) for cell in cells}
    assert {column for _, column in rows} == {ParameterColumn.MOTOR1, ParameterColumn.MOTOR2}
    assert len({row for row, _ in rows}) == model.count
    assert model.columnCount() == len(ParameterColumn)
    horizontal = Qt.Orientation.Horizontal
    assert all(model.headerData(column, horizontal) for column in ParameterColumn)
    assert model.headerData(0, Qt.Orientation.Vertical) is None


def test_unknown_key_has_no_index(model: ParameterModel) -> None:
    assert not model.index_of("nonsense").isValid()
    assert model.index_of("motor_mode").isValid()


# --- Display ----------------------------------------------------------------------------


def test_row_shows_name_and_value(model: ParameterModel) -> None:
    load(model, factory() | {"serial_timeout": 15})
    cell = model.index_of("serial_timeout")
    assert cell.siblingAtColumn(ParameterColumn.NAME).data() == "Serial Timeout"
    assert cell.data() == "1.5 s"
    assert cell.data(Qt.ItemDataRole.AccessibleTextRole) == "Serial Timeout: 1.5 s."
    limit = model.index_of("motor2_current_limit")
    assert limit.siblingAtColumn(ParameterColumn.NAME).data() == "Current Limit"
    edit(model, "motor2_current_limit", 10)
    accessible_text = limit.data(Qt.ItemDataRole.AccessibleTextRole)
    assert accessible_text == "Motor 2 Current Limit: 3 A, was off. Motor 1 differs: off."


def test_unread_parameter_shows_the_reason(model: ParameterModel) -> None:
    stored = factory()
    del stored["serial_timeout"]
    load(model, stored, unread={"serial_timeout": "No reply to 9F 07."})
    assert text(model, "serial_timeout") == "not read"
    assert data(model, "serial_timeout", ParameterRole.PROBLEM) == "No reply to 9F 07."
    accessible_text = data(model, "serial_timeout", Qt.ItemDataRole.AccessibleTextRole)
    assert "No reply to 9F 07." in str(accessible_text)
    assert not edit(model, "serial_timeout", 9)


# --- Edits ------------------------------------------------------------------------------


def test_edit_is_shown_and_pending(model: ParameterModel, qtbot: QtBot) -> None:
    with qtbot.waitSignal(model.pending_changed):
        assert edit(model, "serial_timeout", 15)
    assert model.values.pending == (("serial_timeout", 15),)
    assert text(model, "serial_timeout") == "1.5 s"
    assert data(model, "serial_timeout", ParameterRole.DIRTY) is True


def test_edit_changes_only_its_row_and_heading(model: ParameterModel, qtbot: QtBot) -> None:
    changes: list[tuple[int, int]] = []
    model.dataChanged.connect(lambda first, last: changes.append((first.row(), last.row())))
    with qtbot.assertNotEmitted(model.modelReset):
        edit(model, "serial_timeout", 15)
    row = model.index_of("serial_timeout").row()
    heading = next(index for index in range(row, -1, -1) if not model.rows[index].keys)
    assert changes == [(row, row), (heading, heading)]


def test_invalid_value_is_rejected_with_a_reason(model: ParameterModel, qtbot: QtBot) -> None:
    not_numbers: list[object] = ["abc", "", None, []]
    for key, value in (
        *(("motor_mode", 2), ("serial_timeout", -1), ("uart_settings", 0x0B)),
        *(("serial_timeout", value) for value in not_numbers),
    ):
        with qtbot.waitSignal(model.rejected) as rejection:
            assert not edit(model, key, value)
        assert rejection.args[0].startswith(SPECS[key].name)
    assert model.values.pending == ()


def test_edit_needs_a_value_cell_and_the_edit_role(model: ParameterModel) -> None:
    assert not model.setData(QModelIndex(), 9)
    index = model.index_of("serial_timeout")
    assert not model.setData(index, 9, Qt.ItemDataRole.DisplayRole)
    name = index.siblingAtColumn(ParameterColumn.NAME)
    assert not name.flags() & Qt.ItemFlag.ItemIsEditable
    assert not model.setData(name, 9)
    assert model.values.pending == ()


# --- Writes -----------------------------------------------------------------------------


def test_failed_write_stays_pending_with_a_reason(model: ParameterModel, qtbot: QtBot) -> None:
    edit(model, "serial_timeout", 9)
    edit(model, "motor_mode", 1)
    with qtbot.waitSignal(model.pending_changed):
        model.record_stored({"serial_timeout": 9})
    assert model.values.stored.get("serial_timeout") == 9
    model.record_results(
        [WriteResult("serial_timeout", 9), WriteResult("motor_mode", error=NoReply("No reply."))]
    )
    assert model.values.pending == (("motor_mode", 1),)
    assert data(model, "motor_mode", ParameterRole.PROBLEM) == "No reply."
    assert data(model, "serial_timeout", ParameterRole.PROBLEM) is None
    load(model, factory() | {"serial_timeout": 9})
    assert data(model, "motor_mode", ParameterRole.PROBLEM) == "No reply."
    model.record_results([WriteResult("motor_mode", 1)])
    assert data(model, "motor_mode", ParameterRole.PROBLEM) is None


def test_results_of_other_keys_are_ignored(model: ParameterModel) -> None:
    model.record_results(
        [WriteResult(CalibrationKey.RC_CHANNEL_1, error=NoReply("x")), WriteResult("nonsense", 1)]
    )
    assert model.values.pending == ()


# --- Stored and active ------------------------------------------------------------------


def test_parameters_waiting_for_a_power_cycle_are_named(model: ParameterModel) -> None:
    assert not model.values.waiting_for_power
    model.record_stored({"motor_mode": 1, "serial_timeout": 9})
    assert model.values.waiting_for_power == ("Motor Mode",)
    assert data(model, "motor_mode", ParameterRole.ACTIVE) is not None
    assert data(model, "serial_timeout", ParameterRole.ACTIVE) is None


# --- Another board ----------------------------------------------------------------------


def test_edit_is_discarded_for_another_model(model: ParameterModel, qtbot: QtBot) -> None:
    edit(model, "serial_timeout", 9)
    with qtbot.waitSignal(model.pending_changed):
        load(model, factory(JUNIOR), JUNIOR)
    assert model.values.pending == ()
