"""The parameter table: groups, the way back to defaults, both motors, with mouse and keys."""

import pytest
from PySide6.QtCore import QCoreApplication, QModelIndex, Qt
from PySide6.QtGui import QAction, QContextMenuEvent, QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QComboBox, QLabel, QLineEdit, QMenu, QPushButton, QWidget
from pytestqt.qtbot import QtBot

from tests.views.parameters import Person
from trex_gui.model.parameters import Column, Role
from trex_gui.protocol.parameters import parameters_of

SPECS = parameters_of("trexjr", "1.2")
OLDER = parameters_of("trexjr", "1.0")

with_menu = pytest.mark.qt_log_ignore("This plugin does not support", extend=True)
"""Of the offscreen platform, where a menu is opened."""


@pytest.fixture
def person(qtbot: QtBot) -> Person:
    person = Person(qtbot)
    person.load(SPECS)
    return person


def headings(person: Person) -> list[QModelIndex]:
    return [person.rows.index(row, 0) for row in range(person.rows.rowCount())]


def open_groups(person: Person) -> list[str]:
    return [h.data(Role.GROUP) for h in headings(person) if person.view.isExpanded(h)]


def search(person: Person, words: str) -> None:
    person.find(QLineEdit, "parameterSearch").setText(words)


def help_text(person: Person) -> str:
    return person.find(QLabel, "parameterHelp").text()


# --- Groups -----------------------------------------------------------------------------


def test_groups_are_open_at_first_and_their_headings_span_the_columns(person: Person) -> None:
    assert open_groups(person) == ["motors", "channels", "serial"]
    for heading in headings(person):
        assert person.view.isFirstColumnSpanned(heading.row(), QModelIndex())
    assert person.table.current_key == "motor1_deadband_brake_pwm"


def test_a_closed_group_stays_closed_when_the_board_is_read_again(person: Person) -> None:
    person.view.collapse(headings(person)[1])
    person.go_to("serial_timeout")
    person.load(SPECS)
    assert open_groups(person) == ["motors", "serial"]
    assert person.table.current_key == "serial_timeout"
    assert person.view.currentIndex().column() == Column.VALUE


def test_closing_a_group_leaves_the_heading_as_current_row(person: Person) -> None:
    person.go_to("serial_timeout")
    person.view.collapse(headings(person)[2])
    assert person.view.currentIndex() == headings(person)[2]
    person.model.edit("device_number", 9)
    assert open_groups(person) == ["motors", "channels"]
    assert "Serial (6, 1 modified)" in help_text(person)
    person.load(SPECS)
    assert person.view.currentIndex() == headings(person)[2]


def test_a_search_opens_every_group_and_its_end_closes_them_again(person: Person) -> None:
    person.view.collapse(headings(person)[0])
    person.view.collapse(headings(person)[2])
    search(person, "motor")
    assert open_groups(person) == [h.data(Role.GROUP) for h in headings(person)]
    search(person, "")
    assert open_groups(person) == ["channels"]
    for heading in headings(person):
        assert person.view.isFirstColumnSpanned(heading.row(), QModelIndex())


def test_a_heading_that_comes_back_is_open_and_spanned(person: Person) -> None:
    search(person, "timeout")
    search(person, "")
    assert open_groups(person) == ["motors", "channels", "serial"]
    assert all(person.view.isFirstColumnSpanned(row, QModelIndex()) for row in range(3))


def test_the_current_row_comes_back_after_a_search(person: Person) -> None:
    person.go_to("required_channels")
    search(person, "timeout")
    assert person.table.current_key == "serial_timeout"
    search(person, "flux")
    assert person.table.current_key == ""
    assert help_text(person) == ""
    search(person, "")
    assert person.table.current_key == "required_channels"


def test_a_row_that_was_found_stays_in_sight_after_the_search(person: Person) -> None:
    person.view.collapse(headings(person)[2])
    search(person, "timeout")
    person.click("serial_timeout", Column.NAME)
    search(person, "")
    assert person.table.current_key == "serial_timeout"
    assert open_groups(person) == ["motors", "channels", "serial"]
    person.load(SPECS)
    assert "serial" in open_groups(person)


