"""Learned and stored values of each channel. Importing this module loads pyqtgraph."""

from functools import partial
from typing import Any

from PySide6.QtCore import QSignalBlocker, Qt, Slot
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QTabBar, QWidget

from trex_gui.core.texts import signed_text
from trex_gui.core.translation import tr
from trex_gui.devices.trex.calibration.neutral import deadband_floor
from trex_gui.devices.trex.calibration.proposal import WHY_THESE_VALUES
from trex_gui.devices.trex.model.channel_text import input_text
from trex_gui.devices.trex.model.learning.channels import LearnedChannel
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.model.learning.problem_text import problems_text
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.descriptions import CHANNEL_ROLES
from trex_gui.devices.trex.views.count_editor import CountEditor
from trex_gui.devices.trex.views.pages.channels.curve_plot import CurvePlot
from trex_gui.devices.trex.views.steps import Page
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.units import units
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import LegendKey, Muted, Note

_FORM_CHARACTERS = 17
_CURVE_CHARACTERS, _CURVE_LINES = 40, 13


class ChannelForm(QWidget):
    def __init__(self, learning: Learning, channel: LearnedChannel, parent: QWidget) -> None:
        super().__init__(parent)
        self._learning = learning
        self.channel = channel
        number = channel.number
        names = {
            "minimum": tr("&Minimum"),
            "neutral": tr("&Neutral"),
            "maximum": tr("Ma&ximum"),
            "deadband": tr("&Deadband"),
        }
        self._editors: dict[str, CountEditor] = {}
        self._old_values: dict[str, Muted] = {}

        self._include = ui.check_box(
            self,
            f"learnInclude{number}",
            tr("Use &channel {0}: {1}").format(number, tr(CHANNEL_ROLES[number])),
            on_click=lambda included: self.set_choice(included=included),
        )
        ui.set_bold(self._include)
        self._values = QWidget(self)
        text = tr("was reversed") if channel.reversed_now else tr("was not reversed")
        was_reversed = Muted(text, self)
        self._reversal = ui.named(Note(1, self), f"learnReversal{number}")
        self._problem = ui.named(Note(1, self), f"learnProblem{number}")
        self._reasons = ui.named(Muted("", self), f"learnReasons{number}")

        grid = ui.grid(self._values, margins=0, spacing=(12, 4), stretch=[(2, 1)])
        characters = self.fontMetrics().averageCharWidth()
        grid.setColumnMinimumWidth(2, _FORM_CHARACTERS * characters)
        for row, (field, name) in enumerate(names.items()):
            editor = ui.named(
                CountEditor(channel.source, self),
                f"learn{field.capitalize()}Edit{number}",
                accessible=tr("{0} of channel {1}").format(name.replace("&", ""), number),
            )
            old_value = Muted("", self)
            widgets = ui.label(self, text=name, buddy=editor), editor, old_value
            for column, widget in enumerate(widgets):
                grid.addWidget(widget, row, column)
            self._editors[field], self._old_values[field] = editor, old_value
            editor.valueChanged.connect(partial(self._on_value_changed, field))
            editor.rejected.connect(partial(self._problem.show_note, alarming=True))
        self._reversed = ui.check_box(
            self,
            f"learnReversed{number}",
            tr("&Reversed"),
            on_click=lambda reversed_: self.set_choice(reversed_=reversed_),
        )
        grid.addWidget(self._reversed, len(names), 1)
        grid.addWidget(was_reversed, len(names), 2)
        grid.addWidget(self._reversal, len(names) + 1, 0, 1, 3)
        self._rest = ui.button(self, f"learnUseRest{number}", on_click=self._on_rest_clicked)
        rest = self._rest, 0, Qt.AlignmentFlag.AlignLeft
        items = self._include, self._values, self._problem, rest, self._reasons
        ui.column(*items, 1, into=self, margins=0, spacing=4)
        units().changed.connect(self.refresh)

    def set_choice(self, **changes: Any) -> None:
        self._learning.set_choice(self.channel.number, **changes)

    @Slot()
    def _on_rest_clicked(self) -> None:
        self._editors["neutral"].setValue(self.channel.new_rest or 0)

    def _on_value_changed(self, field: str, value: int) -> None:
        values = {name: editor.value() for name, editor in self._editors.items()}
        self.set_choice(calibration=Calibration(**{**values, field: value}))

    @Slot()
    def refresh(self) -> None:
        channel, choice = self.channel, self.channel.choice
        for widget in (self._values, self._reasons):
            widget.setVisible(choice is not None)
        self._include.setEnabled(choice is not None)
        problems = problems_text(channel.result_problems)
        if choice is None:
            reason = problems or tr("The channel was left out.")
            text = f"{tr('Nothing was learned.')} {reason}"
            self._problem.show_note(text, alarming=True)
            self._rest.setVisible(False)
            return
        self._problem.show_note(problems, alarming=True)
        self._include.setChecked(choice.included)
        self._reversed.setChecked(choice.reversed_)
        for box in (*self._editors.values(), self._reversed):
            box.setEnabled(choice.included)
        self._show_values(choice.calibration)
        rest = channel.new_rest
        self._rest.setVisible(rest is not None)
        self._rest.setText(tr("Use {0} &as neutral").format(channel.source.text(rest or 0)))
        reasons = [channel.remark]
        if channel.proposal is not None:
            self._reversal.show_note(channel.proposal.reversed_reason, alarming=True)
            reasons += channel.proposal.reasons
        if self._learning.pending.has_edit(channel.number):
            reasons.insert(0, tr("This replaces a pending edit of the channel."))
        self._reasons.setText(" ".join(filter(None, reasons)))

    def _show_values(self, calibration: Calibration) -> None:
        before = self.channel.curve_before
        for field, editor in self._editors.items():
            value = getattr(calibration, field)
            if editor.value() != value:
                with QSignalBlocker(editor):
                    editor.setValue(value)
            old = tr("unknown")
            if before is not None:
                old = input_text(self.channel.source, getattr(before.calibration, field))
            self._old_values[field].setText(tr("{0}\nwas {1}").format(editor.other_text, old))


