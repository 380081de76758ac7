"""Every parameter of every board, edited through its own editor as a person does."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QComboBox, QSpinBox, QWidget
from pytestqt.qtbot import QtBot

from tests.views.parameters import Person
from trex_gui.model.parameters import Column
from trex_gui.protocol.device_table import device_table
from trex_gui.protocol.flags import channels_in
from trex_gui.protocol.line_settings import LineSettings
from trex_gui.protocol.parameters import Kind, ParameterSpec, parameters_of

BOARDS = [(model.key, version) for model in device_table().models for version in model.firmware]
SPECS = parameters_of("trexjr", "1.2")


@pytest.fixture
def person(qtbot: QtBot) -> Person:
    person = Person(qtbot)
    person.load(SPECS)
    return person


def new_in(model_key: str, firmware: str) -> list[ParameterSpec]:
    """The parameters that are not the same as in an older firmware, where they were tried."""
    older = [version for key, version in BOARDS if key == model_key and version < firmware]
    tried = [spec for version in older for spec in parameters_of(model_key, version).readable]
    return [spec for spec in parameters_of(model_key, firmware).readable if spec not in tried]


def test_every_parameter_of_every_board_is_tried() -> None:
    tried = {(key, spec.key) for key, version in BOARDS for spec in new_in(key, version)}
    boards = ((key, parameters_of(key, version)) for key, version in BOARDS)
    assert tried == {(key, spec.key) for key, specs in boards for spec in specs.readable}


def values_to_try(spec: ParameterSpec) -> list[int]:
    """One between, lowest and highest, each another than the one before."""
    valid = sorted(spec.valid)
    others = [wire for wire in valid if wire != spec.default]
    wanted = [others[len(others) // 2], valid[0], valid[-1]]
    pairs = zip(wanted, [spec.default, *wanted], strict=False)
    return [wire for wire, before in pairs if wire != before]


def type_number(editor: QWidget, text: str) -> None:
    assert isinstance(editor, QSpinBox)
    editor.selectAll()
    QTest.keyClicks(editor, text)
    QTest.keyClick(editor, Qt.Key.Key_Return)


def choose(combo: QComboBox, index: int) -> None:
    """Walk to an entry with the arrow keys."""
    while combo.currentIndex() != index:
        before = combo.currentIndex()
        down = combo.currentIndex() < index
        QTest.keyClick(combo, Qt.Key.Key_Down if down else Qt.Key.Key_Up)
        assert combo.currentIndex() != before


def tick(editor: QWidget, wire: int) -> None:
    for channel in range(1, 6):
        box = editor.findChild(QCheckBox, f"channel{channel}Box")
        assert box is not None
        if box.isChecked() != (channel in channels_in(wire)):
            QTest.mouseClick(box, Qt.MouseButton.LeftButton, pos=QPoint(8, box.height() // 2))


def choose_line_settings(editor: QWidget, wire: int) -> None:
    wanted = LineSettings.from_wire(wire)
    for name, data in (
        ("baudField", wanted.baud),
        ("detectionField", wanted.detection),
        ("stopBitsField", wanted.stop_bits),
    ):
        field = editor.findChild(QComboBox, name)
        assert field is not None
        choose(field, field.findData(data))


def enter(editor: QWidget, spec: ParameterSpec, wire: int) -> None:
    """Do with mouse and keys what makes the editor mean a wire value."""
    match spec.kind:
        case Kind.CHOICE:
            assert isinstance(editor, QComboBox)
            choose(editor, editor.findData(wire))
        case Kind.CHANNELS:
            tick(editor, wire)
        case Kind.UART:
            choose_line_settings(editor, wire)
        case _:
            type_number(editor, spec.text(wire))


@pytest.mark.parametrize(
    ("model_key", "firmware"),
    [
        *(pytest.param(*board, marks=pytest.mark.slow) for board in BOARDS[:-1]),
        BOARDS[-1],
    ],
)
def test_every_parameter_takes_its_lowest_its_highest_and_another_value(
    qtbot: QtBot, model_key: str, firmware: str
) -> None:
    person = Person(qtbot)
    person.load(parameters_of(model_key, firmware))
    for spec in new_in(model_key, firmware):
        for number, wire in enumerate(values_to_try(spec)):
            opening = person.open_with_mouse if number % 2 else person.open_with_keys
            enter(opening(spec.key), spec, wire)
            person.wait_for_value(spec.key, wire)
            expected = () if wire == spec.default else ((spec.key, wire),)
            assert person.model.pending == expected
            if person.is_editing(spec.key):
                person.close_editor(spec.key)
        person.model.restore(spec.key)
    assert not person.refused


@pytest.mark.parametrize(("model_key", "firmware"), BOARDS)
def test_every_number_refuses_what_is_out_of_its_range_and_names_the_limits(
    qtbot: QtBot, model_key: str, firmware: str
) -> None:
    person = Person(qtbot)
    person.load(parameters_of(model_key, firmware))
    no_numbers = {Kind.CHOICE, Kind.CHANNELS, Kind.UART}
    for spec in new_in(model_key, firmware):
        if spec.kind not in no_numbers:
            type_number(person.open_with_mouse(spec.key), "99999")
            assert person.is_editing(spec.key)
            assert spec.text(spec.maximum) in person.refused[-1]
            assert spec.name in person.refused[-1]
            person.close_editor(spec.key)
            assert not person.model.pending


def test_a_number_goes_up_and_down_with_the_arrows(person: Person) -> None:
    editor = person.open_with_keys("serial_timeout")
    QTest.keyClick(editor, Qt.Key.Key_Up)
    QTest.keyClick(editor, Qt.Key.Key_Up)
    QTest.keyClick(editor, Qt.Key.Key_Down)
    QTest.keyClick(editor, Qt.Key.Key_Return)
    person.wait_for_value("serial_timeout", 1)


def test_a_digit_on_the_row_begins_to_type(person: Person) -> None:
    person.go_to("serial_timeout")
    QTest.keyClicks(person.view, "1")
    editor = person.editor("serial_timeout")
    QTest.keyClicks(editor, ".5 s")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    person.wait_for_value("serial_timeout", 15)


@pytest.mark.parametrize(
    ("typed", "wire"),
    [("500 ms", 25), ("3.2 s", 4), ("12.7s", 1), ("0,1 s", 127), ("100 ms", 127), ("4", 4)],
)
def test_an_acceleration_may_be_typed_as_time_to_full_speed(
    person: Person, typed: str, wire: int
) -> None:
    editor = person.open_with_mouse("motor1_acceleration")
    type_number(editor, typed)
    person.wait_for_value("motor1_acceleration", wire)


@pytest.mark.parametrize("typed", ["20 s", "10 ms", "0 s"])
def test_a_time_to_full_speed_that_cannot_be_is_refused(person: Person, typed: str) -> None:
    editor = person.open_with_mouse("motor1_acceleration")
    type_number(editor, typed)
    assert "reaches full speed in 12.7 s to 100 ms" in person.refused[-1]
    assert person.is_editing("motor1_acceleration")


def test_an_acceleration_left_as_it_is_stays(person: Person) -> None:
    for wire in (0, 1, 2, 7, 40, 41, 63, 64, 99, 101, 124, 125, 126, 127):
        person.model.edit("motor1_acceleration", wire)
        QTest.keyClick(person.open_with_keys("motor1_acceleration"), Qt.Key.Key_Return)
        person.wait_for_no_editor("motor1_acceleration")
        assert person.model.value_of("motor1_acceleration") == wire


def test_escape_leaves_the_value(person: Person) -> None:
    editor = person.open_with_mouse("serial_timeout")
    QTest.keyClicks(editor, "5")
    person.close_editor("serial_timeout")
    assert not person.model.pending


def test_an_editor_stays_within_the_table(person: Person) -> None:
    person.table.resize(700, 500)
    editor = person.open_with_mouse("uart_settings", Column.NAME)
    assert editor.geometry().right() < person.view.viewport().width()
    assert editor.width() >= editor.sizeHint().width()


# --- Where a file gives nothing ---------------------------------------------------------


def test_looking_into_what_is_not_given_gives_nothing(person: Person) -> None:
    person.open_file(SPECS, serial_timeout=5)
    for key in ("device_number", "motor_mode", "required_channels", "uart_settings"):
        person.open_with_mouse(key)
        person.go_to("serial_timeout")
        person.wait_for_no_editor(key)
    assert not person.model.modified


@pytest.mark.parametrize(
    "key", ["device_number", "motor_mode", "required_channels", "uart_settings"]
)
def test_enter_gives_the_default_that_the_editor_shows(person: Person, key: str) -> None:
    person.open_file(SPECS, serial_timeout=5)
    editor = person.open_with_keys(key)
    QTest.keyClick(editor, Qt.Key.Key_Return)
    person.wait_for_value(key, SPECS[key].default)
    person.draft.undo.undo()
    assert not person.model.modified


@pytest.mark.qt_log_ignore("This plugin does not support", extend=True)
def test_a_choice_that_is_what_stands_there_gives_it(person: Person) -> None:
    person.open_file(SPECS, serial_timeout=5)
    editor = person.open_with_mouse("motor_mode")
    assert isinstance(editor, QComboBox)
    editor.showPopup()
    QTest.keyClick(editor.view(), Qt.Key.Key_Return)
    person.wait_for_value("motor_mode", 0)


def test_ticks_and_typing_give_what_they_mean(person: Person) -> None:
    person.open_file(SPECS, serial_timeout=5)
    tick(person.open_with_mouse("ignored_channels"), 0b101)
    type_number(person.open_with_mouse("device_number"), "9")
    person.qtbot.waitUntil(lambda: len(person.model.pending) == 2)
    assert dict(person.model.pending) == {"ignored_channels": 5, "device_number": 9}
