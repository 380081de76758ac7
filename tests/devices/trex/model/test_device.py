"""Device with a real thread, a real line and a simulated board."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import now, runtime

LEARNED = Calibration(2400, 3700, 5100, 80)


class DeviceRecorder:
    """Device with its states, failures and results."""

    def __init__(self, qtbot: QtBot) -> None:
        self.device = Device()
        self.links: list[ConnectionState] = []
        self.failures: list[str] = []
        self.results: list[tuple[WriteResult, ...]] = []
        self.steps: list[tuple[int, int, str]] = []
        self.device.link_changed.connect(self._on_link_changed)
        self.device.notifier.error.connect(self.failures.append)
        self.device.applied.connect(self.results.append)
        self.device.connection.progressed.connect(self._on_progressed)
        self.qtbot = qtbot

    def _on_link_changed(self) -> None:
        self.links.append(self.device.link)

    def _on_progressed(self, done: int, total: int, what: str) -> None:
        self.steps.append((done, total, what))

    def until(self, condition: Callable[[], bool]) -> None:
        self.qtbot.waitUntil(condition)

    def until_link(self, link: ConnectionState) -> None:
        self.until(lambda: self.device.link is link)

    def connect(self, url: str, *, again: bool = False) -> None:
        self.device.connect_to(ConnectionSettings(url))
        if again:
            self.until(lambda: self.device.link is not ConnectionState.CONNECTED)
        failed = len(self.failures)
        self.until(
            lambda: self.device.link is ConnectionState.CONNECTED or len(self.failures) > failed
        )
        assert self.device.link is ConnectionState.CONNECTED, self.failures[failed:]

    def edit(self, key: str, wire: int) -> None:
        assert self.device.parameters.setData(self.device.parameters.index_of(key), wire)

    def apply(self) -> tuple[WriteResult, ...]:
        """Apply every edit, and return the results."""
        before = len(self.results)
        self.device.writer.apply()
        self.until(lambda: len(self.results) > before)
        return self.results[-1]


class RecorderOfBoard(DeviceRecorder):
    """Device beside a simulated board."""

    def __init__(self, simulator: SimulatedDevice, qtbot: QtBot) -> None:
        super().__init__(qtbot)
        self.simulator = simulator


@pytest.fixture
def recorder(quick_simulator: SimulatedDevice, qtbot: QtBot) -> Iterator[RecorderOfBoard]:
    recorder = RecorderOfBoard(quick_simulator, qtbot)
    yield recorder
    qtbot.waitUntil(recorder.device.shut_down)  # no thread remains


@pytest.fixture
def connected(recorder: RecorderOfBoard) -> RecorderOfBoard:
    recorder.connect(recorder.simulator.url)
    return recorder


# --- Connecting -------------------------------------------------------------------------


def test_connecting_reads_state_and_enables_arming(connected: RecorderOfBoard) -> None:
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
    assert connected.steps[-1][0] == connected.steps[-1][1]
    assert connected.failures == []


def test_missing_port_is_reported(recorder: RecorderOfBoard) -> None:
    recorder.device.connect_to(ConnectionSettings("/dev/ttyNothing9"))
    recorder.until_link(ConnectionState.DISCONNECTED)
    assert recorder.links == [ConnectionState.CONNECTING, ConnectionState.DISCONNECTED]
    assert len(recorder.failures) == 1
    assert "There is no port /dev/ttyNothing9" in recorder.failures[0]
    assert recorder.device.status == "Not connected."


# --- Editing ----------------------------------------------------------------------------


def test_edits_are_applied_and_verified(connected: RecorderOfBoard) -> None:
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


def test_apply_without_a_snapshot_writes_nothing(
    connected: RecorderOfBoard, tmp_path: Path
) -> None:
    (tmp_path / "taken").write_text("a file where the folder should be", encoding="utf-8")
    connected.device.writer.history.folder = tmp_path / "taken"
    connected.edit("serial_timeout", 15)
    connected.device.writer.apply()
    connected.until(lambda: not connected.device.writer.running)
    assert "Nothing was written" in connected.failures[-1]
    assert connected.device.draft.pending == 1
    assert connected.simulator.show()["parameters"]["serial_timeout"] == 0


def test_apply_without_edits_writes_nothing(connected: RecorderOfBoard) -> None:
    connected.device.writer.apply()
    connected.device.reload()
    steps = len(connected.steps)
    connected.until(
        lambda: len(connected.steps) > steps and connected.steps[-1][0] == connected.steps[-1][1]
    )
    assert connected.results == []


def test_apply_without_a_board_does_not_lock_apply(connected: RecorderOfBoard) -> None:
    connected.edit("serial_timeout", 9)
    connected.device.disconnect_line()
    connected.until_link(ConnectionState.DISCONNECTED)
    connected.device.writer.apply()
    assert not connected.device.writer.running
    connected.connect(connected.simulator.url)
    assert connected.apply()[0].error is None


# --- Power ------------------------------------------------------------------------------


def test_power_cycle_activates_waiting_parameter(connected: RecorderOfBoard) -> None:
    connected.edit("motor_mode", 1)
    connected.apply()
    assert connected.device.parameters.values.waiting_for_power == ("Motor Mode",)
    assert connected.device.parameters.values.active_of("motor_mode") == 0
    connected.simulator.do("power off")
    connected.until_link(ConnectionState.NOT_RESPONDING)
    waiting = [connected.device.parameters.values.waiting_for_power]
    connected.simulator.do("power on")
    connected.until_link(ConnectionState.CONNECTED)
    waiting.append(connected.device.parameters.values.waiting_for_power)
    assert waiting == [("Motor Mode",), ()]
    assert connected.device.parameters.values.active_of("motor_mode") == 1
    assert connected.failures == []


def test_unpowered_board_cannot_be_driven(connected: RecorderOfBoard) -> None:
    connected.device.motors.arm()
    connected.simulator.do("power off")
    connected.until_link(ConnectionState.NOT_RESPONDING)
    assert not connected.device.motors.armed
    assert not connected.device.motors.is_available
    assert connected.device.telemetry.raw is None
    assert "power" in connected.device.status


@pytest.mark.parametrize("maximum", [0x3F, 0x40])
def test_edits_that_another_board_may_get_are_mentioned(
    connected: RecorderOfBoard, maximum: int
) -> None:
    """The board may be another of the same model."""
    device, texts = connected.device, list[str]()
    device.notifier.delayed_info.connect(texts.append)
    connected.edit("motor1_acceleration", 5)
    connected.simulator.do("line mute on")
    connected.until_link(ConnectionState.NOT_RESPONDING)
    connected.simulator.do(f"eeprom motor1_pwm_maximum {maximum}")
    connected.simulator.do("power cycle")
    connected.simulator.do("line mute off")
    connected.until_link(ConnectionState.CONNECTED)
    assert device.draft.pending == 1
    may_be_other = maximum != 0x3F
    assert [text for text in texts if "still pending" in text] == texts
    assert bool(texts) is may_be_other


def test_doubt_about_the_record_is_said(recorder: RecorderOfBoard) -> None:
    device, said = recorder.device, list[str]()
    device.records.doubted.connect(said.append)
    for adapter in ("0403:6001-A500001", "0403:6001-B700002"):
        device.motors.adapter = adapter
        recorder.connect(recorder.simulator.url, again=device.is_connected)
        recorder.until(lambda: device.records.files.is_idle)
    assert "settings saved for this TReX date from 20" in "".join(said)


# --- Motors -----------------------------------------------------------------------------


def test_unanswered_stop_is_reported(connected: RecorderOfBoard) -> None:
    connected.simulator.do("power off")
    connected.device.motors.stop()
    connected.until(lambda: bool(connected.failures))
    assert "cut its power" in connected.failures[0]


def test_stop_without_a_connection_is_harmless(recorder: RecorderOfBoard) -> None:
    recorder.device.motors.stop()
    assert recorder.failures == []
    recorder.device.reload()
    assert recorder.failures == ["No board is connected."]


def test_channel_driven_motors_cannot_be_armed(
    recorder: RecorderOfBoard, start_simulator: StartSimulator
) -> None:
    recorder.connect(start_simulator("--mode", "rc").url)
    assert not recorder.device.motors.is_available
    recorder.device.motors.arm()
    assert not recorder.device.motors.armed
    assert "The RC channels control the motors" in recorder.device.board.control_text


# --- The end of a line ------------------------------------------------------------------


def test_disconnecting_reports_no_failure(connected: RecorderOfBoard) -> None:
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


def test_closing_connection_is_never_reported_connected(
    simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    recorder = RecorderOfBoard(simulator, qtbot)
    recorder.device.connect_to(ConnectionSettings(simulator.url))
    while simulator.show()["counters"]["packets"] < 45:
        runtime().sleep(0.001)  # the window hangs, so `Connected` is queued
    recorder.device.disconnect_line()
    recorder.until_link(ConnectionState.DISCONNECTED)
    assert recorder.links == [
        ConnectionState.CONNECTING,
        ConnectionState.DISCONNECTING,
        ConnectionState.DISCONNECTED,
    ]
    qtbot.waitUntil(recorder.device.shut_down)


def test_unplugged_cable_is_reported_within_half_a_second(connected: RecorderOfBoard) -> None:
    connected.device.motors.arm()
    connected.simulator.do("line unplug")
    begun = now()
    connected.until_link(ConnectionState.DISCONNECTED)
    assert now() - begun < 0.5
    assert len(connected.failures) == 1
    assert "Plug the adapter in, then connect again" in connected.failures[0]
    assert not connected.device.motors.is_available


def test_line_is_closed_before_another_is_opened(
    connected: RecorderOfBoard, start_simulator: StartSimulator
) -> None:
    connected.edit("serial_timeout", 15)
    other = start_simulator("--model", "trexjr")
    connected.connect(other.url, again=True)
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
    fresh = DeviceRecorder(connected.qtbot)
    fresh.connect(connected.simulator.url)  # the line is free
    fresh.until(fresh.device.shut_down)


def test_last_of_several_chosen_ports_is_connected(
    connected: RecorderOfBoard, start_simulator: StartSimulator
) -> None:
    other = start_simulator("--model", "trexjr")
    connected.device.connect_to(ConnectionSettings("/dev/ttyNothing9"))
    connected.connect(other.url, again=True)
    assert connected.device.settings == ConnectionSettings(other.url)
    assert connected.failures == []


def test_device_does_not_change_after_shutdown(connected: RecorderOfBoard, qtbot: QtBot) -> None:
    connected.until(connected.device.shut_down)
    links = list(connected.links)
    states: list[None] = []
    connected.device.telemetry.updated.connect(lambda: states.append(None))
    with pytest.raises(qtbot.TimeoutError):
        qtbot.waitUntil(lambda: connected.links != links or bool(states), timeout=200)
    assert connected.links == links
    assert connected.failures == []
    assert connected.device.state is None
