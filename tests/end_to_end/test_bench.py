"""Bench tests in the window: the motor runs only while the button is held."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QSpinBox

from tests.support.pages.bench_dialog import BenchTestDialog
from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.devices.trex.bench.run import Plan, Profile
from trex_gui.devices.trex.views.bench.dialog import BenchDialog


@pytest.fixture
def dialog(connected_window: WindowDriver, quick_simulator: SimulatedDevice) -> BenchTestDialog:
    window, device = connected_window, connected_window.device
    window.wait(lambda: device.telemetry.motor_currents is not None)
    window.trigger("bench")
    dialog = window.find(BenchDialog, "benchDialog")
    dialog.bench.set_plan(Plan(profile=Profile(speed=60, duration=20.0), abort_current=30.0))
    return BenchTestDialog(dialog, device, dialog.bench, window.qtbot, quick_simulator)


def test_escape_and_closing_end_the_run_and_disarm(dialog: BenchTestDialog) -> None:
    dialog.hold()
    QTest.keyClick(dialog.hold_button, Qt.Key.Key_Escape)
    dialog.wait_for_end()
    assert dialog.bench.runs[-1].reason == "Stop was pressed."
    assert not dialog.motors.armed
    assert dialog.motors.locked_for > 0
    assert not dialog.hold_button.isEnabled()
    assert dialog.root.isVisible()
    dialog.release()

    dialog.hold()
    dialog.root.close()
    assert not dialog.root.isVisible()
    dialog.wait_for_end()
    assert not dialog.motors.armed
    dialog.release()


def test_bench_dialog_edits_and_applies_settings(
    dialog: BenchTestDialog, connected_window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    dialog.find(QSpinBox, "bench_motor1_acceleration").setValue(25)
    assert "Acceleration (stored: no ramp)" in dialog.text("benchEdited")
    dialog.click("benchApplyButton")
    connected_window.click("writeButton")
    dialog.wait(lambda: quick_simulator.show()["parameters"]["motor1_acceleration"] == 25)
    dialog.wait(lambda: not dialog.has("benchEdited"))

    dialog.bench.set_plan(Plan(motor=2))
    dialog.find(QSpinBox, "bench_motor2_current_limit").setValue(30)
    parameters = connected_window.device.parameters
    assert parameters.values.value_of("motor2_current_limit") == 30
    assert parameters.values.value_of("motor1_current_limit") == 0
