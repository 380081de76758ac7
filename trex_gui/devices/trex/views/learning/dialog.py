"""The wizard that learns channels: beside the window, never in its way."""

from collections.abc import Sequence
from functools import partial

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QCloseEvent, QResizeEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.learning.learning import Learning, LearningStep
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.views.learning.live_pages import (
    ChannelRows,
    RestRow,
    TestPage,
    TravelRow,
)
from trex_gui.devices.trex.views.learning.texts import (
    again_texts,
    head_text,
    is_alarming,
    review_texts,
)
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.placement import resize_with_font
from trex_gui.ui.widgets.scroll_box import ScrollBox
from trex_gui.ui.widgets.step_strip import StepStrip

_PLACES = {LearningStep.NEUTRAL: 1, LearningStep.TRAVEL: 2, LearningStep.REVIEW: 3}
"""Where a step is in the row of steps; others are in place 0, the test in 1."""


class LearnDialog(ReusedDialog):
    """Shows one step at a time; the red button of the window can always be pressed.

    Esc stops the motors, as everywhere, and ends it. Nothing is changed before Use these values.
    Opening it again while it is learning only brings it forward, so that no measurement is lost.
    """

    def __init__(self, learning: Learning, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("learnDialog")
        resize_with_font(self, 920, 600)
        self.learning = learning
        self._shown: tuple[LearningStep, object] | None = None
        self._page: QWidget | None = None
        self._offers_test = False
        self._place = 0

        self._steps = StepStrip(self)
        self._head = ui.named(Note(2, self), "learnHead")
        button = partial(ui.button, self, default=False)
        self._again = button("learnAgainButton", icon="reload", on_click=learning.again)
        self._learn_again = button(
            "learnChannelAgainButton",
            icon="calibrate",
            tip=tr("If a channel does not get a good result, learn its values again."),
            on_click=self._on_learn_again,
        )
        self._back = button("learnBackButton", tr("&Back"), on_click=learning.back)
        self._next = button("learnNextButton", on_click=learning.next)
        self._use = button(
            "learnUseButton",
            tr("&Use these values…"),
            icon="apply",
            on_click=learning.use_values,
        )
        self._test = button(
            "learnTestButton",
            tr("Stop the motors and &test"),
            on_click=lambda: self.test(learning.numbers),
        )
        self._cancel = button("learnCancelButton", on_click=self.close)

        left = self._again, self._learn_again
        right = self._back, self._next, self._use, self._test, self._cancel
        self._body = QVBoxLayout()
        column = self._steps, self._head, (self._body, 1), ui.row(*left, 1, *right)
        ui.column(*column, into=self, spacing=10)

        learning.changed.connect(self._on_changed)
        learning.measured.connect(self._on_measured)
        learning.stored.connect(self._on_stored)

    def learn(self, channels: Sequence[int] = CHANNELS) -> None:
        """Learn these channels unless it is learning already; the motors are stopped first."""
        if not self._is_learning:
            self._offers_test = False
            self.learning.begin(channels)
        self.show_in_front()

    def test(self, channels: Sequence[int] = CHANNELS) -> None:
        """Test the sticks with the stored values; the motors are stopped first."""
        if not self._is_learning:
            self._offers_test = False
            self.learning.begin_test(channels)
        self.show_in_front()

    @property
    def _is_learning(self) -> bool:
        """Whether measurements would be lost; a test is quickly repeated."""
        ended = {LearningStep.ENDED, LearningStep.FAILED}
        return not self.learning.is_test and self.learning.step not in ended

    def reject(self) -> None:
        """Leave everything unchanged on Esc and Cancel."""
        self.learning.cancel()
        super().reject()

    def closeEvent(self, event: QCloseEvent) -> None:
        self.learning.cancel()
        super().closeEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit_head()

    def _fit_head(self) -> None:
        """Make room for all text of the head; in a narrow window the page below shrinks."""
        width = self.contentsRect().width()
        if layout := self.layout():
            margins = layout.contentsMargins()
            width -= margins.left() + margins.right()
        least = 2 * self._head.fontMetrics().lineSpacing()
        self._head.setMinimumHeight(max(least, self._head.heightForWidth(width)))

    # --- Slots --------------------------------------------------------------------------

    @Slot()
    def _on_stored(self) -> None:
        if not self.learning.motors_armed:
            self.test(self.learning.numbers)
            return
        # The user is driving: the motors run on, and the keys stay with the window.
        self._offers_test = True
        self._show_page(None)
        self._describe()
        self.setAttribute(Qt.WidgetAttribute.WA_ShowWithoutActivating)
        self.show()
        self.setAttribute(Qt.WidgetAttribute.WA_ShowWithoutActivating, False)

    @Slot()
    def _on_learn_again(self) -> None:
        tests = self.learning.tests
        if tests is not None and tests.to_learn_again:
            self.learning.begin(tests.to_learn_again)

    @Slot()
    def _on_measured(self) -> None:
        live = {LearningStep.TEST, LearningStep.TRAVEL}
        if self.learning.sampling or self.learning.step in live:
            self._describe()

    @Slot()
    def _on_changed(self) -> None:
        step = self.learning.step
        if step is LearningStep.ENDED:
            self._show_page(None)
            self.hide()
            return
        # New channels or tests need a new page, too.
        subject = self.learning.tests if step is LearningStep.TEST else self.learning.channels
        if self._shown != (step, subject):
            self._show_page(self._make_page(step))
            self._shown = (step, subject)
            self.setFocus()
        self._describe()

    # --- The page -----------------------------------------------------------------------

    def _make_page(self, step: LearningStep) -> QWidget:
        learning = self.learning
        page: QWidget
        match step:
            case LearningStep.NEUTRAL:
                page = ChannelRows(learning, "learnRestPage", RestRow)
            case LearningStep.TRAVEL:
                page = ChannelRows(learning, "learnTravelPage", TravelRow)
            case LearningStep.REVIEW:
                # pyqtgraph takes as long to load as Qt: import it only when it is needed.
                from trex_gui.devices.trex.views.learning import review_page  # noqa: PLC0415

                page = review_page.ReviewPage(learning)
            case LearningStep.TEST if learning.tests is not None:
                page = TestPage(learning, learning.tests)
            case _:
                return QWidget(self)
        box = ScrollBox(page, self)
        if isinstance(page, ChannelRows | TestPage):
            box.setMinimumHeight(page.least_seen)
        box.setAccessibleName(tr("Measurements"))
        return box

    def _show_page(self, page: QWidget | None) -> None:
        if self._page is not None:
            self._body.removeWidget(self._page)
            self._page.hide()
            self._page.setParent(None)
            self._page.deleteLater()
        self._page = page
        self._shown = None
        if page is not None:
            self._body.addWidget(page)
            ui.tab_order(self._again, page, self._again)

    # --- Texts and buttons --------------------------------------------------------------

    def _describe(self) -> None:
        learning, step = self.learning, self.learning.step
        waits_for_primary = self.focusWidget() in {self, self._next, self._use}
        testing = learning.is_test or self._offers_test
        steps = [
            tr("Stop the motors"),
            tr("Hands off the sticks"),
            tr("All sticks to all ends"),
            tr("Review"),
        ]
        if testing:
            steps[1:] = [tr("Test every stick")]
        self.setWindowTitle(tr("Test the sticks") if testing else tr("Learn channels"))
        if step is not LearningStep.FAILED:
            self._place = _PLACES.get(step, int(step is LearningStep.TEST))
        self._steps.show_steps(steps, min(self._place, len(steps) - 1))
        text = head_text(learning, offers_test=self._offers_test)
        self._head.show_note(text, alarming=is_alarming(learning))
        self._fit_head()
        self._describe_again()
        doubtful, reviewing = step is LearningStep.DOUBT, step is LearningStep.REVIEW
        moving = step in {LearningStep.NEUTRAL, LearningStep.TRAVEL}
        self._back.setVisible(step in {LearningStep.TRAVEL, LearningStep.REVIEW})
        self._next.setVisible(moving or doubtful)
        self._next.setEnabled(learning.can_go_on)
        self._next.setDefault(moving)
        self._next.setText(tr("The motors are stopped: co&ntinue") if doubtful else tr("&Next"))
        self._use.setVisible(reviewing)
        self._use.setEnabled(learning.can_use_values)
        self._use.setToolTip(ui.plain(review_texts(learning)[1]))
        self._use.setDefault(reviewing)
        self._test.setVisible(self._offers_test)
        ends = step in {LearningStep.TEST, LearningStep.FAILED, LearningStep.ENDED}
        self._cancel.setText(tr("Close") if ends else tr("Cancel"))
        self._cancel.setDefault(step is LearningStep.TEST or self._offers_test)
        if waits_for_primary:  # while it is disabled Enter must not press Cancel
            buttons = (self._next, self._use, self._cancel)
            usable = (each for each in buttons if each.isDefault() and each.isEnabled())
            next(usable, self).setFocus()

    def _describe_again(self) -> None:
        learning, step = self.learning, self.learning.step
        text, tip = again_texts(step)
        self._again.setText(text)
        self._again.setToolTip(ui.plain(tip))
        never = step in {LearningStep.STOPPING, LearningStep.ENDED}
        waits = step is LearningStep.NEUTRAL and not (learning.has_sampled or learning.sampling)
        self._again.setVisible(not never and not waits)
        self._again.setEnabled(not learning.sampling)
        numbers = () if learning.tests is None else learning.tests.to_learn_again
        text = tr("&Learn channel(s) {0} again", "", len(numbers))
        self._learn_again.setText(text.format(", ".join(map(str, numbers))))
        self._learn_again.setVisible(step is LearningStep.TEST and bool(numbers))
