"""Recording a robot and opening its recordings."""

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QWidget

from trex_gui.devices.aracna.model.recordings import AracnaRecorder, RobotPlayback
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.ui.playback.manager import RecordingManager, RecordingTexts

if TYPE_CHECKING:
    from trex_gui.devices.aracna.views.playback import RobotPlaybackWindow


class AracnaRecordings(RecordingManager["RobotPlaybackWindow"]):
    def __init__(self, robot: Robot, window: QWidget) -> None:
        super().__init__(
            AracnaRecorder(robot),
            _texts(),
            robot.notifier,
            window,
            store="aracna/recording",
            prefix="aracna_",
        )
        self._robot = robot

    def open_window(self, path: Path) -> "RobotPlaybackWindow":
        playback = RobotPlayback.open(path)
        # The plotting library takes as long to load as all of Qt: not before it is needed.
        from trex_gui.devices.aracna.views.playback import RobotPlaybackWindow  # noqa: PLC0415

        return RobotPlaybackWindow(playback, self._robot)


def _texts() -> RecordingTexts:
    def tr(text: str) -> str:
        return QCoreApplication.translate("AracnaRecordings", text)

    return RecordingTexts(
        stem="aracna",
        unavailable=tr("Nothing can be recorded: no robot is connected."),
        open_command=tr("Aracna, Open recording"),
    )
