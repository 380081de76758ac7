"""A person calibrates channels by pointing; a simulated board on a real wire behind it."""

import sys
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import pytest
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtGui import QAction, QKeyEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QCheckBox,
    QLabel,
    QLineEdit,
    QListWidget,
    QPushButton,
    QSpinBox,
    QTabBar,
    QTabWidget,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.emulator.mapping import ChannelSetup
from trex_gui.link.writing import Written
from trex_gui.model.calibration_moves import Handle
from trex_gui.model.device import Link
from trex_gui.protocol.calibration import DEFAULT_CALIBRATION, Calibration
from trex_gui.protocol.errors import Rejected, ResultCode
from trex_gui.protocol.flags import CHANNELS, InputSource
from trex_gui.views.pages.calibration.page import CalibrationPage
from trex_gui.views.theme import theme
from trex_gui.views.widgets.curve_plot import CurvePlot
from trex_gui.views.widgets.input_trace import InputTrace
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

WidgetT = TypeVar("WidgetT", bound=QWidget)
FACTORY = DEFAULT_CALIBRATION[InputSource.RC]


class Person:
    """What a person can do and see on the page, by the names of the widgets."""

    def __init__(self, program: Program, qtbot: QtBot) -> None:
        self.program = program
        self.device = program.device
        self.qtbot = qtbot
        tabs = program.window.findChild(QTabWidget, "tabs")
        page = program.window.findChild(CalibrationPage, "calibrationPage")
        assert tabs is not None
        assert page is not None
        self.page = page
        tabs.setCurrentIndex(2)

    def find(self, kind: type[WidgetT], name: str) -> WidgetT:
        widget = self.page.findChild(kind, name)
        assert isinstance(widget, kind), name
        return widget

    def text(self, name: str) -> str:
        return self.find(QLabel, name).text()

    def wait(self, condition: Callable[[], bool], timeout: int = 20_000) -> None:
        self.qtbot.waitUntil(condition, timeout=timeout)

    def connect(self, simulator: SimulatedDevice) -> "Person":
        self.program.connector.connect_to(self.program.ports.add_typed(simulator.url))
        self.wait(lambda: self.device.link is Link.UP)
        self.wait(lambda: self.device.telemetry.raw is not None)
        return self

    @property
    def plot(self) -> CurvePlot:
        return self.find(CurvePlot, "curvePlot")

    @property
    def live(self) -> str:
        return self.find(QWidget, "curveLegend").accessibleDescription()

    def beside(self) -> str:
        """The handle beside which something is said."""
        handle = self.plot.message_at
        return handle.value if handle is not None else ""

    def choose(self, channel: int) -> None:
        view = self.find(QListWidget, "calibrationChannels")
        where = view.visualItemRect(view.item(channel - 1)).center()
        QTest.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=where)
        assert self.page.channel == channel

    def row(self, channel: int) -> str:
        return self.find(QListWidget, "calibrationChannels").item(channel - 1).text()

    def pull(self, handle: Handle, count: int) -> None:
        """Take a handle and hold it at a count."""
        self.page.grab()  # lets the layout settle
        viewport = self.find(QWidget, "curveViewport")
        start = self.plot.place_of(handle).toPoint()
        end = QPoint(round(self.plot.x_of(count)), start.y())
        QTest.mousePress(viewport, Qt.MouseButton.LeftButton, pos=start)
        for step in (0.5, 1.0):
            QTest.mouseMove(viewport, start + (end - start) * step)

    def let_go(self) -> None:
        QTest.mouseRelease(self.find(QWidget, "curveViewport"), Qt.MouseButton.LeftButton)

    def drag(self, handle: Handle, count: int) -> None:
        self.pull(handle, count)
        self.let_go()

    def type_into(self, field: str, typed: str) -> None:
        editor = self.find(QSpinBox, f"{field}Edit")
        editor.setFocus()
        editor.selectAll()
        QTest.keyClicks(editor, typed)
        QTest.keyClick(editor, Qt.Key.Key_Return)

    def press(self, name: str) -> None:
        button = self.find(QAbstractButton, name)
        assert button.isEnabled(), f"{name} is greyed"
        QTest.mouseClick(button, Qt.MouseButton.LeftButton)

    def do(self, name: str) -> None:
        """Trigger an entry of the page's menu."""
        assert self.find(QPushButton, "changeButton").isEnabled()
        action = self.page.findChild(QAction, name)
        assert action is not None, name
        assert action.isVisible(), name
        action.trigger()

    def tab(self, index: int) -> None:
        bar = self.find(QTabBar, "sourceTabs")
        QTest.mouseClick(bar, Qt.MouseButton.LeftButton, pos=bar.tabRect(index).center())

    def apply(self) -> None:
        for name in ("applyButton", "writeButton"):
            button = self.program.window.findChild(QAbstractButton, name)
            assert button is not None
            assert button.isEnabled(), f"{name} is greyed"
            QTest.mouseClick(button, Qt.MouseButton.LeftButton)
        self.wait(lambda: not self.device.applying)

    def shown(self, channel: int = 1) -> Calibration:
        shown = self.device.calibrations.shown(channel)
        assert shown is not None
        return shown


