"""Review of settings before they are written, and power cycle until they are active."""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton, QSpinBox, QTabBar, QWidget

from tests.support.keyboard import check_keyboard
from tests.support.pages.parameters import ParametersPage
from tests.support.pages.settings import ReviewDialog, SimulatedPower, findings_of
from tests.support.virtual_devices import VirtualSimulator
from tests.support.window import LEFT, WindowDriver
from trex_gui.devices.trex.model.linter import BoardLinter
from trex_gui.devices.trex.model.settings.comparison_table import ComparisonColumn
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.settings.rules import LintFinding
from trex_gui.devices.trex.views.pages.parameters.view import ParameterChoice

LINE = LineSettings(57600, Detection.EVEN, 2)
CALIBRATION = Calibration(2600, 3750, 5000, 60)


@pytest.fixture
def simulator(quick_simulator: VirtualSimulator) -> VirtualSimulator:
    return quick_simulator


@pytest.fixture
def review(connected_window: WindowDriver) -> ReviewDialog:
    return ReviewDialog(connected_window)


@pytest.fixture
def power(connected_window: WindowDriver, simulator: VirtualSimulator) -> SimulatedPower:
    return SimulatedPower(connected_window, simulator)


def edit(window: WindowDriver, **values: int) -> None:
    for key, value in values.items():
        window.device.parameters.edit(key, value)


def findings(window: WindowDriver) -> tuple[LintFinding, ...]:
    """Return the findings about the edited settings."""
    return window.find_only(BoardLinter).findings


def stored(simulator: VirtualSimulator, key: str) -> int:
    return int(simulator.show()["parameters"][key])


def test_review_shows_edits_and_writes_only_checked_ones(
    connected_window: WindowDriver, review: ReviewDialog, simulator: VirtualSimulator
) -> None:
    device = connected_window.device
    edit(connected_window, serial_timeout=15)
    device.calibrations.edit(CalibrationKey.RC_CHANNEL_2, CALIBRATION)
    review.open()
    timeout, calibration = review.rows()
    assert timeout == ["Serial Timeout", "off", "1.5 s", "0 → 15"]
    assert calibration[0] == "Calibration of RC channel 2"
    assert "minimum" in calibration[2]
    assert "maximum" not in calibration[2]
    assert review.button("writeButton").text() == "&Write 2 settings"
    assert "TReX 1.2 (device number 7, " in review.head

    review.close()
    assert stored(simulator, "serial_timeout") == 0
    assert device.draft.pending == 2
    assert device.writer.history.snapshots() == ()

    review.open()
    review.toggle("Serial Timeout")
    edit(connected_window, motor2_acceleration=7)
    assert len(review.rows()) == 3
    assert review.button("writeButton").text() == "&Write 2 settings"
    device.draft.discard_edits()
    assert review.rows() == []
    assert not review.has("writeButton")
    assert review.head.strip() == "Nothing to write."

    edit(connected_window, serial_timeout=15, motor1_acceleration=5)
    review.open()
    review.toggle("Serial Timeout")
    assert review.button("writeButton").text() == "&Write 1 setting"
    review.click("writeButton")
    review.wait(lambda: stored(simulator, "motor1_acceleration") == 5 and not device.writer.running)
    assert stored(simulator, "serial_timeout") == 0
    assert device.parameters.values.pending == (("serial_timeout", 15),)


