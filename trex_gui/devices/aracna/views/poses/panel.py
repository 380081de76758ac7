"""Poses, sequences and gaits: kept in files, put in order, played."""

from PySide6.QtCore import Signal, Slot
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QHBoxLayout, QMenu, QToolButton, QVBoxLayout, QWidget

from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.model.names import Motion
from trex_gui.devices.aracna.model.robot_state import PlayState
from trex_gui.devices.aracna.poses.travel import Present
from trex_gui.devices.aracna.protocol.joints import Limits, factory_limits
from trex_gui.devices.aracna.views.poses.files import PoseFiles
from trex_gui.devices.aracna.views.poses.motion_box import MotionBox
from trex_gui.devices.aracna.views.poses.parts import tool_button
from trex_gui.devices.aracna.views.poses.play_bar import PlayBar
from trex_gui.devices.aracna.views.poses.pose_box import PoseBox
from trex_gui.devices.aracna.views.poses.preview import Preview, preview
from trex_gui.devices.aracna.views.typed import take_typed
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.widgets.elided_label import ElidedLabel


class PosesPanel(QWidget):
    """Edits a library and asks for what is to be played; knows no robot.

    It is told of the robot by `show_link`, `show_present`, `show_limits` and `show_playing`.

    Signals:
        go_to_requested: positions are to be reached, a tuple as the pose has them, not cropped.
        play_requested: a `Play` whose goals are within the limits; its `id` is 0.
        scale_changed: the factor on the seconds of each step, also while something is played.

    Attributes:
        files: opening and saving; `files.may_close()` asks before edits are lost.
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
        self._up = False
        self._why_not = self.tr("There is no robot that could move now.")
        self._playing: PlayState | None = None
        self._played: Motion | None = None
        self._preview = Preview()
        self.files = PoseFiles(library, notifier, self)

        self._name = ElidedLabel("poses.ppr", self)
        self._name.setObjectName("aracnaPoseFile")
        self._menu_button = tool_button(
            self, "aracnaFileMenu", self.tr("Pose file"), self.tr("Pose file"), "folder"
        )
        self._menu_button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self._menu_button.setMenu(self._menu())
        self._undo_button = tool_button(self, "aracnaUndo", "", self.tr("Undo"), "undo")
        self._redo_button = tool_button(self, "aracnaRedo", "", self.tr("Redo"), "redo")
        self._poses = PoseBox(library, notifier, self)
        self._motions = MotionBox(library, notifier, self)
        self._bar = PlayBar(self)

        head = QHBoxLayout()
        head.addWidget(self._menu_button)
        head.addWidget(self._undo_button)
        head.addWidget(self._redo_button)
        head.addWidget(self._name, 1)
        boxes = QHBoxLayout()
        boxes.addWidget(self._poses, 2)
        boxes.addWidget(self._motions, 3)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(head)
        layout.addLayout(boxes, 1)
        layout.addWidget(self._bar)

        self._poses.go_to_requested.connect(self.go_to_requested)
        self._poses.pose_chosen.connect(self._motions.show_pose)
        self._motions.shown.connect(self._renew)
        self._bar.choices_changed.connect(self._renew)
        self._bar.scale_changed.connect(self.scale_changed)
        self._bar.play_clicked.connect(self.play)
        self._undo_button.clicked.connect(library.undo.undo)
        self._redo_button.clicked.connect(library.undo.redo)
        library.undo.canUndoChanged.connect(self._undo_button.setEnabled)
        library.undo.canRedoChanged.connect(self._redo_button.setEnabled)
        library.undo.undoTextChanged.connect(self._on_undo_text_changed)
        library.undo.redoTextChanged.connect(self._on_redo_text_changed)
        library.changed.connect(self._on_library_changed)
        self._poses.show_limits(self._limits)
        self._undo_button.setEnabled(library.undo.canUndo())
        self._redo_button.setEnabled(library.undo.canRedo())
        self._on_undo_text_changed(library.undo.undoText())
        self._on_redo_text_changed(library.undo.redoText())
        self._on_library_changed()

    def _menu(self) -> QMenu:
        menu = QMenu(self)
        menu.setObjectName("aracnaFileMenuEntries")
        menu.setAccessibleName(self.tr("Pose file"))
        for name, text, icon, slot in (
            ("aracnaNewFile", self.tr("&New"), "new", self.files.new),
            ("aracnaOpenFile", self.tr("&Open…"), "open", self.files.ask_and_open),
            ("aracnaSaveFile", self.tr("&Save"), "save", self.files.save),
            ("aracnaSaveFileAs", self.tr("Save &as…"), "", self.files.ask_and_save),
        ):
            action = QAction(text, self)
            action.setObjectName(f"{name}Action")
            if icon:
                set_icon(action, icon)
            action.triggered.connect(slot)
            menu.addAction(action)
        return menu

    # --- What it is told of the robot ---------------------------------------------------

    def show_link(self, up: bool, why_not: str = "") -> None:
        """Whether there is a robot that can be moved; else why not."""
        why_not = why_not or self.tr("There is no robot that could move now.")
        if (up, why_not) != (self._up, self._why_not):
            self._up, self._why_not = up, why_not
            self._show_whether_idle()
            self._allow()

    def _show_whether_idle(self) -> None:
        why_not = self.tr("Something is being played.") if self._playing else self._why_not
        self._poses.show_link(self._up and self._playing is None, why_not)

    def show_present(self, present: Present) -> None:
        """Where each motor is; `None` where that is not known."""
        if tuple(present) != self._present:
            self._present = tuple(present)
            self._poses.show_present(self._present)
            if self._playing is None:
                self._renew()

    def show_limits(self, limits: tuple[Limits, ...]) -> None:
        """How far each joint may turn, one a motor of the robot."""
        if limits != self._limits:
            self._limits = limits
            self._poses.show_limits(limits)
            self._renew()

    def show_playing(self, playing: PlayState | None) -> None:
        """What is played, and which step of it runs."""
        self._playing = playing
        self._show_whether_idle()
        self._mark()
        self._allow()

    # --- Keeping up ---------------------------------------------------------------------

    @Slot()
    def _renew(self) -> None:
        """Look again at what would be played."""
        self._preview = preview(
            self._motions.played,
            self._library.poses,
            self._limits,
            self._present,
            self._bar.choices,
        )
        self._motions.table.show_notes(self._preview.notes)
        self._bar.show_summary(self._preview.text, alarming=self._preview.alarming)
        self._mark()
        self._allow()

    def _mark(self) -> None:
        playing = self._playing
        shown = playing is not None and self._played == self._motions.current
        in_steps = playing is not None and playing.part == "steps"
        running = playing.step if playing is not None and shown and in_steps else None
        self._motions.table.show_running(running)

    def _allow(self) -> None:
        playable = self._preview.play is not None
        if self._playing is not None:
            why = self.tr("Something is being played.")
        elif not self._up:
            why = self._why_not
        else:
            why = self.tr("Play what is chosen.") if playable else self._preview.text
        self._bar.allow(
            play=playable and self._up and self._playing is None,
            why=why,
        )

    @Slot()
    def _on_library_changed(self) -> None:
        library = self._library
        name = self.tr("{0}, changed").format(library.name) if library.modified else library.name
        self._name.show_text(name)
        self._name.setToolTip(str(library.path or self.tr("Not saved yet")))
        self._renew()

    @Slot(str)
    def _on_undo_text_changed(self, text: str) -> None:
        self._undo_button.setToolTip(self.tr("Undo {0}").format(text).strip())

    @Slot(str)
    def _on_redo_text_changed(self, text: str) -> None:
        self._redo_button.setToolTip(self.tr("Redo {0}").format(text).strip())

    # --- What a person does -------------------------------------------------------------

    @Slot()
    def play(self) -> None:
        """Ask for what is chosen to be played; nothing while it cannot be."""
        take_typed()
        self._renew()
        if self._preview.play is not None and self._up and self._playing is None:
            self._played = self._motions.current
            self.play_requested.emit(self._preview.play)

    @Slot()
    def capture(self) -> None:
        """Keep where the robot is as a new pose, and let its name be typed."""
        self._poses.capture()
