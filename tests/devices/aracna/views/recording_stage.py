"""Windows of recordings of a robot, and their driver."""

from pathlib import Path

from pytestqt.qtbot import QtBot

from tests.devices.aracna.recordings import HEADER, MOTORS, T0, open_recording, write
from tests.support.playing import loading
from tests.support.window import WidgetDriver
from trex_gui.core.recording.kinds import Marker
from trex_gui.devices.aracna.model.recordings import RobotPlayback
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.recording import Record, RobotHeader
from trex_gui.devices.aracna.session.messages import Moved, Moving, Passed, SpeedsHeld
from trex_gui.devices.aracna.views.playback import RobotPlaybackWindow
from trex_gui.ui.plotting.plot import TracePlot

GOALS, REACHED = (200,) * MOTORS, (201, 199, *(200,) * 5, -1)
SAMPLE_SESSION: list[Record] = [
    SpeedsHeld(T0 + 1, (100,) * MOTORS, (100, 0, *(100,) * 5, -1)),
    Marker(T0 + 1, "fault", "Motor 7 does not answer (−1)"),
    Moving(T0 + 10, GOALS, (None,) * MOTORS, 2.0),
    Passed(T0 + 11, (201, 199, 200)),
    Moved(T0 + 12, GOALS, REACHED, 2.0),
    Marker(T0 + 40, "note", "Not moved: No robot is connected that could move."),
    Marker(T0 + 60, "stop", "Stopped: nothing more is sent."),
]


class RecordingWindowDriver(WidgetDriver):
    """A window that shows the recording in a file."""

    def __init__(self, path: Path, qtbot: QtBot) -> None:
        self.window = RobotPlaybackWindow(loading(RobotPlayback(open_recording(path))), Robot())
        super().__init__(self.window, qtbot)
        self.playback = self.window.playback
        qtbot.addWidget(self.window)

    @property
    def plot(self) -> TracePlot:
        return self.find_only(TracePlot)

    def is_playing(self) -> bool:
        return self.playback.playing

    def show(self) -> None:
        self.window.show()

    def wait_until_loaded(self) -> None:
        self.wait(lambda: self.playback.is_loaded)

    def close(self) -> None:
        self.window.close()


def show_recording(
    path: Path, qtbot: QtBot, records: list[Record], header: RobotHeader = HEADER
) -> RecordingWindowDriver:
    """Write a recording and show it in a window."""
    write(path, records, header)
    driver = RecordingWindowDriver(path, qtbot)
    driver.show()
    driver.wait_until_loaded()
    return driver
