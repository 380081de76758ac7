"""Power cut and end of the program at every step of Apply."""

from collections.abc import Callable, Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.trex.model.test_device import DeviceRecorder
from tests.support.matrix import sampled
from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import Skipped
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.settings.document import settings_of
from trex_gui.ui.devices.connection import ConnectionState

SPECS = parameters_of("trex", "1.2")
LEARNED = Calibration(2400, 3700, 5100, 80)
CHANNEL = 2

OLD = {"motor1_acceleration": 3, "motor2_acceleration": 4, "serial_timeout": 50}
"""Stored values. They differ from the factory defaults and from the edits."""

EDITS = {
    "motor1_acceleration": 9,
    "motor2_acceleration": 8,
    "serial_timeout": 20,
    "uart_error_shutdown": 0,
    "motor_mode": 1,
    "crc7_polynomial": 0x15,
    "uart_settings": LineSettings(57600, stop_bits=2).to_wire(),
}
STEPS = range(len(EDITS) + 2)
"""Before the calibration, before each parameter, and after the last write."""

every_step = pytest.mark.parametrize("step", sampled(STEPS, every=4))


class InterruptedApply:
    """Board with pending edits, and checks of an interrupted Apply."""

    def __init__(self, recorder: DeviceRecorder) -> None:
        self.recorder = recorder
        self.device = recorder.device
        self.simulator = simulator = recorder.simulator
        for key, wire in OLD.items():
            simulator.do(f"eeprom {key} {wire}")
        simulator.do("power cycle")
        recorder.connect()
        for key, wire in EDITS.items():
            recorder.edit(key, wire)
        self.device.calibrations.edit(CHANNEL, LEARNED)
        assert self.device.state is not None
        self.before = settings_of(self.device.state)
        self.after = dict(self.before.parameters) | EDITS

    def disturb(self, step: int, act: Callable[[], object]) -> None:
        """Apply the edits. Call `act` when a step is reached."""
        done: list[int] = []

        def on_progressed(current: int, _total: int, _text: str) -> None:
            if current == step and not done:
                done.append(current)
                act()

        self.device.connection.progressed.connect(on_progressed)
        self.device.writer.apply()
        self.recorder.until(lambda: bool(done) and not self.device.writer.running)
        self.device.connection.progressed.disconnect(on_progressed)

    @property
    def stored(self) -> dict[str, int]:
        parameters: dict[str, int] = self.simulator.show()["parameters"]
        return parameters

    def require_consistency(self, *, lost: int) -> None:
        """Check snapshot and results, and that all but `lost` values are old or new."""
        (snapshot,) = self.device.writer.history.snapshots()
        assert self.device.writer.history.load(snapshot) == self.before
        assert snapshot.reason == f"Apply of {len(EDITS) + 1} settings"
        assert snapshot.adapter
        errors = {result.key: result.error for result in self.recorder.results[-1]}
        assert set(errors) == {*EDITS, f"rc_channel_{CHANNEL}"}
        for key, wire in EDITS.items():
            if errors[key] is None:
                assert self.stored[key] == wire
            else:
                assert str(errors[key])
        stored, before = self.stored, self.before.parameters
        unexpected = {key for key in stored if stored[key] not in {before[key], EDITS.get(key)}}
        assert len(unexpected) <= lost
        assert all(stored[key] == SPECS[key].default for key in unexpected)

    def require_pending(self) -> None:
        """Check that only failed edits are pending."""
        pending = dict(self.device.parameters.values.pending)
        stored = self.stored
        assert pending == {key: wire for key, wire in EDITS.items() if stored[key] != wire}
        channels = {key.channel for key, _ in self.device.calibrations.pending}
        assert (CHANNEL in channels) == (self.device.calibrations.stored(CHANNEL) != LEARNED)

    def finish(self) -> None:
        """Apply the pending edits. Check that nothing else has changed."""
        if self.device.draft.pending:
            results = self.recorder.apply()
            assert [result.error for result in results] == [None] * len(results)
        assert self.device.draft.pending == 0
        assert self.stored == self.after
        assert self.device.calibrations.stored(CHANNEL) == LEARNED


@pytest.fixture
def apply(qtbot: QtBot, quick_simulator: SimulatedDevice) -> Iterator[InterruptedApply]:
    recorder = DeviceRecorder(qtbot, quick_simulator)
    yield InterruptedApply(recorder)
    recorder.shut_down()


@every_step
def test_apply_resumes_after_a_power_cut(step: int, apply: InterruptedApply) -> None:
    apply.disturb(step, lambda: apply.simulator.do("power off"))
    apply.recorder.until_link(ConnectionState.NOT_RESPONDING)
    apply.simulator.do("power on")
    apply.require_consistency(lost=1)

    # The board responds at the stored line settings, which Apply has announced to the session.
    apply.recorder.until_link(ConnectionState.CONNECTED)
    apply.require_pending()
    apply.finish()


# --- Closed connection ------------------------------------------------------------------


@every_step
def test_shutdown_reports_the_results_of_apply(step: int, apply: InterruptedApply) -> None:
    outcomes: list[tuple[bool, int]] = []

    def shut_down() -> None:
        is_closed = apply.device.shut_down()
        outcomes.append((is_closed, len(apply.recorder.results)))

    apply.disturb(step, shut_down)
    assert outcomes == [(True, 1)]
    assert apply.device.link is ConnectionState.DISCONNECTED
    apply.require_consistency(lost=0)
    apply.require_pending()
    failures = [result.error for result in apply.recorder.results[-1] if result.error is not None]
    assert all(isinstance(error, Skipped) for error in failures)
    assert apply.recorder.failures == []

    apply.simulator.do("power cycle")
    line = LineSettings.from_wire(apply.stored["uart_settings"])
    apply.device.connect_to(ConnectionSettings(apply.simulator.url, line))
    apply.recorder.until_link(ConnectionState.CONNECTED)
    apply.require_pending()
    apply.finish()


# --- Board that is addressed by its number ----------------------------------------------


def test_renumbered_board_reconnects_after_power_cycle(
    qtbot: QtBot, quick_simulator: SimulatedDevice
) -> None:
    recorder = DeviceRecorder(qtbot, quick_simulator)
    recorder.device.connect_to(ConnectionSettings(quick_simulator.url, device_number=7))
    recorder.until_link(ConnectionState.CONNECTED)
    recorder.edit("device_number", 9)
    recorder.edit("uart_settings", EDITS["uart_settings"])
    recorder.apply()
    recorder.cycle_power()
    assert recorder.device.settings is not None
    assert recorder.device.settings.device_number == 9
    assert recorder.device.parameters.values.stored.get("device_number") == 9
    recorder.shut_down()
