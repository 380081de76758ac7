"""Parameter table with mouse and keys."""

from collections.abc import Callable

import pytest
from PySide6.QtCore import QCoreApplication, QModelIndex, Qt
from PySide6.QtGui import QAction, QContextMenuEvent, QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QLineEdit, QMenu, QTabBar, QWidget
from pytestqt.qtbot import QtBot

from tests.devices.trex.views.parameters import ParametersDriver
from tests.support.window import LEFT
from trex_gui.devices.trex.model.parameters.parameters import ParameterRole
from trex_gui.devices.trex.model.parameters.text import ParameterColumn
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.views.pages.parameters.view import ParameterChoice

SPECS = parameters_of("trexjr", "1.2")
OLDER = parameters_of("trexjr", "1.0")
TASKS = ["motors", "braking", "current", "pwm", "channels", "serial"]
FIRST = "motor1_acceleration"
CONTROL = Qt.KeyboardModifier.ControlModifier

with_menu = pytest.mark.qt_log_ignore("This plugin does not support", extend=True)
"""Ignores a warning of the offscreen platform when a menu opens."""


@pytest.fixture
def parameters(qtbot: QtBot) -> ParametersDriver:
    parameters = ParametersDriver(qtbot)
    parameters.load(SPECS)
    return parameters


# --- Tasks and search -------------------------------------------------------------------


def test_first_value_is_selected_once_a_board_is_read(qtbot: QtBot) -> None:
    parameters = ParametersDriver(qtbot)
    assert not parameters.has("noParameterMatches")
    assert not parameters.is_enabled("parameterSearch")
    assert parameters.current == ""
    parameters.table.show_parameter("serial_timeout")
    parameters.press(Qt.Key.Key_Return)
    assert parameters.current == ""

    parameters.load(SPECS)
    assert [heading.data(ParameterRole.GROUP) for heading in parameters.headings] == TASKS
    assert parameters.current == FIRST
    assert parameters.view.verticalScrollBar().value() == 0, "the first heading is visible"


@pytest.mark.parametrize("width", [706, 1200, 3800])  # 706: 1024×600 with the demo panel
def test_no_value_is_cut_off(parameters: ParametersDriver, width: int) -> None:
    parameters.table.resize(width, 350)
    view = parameters.view
    for key, wire in (
        ("motor1_acceleration", 116),
        ("motor2_acceleration", 116),
        ("required_channels", 31),
        ("uart_settings", LineSettings(115200, stop_bits=2).to_wire()),
    ):
        parameters.model.edit(key, wire)
        parameters.go_to(key)
        cell = parameters.cell(key)
        assert view.sizeHintForIndex(cell).width() <= view.visualRect(cell).width(), key
    assert view.horizontalScrollBar().maximum() == 0
    character = view.fontMetrics().averageCharWidth()
    assert 20 * character <= view.columnWidth(ParameterColumn.NAME) <= 44 * character


def test_search_retains_the_selection(parameters: ParametersDriver) -> None:
    parameters.go_to("required_channels")
    parameters.search("timeout")
    assert parameters.current == "serial_timeout"
    assert [heading.data() for heading in parameters.headings] == ["Serial"]
    parameters.search("flux")
    assert parameters.current == ""
    assert not parameters.has("parameterTitle")
    parameters.search("")
    assert parameters.current == "required_channels"

    parameters.search("timeout")
    parameters.click_cell("serial_timeout", ParameterColumn.NAME)
    parameters.search("")
    assert parameters.current == "serial_timeout"
    parameters.load(SPECS)
    assert parameters.current == "serial_timeout"


def test_hidden_parameters_are_counted_and_can_be_shown(parameters: ParametersDriver) -> None:
    assert not parameters.has("noParameterMatches")
    parameters.search("flux capacitor")
    assert parameters.has("noParameterMatches")
    parameters.search("")
    parameters.find(QTabBar, "parameterChoice").setCurrentIndex(ParameterChoice.CHANGED)
    assert parameters.has("noParameterMatches")
    parameters.click("showAllParameters")
    assert not parameters.has("noParameterMatches")
    parameters.model.edit("motor2_current_limit", 9)
    choice = parameters.find(QTabBar, "parameterChoice")
    texts = [choice.tabText(entry) for entry in ParameterChoice]
    assert texts == ["All", "Changed 1", "Not default 1", "Findings 0"]

    parameters.search("motor")
    parameters.table.show_parameter("serial_timeout")
    assert parameters.current == "serial_timeout"
    assert parameters.text("parameterTitle") == "Serial Timeout"


def test_parameter_missing_in_older_firmware_is_deselected(parameters: ParametersDriver) -> None:
    parameters.go_to("uart_response_delay")
    parameters.load(OLDER)
    assert parameters.current == FIRST


# --- Reset to the default ---------------------------------------------------------------


