"""Steps of the set-up assistant."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QPushButton, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.learning import Learning, LearningStep
from trex_gui.devices.trex.model.setup.robot_setup import RobotSetup, SetupStep
from trex_gui.devices.trex.views.learning.flow import LearnFlow
from trex_gui.devices.trex.views.motor_controls import apply_text
from trex_gui.devices.trex.views.setup.direction_pages import SticksPage, WiringPage
from trex_gui.devices.trex.views.setup.pages import (
    DriverPage,
    JumperPage,
    LimitsPage,
    SummaryPage,
    TimeoutPage,
)
from trex_gui.devices.trex.views.steps import Flow, FlowState, Page


class SetupFlow(Flow):
    apply_requested = Signal()

    name = "setup"
    size = 1040, 660

    def __init__(self, device: Device, learning: Learning) -> None:
        super().__init__()
        self._device = device
        self._is_open = False
        self.setup = setup = RobotSetup(device, learning, self)
        self._learn = LearnFlow(learning, self, name="setupLearn")
        self._titles = {
            SetupStep.DRIVER: tr("Driver"),
            SetupStep.JUMPERS: tr("&Jumpers"),
            SetupStep.STICKS: tr("&Sticks"),
            SetupStep.MOTORS: tr("M&otors"),
            SetupStep.LIMITS: tr("&Limits"),
            SetupStep.TIMEOUT: tr("T&imeout"),
            SetupStep.REVIEW: tr("Write"),
        }
        self._factories: dict[SetupStep, Callable[[], Page]] = {
            SetupStep.DRIVER: partial(DriverPage, setup),
            SetupStep.JUMPERS: partial(JumperPage, device, setup),
            SetupStep.STICKS: partial(SticksPage, device, setup, learning),
            SetupStep.MOTORS: partial(WiringPage, device, setup),
            SetupStep.LIMITS: partial(LimitsPage, device, setup),
            SetupStep.TIMEOUT: partial(TimeoutPage, device, setup),
            SetupStep.REVIEW: partial(SummaryPage, device, setup, self._titles),
        }
        self._pages: dict[SetupStep, Page] = {}  # created when first shown
        for changed in (setup.changed, self._learn.changed, self._learn.closed):
            changed.connect(self.changed)

    @property
    def _is_learning(self) -> bool:
        learning = self._learn.learning
        is_learning = learning.step is not LearningStep.ENDED and not learning.is_test
        return is_learning and self.setup.step is SetupStep.STICKS

    def show_in_front(self) -> None:
        if not self._is_open:
            self._is_open = True
            self.setup.go_to(SetupStep.DRIVER)  # earlier answers remain
        super().show_in_front()

    def add_buttons(self, parent: QWidget) -> Sequence[QPushButton]:
        return self._learn.add_buttons(parent)

    def back(self) -> None:
        if self._is_learning and self._learn.learning.step not in {
            LearningStep.TRAVEL,
            LearningStep.REVIEW,
        }:
            self._learn.learning.cancel()
        else:
            (self._learn if self._is_learning else self.setup).back()

    def skip(self) -> None:
        self._close_learning()
        self.setup.skip()

    def next(self) -> None:
        if self.setup.step is SetupStep.REVIEW:
            self.apply_requested.emit()
        else:
            (self._learn if self._is_learning else self.setup).next()

    def on_hidden(self, *, closed: bool) -> None:
        if closed:
            self._is_open = False
            self._close_learning()
        self.setup.stop()

    def _close_learning(self) -> None:
        if self._is_learning:
            self._learn.learning.cancel()

    def state(self) -> FlowState:
        setup, step, title = self.setup, self.setup.step, tr("Set up my robot")
        names = {key: self._titles[key].replace("&", "") for key in setup.steps}
        titles, current = list(names.values()), setup.steps.index(step)
        undone = [names[key] for key in setup.open_steps]
        if self._is_learning:
            state = self._learn.state()
            state = replace(state, title=title, titles=titles, current=current, undone=undone)
            return replace(state, may_go_back=True, may_skip=True)
        self._learn.show_buttons(hidden=True)
        if step not in self._pages:
            self._pages[step] = self._factories[step]()
        is_last = step is SetupStep.REVIEW
        pending = self._device.draft.pending
        can_apply = self._device.writer.can_apply and pending > 0
        return FlowState(
            title,
            titles,
            current,
            self._pages[step],
            note=setup.blocker or self._edits_text(),
            is_alarming=bool(setup.blocker),
            undone=undone,
            next=apply_text(pending) if is_last else tr("&Next"),
            may_go_on=can_apply if is_last else not setup.blocker,
            may_go_back=step is not SetupStep.DRIVER,
            may_skip=step is not SetupStep.DRIVER and not is_last,
            is_close_primary=is_last and not pending,
        )

    def _edits_text(self) -> str:
        edits = self.setup.edits
        if not edits:
            return ""
        return tr(
            "“Next” adds %n change(s). Nothing is written until you apply the changes.",
            "",
            len(edits),
        )
