"""Bench tests: a motor is driven along a profile while the user holds a button."""

from collections.abc import Callable
from dataclasses import replace
from datetime import UTC, datetime
from enum import Enum, auto

from PySide6.QtCore import QCoreApplication, QObject, Qt, Signal, Slot

from trex_gui.devices.trex.bench.profile import Plan
from trex_gui.devices.trex.bench.run import End, Run
from trex_gui.devices.trex.client.telemetry import Currents, LatchedStatus
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.flags import Status, UartError
from trex_gui.devices.trex.session.messages import Batch
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.event_log import EventKind
from trex_gui.ui.runtime import now, runtime

HOLDER = "bench"
"""The name by which the motors know that a bench test drives them."""

MAX_RUNS = 10
"""Tests kept for comparison."""

HIGHEST_COUNT = 255
"""The current measurement is one byte (0x8D)."""

_TREX_AMPERE = 0.15

TUNED = ("acceleration", "brake_duration", "current_limit", "current_limit_p")
"""The parameters of its motor that a bench test tunes, by the end of their keys."""

_ABORT_COUNTS = 100
"""The default abort current in counts: 15 A, on a Jr 4 A.

It is near the drivers' continuous rating (13 A and 2.5 A): a motor whose start exceeds it needs
a higher one, which the user has to choose.
"""

_STEP_MS = 20  # the board renews its outputs every 10 ms

_TAIL = 0.6
"""Seconds for which currents are recorded after the motor began to brake."""

_FAULTS = {1: Status.MOTOR1_FAULT, 2: Status.MOTOR2_FAULT}
_LIMITS = {1: Status.MOTOR1_OVER_LIMIT, 2: Status.MOTOR2_OVER_LIMIT}


class Phase(Enum):
    """No test, driving, or braking while the current is still recorded."""

    IDLE = auto()
    DRIVING = auto()
    BRAKING = auto()


