"""Steps of channel learning and of the stick test."""

from collections.abc import Callable, Sequence
from functools import partial

from PySide6.QtCore import QObject, Signal, Slot
from PySide6.QtWidgets import QPushButton, QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.model.learning.learning import Learning, LearningStep
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.views.learning.live_pages import (
    ChannelRows,
    RestRow,
    TestPage,
    TravelRow,
)
from trex_gui.devices.trex.views.robot_view import RobotView
from trex_gui.devices.trex.views.steps import Flow, FlowState, Page
from trex_gui.ui.widgets import builders as ui

# Indexes in the step strip. The stick test also has index 1. All other steps have index 0.
_INDICES = {LearningStep.NEUTRAL: 1, LearningStep.TRAVEL: 2, LearningStep.REVIEW: 3}


class LearnFlow(Flow):
    """Steps of channel learning. Learning in progress resumes when the dialog is reopened."""

    size = 1040, 660
    apply_requested = Signal()  # the learned values became edits

    def __init__(
        self, learning: Learning, parent: QObject | None = None, *, name: str = "learn"
    ) -> None:
        """Create the flow. With another `name`, it is part of a task that starts no stick test."""
        super().__init__(parent)
        self.name = name
        self.learning = learning
        self._page: Page | None = None
        self._shown_subject: tuple[LearningStep, object] | None = None
        self._offers_test = False
        self._index = 0
        learning.changed.connect(self._on_changed)
        learning.measured.connect(self._on_measured)
        if name == "learn":
            learning.stored.connect(self._on_stored)

    def learn(self, channels: Sequence[int] = CHANNELS) -> None:
        """Stop the motors and learn channels, unless learning is already in progress."""
        self._open(partial(self.learning.start, channels))

    def test(self, channels: Sequence[int] = CHANNELS) -> None:
        """Stop the motors and test the sticks with the stored values."""
        self._open(partial(self.learning.start_test, channels))

    def _open(self, start: Callable[[], object]) -> None:
        if not self.is_learning:
            self._offers_test = False
            start()
        self.show_in_front()

    @property
    def is_learning(self) -> bool:
        """True while measurements could be lost, false during a test."""
        ended = {LearningStep.ENDED, LearningStep.FAILED}
        return not self.learning.is_test and self.learning.step not in ended

    # --- Buttons ------------------------------------------------------------------------

    def add_buttons(self, parent: QWidget) -> Sequence[QPushButton]:
        name = f"{self.name}AgainButton"
        self._again = ui.button(parent, name, default=False, on_click=self.learning.repeat)
        return (self._again,)

    def back(self) -> None:
        self.learning.back()

    def next(self) -> None:
        if self._offers_test:
            self.test(self.learning.numbers)
        elif self.learning.step is not LearningStep.REVIEW:
            self.learning.next()
        elif self.learning.use_values():
            self.apply_requested.emit()

    def on_hidden(self, *, closed: bool) -> None:
        if closed:
            self.learning.cancel()

    # --- Changes ------------------------------------------------------------------------

    @Slot()
    def _on_stored(self) -> None:
        if not self.learning.motors_armed:
            self.test(self.learning.numbers)
            return
        self._offers_test = True  # the user is driving
        self.opened.emit(False)

    @Slot()
    def _on_measured(self) -> None:
        live = {LearningStep.TEST, LearningStep.TRAVEL}
        if self.learning.sampling or self.learning.step in live:
            self.changed.emit()

    @Slot()
    def _on_changed(self) -> None:
        if self.learning.step is LearningStep.ENDED:
            self._shown_subject = None
            self.closed.emit()
        else:
            self.changed.emit()

    # --- Pages --------------------------------------------------------------------------

    def state(self) -> FlowState:
        learning, step = self.learning, self.learning.step
        title = title_of(tr("&Learn channels…"))
        titles = [tr("Stop the motors"), tr("Hands off"), tr("All ends"), tr("Review")]
        if learning.is_test or self._offers_test:
            title, titles[1:] = title_of(tr("&Test the sticks…")), [tr("Test")]
        if step is not LearningStep.FAILED:
            self._index = _INDICES.get(step, int(step is LearningStep.TEST))
        self.show_buttons()
        text, may_go_on = tr("&Next"), learning.can_go_on
        note, is_alarming = _status_note(learning)
        if self._offers_test:
            text, may_go_on = tr("Stop the motors and &test"), True
            note = tr("The new values are in the board. Stop the motors to test the values.")
        elif step is LearningStep.DOUBT:
            text = tr("The motors are stopped: co&ntinue")
        elif step is LearningStep.REVIEW:
            text, may_go_on = tr("&Use these values…"), learning.can_use_values
        elif step in {LearningStep.TEST, LearningStep.FAILED}:
            text = ""
        final_steps = {LearningStep.TEST, LearningStep.FAILED, LearningStep.ENDED}
        return FlowState(
            title,
            titles,
            min(self._index, len(titles) - 1),
            self._page_of(step),
            note=note,
            is_alarming=is_alarming,
            next=text,
            may_go_on=may_go_on,
            may_go_back=step in {LearningStep.TRAVEL, LearningStep.REVIEW},
            is_close_primary=self._offers_test or step in {LearningStep.TEST, LearningStep.DOUBT},
            close="" if step in final_steps else tr("Cancel"),
        )

    def _page_of(self, step: LearningStep) -> Page:
        # New channels and new tests also require a new page.
        learning = self.learning
        subject = learning.tests if step is LearningStep.TEST else learning.channels
        if self._page is not None and self._shown_subject == (step, subject):
            return self._page
        if self._page is not None:
            for widget in (self._page, self._page.side):
                widget.hide()
                widget.setParent(None)
                widget.deleteLater()
        self._shown_subject = step, subject
        self._page = page = self._create_page(step)
        return page

    def _create_page(self, step: LearningStep) -> Page:
        learning = self.learning
        match step:
            case LearningStep.NEUTRAL:
                return ChannelRows(learning, "learnRestPage", RestRow, learning.channels)
            case LearningStep.TRAVEL:
                return ChannelRows(learning, "learnTravelPage", TravelRow, learning.channels)
            case LearningStep.REVIEW:
                # pyqtgraph takes as long to load as Qt, so it is imported only when needed.
                from trex_gui.devices.trex.views.learning import review_page  # noqa: PLC0415

                return review_page.ReviewPage(learning)
            case LearningStep.TEST if learning.tests is not None:
                return TestPage(learning, learning.tests)
        page = Page("learnStopPage")
        ui.column((RobotView(page), 1), into=page, margins=0)
        return page

    def show_buttons(self, *, hidden: bool = False) -> None:
        learning, step = self.learning, self.learning.step
        texts = {
            LearningStep.NEUTRAL: tr("Sample &again"),
            LearningStep.TRAVEL: tr("Start this step &again"),
            LearningStep.REVIEW: tr("&Start over"),
            LearningStep.TEST: tr("Test &again"),
        }
        self._again.setText(texts.get(step, tr("Try &again")))
        is_unavailable = step in {LearningStep.STOPPING, LearningStep.ENDED}
        is_first = step is LearningStep.NEUTRAL and not (learning.has_sampled or learning.sampling)
        self._again.setVisible(not (hidden or is_unavailable or is_first))
        self._again.setEnabled(not learning.sampling)


