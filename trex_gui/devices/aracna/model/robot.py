"""The robot as the window sees it: what may be asked of it."""

from collections.abc import Sequence
from dataclasses import replace

from trex_gui.core.errors import sentence
from trex_gui.core.session.messages import Close, Outcome
from trex_gui.devices.aracna.model.cropping import cropped_goals_text, slowly_first, within_limits
from trex_gui.devices.aracna.model.observed import ObservedRobot
from trex_gui.devices.aracna.model.robot_state import PlayState
from trex_gui.devices.aracna.session.messages import Drag, EndPlay, Halt, Move, Play, SetTimeScale
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.event_log import EventKind


class Robot(ObservedRobot):
    """One robot, or none; nothing is sent that nobody asked for but what the session needs."""

    # --- What a person does -------------------------------------------------------------

    def move(self, goals: Sequence[int]) -> bool:
        """Send every motor to a goal, within its limits; return whether it will be.

        While a motion runs, the newest goals wait for its end.
        """
        if not self._may_move():
            return False
        cropped = self.limits.crop(goals)
        if cropped != tuple(goals):
            self._tell(cropped_goals_text(goals, cropped))
        self.targets.set_all(cropped)
        self._holding = False
        speeds = self.speeds.wanted
        self._story.move_begins(cropped)
        if self._known.moving is not None or self._moves_waiting:
            return self._line.submit(Drag(cropped, speeds))
        if self._line.ask(lambda number: Move(number, cropped, speeds), self._on_move_over):
            self._moves_waiting += 1
        return True

    def begin_drag(self) -> None:
        """Somebody takes hold of a goal: `drag` sends until `end_drag`, or `halt`."""
        if self._may_move():
            self._dragging = True
            self._rate.forget()
            self.changed.emit()

    def drag(self, goals: Sequence[int]) -> None:
        """Send every motor to a goal as soon as the robot listens; the newest goals count."""
        if self._dragging and self.link is ConnectionState.CONNECTED:
            self._holding = False
            self._line.submit(Drag(self.limits.crop(goals), self.speeds.wanted))

    def end_drag(self) -> None:
        """The goal was let go; what was asked last is still sent."""
        if self._dragging:
            self._dragging = False
            self.changed.emit()

    def set_speeds(self, speeds: Sequence[int]) -> None:
        """Choose a speed for each motor, 0-1023; 0 is as fast as it can.

        They are sent at once, or before the motion that follows what is played now; the newest
        count for every motion that is sent after them.

        Raises:
            BadRequest: too few, too many, or one out of range.
        """
        self.speeds.choose(speeds)
        if self.link is ConnectionState.CONNECTED and self._known.play is None:
            self.speeds.give()

    def play(self, play: Play) -> bool:
        """Run steps, each within the limits; return whether they will be.

        Where it is not known where the motors are, they first go slowly to where it begins.
        """
        if not self._may_move():
            return False
        if not play.steps:
            self._reject(self.tr("There is nothing to play: the sequence has no steps."))
            return False
        play, others = within_limits(play, self.limits)
        if others:
            text = self.tr("Kept within the limits of the joints: {0} steps of what is played.")
            self._tell(text.format(others))
        if None in self._known.present:
            play = slowly_first(play)
        self._holding = False
        asked = self._line.ask(lambda number: replace(play, id=number), self._on_play_over)
        if asked:
            self._known.play, self._known.playing = play, PlayState(len(play.steps), play.rounds)
            self._story.play_begins(len(play.steps), play.rounds)
            self.changed.emit()
        return asked

    def end_play(self) -> None:
        """Let what is played end after the current step, with its blend-out."""
        if self._known.play is not None:
            self._line.submit(EndPlay())

    def set_time_scale(self, factor: float) -> None:
        """Run what is played so much slower (above 1) or faster from its next step on."""
        if self._known.play is not None:
            self._line.submit(SetTimeScale(factor))

    def halt(self) -> None:
        """Send nothing more. What moves goes on to its goal: nothing on this link stops it."""
        if not self._line.is_open or self.link is ConnectionState.DISCONNECTING:
            return
        known = self._known
        goes_on = known.moving is not None or known.play is not None
        self._line.submit(Halt())
        self._holding = goes_on or self._dragging or self._moves_waiting > 0
        self._dragging = False
        self._story.halted(self.remaining())
        self.halted.emit()
        if self._holding:
            self._hold()
        self.changed.emit()

    def halt_now(self, *, ending: bool = False) -> None:
        """Send nothing more, and give the port back where the program is `ending`.

        For emergencies, from any thread: it waits for nobody. `halt` is to follow in the GUI
        thread, where there still is one.
        """
        self._line.submit_now(*((Halt(), Close()) if ending else (Halt(),)))

    def _may_move(self) -> bool:
        if self.link is not ConnectionState.CONNECTED:
            self._reject(self.tr("No robot is connected that could move."))
            return False
        if self._known.play is not None:
            self._reject(self.tr("A sequence is playing. Stop it first."))
            return False
        if self._known.stuck is not None:
            self._reject(self.tr("The robot is stuck. Nothing is sent until it has answered."))
            return False
        return True

    def _tell(self, text: str) -> None:
        self.events.add(EventKind.NOTE, text)
        self.notifier.info.emit(text)

    # --- How it went ---------------------------------------------------------------------

    def _on_move_over(self, outcome: Outcome) -> None:
        self._moves_waiting -= 1
        if outcome.error is not None and not self._holding:
            self._reject(self.tr("Not moved: {0}").format(sentence(outcome.error)))
        self.changed.emit()

    def _on_play_over(self, outcome: Outcome) -> None:
        self._known.play = self._known.playing = None
        if outcome.error is not None and not self._holding:
            self._reject(self.tr("Broken off: {0}").format(sentence(outcome.error)))
        self.changed.emit()
