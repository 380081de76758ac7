"""What is shown of the parameter table."""

import pytest
from pytestqt.modeltest import ModelTester
from pytestqt.qtbot import QtBot

from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.views.pages.parameters.filters import ParameterFilter

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


def of_tasks(*tasks: str) -> set[str]:
    """The keys of tasks; that of the maximum of a PWM is in the table for the prescaler as well."""
    specs = (spec for spec in SPECS.readable if spec.task in tasks)
    return {spec.key for spec in specs if not spec.key.endswith("prescaler")}


def test_unfiltered_rows_are_all_shown_in_order(rows: ParameterFilter) -> None:
    assert set(shown(rows)) == of_tasks("motors", "braking", "current", "pwm", "channels", "serial")
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


@pytest.mark.parametrize("task", ["motors", "pwm", "channels"])
def test_selected_task_is_shown_alone(rows: ParameterFilter, task: str) -> None:
    rows.parameters.pin(["acceleration", "serial_timeout"])
    rows.narrow(task=task)
    assert set(shown(rows)) == of_tasks(task)


def test_not_default_filter_shows_changed_values(rows: ParameterFilter) -> None:
    rows.narrow(not_default_only=True)
    assert shown(rows) == ["serial_timeout"]
    rows.parameters.edit("serial_timeout", FACTORY["serial_timeout"])
    rows.parameters.edit("motor_mode", 1)
    assert shown(rows) == ["motor_mode"]


def test_filters_are_combined(rows: ParameterFilter, model: ParameterModel) -> None:
    model.edit("motor1_acceleration", 4)
    model.edit("device_number", 9)
    rows.narrow(words="acceleration", task="motors", modified_only=True)
    assert shown(rows) == ["motor1_acceleration", "motor2_acceleration"]


# --- Headings ---------------------------------------------------------------------------


def headings(rows: ParameterFilter) -> list[str]:
    return [rows.index(row, 0).data() for row in range(rows.rowCount()) if not rows.keys_at(row)]


def test_task_without_rows_has_no_heading(rows: ParameterFilter, model: ParameterModel) -> None:
    rows.narrow(words="timeout")
    assert headings(rows) == ["Serial"]
    rows.narrow(modified_only=True)
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
    rows.narrow(modified_only=True)
    rows.parameters.edit("motor_mode", 1)
    rows.parameters.edit("serial_timeout", 9)
    rows.parameters.load(SPECS, FACTORY, {}, power_cycled=True)
    rows.parameters.discard_edits()
    rows.narrow(words="limit")
    qtmodeltester.check(rows, force_py=True)  # type: ignore[no-untyped-call] # of pytest-qt


def test_value_that_is_not_shown_has_no_index(rows: ParameterFilter) -> None:
    rows.narrow(task="serial")
    assert not rows.index_of("motor_mode").isValid()
    assert rows.index_of("serial_timeout").data() == "0.5 s"
