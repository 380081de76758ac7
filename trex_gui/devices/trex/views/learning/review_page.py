"""What was learned beside what was stored: a tab for each channel, its values and its curve."""

from dataclasses import replace
from functools import partial

from PySide6.QtCore import QSize, Qt, Slot
from PySide6.QtGui import QIcon, QResizeEvent
from PySide6.QtWidgets import QBoxLayout, QLabel, QTabBar, QVBoxLayout, QWidget

from trex_gui.devices.trex.calibration.neutral import deadband_floor
from trex_gui.devices.trex.calibration.proposal import WHY_THESE_VALUES
from trex_gui.devices.trex.client.explanations import CHANNEL_ROLES
from trex_gui.devices.trex.model.learning.channels import LearnedChannel
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.model.learning.problem_text import problems_text
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.views.count_editor import CountEditor
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Muted, Note

_FIELDS = ("minimum", "neutral", "maximum", "deadband")
_WIDE = 34
"""Characters of a line of what is said."""


class ChannelForm(QWidget):
    """One channel: take it or not, its values, the old ones beside them, why they are so."""

    def __init__(
        self, learning: Learning, channel: LearnedChannel, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._learning = learning
        self._channel = channel
        number = channel.number
        names = {
            "minimum": self.tr("Minimum"),
            "neutral": self.tr("Neutral"),
            "maximum": self.tr("Maximum"),
            "deadband": self.tr("Deadband"),
        }
        self._editors: dict[str, CountEditor] = {}
        self._were: dict[str, Muted] = {}
        self._labels: list[QLabel] = []

        self._include = ui.check_box(
            self,
            f"learnInclude{number}",
            self.tr("Take channel {0}: {1}").format(number, CHANNEL_ROLES[number]),
        )
        ui.set_bold(self._include)
        self._reversed = ui.check_box(self, f"learnReversed{number}", self.tr("Reversed"))
        self._reversed_was = Muted("", self)
        self._turned = ui.named(Note(0, self), f"learnReversal{number}")
        self._rest = ui.button(self, f"learnTakeRest{number}", on_click=self._on_rest_clicked)
        self._problem = ui.named(Note(1, self), f"learnProblem{number}")
        self._reasons = ui.named(Muted("", self), f"learnReasons{number}")

        grid = ui.grid(self, margins=0, spacing=(12, 4), stretch=[(2, 1)])
        grid.setColumnMinimumWidth(2, _WIDE * self.fontMetrics().averageCharWidth() // 2)
        grid.addWidget(self._include, 0, 0, 1, 3)
        for row, field in enumerate(_FIELDS, 1):
            label = QLabel(names[field], self)
            editor = ui.named(
                CountEditor(channel.source, self),
                f"learn{field.capitalize()}Edit{number}",
                accessible=self.tr("{0} of channel {1}").format(names[field], number),
            )
            was = Muted("", self)
            label.setBuddy(editor)
            for column, widget in enumerate((label, editor, was)):
                grid.addWidget(widget, row, column)
            self._editors[field] = editor
            self._were[field] = was
            self._labels.append(label)
        last = len(_FIELDS) + 1
        grid.addWidget(self._reversed, last, 1)
        grid.addWidget(self._reversed_was, last, 2)
        grid.addWidget(self._turned, last + 1, 0, 1, 3)
        grid.addWidget(self._problem, last + 2, 0, 1, 3)
        grid.addWidget(self._rest, last + 3, 0, 1, 3, Qt.AlignmentFlag.AlignLeft)
        grid.addWidget(self._reasons, last + 4, 0, 1, 3)
        grid.setRowStretch(last + 5, 1)

        self._include.toggled.connect(self._on_include_toggled)
        self._reversed.toggled.connect(self._on_reversed_toggled)
        for field, editor in self._editors.items():
            editor.valueChanged.connect(partial(self._on_value_changed, field))
            editor.rejected.connect(self._on_rejected)

    @property
    def channel(self) -> LearnedChannel:
        return self._channel

    @Slot(bool)
    def _on_include_toggled(self, included: bool) -> None:
        self._learning.choose(self._channel.number, included=included)

    @Slot(bool)
    def _on_reversed_toggled(self, reversed_: bool) -> None:
        self._learning.choose(self._channel.number, reversed_=reversed_)

    @Slot()
    def _on_rest_clicked(self) -> None:
        choice, rest = self._channel.choice, self._channel.new_rest
        if choice is not None and rest is not None:
            wanted = replace(choice.calibration, neutral=rest)
            self._learning.choose(self._channel.number, wanted)

    def _on_value_changed(self, field: str, value: int) -> None:
        if self._channel.choice is not None:
            values = {name: editor.value() for name, editor in self._editors.items()}
            values[field] = value
            self._learning.choose(self._channel.number, Calibration(**values))

    @Slot(str)
    def _on_rejected(self, reason: str) -> None:
        self._problem.show_note(reason, alarming=True)
        self._problem.setVisible(True)

    def refresh(self) -> None:
        channel, choice = self._channel, self._channel.choice
        there = choice is not None
        for widget in (
            *self._labels,
            *self._editors.values(),
            *self._were.values(),
            self._reversed,
            self._reversed_was,
            self._reasons,
            self._turned,
            self._rest,
        ):
            widget.setVisible(there)
        self._include.setEnabled(there)
        problems = channel.result_problems
        text = problems_text(problems)
        if not there:
            text = self.tr("Nothing was learned. {0}").format(
                text or self.tr("The channel was left out.")
            )
        self._problem.show_note(text, alarming=bool(problems))
        self._problem.setVisible(bool(text))
        if choice is None:
            return
        self._show_values(choice.calibration)
        for box, state in ((self._include, choice.included), (self._reversed, choice.reversed_)):
            box.blockSignals(True)
            box.setChecked(state)
            box.blockSignals(False)
        for widget in (*self._editors.values(), self._reversed):
            widget.setEnabled(choice.included)
        self._show_rest(channel.new_rest)
        reasons = list(channel.remarks)
        if channel.proposal is not None:
            turned = channel.proposal.reversed_reason
            self._turned.show_note(turned, alarming=bool(turned))
            self._turned.setVisible(bool(turned))
            reasons += channel.proposal.reasons
        if self._learning.has_edit(channel.number):
            reasons.insert(0, self.tr("This replaces a pending edit of the channel."))
        self._reasons.setText(" ".join(reasons))
        was = self.tr("was reversed") if channel.reversed_now else self.tr("was not reversed")
        self._reversed_was.setText(was)

    def _show_rest(self, rest: int | None) -> None:
        """Offer the place where it came to rest, where that is another one."""
        self._rest.setVisible(rest is not None)
        if rest is not None:
            text = self._channel.source.text(rest)
            self._rest.setText(self.tr("Take {0} as neutral").format(text))

    def _show_values(self, calibration: Calibration) -> None:
        for field, editor in self._editors.items():
            value = getattr(calibration, field)
            if editor.value() != value:
                editor.blockSignals(True)
                editor.setValue(value)
                editor.blockSignals(False)
            old = self.tr("unknown")
            if self._channel.stored is not None:
                count = getattr(self._channel.stored, field)
                old = f"{self._channel.source.text(count)} ({count})"
            self._were[field].setText(self.tr("{0} counts\nwas {1}").format(value, old))


_GAP = 16
_MARGIN = 8


class ReviewPage(QWidget):
    """One channel at a time, to be chosen above: numbers and curve change together.

    The curve is beside the numbers, or below them if there is no room.
    """

    def __init__(self, learning: Learning, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        # The plotting library takes as long to load as Qt: only when it is to be seen.
        from trex_gui.devices.trex.views.learning.curve_pane import CurvePane  # noqa: PLC0415

        self.setObjectName("learnReviewPage")
        self._learning = learning

        self._tabs = ui.named(QTabBar(self), "learnChannelTabs", accessible=self.tr("Channels"))
        self._tabs.setExpanding(False)
        self._forms = [ChannelForm(learning, channel, self) for channel in learning.channels]
        for channel in learning.channels:
            self._tabs.addTab(self.tr("Channel {0}").format(channel.number))
        self._curve = CurvePane(learning, self)
        floor = learning.source.text(deadband_floor(learning.source))
        self._common = ui.named(Muted(WHY_THESE_VALUES.format(floor), self), "learnCommonReasons")
        self._earlier = ui.named(Note(0, self), "learnEarlierEdits")

        self._body = QBoxLayout(QBoxLayout.Direction.LeftToRight)
        self._body.setSpacing(_GAP)
        forms = QVBoxLayout()
        for form in self._forms:
            forms.addWidget(form)
        self._body.addLayout(forms, 2)
        self._body.addWidget(self._curve, 3)
        ui.column(
            self._tabs,
            (self._body, 1),
            self._common,
            self._earlier,
            into=self,
            margins=(0, 0, _MARGIN, 0),
        )

        self._tabs.currentChanged.connect(self._on_tab_changed)
        self._tabs.setVisible(len(self._forms) > 1)
        self._curve.edited.connect(self._on_curve_edited)
        learning.changed.connect(self._on_changed)
        theme().changed.connect(self._show_signs)
        self._on_changed()
        self._choose_first_to_look_at()

    @property
    def _form(self) -> ChannelForm:
        return self._forms[max(0, self._tabs.currentIndex())]

    def minimumSizeHint(self) -> QSize:
        """As wide as numbers or curve need, whichever needs more."""
        least = super().minimumSizeHint()
        form = max(form.minimumSizeHint().width() for form in self._forms)
        least.setWidth(max(form, self._curve.minimumSizeHint().width()) + _MARGIN)
        return least

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        form = max(form.minimumSizeHint().width() for form in self._forms)
        both = form + _GAP + self._curve.minimumSizeHint().width()
        wide = self.width() - _MARGIN >= both
        direction = QBoxLayout.Direction
        self._body.setDirection(direction.LeftToRight if wide else direction.TopToBottom)

    def _choose_first_to_look_at(self) -> None:
        """Begin with a channel that has a problem, else with the first one."""
        for index, form in enumerate(self._forms):
            if form.channel.result_problems:
                self._tabs.setCurrentIndex(index)
                return

    @Slot()
    def _on_changed(self) -> None:
        for form in self._forms:
            form.setVisible(form is self._form)
            form.refresh()
        self._curve.show_channel(self._form.channel)
        self._common.setVisible(any(form.channel.choice is not None for form in self._forms))
        self._show_earlier_edits()
        self._show_signs()

    def _show_earlier_edits(self) -> None:
        """Say what else the list will hold that Apply shows."""
        count = self._learning.other_edits
        text = self.tr("1 earlier edit is in the list of Apply, too.")
        if count != 1:
            text = self.tr("{0} earlier edits are in the list of Apply, too.").format(count)
        self._earlier.show_note(text if count else "", alarming=bool(count))
        self._earlier.setVisible(bool(count))

    @Slot(int)
    def _on_tab_changed(self, _index: int) -> None:
        self._on_changed()

    @Slot(object)
    def _on_curve_edited(self, calibration: Calibration) -> None:
        self._learning.choose(self._form.channel.number, calibration)

    @Slot()
    def _show_signs(self) -> None:
        for index, form in enumerate(self._forms):
            name, color, words = self._sign_of(form.channel)
            self._tabs.setTabIcon(index, icon(name, color) if name else QIcon())
            self._tabs.setTabToolTip(index, words)

    def _sign_of(self, channel: LearnedChannel) -> tuple[str, str, str]:
        """Return the icon, its colour and what it means."""
        if channel.choice is None:
            return "warning", "warning", self.tr("Nothing was learned.")
        if not channel.choice.included:
            return "", "", self.tr("Stays as it is.")
        if channel.result_problems:
            return "warning", "warning", self.tr("Needs a look.")
        return "ok", "good", self.tr("Is taken.")
