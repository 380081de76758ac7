"""Every parameter of every board in its editor."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QSpinBox, QToolButton, QWidget
from pytestqt.qtbot import QtBot

from tests.devices.trex.views.parameters import ParametersDriver
from tests.support.window import WidgetDriver
from trex_gui.devices.trex.model.parameters.text import ParameterColumn
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import channels_in
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKind, ParameterSpec, parameters_of
from trex_gui.devices.trex.views.count_editor import UnitSpinBox
from trex_gui.devices.trex.views.pages.parameters.editors import AccelerationEditor

BOARDS = [(model.key, version) for model in device_table().models for version in model.firmware]
SPECS = parameters_of("trexjr", "1.2")


@pytest.fixture
def parameters(qtbot: QtBot) -> ParametersDriver:
    parameters = ParametersDriver(qtbot)
    parameters.load(SPECS)
    return parameters


def values_to_try(spec: ParameterSpec) -> list[int]:
    """Return a middle, the lowest and the highest value. Each differs from its predecessor."""
    valid = sorted(spec.valid)
    changed = [wire for wire in valid if wire != spec.default]
    values = [changed[len(changed) // 2], valid[0], valid[-1]]
    previous = [spec.default, *values]
    return [wire for wire, before in zip(values, previous, strict=False) if wire != before]


def type_number(editor: QWidget, text: str) -> None:
    assert isinstance(editor, QSpinBox)
    editor.selectAll()
    QTest.keyClicks(editor, text)
    QTest.keyClick(editor, Qt.Key.Key_Return)


def select(combo: QComboBox, index: int) -> None:
    """Select an entry with the arrow keys."""
    while combo.currentIndex() != index:
        before = combo.currentIndex()
        down = combo.currentIndex() < index
        QTest.keyClick(combo, Qt.Key.Key_Down if down else Qt.Key.Key_Up)
        assert combo.currentIndex() != before


def check_channels(editor: WidgetDriver, wire: int) -> None:
    for channel in range(1, 6):
        name = f"channel{channel}Box"
        if editor.button(name).isChecked() != (channel in channels_in(wire)):
            editor.click(name)


def select_line_settings(editor: WidgetDriver, wire: int) -> None:
    settings = LineSettings.from_wire(wire)
    for name, data in (
        ("baudField", settings.baud),
        ("detectionField", settings.detection),
        ("stopBitsField", settings.stop_bits),
    ):
        field = editor.combo(name)
        select(field, field.findData(data))


def enter(editor: WidgetDriver, spec: ParameterSpec, wire: int) -> None:
    """Enter a wire value with mouse and keys."""
    match spec.kind:
        case ParameterKind.CHOICE:
            assert isinstance(editor.root, QComboBox)
            select(editor.root, editor.root.findData(wire))
        case ParameterKind.CHANNELS:
            check_channels(editor, wire)
        case ParameterKind.UART:
            select_line_settings(editor, wire)
        case _:
            type_number(editor.root, spec.text(wire))


on_each_board = pytest.mark.parametrize(
    ("model_key", "firmware"),
    [*(pytest.param(*board, marks=pytest.mark.slow) for board in BOARDS[:-1]), BOARDS[-1]],
)


@on_each_board
def test_each_parameter_accepts_its_extreme_values(
    qtbot: QtBot, model_key: str, firmware: str
) -> None:
    parameters = ParametersDriver(qtbot)
    parameters.load(parameters_of(model_key, firmware))
    for spec in parameters_of(model_key, firmware).readable:
        if spec.key.startswith(("motor1_pwm", "motor2_pwm")):
            continue  # edited as a frequency
        for number, wire in enumerate(values_to_try(spec)):
            open_editor = parameters.open_with_mouse if number % 2 else parameters.open_with_keys
            enter(WidgetDriver(open_editor(spec.key), qtbot), spec, wire)
            parameters.wait_for_value(spec.key, wire)
            expected = () if wire == spec.default else ((spec.key, wire),)
            assert parameters.model.values.pending == expected
            if parameters.is_editing(spec.key):
                parameters.close_editor(spec.key)
        parameters.model.restore(spec.key)
    assert not parameters.rejected


def test_rejected_input_is_marked_until_it_is_valid(parameters: ParametersDriver) -> None:
    editor = parameters.open_with_mouse("serial_timeout")
    assert isinstance(editor, UnitSpinBox)
    (icon,) = editor.findChildren(QToolButton)
    assert not icon.isVisible()
    type_number(editor, "99999")
    assert icon.isVisible()
    assert editor.problem == parameters.rejected[-1]
    QTest.keyClick(editor, Qt.Key.Key_Backspace)
    assert editor.problem
    editor.selectAll()
    QTest.keyClicks(editor, "2")
    assert not editor.problem
    assert not icon.isVisible()


@pytest.mark.parametrize("key", [Qt.Key.Key_Tab, Qt.Key.Key_Backtab])
def test_tab_keys_do_not_leave_invalid_input(parameters: ParametersDriver, key: Qt.Key) -> None:
    editor = parameters.open_with_keys("serial_timeout")
    QTest.keyClicks(editor, "99999")
    QTest.keyClick(editor, key)
    assert parameters.editor("serial_timeout") is editor
    assert isinstance(editor, UnitSpinBox)
    assert editor.problem == parameters.rejected[-1]
    assert editor.text() == "99999"


def test_marked_input_is_painted_completely(parameters: ParametersDriver) -> None:
    editor = parameters.open_with_mouse("serial_timeout")
    assert isinstance(editor, UnitSpinBox)

    def painted() -> QImage:
        QApplication.processEvents()
        return editor.screen().grabWindow(parameters.table.winId()).toImage()

    editor.selectAll()
    QTest.keyClicks(editor, "12 kg")
    unmarked = painted()
    QTest.keyClick(editor, Qt.Key.Key_Return)
    marked = painted()
    editor.lineEdit().repaint()
    assert unmarked != marked == painted()


def test_keys_change_a_number(parameters: ParametersDriver) -> None:
    editor = parameters.open_with_keys("serial_timeout")
    for key in (Qt.Key.Key_Up, Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_Return):
        QTest.keyClick(editor, key)
    parameters.wait_for_value("serial_timeout", 1)
    parameters.wait_for_no_editor("serial_timeout")

    parameters.go_to("serial_timeout")
    QTest.keyClicks(parameters.view, "1")
    editor = parameters.editor("serial_timeout")
    QTest.keyClicks(editor, ".5 s")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    parameters.wait_for_value("serial_timeout", 15)
    parameters.wait_for_no_editor("serial_timeout")

    editor = parameters.open_with_mouse("serial_timeout")
    QTest.keyClicks(editor, "5")
    parameters.close_editor("serial_timeout")
    assert parameters.model.values.value_of("serial_timeout") == 15, "Escape restores the value"


def test_number_typed_after_a_click_retains_its_first_digit(
    parameters: ParametersDriver, qapp: QApplication
) -> None:
    parameters.go_to("serial_timeout")
    before = qapp.doubleClickInterval()
    qapp.setDoubleClickInterval(10)
    parameters.click_cell("serial_timeout")
    QTest.keyClicks(parameters.view, "0")
    QTest.qWait(30)  # a second click would open the editor
    qapp.setDoubleClickInterval(before)
    editor = parameters.editor("serial_timeout")
    QTest.keyClicks(editor, ".8 s")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    parameters.wait_for_value("serial_timeout", 8)


def test_arrows_of_acceleration_step_through_the_times(parameters: ParametersDriver) -> None:
    """The up arrow selects a longer time. No step leads from the longest time to no ramp."""
    editor = parameters.open_with_keys("motor1_acceleration")
    assert isinstance(editor, AccelerationEditor)
    for start, steps, wire in (
        (10, 1, 9),
        (10, -1, 11),
        (2, 10, 1),
        (1, 1, 1),
        (126, -1, 127),
        (127, -1, 0),
        (0, 1, 127),
        (0, -1, 0),
    ):
        editor.setValue(start)
        editor.stepBy(steps)
        assert editor.value() == wire, (start, steps)


def test_frequency_is_rounded_to_the_nearest(parameters: ParametersDriver) -> None:
    key = "motor1_pwm_maximum"
    for typed, shown in (
        ("9766", "9766 Hz"),
        ("5 kHz", "5040 Hz"),
        ("0,3khz", "296 Hz"),
        ("76", "76 Hz"),
        ("10000 hz", "10000 Hz"),
        ("2441 Hz", "2441 Hz"),
    ):
        type_number(parameters.open_with_mouse(key), typed)
        parameters.wait_for_no_editor(key)
        assert parameters.cell(key).data() == shown, typed

    for typed in ("70", "20 kHz", "fast"):
        editor = parameters.open_with_mouse(key)
        type_number(editor, typed)
        assert isinstance(editor, UnitSpinBox)
        assert "76 Hz to 10000 Hz" in editor.problem, typed
        parameters.close_editor(key)
    assert parameters.cell(key).data() == "2441 Hz"


def test_arrow_keys_step_through_frequencies(parameters: ParametersDriver) -> None:
    for prescaler, maximum, steps, shown in (
        (1, 63, -1, "2404 Hz"),
        (3, 3, 1, "2480 Hz"),
        (0, 0, 1, "10000 Hz"),
        (9, 9, 1, "76 Hz"),
        (3, 127, -1, "76 Hz"),
    ):
        values = {"motor2_pwm_prescaler": prescaler, "motor2_pwm_maximum": maximum}
        parameters.load(SPECS, **values)
        QTest.keyClick(parameters.open_with_keys("motor2_pwm_maximum"), Qt.Key.Key_Return)
        parameters.wait_for_no_editor("motor2_pwm_maximum")
        assert not parameters.model.values.pending, "Return retains any stored frequency"
        editor = parameters.open_with_keys("motor2_pwm_maximum")
        QTest.keyClick(editor, Qt.Key.Key_Up if steps > 0 else Qt.Key.Key_Down)
        QTest.keyClick(editor, Qt.Key.Key_Return)
        parameters.wait_for_no_editor("motor2_pwm_maximum")
        assert parameters.cell("motor2_pwm_maximum").data() == shown
        parameters.model.discard_edits()


def test_editor_stays_within_the_table(parameters: ParametersDriver) -> None:
    parameters.table.resize(700, 500)
    editor = parameters.open_with_mouse("uart_settings", ParameterColumn.NAME)
    assert editor.geometry().right() < parameters.view.viewport().width()
    assert editor.width() >= editor.sizeHint().width()


# --- Parameters that are missing in a file ----------------------------------------------


@pytest.mark.qt_log_ignore("This plugin does not support", extend=True)
def test_missing_parameter_accepts_only_confirmed_values(parameters: ParametersDriver) -> None:
    parameters.open_file(SPECS, serial_timeout=5)
    keys = ("device_number", "motor_mode", "required_channels", "uart_settings")
    for key in keys:
        parameters.open_with_mouse(key)
        parameters.go_to("serial_timeout")
        parameters.wait_for_no_editor(key)
    assert not parameters.model.values.modified

    for key in keys:
        QTest.keyClick(parameters.open_with_keys(key), Qt.Key.Key_Return)
        parameters.wait_for_value(key, SPECS[key].default)
        parameters.wait_for_no_editor(key)
        parameters.draft.undo.undo()
        assert not parameters.model.values.modified, key

    combo = parameters.open_with_mouse("motor_mode")
    assert isinstance(combo, QComboBox)
    combo.showPopup()
    QTest.keyClick(combo.view(), Qt.Key.Key_Return)
    parameters.wait_for_value("motor_mode", 0)
    parameters.wait_for_no_editor("motor_mode")
    parameters.draft.undo.undo()

    editor = WidgetDriver(parameters.open_with_mouse("ignored_channels"), parameters.qtbot)
    check_channels(editor, 0b101)
    type_number(parameters.open_with_mouse("device_number"), "9")
    parameters.wait(lambda: len(parameters.model.values.pending) == 2)
    assert dict(parameters.model.values.pending) == {"ignored_channels": 5, "device_number": 9}


@pytest.mark.parametrize(
    ("key", "typed", "rounded"),
    [
        ("serial_timeout", "1.24", ["1.2 s"]),
        ("serial_timeout", "1240 ms", ["1.2 s"]),
        ("serial_timeout", "1200 ms", []),
        ("motor1_pwm_maximum", "9 kHz", ["9191 Hz"]),
        ("motor1_acceleration", "9", ["6.3 s to full speed"]),
        ("motor1_acceleration", "11 per 100 ms", []),
    ],
)
def test_rounded_value_is_reported(
    parameters: ParametersDriver, key: str, typed: str, rounded: list[str]
) -> None:
    sentences: list[str] = []
    parameters.model.rounded.connect(sentences.append)
    type_number(parameters.open_with_keys(key), typed)
    parameters.wait_for_no_editor(key)
    assert sentences == [
        f"The nearest value that the board can store is {text}." for text in rounded
    ]