class Bench(QObject):
    """Runs one test at a time, only while its button is held, and keeps the last ones.

    Releasing the button brakes the motor. Everything else that ends a test stops and disarms
    all motors: too high a current, a fault, missing readings, loss of serial control, a stop.

    Signals:
        changed: the plan, `phase` or `blocker`; `current` grows silently.
        started: a test runs now.
        finished: a test is over, braking included: the `Run`, which is the last of `runs`.
    """

    changed = Signal()
    started = Signal()
    finished = Signal(object)

    def __init__(
        self,
        device: Device,
        parent: QObject | None = None,
        clock: Callable[[], float] = now,
    ) -> None:
        super().__init__(parent)
        self._device = device
        self._motors = device.motors
        self._clock = clock  # the one of the session's samples
        self._plan = Plan()
        self._phase = Phase.IDLE
        self._runs: tuple[Run, ...] = ()
        self._current: Run | None = None
        self._options = True, False
        self._ends_at_limit = False
        self._unit = 0.0
        self._start = self._last_reading = 0.0
        self._setpoints: list[tuple[float, int]] = []
        self._readings: list[tuple[float, float]] = []
        self._timer = runtime().timer(self)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.setInterval(_STEP_MS)

        self._timer.timeout.connect(self._on_step)
        device.sampled.connect(self._on_sampled)
        motors = self._motors
        for signal in (
            motors.arming_changed,
            motors.availability_changed,
            motors.setpoints_changed,
            motors.holder_changed,
            motors.options_changed,
            motors.lockout_changed,
        ):
            signal.connect(self._on_motors_changed)
        device.link_changed.connect(self._on_link_changed)
        device.state_changed.connect(self._on_state_changed)

    # --- State --------------------------------------------------------------------------

    @property
    def plan(self) -> Plan:
        """The next test."""
        return self._plan

    @property
    def phase(self) -> Phase:
        """The phase of the test that runs."""
        return self._phase

    @property
    def is_driving(self) -> bool:
        """Whether a test drives a motor now."""
        return self._phase is Phase.DRIVING

    @property
    def current(self) -> Run | None:
        """The test that runs, up to now, else the last one."""
        if self._phase is not Phase.IDLE and self._current is not None:
            return replace(
                self._current,
                ended=self._current.ended if self._phase is Phase.BRAKING else self._past,
                setpoints=tuple(self._setpoints),
                currents=tuple(self._readings),
            )
        return self._runs[-1] if self._runs else None

    @property
    def runs(self) -> tuple[Run, ...]:
        """The last tests, oldest first; at most `MAX_RUNS`."""
        return self._runs

    @property
    def highest_current(self) -> float:
        """The highest current in A that the board can measure; without a board, a TReX."""
        return self._ampere * HIGHEST_COUNT

    @property
    def blocker(self) -> str:
        """Why no test can start now and what to do, for the user; empty when one can."""
        return _blocker(self._device, ignore_setpoints=self._phase is Phase.DRIVING)

    def tuned_keys(self) -> tuple[str, ...]:
        """Return the keys of the parameters that the planned test tunes."""
        return tuple(f"motor{self._plan.motor}_{name}" for name in TUNED)

    @property
    def _past(self) -> float:
        return self._clock() - self._start

    # --- Commands -----------------------------------------------------------------------

    def set_plan(self, plan: Plan) -> None:
        """Set the next test; one that runs keeps its own plan."""
        if plan != self._plan:
            self._plan = plan
            self.changed.emit()

    def start(self) -> bool:
        """Start a test when its button is pressed; return whether one runs."""
        if self._phase is Phase.BRAKING:
            self._finish()
        if self._phase is not Phase.IDLE or self.blocker or not self._motors.acquire(HOLDER):
            return False
        plan, motors = self._plan, self._motors
        self._options = motors.accelerate, motors.linked
        self._ends_at_limit = plan.abort_at_limit
        motors.accelerate = plan.accelerate
        if motors.linked:
            motors.set_linked(False)  # the test is one motor's
        self._start = self._last_reading = self._clock()
        self._setpoints, self._readings = [], []
        self._current = Run(
            motor=plan.motor,
            profile=plan.profile.limited(motors.ceiling),
            accelerate=plan.accelerate,
            abort_current=plan.abort_current,
            ampere=self._ampere,
            started=datetime.now(UTC).astimezone(),
            end=End.COMPLETE,
            ended=0.0,
            setpoints=(),
            currents=(),
            settings=self._settings(),
        )
        self._phase = Phase.DRIVING
        text = self.tr("Bench test of motor {0}: {1}").format(plan.motor, self._current.title)
        self._device.events.add(EventKind.NOTE, text)
        self._timer.start()
        self._on_step()
        self.changed.emit()
        self.started.emit()
        return True

    def release(self) -> None:
        """Brake the motor when the button is released."""
        if self._phase is Phase.DRIVING:
            self._end(End.RELEASED)

    def abort(self, reason: str) -> None:
        """Stop and disarm all motors; `reason` is for the user."""
        if self._phase is Phase.DRIVING:
            self._end(End.ABORTED, reason)

    def add_run(self, run: Run) -> None:
        """Add a saved test, to compare with."""
        self._runs = (*self._runs[-MAX_RUNS + 1 :], run)
        self.changed.emit()
        self.finished.emit(run)

    # --- While it runs ------------------------------------------------------------------

    @Slot()
    def _on_step(self) -> None:
        past, run = self._past, self._current
        if run is None:
            return
        if self._phase is Phase.BRAKING:
            if past >= run.ended + _TAIL:
                self._finish()
        elif past >= run.profile.duration:
            self._end(End.COMPLETE)
        elif self._clock() - self._last_reading > (gap := self._device.timeouts.current_gap):
            self.abort(self.tr("No current was read for {0:g} s.").format(gap))
        else:
            speed = run.profile.speed_at(past)
            if not self._setpoints or self._setpoints[-1][1] != speed:
                self._motors.set_speed(run.motor, speed, HOLDER)
                if self._phase is Phase.DRIVING:  # a stop may have come from within
                    self._setpoints.append((past, speed))

    @Slot(object)
    def _on_sampled(self, batch: Batch) -> None:
        if self._phase is Phase.IDLE or self._current is None:
            return
        motor = self._current.motor
        for sample in batch.samples:
            if sample.time < self._start:
                continue  # measured before the first setpoint
            if isinstance(sample, Currents):
                self._last_reading = sample.time
                amps = sample.counts[motor - 1] * self._current.ampere
                self._readings.append((sample.time - self._start, amps))
                self._check_current(motor, amps)
            elif isinstance(sample, LatchedStatus):
                self._check_status(motor, sample)

    def _check_current(self, motor: int, amps: float) -> None:
        if self._current is not None and amps > self._current.abort_current:
            text = self.tr("Motor {0} drew {1:.2f} A, more than the abort current of {2:g} A.")
            self.abort(text.format(motor, amps, self._current.abort_current))

    def _check_status(self, motor: int, sample: LatchedStatus) -> None:
        if sample.status & _FAULTS[motor]:
            self.abort(self.tr("The driver of motor {0} reported a fault.").format(motor))
        elif sample.uart & UartError.TIMEOUT:
            self.abort(self.tr("The board's serial timeout stopped the motors."))
        elif self._ends_at_limit and sample.status & _LIMITS[motor]:
            self.abort(self.tr("Motor {0} exceeded its current limit.").format(motor))

    @Slot()
    def _on_motors_changed(self) -> None:
        if self._phase is Phase.DRIVING and self._motors.holder != HOLDER:
            # Without a board nothing can be armed; the report of the link has the reason.
            known = self._motors.is_available or self._motors.stop_reason
            self._end(End.ABORTED, self._external_reason() if known else "")
        elif self._phase is not Phase.DRIVING:  # its own setpoints change nothing here
            self.changed.emit()

    @Slot()
    def _on_link_changed(self) -> None:
        if self._phase is not Phase.IDLE and self._device.link is not ConnectionState.CONNECTED:
            self.abort("")
            self._finish()
        self.changed.emit()

    def _external_reason(self) -> str:
        if self._device.link is ConnectionState.NOT_RESPONDING:
            return self.tr("The board stopped responding.")
        if self._device.link is not ConnectionState.CONNECTED:
            return self.tr("The connection was closed.")
        if self._device.telemetry.serial_controls is False:
            return self.tr("Serial commands no longer control the motors.")
        return self._motors.stop_reason or self.tr("Stop was pressed.")

    # --- The end ------------------------------------------------------------------------

    def _end(self, how: End, reason: str = "") -> None:
        """Brake the motor first; go on recording its current for a moment."""
        self._phase = Phase.BRAKING
        if how is End.ABORTED:
            self._motors.abort(HOLDER, reason)  # does nothing if the motors are stopped already
        else:
            self._motors.release(HOLDER)
        accelerate, linked = self._options
        self._motors.accelerate = accelerate
        if linked:
            self._motors.set_linked(True)
        if self._current is not None:
            self._current = replace(self._current, end=how, reason=reason, ended=self._past)
        self.changed.emit()

    def _finish(self) -> None:
        if self._current is not None and self._current.end is End.ABORTED:
            # The motors are disarmed before the link says why.
            reason = self._current.reason or self._external_reason()
            self._current = replace(self._current, reason=reason)
        run = self.current
        self._timer.stop()
        self._phase = Phase.IDLE
        self._current = None
        if run is not None:
            self._runs = (*self._runs[-MAX_RUNS + 1 :], run)
            self.changed.emit()
            self.finished.emit(run)

    @property
    def _ampere(self) -> float:
        state = self._device.state
        return state.signature.model.current_unit if state is not None else _TREX_AMPERE

    @Slot()
    def _on_state_changed(self) -> None:
        """Set the default abort current of the board."""
        state = self._device.state
        if state is not None and state.signature.model.current_unit != self._unit:
            self._unit = state.signature.model.current_unit
            self._plan = replace(self._plan, abort_current=round(_ABORT_COUNTS * self._unit, 2))
        self.changed.emit()

    def _settings(self) -> tuple[tuple[str, str], ...]:
        """Return the motor's stored parameters, for the user."""
        parameters, found = self._device.parameters, []
        for key in self.tuned_keys():
            wire = parameters.stored_of(key)
            if wire is not None:
                spec = parameters.spec_of(key)
                found.append((spec.name, spec.text(wire)))
        return tuple(found)


