"""Controls that play a sequence or gait, and a preview."""

from collections.abc import Mapping

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import Number, tr
from trex_gui.devices.aracna.model.library import ItemKey, Library
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.poses.playing import (
    Present,
    blend_in,
    blend_out,
    clamped,
    estimated_seconds,
    motor_count_warning,
    slow_motors,
    stages_of,
    steps_of,
)
from trex_gui.devices.aracna.protocol.joints import Limits
from trex_gui.devices.aracna.session.messages import Play
from trex_gui.devices.aracna.views.poses.motion_box import MotionBox
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.theme.theme import set_look
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import commit_typed
from trex_gui.ui.widgets.labels import Note

_MAX_ROUNDS = 999
_SLOWEST, _FASTEST = 10, 400  # percent


class PlayBar(QWidget):
    def __init__(
        self, robot: Robot, library: Library, motions: MotionBox, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaPlayBar")
        self._robot = robot
        self._library = library
        self._motions = motions
        self._request: Play | None = None  # `None` if nothing can be played
        self._limits: tuple[Limits, ...] = ()  # limits in the last preview
        self._present: Present = ()  # positions in the last preview
        self._played: ItemKey | None = None

        self._rounds = ui.spin_box(
            self,
            "aracnaRounds",
            tr("Rounds"),
            0,
            _MAX_ROUNDS,
            value=1,
            tip=tr("0: repeat until stopped."),
            on_change=self._update_preview,
        )
        self._rounds.setSpecialValueText(tr("repeating"))
        self._speed = ui.spin_box(
            self,
            "aracnaSpeedScale",
            tr("Speed in percent"),
            _SLOWEST,
            _FASTEST,
            value=100,
            step=10,
            suffix=tr(" %"),
            tip=tr(
                "Changes during playback take effect from the next step. At 50 %, each step "
                "takes twice as long."
            ),
            on_change=self._on_speed_changed,
        )
        self._blend_in = ui.check_box(
            self,
            "aracnaBlendIn",
            tr("&Blend in"),
            tip=tr("Move slowly to the start first, in 3 s."),
            checked=True,
            on_toggle=self._update_preview,
        )
        self._blend_out = ui.check_box(
            self,
            "aracnaBlendOut",
            tr("B&lend out to stand"),
            tip=tr("At the end, move slowly to the pose “stand”, in 3 s."),
            on_toggle=self._update_preview,
        )
        self._play = ui.button(self, "aracnaPlay", tr("Pla&y"), on_click=self.play)
        set_look(self._play, "primary")
        set_icon(self._play, "run", "primary_text")
        self._summary = ui.named(Note(2, self), "aracnaPlaySummary")
        self._summary.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        ui.column(
            ui.row(
                ui.label(self, "", tr("R&ounds"), buddy=self._rounds),
                self._rounds,
                ui.label(self, "", tr("&Speed"), buddy=self._speed),
                self._speed,
                self._blend_in,
                self._blend_out,
                1,
                spacing=8,
            ),
            ui.row(self._play, (self._summary, 1), spacing=12),
            into=self,
            margins=0,
            spacing=8,
        )

        motions.steps_changed.connect(self._update_preview)
        library.changed.connect(self._update_preview)
        robot.changed.connect(self._on_robot_changed)
        robot.limits.changed.connect(self._on_robot_changed)
        self._update_preview()

    @property
    def _time_scale(self) -> float:
        return 100 / self._speed.value()

    @Slot()
    def play(self) -> None:
        commit_typed()
        self._update_preview()
        if self._request is not None and not self._robot.move_blocker:
            self._played = self._motions.current
            self._robot.play(self._request)

    @Slot()
    def _on_speed_changed(self) -> None:
        self._update_preview()
        self._robot.set_time_scale(self._time_scale)

    @Slot()
    def _on_robot_changed(self) -> None:
        """Update the preview if necessary. Replies arrive 30 times a second."""
        state = self._robot.state
        has_moved = state.play is None and state.present != self._present
        if has_moved or self._robot.limits.for_motors(state.motors) != self._limits:
            self._update_preview()
        else:
            self._show_playing()

    @Slot()
    def _update_preview(self) -> None:
        state, sequence = self._robot.state, self._motions.playable
        self._limits, self._present = self._robot.limits.for_motors(state.motors), state.present
        limits, present, poses = self._limits, self._present, self._library.project.poses
        self._request = None
        if sequence is None:
            self._show_preview(tr("Select a sequence or a gait to play it."))
            return
        try:
            steps = steps_of(sequence, poses, limits)
        except BadRequest as error:
            known = {pose.name for pose in poses}
            undefined = [n for n, step in enumerate(sequence.steps) if step.pose_name not in known]
            notes = dict.fromkeys(undefined, tr("not defined"))
            self._show_preview(tr("Cannot play: {0}.").format(error), alarming=True, notes=notes)
            return
        self._request = play = Play(
            0,
            steps,
            self._rounds.value(),
            blend_in(sequence, poses, limits, present) if self._blend_in.isChecked() else (),
            blend_out(limits, poses) if self._blend_out.isChecked() else (),
            self._time_scale,
        )
        scaled = steps_of(sequence, poses, limits, play.time_scale)
        start = play.blend_in[-1].goals if play.blend_in else present
        slow = slow_motors(scaled, start, repeated=play.rounds != 1)
        used = [pose for pose, _ in stages_of(sequence, poses)]
        is_clamped = any(pose.for_motors(len(limits)) != clamped(pose, limits) for pose in used)
        warning = motor_count_warning(used, len(limits))
        sentences = (
            warning,
            _length_text(len(steps), estimated_seconds(scaled, start), play.rounds),
            tr("Positions outside the limits are clamped.") if is_clamped else "",
            tr("Some motors are too slow.") if slow else "",
        )
        text, alarming = " ".join(filter(None, sentences)), bool(slow or warning)
        self._show_preview(text, alarming=alarming, notes=_notes(slow))

    def _show_preview(
        self, text: str, *, alarming: bool = False, notes: dict[int, str] | None = None
    ) -> None:
        """Show a text. `notes`: step index → remark."""
        self._motions.table.show_notes(notes or {})
        self._summary.show_note(text, alarming=alarming)
        self._summary.setAccessibleName(text)
        self._show_playing()

    def _show_playing(self) -> None:
        blocker, step = self._robot.move_blocker, self._robot.state.step
        is_playable = self._request is not None
        tip = tr("Play the current sequence or gait.") if is_playable else self._summary.text()
        self._play.setEnabled(is_playable and not blocker)
        self._play.setToolTip(ui.plain(blocker or tip))
        is_shown = step is not None and step.part == "steps"
        is_shown &= self._played == self._motions.current
        self._motions.table.show_running(step.index if step is not None and is_shown else None)


def _notes(slow: Mapping[int, dict[int, float]]) -> dict[int, str]:
    text = tr("needs {0:.2f} s (motor {1})")
    return {
        step: text.format(Number(max(needed.values())), ", ".join(map(str, needed)))
        for step, needed in slow.items()
    }


def _length_text(steps: int, seconds: float, rounds: int) -> str:
    count, text = tr("%n step(s)", "", steps), tr("{0:.1f} s")
    one_round, total = text.format(Number(seconds)), text.format(Number(seconds * rounds))
    if rounds == 1:
        return tr("{0}, {1}.").format(count, one_round)
    if rounds == 0:
        return tr("{0}, {1} per round, until stopped.").format(count, one_round)
    return tr("{0}, {1} per round, {2} in total.").format(count, one_round, total)
