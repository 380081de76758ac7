"""The steps of a power cycle, each ticked when it was seen to happen."""

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QWidget

from trex_gui.devices.trex.model.power_cycle import PowerCycle, PowerCycleStage
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.builders import button
from trex_gui.ui.widgets.labels import Note

_DONE = {
    PowerCycleStage.NONE: 0,
    PowerCycleStage.OFF_WANTED: 0,
    PowerCycleStage.ON_WANTED: 1,
    PowerCycleStage.LOST: 0,
    PowerCycleStage.UNSURE: 0,
    PowerCycleStage.BACK: 3,
}
"""How many of the three steps are behind us."""


class PowerCyclePanel(QFrame):
    """Says what to do now, what was noticed, and what is active afterwards."""

    def __init__(self, cycle: PowerCycle, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("powerCyclePanel")
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self._cycle = cycle
        self._waiting: tuple[str, ...] = ()

        self._title = Note(1, self)
        self._title.setObjectName("powerCycleTitle")
        self._steps = tuple(QLabel(self) for _ in range(3))
        self._signs = tuple(QLabel(self) for _ in range(3))
        for number, step in enumerate(self._steps, 1):
            step.setObjectName(f"powerCycleStep{number}")
            step.setWordWrap(True)
        self._result = Note(2, self)
        self._result.setObjectName("powerCycleResult")
        self._done = button(self, "powerCycleDone", self.tr("I have switched it off and on"))

        layout = QGridLayout(self)
        layout.setContentsMargins(12, 8, 12, 8)
        layout.setColumnStretch(1, 1)
        layout.addWidget(self._title, 0, 0, 1, 3)
        for row, (sign, step) in enumerate(zip(self._signs, self._steps, strict=True), 1):
            layout.addWidget(sign, row, 0, Qt.AlignmentFlag.AlignTop)
            layout.addWidget(step, row, 1, 1, 2)
        layout.addWidget(self._result, 4, 0, 1, 2)
        layout.addWidget(self._done, 4, 2, Qt.AlignmentFlag.AlignBottom)
        layout.setRowStretch(5, 1)

        self._done.clicked.connect(cycle.confirm)
        cycle.changed.connect(self._on_changed)
        theme().changed.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        stage = self._cycle.stage
        if stage is PowerCycleStage.OFF_WANTED:
            self._waiting = self._cycle.still_waiting
        self._title.show_note(self._title_text(stage))
        self._steps[0].setText(
            self.tr("Switch the board's power off, and leave it off for a second.")
        )
        self._steps[1].setText(self._how_it_comes_back())
        self._steps[2].setText(self.tr("The program reads it again by itself."))
        size = self.fontMetrics().height() + 2
        for number, sign in enumerate(self._signs):
            done = _DONE[stage]
            name = "ok" if number < done else "run" if number == done else ""
            if name and stage is not PowerCycleStage.NONE:
                sign.setPixmap(icon(name).pixmap(size, size))
            else:
                sign.clear()
            sign.setFixedWidth(size + 4)
            font = self._steps[number].font()
            font.setBold(number == done)
            self._steps[number].setFont(font)
        self._show_result(stage)

    def _how_it_comes_back(self) -> str:
        if self._cycle.expected is None:
            return self.tr("Switch it on again.")
        line = self._cycle.expected.line.text()
        return self.tr("Switch it on again. It is looked for at {0} then.").format(line)

    def _title_text(self, stage: PowerCycleStage) -> str:
        names = ", ".join(self._waiting)
        if stage is PowerCycleStage.BACK:
            return self.tr("The power cycle is over.")
        if names:
            text = self.tr("Not active before the board is switched off and on: {0}.")
            return text.format(names)
        return self.tr("The board has to be switched off and on.")

    def _show_result(self, stage: PowerCycleStage) -> None:
        waiting = ", ".join(self._cycle.still_waiting)
        long = self._cycle.takes_long
        text, alarming = "", False
        match stage:
            case PowerCycleStage.OFF_WANTED if long:
                text = self.tr(
                    "Nothing was noticed yet. A short break is not seen: leave the power off "
                    "for a full second."
                )
            case PowerCycleStage.OFF_WANTED:
                text = self.tr("Waiting for the board to fall silent …")
            case PowerCycleStage.ON_WANTED if long:
                alarming = True
                text = self.tr(
                    "The board is still silent. Is its power on, and the cable in? Otherwise "
                    "disconnect and press “Find…”, which looks for it at every setting."
                )
            case PowerCycleStage.ON_WANTED:
                text = self.tr("The board has fallen silent. Waiting for it to answer again …")
            case PowerCycleStage.LOST:
                alarming = True
                text = self.tr(
                    "The line was closed. Switch the board off and on, then connect again; "
                    "“Find…” looks for it at every setting."
                )
            case PowerCycleStage.UNSURE:
                text = self.tr(
                    "Connected again. Whether the power was off meanwhile cannot be seen: say so, "
                    "or switch the board off and on now."
                )
            case PowerCycleStage.BACK if waiting:
                alarming = True
                text = self.tr("The board is back, but still not active: {0}.").format(waiting)
            case PowerCycleStage.BACK:
                text = self.tr("The board is back, and everything that it stores is active.")
        self._result.show_note(text, alarming=alarming)
        self._done.setVisible(
            stage is PowerCycleStage.UNSURE or (stage is PowerCycleStage.OFF_WANTED and long)
        )