def _blocker(device: Device, *, ignore_setpoints: bool) -> str:
    """Return why no test can start; with `ignore_setpoints` motors may be driven already."""
    motors = device.motors

    def tr(text: str) -> str:
        return QCoreApplication.translate("bench_obstacle", text)

    if device.link is ConnectionState.NOT_RESPONDING:
        return tr("The board does not answer.")
    if device.link is not ConnectionState.CONNECTED:
        return tr("Connect to a board to test its motors.")
    if device.is_joint:
        return tr("In joint mode the board senses no current: nothing would end a test of itself.")
    if device.applying:
        return tr("Settings are being written.")
    if device.telemetry.serial_controls is False:
        return tr("{0} A test needs serial control.").format(device.control_text)
    if motors.locked_for:
        return tr("Stop was pressed: the motors are locked for {0:.0f} s more.").format(
            max(1.0, motors.locked_for)
        )
    if not motors.armed:
        return tr("Nothing is sent yet. Put the robot on blocks, then press Run motor.")
    if motors.holder not in {"", HOLDER}:
        return tr("Another control drives the motors now.")
    drives = [motors.drive(motor) for motor in (1, 2)]
    moving = any(drive and not drive.is_brake and drive.speed for drive in drives)
    if not ignore_setpoints and (moving or motors.auxiliary > 0):
        return tr("Motors are driven already ({0}): bring them to rest first.").format(motors.text)
    if device.telemetry.motor_currents is None:
        return tr("No current was read yet.")
    return ""