class ReviewPage(Page):
    def __init__(self, learning: Learning) -> None:
        super().__init__("learnReviewPage")
        self._learning = learning

        self._tabs = ui.named(QTabBar(self), "learnChannelTabs", accessible=tr("Channels"))
        self._tabs.setExpanding(False)
        self._forms = [ChannelForm(learning, channel, self.side) for channel in learning.channels]
        for channel in learning.channels:
            self._tabs.addTab(tr("CH{0}").format(channel.number))
        metrics = self.fontMetrics()
        self._plot = ui.named(CurvePlot(self), "learnCurve")
        self._plot.setMinimumWidth(_CURVE_CHARACTERS * metrics.averageCharWidth())
        self._plot.setMinimumHeight(_CURVE_LINES * metrics.lineSpacing())
        after = LegendKey(tr("proposed"), "pointer", self)
        before = LegendKey(tr("as it was"), "muted", self, Qt.PenStyle.DashLine)
        self._legend = after, ui.named(before, "learnCurveBefore")
        self._live = ui.named(Muted("", self), "learnCurveLive")
        source = learning.preconditions.source
        reasons = tr(WHY_THESE_VALUES).format(source.text(deadband_floor(source)))
        self._common = ui.named(Muted(reasons, self.side), "learnCommonReasons")
        self._earlier = ui.named(Note(0, self.side), "learnEarlierEdits")
        items = self._tabs, ui.row(*self._legend, 1), (self._plot, 1), self._live
        ui.column(*items, into=self, margins=0)
        ui.column(*self._forms, self._common, self._earlier, into=self.side, margins=0)

        self._tabs.currentChanged.connect(self._on_changed)
        self._tabs.setVisible(len(self._forms) > 1)
        self._plot.edited.connect(lambda edited: self._form.set_choice(calibration=edited))
        learning.changed.connect(self._on_changed)
        learning.measured.connect(self._on_measured)
        theme().changed.connect(self._show_signs)
        self._on_changed()
        problems = (i for i, form in enumerate(self._forms) if form.channel.result_problems)
        self._tabs.setCurrentIndex(next(problems, 0))

    @property
    def _form(self) -> ChannelForm:
        return self._forms[max(0, self._tabs.currentIndex())]

    @Slot()
    def _on_changed(self) -> None:
        for form in self._forms:
            form.setVisible(form is self._form)
            form.refresh()
        channel = self._form.channel
        before, after = channel.curve_before, channel.curve_after
        number, source, editable = channel.number, channel.source, channel.is_included
        self._plot.show_channel(number, source, before, after, editable=editable)
        for key, curve in zip(self._legend, (after, before), strict=True):
            key.setVisible(curve is not None and before != after)
        self._on_measured()
        self._common.setVisible(any(form.channel.choice is not None for form in self._forms))
        count = self._learning.other_edits
        text = tr("%n earlier pending edit(s) will also be written.", "", count)
        self._earlier.show_note(text if count else "", alarming=True)
        self._show_signs()

    @Slot()
    def _on_measured(self) -> None:
        channel = self._form.channel
        self._plot.set_raw(channel.raw)
        if channel.raw is None:
            self._live.setText(tr("No signal now: the output is 0."))
            return
        curves = ((tr("proposed"), channel.curve_after), (tr("as it was"), channel.curve_before))
        outputs = [
            f"{text} {signed_text(curve.output(channel.raw))}" for text, curve in curves if curve
        ]
        text = tr("Input now {0}; output {1}.")
        self._live.setText(text.format(channel.source.text(channel.raw), ", ".join(outputs)))

    @Slot()
    def _show_signs(self) -> None:
        for index, form in enumerate(self._forms):
            name, color, text = self._sign_of(form.channel)
            self._tabs.setTabIcon(index, icon(name, color) if name else QIcon())
            self._tabs.setTabToolTip(index, text)
        self._tabs.setMinimumWidth(self._tabs.sizeHint().width())

    def _sign_of(self, channel: LearnedChannel) -> tuple[str, str, str]:
        if channel.choice is None:
            return "warning", "warning", tr("Nothing was learned.")
        if not channel.choice.included:
            return "", "", tr("This channel keeps its old values.")
        if channel.result_problems:
            return "warning", "warning", tr("Check this channel.")
        return "ok", "good", tr("The new values of this channel will be used.")
