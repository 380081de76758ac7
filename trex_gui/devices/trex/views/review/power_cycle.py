"""The steps of a power cycle: a panel of the review, and a dialog of its own."""

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QFrame, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.power_cycle import PowerCycle, PowerCycleStage
from trex_gui.devices.trex.views.motor_controls import ActionBar
from trex_gui.ui.theme.theme import set_look
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.builders import button, column, grid, label, named, row, set_bold
from trex_gui.ui.widgets.labels import Note, Sign
from trex_gui.ui.widgets.placement import resize_with_font

_STEPS_DONE = {PowerCycleStage.ON_WANTED: 1, PowerCycleStage.BACK: 3}


class PowerCyclePanel(QFrame):
    """Shows the next step, what was detected, and what is active afterwards."""

    def __init__(self, cycle: PowerCycle, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("powerCyclePanel")
        set_look(self, "card")
        self._cycle = cycle
        self._waiting: tuple[str, ...] = ()

        self._title = named(Note(1, self), "powerCycleTitle")
        self._result = named(Note(2, self), "powerCycleResult")
        text = tr("I have &switched it off and on")
        self._confirm = button(self, "powerCycleDone", text, on_click=cycle.confirm)

        layout = grid(self, margins=(12, 8, 12, 8), stretch=[(1, 1)])
        layout.addWidget(self._title, 0, 0, 1, 3)
        texts = (
            tr("Switch the board off for at least one second."),
            "",
            tr("The program reads the settings again."),
        )
        self._steps = [
            (Sign(self), label(self, f"powerCycleStep{number}", text, wrap=True))
            for number, text in enumerate(texts, 1)
        ]
        for number, (sign, step) in enumerate(self._steps, 1):
            layout.addWidget(sign, number, 0, Qt.AlignmentFlag.AlignTop)
            layout.addWidget(step, number, 1, 1, 2)
        layout.addWidget(self._result, 4, 0, 1, 2)
        layout.addWidget(self._confirm, 4, 2, Qt.AlignmentFlag.AlignBottom)
        layout.setRowStretch(5, 1)

        cycle.changed.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        stage = self._cycle.stage
        if stage is PowerCycleStage.OFF_WANTED:
            self._waiting = self._cycle.still_waiting
        self._title.show_note(self._title_text())
        done = _STEPS_DONE.get(stage, 0)
        for number, (sign, step) in enumerate(self._steps):
            name = "ok" if number < done else "run" if number == done else ""
            sign.show_sign("" if stage is PowerCycleStage.NONE else name)
            set_bold(step, number == done)
        expected, text = self._cycle.expected, tr("Switch it on again.")
        if expected is not None:
            text = tr("Switch it on again. The program then reconnects at {0}.")
            text = text.format(expected.line.text())
        self._steps[1][1].setText(text)
        text, alarming = self._result_text()
        self._result.show_note(text, alarming=alarming)
        is_long = stage is PowerCycleStage.OFF_WANTED and self._cycle.takes_long
        self._confirm.setVisible(stage is PowerCycleStage.UNSURE or is_long)

    def _title_text(self) -> str:
        if self._cycle.stage is PowerCycleStage.BACK:
            return tr("Power cycle completed.")
        if self._waiting:
            text = tr("Not active until the board is switched off and on: {0}.")
            return text.format(", ".join(self._waiting))
        return tr("The board has to be switched off and on.")

    def _result_text(self) -> tuple[str, bool]:
        """Return what was detected, and whether it is alarming."""
        waiting = ", ".join(self._cycle.still_waiting)
        match self._cycle.stage, self._cycle.takes_long:
            case PowerCycleStage.OFF_WANTED, True:
                return tr(
                    "The board still responds. A short interruption is not detected: leave the "
                    "power off for a full second."
                ), False
            case PowerCycleStage.OFF_WANTED, False:
                return tr("Waiting for the board to stop responding …"), False
            case PowerCycleStage.ON_WANTED, True:
                return tr(
                    "The board is still not responding. Check its power and the cable. If both "
                    "are fine, disconnect and press “Find…”, which tries every setting."
                ), True
            case PowerCycleStage.ON_WANTED, False:
                text = tr("The board has stopped responding. Waiting for it to respond again …")
                return text, False
            case PowerCycleStage.LOST, _:
                return tr(
                    "The line was closed. Switch the board off and on, then connect again; "
                    "“Find…” tries every setting."
                ), True
            case PowerCycleStage.UNSURE, _:
                return tr(
                    "Connected again. The program cannot detect whether the board was switched "
                    "off meanwhile: confirm it, or switch the board off and on now."
                ), False
            case PowerCycleStage.BACK, _ if waiting:
                text = tr("The board is back, but these settings are still not active: {0}.")
                return text.format(waiting), True
            case PowerCycleStage.BACK, _:
                return tr("The board is back, and all stored settings are active."), False
        return "", False


class PowerCycleDialog(ReusedDialog):
    """Not modal, with a stop button of its own."""

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("powerCycleDialog")
        self.setWindowTitle(tr("Switch the board off and on"))
        resize_with_font(self, 560, 240)
        self._device = device
        self._cycle = PowerCycle(device, self)

        panel = PowerCyclePanel(self._cycle, self)
        bar = ActionBar(device, "powerCycleStopButton", self)
        text = tr("Close")
        close = button(self, "powerCycleCloseButton", text, default=True, on_click=self.close)
        row(bar.stop, 1, close, into=bar)
        column((panel, 1), bar, into=self)
        self.finished.connect(self._cycle.end)

    def guide(self) -> None:
        """Begin a power cycle and show its steps, if a board is connected."""
        if self._device.is_connected:  # not while the window closes
            self._cycle.begin()
            self.show_in_front()
