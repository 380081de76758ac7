"""The wizard that learns channels: beside the window, never in its way."""

from collections.abc import Callable, Sequence
from functools import partial

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QCloseEvent, QResizeEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.model.learning.learning import Learning, LearningStep
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.views.learning.live_pages import (
    ChannelRows,
    RestRow,
    TestPage,
    TravelRow,
)
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.placement import resize_with_font
from trex_gui.ui.widgets.scroll_box import ScrollBox
from trex_gui.ui.widgets.step_strip import StepStrip

# Where a step is in the row of steps; others are in place 0, the test in 1.
_PLACES = {LearningStep.NEUTRAL: 1, LearningStep.TRAVEL: 2, LearningStep.REVIEW: 3}


class LearnDialog(ReusedDialog):
    """Opening it again while it is learning only brings it forward: no measurement is lost."""

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
        tip = tr("If a channel does not get a good result, learn its values again.")
        self._learn_again = button("learnChannelAgainButton", icon="calibrate", tip=tip)
        self._back = button("learnBackButton", tr("&Back"), on_click=learning.back)
        self._next = button("learnNextButton", on_click=learning.next)
        self._use = button("learnUseButton", tr("&Use these values…"), icon="apply")
        self._test = button("learnTestButton", tr("Stop the motors and &test"))
        self._cancel = button("learnCancelButton", on_click=self.close)

        left = self._again, self._learn_again
        right = self._back, self._next, self._use, self._test, self._cancel
        self._body, buttons = QVBoxLayout(), ui.row(*left, 1, *right)
        ui.column(self._steps, self._head, (self._body, 1), buttons, into=self, spacing=10)

        self._learn_again.clicked.connect(self._on_learn_again)
        self._use.clicked.connect(learning.use_values)
        self._test.clicked.connect(lambda: self.test(learning.numbers))
        learning.changed.connect(self._on_changed)
        learning.measured.connect(self._on_measured)
        learning.stored.connect(self._on_stored)

    def learn(self, channels: Sequence[int] = CHANNELS) -> None:
        """Learn these channels unless it is learning already; the motors are stopped first."""
        self._open(partial(self.learning.begin, channels))

    def test(self, channels: Sequence[int] = CHANNELS) -> None:
        """Test the sticks with the stored values; the motors are stopped first."""
        self._open(partial(self.learning.begin_test, channels))

    def _open(self, begin: Callable[[], object]) -> None:
        if not self._is_learning:
            self._offers_test = False
            begin()
        self.show_in_front()

    @property
    def _is_learning(self) -> bool:
        """Whether measurements would be lost; a test is quickly repeated."""
        ended = {LearningStep.ENDED, LearningStep.FAILED}
        return not self.learning.is_test and self.learning.step not in ended

    def reject(self) -> None:
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

    def _describe(self) -> None:
        learning, step = self.learning, self.learning.step
        waits_for_primary = self.focusWidget() in {self, self._next, self._use}
        testing = learning.is_test or self._offers_test
        learn = [tr("Hands off the sticks"), tr("All sticks to all ends"), tr("Review")]
        test = [tr("Test every stick")]
        steps = [tr("Stop the motors"), *(test if testing else learn)]
        self.setWindowTitle(tr("Test the sticks") if testing else tr("Learn channels"))
        if step is not LearningStep.FAILED:
            self._place = _PLACES.get(step, int(step is LearningStep.TEST))
        self._steps.show_steps(steps, min(self._place, len(steps) - 1))
        text = _head_text(learning, offers_test=self._offers_test)
        self._head.show_note(text, alarming=_is_alarming(learning))
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
        self._use.setToolTip(ui.plain(_review_texts(learning)[1]))
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
        text, tip = _again_texts(step)
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


def _again_texts(step: LearningStep) -> tuple[str, str]:
    """Return the text and the tip of the button that repeats a step."""
    match step:
        case LearningStep.NEUTRAL:
            return (
                tr("Sample &again"),
                tr("Measure the rest positions of all channels once more."),
            )
        case LearningStep.TRAVEL:
            return (
                tr("&Forget these ends"),
                tr("Forget the ends reached so far. The rest positions are kept."),
            )
        case LearningStep.REVIEW:
            return (
                tr("&Start over"),
                tr("Forget everything measured and go back to the rest positions."),
            )
        case LearningStep.TEST:
            return (
                tr("Test &again"),
                tr("Forget what was tested so far and begin the test again."),
            )
    return tr("Try &again"), tr("Stop the motors again and begin again.")


