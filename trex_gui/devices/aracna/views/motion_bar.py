"""Stop button, and the row below the pages that shows the robot's activity."""

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.model.texts import activity_text, ending_text
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import new_timer
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import RedButton
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.messages import ActionBar

_REFRESH_MS = 100


class StopSequenceButton(RedButton):
    """Button that ends the sequence, like Esc. Also used in windows that may cover the pages."""

    def __init__(self, robot: Robot, name: str, parent: QWidget | None = None) -> None:
        super().__init__(name, title_of(tr("&Stop sequence")), robot.halt, parent)
        self.setToolTip(
            tr(
                "End the sequence and send nothing more. A running motion continues to its "
                "goal. (Esc, anywhere)"
            )
        )
        self._robot = robot
        robot.link_changed.connect(self._on_link_changed)
        self._on_link_changed()

    @Slot()
    def _on_link_changed(self) -> None:
        unavailable = {ConnectionState.DISCONNECTED, ConnectionState.DISCONNECTING}
        self.setEnabled(self._robot.link not in unavailable)


class MotionBar(ActionBar):
    """Row with the stop button. The button does not end a running motion."""

    def __init__(self, robot: Robot, recording: QWidget, parent: QWidget) -> None:
        super().__init__(StopSequenceButton(robot, "aracnaStopButton"), parent)
        self._robot = robot
        self._timer = new_timer(self, _REFRESH_MS, self._update)

        ui.set_large(self.stop)
        self._end = ui.button(
            self,
            "aracnaEndButton",
            tr("End afte&r this step"),
            tip=tr("Let the step finish, then blend out"),
            on_click=robot.end_play,
        )
        self._end.setMinimumHeight(self.stop.minimumHeight())
        self._activity = ui.named(Note(1, self), "aracnaMotionLabel")
        hint = tr(
            "This link has no stop command: a running motion ends by itself or when the "
            "servo power is cut."
        )
        hint_label = ui.label(self, "aracnaNoStopLabel", hint, wrap=True)
        texts = ui.column(self._activity, hint_label, spacing=2)
        self.fill((texts, 1), recording, self._end)

        robot.changed.connect(self._update)
        self._update()

    @Slot()
    def _update(self) -> None:
        robot = self._robot
        is_connected = robot.link is ConnectionState.CONNECTED
        self._end.setEnabled(robot.state.play is not None and is_connected)
        remaining = robot.remaining()
        text, alarming = self._activity_text(remaining)
        self._activity.show_note(text, alarming=alarming)
        is_counting = robot.state.moving is not None or remaining > 0
        if is_counting != self._timer.isActive():
            self._timer.start() if is_counting else self._timer.stop()

    def _activity_text(self, remaining: float) -> tuple[str, bool]:
        if self._robot.link not in {ConnectionState.CONNECTED, ConnectionState.NOT_RESPONDING}:
            text = f"{tr('No robot is connected.')} {ending_text(remaining)}"
            return text.rstrip(), remaining > 0
        return activity_text(self._robot.state, remaining)
