"""Poses, sequences and gaits: kept in files, edited, played."""

from PySide6.QtCore import Signal, Slot
from PySide6.QtWidgets import QMenu, QToolButton, QWidget

from trex_gui.devices.aracna.model.library import ItemKey, Library
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.model.robot_state import PlayState
from trex_gui.devices.aracna.poses.playing import Present
from trex_gui.devices.aracna.protocol.joints import Limits, factory_limits
from trex_gui.devices.aracna.protocol.units import CENTRE
from trex_gui.devices.aracna.views.poses.files import PoseFiles
from trex_gui.devices.aracna.views.poses.motion_box import MotionBox
from trex_gui.devices.aracna.views.poses.name_list import small_button
from trex_gui.devices.aracna.views.poses.play_bar import PlayBar, Preview, preview
from trex_gui.devices.aracna.views.poses.pose_box import PoseBox
from trex_gui.devices.aracna.views.robot.drawing import RobotDrawing
from trex_gui.devices.aracna.views.robot.texts import assumed_text, move_blocker
from trex_gui.devices.aracna.views.typed import take_typed
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.widgets import builders
from trex_gui.ui.widgets.labels import ElidedLabel


class PosesPanel(QWidget):
    """Edits a library and requests what to play; the state of the robot is set from outside.

    Signals:
        go_to_requested: the positions of a pose, a tuple; not cropped.
        play_requested: a `Play` with goals within the limits; its `id` is 0.
        scale_changed: the new time scale, which also applies to what is playing.

    Attributes:
        files: opens and saves.
        capture: saves the robot's position as a new pose.
    """

    go_to_requested = Signal(object)
    play_requested = Signal(object)
    scale_changed = Signal(float)

    def __init__(self, library: Library, notifier: Notifier, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaPosesPanel")
        self._library = library
        self._limits = factory_limits()
        self._present: tuple[int | None, ...] = ()
        self._can_move = False
        self._why_not = self.tr("No robot is connected.")
        self._playing: PlayState | None = None
        self._played: ItemKey | None = None
        self._preview = Preview()
        self.files = PoseFiles(library, notifier, self)

        self._name = builders.named(ElidedLabel("poses.ppr", self), "aracnaPoseFile")
        title = self.tr("Pose file")
        menu_button = small_button(self, "aracnaFileMenu", title, tip=title, icon="folder")
        menu_button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu_button.setMenu(self._menu())
        stack = library.undo
        undo, redo = self.tr("Undo"), self.tr("Redo")
        self._undo = small_button(self, "aracnaUndo", tip=undo, icon="undo", on_click=stack.undo)
        self._redo = small_button(self, "aracnaRedo", tip=redo, icon="redo", on_click=stack.redo)
        self._poses = PoseBox(library, notifier, self)
        self._motions = MotionBox(library, notifier, self)
        self._bar = PlayBar(self)
        self.capture = self._poses.capture
        builders.column(
            builders.row(menu_button, self._undo, self._redo, (self._name, 1)),
            (builders.row((self._poses, 2), (self._motions, 3)), 1),
            self._bar,
            into=self,
            margins=0,
        )

        self._poses.go_to_requested.connect(self.go_to_requested)
        self._poses.pose_chosen.connect(self._motions.show_pose)
        self._motions.shown.connect(self._update_preview)
        self._bar.options_changed.connect(self._update_preview)
        self._bar.scale_changed.connect(self.scale_changed)
        self._bar.play_clicked.connect(self.play)
        library.changed.connect(self._on_library_changed)
        stack.canUndoChanged.connect(self._undo.setEnabled)  # with arguments: the stack may be gone
        stack.canRedoChanged.connect(self._redo.setEnabled)
        stack.undoTextChanged.connect(self._on_undo_text_changed)
        stack.redoTextChanged.connect(self._on_redo_text_changed)
        self._undo.setEnabled(stack.canUndo())
        self._redo.setEnabled(stack.canRedo())
        self._poses.show_limits(self._limits)
        self._show_whether_idle()
        self._on_library_changed()
        self._on_undo_text_changed(stack.undoText())
        self._on_redo_text_changed(stack.redoText())

    def _menu(self) -> QMenu:
        menu = builders.named(QMenu(self), "aracnaFileMenuEntries", accessible=self.tr("Pose file"))
        for name, text, icon, slot in (
            ("aracnaNewFile", self.tr("&New"), "new", self.files.new),
            ("aracnaOpenFile", self.tr("&Open…"), "open", self.files.ask_and_open),
            ("aracnaSaveFile", self.tr("&Save"), "save", self.files.save),
            ("aracnaSaveFileAs", self.tr("Save &as…"), "", self.files.ask_and_save),
        ):
            menu.addAction(builders.action(self, f"{name}Action", text, icon=icon, on_trigger=slot))
        return menu

    # --- The state of the robot ---------------------------------------------------------

    def show_link(self, can_move: bool, why_not: str = "") -> None:
        why_not = why_not or self.tr("No robot is connected.")
        if (can_move, why_not) != (self._can_move, self._why_not):
            self._can_move, self._why_not = can_move, why_not
            self._show_whether_idle()
            self._update_play_button()

    def _show_whether_idle(self) -> None:
        why_not = self.tr("A sequence is playing.") if self._playing else self._why_not
        self._poses.show_link(self._can_move and self._playing is None, why_not)

    def show_present(self, present: Present) -> None:
        if tuple(present) != self._present:
            self._present = tuple(present)
            self._poses.show_present(self._present)
            if self._playing is None:
                self._update_preview()

    def show_limits(self, limits: tuple[Limits, ...]) -> None:
        if limits != self._limits:
            self._limits = limits
            self._poses.show_limits(limits)
            self._update_preview()

    def show_playing(self, playing: PlayState | None) -> None:
        self._playing = playing
        self._show_whether_idle()
        self._mark_running_step()
        self._update_play_button()

    # --- Updates ------------------------------------------------------------------------

    @Slot()
    def _update_preview(self) -> None:
        self._preview = preview(
            self._motions.played,
            self._library.project.poses,
            self._limits,
            self._present,
            self._bar.options,
        )
        self._motions.table.show_notes(self._preview.notes)
        self._bar.show_summary(self._preview.text, alarming=self._preview.alarming)
        self._mark_running_step()
        self._update_play_button()

    def _mark_running_step(self) -> None:
        playing = self._playing
        is_shown = self._played == self._motions.current
        in_steps = playing is not None and playing.part == "steps" and is_shown
        self._motions.table.show_running(playing.step if playing and in_steps else None)

    def _update_play_button(self) -> None:
        playable = self._preview.play is not None
        if self._playing is not None:
            tip = self.tr("A sequence is playing.")
        elif not self._can_move:
            tip = self._why_not
        else:
            tip = self.tr("Play the current sequence or gait.") if playable else self._preview.text
        self._bar.set_play_enabled(playable and self._can_move and self._playing is None, tip)

    @Slot()
    def _on_library_changed(self) -> None:
        library = self._library
        name = self.tr("{0}, changed").format(library.name) if library.modified else library.name
        self._name.show_text(name)
        self._name.setToolTip(str(library.path or self.tr("Not saved yet")))
        self._update_preview()

    @Slot(str)
    def _on_undo_text_changed(self, text: str) -> None:
        self._undo.setToolTip(self.tr("Undo {0}").format(text).strip())

    @Slot(str)
    def _on_redo_text_changed(self, text: str) -> None:
        self._redo.setToolTip(self.tr("Redo {0}").format(text).strip())

    @Slot()
    def play(self) -> None:
        take_typed()
        self._update_preview()
        if self._preview.play is not None and self._can_move and self._playing is None:
            self._played = self._motions.current
            self.play_requested.emit(self._preview.play)


class PosesPage(QWidget):
    """The panel beside a drawing, connected to the robot."""

    def __init__(self, robot: Robot, library: Library, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaPosesPage")
        self._robot = robot
        self.panel = PosesPanel(library, robot.notifier, self)
        self._drawing = builders.named(RobotDrawing(robot.state, self), "aracnaPosesDrawing")
        footnote = builders.label(self, "aracnaPosesFootnote", f"* {assumed_text()}", wrap=True)
        footnote.setForegroundRole(footnote.palette().ColorRole.PlaceholderText)
        left = builders.column((self._drawing, 1), footnote, 0)
        builders.row((left, 1), (self.panel, 4), into=self, spacing=16)

        self._drawing.pointed.connect(self._drawing.mark)
        self.panel.go_to_requested.connect(self._on_go_to_requested)
        self.panel.play_requested.connect(robot.play)
        self.panel.scale_changed.connect(robot.set_time_scale)
        robot.changed.connect(self._on_changed)
        robot.limits.changed.connect(self._on_changed)
        robot.targets.changed.connect(self._on_changed)
        self._on_changed()

    @Slot(object)
    def _on_go_to_requested(self, positions: tuple[int, ...]) -> None:
        """Move to a pose; motors without a position go to the centre."""
        motors = self._robot.state.motors
        self._robot.move((*positions, *(CENTRE,) * motors)[:motors])

    @Slot()
    def _on_changed(self) -> None:
        robot, state = self._robot, self._robot.state
        why_not = move_blocker(robot)
        self.panel.show_link(not why_not, why_not)
        self.panel.show_present(state.present)
        self.panel.show_limits(robot.limits.first(state.motors))
        self.panel.show_playing(state.playing)
        self._drawing.show_robot(state, robot.targets.goals)