def _is_alarming(learning: Learning) -> bool:
    if learning.inputs.stalled:
        return True
    match learning.step:
        case LearningStep.NEUTRAL if learning.has_sampled:
            return not all(channel.is_at_rest for channel in learning.channels)
        case LearningStep.TEST if learning.tests is not None:
            return learning.tests.channels_passed and not learning.tests.passed
    return learning.step in {LearningStep.FAILED, LearningStep.DOUBT}


def _head_text(learning: Learning, *, offers_test: bool) -> str:
    if offers_test:
        return tr(
            "The new values are in the board. The test does not start by itself, because the "
            "motors may be running: it has to stop them first."
        )
    if learning.inputs.stalled:
        return tr("The board sends no measurements: the line is busy or disturbed. Waiting …")
    match learning.step:
        case LearningStep.STOPPING:
            return tr(
                "Stopping the motors. The next step comes when the board has confirmed the "
                "stop and no current flows."
            )
        case LearningStep.NEUTRAL:
            return _rest_text(learning)
        case LearningStep.TRAVEL:
            return _travel_text(learning)
        case LearningStep.REVIEW:
            return _review_texts(learning)[0]
        case LearningStep.TEST:
            return f"{learning.news} {_test_text(learning)}".strip()
    return learning.trouble


def _rest_text(learning: Learning) -> str:
    if learning.sampling:
        return tr("Hands off. Sampling … {0:.1f} s").format(Number(learning.seconds_left))
    if not learning.has_sampled:
        return tr(
            "The motors are stopped. Release every stick and set every switch to off. Then "
            "click Next to measure the rest positions."
        )
    bad = [str(channel.number) for channel in learning.channels if not channel.is_at_rest]
    if len(bad) == len(learning.channels):
        return tr("No channel is at rest. Correct the problems below, then click “Sample again”.")
    return tr(
        "Not every channel is at rest. Correct the problems below and click “Sample again”, or "
        "click Next to continue without channel {0}."
    ).format(", ".join(bad))


def _travel_text(learning: Learning) -> str:
    text = tr(
        "Push every stick forward or right first, all the way; then the other way. "
        "Move switches to all positions."
    )
    slow = [c.travel for c in learning.channels if c.travel and c.travel.is_slow]
    if not slow:
        return f"{text} " + tr("Hold each end for a moment, then click Next.")
    reason = tr(
        "Hold each end until its check mark appears, for at least {0:.1f} s: this line "
        "({1} baud) carries only {2:.1f} measurements per second. Then click Next."
    )
    hold = max(travel.hold_seconds for travel in slow)
    rate = 1 / max(travel.interval for travel in slow)
    return f"{text} {reason.format(Number(hold), learning.baud, Number(rate))}"


def _review_texts(learning: Learning) -> tuple[str, str]:
    """Return the text of the head and the tip of the button that uses the values."""
    rejected = ", ".join(str(c.number) for c in learning.included if not c.can_be_used)
    if not any(channel.choice is not None for channel in learning.channels):
        return (
            tr("Nothing was learned. The reason is below. Go back, or start over."),
            tr("Nothing was learned, so there are no values to use."),
        )
    if not learning.included:
        return (
            tr("No channel is selected. Select each channel whose new values to use."),
            tr("No channel is selected."),
        )
    if rejected:
        return (
            tr(
                "The board would reject the values of channel {0}: change them, or clear its "
                "check box."
            ).format(rejected),
            tr("The board would reject the values of channel {0}.").format(rejected),
        )
    return (
        tr(
            "Check the new values. You can change them; clear the check box of a channel to "
            "keep its old values. "
            "Nothing is written yet: you confirm all changes in the next window."
        ),
        learning.preconditions.blocker
        or tr("Use the values of all selected channels. Nothing is written yet."),
    )


def _test_text(learning: Learning) -> str:
    tests = learning.tests
    if tests is not None and tests.heard:
        if tests.passed:
            return tr("Everything is as it should be.")
        if tests.all_ignored:
            return tr(
                "There is nothing to test: the board ignores this input, so it holds it at "
                "neutral. See the setting Ignored Channels."
            )
        if tests.channels_passed:
            text = tr(
                "The tested channels are good. But in {0} mode the motors would not start. {1}"
            )
            return text.format(tests.mode, tests.safe_start_reasons)
    return tr(
        "Push every stick to all its ends, then release it. Move every switch to all its "
        "positions. The motors stay off: in serial mode the sticks do not drive them."
    )
