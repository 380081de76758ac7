"""Bench tests that drive a motor while a button is held."""

from dataclasses import replace
from datetime import UTC, datetime
from enum import Enum, auto

from PySide6.QtCore import QObject, Qt, Signal, Slot

from trex_gui.core.events import EventKind
from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.bench.run import End, Plan, Run
from trex_gui.devices.trex.client.telemetry import Currents, LatchedStatus
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import held_drive_blocker
from trex_gui.devices.trex.protocol.flags import MOTOR_FAULTS, OVER_LIMITS, UartError
from trex_gui.devices.trex.session.messages import Batch
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import new_timer, now

_HOLDER = "bench"  # holder name for `Motors.acquire`
_MAX_RUNS = 10  # newest tests, which stay in memory for comparison
_HIGHEST_COUNT = 255  # the board reports a current in one byte (0x8D)
_TUNED_SUFFIXES = ("acceleration", "brake_duration", "current_limit", "current_limit_p")

_ABORT_COUNTS = 100
"""Default abort current in counts: 15 A, or 4 A on a Jr.

These currents exceed the continuous ratings of the drivers (13 A and 2.5 A).
"""

_STEP_MS = 20  # the board updates its outputs every 10 ms
_TAIL = 0.6  # s; duration of the recording while the motor brakes


class Phase(Enum):
    IDLE = auto()
    DRIVING = auto()
    BRAKING = auto()  # the motor brakes, and its current is still recorded


