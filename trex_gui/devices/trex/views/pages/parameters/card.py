"""Card of the selected parameter: value, effect, limits and details."""

from html import escape

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QAction, QResizeEvent
from PySide6.QtWidgets import QBoxLayout, QPushButton, QSizePolicy, QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.linter import SettingsLinter
from trex_gui.devices.trex.model.parameters.text import ParameterText
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.device_table import HIGHEST_WIRE
from trex_gui.devices.trex.settings.rules import LintFinding
from trex_gui.devices.trex.views.findings_list import FindingsList
from trex_gui.devices.trex.views.note_field import NoteField
from trex_gui.devices.trex.views.pages.parameters.parameter_pictures import ParameterPicture
from trex_gui.devices.trex.views.pages.parameters.view import ParameterView
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.theme.theme import CARD_PADDING, follow_theme, set_look, set_text_color, theme
from trex_gui.ui.translations import error_sentence
from trex_gui.ui.units import units
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import ElidedLabel, LinkLabel, Muted
from trex_gui.ui.widgets.scroll_box import ScrollBox

_WIDTH = 33  # minimum width in average characters
_BOTH_MOTORS = "parameters/both_motors"


class ParameterCard(ui.Card):
    def __init__(
        self, draft: SettingsDraft, linter: SettingsLinter, view: ParameterView, parent: QWidget
    ) -> None:
        super().__init__("", parent)
        ui.named(self, "aboutParameters", accessible=tr("Selected parameter"))
        self._model, self._view, self._can_edit = draft.parameters, view, True
        self._facts = facts = ui.named(QWidget(self), "parameterFacts")
        box, policy = ScrollBox(facts, self), QSizePolicy.Policy
        box.setSizePolicy(policy.Preferred, policy.Maximum)  # leaves no gap above the buttons
        self._heading = ui.label(facts, "parameterTitle", wrap=True, size="heading")
        self._value = ui.label(facts, "parameterValue", wrap=True, bold=True)
        self._picture = ParameterPicture(facts)
        self._picture.setAccessibleName(self.accessibleName())
        self._notes = ui.label(facts, "parameterNotes", wrap=True, bold=True)
        text, tip = tr("Ma&ke active…"), tr("Show the steps for switching the board off and on")
        self.activate = ui.button(facts, "makeActiveButton", text, icon="power", tip=tip)
        self._help = ui.label(facts, "parameterHelp", wrap=True, selectable=True)
        self._limits = ui.named(Muted("", facts), "parameterLimits")
        self._fold = ui.button(facts, "parameterDetailsButton", tr("Detail&s"), checkable=True)
        set_look(self._fold, "link")
        self._summary = ElidedLabel("", facts)
        set_text_color(self._summary, "muted")
        self._details = LinkLabel("parameterDetails", facts)
        by_mouse = Qt.TextInteractionFlag.TextSelectableByMouse
        self._details.setTextInteractionFlags(self._details.textInteractionFlags() | by_mouse)
        self._details.setOpenExternalLinks(True)
        self._wire = self._wire_row(facts)
        self._note = NoteField(draft.notes, "noteEdit", facts)
        note = ui.label(facts, text=tr("Note"), size="caption")
        self._findings = FindingsList("parameter", self._value, facts)
        tip = tr("Apply each change of one motor to both motors, in one step")
        text, both = tr("&Both motors as one"), Preferences().flag(_BOTH_MOTORS, default=False)
        self._both = ui.check_box(self, "bothMotors", text, tip=tip, checked=both)
        self._model.both_motors = both
        default, undo = self._buttons = [_push_button(action, self) for action in view.tools]
        fold = ui.row(self._fold, (self._summary, 1), spacing=4)
        header = ui.column(self._heading, self._value, self._picture, self._notes, spacing=4)
        parts = self.activate, self._findings, self._help, self._limits, fold, self._details
        notes = ui.column(note, self._note, spacing=2)
        ui.column(header, *parts, self._wire, notes, 1, into=facts, margins=0)
        self._tools = ui.row(default, undo, 1)
        ui.column(box, self._both, self._tools, 1, into=self)

        def fit() -> None:
            texts = _WIDTH * self.fontMetrics().averageCharWidth()
            self.setMinimumWidth(max(texts, self._both.sizeHint().width() + 2 * CARD_PADDING + 2))
            self.show_current()

        self._findings.follow(linter, self._is_relevant)
        self._both.toggled.connect(self._on_both_toggled)
        self._fold.toggled.connect(self.show_current)
        view.wire_value_requested.connect(self._on_wire_value_requested)
        self._model.dataChanged.connect(self.show_current)
        units().changed.connect(self.show_current)
        follow_theme(self, "card", fit)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        width = sum(button.sizeHint().width() + self._tools.spacing() for button in self._buttons)
        fits = width <= self.contentsRect().width()
        direction = QBoxLayout.Direction
        self._tools.setDirection(direction.LeftToRight if fits else direction.TopToBottom)

    def _wire_row(self, parent: QWidget) -> QWidget:
        """Create the field for wire values outside an inferred limit."""
        wire = ui.named(QWidget(parent), "parameterWire")
        text = tr("No document confirms this limit. The board may accept other values.")
        note = ui.label(wire, "wireNote", text, wrap=True)
        self._wire_value = ui.spin_box(wire, "wireField", tr("Wire value"), 0, HIGHEST_WIRE)
        accept = ui.button(wire, "tryWireButton", tr("&Try this value"), on_click=self._on_try)
        ui.column(note, self._wire_value, accept, into=wire, margins=0)
        return wire

    def _is_relevant(self, finding: LintFinding) -> bool:
        key = self._view.current_key
        return bool(key) and not set(finding.keys).isdisjoint(self._model.text.keys_of(key))

    def set_can_edit(self, can_edit: bool) -> None:
        self._can_edit = can_edit
        self._findings.set_can_accept(can_edit)
        self.show_current()

    @Slot()
    def show_current(self) -> None:
        key, text, values = self._view.current_key, self._model.text, self._model.values
        self._view.update_actions()
        self._picture.show_parameter(key, values)
        for widget in (self._facts, self._both):
            widget.setVisible(bool(key))
        for label in (self._help, self._details):  # empty labels need an accessible name
            label.setAccessibleName("" if key else self.accessibleName())
        if not key:
            return
        keys, is_open, notes = text.keys_of(key), self._fold.isChecked(), " ".join(text.notes(key))
        self.activate.setVisible(key in values.active)
        self.activate.setEnabled(self._can_edit)
        self._details.setVisible(is_open)
        self._wire.setVisible(is_open and self._model.key_with_open_values(key) is not None)
        self._wire.setEnabled(self._can_edit)
        is_edited = any(map(values.is_modified, keys))
        set_text_color(self._value, "dirty" if is_edited else "window_text")
        self._heading.setText(text.title(key))
        self._value.setText(text.change(key))
        self._help.setText(text.description(key))
        self._limits.setText(text.limits(key))
        self._summary.setText(f"{'▾' if is_open else '▸'} {text.summary(key)}")
        self._notes.setText(notes)
        self._notes.setVisible(bool(notes))
        self._details.setText(_details(text, key))
        self._note.show_note_on(keys[0], text.title(key))
        self._findings.refresh()
        self._both.setEnabled(values.other_motor_of(key) is not None)

    @Slot(bool)
    def _on_both_toggled(self, both: bool) -> None:
        self._model.both_motors = both
        Preferences().set(_BOTH_MOTORS, both)

    @Slot()
    def _on_wire_value_requested(self) -> None:
        self._fold.setChecked(True)
        self._wire_value.setValue(self._model.values.value_of(self._view.current_key) or 0)
        self._wire_value.setFocus()

    @Slot()
    def _on_try(self) -> None:
        key = self._model.key_with_open_values(self._view.current_key)
        try:
            if key is not None:
                self._model.edit(key, self._wire_value.value(), forced=True)
        except BadRequest as error:
            self._model.rejected.emit(error_sentence(error))


def _details(text: ParameterText, key: str) -> str:
    address, title = map(escape, text.guide(key))
    names = "<br>".join(f"<code>{name}</code>" for name in text.keys_of(key))
    link = f'<a href="{address}" style="color:{theme().color("link").name()}">{title}</a>'
    return f"<p>{names}</p><p>{'<br>'.join(map(escape, text.about(key)))}</p><p>{link}</p>"


def _push_button(action: QAction, parent: QWidget) -> QPushButton:
    button = ui.button(parent, f"{action.objectName()}Button", on_click=action.trigger)

    def update() -> None:
        button.setText(action.iconText())
        button.setToolTip(ui.plain(action.text().replace("&", "")))
        button.setEnabled(action.isEnabled())
        button.setVisible(action.isVisible())

    action.changed.connect(update)
    update()
    return button
