"""Recording the robot's session, and opening what was recorded."""

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, QEvent, QObject
from PySide6.QtWidgets import QWidget

from trex_gui.devices.aracna.model.playback import RobotPlayback
from trex_gui.devices.aracna.model.recorder import AracnaRecorder
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.trex.views.recordings.recordings import SUFFIXES
from trex_gui.ui.playback.keeper import RecordingManager, RecordingWords
from trex_gui.ui.widgets.file_drop import FileDrop

if TYPE_CHECKING:
    from trex_gui.devices.aracna.views.playback.window import RobotPlaybackWindow


class AracnaRecordings(RecordingManager[AracnaRecorder, "RobotPlaybackWindow"]):
    """One recorder, the row that shows that it records, and the windows of what was recorded."""

    def __init__(self, robot: Robot, window: QWidget) -> None:
        super().__init__(
            AracnaRecorder(robot),
            _words(),
            robot.notifier,
            window,
            store="aracna/recording",
            prefix="aracna_",
        )
        self._robot = robot

    def take_drops(self, frame: QWidget, workspace: QWidget) -> None:
        """Open the recordings that are dropped on a window while this desk is shown in it."""
        _DeskDrop(frame, workspace).dropped.connect(self.open_file)

    def open_window(self, path: Path) -> "RobotPlaybackWindow":
        playback = RobotPlayback.open(path)
        # The plotting library takes as long to load as all of Qt: not before it is needed.
        from trex_gui.devices.aracna.views.playback.window import RobotPlaybackWindow  # noqa: PLC0415

        return RobotPlaybackWindow(playback, self._robot)


class _DeskDrop(FileDrop):
    """Takes recordings of any device, so that those of another are told from these.

    What was installed last is asked first: no other desk gets them while this one is shown.
    """

    def __init__(self, frame: QWidget, workspace: QWidget) -> None:
        super().__init__(frame, SUFFIXES)
        self._workspace = workspace

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        return self._workspace.isVisible() and super().eventFilter(watched, event)


def _words() -> RecordingWords:
    def tr(text: str) -> str:
        return QCoreApplication.translate("AracnaRecordings", text)

    return RecordingWords(
        stem="aracna",
        kinds={tr("CSV for spreadsheets (*.csv)"): ".csv"},
        nothing=tr("Nothing can be recorded: no robot is connected."),
        shown_by=tr("Aracna, Open recording"),
    )