class Bench(QObject):
    """Runs one test at a time while a button is held.

    Releasing the button brakes the motor. Excessive current, a fault, missing readings or loss of
    serial control aborts a test. An abort stops, disarms and locks out all motors.
    """

    changed = Signal()  # `plan`, `phase`, `runs` or `blocker`; not emitted for new readings
    started = Signal()
    finished = Signal(object)  # the finished `Run`, which is also the last of `runs`

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.plan = Plan()
        self.phase = Phase.IDLE
        self.runs: tuple[Run, ...] = ()  # oldest first
        self._device = device
        self._motors = device.motors
        self._run: Run | None = None
        self._ends_at_limit = False
        self._ampere = 0.0  # A per count when `plan.abort_current` was set
        self._started_at = self._last_reading = 0.0
        self._setpoints: list[tuple[float, int]] = []
        self._readings: list[tuple[float, float]] = []
        self._timer = new_timer(self, _STEP_MS, self._on_step)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)

        device.sampled.connect(self._on_sampled)
        motors = self._motors
        for signal in (
            motors.arming_changed,
            motors.setpoints_changed,
            motors.holder_changed,
            motors.options_changed,
        ):
            signal.connect(self._on_motors_changed)
        device.link_changed.connect(self._on_link_changed)
        device.state_changed.connect(self._on_state_changed)
        self._on_state_changed()

    # --- State --------------------------------------------------------------------------

    @property
    def is_driving(self) -> bool:
        return self.phase is Phase.DRIVING

    @property
    def latest_run(self) -> Run | None:
        if self._run is None:
            return self.runs[-1] if self.runs else None
        return replace(
            self._run,
            ended=now() - self._started_at if self.is_driving else self._run.ended,
            setpoints=tuple(self._setpoints),
            currents=tuple(self._readings),
        )

    @property
    def highest_current(self) -> float:
        """Highest measurable current in A."""
        return self._device.telemetry.ampere * _HIGHEST_COUNT

    def tuned_keys(self) -> tuple[str, ...]:
        return tuple(f"motor{self.plan.motor}_{name}" for name in _TUNED_SUFFIXES)

    @property
    def blocker(self) -> str:
        """Reason why no test can start, or an empty string."""
        device = self._device
        if device.is_connected and device.board.is_joint:
            return tr(
                "In joint mode the board measures no current, so excessive current could not "
                "abort a test."
            )
        if reason := held_drive_blocker(device, _HOLDER):
            return reason
        if device.telemetry.motor_currents is None:
            return tr("No current has been read yet.")
        return ""

    # --- Commands -----------------------------------------------------------------------

    def set_plan(self, plan: Plan) -> None:
        if plan != self.plan:
            self.plan = plan
            self.changed.emit()

    def start(self) -> bool:
        if self.phase is Phase.BRAKING:
            self._finish()
        if self.phase is not Phase.IDLE or self.blocker:
            return False
        plan = self.plan
        if not self._motors.acquire(_HOLDER, accelerate=plan.accelerate):
            return False
        self._ends_at_limit = plan.abort_at_limit
        self._started_at = self._last_reading = now()
        self._setpoints, self._readings = [], []
        self._run = Run(
            motor=plan.motor,
            profile=plan.profile.limited(self._motors.ceiling),
            accelerate=plan.accelerate,
            abort_current=plan.abort_current,
            ampere=self._device.telemetry.ampere,
            started=datetime.now(UTC).astimezone(),
            end=End.COMPLETE,
            ended=0.0,
            setpoints=(),
            currents=(),
            settings=self._settings(),
        )
        self.phase = Phase.DRIVING
        text = tr("Bench test of motor {0}: {1}").format(plan.motor, self._run.title)
        self._device.events.add(EventKind.NOTE, text)
        self._timer.start()
        self._on_step()
        self.changed.emit()
        self.started.emit()
        return True

    def release(self) -> None:
        if self.is_driving:
            self._end(End.RELEASED)

    def abort(self, reason: str) -> None:
        """Stop, disarm and lock out all motors."""
        if self.is_driving:
            self._end(End.ABORTED, reason)

    def add_run(self, run: Run) -> None:
        self.runs = (*self.runs[-_MAX_RUNS + 1 :], run)
        self.changed.emit()
        self.finished.emit(run)

    # --- During a test ------------------------------------------------------------------

    @Slot()
    def _on_step(self) -> None:
        elapsed, run = now() - self._started_at, self._run
        if run is None:
            return
        if self.phase is Phase.BRAKING:
            if elapsed >= run.ended + _TAIL:
                self._finish()
        elif elapsed >= run.profile.duration:
            self._end(End.COMPLETE)
        elif now() - self._last_reading > (gap := self._device.timeouts.current_gap):
            self.abort(tr("No current was read for {0:g} s.").format(Number(gap)))
        else:
            speed = run.profile.speed_at(elapsed)
            if not self._setpoints or self._setpoints[-1][1] != speed:
                self._motors.set_speed(run.motor, speed, _HOLDER)
                if self.is_driving:  # setting the speed may have caused a stop
                    self._setpoints.append((elapsed, speed))

    @Slot(object)
    def _on_sampled(self, batch: Batch) -> None:
        run = self._run
        if run is None:
            return
        for sample in batch.samples:
            if sample.time < self._started_at:
                continue  # measured before the first setpoint
            if isinstance(sample, Currents):
                self._last_reading = sample.time
                amps = sample.counts[run.motor - 1] * run.ampere
                self._readings.append((sample.time - self._started_at, amps))
                if amps > run.abort_current:
                    text = tr("Motor {0} drew {1:.2f} A, more than the abort current of {2:g} A.")
                    self.abort(text.format(run.motor, Number(amps), Number(run.abort_current)))
            elif isinstance(sample, LatchedStatus):
                self._check_status(run.motor, sample)

    def _check_status(self, motor: int, sample: LatchedStatus) -> None:
        if sample.status & MOTOR_FAULTS[motor]:
            self.abort(tr("The driver of motor {0} reported a fault.").format(motor))
        elif sample.uart & UartError.TIMEOUT:
            self.abort(tr("The board received nothing within its Serial Timeout."))
        elif self._ends_at_limit and sample.status & OVER_LIMITS[motor]:
            self.abort(tr("Motor {0} exceeded its current limit.").format(motor))

    @Slot()
    def _on_motors_changed(self) -> None:
        if not self.is_driving:
            self.changed.emit()
        elif self._motors.holder != _HOLDER:
            # If the connection is lost, `_finish` adds the reason.
            is_reason_known = self._motors.is_available or self._motors.stop_reason
            self._end(End.ABORTED, self._external_reason() if is_reason_known else "")

    @Slot()
    def _on_link_changed(self) -> None:
        if self._run is not None and not self._device.is_connected:
            self.abort("")
            self._finish()
        self.changed.emit()

    @Slot()
    def _on_state_changed(self) -> None:
        if (ampere := self._device.telemetry.ampere) != self._ampere:
            self._ampere = ampere
            self.plan = replace(self.plan, abort_current=round(_ABORT_COUNTS * ampere, 2))
        self.changed.emit()

    def _external_reason(self) -> str:
        if self._device.link is ConnectionState.NOT_RESPONDING:
            return tr("The board does not respond.")
        if not self._device.is_connected:
            return tr("The connection was closed.")
        if self._device.board.serial_controls is False:
            return tr("Serial commands no longer reach the motors.")
        return self._motors.stop_reason or tr("Stop was pressed.")

    # --- End of a test ------------------------------------------------------------------

    def _end(self, end: End, reason: str = "") -> None:
        self.phase = Phase.BRAKING
        if end is not End.ABORTED:
            self._motors.release(_HOLDER)
        elif self._motors.holder == _HOLDER:  # otherwise the motors are already stopped
            self._motors.press_stop(reason=reason)
        if self._run is not None:
            self._run = replace(self._run, end=end, reason=reason, ended=now() - self._started_at)
        self.changed.emit()

    def _finish(self) -> None:
        run = self.latest_run
        self._timer.stop()
        self.phase = Phase.IDLE
        self._run = None
        if run is not None:
            if run.end is End.ABORTED and not run.reason:
                # The reason is known only now, because motors are disarmed before the link changes.
                run = replace(run, reason=self._external_reason())
            self.add_run(run)

    def _settings(self) -> tuple[tuple[str, str], ...]:
        values = self._device.parameters.values
        specs = [values.specs[key] for key in self.tuned_keys() if key in values.stored]
        return tuple((spec.name, spec.text(values.stored[spec.key])) for spec in specs)