def test_reset_restores_the_default(parameters: ParametersDriver) -> None:
    parameters.go_to("serial_timeout")
    assert not parameters.is_enabled("resetParameterButton")

    parameters.load(SPECS, serial_timeout=15)
    resets: tuple[Callable[[], None], ...] = (
        lambda: parameters.click("resetParameterButton"),
        lambda: parameters.press(Qt.Key.Key_Backspace, CONTROL),
    )
    for reset in resets:
        parameters.go_to("serial_timeout")
        parameters.focus_view()
        reset()
        assert dict(parameters.model.values.pending) == {"serial_timeout": 0}
        assert parameters.draft.undo.undoText() == "Serial Timeout"
        parameters.draft.undo.undo()

    parameters.table.set_rows_enabled(False)
    parameters.press(Qt.Key.Key_Backspace, CONTROL)
    assert not parameters.is_enabled("resetParameterButton")
    assert not parameters.model.values.pending, "disabled rows cannot be reset"


def test_finding_is_accepted_only_while_rows_are_enabled(parameters: ParametersDriver) -> None:
    parameters.open_file(SPECS, ignored_channels=1, required_channels=1)
    parameters.find(QTabBar, "parameterChoice").setCurrentIndex(ParameterChoice.WITH_FINDINGS)
    parameters.wait(lambda: parameters.has("parameterFinding0"))
    assert parameters.current == "required_channels"
    assert "Set Required Channels to none." in parameters.text("parameterFinding0")
    parameters.table.set_rows_enabled(False)
    assert not parameters.is_enabled("parameterAccept0")
    parameters.table.set_rows_enabled(True)
    parameters.click("parameterAccept0")
    assert parameters.model.values.value_of("required_channels") == 0


# --- Keys and mouse ---------------------------------------------------------------------


def test_arrow_keys_go_from_value_to_value(parameters: ParametersDriver) -> None:
    keys = Qt.Key
    visited = []
    for key in (
        *(keys.Key_Left, keys.Key_Up, keys.Key_Right, keys.Key_Down, keys.Key_Down),
        *(keys.Key_Right, keys.Key_Down, keys.Key_Left, keys.Key_Left),
    ):
        parameters.press(key)
        visited.append(parameters.current)
    assert visited == [
        *(FIRST, FIRST, "motor2_acceleration", "aux_acceleration", "motor_mode"),
        *("motor_mode", "motor2_deadband_brake_pwm"),
        *("motor1_deadband_brake_pwm", "motor1_deadband_brake_pwm"),
    ]


def test_tab_keys_edit_each_value_in_both_directions(parameters: ParametersDriver) -> None:
    parameters.open_with_keys(FIRST)
    visited = []
    for key in (*[Qt.Key.Key_Tab] * 4, *[Qt.Key.Key_Backtab] * 5):
        QTest.keyClick(parameters.editor(parameters.current), key)
        visited.append(parameters.current)
    forward = ["motor2_acceleration", "aux_acceleration", "motor_mode"]
    last = "motor1_deadband_brake_pwm"
    assert visited == [*forward, last, *reversed(forward), FIRST, FIRST]


def test_keys_edit_and_search(parameters: ParametersDriver) -> None:
    parameters.go_to("device_number")
    parameters.press(Qt.Key.Key_Down)
    parameters.press(Qt.Key.Key_Return)
    editor = parameters.editor("serial_timeout")
    QTest.keyClicks(editor, "2 s")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    parameters.wait_for_value("serial_timeout", 20)

    parameters.go_to(FIRST)
    parameters.focus_view()
    parameters.press(Qt.Key.Key_F, CONTROL)
    search = parameters.find(QLineEdit, "parameterSearch")
    assert search.hasFocus()
    QTest.keyClicks(search, "serial")
    assert parameters.current == "serial_timeout", "names are matched before descriptions"
    QTest.keyClick(search, Qt.Key.Key_Return)
    assert parameters.view.hasFocus()
    QTest.keyClicks(parameters.view, "3")
    QTest.keyClick(parameters.editor("serial_timeout"), Qt.Key.Key_Return)
    parameters.wait_for_value("serial_timeout", 30)


def test_name_opens_its_editor_and_a_heading_opens_none(parameters: ParametersDriver) -> None:
    for key in ("serial_timeout", "motor1_current_limit"):
        parameters.open_with_mouse(key, ParameterColumn.NAME)
        assert parameters.current == key
        parameters.close_editor(key)
    parameters.click_cell("motor1_current_limit")
    place = parameters.place_of(parameters.headings[1])
    QTest.mouseClick(parameters.view.viewport(), LEFT, pos=place)
    QTest.keyClicks(parameters.view, "30")
    assert not parameters.is_editing("motor1_current_limit")
    assert parameters.current == ""
    parameters.press(Qt.Key.Key_Down)
    assert parameters.current


