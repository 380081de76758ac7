"""The parameter table: groups, search, reset to defaults, both motors, with mouse and keys."""

import pytest
from PySide6.QtCore import QCoreApplication, QModelIndex, Qt
from PySide6.QtGui import QAction, QContextMenuEvent, QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QComboBox, QLineEdit, QMenu
from pytestqt.qtbot import QtBot

from tests.devices.trex.views.parameters import ParametersDriver
from trex_gui.devices.trex.model.parameters.parameters import Role
from trex_gui.devices.trex.model.parameters.text import ParameterColumn
from trex_gui.devices.trex.protocol.parameters import parameters_of

SPECS = parameters_of("trexjr", "1.2")
OLDER = parameters_of("trexjr", "1.0")
GROUPS = ["motors", "channels", "serial"]
MOTORS, CHANNELS, SERIAL = range(3)
FIRST = "motor1_deadband_brake_pwm"
CONTROL = Qt.KeyboardModifier.ControlModifier

with_menu = pytest.mark.qt_log_ignore("This plugin does not support", extend=True)
"""Of the offscreen platform, where a menu is opened."""


@pytest.fixture
def parameters(qtbot: QtBot) -> ParametersDriver:
    parameters = ParametersDriver(qtbot)
    parameters.load(SPECS)
    return parameters


def headings_span(parameters: ParametersDriver) -> bool:
    """Return whether each heading spans all columns."""
    rows = range(len(parameters.headings))
    return all(parameters.view.isFirstColumnSpanned(row, QModelIndex()) for row in rows)


def help_text(parameters: ParametersDriver) -> str:
    return parameters.text("parameterHelp")


# --- Groups and search ------------------------------------------------------------------


def test_groups_are_open_once_a_board_is_read(qtbot: QtBot) -> None:
    parameters = ParametersDriver(qtbot)
    assert not parameters.has("noParameterMatches")
    assert not parameters.is_enabled("parameterSearch")
    assert parameters.current == ""
    parameters.table.show_parameter("serial_timeout")
    parameters.press(Qt.Key.Key_Return)
    assert parameters.current == ""

    parameters.load(SPECS)
    assert parameters.open_groups == GROUPS
    assert headings_span(parameters)
    assert parameters.current == FIRST
    assert parameters.view.verticalScrollBar().value() == 0, "the first heading is in sight"


def test_closed_group_stays_closed(parameters: ParametersDriver) -> None:
    view = parameters.view
    view.collapse(parameters.headings[CHANNELS])
    parameters.go_to("serial_timeout")
    parameters.load(SPECS)
    assert parameters.open_groups == ["motors", "serial"]
    assert parameters.current == "serial_timeout"
    assert view.currentIndex().column() == ParameterColumn.VALUE
    view.expand(parameters.headings[CHANNELS])

    view.collapse(parameters.headings[SERIAL])
    assert view.currentIndex() == parameters.headings[SERIAL]
    parameters.model.edit("device_number", 9)
    assert parameters.open_groups == ["motors", "channels"]
    assert "Serial (6, 1 modified)" in help_text(parameters)
    parameters.load(SPECS)
    assert view.currentIndex() == parameters.headings[SERIAL]
    view.expand(parameters.headings[SERIAL])

    parameters.go_to("uart_response_delay")
    view.collapse(parameters.headings[MOTORS])
    parameters.load(OLDER)
    assert view.currentIndex() == parameters.headings[MOTORS], "not opened for its first row"
    assert parameters.open_groups == ["channels", "serial"]


