"""The wizard that learns channels: beside the window, never in its way."""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, Qt, Slot
from PySide6.QtGui import QCloseEvent, QKeyEvent, QResizeEvent
from PySide6.QtWidgets import QDialog, QVBoxLayout, QWidget

from trex_gui.devices.trex.model.learning.channels import LearnedChannel
from trex_gui.devices.trex.model.learning.learning import Learning, LearningStep
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.views.learning.measuring_pages import ChannelRows, RestPage, TravelPage
from trex_gui.devices.trex.views.learning.review_page import ReviewPage
from trex_gui.devices.trex.views.learning.step_strip import StepStrip
from trex_gui.devices.trex.views.learning.test_page import TestPage
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.scroll_box import ScrollBox

_PAGES: dict[LearningStep, type[RestPage | TravelPage | ReviewPage | TestPage]] = {
    LearningStep.NEUTRAL: RestPage,
    LearningStep.TRAVEL: TravelPage,
    LearningStep.REVIEW: ReviewPage,
    LearningStep.TEST: TestPage,
}

_PLACES = {
    LearningStep.STOPPING: 0,
    LearningStep.DOUBT: 0,
    LearningStep.NEUTRAL: 1,
    LearningStep.TRAVEL: 2,
    LearningStep.REVIEW: 3,
    LearningStep.TEST: 1,
}


