"""Filters of the parameter table."""

import pytest
from pytestqt.qtbot import QtBot

from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.views.pages.parameters.view import ParameterChoice, ParameterFilter

SPECS = parameters_of("trex", "1.2")
FACTORY = {spec.key: spec.default for spec in SPECS.readable}


@pytest.fixture
def model(qtbot: QtBot) -> ParameterModel:
    model = ParameterModel()
    model.load(SPECS, {**FACTORY, "serial_timeout": 5}, {}, power_cycled=True)
    return model


def keys(
    model: ParameterModel,
    words: str = "",
    choice: ParameterChoice = ParameterChoice.ALL,
    *with_findings: str,
) -> list[str]:
    """Return the visible keys."""
    rows = ParameterFilter(tuple(words.split()), choice, frozenset(with_findings)).rows(model)
    return [key for row in rows for key in model.rows[row].keys]


def test_unfiltered_rows_are_all_shown_in_order(model: ParameterModel) -> None:
    readable = {spec.key for spec in SPECS.readable}
    assert readable - set(keys(model)) == {"motor1_pwm_prescaler", "motor2_pwm_prescaler"}
    assert keys(model)[:2] == ["motor1_acceleration", "motor2_acceleration"]


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("timeout serial", ["serial_timeout", "uart_error_shutdown"]),
        ("serial_timeout", ["serial_timeout"]),
        ("accepts compact packets", ["device_number"]),
        ("flux capacitor", []),
    ],
)
def test_words_match_names_and_descriptions_in_any_order(
    model: ParameterModel, words: str, expected: list[str]
) -> None:
    assert keys(model, words) == expected


def test_not_default_filter_follows_edits(model: ParameterModel) -> None:
    assert keys(model, "", ParameterChoice.NOT_DEFAULT) == ["serial_timeout"]
    model.edit("serial_timeout", FACTORY["serial_timeout"])
    model.edit("motor_mode", 1)
    assert keys(model, "", ParameterChoice.NOT_DEFAULT) == ["motor_mode"]


def test_findings_filter_shows_parameters_with_findings(model: ParameterModel) -> None:
    assert keys(model, "", ParameterChoice.WITH_FINDINGS, "device_number") == ["device_number"]


def test_filters_are_combined(model: ParameterModel) -> None:
    model.edit("motor1_acceleration", 4)
    model.edit("device_number", 9)
    visible = keys(model, "acceleration", ParameterChoice.CHANGED)
    assert visible == ["motor1_acceleration", "motor2_acceleration"]


def test_task_without_rows_has_no_heading(model: ParameterModel) -> None:
    assert not ParameterFilter(shown=ParameterChoice.CHANGED).rows(model)
    model.edit("motor_mode", 1)
    model.edit("ignored_channels", 3)
    rows = ParameterFilter(shown=ParameterChoice.CHANGED).rows(model)
    headings = [model.index(row, 0).data() for row in rows if not model.rows[row].keys]
    assert headings == ["Motors and speed ramp (1 modified)", "Inputs (1 modified)"]