def test_a_group_closed_by_hand_is_not_opened_to_find_a_first_row(person: Person) -> None:
    person.go_to("uart_response_delay")
    person.view.collapse(headings(person)[0])
    person.load(OLDER)
    assert person.view.currentIndex() == headings(person)[0]
    assert open_groups(person) == ["channels", "serial"]


def test_the_first_heading_is_in_sight_at_first(person: Person) -> None:
    assert person.view.verticalScrollBar().value() == 0


def test_where_no_row_matches_a_button_shows_all(person: Person) -> None:
    nothing = person.find(QWidget, "noParameterMatches")
    assert not nothing.isVisible()
    search(person, "flux capacitor")
    person.find(QCheckBox, "modifiedOnly").setChecked(True)
    assert nothing.isVisible()
    button = person.find(QPushButton, "showAllParameters")
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    assert not nothing.isVisible()
    assert person.rows.shown == len(SPECS.readable)


def test_before_a_board_there_is_nothing_to_search(qtbot: QtBot) -> None:
    person = Person(qtbot)
    assert not person.find(QWidget, "noParameterMatches").isVisible()
    assert not person.find(QLineEdit, "parameterSearch").isEnabled()
    assert person.table.current_key == ""
    person.table.show_parameter("serial_timeout")
    person.press(Qt.Key.Key_Return)
    assert person.table.current_key == ""


def test_the_groups_to_choose_from_are_those_of_the_board(person: Person) -> None:
    group = person.find(QComboBox, "parameterGroup")
    assert [group.itemData(i) for i in range(group.count())] == ["", "motors", "channels", "serial"]
    group.setCurrentIndex(group.findData("serial"))
    person.load(OLDER)
    assert group.currentData() == "serial"
    assert len(headings(person)) == 1


def test_a_parameter_is_shown_whatever_was_narrowed_down(person: Person) -> None:
    person.view.collapse(headings(person)[2])
    search(person, "motor")
    person.table.show_parameter("serial_timeout")
    assert person.table.current_key == "serial_timeout"
    assert person.view.isExpanded(headings(person)[2])
    assert "Serial Timeout" in help_text(person)


def test_a_current_parameter_that_an_older_board_lacks_gives_way(person: Person) -> None:
    person.go_to("uart_response_delay")
    person.load(OLDER)
    assert person.table.current_key == "motor1_deadband_brake_pwm"


# --- Back to the default ----------------------------------------------------------------


def test_one_click_goes_back_to_the_default_and_undo_takes_that_back(person: Person) -> None:
    person.load(SPECS, serial_timeout=15)
    person.click("serial_timeout", Column.RESET)
    assert dict(person.model.pending) == {"serial_timeout": 0}
    assert person.draft.undo.undoText() == "Serial Timeout"
    person.draft.undo.undo()
    assert not person.model.pending


def test_a_click_where_nothing_differs_does_nothing(person: Person) -> None:
    person.click("serial_timeout", Column.RESET)
    person.click("serial_timeout", Column.DEFAULT)
    assert not person.draft.undo.canUndo()


def test_greyed_rows_cannot_be_reset(person: Person) -> None:
    person.load(SPECS, serial_timeout=15)
    person.table.set_rows_enabled(False)
    person.click("serial_timeout", Column.RESET)
    QTest.keyClick(person.view, Qt.Key.Key_Backspace, Qt.KeyboardModifier.ControlModifier)
    assert not person.model.pending


@pytest.mark.parametrize("key", [Qt.Key.Key_Return, Qt.Key.Key_Space])
def test_keys_alone_reach_the_way_back(person: Person, key: Qt.Key) -> None:
    person.load(SPECS, serial_timeout=15)
    person.go_to("serial_timeout")
    person.press(Qt.Key.Key_Right)
    assert person.view.currentIndex().column() == Column.RESET
    person.press(key)
    assert dict(person.model.pending) == {"serial_timeout": 0}
    person.press(Qt.Key.Key_Left)
    assert person.view.currentIndex().column() == Column.VALUE


def test_ctrl_backspace_resets_the_current_row(person: Person) -> None:
    person.load(SPECS, serial_timeout=15)
    person.go_to("serial_timeout")
    person.table.activateWindow()
    person.view.setFocus()
    person.qtbot.waitUntil(person.view.hasFocus)
    QTest.keyClick(person.view, Qt.Key.Key_Backspace, Qt.KeyboardModifier.ControlModifier)
    assert dict(person.model.pending) == {"serial_timeout": 0}