def test_review_reports_stored_and_failed_settings(
    connected_window: WindowDriver, review: ReviewDialog, simulator: VirtualSimulator
) -> None:
    window, device = connected_window, connected_window.device
    edit(window, serial_timeout=15)
    device.calibrations.edit(CalibrationKey.RC_CHANNEL_2, CALIBRATION)
    review.write()
    assert [len(row) for row in review.rows()] == [len(ComparisonColumn)] * 2
    assert [row[-1] for row in review.rows()] == ["stored"] * 2
    assert "2 settings written and verified" in review.head
    assert review.button("reviewCloseButton").text() == "Close"
    assert review.root.focusWidget() is review.button("reviewCloseButton")
    assert not review.has("writeButton")
    assert not review.has("powerCyclePanel"), "a new timeout is active at once"

    edit(window, serial_timeout=14)
    review.open()  # it is open already
    focused: object = review.root.focusWidget()  # `None` is possible, against Qt's stubs
    QTest.keyClick(focused if isinstance(focused, QWidget) else review.root, Qt.Key.Key_Return)
    review.wait(lambda: stored(simulator, "serial_timeout") == 14 and not device.writer.running)
    review.close()

    edit(window, serial_timeout=16)
    device.calibrations.edit(CalibrationKey.RC_CHANNEL_3, CALIBRATION)
    review.open()
    review.click("writeButton")
    review.wait(lambda: device.writer.running and not device.writer.is_saving_snapshot)
    review.close()
    assert "written and verified" not in window.text("bannerText")
    window.wait_for_text("bannerText", "written and verified")

    edit(window, serial_timeout=15, motor1_acceleration=5)
    review.open()
    simulator.do("jumper mode rc", "power cycle")
    window.wait(lambda: device.state is not None and not device.state.mode.is_serial)
    assert not window.is_enabled("applyButton")
    assert "in serial mode only" in review.head
    review.click("writeButton")
    review.wait_for_text("reviewHead", "could not be verified")
    not_attempted, rejected = sorted((row[-1] for row in review.rows()), key=len)
    assert "not in serial mode" in rejected
    assert not_attempted == "not attempted"
    assert device.draft.pending == 2


def test_board_decides_on_values_beyond_inferred_limits(
    connected_window: WindowDriver,
    review: ReviewDialog,
    simulator: VirtualSimulator,
    tmp_path: Path,
) -> None:
    window, device, key = connected_window, connected_window.device, "ignored_channels"
    page = ParametersPage(window)

    def try_wire(wire: int) -> None:
        page.view.setCurrentIndex(page.index_of(key))
        page.find(QAction, "tryParameter").trigger()
        assert "No document confirms this limit" in page.text("wireNote")
        page.find(QSpinBox, "wireField").setValue(wire)
        page.click("tryWireButton")

    def write_anyway() -> None:
        review.open()
        review.click("writeButton")
        assert review.text("questionText").startswith("Ignored Channels 63: beyond a limit")
        assert stored(simulator, key) == 0, "the question comes before the write"
        review.click("writeAnyway")
        review.wait(
            lambda: not device.writer.running and len(review.rows()[0]) == len(ComparisonColumn)
        )

    try_wire(63)
    review.open()
    review.click("writeButton")
    check_keyboard(review.root)
    review.toggle("Ignored Channels")
    assert not review.has("writeAnyway"), "the question disappears with its setting"
    review.close()

    write_anyway()
    assert "the board rejects this value" in review.rows()[0][-1]
    review.close()
    simulator.do("accept ignored_channels 127 31")
    write_anyway()
    assert "read back channels 1, 2, 3, 4, 5" in review.rows()[0][-1]
    assert device.parameters.values.stored.get(key) == 31
    review.close()
    edit(window, ignored_channels=0)
    simulator.do("accept ignored_channels 127")
    review.write()
    review.close()
    try_wire(63)
    write_anyway()
    assert review.rows()[0][-1] == "stored"
    review.close()
    assert stored(simulator, key) == 63
    window.wait_for_files()
    help_text = page.text("parameterDetails")
    assert "This firmware has also stored wire values outside this range: 63." in help_text


# --- The power cycle --------------------------------------------------------------------


