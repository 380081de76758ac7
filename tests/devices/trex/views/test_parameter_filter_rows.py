"""What is shown of the parameter table."""

import pytest
from pytestqt.modeltest import ModelTester
from pytestqt.qtbot import QtBot

from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.views.pages.parameters.filters import ParameterFilter, Shown

SPECS = parameters_of("trex", "1.2")
FACTORY = {spec.key: spec.default for spec in SPECS.readable}


@pytest.fixture
def model(qtbot: QtBot) -> ParameterModel:
    model = ParameterModel()
    model.load(SPECS, {**FACTORY, "serial_timeout": 5}, {}, power_cycled=True)
    return model


@pytest.fixture
def rows(model: ParameterModel) -> ParameterFilter:
    return ParameterFilter(model)


def shown(rows: ParameterFilter) -> list[str]:
    return [key for row in range(rows.rowCount()) for key in rows.keys_at(row)]


def test_unfiltered_rows_are_all_shown_in_order(rows: ParameterFilter) -> None:
    keys = {spec.key for spec in SPECS.readable}
    assert keys - set(shown(rows)) == {"motor1_pwm_prescaler", "motor2_pwm_prescaler"}
    assert shown(rows)[:2] == ["motor1_acceleration", "motor2_acceleration"]


@pytest.mark.parametrize(
    ("words", "keys"),
    [
        ("TIMEOUT serial", ["serial_timeout", "uart_error_shutdown"]),
        ("serial_timeout", ["serial_timeout"]),
        ("accepts compact packets", ["device_number"]),
        ("flux capacitor", []),
    ],
)
def test_words_match_names_and_descriptions_in_any_order(
    rows: ParameterFilter, words: str, keys: list[str]
) -> None:
    rows.narrow(words=words)
    assert shown(rows) == keys
    rows.narrow()
    assert len(shown(rows)) == len(SPECS.readable) - 2


def test_not_default_filter_shows_changed_values(rows: ParameterFilter) -> None:
    rows.narrow(shown=Shown.NOT_DEFAULT)
    assert shown(rows) == ["serial_timeout"]
    rows.parameters.edit("serial_timeout", FACTORY["serial_timeout"])
    rows.parameters.edit("motor_mode", 1)
    assert shown(rows) == ["motor_mode"]
    rows.narrow(shown=Shown.FOUND)
    assert shown(rows) == []
    rows.set_found(frozenset({"device_number"}))
    assert shown(rows) == ["device_number"]


def test_filters_are_combined(rows: ParameterFilter, model: ParameterModel) -> None:
    model.edit("motor1_acceleration", 4)
    model.edit("device_number", 9)
    rows.narrow(words="acceleration", shown=Shown.CHANGED)
    assert shown(rows) == ["motor1_acceleration", "motor2_acceleration"]


# --- Headings ---------------------------------------------------------------------------


def headings(rows: ParameterFilter) -> list[str]:
    return [rows.index(row, 0).data() for row in range(rows.rowCount()) if not rows.keys_at(row)]


def test_task_without_rows_has_no_heading(rows: ParameterFilter, model: ParameterModel) -> None:
    rows.narrow(words="timeout")
    assert headings(rows) == ["Serial"]
    rows.narrow(shown=Shown.CHANGED)
    assert headings(rows) == []
    model.edit("motor_mode", 1)
    assert headings(rows) == ["Motors and speed ramp (1 modified)"]
    model.edit("ignored_channels", 3)
    assert headings(rows) == ["Motors and speed ramp (1 modified)", "Inputs (1 modified)"]
    model.discard_edits()
    assert headings(rows) == []


def test_filter_passes_qt_model_tester_through_changes(
    rows: ParameterFilter, qtmodeltester: ModelTester
) -> None:
    qtmodeltester.check(rows, force_py=True)  # type: ignore[no-untyped-call] # of pytest-qt
    rows.narrow(shown=Shown.CHANGED)
    rows.parameters.edit("motor_mode", 1)
    rows.parameters.edit("serial_timeout", 9)
    rows.parameters.load(SPECS, FACTORY, {}, power_cycled=True)
    rows.parameters.discard_edits()
    rows.narrow(words="limit")
    qtmodeltester.check(rows, force_py=True)  # type: ignore[no-untyped-call] # of pytest-qt


def test_value_that_is_not_shown_has_no_index(rows: ParameterFilter) -> None:
    rows.narrow("serial")
    assert not rows.index_of("motor_mode").isValid()
    assert rows.index_of("serial_timeout").data() == "0.5 s"
