"""Bench tests: a motor is driven along a profile while somebody holds a button."""

from collections.abc import Callable
from dataclasses import replace
from datetime import UTC, datetime
from enum import Enum, auto

from PySide6.QtCore import QObject, Qt, Signal, Slot

from trex_gui.devices.trex.bench.plan import Plan
from trex_gui.devices.trex.bench.run import End, Run
from trex_gui.devices.trex.client.telemetry import Currents, LatchedStatus
from trex_gui.devices.trex.model.bench.obstacle import HOLDER, obstacle
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.flags import Status, UartError
from trex_gui.devices.trex.session.messages import Batch
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.devices.event_log import EventKind
from trex_gui.ui.runtime import now, runtime

KEPT = 10
"""Tests that are kept to be compared with."""

HIGHEST_COUNT = 255
"""The current measurement is one byte (0x8D)."""

_TREX_AMPERE = 0.15

TUNED = ("acceleration", "brake_duration", "current_limit", "current_limit_p")
"""What a bench test is used to tune: parameters of its motor, by the end of their keys."""

_ABORT_COUNTS = 100
"""The current at which a test is aborted unless set otherwise, in counts: 15 A, on a Jr 4 A.

Near what the drivers bear for long (13 A and 2.5 A): a start may pass it for a moment and then
needs a higher one, which somebody has to choose.
"""

__all__ = ["HOLDER", "KEPT", "TUNED", "Bench", "Phase", "Plan"]

_STEP_MS = 20  # 50 times a second: the board renews its outputs 100 times, a person sees 25

_TAIL = 0.6
"""Seconds for which currents are taken after the motor was left to brake."""

_FAULTS = {1: Status.MOTOR1_FAULT, 2: Status.MOTOR2_FAULT}
_LIMITS = {1: Status.MOTOR1_OVER_LIMIT, 2: Status.MOTOR2_OVER_LIMIT}


class Phase(Enum):
    """Where a test is: none, driving, or braking with an eye on the current."""

    IDLE = auto()
    DRIVING = auto()
    BRAKING = auto()


