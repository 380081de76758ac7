"""The poses page: poses, sequences and gaits are edited, kept in files, and played."""

from PySide6.QtCore import Slot
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QToolButton, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.model.texts import assumed_text
from trex_gui.devices.aracna.views.poses.files import PoseFiles
from trex_gui.devices.aracna.views.poses.motion_box import MotionBox
from trex_gui.devices.aracna.views.poses.name_list import small_button
from trex_gui.devices.aracna.views.poses.play_bar import PlayBar
from trex_gui.devices.aracna.views.poses.pose_box import PoseBox
from trex_gui.devices.aracna.views.robot.drawing import RobotDrawing
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import ElidedLabel


class PosesPage(QWidget):
    """Edits a library beside a drawing of the robot that plays it."""

    def __init__(self, robot: Robot, library: Library, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaPosesPage")
        self._library = library
        self.files = PoseFiles(library, robot.notifier, self)
        drawing = ui.named(RobotDrawing(robot.state, self), "aracnaPosesDrawing")
        drawing.follow(robot)
        drawing.pointed.connect(drawing.mark)
        footnote = ui.label(self, "aracnaPosesFootnote", f"* {assumed_text()}", wrap=True)
        footnote.setForegroundRole(footnote.palette().ColorRole.PlaceholderText)
        self._name = ui.named(ElidedLabel("poses.ppr", self), "aracnaPoseFile")
        undo = library.undo.createUndoAction(self, tr("Undo"))
        redo = library.undo.createRedoAction(self, tr("Redo"))
        head = ui.row(
            self._file_button(),
            self._action_button("aracnaUndo", undo, "undo"),
            self._action_button("aracnaRedo", redo, "redo"),
            (self._name, 1),
        )
        poses = PoseBox(robot, library, self)
        motions = MotionBox(library, robot.notifier, self)
        bar = PlayBar(robot, library, motions, self)
        self.capture = poses.capture
        self.play = bar.play
        panel = ui.column(head, (ui.row((poses, 2), (motions, 3)), 1), bar, spacing=6)
        left = ui.column((drawing, 1), footnote, 0)
        ui.row((left, 1), (panel, 4), into=self, margins=4, spacing=6)

        poses.pose_chosen.connect(motions.show_pose)
        motions.show_pose(poses.current_name)
        library.changed.connect(self._show_file)
        self._show_file()

    def _file_button(self) -> QToolButton:
        title = tr("Pose file")
        menu = ui.named(QMenu(self), "aracnaFileMenuEntries", accessible=title)
        for name, text, icon, slot in (
            ("aracnaNewFile", tr("&New"), "new", self.files.new),
            ("aracnaOpenFile", tr("&Open…"), "open", self.files.ask_and_open),
            ("aracnaSaveFile", tr("&Save"), "save", self.files.save),
            ("aracnaSaveFileAs", tr("Save &as…"), "", self.files.ask_and_save),
        ):
            menu.addAction(ui.action(self, f"{name}Action", text, icon=icon, on_trigger=slot))
        button = small_button(self, "aracnaFileMenu", title, text=title, icon="folder")
        button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        button.setMenu(menu)
        return button

    def _action_button(self, name: str, action: QAction, icon: str) -> QToolButton:
        set_icon(action, icon)
        button = small_button(self, name, action.text())
        button.setDefaultAction(action)
        # Qt would show the text, with the name of a pose in it, as a tool tip that may be markup.
        action.changed.connect(lambda: action.setToolTip(ui.plain(action.text())))
        return button

    @Slot()
    def _show_file(self) -> None:
        library = self._library
        name = tr("{0}, changed").format(library.name) if library.modified else library.name
        self._name.show_text(name)
        self._name.setToolTip(ui.plain(str(library.path or tr("Not saved yet"))))
