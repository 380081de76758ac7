"""A person in front of the window, a simulated board on a real pseudo-terminal behind it."""

import sys
from collections.abc import Callable
from typing import TypeVar

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QComboBox,
    QLabel,
    QSlider,
    QSpinBox,
    QTabWidget,
    QTreeView,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.model.parameter_filter import ParameterFilter
from trex_gui.model.parameters import Column
from trex_gui.protocol.calibration import Calibration
from trex_gui.protocol.flags import InputSource
from trex_gui.runtime import now, open_transport
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")


WidgetT = TypeVar("WidgetT", bound=QWidget)


class Person:
    """What a person can do and see, by the names of the widgets."""

    def __init__(self, program: Program, qtbot: QtBot) -> None:
        self.program = program
        self.qtbot = qtbot

    def find(self, kind: type[WidgetT], name: str) -> WidgetT:
        widget = self.program.window.findChild(kind, name)
        assert isinstance(widget, kind), name
        return widget

    def text(self, name: str) -> str:
        label = self.find(QLabel, name)
        return label.text()

    def press(self, name: str) -> None:
        button = self.find(QAbstractButton, name)
        assert button.isEnabled(), f"{name} is greyed"
        QTest.mouseClick(button, Qt.MouseButton.LeftButton)

    def apply(self) -> None:
        """Look at the review, and write."""
        self.press("applyButton")
        self.press("writeButton")

    def open_page(self, name: str) -> QWidget:
        tabs = self.find(QTabWidget, "tabs")
        for index in range(tabs.count()):
            page = tabs.widget(index)
            if page is not None and page.objectName() == f"{name}Area":
                tabs.setCurrentIndex(index)
                return page
        pytest.fail(f"no page {name}")

    def connect(self, url: str) -> None:
        port = self.program.ports.add_typed(url)
        combo = self.find(QComboBox, "portCombo")
        index = next(i for i in range(combo.count()) if combo.itemData(i) == port)
        combo.setCurrentIndex(index)
        combo.activated.emit(index)
        self.wait(lambda: self.program.device.link is Link.UP)

    def wait(self, condition: Callable[[], bool], timeout: int = 20_000) -> None:
        self.qtbot.waitUntil(condition, timeout=timeout)

    def edit(self, key: str, typed: str) -> None:
        """Open the editor of a parameter with the mouse, type, press Enter; it closes."""
        editor = self.type_into(key, typed)
        view = self.find(QTreeView, "parametersView")
        self.wait(lambda: view.viewport().findChild(QSpinBox) is not editor)

    def type_into(self, key: str, typed: str) -> QSpinBox:
        """Open the editor of a parameter with the mouse, type, press Enter."""
        view = self.find(QTreeView, "parametersView")
        rows = view.model()
        assert isinstance(rows, ParameterFilter)
        index = rows.mapFromSource(self.program.device.parameters.index_of(key, Column.VALUE))
        view.scrollTo(index)
        place = view.visualRect(index).center()
        QTest.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=place)
        QTest.mouseDClick(view.viewport(), Qt.MouseButton.LeftButton, pos=place)
        editor = view.viewport().findChild(QSpinBox)
        assert isinstance(editor, QSpinBox)
        editor.selectAll()
        QTest.keyClicks(editor, typed)
        QTest.keyClick(editor, Qt.Key.Key_Return)
        return editor


@pytest.fixture
def person(program: Program, qtbot: QtBot) -> Person:
    return Person(program, qtbot)


def test_choosing_a_port_connects_and_names_the_board(
    person: Person, simulator: SimulatedDevice
) -> None:
    person.connect(simulator.url)
    assert person.text("statusLabel") == "Connected to TReX 1.2."
    person.open_page("statusPage")
    assert "Serial commands control the motors" in person.text("controlValue")


def test_everything_is_greyed_and_not_stale_without_a_board(
    person: Person, simulator: SimulatedDevice
) -> None:
    person.connect(simulator.url)
    person.open_page("channelsPage")
    person.wait(lambda: person.text("channel1Input") == "1500 µs (3750)")
    person.press("connectButton")
    person.wait(lambda: person.program.device.link is Link.NONE)
    assert person.text("channel1Input") == "N/A"
    assert person.text("modelValue") == "N/A"
    view = person.find(QTreeView, "parametersView")
    assert not view.isEnabled()
    for name in ("runButton", "stopButton", "applyButton"):
        button = person.find(QAbstractButton, name)
        assert not button.isEnabled(), name


def test_a_changed_parameter_reaches_the_board_only_with_apply(
    person: Person, simulator: SimulatedDevice
) -> None:
    person.connect(simulator.url)
    person.open_page("parametersPage")
    person.edit("serial_timeout", "1.5 s")
    assert person.text("unappliedLabel") == "There are unapplied changes."
    assert simulator.show()["parameters"]["serial_timeout"] == 0
    person.apply()
    person.wait(lambda: not person.program.device.parameters.pending)
    assert simulator.show()["parameters"]["serial_timeout"] == 15
    assert "read back equal" in person.text("parametersNotice")


