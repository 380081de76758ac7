"""Robot of a window: connection, reported state and requests."""

from collections.abc import Sequence
from dataclasses import replace

from PySide6.QtCore import Signal, Slot

from trex_gui.core.errors import StudioError
from trex_gui.core.events import EventKind
from trex_gui.core.session import Close, Outcome
from trex_gui.core.translation import tr
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.model.robot_state import RobotState
from trex_gui.devices.aracna.model.setpoints import JointLimits, Targets
from trex_gui.devices.aracna.model.texts import (
    clamped_goals_text,
    ending_text,
    event_of,
    waiting_text,
)
from trex_gui.devices.aracna.protocol.joints import HIGHEST, MOTORS, travel_seconds
from trex_gui.devices.aracna.session.errors import ErrorCode, suggests_scan
from trex_gui.devices.aracna.session.messages import (
    Connected,
    EndPlay,
    Halt,
    Move,
    Moved,
    Moving,
    NotResponding,
    Play,
    Restarted,
    SetLed,
    SetLimits,
    SetSpeeds,
    SetTimeScale,
    Step,
)
from trex_gui.devices.aracna.session.session import AracnaSession
from trex_gui.devices.aracna.session.traffic_decoder import AracnaDecoder
from trex_gui.ui.devices.connection import ConnectionState, DeviceConnection
from trex_gui.ui.log import EventLog
from trex_gui.ui.notifier import Notifier, remedies_of
from trex_gui.ui.runtime import now
from trex_gui.ui.translations import error_sentence, error_text
from trex_gui.ui.workers.session_thread import SessionFactory

FIRST_SPEED = 100
"""Speed of the servos, 67 degrees per second, until the user changes it.

Positions are unknown before the first motion, and a servo's speed is unlimited after power-up."""