# --- Keys -------------------------------------------------------------------------------


def test_keys_alone_walk_close_open_and_edit(person: Person) -> None:
    person.view.setCurrentIndex(headings(person)[2])
    person.press(Qt.Key.Key_Space)
    assert open_groups(person) == ["motors", "channels"]
    person.press(Qt.Key.Key_Return)
    person.press(Qt.Key.Key_Down)
    assert person.table.current_key == "device_number"
    person.press(Qt.Key.Key_Down)
    person.press(Qt.Key.Key_Return)
    editor = person.editor("serial_timeout")
    QTest.keyClicks(editor, "2 s")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    person.wait_for_value("serial_timeout", 20)
    person.press(Qt.Key.Key_Up)
    person.press(Qt.Key.Key_Up)
    assert person.view.currentIndex().data(Role.GROUP) == "serial"


@pytest.mark.parametrize("column", [Column.NAME, Column.WIRE, Column.RESET, Column.EFFECT])
def test_f2_edits_the_value_wherever_in_the_row_one_is(person: Person, column: Column) -> None:
    person.go_to("serial_timeout", column)
    person.press(Qt.Key.Key_F2)
    assert person.is_editing("serial_timeout")


@pytest.mark.parametrize("column", [Column.NAME, Column.DEFAULT, Column.SOURCE])
def test_a_double_click_anywhere_in_a_row_edits_its_value(person: Person, column: Column) -> None:
    person.open_with_mouse("serial_timeout", column)
    assert person.view.currentIndex().column() == Column.VALUE


def test_the_search_takes_the_focus(person: Person) -> None:
    person.table.activateWindow()
    person.view.setFocus()
    person.qtbot.waitUntil(person.view.hasFocus)
    QTest.keyClick(person.view, Qt.Key.Key_F, Qt.KeyboardModifier.ControlModifier)
    assert person.find(QLineEdit, "parameterSearch").hasFocus()


# --- Context menu -----------------------------------------------------------------------


def ask_for_menu(person: Person, index: QModelIndex) -> QMenu:
    """Press the right button of the mouse on a row."""
    place = person.place_of(index)
    viewport = person.view.viewport()
    mouse = QContextMenuEvent.Reason.Mouse
    QCoreApplication.sendEvent(
        viewport, QContextMenuEvent(mouse, place, viewport.mapToGlobal(place))
    )
    menu = person.view.findChild(QMenu, "parameterMenu")
    assert menu is not None
    return menu


def menu_of(person: Person, key: str) -> dict[str, QAction]:
    """Ask for the menu of a row; return what can be seen in it, by name."""
    menu = ask_for_menu(person, person.rows.index_of(key))
    assert menu.isVisible()
    menu.close()
    return {a.objectName(): a for a in menu.actions() if a.isVisible() and a.objectName()}


@with_menu
def test_the_menu_key_asks_for_the_menu_of_the_current_row(person: Person) -> None:
    person.go_to("serial_timeout", Column.WIRE)
    keyboard = QContextMenuEvent.Reason.Keyboard
    corner = person.view.pos()
    event = QContextMenuEvent(keyboard, corner, person.view.mapToGlobal(corner))
    QCoreApplication.sendEvent(person.view, event)
    menu = person.view.findChild(QMenu, "parameterMenu")
    assert menu is not None
    assert menu.isVisible()
    menu.close()
    assert person.table.current_key == "serial_timeout"


@with_menu
def test_the_menu_says_what_it_would_do(person: Person) -> None:
    person.model.edit("serial_timeout", 15)
    actions = menu_of(person, "serial_timeout")
    assert person.table.current_key == "serial_timeout"
    assert actions["resetParameter"].text() == "Back to default: 0 (off)"
    assert actions["restoreParameter"].text() == "Back to what is stored: 0 (off)"
    assert actions["copyParameter"].text() == "Copy as “serial_timeout: 15”"
    assert "leaveOutParameter" not in actions
    assert "copyToTwin" not in actions
    unchanged = menu_of(person, "device_number")
    assert not unchanged["resetParameter"].isEnabled()
    assert not unchanged["restoreParameter"].isEnabled()


