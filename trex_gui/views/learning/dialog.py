"""The wizard that learns channels: beside the window, never in its way."""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, Qt, Slot
from PySide6.QtGui import QCloseEvent, QKeyEvent
from PySide6.QtWidgets import QDialog, QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from trex_gui.model.learning import Learning, Step
from trex_gui.protocol.flags import CHANNELS
from trex_gui.views.icons import set_icon
from trex_gui.views.learning.rest_page import RestPage
from trex_gui.views.learning.review_page import ReviewPage
from trex_gui.views.learning.step_strip import StepStrip
from trex_gui.views.learning.test_page import TestPage
from trex_gui.views.learning.travel_page import TravelPage
from trex_gui.views.widgets.note import Note
from trex_gui.views.widgets.scroll_box import ScrollBox

_PAGES: dict[Step, type[RestPage | TravelPage | ReviewPage | TestPage]] = {
    Step.NEUTRAL: RestPage,
    Step.TRAVEL: TravelPage,
    Step.REVIEW: ReviewPage,
    Step.TEST: TestPage,
}

_PLACES = {
    Step.STOPPING: 0,
    Step.DOUBT: 0,
    Step.NEUTRAL: 1,
    Step.TRAVEL: 2,
    Step.REVIEW: 3,
    Step.TEST: 1,
}