def test_search_opens_groups_until_it_ends(parameters: ParametersDriver) -> None:
    view = parameters.view
    parameters.search("timeout")
    parameters.search("")
    assert parameters.open_groups == GROUPS
    assert headings_span(parameters)

    parameters.go_to("required_channels")
    parameters.search("timeout")
    assert parameters.current == "serial_timeout"
    parameters.search("flux")
    assert parameters.current == ""
    assert help_text(parameters) == ""
    parameters.search("")
    assert parameters.current == "required_channels"

    view.collapse(parameters.headings[MOTORS])
    view.collapse(parameters.headings[SERIAL])
    parameters.search("motor")
    assert parameters.open_groups == [row.data(Role.GROUP) for row in parameters.headings]
    parameters.search("")
    assert parameters.open_groups == ["channels"]
    assert headings_span(parameters)

    parameters.search("timeout")
    parameters.click_cell("serial_timeout", ParameterColumn.NAME)
    parameters.search("")
    assert parameters.current == "serial_timeout", "the row that was found stays in sight"
    assert parameters.open_groups == ["channels", "serial"]
    parameters.load(SPECS)
    assert parameters.open_groups == ["channels", "serial"]


def test_hidden_parameters_can_be_shown(parameters: ParametersDriver) -> None:
    assert not parameters.has("noParameterMatches")
    parameters.search("flux capacitor")
    parameters.find(QCheckBox, "modifiedOnly").setChecked(True)
    assert parameters.has("noParameterMatches")
    parameters.click("showAllParameters")
    assert not parameters.has("noParameterMatches")
    assert parameters.rows.shown == len(SPECS.readable)

    parameters.view.collapse(parameters.headings[SERIAL])
    parameters.search("motor")
    parameters.table.show_parameter("serial_timeout")
    assert parameters.current == "serial_timeout"
    assert parameters.view.isExpanded(parameters.headings[SERIAL])
    assert "Serial Timeout" in help_text(parameters)


def test_board_of_older_firmware_lacks_parameters(parameters: ParametersDriver) -> None:
    parameters.go_to("uart_response_delay")
    parameters.load(OLDER)
    assert parameters.current == FIRST

    group = parameters.find(QComboBox, "parameterGroup")
    parameters.load(SPECS)
    assert [group.itemData(i) for i in range(group.count())] == ["", *GROUPS]
    group.setCurrentIndex(group.findData("serial"))
    parameters.load(OLDER)
    assert group.currentData() == "serial"
    assert len(parameters.headings) == 1


# --- Reset to the default ---------------------------------------------------------------


def test_click_on_reset_restores_the_default(parameters: ParametersDriver) -> None:
    parameters.click_cell("serial_timeout", ParameterColumn.RESET)
    parameters.click_cell("serial_timeout", ParameterColumn.DEFAULT)
    assert not parameters.draft.undo.canUndo(), "nothing differs from the default"

    parameters.load(SPECS, serial_timeout=15)
    parameters.click_cell("serial_timeout", ParameterColumn.RESET)
    assert dict(parameters.model.pending) == {"serial_timeout": 0}
    assert parameters.draft.undo.undoText() == "Serial Timeout"
    parameters.draft.undo.undo()
    assert not parameters.model.pending

    parameters.table.set_rows_enabled(False)
    parameters.click_cell("serial_timeout", ParameterColumn.RESET)
    parameters.press(Qt.Key.Key_Backspace, CONTROL)
    assert not parameters.model.pending, "disabled rows cannot be reset"


def test_keys_reset_to_the_default(parameters: ParametersDriver) -> None:
    parameters.load(SPECS, serial_timeout=15)
    for key in (Qt.Key.Key_Return, Qt.Key.Key_Space):
        parameters.go_to("serial_timeout")
        parameters.press(Qt.Key.Key_Right)
        assert parameters.view.currentIndex().column() == ParameterColumn.RESET
        parameters.press(key)
        assert dict(parameters.model.pending) == {"serial_timeout": 0}, key
        parameters.press(Qt.Key.Key_Left)
        assert parameters.view.currentIndex().column() == ParameterColumn.VALUE
        parameters.draft.undo.undo()

    assert not parameters.model.pending
    parameters.go_to("serial_timeout")
    parameters.focus_view()
    parameters.press(Qt.Key.Key_Backspace, CONTROL)
    assert dict(parameters.model.pending) == {"serial_timeout": 0}


# --- Keys and mouse ---------------------------------------------------------------------