class LearnDialog(QDialog):
    """Shows one step at a time; the red button of the window can always be pressed.

    Esc stops the motors, as everywhere, and ends it. Nothing is changed before Take. Asked for
    while it is at work, it only comes forward: what was measured so far is not thrown away.
    """

    def __init__(self, learning: Learning, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("learnDialog")
        self.resize(920, 600)
        self._learning = learning
        self._shown: tuple[LearningStep, object] | None = None
        self._page: QWidget | None = None
        self._offers_test = False

        self._steps = StepStrip(self)
        self._head = ui.named(Note(2, self), "learnHead")
        self._back = ui.button(self, "learnBackButton", self.tr("Back"), on_click=learning.back)
        self._again = ui.button(self, "learnAgainButton", icon="reload", on_click=learning.again)
        self._learn_again = ui.button(
            self, "learnChannelAgainButton", icon="calibrate", on_click=self._on_learn_again
        )
        self._next = ui.button(self, "learnNextButton", self.tr("Next"), on_click=learning.next)
        self._take = ui.button(
            self,
            "learnTakeButton",
            self.tr("Use these values…"),
            icon="apply",
            on_click=learning.take,
        )
        self._test = ui.button(self, "learnTestButton", self.tr("Stop the motors and test"))
        self._cancel = ui.button(self, "learnCancelButton")

        buttons = ui.row(
            self._again,
            self._learn_again,
            1,
            self._back,
            self._next,
            self._take,
            self._test,
            self._cancel,
        )
        self._body = QVBoxLayout()
        ui.column(self._steps, self._head, (self._body, 1), buttons, into=self, spacing=10)

        self._test.clicked.connect(lambda: self.test(learning.numbers))
        self._cancel.clicked.connect(self.close)
        learning.changed.connect(self._on_changed)
        learning.measured.connect(self._on_measured)
        learning.stored.connect(self._on_stored)

    def learn(self, channels: Sequence[int] = CHANNELS) -> None:
        """Learn these channels, unless some are learned already; the motors are stopped first."""
        if not self._is_learning:
            self._offers_test = False
            self._learning.begin(channels)
        self._come_forward()

    def test(self, channels: Sequence[int] = CHANNELS) -> None:
        """Test the sticks on what is stored; the motors are stopped first."""
        if not self._is_learning:
            self._offers_test = False
            self._learning.begin_test(channels)
        self._come_forward()

    @property
    def _is_learning(self) -> bool:
        """Whether there is something to lose; a test is begun again in no time."""
        learning = self._learning
        return not learning.is_test and learning.step not in {
            LearningStep.ENDED,
            LearningStep.FAILED,
        }

    def _come_forward(self) -> None:
        self.show()
        self.activateWindow()

    def event(self, event: QEvent) -> bool:
        """Let Esc close the dialog, too; the window's own watch for it has stopped the motors."""
        if (
            event.type() == QEvent.Type.ShortcutOverride
            and isinstance(event, QKeyEvent)
            and event.key() == Qt.Key.Key_Escape
        ):
            event.accept()  # else the window's shortcut would take the key away
            return True
        return super().event(event)

    def reject(self) -> None:
        """Esc and Cancel leave everything as it was."""
        self._learning.cancel()
        super().reject()

    def closeEvent(self, event: QCloseEvent) -> None:
        self._learning.cancel()
        super().closeEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit_head()

    def _fit_head(self) -> None:
        """Keep the room for all that the head says: where it is narrow, what is below shrinks."""
        layout = self.layout()
        if layout is None:
            return
        margins = layout.contentsMargins()
        width = self.width() - margins.left() - margins.right()
        least = 2 * self._head.fontMetrics().lineSpacing()
        self._head.setMinimumHeight(max(least, self._head.heightForWidth(width)))

    # --- What has changed ---------------------------------------------------------------

    @Slot()
    def _on_stored(self) -> None:
        if not self._learning.motors_armed:
            self.test(self._learning.numbers)
            return
        # Somebody drives: only they stop the motors, and the keys they drive with stay theirs.
        self._offers_test = True
        self._show_page(None)
        self._describe()
        self.setAttribute(Qt.WidgetAttribute.WA_ShowWithoutActivating)
        self.show()
        self.setAttribute(Qt.WidgetAttribute.WA_ShowWithoutActivating, False)

    @Slot()
    def _on_learn_again(self) -> None:
        tests = self._learning.tests
        if tests is not None and tests.to_learn_again:
            self._learning.begin(tests.to_learn_again)

    @Slot()
    def _on_measured(self) -> None:
        if self._learning.sampling or self._learning.step in {
            LearningStep.TEST,
            LearningStep.TRAVEL,
        }:
            self._describe()

    @Slot()
    def _on_changed(self) -> None:
        step = self._learning.step
        if step is LearningStep.ENDED:
            self._show_page(None)
            self.hide()
            return
        # The channels are made anew when the rest is: then the page has to be, too.
        subject = self._learning.tests if step is LearningStep.TEST else self._learning.channels
        if self._shown != (step, subject):
            self._shown = (step, subject)
            make = _PAGES.get(step)
            self._show_page(QWidget(self) if make is None else self._scrolling(make))
        self._describe()

    def _scrolling(self, make: type[RestPage | TravelPage | ReviewPage | TestPage]) -> QWidget:
        page = make(self._learning)
        box = ScrollBox(page, self)
        if isinstance(page, ChannelRows | TestPage):
            box.setMinimumHeight(page.least_seen)
        box.setAccessibleName(self.tr("What is measured"))
        return box

    def _show_page(self, page: QWidget | None) -> None:
        if self._page is not None:
            self._body.removeWidget(self._page)
            self._page.hide()
            self._page.setParent(None)
            self._page.deleteLater()
        self._page = page
        if page is None:
            self._shown = None
        else:
            self._body.addWidget(page)

    def _describe(self) -> None:
        """Let every word and button fit the step."""
        learning, step = self._learning, self._learning.step
        if learning.is_test or self._offers_test:
            self.setWindowTitle(self.tr("Test the sticks"))
            self._steps.set_steps([self.tr("Stop the motors"), self.tr("Test every stick")])
        else:
            self.setWindowTitle(self.tr("Learn channels"))
            self._steps.set_steps(
                [
                    self.tr("Stop the motors"),
                    self.tr("Hands off the sticks"),
                    self.tr("All sticks to all ends"),
                    self.tr("Review"),
                ]
            )
        if self._offers_test:
            self._steps.show_step(0)
        elif step in _PLACES:
            self._steps.show_step(_PLACES[step])
        self._head.show_note(self._head_text(), alarming=self._is_alarming())
        self._fit_head()
        moving = step in {LearningStep.NEUTRAL, LearningStep.TRAVEL, LearningStep.DOUBT}
        self._back.setVisible(step in {LearningStep.TRAVEL, LearningStep.REVIEW})
        self._describe_again()
        self._next.setVisible(moving)
        self._next.setEnabled(learning.can_go_on)
        self._next.setDefault(moving and step is not LearningStep.DOUBT)
        doubtful = step is LearningStep.DOUBT
        self._next.setText(
            self.tr("The motors are stopped: continue") if doubtful else self.tr("Next")
        )
        self._take.setVisible(step is LearningStep.REVIEW)
        self._take.setEnabled(learning.can_take)
        self._take.setToolTip(self._take_tip())
        self._take.setDefault(step is LearningStep.REVIEW)
        self._test.setVisible(self._offers_test)
        ends = step in {LearningStep.TEST, LearningStep.FAILED, LearningStep.ENDED}
        self._cancel.setText(self.tr("Close") if ends else self.tr("Cancel"))
        self._cancel.setDefault(step is LearningStep.TEST or self._offers_test)

    def _describe_again(self) -> None:
        """Say what it is that would be done again."""
        learning, step = self._learning, self._learning.step
        names = {
            LearningStep.NEUTRAL: (
                self.tr("Sample again"),
                self.tr("Measure the rest positions of all channels once more."),
            ),
            LearningStep.TRAVEL: (
                self.tr("Forget these ends"),
                self.tr("Forget the ends reached so far. The rest positions are kept."),
            ),
            LearningStep.REVIEW: (
                self.tr("Start over"),
                self.tr("Forget everything measured and go back to the rest positions."),
            ),
            LearningStep.TEST: (
                self.tr("Test again"),
                self.tr("Forget what was tested so far and begin the test again."),
            ),
        }
        retry = self.tr("Try again"), self.tr("Stop the motors again and begin again.")
        text, tip = names.get(step, retry)
        self._again.setText(text)
        self._again.setToolTip(tip)
        never = {LearningStep.STOPPING, LearningStep.ENDED}
        waits = step is LearningStep.NEUTRAL and not (learning.has_sampled or learning.sampling)
        self._again.setVisible(step not in never and not waits)
        self._again.setEnabled(not learning.sampling)
        numbers = () if learning.tests is None else learning.tests.to_learn_again
        if len(numbers) == 1:
            text = self.tr("Learn channel {0} again")
        else:
            text = self.tr("Learn channels {0} again")
        self._learn_again.setText(text.format(", ".join(map(str, numbers))))
        self._learn_again.setToolTip(
            self.tr("If a channel does not get a good result, learn its values again.")
        )
        self._learn_again.setVisible(step is LearningStep.TEST and bool(numbers))

    def _is_alarming(self) -> bool:
        learning = self._learning
        failed_rest = (
            learning.step is LearningStep.NEUTRAL
            and learning.has_sampled
            and not all(channel.is_at_rest for channel in learning.channels)
        )
        tests = learning.tests if learning.step is LearningStep.TEST else None
        held = tests is not None and tests.channels_passed and not tests.passed
        broken = learning.step in {LearningStep.FAILED, LearningStep.DOUBT} or learning.stalled
        return broken or failed_rest or held

    def _head_text(self) -> str:
        learning = self._learning
        if self._offers_test:
            return self.tr(
                "The new values are in the board. The test does not start by itself, because the "
                "motors may be running: it has to stop them first."
            )
        if learning.stalled:
            return self.tr(
                "The board sends no measurements: the line is busy or disturbed. Waiting …"
            )
        match learning.step:
            case LearningStep.STOPPING:
                return self.tr(
                    "Stopping the motors. The next step comes when the board has confirmed the "
                    "stop and no current flows."
                )
            case LearningStep.NEUTRAL:
                return self._rest_text()
            case LearningStep.TRAVEL:
                return self._travel_text()
            case LearningStep.REVIEW:
                return self._review_text()
            case LearningStep.TEST:
                return f"{learning.news} {self._test_text()}".strip()
        return learning.trouble

    def _rest_text(self) -> str:
        learning = self._learning
        if learning.sampling:
            return self.tr("Hands off. Sampling … {0:.1f} s").format(learning.seconds_left)
        if not learning.has_sampled:
            return self.tr(
                "The motors are stopped. Let go of every stick and set every switch to off. Then "
                "click Next: the rest positions are measured."
            )
        bad = [str(channel.number) for channel in learning.channels if not channel.is_at_rest]
        if len(bad) == len(learning.channels):
            return self.tr(
                "No channel is at rest. Correct the problems below, then click “Sample again”."
            )
        return self.tr(
            "Not every channel rests. Correct the problems below and click “Sample again”, or "
            "click Next to go on without channel {0}."
        ).format(", ".join(bad))

    def _travel_text(self) -> str:
        text = self.tr(
            "Push every stick forward or right first, all the way; then the other way. "
            "Move switches to all positions. "
        )
        slow = [c.travel for c in self._learning.channels if c.travel and c.travel.is_slow]
        if not slow:
            return text + self.tr("Hold each end for a moment, then click Next.")
        held = max(travel.hold_seconds for travel in slow)
        reason = self.tr(
            "Hold each end until it is ticked, for {0:.1f} s at least: over this line ({1} baud) "
            "only {2:.1f} measurements come in a second. Then click Next."
        )
        return text + reason.format(held, self._learning.baud, self._learning.samples_a_second)

    def _review_text(self) -> str:
        if not any(channel.choice is not None for channel in self._learning.channels):
            return self.tr("Nothing was learned. The reason is below. Go back, or start over.")
        if not self._wanted:
            return self.tr(
                "No channel is ticked, so nothing would be taken. Tick each channel whose new "
                "values you want."
            )
        if self._refused:
            return self.tr(
                "The board would reject the values of channel {0}: change them, or clear its "
                "check box."
            ).format(self._refused)
        return self.tr(
            "Check the new values. You can change them; clear the check box of a channel to "
            "keep its old values. "
            "Nothing is written yet: you confirm all changes in the next window."
        )

    def _take_tip(self) -> str:
        if self._learning.can_take:
            return self.tr("Take the values of all ticked channels. Nothing is written yet.")
        if not any(channel.choice is not None for channel in self._learning.channels):
            return self.tr("Nothing was learned, so there is nothing to take.")
        if not self._wanted:
            return self.tr("No channel is ticked.")
        if self._refused:
            return self.tr("The board would not take the values of channel {0}.").format(
                self._refused
            )
        return self._learning.why_not()

    @property
    def _wanted(self) -> list[LearnedChannel]:
        """The channels whose values are to be taken."""
        return [c for c in self._learning.channels if c.choice is not None and c.choice.included]

    @property
    def _refused(self) -> str:
        """The numbers of those among them that the board would not take."""
        return ", ".join(str(c.number) for c in self._wanted if not c.can_be_taken)

    def _test_text(self) -> str:
        tests = self._learning.tests
        if tests is None or not tests.heard:
            return self._test_orders()
        if tests.passed:
            return self.tr("Everything is as it should be.")
        if tests.all_ignored:
            return self.tr(
                "There is nothing to test: the board ignores this input, so it holds it at "
                "neutral. See the setting Ignored Channels."
            )
        if tests.channels_passed:
            text = self.tr("What was tested is good. But in {0} mode the motors would not start: ")
            return text.format(tests.mode) + "; ".join(tests.safe_start_reasons) + "."
        return self._test_orders()

    def _test_orders(self) -> str:
        return self.tr(
            "Push every stick to all its ends, then let go. Move every switch to all its "
            "positions. The motors stay off: in serial mode the sticks do not drive them."
        )