def test_a_value_out_of_range_stays_in_the_editor_with_the_limits_beside_it(
    person: Person, simulator: SimulatedDevice
) -> None:
    person.connect(simulator.url)
    person.open_page("parametersPage")
    editor = person.type_into("serial_timeout", "99 s")
    assert editor.isVisible()
    assert editor.text() == "99 s"
    assert "off to 12.7 s" in person.text("parametersNotice")
    QTest.keyClick(editor, Qt.Key.Key_Escape)
    assert person.program.device.pending == 0


def test_a_write_in_rc_mode_says_why_it_was_refused(
    person: Person, simulator: SimulatedDevice
) -> None:
    simulator.do("jumper mode rc")
    simulator.do("power cycle")
    person.connect(simulator.url)
    person.open_page("parametersPage")
    person.edit("serial_timeout", "1.5 s")
    person.apply()
    person.wait(lambda: "Serial Timeout" in person.text("bannerText"))
    assert "not in serial mode" in person.text("bannerText")
    assert person.program.device.parameters.pending == (("serial_timeout", 15),)


def test_a_moved_stick_moves_its_bar(person: Person, simulator: SimulatedDevice) -> None:
    person.connect(simulator.url)
    person.open_page("channelsPage")
    simulator.do("channel 1 1800us")
    person.wait(lambda: person.text("channel1Input") == "1800 µs (4500)")
    bar = person.find(QWidget, "channel1Bar")
    person.wait(lambda: "1800 µs" in bar.accessibleDescription())
    output = person.find(QWidget, "channel1Output")
    remapped = simulator.show()["channels"][0]["remapped"]
    person.wait(lambda: str(remapped) in output.accessibleDescription())


def test_a_channel_without_signal_says_so(person: Person, simulator: SimulatedDevice) -> None:
    person.connect(simulator.url)
    person.open_page("channelsPage")
    simulator.do("channel 2 invalid")
    person.wait(lambda: person.text("channel2Input") == "no signal")


def test_nothing_moves_before_run_motor_and_everything_stops_after_stop(
    person: Person, simulator: SimulatedDevice
) -> None:
    person.connect(simulator.url)
    person.open_page("motorsPage")
    slider = person.find(QSlider, "motor1Slider")
    assert not slider.isEnabled()
    person.press("runButton")
    slider.setValue(80)
    person.wait(lambda: simulator.show()["motors"][0]["speed"] == 80)
    assert simulator.show()["motors"][0]["direction"] == "forward"
    person.wait(lambda: "A" in person.text("motor1Reported"))
    person.press("stopButton")
    person.wait(lambda: simulator.show()["motors"][0]["direction"] == "brake")
    assert slider.value() == 0
    assert not slider.isEnabled()


def test_escape_in_the_editor_of_a_table_stops_the_motors(
    person: Person, simulator: SimulatedDevice
) -> None:
    person.connect(simulator.url)
    person.press("runButton")
    person.program.device.motors.set_speed(2, -100)
    person.wait(lambda: simulator.show()["motors"][1]["speed"] == 100)
    person.open_page("parametersPage")
    view = person.find(QTreeView, "parametersView")
    rows = view.model()
    assert isinstance(rows, ParameterFilter)
    view.edit(rows.mapFromSource(person.program.device.parameters.index_of("serial_timeout")))
    window = person.program.window.windowHandle()
    person.qtbot.waitUntil(lambda: window.isActive() or window.isExposed())
    QTest.keyClick(window, Qt.Key.Key_Escape)
    person.wait(lambda: simulator.show()["motors"][1]["direction"] == "brake")


def test_closing_the_window_stops_driven_motors(person: Person, simulator: SimulatedDevice) -> None:
    person.connect(simulator.url)
    person.press("runButton")
    person.program.device.motors.set_speed(1, 60)
    person.wait(lambda: simulator.show()["motors"][0]["speed"] == 60)
    person.program.window.close()
    person.wait(lambda: simulator.show()["motors"][0]["direction"] == "brake")


def test_a_pulled_plug_is_noticed_within_half_a_second_and_replugging_connects_again(
    person: Person, simulator: SimulatedDevice
) -> None:
    def seconds_to_notice() -> float:
        person.press("runButton")
        begun = now()
        simulator.do("line unplug")
        person.wait(lambda: person.program.device.link is Link.NONE)
        seconds = now() - begun
        assert "gone" in person.text("bannerText")
        assert not person.program.device.motors.armed
        assert person.text("statusLabel") == "Not connected."
        person.connect(simulator.do("line plug").split()[-1])
        assert person.text("statusLabel") == "Connected to TReX 1.2."
        return seconds

    person.connect(simulator.url)
    # A computer with other things to do may be late, but hardly each time.
    assert any(seconds_to_notice() < 0.5 for _ in range(5))