class LearnDialog(QDialog):
    """Shows one step at a time; the red button of the window can always be pressed.

    Esc stops the motors, as everywhere, and ends it. Nothing is changed before Take.
    """

    def __init__(self, learning: Learning, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("learnDialog")
        self.resize(920, 600)
        self._learning = learning
        self._shown: tuple[Step, object] | None = None
        self._page: QWidget | None = None

        self._steps = StepStrip(self)
        self._head = Note(2, self)
        self._head.setObjectName("learnHead")
        self._back = QPushButton(self.tr("Back"), self)
        self._back.setObjectName("learnBackButton")
        self._again = QPushButton(self.tr("Again"), self)
        self._again.setObjectName("learnAgainButton")
        set_icon(self._again, "reload")
        self._next = QPushButton(self.tr("Next"), self)
        self._next.setObjectName("learnNextButton")
        self._take = QPushButton(self.tr("Take these values…"), self)
        self._take.setObjectName("learnTakeButton")
        set_icon(self._take, "apply")
        self._cancel = QPushButton(self)
        self._cancel.setObjectName("learnCancelButton")

        buttons = QHBoxLayout()
        buttons.addWidget(self._again)
        buttons.addStretch(1)
        for button in (self._back, self._next, self._take, self._cancel):
            buttons.addWidget(button)
        self._body = QVBoxLayout()
        layout = QVBoxLayout(self)
        layout.setSpacing(10)
        layout.addWidget(self._steps)
        layout.addWidget(self._head)
        layout.addLayout(self._body, 1)
        layout.addLayout(buttons)

        self._back.clicked.connect(learning.back)
        self._again.clicked.connect(learning.again)
        self._next.clicked.connect(learning.next)
        self._take.clicked.connect(learning.take)
        self._cancel.clicked.connect(self.close)
        learning.changed.connect(self._on_changed)
        learning.measured.connect(self._on_measured)
        learning.stored.connect(self._on_stored)

    def learn(self, channels: Sequence[int] = CHANNELS) -> None:
        """Learn these channels; the motors are stopped first."""
        self._learning.begin(channels)
        self._come_forward()

    def test(self, channels: Sequence[int] = CHANNELS) -> None:
        """Test the sticks on what is stored; the motors are stopped first."""
        self._learning.begin_test(channels)
        self._come_forward()

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

    # --- What has changed ---------------------------------------------------------------

    @Slot()
    def _on_stored(self) -> None:
        self.test(self._learning.numbers)

    @Slot()
    def _on_measured(self) -> None:
        if self._learning.sampling or self._learning.step in {Step.TEST, Step.TRAVEL}:
            self._describe()

    @Slot()
    def _on_changed(self) -> None:
        step = self._learning.step
        if step is Step.ENDED:
            self._show_page(None)
            self.hide()
            return
        # The channels are made anew when the rest is: then the page has to be, too.
        subject = self._learning.tests if step is Step.TEST else self._learning.channels
        if self._shown != (step, subject):
            self._shown = (step, subject)
            make = _PAGES.get(step)
            self._show_page(QWidget(self) if make is None else self._scrolling(make))
        self._describe()

    def _scrolling(self, make: type[RestPage | TravelPage | ReviewPage | TestPage]) -> QWidget:
        box = ScrollBox(make(self._learning), self)
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
        if learning.is_test:
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
        if step in _PLACES:
            self._steps.show_step(_PLACES[step])
        self._head.show_note(self._head_text(), alarming=self._is_alarming())
        moving = step in {Step.NEUTRAL, Step.TRAVEL, Step.DOUBT}
        self._back.setVisible(step in {Step.TRAVEL, Step.REVIEW})
        can_repeat = step not in {Step.STOPPING, Step.NEUTRAL}
        self._again.setVisible(can_repeat or step is Step.NEUTRAL)
        self._again.setEnabled(can_repeat or learning.has_sampled)
        self._next.setVisible(moving)
        self._next.setEnabled(learning.can_go_on)
        self._next.setDefault(moving and step is not Step.DOUBT)
        doubtful = step is Step.DOUBT
        self._next.setText(self.tr("The motors stand: go on") if doubtful else self.tr("Next"))
        self._take.setVisible(step is Step.REVIEW)
        self._take.setEnabled(learning.can_take)
        self._take.setDefault(step is Step.REVIEW)
        ends = step in {Step.TEST, Step.FAILED}
        self._cancel.setText(self.tr("Close") if ends else self.tr("Cancel"))
        self._cancel.setDefault(step is Step.TEST)

    def _is_alarming(self) -> bool:
        learning = self._learning
        failed_rest = (
            learning.step is Step.NEUTRAL
            and learning.has_sampled
            and not all(channel.is_at_rest for channel in learning.channels)
        )
        return learning.step in {Step.FAILED, Step.DOUBT} or learning.stalled or failed_rest

    def _head_text(self) -> str:
        learning = self._learning
        if learning.stalled:
            return self.tr(
                "No measurements come from the board: the line is busy or bad. Waiting for them …"
            )
        match learning.step:
            case Step.STOPPING:
                return self.tr(
                    "Stopping the motors. It goes on when the board has confirmed it and no "
                    "current flows."
                )
            case Step.NEUTRAL:
                return self._rest_text()
            case Step.TRAVEL:
                return self._travel_text()
            case Step.REVIEW:
                return self._review_text()
            case Step.TEST:
                return self._test_text()
        return learning.trouble

    def _rest_text(self) -> str:
        learning = self._learning
        if learning.sampling:
            return self.tr("Hands off. Sampling … {0:.1f} s").format(learning.seconds_left)
        if not learning.has_sampled:
            return self.tr(
                "The motors are stopped. Let go of every stick and leave the switches where they "
                "are to rest, then click Next: what comes in is sampled for a moment."
            )
        bad = [str(channel.number) for channel in learning.channels if not channel.is_at_rest]
        if len(bad) == len(learning.channels):
            return self.tr("No channel rests. Mend what is wrong, then click Again.")
        return self.tr(
            "Not every channel rests. Mend what is wrong and click Again, or click Next to go on "
            "without channel {0}."
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
            return self.tr("Nothing was learned; below it says why. Go back, or begin again.")
        bad = [
            str(channel.number)
            for channel in self._learning.channels
            if channel.choice is not None and channel.choice.included and not channel.can_be_taken
        ]
        if bad:
            return self.tr(
                "The board would not take the values of channel {0}: change them, or untick it."
            ).format(", ".join(bad))
        return self.tr(
            "These values fit what was measured. Change what you like and untick what shall stay. "
            "Nothing is written yet: taken, they are edits, and you see them once more before."
        )

    def _test_text(self) -> str:
        tests = self._learning.tests
        if tests is not None and tests.passed:
            return self.tr("Everything is as it should be.")
        return self.tr(
            "Push every stick to all its ends, then let go; move the switches. The motors stay "
            "off: in serial mode sticks move nothing."
        )