def test_keys_navigate_collapse_expand_and_edit(parameters: ParametersDriver) -> None:
    parameters.view.setCurrentIndex(parameters.headings[SERIAL])
    parameters.press(Qt.Key.Key_Space)
    assert parameters.open_groups == ["motors", "channels"]
    parameters.press(Qt.Key.Key_Return)
    parameters.press(Qt.Key.Key_Down)
    assert parameters.current == "device_number"
    parameters.press(Qt.Key.Key_Down)
    parameters.press(Qt.Key.Key_Return)
    editor = parameters.editor("serial_timeout")
    QTest.keyClicks(editor, "2 s")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    parameters.wait_for_value("serial_timeout", 20)
    parameters.press(Qt.Key.Key_Up)
    parameters.press(Qt.Key.Key_Up)
    assert parameters.view.currentIndex().data(Role.GROUP) == "serial"

    parameters.focus_view()
    parameters.press(Qt.Key.Key_F, CONTROL)
    assert parameters.find(QLineEdit, "parameterSearch").hasFocus()


def test_value_is_edited_from_any_column(parameters: ParametersDriver) -> None:
    for column in (
        ParameterColumn.NAME,
        ParameterColumn.WIRE,
        ParameterColumn.RESET,
        ParameterColumn.EFFECT,
    ):
        parameters.go_to("serial_timeout", column)
        parameters.press(Qt.Key.Key_F2)
        assert parameters.is_editing("serial_timeout"), column
        parameters.close_editor("serial_timeout")
    for column in (ParameterColumn.NAME, ParameterColumn.DEFAULT, ParameterColumn.SOURCE):
        parameters.open_with_mouse("serial_timeout", column)
        assert parameters.view.currentIndex().column() == ParameterColumn.VALUE, column
        parameters.close_editor("serial_timeout")


# --- Context menu -----------------------------------------------------------------------


def request_menu(parameters: ParametersDriver, index: QModelIndex) -> QMenu:
    """Press the right button of the mouse on a row."""
    place = parameters.place_of(index)
    viewport = parameters.view.viewport()
    mouse = QContextMenuEvent.Reason.Mouse
    event = QContextMenuEvent(mouse, place, viewport.mapToGlobal(place))
    QCoreApplication.sendEvent(viewport, event)
    return parameters.find(QMenu, "parameterMenu")


def menu_of(parameters: ParametersDriver, key: str) -> dict[str, QAction]:
    """Open the menu of a row; return what can be seen in it, by name."""
    menu = request_menu(parameters, parameters.rows.index_of(key))
    assert menu.isVisible()
    menu.close()
    return {a.objectName(): a for a in menu.actions() if a.isVisible() and a.objectName()}


@with_menu
def test_menu_entries_describe_their_effect(parameters: ParametersDriver) -> None:
    parameters.go_to("serial_timeout", ParameterColumn.WIRE)
    corner = parameters.view.pos()
    keyboard = QContextMenuEvent.Reason.Keyboard
    event = QContextMenuEvent(keyboard, corner, parameters.view.mapToGlobal(corner))
    QCoreApplication.sendEvent(parameters.view, event)
    menu = parameters.find(QMenu, "parameterMenu")
    assert menu.isVisible()
    menu.close()
    assert parameters.current == "serial_timeout", "the menu key keeps the current row"

    parameters.go_to("device_number")
    parameters.model.edit("serial_timeout", 15)
    actions = menu_of(parameters, "serial_timeout")
    assert parameters.current == "serial_timeout"
    assert actions["resetParameter"].text() == "Reset to default: 0 (off)"
    assert actions["restoreParameter"].text() == "Restore stored value: 0 (off)"
    assert actions["copyParameter"].text() == "Copy as “serial_timeout: 15”"
    assert "leaveOutParameter" not in actions
    assert "copyToOtherMotor" not in actions
    unchanged = menu_of(parameters, "device_number")
    assert not unchanged["resetParameter"].isEnabled()
    assert not unchanged["restoreParameter"].isEnabled()
    assert not request_menu(parameters, parameters.headings[0]).isVisible(), "none of a heading"