@with_menu
def test_the_menu_edits_resets_restores_and_copies(person: Person) -> None:
    person.load(SPECS, serial_timeout=5)
    menu_of(person, "serial_timeout")["resetParameter"].trigger()
    assert dict(person.model.pending) == {"serial_timeout": 0}
    menu_of(person, "serial_timeout")["restoreParameter"].trigger()
    assert not person.model.pending
    menu_of(person, "serial_timeout")["copyParameter"].trigger()
    assert QGuiApplication.clipboard().text() == "serial_timeout: 5"
    menu_of(person, "serial_timeout")["editParameter"].trigger()
    assert person.is_editing("serial_timeout")


@with_menu
def test_the_menu_gives_the_other_motor_the_same(person: Person) -> None:
    person.model.edit("motor1_current_limit", 25)
    actions = menu_of(person, "motor1_current_limit")
    assert actions["copyToTwin"].text() == "Give Motor 2 the same"
    actions["copyToTwin"].trigger()
    assert person.model.value_of("motor2_current_limit") == 25
    assert not menu_of(person, "motor1_current_limit")["copyToTwin"].isEnabled()


def test_a_heading_has_no_menu(person: Person) -> None:
    assert not ask_for_menu(person, headings(person)[0]).isVisible()


@with_menu
def test_a_file_can_leave_a_parameter_out(person: Person) -> None:
    person.open_file(SPECS, serial_timeout=5, motor1_current_limit=10)
    actions = menu_of(person, "serial_timeout")
    assert actions["leaveOutParameter"].text() == "Leave out of the file"
    actions["leaveOutParameter"].trigger()
    assert person.rows.index_of("serial_timeout").data() == "not given"
    assert person.draft.pending == 1
    assert not menu_of(person, "serial_timeout")["copyParameter"].isEnabled()
    assert "leaveOutParameter" not in menu_of(person, "serial_timeout")
    person.draft.undo.undo()
    assert person.rows.index_of("serial_timeout").data() == "0.5 s"


# --- Both motors ------------------------------------------------------------------------


def test_both_motors_are_edited_as_one_while_the_box_is_ticked(person: Person) -> None:
    QTest.mouseClick(person.find(QCheckBox, "bothMotors"), Qt.MouseButton.LeftButton)
    editor = person.open_with_mouse("motor1_current_limit")
    QTest.keyClicks(editor, "2 A")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    person.wait_for_value("motor2_current_limit", 25)
    assert person.draft.undo.count() == 1
    person.click("motor2_current_limit", Column.RESET)
    assert not person.model.pending
    person.find(QCheckBox, "bothMotors").setChecked(False)
    person.model.edit("motor1_current_limit", 25)
    assert person.model.value_of("motor2_current_limit") == 0


def test_the_box_is_remembered(person: Person, qtbot: QtBot) -> None:
    person.find(QCheckBox, "bothMotors").setChecked(True)
    other = Person(qtbot)
    assert other.find(QCheckBox, "bothMotors").isChecked()
    assert other.model.both_motors


# --- Help -------------------------------------------------------------------------------


def test_the_help_tells_limits_source_and_the_other_motor(person: Person) -> None:
    person.go_to("motor1_current_limit")
    for text in ("0x13", "off to 10.16 A", "Default: 0 (off)", "the board has the last word"):
        assert text in help_text(person)
    assert "Motor 2" not in help_text(person)
    person.model.edit("motor2_current_limit", 25)
    assert "Motor 2 differs: 2 A." in help_text(person)


def test_the_help_follows_edits_and_power_cycles(person: Person) -> None:
    person.go_to("motor_mode")
    assert "switched off and on" in help_text(person)
    person.model.edit("motor_mode", 1)
    assert "Stored: 0 (independent)" in help_text(person)


def test_every_row_of_every_kind_is_painted(person: Person) -> None:
    """A picture of marked, inferred, greyed and current rows; a fault in painting is a warning."""
    person.model.edit("motor1_acceleration", 4)
    person.go_to("motor1_acceleration", Column.RESET)
    assert not person.table.grab().isNull()
    person.table.set_rows_enabled(False)
    assert not person.table.grab().isNull()
    person.open_file(SPECS, serial_timeout=5)
    assert not person.table.grab().isNull()
