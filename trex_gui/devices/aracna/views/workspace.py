"""Workspace of an Aracna: pages, motion bar and menu actions."""

from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Slot
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QWidget

from trex_gui.core.recording.store import Recording
from trex_gui.core.translation import tr
from trex_gui.devices.aracna.model.controller import AracnaController
from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.model.recordings import AracnaRecorder, RobotPlayback
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.poses.ppr import SUFFIX
from trex_gui.devices.aracna.recording import FORMAT, Record, RobotHeader
from trex_gui.devices.aracna.views.demo import DemoRobotView
from trex_gui.devices.aracna.views.help import TOPICS, message_help
from trex_gui.devices.aracna.views.motion_bar import MotionBar
from trex_gui.devices.aracna.views.poses.page import PosesPage
from trex_gui.devices.aracna.views.problems import RobotProblemsPage
from trex_gui.devices.aracna.views.robot.page import RobotPage
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.demo_panel import DemoDock
from trex_gui.ui.diagnostics.place import Diagnostics
from trex_gui.ui.frame.main_window import MainWindow
from trex_gui.ui.frame.start_panel import StartPanel, StartTexts, StartWay
from trex_gui.ui.frame.wiring_sketch import Wires
from trex_gui.ui.frame.workspace import SEPARATOR, Entry, FileKind, Menu, Menus, PageInfo, Workspace
from trex_gui.ui.playback.manager import RecordingManager, RecordingTexts
from trex_gui.ui.traffic.page import TrafficPage
from trex_gui.ui.widgets import builders as ui

if TYPE_CHECKING:
    from trex_gui.devices.aracna.views.playback import RobotPlaybackWindow


class AracnaRecordings(RecordingManager["RobotPlaybackWindow"]):
    def __init__(self, robot: Robot, window: QWidget) -> None:
        texts = RecordingTexts(
            stem="aracna",
            unavailable=tr("Nothing can be recorded: no robot is connected."),
            open_command=tr("Aracna, Open recording"),
        )
        super().__init__(
            AracnaRecorder(robot),
            FORMAT,
            texts,
            robot.notifier,
            window,
            store="aracna/recording",
            prefix="aracna_",
        )
        self._robot = robot

    def create_window(self, recording: Recording[RobotHeader, Record]) -> "RobotPlaybackWindow":
        # Imported late, because the plotting library takes as long to load as all of Qt.
        from trex_gui.devices.aracna.views.playback import RobotPlaybackWindow  # noqa: PLC0415

        return RobotPlaybackWindow(RobotPlayback(recording), self._robot)


