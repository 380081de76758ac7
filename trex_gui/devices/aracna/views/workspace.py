"""The workspace of an Aracna: its pages, the bar below them, and its menu actions."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from PySide6.QtCore import QObject, QSettings, Slot
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QDockWidget, QVBoxLayout

from trex_gui.devices.aracna.model.controller import AracnaController
from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.poses.ppr import SUFFIX
from trex_gui.devices.aracna.views.action_bar import ActionBar
from trex_gui.devices.aracna.views.demo import RobotPanel
from trex_gui.devices.aracna.views.help import help_text
from trex_gui.devices.aracna.views.log_page import LogPage
from trex_gui.devices.aracna.views.menu import menus
from trex_gui.devices.aracna.views.poses.page import PosesPage
from trex_gui.devices.aracna.views.recordings import AracnaRecordings
from trex_gui.devices.aracna.views.robot.page import RobotPage
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.frame.main_window import MainWindow
from trex_gui.ui.frame.workspace import FileKind, Menus, PageInfo, Workspace
from trex_gui.ui.traffic.page import TrafficPage

_PAGE = "aracna/page"


class AracnaWorkspace(Workspace):
    """Everything in the window that is specific to an Aracna; has no state of the robot."""

    def __init__(self, controller: AracnaController, frame: MainWindow) -> None:
        robot = controller.robot
        super().__init__(controller.plugin.key, robot.notifier, frame)
        self._robot = robot
        self._library = library = Library(robot)
        self._store = QSettings(self)
        self._was_up = False
        self._actions: Mapping[str, QAction] = {}
        self._shown_actions: Mapping[str, bool] = {}

        tabs = self.pages
        tabs.setObjectName("aracnaTabs")
        tabs.setAccessibleName(self.tr("Pages"))
        self._page = RobotPage(robot, self)
        self._poses = PosesPage(robot, library, self)
        traffic = TrafficPage(
            robot.traffic, "aracnaTranscript", self.tr("a robot"), self.notifier, self
        )
        self.add_pages(
            (
                PageInfo("robot", self.tr("R&obot"), self._page),
                PageInfo("poses", self.tr("Pos&es"), self._poses),
                PageInfo("log", self.tr("Lo&g"), LogPage(robot, self)),
                PageInfo("transcript", self.tr("&Traffic"), traffic),
            )
        )
        self.recordings = AracnaRecordings(robot, self)
        self.recordings.accept_drops(frame, self)
        bar = ActionBar(robot, self)
        self._controller = controller
        self._demo = RobotPanel(controller, frame)

        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(tabs, 1)
        layout.addWidget(self.recordings.indicator)
        layout.addWidget(bar)

        controller.demo_robot.rejected.connect(self.notifier.error)
        controller.changed.connect(self._on_changed)
        self._demo.wanted_changed.connect(self._on_demo_wanted)
        robot.link_changed.connect(self._on_link_changed)
        robot.changed.connect(self._on_changed)
        robot.limits.changed.connect(self._on_changed)
        self.recordings.changed.connect(self._on_changed)
        self._undo_watch = library.undo.indexChanged.connect(self._on_changed)

    @property
    def library(self) -> Library:
        """The poses and sequences."""
        return self._library

    @property
    def stop_text(self) -> str:
        """This robot has no stop."""
        return self.tr("&Stop sequence")

    @property
    def help_title(self) -> str:
        """There is no published documentation to link to."""
        return self.tr("&Help on the Aracna…")

    @property
    def help_text(self) -> str:
        return help_text(self.menus())

    @property
    def file_kinds(self) -> Sequence[FileKind]:
        """Pose files; recordings open in their own windows."""
        return (FileKind({SUFFIX}, self.tr("a pose file of an Aracna"), self._open_poses),)

    def _open_poses(self, path: Path) -> None:
        if self._poses.files.open_file(path):
            self.show_page("poses")

    @property
    def docks(self) -> Sequence[QDockWidget]:
        return (self._demo,)

    # --- Menus --------------------------------------------------------------------------

    def menus(self) -> Menus:
        return menus(self.page_actions())

    def slots(self) -> Mapping[str, Callable[[], object]]:
        controls, files, undo = self._page.controls, self._poses.files, self._library.undo
        return {
            "aracna_move": self._page.move_now,
            "aracna_present": controls.take_present,
            "aracna_centre": controls.centre,
            "aracna_stand": controls.stand,
            "aracna_play": self._play,
            "aracna_end": self._robot.end_play,
            "aracna_record": self.recordings.toggle,
            "aracna_open_recording": self.recordings.choose_and_open,
            "aracna_limits": self._robot.limits.reset,
            **self.page_slots(),
            "aracna_new": files.new,
            "aracna_open": files.ask_and_open,
            "aracna_save": files.save,
            "aracna_save_as": files.ask_and_save,
            "aracna_undo": undo.undo,
            "aracna_redo": undo.redo,
            "aracna_capture": self._capture,
            "aracna_demo": self._demo.toggle,
        }

    def take_actions(self, actions: Mapping[str, QAction]) -> None:
        self._actions = actions
        page = str(self._store.value(_PAGE, 0))
        self.pages.setCurrentIndex(int(page) if page.isdigit() else 0)
        self._demo.show_if_wanted()
        self._on_demo_wanted()
        self._on_changed()

    def enabled_actions(self) -> Mapping[str, bool]:
        robot, recorder = self._robot, self.recordings.recorder
        idle, undo = robot.state.play is None, self._library.undo
        known = any(position is not None for position in robot.state.present)
        return {
            "aracna_move": self._page.controls.can_move,
            "aracna_present": idle and known,
            "aracna_centre": idle,
            "aracna_stand": idle,
            "aracna_play": self._page.controls.can_move,
            "aracna_end": not idle and robot.link is ConnectionState.CONNECTED,
            "aracna_record": recorder.recording or recorder.can_record,
            "aracna_limits": not robot.limits.are_factory,
            "aracna_capture": None not in robot.state.present,
            "aracna_undo": undo.canUndo(),
            "aracna_redo": undo.canRedo(),
            "aracna_demo": self._controller.demo_in_use,
        }

    def _play(self) -> None:
        self.show_page("poses")
        self._poses.play()

    def _capture(self) -> None:
        self.show_page("poses")
        self._poses.capture()

    # --- Updates ------------------------------------------------------------------------

    @Slot()
    def _on_link_changed(self) -> None:
        up = self._robot.link is ConnectionState.CONNECTED
        if up and not self._was_up:
            self.notifier.cleared.emit()
        self._was_up = up
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        """Update the menus only if needed: while dragging, replies arrive 30 times a second."""
        if not self._actions:
            return
        recording = self.recordings.recorder.recording
        text = self.tr("Stop &recording") if recording else self.tr("&Record…")
        self._actions["aracna_record"].setText(text)
        if (enabled_actions := self.enabled_actions()) != self._shown_actions:
            self._shown_actions = enabled_actions
            self.actions_changed.emit()

    @Slot()
    def _on_demo_wanted(self) -> None:
        if self._actions:
            self._actions["aracna_demo"].setChecked(self._demo.wanted)

    # --- The end ------------------------------------------------------------------------

    def may_close(self, leave: Callable[[], object]) -> bool:
        del leave
        return self._poses.files.may_close()

    def prepare_to_close(self) -> None:
        QObject.disconnect(self._undo_watch)  # the stack emits at its end, too
        self._demo.leave()
        self._store.setValue(_PAGE, self.pages.currentIndex())

    def finish(self) -> None:
        self.recordings.close_all()

    def shut_down(self) -> bool:
        return self.recordings.shut_down()
