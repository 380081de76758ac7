"""Device with a simulated board."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.trex.model.device_setup import DeviceSetup
from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import now, runtime

LEARNED = Calibration(2400, 3700, 5100, 80)


class DeviceRecorder(DeviceSetup):
    """Device with a simulated board. Records link states, failures and results."""

    def __init__(self, qtbot: QtBot, simulator: SimulatedDevice) -> None:
        super().__init__(qtbot, simulator)
        self.links: list[ConnectionState] = []
        self.failures: list[str] = []
        self.results: list[tuple[WriteResult, ...]] = []
        self.device.link_changed.connect(self._on_link_changed)
        self.device.notifier.error.connect(self.failures.append)
        self.device.applied.connect(self.results.append)

    def _on_link_changed(self) -> None:
        self.links.append(self.device.link)

    def edit(self, key: str, wire: int) -> None:
        assert self.device.parameters.setData(self.device.parameters.index_of(key), wire)

    def apply(self) -> tuple[WriteResult, ...]:
        """Apply every edit, and return the results."""
        self.write()
        return self.results[-1]


@pytest.fixture
def recorder(quick_simulator: SimulatedDevice, qtbot: QtBot) -> Iterator[DeviceRecorder]:
    recorder = DeviceRecorder(qtbot, quick_simulator)
    yield recorder
    recorder.shut_down()


@pytest.fixture
def connected(recorder: DeviceRecorder) -> DeviceRecorder:
    recorder.connect()
    return recorder


# --- Connecting -------------------------------------------------------------------------


def test_connecting_reads_state_and_enables_arming(connected: DeviceRecorder) -> None:
    device = connected.device
    assert connected.links == [ConnectionState.CONNECTING, ConnectionState.CONNECTED]
    assert "Connected to TReX 1.2" in device.status
    assert device.state is not None
    assert device.state.parameters == connected.simulator.show()["parameters"]
    assert device.calibrations.stored(1) == device.state.calibrations[1]
    assert device.board.serial_controls is True
    assert device.motors.is_available
    assert not device.motors.armed
    assert not device.board.echo
    assert connected.failures == []


# --- Editing ----------------------------------------------------------------------------


def test_edits_are_applied_and_verified(connected: DeviceRecorder) -> None:
    connected.edit("serial_timeout", 15)
    connected.device.calibrations.edit(2, LEARNED)
    assert connected.device.draft.pending == 2
    results = connected.apply()
    assert set(results) == {
        WriteResult(CalibrationKey.RC_CHANNEL_2, LEARNED),
        WriteResult("serial_timeout", 15),
    }
    assert connected.device.draft.pending == 0
    assert connected.simulator.show()["parameters"]["serial_timeout"] == 15
    assert connected.device.calibrations.stored(2) == LEARNED


def test_apply_without_a_snapshot_writes_nothing(connected: DeviceRecorder, tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.write_text("", encoding="utf-8")
    connected.device.writer.history.folder = file
    connected.edit("serial_timeout", 15)
    connected.write()
    assert "Nothing was written" in connected.failures[-1]
    assert connected.device.draft.pending == 1
    assert connected.simulator.show()["parameters"]["serial_timeout"] == 0


def test_apply_without_edits_writes_nothing(connected: DeviceRecorder) -> None:
    connected.write()
    connected.pass_time(1)
    assert connected.results == []


def test_apply_without_a_board_does_not_block_the_next_apply(connected: DeviceRecorder) -> None:
    connected.edit("serial_timeout", 9)
    connected.disconnect()
    connected.device.writer.apply()
    assert not connected.device.writer.running
    connected.connect()
    assert connected.apply()[0].error is None


# --- Power ------------------------------------------------------------------------------


def test_power_cycle_activates_a_waiting_parameter(connected: DeviceRecorder) -> None:
    connected.edit("motor_mode", 1)
    connected.apply()
    values = connected.device.parameters.values
    assert values.waiting_for_power == ("Motor Mode",)
    assert values.active_of("motor_mode") == 0
    connected.simulator.do("power off")
    connected.until_link(ConnectionState.NOT_RESPONDING)
    waiting = [values.waiting_for_power]
    connected.simulator.do("power on")
    connected.until_link(ConnectionState.CONNECTED)
    waiting.append(values.waiting_for_power)
    assert waiting == [("Motor Mode",), ()]
    assert values.active_of("motor_mode") == 1
    assert connected.failures == []


def test_unpowered_board_cannot_be_driven(connected: DeviceRecorder) -> None:
    connected.device.motors.arm()
    connected.simulator.do("power off")
    connected.until_link(ConnectionState.NOT_RESPONDING)
    assert not connected.device.motors.armed
    assert not connected.device.motors.is_available
    assert connected.device.telemetry.raw is None
    assert "power" in connected.device.status


@pytest.mark.parametrize("maximum", [0x3F, 0x40])
def test_pending_edits_are_reported_if_the_board_may_be_another(
    connected: DeviceRecorder, maximum: int
) -> None:
    """Another value of a stored parameter suggests another board of the same model."""
    device, texts = connected.device, list[str]()
    device.notifier.delayed_info.connect(texts.append)
    connected.edit("motor1_acceleration", 5)
    connected.simulator.do("line mute on")
    connected.until_link(ConnectionState.NOT_RESPONDING)
    connected.simulator.do(f"eeprom motor1_pwm_maximum {maximum}", "power cycle", "line mute off")
    connected.until_link(ConnectionState.CONNECTED)
    assert device.draft.pending == 1
    assert [text for text in texts if "still pending" in text] == texts
    assert bool(texts) is (maximum != 0x3F)


def test_doubt_about_the_board_record_is_reported(recorder: DeviceRecorder) -> None:
    device, texts = recorder.device, list[str]()
    device.records.doubted.connect(texts.append)
    for adapter in ("0403:6001-A500001", "0403:6001-B700002"):
        device.motors.adapter = adapter
        recorder.connect()
        recorder.until(lambda: device.records.files.is_idle)
    assert "settings saved for this TReX date from 20" in "".join(texts)


# --- Motors -----------------------------------------------------------------------------


def test_stop_without_a_reply_is_reported(connected: DeviceRecorder) -> None:
    connected.simulator.do("power off")
    connected.device.motors.stop()
    connected.until(lambda: bool(connected.failures))
    assert "cut its power" in connected.failures[0]


def test_only_reading_without_a_connection_is_reported(recorder: DeviceRecorder) -> None:
    recorder.device.motors.stop()
    recorder.device.reload()
    assert recorder.failures == ["No board is connected."]


def test_channel_driven_motors_cannot_be_armed(
    recorder: DeviceRecorder, start_simulator: StartSimulator
) -> None:
    recorder.connect(start_simulator("--mode", "rc").url)
    assert not recorder.device.motors.is_available
    recorder.device.motors.arm()
    assert not recorder.device.motors.armed
    assert "The RC channels control the motors" in recorder.device.board.control_text


# --- End of a connection ----------------------------------------------------------------


def test_disconnecting_reports_no_failure(connected: DeviceRecorder) -> None:
    connected.device.disconnect_line()
    connected.device.disconnect_line()
    assert connected.device.link is ConnectionState.DISCONNECTING
    connected.until_link(ConnectionState.DISCONNECTED)
    assert connected.links.count(ConnectionState.DISCONNECTED) == 1
    assert connected.failures == []
    assert connected.device.state is None
    assert connected.device.status == "Not connected."
    assert connected.device.telemetry.raw is None
    assert connected.device.parameters.rowCount() > 0  # still displayed


def test_closing_connection_never_becomes_connected(
    simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    recorder = DeviceRecorder(qtbot, simulator)
    recorder.device.connect_to(ConnectionSettings(simulator.url))
    while simulator.show()["counters"]["packets"] < 45:
        runtime().sleep(0.001)  # the window hangs, so `Connected` stays queued
    recorder.device.disconnect_line()
    recorder.until_link(ConnectionState.DISCONNECTED)
    assert recorder.links == [
        ConnectionState.CONNECTING,
        ConnectionState.DISCONNECTING,
        ConnectionState.DISCONNECTED,
    ]
    recorder.shut_down()


def test_unplugged_cable_is_reported_within_half_a_second(connected: DeviceRecorder) -> None:
    connected.device.motors.arm()
    connected.simulator.do("line unplug")
    start = now()
    connected.until_link(ConnectionState.DISCONNECTED)
    assert now() - start < 0.5
    assert len(connected.failures) == 1
    assert "Plug the adapter in, then connect again" in connected.failures[0]
    assert not connected.device.motors.is_available


def test_line_is_closed_before_another_is_opened(
    connected: DeviceRecorder, start_simulator: StartSimulator
) -> None:
    connected.edit("serial_timeout", 15)
    second = start_simulator("--model", "trexjr")
    connected.connect(second.url)
    assert connected.links == [
        ConnectionState.CONNECTING,
        ConnectionState.CONNECTED,
        ConnectionState.DISCONNECTING,
        ConnectionState.CONNECTING,
        ConnectionState.CONNECTED,
    ]
    assert connected.device.state is not None
    assert connected.device.state.signature.model.key == "trexjr"
    assert connected.device.parameters.values.pending == ()
    assert connected.failures == []
    recorder = DeviceRecorder(connected.qtbot, connected.simulator)
    recorder.connect()  # the first line is closed
    recorder.shut_down()


def test_last_of_several_selected_ports_is_connected(
    connected: DeviceRecorder, start_simulator: StartSimulator
) -> None:
    second = start_simulator("--model", "trexjr")
    connected.device.connect_to(ConnectionSettings("/dev/ttyNothing9"))
    connected.connect(second.url)
    assert connected.device.settings == ConnectionSettings(second.url)
    assert connected.failures == []


def test_device_does_not_change_after_shutdown(connected: DeviceRecorder, qtbot: QtBot) -> None:
    connected.until(connected.device.shut_down)
    links = list(connected.links)
    states: list[None] = []
    connected.device.telemetry.updated.connect(lambda: states.append(None))
    with pytest.raises(qtbot.TimeoutError):
        qtbot.waitUntil(lambda: connected.links != links or bool(states), timeout=200)
    assert connected.links == links
    assert connected.failures == []
    assert connected.device.state is None
