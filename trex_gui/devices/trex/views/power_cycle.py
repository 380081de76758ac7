"""Steps of a power cycle, in a panel or in a dialog."""

from collections.abc import Sequence

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QFrame, QWidget

from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.power_cycle import PowerCycle
from trex_gui.devices.trex.model.power_cycle import PowerCycleStage as Stage
from trex_gui.devices.trex.views.steps import Flow, FlowState, Page
from trex_gui.ui.theme.theme import set_look
from trex_gui.ui.widgets.behaviour import reserve_space
from trex_gui.ui.widgets.builders import button, column, named
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.step_strip import StepStrip

_STEPS_DONE = {Stage.AWAITING_ON: 1, Stage.BACK: 3}

_RESULTS = {  # (stage, true if the stage takes a long time) → text
    (Stage.AWAITING_OFF, False): tr_noop(
        "Switch the board off for at least one second. Waiting for the board to stop responding …"
    ),
    (Stage.AWAITING_OFF, True): tr_noop(
        "The board still responds. A short interruption is not detected: leave the power off for "
        "a full second."
    ),
    (Stage.AWAITING_ON, False): tr_noop(
        "Switch the board on again. Waiting for the board to respond …"
    ),
    (Stage.AWAITING_ON, True): tr_noop(
        "The board is still not responding. Check its power and the cable. If both are fine, "
        "disconnect and press “Find…”, which tries every setting."
    ),
    (Stage.LOST, False): tr_noop(
        "The connection was closed. Switch the board off and on, then connect again. If that "
        "fails, press “Find…”, which tries every setting."
    ),
    (Stage.UNSURE, False): tr_noop(
        "Connected again. The program cannot detect whether the board was switched off in "
        "the meantime. Confirm that it was, or switch the board off and on now."
    ),
    (Stage.BACK, False): tr_noop("The board is back, and all stored settings are active."),
}


class PowerCyclePage(Page):
    def __init__(self, cycle: PowerCycle) -> None:
        super().__init__("powerCyclePage")
        self._cycle = cycle
        self._waiting: tuple[str, ...] = ()
        self._title = named(Note(1, self), "powerCycleTitle")
        self._result = named(Note(3, self), "powerCycleResult")
        text = tr("I have &switched the board off and on")
        self._confirm = button(self, "powerCycleDone", text, on_click=cycle.confirm)
        reserve_space(self._confirm)
        confirm = self._confirm, 0, Qt.AlignmentFlag.AlignRight
        column(self._title, self._result, 1, confirm, into=self, margins=0, spacing=8)
        cycle.changed.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        stage = self._cycle.stage
        if stage is Stage.AWAITING_OFF:
            self._waiting = self._cycle.still_waiting
        self._title.show_note(self._title_text())
        text, alarming = self._result_text()
        self._result.show_note(text, alarming=alarming)
        is_long = stage is Stage.AWAITING_OFF and self._cycle.takes_long
        self._confirm.setVisible(stage is Stage.UNSURE or is_long)

    def _title_text(self) -> str:
        if self._cycle.stage is Stage.BACK:
            return tr("Power cycle completed.")
        if self._waiting:
            text = tr("Stored, but not active until the board is switched off and on: {0}.")
            return text.format(", ".join(self._waiting))
        return tr("Switch the board off and on.")

    def _result_text(self) -> tuple[str, bool]:
        """Return the text, and true if the text is alarming."""
        cycle, waiting = self._cycle, ", ".join(self._cycle.still_waiting)
        stage, takes_long = cycle.stage, cycle.takes_long
        if stage is Stage.BACK and waiting:
            text = tr("The board is back, but these settings are still not active: {0}.")
            return text.format(waiting), True
        text = "" if stage is Stage.NONE else tr(_RESULTS[stage, takes_long])
        if stage is Stage.AWAITING_ON and not takes_long and cycle.expected is not None:
            reconnects = tr("The program then reconnects at {0}.")
            text = f"{text} {reconnects.format(cycle.expected.line.text())}"
        return text, stage is Stage.LOST or (stage is Stage.AWAITING_ON and takes_long)


def _steps(cycle: PowerCycle) -> tuple[Sequence[str], int]:
    """Return the step titles and the number of completed steps."""
    titles = tr("Switch off"), tr("Switch on"), tr("Read again")
    return titles, _STEPS_DONE.get(cycle.stage, 0)


class PowerCyclePanel(QFrame):
    def __init__(self, cycle: PowerCycle, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("powerCyclePanel")
        set_look(self, "card")
        strip = StepStrip(self)
        column(strip, (PowerCyclePage(cycle), 1), into=self, margins=(12, 8, 12, 8))
        cycle.changed.connect(lambda: strip.show_steps(*_steps(cycle)))
        strip.show_steps(*_steps(cycle))


class PowerCycleFlow(Flow):
    name = "powerCycle"
    size = 620, 340

    def __init__(self, device: Device) -> None:
        super().__init__()
        self._device = device
        self._cycle = PowerCycle(device, self)
        self._page = PowerCyclePage(self._cycle)
        self._cycle.changed.connect(self.changed)

    def state(self) -> FlowState:
        title = tr("Switch the board off and on")
        return FlowState(title, *_steps(self._cycle), self._page, is_close_primary=True)

    def on_hidden(self, *, closed: bool) -> None:
        if closed:
            self._cycle.end()

    def start(self) -> None:
        """Show the steps of a power cycle if a board is connected."""
        if self._device.is_connected:  # false while the window is closing
            self._cycle.start()
            self.show_in_front()