def test_power_cycle_is_tracked_until_settings_are_active(
    connected_window: WindowDriver, review: ReviewDialog, power: SimulatedPower
) -> None:
    window, device = connected_window, connected_window.device
    edit(window, motor_mode=1)
    review.write()
    assert review.has("powerCyclePanel")
    assert "Motor Mode" in review.text("powerCycleTitle")
    check_keyboard(review.root)
    assert "Waiting for the board to stop responding" in review.text("powerCycleResult")
    window.trigger("power")
    window.click("powerCycleCloseButton")
    assert "Waiting for the board to stop responding" in review.text("powerCycleResult")
    review.wait_for_text("powerCycleResult", "A short interruption is not detected")
    power.off()
    review.wait_for_text("powerCycleResult", "Waiting for the board to respond")
    review.wait_for_text("powerCycleResult", "Check its power")
    power.on()
    review.wait_for_text("powerCycleResult", "all stored settings are active")
    assert review.text("powerCycleTitle") == "Power cycle completed."
    assert device.parameters.values.active_of("motor_mode") == 1

    review.close()
    edit(window, motor_mode=0)
    review.write()
    review.close()
    page = ParametersPage(window)
    page.view.setCurrentIndex(page.index_of("motor_mode"))
    window.click("makeActiveButton")
    guide = window.dialog("powerCycleDialog")
    assert guide.is_enabled("powerCycleStopButton")
    assert "Motor Mode" in guide.text("powerCycleTitle")
    power.off()
    guide.wait_for_text("powerCycleResult", "Waiting for the board to respond")
    power.on()
    guide.wait_for_text("powerCycleResult", "active")
    guide.click("powerCycleCloseButton")
    assert not window.has("makeActiveButton")


def test_disconnect_does_not_count_as_power_cycle(
    connected_window: WindowDriver, review: ReviewDialog, simulator: VirtualSimulator
) -> None:
    window, device = connected_window, connected_window.device
    edit(window, motor_mode=1)
    review.write()
    window.disconnect()
    review.wait_for_text("powerCycleResult", "The connection was closed")
    device.connect_to(ConnectionSettings(simulator.url))
    review.wait_for_text("powerCycleResult", "cannot detect")
    assert list(device.parameters.values.waiting_for_power) == ["Motor Mode"]
    review.click("powerCycleDone")
    assert "all stored settings are active" in review.text("powerCycleResult")
    assert list(device.parameters.values.waiting_for_power) == []


# --- Defaults ---------------------------------------------------------------------------


def test_defaults_are_edits_only_while_they_are_reviewed(
    connected_window: WindowDriver, review: ReviewDialog, simulator: VirtualSimulator
) -> None:
    window, device = connected_window, connected_window.device
    edit(window, serial_timeout=15, motor1_acceleration=5, uart_settings=LINE.to_wire())
    review.write()
    review.close()
    window.trigger("serial_defaults")
    assert [row[0] for row in review.rows()] == ["UART Settings"]
    assert not review.has("boardResetButton")
    review.click("writeButton")
    review.wait_for_text("reviewHead", "written and verified")
    review.close()

    edit(window, motor2_acceleration=9)
    window.trigger("defaults")
    assert [row[0] for row in review.rows()] == ["Serial Timeout", "Motor 1 Acceleration"]
    assert "serial_timeout" in [key for finding in findings(window) for key in finding.keys]
    review.close()
    assert device.parameters.values.pending == (("motor2_acceleration", 9),)

    window.trigger("defaults")
    review.toggle("Serial Timeout")
    review.click("writeButton")
    review.wait(lambda: stored(simulator, "motor1_acceleration") == 0 and not device.writer.running)
    assert stored(simulator, "serial_timeout") == 15
    assert device.draft.pending == 0, "no edit is left, not even the earlier edit"