@with_menu
def test_menu_edits_resets_restores_and_copies(parameters: ParametersDriver) -> None:
    parameters.model.edit("motor1_current_limit", 25)
    actions = menu_of(parameters, "motor1_current_limit")
    assert actions["copyToOtherMotor"].text() == "Copy to Motor 2"
    actions["copyToOtherMotor"].trigger()
    assert parameters.model.value_of("motor2_current_limit") == 25
    assert not menu_of(parameters, "motor1_current_limit")["copyToOtherMotor"].isEnabled()
    for key in ("motor1_current_limit", "motor2_current_limit"):
        parameters.model.restore(key)

    parameters.load(SPECS, serial_timeout=5)
    menu_of(parameters, "serial_timeout")["resetParameter"].trigger()
    assert dict(parameters.model.pending) == {"serial_timeout": 0}
    menu_of(parameters, "serial_timeout")["restoreParameter"].trigger()
    assert not parameters.model.pending
    menu_of(parameters, "serial_timeout")["copyParameter"].trigger()
    assert QGuiApplication.clipboard().text() == "serial_timeout: 5"
    menu_of(parameters, "serial_timeout")["editParameter"].trigger()
    assert parameters.is_editing("serial_timeout")


@with_menu
def test_menu_leaves_a_parameter_out_of_a_file(parameters: ParametersDriver) -> None:
    parameters.open_file(SPECS, serial_timeout=5, motor1_current_limit=10)
    actions = menu_of(parameters, "serial_timeout")
    assert actions["leaveOutParameter"].text() == "Leave out of the file"
    actions["leaveOutParameter"].trigger()
    assert parameters.rows.index_of("serial_timeout").data() == "not given"
    assert parameters.draft.pending == 1
    assert not menu_of(parameters, "serial_timeout")["copyParameter"].isEnabled()
    assert "leaveOutParameter" not in menu_of(parameters, "serial_timeout")
    parameters.draft.undo.undo()
    assert parameters.rows.index_of("serial_timeout").data() == "0.5 s"


# --- Both motors ------------------------------------------------------------------------


def test_both_motors_are_edited_as_one(parameters: ParametersDriver, qtbot: QtBot) -> None:
    parameters.click("bothMotors")
    editor = parameters.open_with_mouse("motor1_current_limit")
    QTest.keyClicks(editor, "2 A")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    parameters.wait_for_value("motor2_current_limit", 25)
    assert parameters.draft.undo.count() == 1
    parameters.click_cell("motor2_current_limit", ParameterColumn.RESET)
    assert not parameters.model.pending

    other = ParametersDriver(qtbot)
    assert other.find(QCheckBox, "bothMotors").isChecked(), "the box is remembered"
    assert other.model.both_motors

    parameters.click("bothMotors")
    parameters.model.edit("motor1_current_limit", 25)
    assert parameters.model.value_of("motor2_current_limit") == 0


# --- Help and painting ------------------------------------------------------------------


def test_help_follows_the_parameter_and_its_edits(parameters: ParametersDriver) -> None:
    parameters.go_to("motor1_current_limit")
    for text in ("0x13", "off to 10.16 A", "Default: 0 (off)", "The board rejects any value"):
        assert text in help_text(parameters)
    assert "Motor 2" not in help_text(parameters)
    parameters.model.edit("motor2_current_limit", 25)
    assert "Motor 2 differs: 2 A." in help_text(parameters)

    parameters.go_to("motor_mode")
    assert "switched off and on" in help_text(parameters)
    parameters.model.edit("motor_mode", 1)
    assert "Stored: 0 (independent)" in help_text(parameters)


def test_rows_of_every_kind_are_painted(parameters: ParametersDriver) -> None:
    """Rows are marked, inferred, disabled and current; a fault in painting is a warning."""
    parameters.model.edit("motor1_acceleration", 4)
    parameters.go_to("motor1_acceleration", ParameterColumn.RESET)
    parameters.focus_view()
    assert not parameters.table.grab().isNull()
    parameters.table.set_rows_enabled(False)
    assert not parameters.table.grab().isNull()
    parameters.open_file(SPECS, serial_timeout=5)
    assert not parameters.table.grab().isNull()