def test_arrow_keys_scroll_to_the_first_heading(parameters: ParametersDriver) -> None:
    parameters.table.resize(900, 300)
    parameters.go_to("uart_settings")
    assert parameters.view.verticalScrollBar().value() > 0
    for _ in parameters.model.rows:
        parameters.press(Qt.Key.Key_Up)
    assert parameters.current == FIRST
    assert parameters.view.verticalScrollBar().value() == 0


# --- Context menu -----------------------------------------------------------------------


def request_menu(parameters: ParametersDriver, index: QModelIndex) -> QMenu:
    """Request the menu of a row with the mouse."""
    place = parameters.place_of(index)
    viewport = parameters.view.viewport()
    mouse = QContextMenuEvent.Reason.Mouse
    event = QContextMenuEvent(mouse, place, viewport.mapToGlobal(place))
    QCoreApplication.sendEvent(viewport, event)
    return parameters.find(QMenu, "parameterMenu")


def menu_of(parameters: ParametersDriver, key: str) -> dict[str, QAction]:
    """Open the menu of a row. Return its visible actions by name."""
    menu = request_menu(parameters, parameters.model.index_of(key))
    assert menu.isVisible()
    menu.close()
    visible = (action for action in menu.actions() if action.isVisible())
    return {action.objectName(): action for action in visible if action.objectName()}


@with_menu
def test_menu_entries_describe_their_effect(parameters: ParametersDriver) -> None:
    parameters.go_to("serial_timeout")
    corner = parameters.view.pos()
    keyboard = QContextMenuEvent.Reason.Keyboard
    event = QContextMenuEvent(keyboard, corner, parameters.view.mapToGlobal(corner))
    QCoreApplication.sendEvent(parameters.view, event)
    menu = parameters.find(QMenu, "parameterMenu")
    assert menu.isVisible()
    menu.close()
    assert parameters.current == "serial_timeout", "the menu key does not change the current row"

    parameters.go_to("device_number")
    parameters.model.edit("serial_timeout", 15)
    actions = menu_of(parameters, "serial_timeout")
    assert parameters.current == "serial_timeout"
    assert actions["resetParameter"].text() == "Reset to default: 0 (off)"
    assert actions["copyParameter"].text() == "Copy as “serial_timeout: 15”"
    assert "leaveOutParameter" not in actions
    unchanged = menu_of(parameters, "device_number")
    assert not unchanged["resetParameter"].isEnabled()
    assert not unchanged["restoreParameter"].isEnabled()
    assert not request_menu(parameters, parameters.headings[0]).isVisible(), "a heading has no menu"


@with_menu
def test_menu_edits_resets_restores_and_copies(parameters: ParametersDriver) -> None:
    parameters.load(SPECS, serial_timeout=5)
    menu_of(parameters, "serial_timeout")["resetParameter"].trigger()
    assert dict(parameters.model.values.pending) == {"serial_timeout": 0}
    menu_of(parameters, "serial_timeout")["restoreParameter"].trigger()
    assert not parameters.model.values.pending
    menu_of(parameters, "serial_timeout")["copyParameter"].trigger()
    assert QGuiApplication.clipboard().text() == "serial_timeout: 5"
    menu_of(parameters, "serial_timeout")["editParameter"].trigger()
    assert parameters.is_editing("serial_timeout")


# --- Both motors ------------------------------------------------------------------------


def test_both_motors_are_edited_as_one(parameters: ParametersDriver, qtbot: QtBot) -> None:
    parameters.click("bothMotors")
    editor = parameters.open_with_mouse("motor1_current_limit")
    QTest.keyClicks(editor, "2 A")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    parameters.wait_for_value("motor2_current_limit", 25)
    assert parameters.draft.undo.count() == 1
    parameters.go_to("motor2_current_limit")
    parameters.click("resetParameterButton")
    assert not parameters.model.values.pending

    reopened = ParametersDriver(qtbot)
    assert reopened.find(QCheckBox, "bothMotors").isChecked(), "the box is remembered"
    assert reopened.model.both_motors

    parameters.click("bothMotors")
    parameters.model.edit("motor1_current_limit", 25)
    assert parameters.model.values.value_of("motor2_current_limit") == 0


# --- Help and painting ------------------------------------------------------------------


def test_rows_of_every_kind_are_painted(parameters: ParametersDriver) -> None:
    """A painting error is a Qt warning, which fails the test."""
    parameters.model.edit("motor1_acceleration", 4)
    parameters.go_to("motor1_acceleration")
    cell = parameters.view.visualRect(parameters.cell(FIRST))
    parameters.focus_view()
    focused = parameters.view.viewport().grab(cell).toImage()
    parameters.find(QWidget, "parameterSearch").setFocus()
    assert parameters.view.viewport().grab(cell).toImage() != focused, "the frame disappears"
    assert not parameters.table.grab().isNull()
    parameters.table.set_rows_enabled(False)
    assert not parameters.table.grab().isNull()
    parameters.open_file(SPECS, serial_timeout=5)
    assert not parameters.table.grab().isNull()