def test_pending_reset_blocks_writing_until_power_cycle(
    connected_window: WindowDriver,
    review: ReviewDialog,
    simulator: VirtualSimulator,
    power: SimulatedPower,
) -> None:
    window, device = connected_window, connected_window.device
    edit(window, serial_timeout=15, uart_settings=LINE.to_wire())
    review.write()
    power.cycle()
    review.close()
    window.trigger("defaults")
    review.click("boardResetButton")
    assert review.button("questionCancel").hasFocus()
    QTest.mouseClick(review.button("boardResetSureButton"), LEFT)  # too early after it has appeared
    assert review.has("boardResetSureButton")
    assert not device.draft.reset_pending
    review.click("boardResetSureButton")
    guide = window.dialog("powerCycleDialog")
    guide.wait(guide.root.isVisible)
    window.wait(lambda: device.draft.reset_pending)
    assert len(device.writer.history.snapshots()) == 2
    guide.click("powerCycleCloseButton")

    edit(window, motor1_acceleration=5)
    review.open()
    assert "will reset itself" in review.head
    assert not review.is_enabled("writeButton")
    device.writer.apply()
    assert not device.writer.running
    review.close()

    window.trigger("power")
    power.cycle()
    assert not device.draft.reset_pending
    assert stored(simulator, "serial_timeout") == 0
    assert device.parameters.values.stored.get("serial_timeout") == 0
    assert device.settings is not None
    assert device.settings.line == LineSettings()
    review.open()
    assert review.is_enabled("writeButton")
    guide.click("powerCycleCloseButton")
    review.close()


# --- Findings ---------------------------------------------------------------------------


def test_arming_warns_about_the_serial_timeout(connected_window: WindowDriver) -> None:
    window = connected_window
    window.open_page("parametersPage")
    window.wait(lambda: window.motors.is_available)
    window.motors.arm()
    window.find(QTabBar, "parameterChoice").setCurrentIndex(ParameterChoice.WITH_FINDINGS)
    window.click("parameterAccept0")
    assert window.device.parameters.values.value_of("serial_timeout") == 5


def test_review_offers_findings_and_writes_accepted_values(
    connected_window: WindowDriver, quick_simulator: VirtualSimulator
) -> None:
    window, device = connected_window, connected_window.device
    window.open_page("channelsPage")
    for key, wire in {
        "ignored_channels": 1,
        "motor1_current_limit": 10,
        "motor2_current_limit": 10,
        "motor1_acceleration": 10,
        "motor1_current_limit_p": 0,
        "motor2_current_limit_p": 0,
    }.items():
        device.parameters.edit(key, wire)
    (finding,) = findings_of(window, "calibration")
    assert finding.startswith("Both required and ignored: channel 1.")
    window.window.resize(1024, 600)
    accept = window.find(QPushButton, "calibrationAccept0")
    window.wait(lambda: accept.visibleRegion().boundingRect() == accept.rect())

    review = ReviewDialog(window)
    review.open()
    check_keyboard(review.root)
    gain1, gain2, ramp2, ignored = findings_of(review, "review")
    assert "Motor 1 Current Limit is 3 A" in gain1
    assert review.button("reviewAccept2").text().startswith("Set Motor 2 Acceleration")

    def shows(*expected: str) -> bool:
        return findings_of(review, "review") == list(expected)

    review.click("reviewAccept0")
    review.wait(lambda: shows(gain2, ramp2, ignored))
    assert "motor1_current_limit_p" not in review.values(), "the board stores this value already"
    review.click("reviewAccept1")
    assert review.values()["motor2_acceleration"] == ("no ramp", "1.3 s to full speed")
    review.toggle("Motor 2 Current Limit")
    review.wait(lambda: shows(ignored))  # pending power-cycle values are not checked
    review.toggle("Motor 2 Current Limit")
    review.toggle("Motor 2 Acceleration")
    review.wait(lambda: shows(gain2, ramp2, ignored))
    review.click("reviewAccept1")
    review.wait(lambda: shows(gain2, ignored))  # because the edit will be written again

    review.click("writeButton")
    review.wait_for_text("reviewHead", "written and verified")
    parameters = quick_simulator.show()["parameters"]
    assert parameters["motor1_current_limit_p"] == 4
    assert parameters["motor2_current_limit_p"] == 0
    assert parameters["motor2_acceleration"] == 10
    review.wait(lambda: shows(gain2, ignored))
    assert not review.is_enabled("reviewAccept0")