def test_motors_that_ran_when_the_plug_was_pulled_stop_when_it_is_back(
    person: Person, simulator: SimulatedDevice
) -> None:
    person.connect(simulator.url)
    person.press("runButton")
    person.program.device.motors.set_speed(1, 50)
    person.wait(lambda: simulator.show()["motors"][0]["speed"] == 50)
    simulator.do("line unplug")
    person.wait(lambda: person.program.device.link is Link.NONE)
    assert "motors may still turn" in person.text("motorStateLabel")
    assert simulator.show()["motors"][0]["speed"] == 50
    person.connect(simulator.do("line plug").split()[-1])
    assert simulator.show()["motors"][0]["direction"] == "brake"
    assert "Not armed" in person.text("motorStateLabel")


def test_a_board_that_cannot_be_heard_is_stopped_all_the_same(
    person: Person, simulator: SimulatedDevice
) -> None:
    person.connect(simulator.url)
    person.press("runButton")
    person.program.device.motors.set_speed(2, 90)
    person.wait(lambda: simulator.show()["motors"][1]["speed"] == 90)
    simulator.do("line mute on")
    person.wait(lambda: person.program.device.link is Link.SILENT)
    person.wait(lambda: simulator.show()["motors"][1]["direction"] == "brake")
    person.open_page("statusPage")
    assert person.text("modelValue") == "N/A"
    simulator.do("line mute off")
    person.wait(lambda: person.program.device.link is Link.UP)
    assert not person.program.device.motors.armed


def test_where_channels_are_in_control_the_motors_cannot_be_armed(
    person: Person, simulator: SimulatedDevice
) -> None:
    simulator.do("jumper mode rc")
    simulator.do("power cycle")
    person.connect(simulator.url)
    person.open_page("motorsPage")
    assert not person.find(QAbstractButton, "runButton").isEnabled()
    assert "RC channels control the motors" in person.text("motorsReason")


def test_what_was_written_is_what_every_page_shows_and_what_is_saved(
    person: Person, simulator: SimulatedDevice
) -> None:
    device = person.program.device
    person.connect(simulator.url)
    wanted = Calibration(2400, 3700, 5100, 60)
    device.calibrations.edit(1, wanted)
    device.parameters.setData(device.parameters.index_of("motor1_current_limit"), 10)
    person.apply()
    person.wait(lambda: device.pending == 0 and not device.applying)
    assert device.state is not None
    assert device.state.calibrations[1] == wanted
    assert device.draft.stored is not None
    assert device.draft.stored.calibrations[InputSource.RC, 1] == wanted
    assert device.parameters.stored_of("motor1_current_limit") == 10


def test_a_power_cycle_is_noticed_and_survived(person: Person, simulator: SimulatedDevice) -> None:
    person.connect(simulator.url)
    simulator.do("power off")
    person.wait(lambda: person.program.device.link is Link.SILENT)
    assert "stopped answering" in person.text("statusLabel")
    simulator.do("power on")
    person.wait(lambda: person.program.device.link is Link.UP)


def test_a_stored_value_that_waits_for_power_says_so_until_the_power_cycle(
    person: Person, simulator: SimulatedDevice
) -> None:
    person.connect(simulator.url)
    page = person.open_page("parametersPage")
    model = person.program.device.parameters
    model.setData(model.index_of("motor_mode"), 1)
    person.apply()
    person.wait(lambda: model.waiting_for_power == ("Motor Mode",))
    assert "Motor Mode" in person.text("parametersNotice")
    assert page.isVisible()
    simulator.do("power off")
    person.wait(lambda: person.program.device.link is Link.SILENT)
    simulator.do("power on")
    person.wait(lambda: model.waiting_for_power == ())
    assert person.program.device.state is not None
    assert person.program.device.state.parameters["motor_mode"] == 1


def test_a_missing_port_is_a_sentence(person: Person) -> None:
    person.program.connector.connect_to(person.program.ports.add_typed("/dev/ttyNothing7"))
    person.wait(lambda: person.text("bannerText") != "")
    assert "There is no port /dev/ttyNothing7" in person.text("bannerText")
    assert person.program.device.link is Link.NONE


def test_a_busy_port_is_a_sentence(person: Person, simulator: SimulatedDevice) -> None:
    other = open_transport(LinkSettings(simulator.url))
    try:
        person.program.connector.connect_to(person.program.ports.add_typed(simulator.url))
        person.wait(lambda: person.text("bannerText") != "")
        assert "in use" in person.text("bannerText")
    finally:
        other.close()


def test_the_demo_needs_no_hardware(person: Person) -> None:
    person.program.connector.connect_to(person.program.ports.demo)
    person.wait(lambda: person.program.device.link is Link.UP)
    telemetry = person.program.device.telemetry
    person.open_page("channelsPage")
    person.wait(lambda: telemetry.raw is not None)
    first = telemetry.raw
    person.wait(lambda: telemetry.raw != first)