class AracnaWorkspace(Workspace):
    def __init__(self, controller: AracnaController, frame: MainWindow) -> None:
        robot = controller.robot
        super().__init__(controller.plugin.key, robot.notifier, frame.stack)
        self._robot = robot
        self._controller = controller
        self.help_topics, self.message_help = TOPICS, message_help()
        self.log.follow(robot.events)
        self.library = Library(robot)
        self._menu_state: tuple[Mapping[str, bool], bool] = ({}, False)

        tabs = self.pages
        tabs.setObjectName("aracnaTabs")
        tabs.setAccessibleName(tr("Pages"))
        self._frame = frame
        self._page = page = RobotPage(robot, self._create_start_panel, self)
        self._poses = PosesPage(robot, self.library, self)
        traffic = TrafficPage(robot.traffic, "aracnaTranscript", tr("a robot"), self.notifier, self)
        diagnostics = Diagnostics(self, "aracnaDiagnostics", frame.show_help)
        problems = RobotProblemsPage(robot, self.log, self.message_help, self)
        self.add_pages(
            (
                PageInfo("robot", tr("R&obot"), lambda _parent: page, "board"),
                PageInfo("poses", tr("Pos&es"), lambda _parent: self._poses, "copy"),
                *diagnostics.pages(lambda _parent: problems, lambda _parent: traffic),
            )
        )
        self.create_pages()  # a page outside the tabs would cover the first page
        self.recordings = AracnaRecordings(robot, self)
        self.recordings.accept_drops(frame, self)
        self.bar = MotionBar(robot, self.recordings.indicator, self)
        ui.column(tabs, into=self, margins=0)
        create_demo, key = partial(DemoRobotView, controller), "aracna/demo_panel"
        self._demo = DemoDock("aracnaDemoPanel", key, controller, create_demo, frame)
        self._demo.setWindowTitle(tr("Demo Aracna"))
        self.stop_text = tr("&Stop sequence")  # this robot has no stop command
        self.docks = (self._demo,)
        self.motion_keys = {"aracna_move", "aracna_play", "aracna_led"}
        pose_files = self._poses.files
        pose_files.opened.connect(lambda: self.show_page("poses"))
        poses = FileKind({SUFFIX}, tr("an Aracna pose file"), pose_files.open_file)
        self.file_kinds = (poses,)
        self.openers = {"poses": pose_files.open_file, "recording": self.recordings.open_file}
        pose_files.used.connect(partial(frame.files.recent.add, self.key, "poses"))
        self.recordings.used.connect(partial(frame.files.recent.add, self.key, "recording"))

        controller.demo_robot.rejected.connect(self.notifier.error)
        for signal in (
            controller.changed,
            robot.changed,
            robot.limits.changed,
            self.recordings.changed,
            self._demo.wanted_changed,
        ):
            signal.connect(self._on_changed)
        self._undo_watch = self.library.undo.indexChanged.connect(self._on_changed)

    def _create_start_panel(self, parent: QWidget) -> StartPanel:
        texts = StartTexts(
            title=tr("Connect my {0}").format(self._controller.plugin.name),
            hint=tr(
                "Keep clear of the legs: this robot has no stop command. Nothing moves until "
                "you press Move."
            ),
            ways=(
                StartWay(
                    Wires(
                        tr("ArbotiX"), tr("Adapter"), (("TX", "RX"), ("RX", "TX"), ("GND", "GND"))
                    ),
                    tr(
                        "Connect an FTDI cable to the header or plug an XBee radio into the "
                        "socket: both share one line. Switch on the servo power as well. "
                        "Without servo power, the first move never ends."
                    ),
                ),
            ),
            demo_heading=tr("No robot at hand?"),
            demo=tr("Tr&y the demo"),
            files=(
                ("aracna_open", tr("Open pose fi&le…")),
                ("aracna_open_recording", tr("Ope&n recording…")),
                ("aracna_offline", tr("Set &up goals and limits")),
            ),
            prefix="aracna_",
        )
        return StartPanel(texts, self._frame, self, parent)

    def report_parts(self) -> dict[str, Callable[[], str]]:
        robot = self._robot
        status = f"{robot.status}\n"
        if robot.settings is not None:
            status += f"Line: {robot.settings.text()}\n"
        return {
            "status.txt": lambda: status,
            **super().report_parts(),
            "traffic.txt": robot.traffic.newest_as_text(),
        }

    def menus(self) -> Menus:
        keys = QKeySequence.StandardKey
        move, robot = self._page.controls.move_now, self._robot
        files, undo = self._poses.files, self.library.undo
        record, open_recording = self.recordings.toggle, self.recordings.select_and_open
        play = partial(self._on_page, "poses", self._poses.play)

        def switch_led() -> None:
            robot.set_led(on=not robot.state.led)

        return {
            tr("&Aracna"): (
                Entry("aracna_move", tr("&Move to the sliders' goals"), move, "Ctrl+M", "run"),
                Entry("aracna_play", tr("Pla&y the current sequence or gait"), play, "Ctrl+R"),
                Entry("aracna_end", tr("&End sequence after this step"), robot.end_play, "Ctrl+E"),
                SEPARATOR,
                Entry("aracna_record", tr("&Record…"), record, "Ctrl+Shift+R", "record"),
                Entry(
                    "aracna_open_recording",
                    tr("Ope&n recording…"),
                    open_recording,
                    "Ctrl+Shift+O",
                    "plot",
                ),
                SEPARATOR,
                Entry(
                    "aracna_offline",
                    tr("Set up &goals and limits without a robot"),
                    partial(self._on_page, "robot", self._page.set_up_offline),
                ),
                Entry("aracna_led", tr("&Debug LED of the board"), switch_led, checkable=True),
            ),
            tr("Pos&es"): (
                Entry("aracna_new", tr("&New pose file"), files.new, keys.New, "new"),
                Entry(
                    "aracna_open", tr("&Open pose file…"), files.prompt_and_open, "Ctrl+O", "open"
                ),
                Entry("aracna_save", tr("&Save pose file"), files.save, "Ctrl+S", "save"),
                Entry("aracna_save_as", tr("Save pose file &as…"), files.prompt_and_save),
                SEPARATOR,
                Entry("aracna_undo", tr("&Undo"), undo.undo, keys.Undo, "undo"),
                Entry("aracna_redo", tr("&Redo"), undo.redo, keys.Redo, "redo"),
                SEPARATOR,
                Entry(
                    "aracna_capture",
                    tr("&Capture the present position as a pose"),
                    partial(self._on_page, "poses", self._poses.capture),
                    "Ctrl+Shift+P",
                ),
            ),
            Menu.WINDOW: (
                *self.page_entries(),
                SEPARATOR,
                Entry("aracna_demo", tr("&Demo Aracna panel"), self._demo.toggle, checkable=True),
            ),
        }

    def set_actions(self, actions: Mapping[str, QAction]) -> None:
        super().set_actions(actions)
        self._demo.show_if_wanted()
        self._on_changed()

    @property
    def device_name(self) -> str:
        is_connected = self._robot.link is ConnectionState.CONNECTED
        return self._controller.plugin.name if is_connected else ""

    @property
    def has_edits(self) -> bool:
        return self.library.modified

    def enabled_actions(self) -> Mapping[str, bool]:
        robot, recorder = self._robot, self.recordings.recorder
        is_idle, undo = robot.state.play is None, self.library.undo
        return {
            "aracna_move": not robot.move_blocker,
            "aracna_play": not robot.move_blocker,
            "aracna_end": not is_idle and robot.link is ConnectionState.CONNECTED,
            "aracna_record": recorder.recording or recorder.can_record,
            "aracna_offline": robot.link is ConnectionState.DISCONNECTED,
            "aracna_led": is_idle and robot.link is ConnectionState.CONNECTED,
            "aracna_capture": None not in robot.state.present,
            "aracna_undo": undo.canUndo(),
            "aracna_redo": undo.canRedo(),
            "aracna_demo": self._controller.demo_in_use,
        }

    def _on_page(self, key: str, action: Callable[[], None]) -> None:
        self.show_page(key)
        action()

    @Slot()
    def _on_changed(self) -> None:
        """Update the menus if necessary. Replies arrive 30 times a second."""
        if not self._actions:
            return
        recording = self.recordings.recorder.recording
        text = tr("Stop &recording") if recording else tr("&Record…")
        self._actions["aracna_record"].setText(text)
        self._actions["aracna_demo"].setChecked(self._demo.wanted)
        self._actions["aracna_led"].setChecked(bool(self._robot.state.led))
        if (menu_state := (self.enabled_actions(), self.has_edits)) != self._menu_state:
            self._menu_state = menu_state
            self.actions_changed.emit()

    def may_close(self, leave: Callable[[], object]) -> bool:
        return self._poses.files.may_close(leave)

    def prepare_to_close(self) -> None:
        QObject.disconnect(self._undo_watch)  # the undo stack also emits when destroyed
        self._demo.hide_dock()

    def finish(self) -> None:
        self.recordings.close_all()

    def shut_down(self) -> bool:
        return self.recordings.shut_down()