class Bench(QObject):
    """Runs one test at a time, only while it is held, and keeps the last ones.

    Letting go brakes the motor. Whatever else ends a test stops and disarms everything: too
    high a current, a fault, no readings, a board that obeys somebody else, a stop.

    Signals:
        changed: the plan, `phase`, or what stands in the way of a test; `current` grows silently.
        begun: a test runs now.
        finished: a test is over, braking included: the `Run`, which is the last of `runs`.
    """

    changed = Signal()
    begun = Signal()
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
        self._clock = clock  # the one that a session gives its samples, too
        self._plan = Plan()
        self._phase = Phase.IDLE
        self._runs: tuple[Run, ...] = ()
        self._current: Run | None = None
        self._options = True, False
        self._ends_at_limit = False
        self._unit = 0.0
        self._start = self._last_reading = 0.0
        self._wishes: list[tuple[float, int]] = []
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

    # --- What is known ------------------------------------------------------------------

    @property
    def plan(self) -> Plan:
        """What the next test is."""
        return self._plan

    @property
    def phase(self) -> Phase:
        """Where a test is."""
        return self._phase

    @property
    def is_driving(self) -> bool:
        """Whether a motor is driven by a test now."""
        return self._phase is Phase.DRIVING

    @property
    def current(self) -> Run | None:
        """The test that runs, as far as it has come, else the last one."""
        if self._phase is not Phase.IDLE and self._current is not None:
            return replace(
                self._current,
                ended=self._current.ended if self._phase is Phase.BRAKING else self._past,
                wishes=tuple(self._wishes),
                currents=tuple(self._readings),
            )
        return self._runs[-1] if self._runs else None

    @property
    def runs(self) -> tuple[Run, ...]:
        """The last tests, oldest first; at most `KEPT`."""
        return self._runs

    @property
    def highest_current(self) -> float:
        """The highest current in A that the board can measure; of a TReX while none is known."""
        return self._ampere * HIGHEST_COUNT

    @property
    def obstacle(self) -> str:
        """Why no test can begin now, for people; empty when one can."""
        return obstacle(self._device, ignore_wishes=self._phase is Phase.DRIVING)

    def tuned_keys(self) -> tuple[str, ...]:
        """Return the keys of the parameters that a test of the plan's motor tunes."""
        return tuple(f"motor{self._plan.motor}_{name}" for name in TUNED)

    @property
    def _past(self) -> float:
        return self._clock() - self._start

    # --- What a person does -------------------------------------------------------------

    def set_plan(self, plan: Plan) -> None:
        """Take what the next test shall be; one that runs goes on as it was begun."""
        if plan != self._plan:
            self._plan = plan
            self.changed.emit()

    def begin(self) -> bool:
        """Begin a test because its button is held now; return whether one runs.

        It ends by itself, by `let_go`, or by what makes it dangerous.
        """
        if self._phase is Phase.BRAKING:
            self._finish()
        if self._phase is not Phase.IDLE or self.obstacle or not self._motors.acquire(HOLDER):
            return False
        plan, motors = self._plan, self._motors
        self._options = motors.accelerate, motors.linked
        self._ends_at_limit = plan.abort_at_limit
        motors.accelerate = plan.accelerate
        if motors.linked:
            motors.set_linked(False)  # the test is one motor's
        self._start = self._last_reading = self._clock()
        self._wishes, self._readings = [], []
        self._current = Run(
            motor=plan.motor,
            profile=plan.profile.limited(motors.ceiling),
            accelerate=plan.accelerate,
            abort_current=plan.abort_current,
            ampere=self._ampere,
            began=datetime.now(UTC).astimezone(),
            end=End.COMPLETE,
            ended=0.0,
            wishes=(),
            currents=(),
            settings=self._settings(),
        )
        self._phase = Phase.DRIVING
        text = self.tr("Bench test of motor {0}: {1}").format(plan.motor, self._current.title)
        self._device.events.add(EventKind.NOTE, text)
        self._timer.start()
        self._on_step()
        self.changed.emit()
        self.begun.emit()
        return True

    def let_go(self) -> None:
        """The button is not held any more: the motor brakes."""
        if self._phase is Phase.DRIVING:
            self._end(End.LET_GO)

    def abort(self, reason: str) -> None:
        """Stop everything and disarm; `reason` is for people."""
        if self._phase is Phase.DRIVING:
            self._end(End.ABORTED, reason)

    def keep(self, run: Run) -> None:
        """Keep a test that was saved earlier, to compare with; it is not the last one's better."""
        self._runs = (*self._runs[-KEPT + 1 :], run)
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
            if not self._wishes or self._wishes[-1][1] != speed:
                self._motors.set_speed(run.motor, speed, HOLDER)
                if self._phase is Phase.DRIVING:  # a stop may come from within
                    self._wishes.append((past, speed))

    @Slot(object)
    def _on_sampled(self, batch: Batch) -> None:
        if self._phase is Phase.IDLE or self._current is None:
            return
        motor = self._current.motor
        for sample in batch.samples:
            if sample.time < self._start:
                continue  # was measured before the first command
            if isinstance(sample, Currents):
                self._last_reading = sample.time
                amps = sample.counts[motor - 1] * self._current.ampere
                self._readings.append((sample.time - self._start, amps))
                self._judge_current(motor, amps)
            elif isinstance(sample, LatchedStatus):
                self._judge_status(motor, sample)

    def _judge_current(self, motor: int, amps: float) -> None:
        if self._current is not None and amps > self._current.abort_current:
            text = self.tr("Motor {0} drew {1:.2f} A, more than the {2:g} A to abort at.")
            self.abort(text.format(motor, amps, self._current.abort_current))

    def _judge_status(self, motor: int, news: LatchedStatus) -> None:
        if news.status & _FAULTS[motor]:
            self.abort(self.tr("The driver of motor {0} reported a fault.").format(motor))
        elif news.uart & UartError.TIMEOUT:
            self.abort(self.tr("The board's serial timeout has stopped the motors."))
        elif self._ends_at_limit and news.status & _LIMITS[motor]:
            self.abort(self.tr("Motor {0} went over its current limit.").format(motor))

    @Slot()
    def _on_motors_changed(self) -> None:
        if self._phase is Phase.DRIVING and self._motors.holder != HOLDER:
            # Without a board nothing can be armed; the link is about to say why.
            known = self._motors.is_available or self._motors.stop_reason
            self._end(End.ABORTED, self._reason_from_outside() if known else "")
        elif self._phase is not Phase.DRIVING:  # its own commands change nothing here
            self.changed.emit()

    @Slot()
    def _on_link_changed(self) -> None:
        if self._phase is not Phase.IDLE and self._device.link is not ConnectionState.CONNECTED:
            self.abort("")
            self._finish()
        self.changed.emit()

    def _reason_from_outside(self) -> str:
        if self._device.link is ConnectionState.NOT_RESPONDING:
            return self.tr("The board has stopped answering.")
        if self._device.link is not ConnectionState.CONNECTED:
            return self.tr("The line was closed.")
        if self._device.telemetry.serial_controls is False:
            return self.tr("Serial commands do not control the motors any more.")
        return self._motors.stop_reason or self.tr("Stop was pressed.")

    # --- The end ------------------------------------------------------------------------

    def _end(self, how: End, reason: str = "") -> None:
        """Bring the motor to rest, first of all; go on reading its current for a moment."""
        self._phase = Phase.BRAKING
        if how is End.ABORTED:
            self._motors.abort(HOLDER, reason)  # nothing to stop where another has stopped it
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
            reason = self._current.reason or self._reason_from_outside()
            self._current = replace(self._current, reason=reason)
        run = self.current
        self._timer.stop()
        self._phase = Phase.IDLE
        self._current = None
        if run is not None:
            self._runs = (*self._runs[-KEPT + 1 :], run)
            self.changed.emit()
            self.finished.emit(run)

    @property
    def _ampere(self) -> float:
        state = self._device.state
        return state.signature.model.current_unit if state is not None else _TREX_AMPERE

    @Slot()
    def _on_state_changed(self) -> None:
        """Begin with a current to abort at that fits the board."""
        state = self._device.state
        if state is not None and state.signature.model.current_unit != self._unit:
            self._unit = state.signature.model.current_unit
            self._plan = replace(self._plan, abort_current=round(_ABORT_COUNTS * self._unit, 2))
        self.changed.emit()

    def _settings(self) -> tuple[tuple[str, str], ...]:
        """What the board stores for the motor, for people."""
        parameters, found = self._device.parameters, []
        for key in self.tuned_keys():
            wire = parameters.stored_of(key)
            if wire is not None:
                spec = parameters.spec_of(key)
                found.append((spec.name, spec.text(wire)))
        return tuple(found)
