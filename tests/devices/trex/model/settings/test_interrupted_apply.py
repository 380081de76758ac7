"""Power cut, unplugged cable and closed line at every step of an Apply."""

from collections.abc import Callable, Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.trex.model.test_device import DeviceRecorder
from tests.support.matrix import sampled
from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import Skipped
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.settings.document import Settings, settings_of
from trex_gui.ui.devices.connection import ConnectionState

SPECS = parameters_of("trex", "1.2")
LEARNED = Calibration(2400, 3700, 5100, 80)
CHANNEL = 2

OLD = {"motor1_acceleration": 3, "motor2_acceleration": 4, "serial_timeout": 50}
"""What the board stores that is neither the factory's nor what is wanted."""

WANTED = {
    "motor1_acceleration": 9,
    "motor2_acceleration": 8,
    "serial_timeout": 20,
    "uart_error_shutdown": 0,
    "motor_mode": 1,
    "crc7_polynomial": 0x15,
    "uart_settings": LineSettings(57600, stop_bits=2).to_wire(),
}
STEPS = range(len(WANTED) + 2)
"""Before the calibration, before each parameter, and when all are written."""

every_step = pytest.mark.parametrize("step", sampled(STEPS, every=4))


class InterruptedApply:
    """Board with pending edits, and reports of an interrupted Apply."""

    def __init__(self, recorder: DeviceRecorder, simulator: SimulatedDevice) -> None:
        for key, wire in OLD.items():
            simulator.do(f"eeprom {key} {wire}")
        simulator.do("power cycle")
        self.recorder = recorder
        self.device = recorder.device
        self.simulator = simulator
        recorder.connect(simulator.url)
        for key, wire in WANTED.items():
            recorder.edit(key, wire)
        self.device.calibrations.edit(CHANNEL, LEARNED)
        assert self.device.state is not None
        self.before = settings_of(self.device.state)
        self.after = dict(self.before.parameters) | WANTED

    def disturb(self, step: int, act: Callable[[], object]) -> None:
        """Apply, and act when a step is reached."""
        done: list[int] = []

        def on_progressed(now: int, _total: int, _what: str) -> None:
            if now == step and not done:
                done.append(now)
                act()

        self.device.connection.progressed.connect(on_progressed)
        self.device.writer.apply()
        self.recorder.until(lambda: bool(done) and not self.device.writer.running)
        self.device.connection.progressed.disconnect(on_progressed)

    @property
    def results(self) -> tuple[WriteResult, ...]:
        """Results of the writes, as far as reported."""
        return self.recorder.results[-1] if self.recorder.results else ()

    @property
    def stored(self) -> dict[str, int]:
        parameters: dict[str, int] = self.simulator.show()["parameters"]
        return parameters

    def require_kept(self) -> None:
        """Check that the snapshot has all former values."""
        (snapshot,) = self.device.writer.history.snapshots()
        assert self.device.writer.history.load(snapshot) == self.before
        assert snapshot.reason == f"Apply of {len(WANTED) + 1} settings"
        assert snapshot.adapter

    def require_named(self) -> None:
        """Check that the report names every setting that is not stored."""
        reports = {result.key: result for result in self.results}
        assert set(reports) == {*WANTED, f"rc_channel_{CHANNEL}"}
        for key, wire in WANTED.items():
            if reports[key].error is None:
                assert self.stored[key] == wire
            else:
                assert str(reports[key].error)

    def require_waiting(self) -> None:
        """Check that only failed edits are pending."""
        waiting = dict(self.device.parameters.values.pending)
        stored = self.stored
        assert waiting == {key: wire for key, wire in WANTED.items() if stored[key] != wire}
        waits = CHANNEL in {key.channel for key, _ in self.device.calibrations.pending}
        assert waits == (self.device.calibrations.stored(CHANNEL) != LEARNED)

    def finish(self) -> None:
        """Apply again. Check that only the edits have changed."""
        if self.device.draft.pending:
            results = self.recorder.apply()
            assert [result.error for result in results] == [None] * len(results)
        assert self.device.draft.pending == 0
        assert self.stored == self.after
        assert self.device.calibrations.stored(CHANNEL) == LEARNED


@pytest.fixture
def applied(qtbot: QtBot, quick_simulator: SimulatedDevice) -> Iterator[InterruptedApply]:
    recorder = DeviceRecorder(qtbot)
    yield InterruptedApply(recorder, quick_simulator)
    qtbot.waitUntil(recorder.device.shut_down)  # no thread lives on