class Robot(DeviceConnection[PortSettings]):
    """Robot, connected or not. Without a request, its session sends only queries.

    Positions and speeds are tuples with one value for each motor, motor 0 first, in the servo's
    units. `reported` is emitted after `state` includes the report.
    """

    link_changed = Signal()  # emitted after `changed`
    halted = Signal()
    rejected = Signal(str)  # reason why a command was rejected; also sent to the notifier

    def __init__(self, notifier: Notifier | None = None) -> None:
        super().__init__(AracnaDecoder())
        self.notifier = notifier or Notifier(self)
        self.state = RobotState(MOTORS)
        self.dragging = False
        self.limits = JointLimits(self)
        self.targets = Targets(self.limits, self)
        self.speeds = (FIRST_SPEED,) * MOTORS  # for the next motion
        self.has_user_speeds = False  # True if the user has set `speeds`
        self.events = EventLog(self)
        self._pending_moves = 0
        self._pending_speeds = 0
        self._follows_present = False  # True if targets follow the present positions, after a halt

        self.line_closed.connect(self._on_line_closed)
        self.failed.connect(self._on_failed)
        self.interfered.connect(self.notifier.report)
        self.limits.changed.connect(self._send_limits)
        self.rejected.connect(self.notifier.error)

    def remaining(self) -> float:
        """Return the seconds until any motion should end, or 0."""
        until = self.state.moving_until
        return 0.0 if until is None else max(until - now(), 0.0)

    # --- Connection ---------------------------------------------------------------------

    connect_to = DeviceConnection.open
    disconnect_line = DeviceConnection.close

    def new_session(self, settings: PortSettings, *, may_move: bool) -> SessionFactory:
        del may_move  # a motion ends by itself
        return lambda inbox, report: AracnaSession(settings, inbox, report, self.open_logged)

    def prepare_to_close(self) -> None:
        self.submit(Halt())

    def _set_state(self, link: ConnectionState, status: str) -> None:
        super()._set_state(link, status)
        is_silent = link is ConnectionState.NOT_RESPONDING
        self.events.add(EventKind.LINK, status, is_problem=is_silent)
        self.link_changed.emit()

    def _reset(self, motors: int) -> None:
        """Reset to an unknown robot. Retain the end time of a running motion."""
        self.state = RobotState(motors, unobserved_until=self.state.moving_until)
        self.dragging = self._follows_present = False
        self.speeds, self.has_user_speeds = (FIRST_SPEED,) * motors, False
        self.targets.set_count(motors)
        self.changed.emit()

    @Slot()
    def _on_line_closed(self) -> None:
        self._pending_moves = self._pending_speeds = 0
        self._reset(self.state.motors)

    @Slot(object)
    def _on_failed(self, error: StudioError) -> None:
        text = error_text(error)
        self.events.add(EventKind.LINK, text, is_problem=True)
        self.notifier.report(text, remedies_of(error, may_be_found=suggests_scan(error)))

    # --- Reports ------------------------------------------------------------------------

    def handle(self, report: object) -> None:
        if isinstance(report, Connected) and report.motors != self.state.motors:
            self._reset(report.motors)
        self.state.update(report)
        match report:
            case Connected():
                self._send_limits()
            case Restarted() | NotResponding():
                self.dragging = False
            case Moving(goals=goals) if self.state.play is not None:
                self.targets.set_all(goals)
            case Moved() if self._follows_present:
                self.aim_at_present()
        if self.link is not ConnectionState.DISCONNECTING:
            self._update_link(report)
        if (event := event_of(report, self.state)) is not None:
            self.events.add(*event, is_problem=event[0] is EventKind.FAULT)
        self.changed.emit()

    def _update_link(self, report: object) -> None:
        match report:
            case Connected(version=version, motors=motors):
                text = tr("Connected to Aracna: firmware {0}, %n motor(s).", "", motors)
                self._set_state(ConnectionState.CONNECTED, text.format(version))
            case Restarted():
                text = tr("The board has restarted; it is ready again in a second …")
                self._set_state(ConnectionState.NOT_RESPONDING, text)
            case NotResponding():
                text = tr("The robot is not responding. Is its power on? Waiting for it …")
                self._set_state(ConnectionState.NOT_RESPONDING, text)

    @Slot()
    def _send_limits(self) -> None:
        self.submit(SetLimits(self.limits.for_motors(self.state.motors)))

    # --- Commands -----------------------------------------------------------------------

    def move(self, goals: Sequence[int]) -> bool:
        """Move every motor to its goal after any running motion. Return False if rejected."""
        if not self._can_move():
            return False
        clamped = self.limits.clamp(goals)
        if clamped != tuple(goals):
            self._inform(clamped_goals_text(goals, clamped))
        self.targets.set_all(clamped)
        self.events.add(EventKind.NOTE, tr("Move to {0}.").format(", ".join(map(str, clamped))))
        return self._request_move(clamped, dragged=False)

    def _request_move(self, goals: tuple[int, ...], *, dragged: bool) -> bool:
        speeds, self._follows_present = self.speeds, False
        requested = self.request(
            lambda number: Move(number, goals, speeds, dragged), self._on_move_done
        )
        self._pending_moves += requested
        return requested

    def start_drag(self) -> None:
        """Enable `drag` until `end_drag` or `halt`."""
        if self._can_move():
            self.dragging = True
            self.changed.emit()

    def drag(self, goals: Sequence[int]) -> None:
        """Send goals once the robot is ready. They replace unsent goals."""
        if self.dragging and self.link is ConnectionState.CONNECTED:
            self._request_move(self.limits.clamp(goals), dragged=True)

    def end_drag(self) -> None:
        if self.dragging:
            self.dragging = False
            self.changed.emit()

    def set_speeds(self, speeds: Sequence[int]) -> None:
        """Set speeds, 0-1023 (0: unlimited). During a sequence, they apply to the next move."""
        values = tuple(speeds)
        self.speeds, self.has_user_speeds = values, True
        if (
            self.link is ConnectionState.CONNECTED
            and self.state.play is None
            and self.request(lambda number: SetSpeeds(number, values), self._on_speeds_done)
        ):
            self._pending_speeds += 1
        self.changed.emit()

    def set_led(self, *, on: bool) -> None:
        if self.link is ConnectionState.CONNECTED:
            self.request(lambda number: SetLed(number, on), self._on_led_done)

    def play(self, play: Play) -> bool:
        """Play steps, clamped to the limits. Return False if rejected.

        From unknown positions, the robot starts with a slow motion.
        """
        if not self._can_move():
            return False
        if clamped := sum(self.limits.clamp(step.goals) != step.goals for step in play.steps):
            self._inform(tr("Clamped to the limits of the joints: %n step(s).", "", clamped))
        if None in self.state.present:
            play = self._with_slow_start(play)
        self._follows_present = False
        if not self.request(lambda number: replace(play, id=number), self._on_play_done):
            return False
        steps, rounds = len(play.steps), play.rounds
        self.state.play = play
        repetition = tr("%n time(s)", "", rounds) if rounds else tr("repeating")
        self.events.add(
            EventKind.NOTE, tr("Playing %n step(s), {0}.", "", steps).format(repetition)
        )
        self.changed.emit()
        return True

    def _with_slow_start(self, play: Play) -> Play:
        """Prepend a slow step to the start position, long enough for the full travel."""
        first = (*play.blend_in, *play.steps)[0]
        seconds = travel_seconds(HIGHEST, FIRST_SPEED) / play.time_scale
        slow = Step(first.goals, seconds, tr("slowly to the start"))
        return replace(play, blend_in=(slow, *play.blend_in))

    def end_play(self) -> None:
        if self.state.play is not None:
            self.submit(EndPlay())

    def set_time_scale(self, factor: float) -> None:
        if self.state.play is not None:
            self.submit(SetTimeScale(factor))

    def halt(self) -> None:
        """Send nothing more. A running motion continues, since no command stops it."""
        if not self.is_open or self.link is ConnectionState.DISCONNECTING:
            return
        is_active = self.state.moving is not None or self.state.play is not None
        self.submit(Halt())
        self._follows_present = is_active or self.dragging or self._pending_moves > 0
        self.dragging = False
        ending = ending_text(self.remaining())
        self.events.add(EventKind.STOP, f"{tr('Nothing more is sent.')} {ending}".rstrip())
        self.halted.emit()
        if self._follows_present:
            self.aim_at_present()
        self.changed.emit()

    def halt_now(self, *, ending: bool = False) -> None:
        """Send nothing more, from any thread. `ending`: also close the port.

        Does not wait. `halt` should follow in the GUI thread.
        """
        self.submit_now(*((Halt(), Close()) if ending else (Halt(),)))

    def stop_because(self, reason: str) -> str:
        """Halt for a `reason`, a clause without a full stop. Return the reason and the effect.

        Return an empty text if no robot is connected and no earlier motion may be running.
        """
        ending = ending_text(self.remaining())
        if self.link is ConnectionState.DISCONNECTED:
            return f"{reason}. {tr('No robot is connected.')} {ending}" if ending else ""
        if not ending and not self.is_at_rest:
            ending = tr("A running motion continues to its goal.")
        self.events.add(EventKind.NOTE, f"{reason}.")
        self.halt()
        return f"{reason}. {tr('Nothing more is sent.')} {ending}".rstrip()

    @property
    def is_at_rest(self) -> bool:
        """True if a connected robot is at rest, with no motion pending."""
        state = self.state
        is_busy = state.moving is not None or state.play is not None or state.may_be_moving
        is_pending = self.dragging or self._pending_moves > 0
        return self.link is ConnectionState.CONNECTED and not is_busy and not is_pending

    def aim_at_present(self) -> None:
        pairs = zip(self.state.present, self.targets.goals, strict=False)
        self.targets.set_all([goal if present is None else present for present, goal in pairs])

    @property
    def move_blocker(self) -> str:
        """Reason why the robot cannot be moved, or empty."""
        if self.link is not ConnectionState.CONNECTED:
            return tr("No robot is connected.")
        if self.state.play is not None:
            return tr(ErrorCode.PLAYING.value)
        return "" if self.state.stuck is None else waiting_text(self.state.stuck.motor)

    def _can_move(self) -> bool:
        if blocker := self.move_blocker:
            self.rejected.emit(blocker)
        return not blocker

    def _inform(self, text: str) -> None:
        self.events.add(EventKind.NOTE, text)
        self.notifier.info.emit(text)

    def _reject_because(self, text: str, error: StudioError) -> None:
        self.rejected.emit(text.format(error_sentence(error)))

    # --- Outcomes -----------------------------------------------------------------------

    def _on_speeds_done(self, outcome: Outcome) -> None:
        self._pending_speeds -= 1
        if outcome.error is not None and not self._pending_speeds:  # otherwise newer speeds follow
            self._reject_because(tr("Speeds not set: {0}"), outcome.error)

    def _on_led_done(self, outcome: Outcome) -> None:
        if outcome.error is None:
            self.state.led = bool(outcome.value)
        else:
            self._reject_because(tr("LED not switched: {0}"), outcome.error)
        self.changed.emit()

    def _on_move_done(self, outcome: Outcome) -> None:
        self._pending_moves -= 1
        is_newest = not self._pending_moves
        if outcome.error is not None and is_newest and not self._follows_present:
            self.dragging = False  # so that only one error is reported
            self._reject_because(tr("Not moved: {0}"), outcome.error)
        self.changed.emit()

    def _on_play_done(self, outcome: Outcome) -> None:
        self.state.play = self.state.step = None
        if outcome.error is not None and not self._follows_present:
            self._reject_because(tr("Aborted: {0}"), outcome.error)
        self.changed.emit()
