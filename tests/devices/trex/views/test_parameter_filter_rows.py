"""What is shown of the parameter table."""

import pytest
from pytestqt.modeltest import ModelTester
from pytestqt.qtbot import QtBot

from trex_gui.devices.trex.model.parameters.parameters import ParameterModel, Role
from trex_gui.devices.trex.model.parameters.text import ParameterColumn
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
    headings = [rows.index(group, 0) for group in range(rows.rowCount())]
    return [
        rows.index(row, ParameterColumn.VALUE, heading).data(Role.SPEC).key
        for heading in headings
        for row in range(rows.rowCount(heading))
    ]


def in_groups(*groups: str) -> list[str]:
    return [spec.key for group in groups for spec in SPECS.readable if spec.group == group]


def test_filter_passes_qt_model_tester(rows: ParameterFilter, qtmodeltester: ModelTester) -> None:
    rows.narrow(words="motor")
    qtmodeltester.check(rows)  # type: ignore[no-untyped-call] # of pytest-qt


def test_unfiltered_rows_are_all_shown_in_order(rows: ParameterFilter) -> None:
    assert shown(rows) == in_groups("motors", "channels", "serial", "system")


@pytest.mark.parametrize("words", ["serial timeout", "TIMEOUT serial", "serial_timeout"])
def test_words_match_in_any_order_and_case(rows: ParameterFilter, words: str) -> None:
    rows.narrow(words=words)
    assert "serial_timeout" in shown(rows)
    assert "motor_mode" not in shown(rows)


def test_words_match_descriptions(rows: ParameterFilter) -> None:
    rows.narrow(words="accepts compact packets")
    assert shown(rows) == ["device_number"]


def test_unmatched_words_leave_no_rows(rows: ParameterFilter) -> None:
    rows.narrow(words="flux capacitor")
    assert shown(rows) == []
    rows.narrow()
    assert len(shown(rows)) == len(SPECS.readable)


@pytest.mark.parametrize("group", ["motors", "channels", "serial"])
def test_selected_group_is_shown_alone(rows: ParameterFilter, group: str) -> None:
    rows.narrow(group=group)
    assert shown(rows) == in_groups(group)


def test_modified_only_filter_follows_the_edits(
    rows: ParameterFilter, model: ParameterModel
) -> None:
    rows.narrow(modified_only=True)
    assert shown(rows) == []
    model.edit("motor_mode", 1)
    assert shown(rows) == ["motor_mode"]
    model.discard_edits()
    assert shown(rows) == []


def test_not_default_filter_shows_changed_values(
    rows: ParameterFilter, model: ParameterModel
) -> None:
    rows.narrow(not_default_only=True)
    assert shown(rows) == ["serial_timeout"]
    model.edit("serial_timeout", FACTORY["serial_timeout"])
    model.edit("motor_mode", 1)
    assert shown(rows) == ["motor_mode"]


def test_filters_are_combined(rows: ParameterFilter, model: ParameterModel) -> None:
    model.edit("motor1_acceleration", 4)
    model.edit("device_number", 9)
    rows.narrow(words="acceleration", group="motors", modified_only=True)
    assert shown(rows) == ["motor1_acceleration"]


# --- Headings ---------------------------------------------------------------------------


def headings(rows: ParameterFilter) -> list[str]:
    return [rows.index(row, 0).data() for row in range(rows.rowCount())]


def test_group_without_rows_has_no_heading(rows: ParameterFilter, model: ParameterModel) -> None:
    rows.narrow(words="timeout")
    assert headings(rows) == ["Serial (6)"]
    rows.narrow(modified_only=True)
    assert headings(rows) == []
    model.edit("motor_mode", 1)
    assert headings(rows) == ["Motors (17, 1 modified)"]
    model.edit("ignored_channels", 3)
    assert headings(rows) == ["Motors (17, 1 modified)", "Channels (5, 1 modified)"]
    model.discard_edits()
    assert headings(rows) == []


def test_filter_passes_qt_model_tester_through_changes(
    rows: ParameterFilter, model: ParameterModel, qtmodeltester: ModelTester
) -> None:
    qtmodeltester.check(rows, force_py=True)  # type: ignore[no-untyped-call] # of pytest-qt
    rows.narrow(modified_only=True)
    model.edit("motor_mode", 1)
    model.edit("serial_timeout", 9)
    model.load(SPECS, FACTORY, {}, power_cycled=True)
    model.discard_edits()
    rows.narrow(words="limit")
    qtmodeltester.check(rows, force_py=True)  # type: ignore[no-untyped-call] # of pytest-qt


def test_is_narrowed_reports_an_active_filter(rows: ParameterFilter) -> None:
    before = rows.is_narrowed
    rows.narrow(group="serial")
    assert (before, rows.is_narrowed) == (False, True)
    assert not rows.index_of("motor_mode").isValid()
    assert rows.index_of("serial_timeout").data() == "0.5 s"