def require_old_or_new(stored: dict[str, int], before: Settings, *, lost: int) -> None:
    unexpected = {
        key for key in stored if stored[key] not in {before.parameters[key], WANTED.get(key)}
    }
    assert len(unexpected) <= lost
    assert all(stored[key] == SPECS[key].default for key in unexpected)


@every_step
def test_apply_resumes_after_a_power_cut(step: int, applied: InterruptedApply) -> None:
    applied.disturb(step, lambda: applied.simulator.do("power off"))
    applied.recorder.until_link(ConnectionState.NOT_RESPONDING)
    applied.simulator.do("power on")
    applied.require_kept()
    applied.require_named()
    require_old_or_new(applied.stored, applied.before, lost=1)

    # The board returns at the stored line settings, which Apply has announced.
    applied.recorder.until_link(ConnectionState.CONNECTED)
    applied.require_waiting()
    applied.finish()


@every_step
def test_apply_resumes_after_an_unplugged_cable(step: int, applied: InterruptedApply) -> None:
    applied.disturb(step, lambda: applied.simulator.do("line unplug"))
    applied.recorder.until_link(ConnectionState.DISCONNECTED)
    applied.require_kept()
    applied.require_named()
    require_old_or_new(applied.stored, applied.before, lost=0)

    applied.recorder.connect(applied.simulator.do("line plug").split()[-1])
    applied.require_waiting()
    applied.finish()


# --- Closed line ------------------------------------------------------------------------


def connect_after_power_cycle(applied: InterruptedApply) -> None:
    """Cycle the power, and connect at the stored line settings."""
    applied.simulator.do("power cycle")
    line = LineSettings.from_wire(applied.stored["uart_settings"])
    applied.device.connect_to(ConnectionSettings(applied.simulator.url, line))
    applied.recorder.until_link(ConnectionState.CONNECTED)


def require_report(applied: InterruptedApply) -> None:
    """Check that each setting is stored or was not tried, without a failure."""
    applied.require_kept()
    applied.require_named()
    applied.require_waiting()
    require_old_or_new(applied.stored, applied.before, lost=0)
    failures = [result.error for result in applied.results if result.error is not None]
    assert all(isinstance(error, Skipped) for error in failures)
    assert applied.recorder.failures == []
    pair = [applied.stored[key] == WANTED[key] for key in ("crc7_polynomial", "uart_settings")]
    assert len(set(pair)) == 1


@every_step
def test_apply_resumes_after_disconnecting(step: int, applied: InterruptedApply) -> None:
    applied.disturb(step, applied.device.disconnect_line)
    applied.recorder.until_link(ConnectionState.DISCONNECTED)
    require_report(applied)

    applied.recorder.connect(applied.simulator.url)
    applied.require_waiting()
    applied.finish()


@every_step
def test_shutdown_reports_the_results_of_an_apply(step: int, applied: InterruptedApply) -> None:
    ended: list[bool] = []
    reports: list[int] = []

    def end() -> None:
        ended.append(applied.device.shut_down())
        reports.append(len(applied.recorder.results))

    applied.disturb(step, end)
    assert (ended, reports) == ([True], [1])
    assert applied.device.link is ConnectionState.DISCONNECTED
    require_report(applied)

    connect_after_power_cycle(applied)
    applied.require_waiting()
    applied.finish()


# --- A board that is addressed by number ------------------------------------------------


@pytest.fixture
def addressed(qtbot: QtBot, quick_simulator: SimulatedDevice) -> Iterator[DeviceRecorder]:
    """Device that addresses its board by number 7."""
    recorder = DeviceRecorder(qtbot)
    recorder.device.connect_to(ConnectionSettings(quick_simulator.url, device_number=7))
    recorder.until_link(ConnectionState.CONNECTED)
    yield recorder
    qtbot.waitUntil(recorder.device.shut_down)  # no thread lives on


def test_renumbered_board_reconnects_after_power_cycle(
    addressed: DeviceRecorder, quick_simulator: SimulatedDevice
) -> None:
    addressed.edit("device_number", 9)
    addressed.edit("uart_settings", WANTED["uart_settings"])
    addressed.apply()
    quick_simulator.do("power off")
    addressed.until_link(ConnectionState.NOT_RESPONDING)
    quick_simulator.do("power on")
    addressed.until_link(ConnectionState.CONNECTED)
    assert addressed.device.settings is not None
    assert addressed.device.settings.device_number == 9
    assert addressed.device.parameters.values.stored.get("device_number") == 9
