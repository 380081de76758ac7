"""The values of one channel to change, what they were, and what there is to say."""

from dataclasses import replace
from functools import partial

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QLabel, QWidget

from trex_gui.devices.trex.client.explanations import CHANNEL_ROLES
from trex_gui.devices.trex.model.learning.channel import LearnedChannel
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.views.count_editor import CountEditor
from trex_gui.devices.trex.views.learning.parts import Muted, in_words
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.note import Note

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
            editor.refused.connect(self._on_refused)

    @property
    def channel(self) -> LearnedChannel:
        """The channel that it shows."""
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
    def _on_refused(self, reason: str) -> None:
        self._problem.show_note(reason, alarming=True)
        self._problem.setVisible(True)

    def refresh(self) -> None:
        """Show the choice as it is."""
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
        text = in_words(problems)
        if not there:
            text = self.tr("Nothing was learned. {0}").format(text or self.tr("It was left out."))
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
            reasons.insert(0, self.tr("An edit of it that waits for Apply is replaced."))
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
            old = self.tr("not known")
            if self._channel.stored is not None:
                count = getattr(self._channel.stored, field)
                old = f"{self._channel.source.text(count)} ({count})"
            self._were[field].setText(self.tr("{0} counts\nwas {1}").format(value, old))