@pytest.fixture
def person(program: Program, qtbot: QtBot) -> Person:
    program.window.resize(1050, 700)
    return Person(program, qtbot)


def test_without_a_board_the_page_says_what_to_do(person: Person) -> None:
    assert person.find(QLabel, "calibrationEmpty").isVisible()
    assert "Connect to a board" in person.text("calibrationEmpty")
    assert not person.find(QAbstractButton, "learnButton").isVisible()


def test_a_dragged_handle_is_one_edit_that_can_be_taken_back_and_written(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.connect(quick_simulator)
    undo = person.device.undo
    for handle, count in (
        (Handle.MINIMUM, 2300),
        (Handle.MAXIMUM, 5200),
        (Handle.NEUTRAL, 3600),
        (Handle.DEADBAND_HIGH, 3900),
        (Handle.DEADBAND_LOW, 3500),
    ):
        before, steps = person.shown(), undo.count()
        person.drag(handle, count)
        after = person.shown()
        assert after != before, handle
        assert undo.count() == steps + 1, handle
        undo.undo()
        assert person.shown() == before
        undo.redo()
        assert person.shown() == after
        assert f"= {after.minimum} counts" == person.text("minimumCounts")
    assert "edited" in person.row(1)
    assert person.device.calibrations.stored(1) == FACTORY
    wanted = person.shown()
    person.apply()
    assert person.device.calibrations.stored(1) == wanted
    assert person.device.pending == 0
    assert "edited" not in person.row(1)
    assert person.text("learnedLabel").startswith("learned")


@pytest.mark.parametrize(
    ("typed", "count"), [("1520", 3800), ("1.52 ms", 3800), ("3801 counts", 3801)]
)
def test_a_value_is_typed_in_any_unit(
    person: Person, quick_simulator: SimulatedDevice, typed: str, count: int
) -> None:
    person.connect(quick_simulator)
    person.type_into("neutral", typed)
    assert person.shown().neutral == count
    assert person.text("neutralCounts") == f"= {count} counts"


def test_arrow_keys_step_by_a_count(person: Person, quick_simulator: SimulatedDevice) -> None:
    person.connect(quick_simulator)
    editor = person.find(QSpinBox, "deadbandEdit")
    QTest.keyClick(editor, Qt.Key.Key_Up)
    QTest.keyClick(editor, Qt.Key.Key_Up)
    QTest.keyClick(editor, Qt.Key.Key_Down)
    assert person.shown().deadband == 76


def test_steps_with_the_keys_of_one_field_are_taken_back_at_once(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.connect(quick_simulator)
    person.program.window.activateWindow()
    undo = person.device.undo
    deadband, maximum = (person.find(QSpinBox, f"{name}Edit") for name in ("deadband", "maximum"))
    deadband.setFocus()
    for key in (Qt.Key.Key_Up, Qt.Key.Key_Up, Qt.Key.Key_PageUp):
        QTest.keyClick(deadband, key)
    QTest.keyPress(deadband, Qt.Key.Key_Up)  # and held: what Qt makes of that
    held = QKeyEvent(
        QEvent.Type.KeyPress, Qt.Key.Key_Up, Qt.KeyboardModifier.NoModifier, "", True, 5
    )
    QApplication.sendEvent(deadband, held)
    QTest.keyRelease(deadband, Qt.Key.Key_Up)
    assert person.shown().deadband >= FACTORY.deadband + 14
    assert undo.count() == 1
    maximum.setFocus()
    QTest.keyClick(maximum, Qt.Key.Key_Down)
    QTest.keyClick(maximum, Qt.Key.Key_Down)
    assert undo.count() == 2
    person.type_into("maximum", "4990 counts")
    assert undo.count() == 3
    QTest.keyClick(maximum, Qt.Key.Key_Down)
    assert undo.count() == 4
    for maximum_then in (4990, FACTORY.maximum - 2, FACTORY.maximum):
        undo.undo()
        assert person.shown().maximum == maximum_then
    undo.undo()
    assert person.shown() == FACTORY
    assert not undo.canUndo()


def test_leaving_a_field_ends_its_run_of_steps(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.connect(quick_simulator)
    person.program.window.activateWindow()
    fields = [person.find(QSpinBox, f"{name}Edit") for name in ("deadband", "maximum", "deadband")]
    for field in fields:
        field.setFocus()
        QTest.keyClick(field, Qt.Key.Key_Up)
        QTest.keyClick(field, Qt.Key.Key_Up)
    assert person.device.undo.count() == 3


def test_an_impossible_order_is_refused_beside_the_fields_and_never_becomes_an_edit(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.connect(quick_simulator)
    person.type_into("minimum", "1600")
    assert person.text("calibrationNote") == "Minimum (1600 µs) cannot be above neutral (1500 µs)."
    assert person.beside() == "minimum"
    assert person.plot.message == person.text("calibrationNote")
    assert person.find(QSpinBox, "minimumEdit").text() == "1000 µs"
    person.type_into("maximum", "1.2 ms")
    assert "Maximum (1200 µs) cannot be below neutral" in person.text("calibrationNote")
    assert person.beside() == "maximum"
    person.type_into("neutral", "nonsense")
    assert "no value" in person.text("calibrationNote")
    assert person.beside() == ""
    person.type_into("minimum", "1600")
    person.choose(2)
    assert person.beside() == ""
    person.choose(1)
    assert person.device.pending == 0
    person.drag(Handle.MINIMUM, 4200)
    assert person.shown().minimum == person.shown().neutral
    person.type_into("neutral", "1520")
    assert "The deadband (30 µs to each side of neutral)" in person.text("calibrationNote")
    assert "problem" in person.row(1)


def test_why_a_handle_goes_no_further_is_read_while_it_is_held_and_gone_after(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.connect(quick_simulator)
    person.type_into("minimum", "1500")
    concern = person.text("calibrationNote")
    assert "reaches minimum" in concern
    person.pull(Handle.MINIMUM, 4100)
    assert person.text("calibrationNote") == "Minimum cannot pass neutral."
    assert person.beside() == "minimum"
    person.let_go()
    assert person.text("calibrationNote") == concern
    assert person.plot.message == ""
    person.pull(Handle.MAXIMUM, 3000)
    assert person.text("calibrationNote") == "Minimum and maximum must differ."
    person.program.connector.disconnect_port()
    person.wait(lambda: person.device.link is Link.NONE)
    assert "No board answers" in person.text("calibrationNote")


def test_a_handle_is_dragged_as_far_as_the_input_can_be_and_then_says_why_no_further(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.connect(quick_simulator)
    person.pull(Handle.MAXIMUM, 7000)
    assert person.text("calibrationNote") == "A pulse cannot be longer than 2500 µs."
    assert person.plot.message == person.text("calibrationNote")
    person.let_go()
    assert person.shown().maximum == 6250
    assert "cannot" not in person.text("calibrationNote")


def test_full_output_that_no_input_can_ask_for_is_a_problem(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.connect(quick_simulator)
    person.type_into("maximum", "6000")
    assert person.text("calibrationNote").startswith("Maximum (6000 µs) is beyond")
    assert "problem" in person.row(1)
    person.type_into("maximum", "2500")
    person.type_into("minimum", "100")
    assert person.text("calibrationNote").startswith("Minimum (100 µs) is beyond")


def test_the_trace_of_the_input_is_high_enough_in_a_small_window(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.program.window.resize(900, 600)
    person.connect(quick_simulator)
    for channel in CHANNELS:
        person.choose(channel)
        person.page.grab()
        trace = person.find(InputTrace, "inputTrace")
        assert trace.frame.height() >= 4.5 * trace.fontMetrics().height()


def test_a_channel_with_edits_will_be_learned_after_apply(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.program.window.resize(1300, 800)
    person.connect(quick_simulator)
    assert person.text("learnedLabel") == "not learned: has the factory's values"
    person.type_into("minimum", "1100")
    assert person.text("learnedLabel") == "not learned yet: will be after Apply"
    person.device.undo.undo()
    assert person.text("learnedLabel") == "not learned: has the factory's values"


def test_the_live_dot_follows_the_stick_along_the_curve(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.connect(quick_simulator)
    quick_simulator.do("channel 1 1800us")
    person.wait(lambda: "1800 µs (4500 counts)" in person.live)
    remapped = ChannelSetup((FACTORY,) * 5).remapped([4500] * 5)[0]
    assert person.plot.dot == (4500, remapped)
    assert f"output {remapped}" in person.live
    assert "1800 µs" in person.row(1)
    person.find(QCheckBox, "parabolicBox").click()
    gentle = ChannelSetup((FACTORY,) * 5, parabolic=1).remapped([4500] * 5)[0]
    assert person.plot.dot == (4500, gentle)
    quick_simulator.do("channel 1 invalid")
    person.wait(lambda: "no signal" in person.row(1))
    person.wait(lambda: person.plot.dot is None)
    person.wait(lambda: "no signal" in person.live)


def test_the_mix_jumper_is_told_as_soon_as_a_stick_shows_it(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.connect(quick_simulator)
    assert "with the mix jumper on it steers" in person.text("channelDoes")
    quick_simulator.do("channel 1 1800us")
    person.wait(lambda: "drives motor 1 (the mix jumper is off)" in person.text("channelDoes"))
    quick_simulator.do("jumper mix on")
    person.wait(lambda: "steers (the mix jumper is on)" in person.text("channelDoes"))
    quick_simulator.do("channel 1 1500us")
    person.choose(2)
    assert "forward and back (the mix jumper is on)" in person.text("channelDoes")
    quick_simulator.do("channel 2 1700us")
    quick_simulator.do("jumper mix off")
    person.wait(lambda: "drives motor 2 (the mix jumper is off)" in person.text("channelDoes"))
    quick_simulator.do("channel 2 1500us")
    person.program.connector.disconnect_port()
    person.wait(lambda: "with the mix jumper on it" in person.text("channelDoes"))
    person.connect(quick_simulator)
    assert "with the mix jumper on it" in person.text("channelDoes")


def test_the_switches_are_bits_of_parameters_that_are_written(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.connect(quick_simulator)
    person.choose(3)
    for name in ("reversed", "parabolic", "ignored", "required"):
        box = person.find(QCheckBox, f"{name}Box")
        assert not box.isChecked()
        box.click()
        assert person.device.parameters.value_of(f"{name}_channels") in {4, 5}
        person.device.undo.undo()
        assert not box.isChecked()
        person.device.undo.redo()
        assert box.isChecked()
    assert "edited" in person.row(3)
    assert "ignored" in person.text("channelDoes")
    person.choose(1)
    assert not person.find(QCheckBox, "reversedBox").isChecked()
    assert person.find(QCheckBox, "requiredBox").isChecked()
    person.choose(3)
    person.apply()
    stored = quick_simulator.show()["parameters"]
    assert stored["reversed_channels"] == stored["parabolic_channels"] == 4
    assert stored["required_channels"] == 5


def test_where_a_switch_switches_is_said_and_follows_its_calibration(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.connect(quick_simulator)
    person.choose(4)
    assert "below about 1250 µs" in person.text("channelDoes")
    person.find(QCheckBox, "reversedBox").click()
    assert "above about 1750 µs" in person.text("channelDoes")
    person.type_into("maximum", "2100")
    assert "above about 1800 µs" in person.text("channelDoes")


def test_a_calibration_is_copied_made_symmetric_reset_and_given_up(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.connect(quick_simulator)
    person.type_into("minimum", "1100")
    mine = person.shown()
    steps = person.device.undo.count()
    person.do("copyTo3Action")
    assert person.shown(3) == mine
    person.do("copyToAllAction")
    assert all(person.shown(channel) == mine for channel in CHANNELS)
    assert person.device.undo.count() == steps + 2
    person.device.undo.undo()
    assert person.shown(2) == FACTORY
    person.do("symmetricSmallerAction")
    assert person.shown() == Calibration(2750, 3750, 4750, 75)
    person.device.undo.undo()
    person.do("symmetricLargerAction")
    assert person.shown() == Calibration(2500, 3750, 5000, 75)
    person.device.undo.undo()
    person.do("resetCalibrationAction")
    assert person.shown() == FACTORY
    person.device.undo.undo()
    person.type_into("minimum", "1500")
    steps = person.device.undo.count()
    shorter = person.page.findChild(QAction, "symmetricSmallerAction")
    assert shorter is not None
    assert not shorter.isEnabled()
    assert "too little for every output" in shorter.toolTip()
    shorter.trigger()
    assert person.device.undo.count() == steps
    person.device.undo.undo()
    assert shorter.isEnabled()
    person.find(QCheckBox, "reversedBox").click()
    person.press("discardChannelButton")
    assert person.shown() == FACTORY
    assert not person.find(QCheckBox, "reversedBox").isChecked()
    assert person.shown(3) == mine
    assert not person.find(QAbstractButton, "discardChannelButton").isEnabled()
    person.device.undo.undo()
    assert person.shown() == mine
    assert person.find(QCheckBox, "reversedBox").isChecked()


def test_calibrations_go_to_a_file_and_come_back(
    person: Person, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    person.connect(quick_simulator)
    person.type_into("minimum", "1100")
    mine, path = person.shown(), tmp_path / "mine.txt"
    person.page.files.save_file(path)
    person.device.discard_edits()
    with person.qtbot.waitSignal(person.page.told) as told:
        person.page.files.load_file(path)
    assert told.args[0].startswith("1 calibration of mine.txt is an edit now.")
    person.type_into("minimum", "1150")
    person.do("copyToAllAction")
    person.page.files.save_file(path)
    person.device.discard_edits()
    with person.qtbot.waitSignal(person.page.told) as told:
        person.page.files.load_file(path)
    assert told.args[0].startswith("5 calibrations of mine.txt are edits now.")
    person.device.undo.undo()
    person.type_into("minimum", "1100")
    person.page.files.save_file(path)
    person.type_into("deadband", "1 count")
    assert person.text("deadbandCounts") == "= 1 count"
    person.device.discard_edits()
    person.page.files.load_file(path)
    assert person.shown() == mine
    with person.qtbot.waitSignal(person.page.refused) as refused:
        person.page.files.load_file(tmp_path / "none.txt")
    assert "none.txt was not taken" in refused.args[0]


def test_the_way_to_the_other_source_is_shown_and_what_was_seen_of_it_is_kept(
    person: Person, start_simulator: StartSimulator
) -> None:
    simulator = start_simulator("--unpaced")
    person.connect(simulator)
    bar = person.find(QTabBar, "sourceTabs")
    assert bar.tabText(0) == "RC pulses (in force)"
    person.tab(1)
    assert "None of them were seen" in person.text("otherSourceWords")
    for name in ("minimum", "neutral", "maximum", "deadband"):
        assert not person.find(QSpinBox, f"{name}Edit").isEnabled()
    assert not person.find(QAbstractButton, "changeButton").isEnabled()
    for kind, name in (
        (QAbstractButton, "learnButton"),
        (QAbstractButton, "learnAllButton"),
        (QCheckBox, "reversedBox"),
        (QCheckBox, "ignoredBox"),
    ):
        widget = person.find(kind, name)
        assert not widget.isEnabled(), name
        assert widget.toolTip().startswith("The board reads RC pulses now."), name
        assert "let the board read analog voltages first" in widget.toolTip(), name
    assert not person.find(QCheckBox, "requiredBox").isVisible()
    assert not person.find(InputTrace, "inputTrace").isVisible()
    person.press("switchSourceButton")
    assert person.device.parameters.pending == (("channel_input_source", 1),)
    assert "apply this edit" in person.text("otherSourceWords")
    person.apply()
    assert "once it is switched off and on" in person.text("otherSourceWords")
    assert person.page.source is InputSource.ANALOG
    assert person.find(QAbstractButton, "switchSourceCycleButton").isEnabled()
    simulator.do("power cycle")
    person.wait(lambda: bar.tabText(1) == "Analog voltages (in force)")
    assert person.find(QSpinBox, "minimumEdit").isEnabled()
    assert person.find(QSpinBox, "maximumEdit").text() == "5.000 V"
    assert person.find(QAbstractButton, "learnButton").isEnabled()
    assert not person.find(QAbstractButton, "learnButton").toolTip()
    assert person.find(QCheckBox, "reversedBox").isEnabled()
    assert "forward and reverse" in person.find(QCheckBox, "reversedBox").toolTip()
    assert not person.find(QCheckBox, "requiredBox").isVisible()
    simulator.do("channel 1 2.5V")
    person.wait(lambda: "2.50 V" in person.live)
    person.type_into("minimum", "500 mV")
    assert person.shown().minimum == 102
    person.tab(0)
    assert "what was last seen" in person.text("otherSourceWords")
    assert person.find(QSpinBox, "neutralEdit").text() == "1500 µs"
    assert not person.find(QSpinBox, "neutralEdit").isEnabled()
    assert person.device.pending == 1


def test_in_rc_mode_the_page_says_what_the_channel_does_and_why_nothing_can_be_stored(
    person: Person, start_simulator: StartSimulator
) -> None:
    simulator = start_simulator("--unpaced", "--mode", "rc")
    person.connect(simulator)
    assert person.text("channelDoes").startswith("Channel 1 drives motor 1")
    assert "serial mode only" in person.text("calibrationNote")
    person.type_into("minimum", "1100")
    person.apply()
    assert "code 3" in person.text("calibrationNote")
    assert "problem" in person.row(1)
    person.type_into("minimum", "1104")
    assert "code 3" not in person.text("calibrationNote")
    person.tab(1)
    assert "mode jumper to analog" in person.text("otherSourceWords")
    assert not person.find(QAbstractButton, "switchSourceButton").isVisible()


def test_a_value_that_the_board_refuses_is_explained_on_its_channel(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.connect(quick_simulator)
    person.device.calibrations.edit(2, Calibration(2400, 3700, 5100, 60))
    error = Rejected("Calibration of channel 2", ResultCode.BAD_VALUE)
    person.device.applied.emit((Written("channel 2", error=error),))
    assert "problem" in person.row(2)
    assert "problem" not in person.row(1)
    assert "code 2" not in person.text("calibrationNote")
    person.choose(2)
    assert "code 2" in person.text("calibrationNote")
    assert "minimum is not above neutral" in person.text("calibrationNote")
    person.device.undo.undo()
    assert "problem" not in person.row(2)


def test_the_other_model_is_calibrated_alike(
    person: Person, start_simulator: StartSimulator
) -> None:
    person.connect(start_simulator("--unpaced", "--model", "trexjr"))
    person.choose(5)
    person.drag(Handle.MAXIMUM, 5200)
    wanted = person.shown(5)
    person.apply()
    assert person.device.calibrations.stored(5) == wanted


def test_without_an_answer_the_page_is_to_be_looked_at_only(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.connect(quick_simulator)
    person.type_into("minimum", "1100")
    person.program.connector.disconnect_port()
    person.wait(lambda: person.device.link is Link.NONE)
    for kind, name in ((QSpinBox, "minimumEdit"), (QCheckBox, "reversedBox")):
        assert not person.find(kind, name).isEnabled(), name
    for name in ("learnButton", "learnAllButton", "changeButton", "discardChannelButton"):
        assert not person.find(QAbstractButton, name).isEnabled(), name
    assert "No board answers" in person.text("calibrationNote")
    assert "N/A" in person.row(1)
    assert person.plot.dot is None
    before = person.shown()
    person.drag(Handle.MAXIMUM, 5200)
    assert person.shown() == before


def test_the_learn_buttons_ask_for_one_or_all(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.connect(quick_simulator)
    page = CalibrationPage(person.device)  # one that nobody listens to
    person.qtbot.addWidget(page)
    view = page.findChild(QListWidget, "calibrationChannels")
    assert view is not None
    view.setCurrentRow(1)
    asked: list[object] = []
    page.learn_requested.connect(asked.append)
    for name in ("learnButton", "learnAllButton"):
        button = page.findChild(QAbstractButton, name)
        assert button is not None
        button.click()
    assert asked == [(2,), CHANNELS]


def test_nothing_is_drawn_while_nobody_looks(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.connect(quick_simulator)
    person.program.window.pages.setCurrentIndex(0)
    before = person.row(1)
    quick_simulator.do("channel 1 1900us")
    person.wait(lambda: person.device.telemetry.raw_of(1) == 4750)
    person.qtbot.wait(80)
    assert person.row(1) == before
    person.program.window.pages.setCurrentIndex(2)
    assert "1900 µs" in person.row(1)


def test_the_page_follows_the_theme(person: Person, quick_simulator: SimulatedDevice) -> None:
    person.connect(quick_simulator)
    person.type_into("minimum", "1100")
    for scheme in ("light", "dark", "light"):
        theme().set_scheme(scheme)
        picture = person.plot.grab().toImage()
        assert theme().color("plot_background").name() in {
            picture.pixelColor(x, picture.height() // 3).name() for x in range(picture.width())
        }


def test_every_control_has_an_accessible_name(
    person: Person, quick_simulator: SimulatedDevice
) -> None:
    person.connect(quick_simulator)
    kinds = (QAbstractButton, QSpinBox, QListWidget, QTabBar, CurvePlot)
    for kind in kinds:
        for widget in person.page.findChildren(kind):
            if isinstance(widget.parentWidget(), QTabBar):
                continue  # the arrows of a bar that is too narrow
            text = widget.text() if isinstance(widget, QAbstractButton) else ""
            assert widget.accessibleName() or text, widget.objectName()
    for editor in person.page.findChildren(QLineEdit):
        box = editor.parentWidget()
        assert box is not None
        assert box.accessibleName()
