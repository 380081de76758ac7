"""The columns of the parameter table share its width."""

import pytest

from tests.support.program import trex
from tests.support.window import WindowDriver
from trex_gui.devices.trex.model.parameters.text import ParameterColumn
from trex_gui.devices.trex.views.pages.parameters.view import ParameterView


@pytest.mark.parametrize("width", [470, 1000, 1900, 3800])
def test_values_and_names_are_neither_cut_nor_lost_in_empty_room(
    connected_window: WindowDriver, width: int
) -> None:
    window = connected_window
    trex(window.program).workspace.show_page("parameters")
    view = window.find_only(ParameterView)
    view.resize(width, 400)
    character = view.fontMetrics().averageCharWidth()
    assert view.columnWidth(ParameterColumn.MOTOR1) >= 22 * character
    assert view.columnWidth(ParameterColumn.MOTOR2) >= 22 * character
    assert 24 * character <= view.columnWidth(ParameterColumn.NAME) <= 44 * character


def test_width_that_the_user_gives_a_column_stays(connected_window: WindowDriver) -> None:
    window = connected_window
    trex(window.program).workspace.show_page("parameters")
    view = window.find_only(ParameterView)
    view.resize(1000, 400)
    value = view.columnWidth(ParameterColumn.MOTOR1)
    wide = view.columnWidth(ParameterColumn.NAME) + 57
    view.setColumnWidth(ParameterColumn.NAME, wide)
    view.resize(1900, 400)
    assert view.columnWidth(ParameterColumn.NAME) == wide
    assert view.columnWidth(ParameterColumn.MOTOR1) > value