def _status_note(learning: Learning) -> tuple[str, bool]:
    """Return the note on the current step, and true if the note is alarming."""
    if learning.inputs.stalled:
        text = tr("The board sends no measurements: the line is busy or disturbed. Waiting …")
        return text, True
    match learning.step:
        case LearningStep.STOPPING:
            return tr("Stopping the motors. The board must confirm the stop."), False
        case LearningStep.NEUTRAL:
            is_bad = not all(channel.is_at_rest for channel in learning.channels)
            return _rest_text(learning), learning.has_sampled and is_bad
        case LearningStep.TRAVEL:
            return _travel_text(learning), False
        case LearningStep.REVIEW:
            return _review_text(learning), False
        case LearningStep.TEST:
            tests = learning.tests
            is_held = tests is not None and tests.channels_passed and not tests.passed
            return f"{learning.test_message} {_test_text(learning)}".strip(), is_held
    return learning.problem, learning.step in {LearningStep.FAILED, LearningStep.DOUBT}


def _rest_text(learning: Learning) -> str:
    if learning.sampling:
        return tr("Hands off. Sampling … {0:.1f} s").format(Number(learning.seconds_left))
    if not learning.has_sampled:
        return tr("Release every stick and set every switch to off. Then click Next.")
    bad = [str(channel.number) for channel in learning.channels if not channel.is_at_rest]
    if len(bad) == len(learning.channels):
        return tr("No channel is at rest. Click “Sample again”.")
    return tr(
        "Not every channel is at rest. Click “Sample again”, or Next to go on without channel {0}."
    ).format(", ".join(bad))


def _travel_text(learning: Learning) -> str:
    text = tr(
        "Push every stick all the way forward or right first, then all the way in the other "
        "direction. Move every switch to all its positions. Hold each end position until it "
        "is ticked, then click Next."
    )
    travels = [channel.travel for channel in learning.channels]
    slow = [travel for travel in travels if travel and travel.is_slow]
    if not slow:
        return text
    reason = tr(
        "This takes at least {0:.1f} s: at {1} baud only {2:.1f} measurements arrive per second."
    )
    hold = max(travel.hold_seconds for travel in slow)
    rate = 1 / max(travel.interval for travel in slow)
    return f"{text} {reason.format(Number(hold), learning.baud, Number(rate))}"


def _review_text(learning: Learning) -> str:
    rejected = ", ".join(
        str(channel.number) for channel in learning.included if not channel.can_be_used
    )
    if not any(channel.choice is not None for channel in learning.channels):
        return tr("Nothing was learned. Go back, or start over.")
    if not learning.included:
        return tr("No channel is selected.")
    if rejected:
        text = tr(
            "The board would reject the values of channel {0}: change them, or clear its check box."
        )
        return text.format(rejected)
    blocker = learning.preconditions.blocker
    return blocker or tr("Check the new values. Nothing has been written yet.")


def _test_text(learning: Learning) -> str:
    tests = learning.tests
    if tests is not None and tests.has_samples:
        if tests.passed:
            return tr("Every channel works as it should.")
        if tests.all_ignored:
            return tr("Nothing to test: the board ignores this input (Ignored Channels).")
        if tests.channels_passed:
            text = tr("The channels are good. But in {0} mode the motors would not start. {1}")
            return text.format(learning.preconditions.source.word, tests.safe_start_reasons)
    return tr(
        "Push every stick to all its ends, then release it. Move every switch to all its "
        "positions. The motors stay off."
    )
