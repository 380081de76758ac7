"""Page to edit, save and play poses, sequences and gaits."""

from PySide6.QtCore import Slot
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.model.texts import assumed_text
from trex_gui.devices.aracna.views.poses.files import PoseFiles
from trex_gui.devices.aracna.views.poses.motion_box import MotionBox
from trex_gui.devices.aracna.views.poses.play_bar import PlayBar
from trex_gui.devices.aracna.views.poses.pose_box import PoseBox
from trex_gui.devices.aracna.views.robot.drawing import RobotCard
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import PAGE_MARGINS, PageHead


class PosesPage(QWidget):
    def __init__(self, robot: Robot, library: Library, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaPosesPage")
        self._library = library
        self.files = PoseFiles(library, robot.notifier, self)
        self._head = PageHead(title_of(tr("Pos&es")), self)
        panel = QWidget(self)
        poses = PoseBox(robot, library, panel)
        motions = MotionBox(library, robot.notifier, panel)
        bar = PlayBar(robot, library, motions, panel)
        self.capture = poses.capture
        self.play = bar.play
        cards = ui.row((poses, 2), (motions, 3), spacing=16)
        ui.column((cards, 1), bar, into=panel, margins=0, spacing=8)
        self._drawn = RobotCard(robot, f"* {assumed_text()}", panel, self)
        below = ui.row((self._drawn, 2), (panel, 7), spacing=16)
        ui.column(self._head, (below, 1), into=self, margins=PAGE_MARGINS, spacing=8)

        poses.pose_selected.connect(motions.set_step_pose)
        motions.set_step_pose(poses.current_name)
        library.changed.connect(self._show_file)
        self._show_file()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._drawn.show_in(self.contentsRect().width())

    @Slot()
    def _show_file(self) -> None:
        name = str(self._library.path or self._library.name)
        self._head.show_state(tr("{0}, changed").format(name) if self._library.modified else name)
