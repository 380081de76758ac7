"""The assistant that sets up a robot, beside the window."""

from functools import partial

from PySide6.QtCore import Signal, Slot
from PySide6.QtGui import QHideEvent
from PySide6.QtWidgets import QStackedWidget, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.model.setup.robot_setup import RobotSetup, SetupStep
from trex_gui.devices.trex.views.motor_controls import ActionBar
from trex_gui.devices.trex.views.setup.direction_pages import SticksPage, WiringPage
from trex_gui.devices.trex.views.setup.pages import (
    DriverPage,
    JumperPage,
    LimitsPage,
    SummaryPage,
    TimeoutPage,
)
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import ReusedDialog, keep_room, only_when_visible
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.placement import resize_with_font
from trex_gui.ui.widgets.scroll_box import ScrollBox
from trex_gui.ui.widgets.step_strip import StepStrip

_Page = DriverPage | JumperPage | SticksPage | WiringPage | LimitsPage | TimeoutPage | SummaryPage

_MOST_NAMED = 2  # changes that are listed; of more the number is given


class SetupDialog(ReusedDialog):
    """Not modal, with a stop button of its own; leaving it stops the motors."""

    stays_on_stop = True  # no answer is lost

    learn_requested = Signal()
    apply_requested = Signal()

    def __init__(self, device: Device, learning: Learning, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("setupDialog")
        self.setWindowTitle(tr("Set up my robot"))
        resize_with_font(self, 900, 540)
        self._device = device
        self.setup = setup = RobotSetup(device, learning, self)

        self._strip = StepStrip(self)
        self._titles = {
            SetupStep.DRIVER: tr("&Who drives"),
            SetupStep.JUMPERS: tr("&Jumpers"),
            SetupStep.STICKS: tr("&Sticks"),
            SetupStep.MOTORS: tr("Which &motor is which"),
            SetupStep.LIMITS: tr("&Ramps and limits"),
            SetupStep.TIMEOUT: tr("Serial &timeout"),
            SetupStep.REVIEW: tr("Review"),
        }
        self._learning = learning
        self._pages: dict[SetupStep, tuple[_Page, ScrollBox]] = {}  # made when first shown
        self._stack = QStackedWidget(self)
        self._edits = ui.named(Note(2, self), "setupEdits")
        bar = ActionBar(device, "setupStopButton", self)
        self._stop = bar.stop
        button = partial(ui.button, self, default=False)
        skip_tip = tr("Go on without the changes of this step")
        close_tip = tr("Close the assistant; its changes stay until you apply or discard them")
        self._back = button("setupBackButton", tr("&Back"), on_click=setup.back)
        self._skip = button("setupSkipButton", tr("S&kip"), tip=skip_tip, on_click=setup.skip)
        self._next = button("setupNextButton", tr("&Next"), default=True, on_click=setup.next)
        close = button("setupCloseButton", tr("&Close"), tip=close_tip, on_click=self.close)
        for each in (self._skip, self._next):  # a second click must not hit another button
            keep_room(each)
        ui.row(bar.stop, 1, self._back, self._skip, self._next, close, into=bar)
        ui.column(self._strip, (self._stack, 1), self._edits, bar, into=self, spacing=10)

        setup.changed.connect(self._on_changed)
        device.link_changed.connect(self._on_changed)

    def open_setup(self) -> None:
        if not self.isVisible():
            self.setup.begin()
        self.show_in_front()
        self._on_changed()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self.setup.leave()

    def _add_page(self, step: SetupStep) -> None:
        device, setup = self._device, self.setup
        page: _Page
        match step:
            case SetupStep.DRIVER:
                page = DriverPage(setup, self)
            case SetupStep.JUMPERS:
                page = JumperPage(device, setup, self)
            case SetupStep.STICKS:
                page = SticksPage(device, setup, self._learning, self)
                page.learn_requested.connect(self.learn_requested)
            case SetupStep.MOTORS:
                page = WiringPage(device, setup, self)
            case SetupStep.LIMITS:
                page = LimitsPage(device, setup, self)
            case SetupStep.TIMEOUT:
                page = TimeoutPage(device, setup, self)
            case SetupStep.REVIEW:
                page = SummaryPage(device, setup, self._titles, self)
                page.apply_requested.connect(self.apply_requested)
        page.setObjectName(page.objectName() or f"setup{step.name.title()}Page")
        area = ScrollBox(page, self)
        self._pages[step] = page, area
        self._stack.addWidget(area)
        ui.tab_order(self._stop, page, self._stop)

    @Slot()
    @only_when_visible
    def _on_changed(self) -> None:
        setup = self.setup
        step, steps = setup.step, setup.steps
        titles = {each: self._titles[each].replace("&", "") for each in steps}
        self._strip.show_steps(
            list(titles.values()), steps.index(step), [titles[each] for each in setup.open_steps]
        )
        if step not in self._pages:
            self._add_page(step)
        page, area = self._pages[step]
        page.refresh()
        self._stack.setCurrentWidget(area)
        is_last = step is SetupStep.REVIEW
        had_focus = self.focusWidget() in {self._skip, self._next}
        self._back.setEnabled(step is not SetupStep.DRIVER)
        self._skip.setVisible(step is not SetupStep.DRIVER and not is_last)
        if had_focus and isinstance(page, SummaryPage):  # Qt would move it to Close
            page.focus_apply()
        elif had_focus and setup.blocker:
            self._skip.setFocus()
        self._next.setVisible(not is_last)
        self._next.setEnabled(not setup.blocker)
        text = setup.blocker or self._edits_text()
        self._edits.show_note(text, alarming=bool(setup.blocker))

    def _edits_text(self) -> str:
        parameters, edits = self._device.parameters, self.setup.edits
        if not edits:
            return ""
        if len(edits) > _MOST_NAMED:
            return tr(
                "Next adds %n change(s). Nothing is written before you apply them.", "", len(edits)
            )
        rows = []
        for key, wire in edits.items():
            spec, before = parameters.values.specs[key], parameters.values.value_of(key)
            old = "" if before is None else spec.text(before)
            change = f"{old} → {spec.text(wire)}"
            rows.append(tr("{0}: {1}").format(spec.name, change))
        text = tr("Next changes {0}. Nothing is written before you apply it.")
        return text.format("; ".join(rows))
