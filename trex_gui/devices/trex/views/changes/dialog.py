"""Dialog that previews changes to settings."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from PySide6.QtCore import QRect, SignalInstance, Slot
from PySide6.QtGui import QGuiApplication, QShowEvent
from PySide6.QtWidgets import QBoxLayout, QSizePolicy, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.settings.comparison import Comparison, ComparisonRow
from trex_gui.devices.trex.views.comparison_view import ComparisonView
from trex_gui.devices.trex.views.findings_list import FindingsList, Remark
from trex_gui.devices.trex.views.motor_controls import MotorBar
from trex_gui.ui.notifier import Answer
from trex_gui.ui.theme.theme import set_look, set_style_property
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.builders import button, column, label, named, tab_order
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.messages import InlinePrompt, MessageSpace
from trex_gui.ui.widgets.placement import fitted, resize_with_font
from trex_gui.ui.widgets.scroll_box import ScrollBox

_WIDTH = 760  # pixels
_MARGIN = 24  # pixels
_AROUND_BUTTONS = 12  # pixels around the buttons; this area is amber while motors are armed
Rows = tuple[ComparisonRow, ...]
TickedOf = Callable[[Comparison], Rows]  # returns the checked rows of a comparison


class Names(NamedTuple):
    """Object names of a dialog and its parts."""

    dialog: str
    prefix: str  # prefix of the other object names
    action: str
    close: str


@dataclass(frozen=True, slots=True)
class Changes:
    heading: str  # planned action or its result
    has_failed: bool = False
    caption: str = ""
    rows: Comparison | None = None  # `None`: no table
    sides: tuple[str, str] = ("", "")  # names of the settings before and after
    with_ticks: bool = True  # True if the rows have check boxes
    outcomes: Mapping[str, str] = field(default_factory=dict)  # key → text in `ComparisonTable`
    summary: str = ""  # text instead of the counts
    remarks: Sequence[Remark] = ()
    can_accept: bool = False  # True if proposals in the remarks can be accepted
    problem: str = ""  # obstacle or error
    action: str = ""  # verb and count on the primary button; empty hides the button
    can_act: bool = False
    close: str = ""  # text of the close button, `Cancel` by default
    is_close_default: bool = False  # True if the close button is the default button


class Question(InlinePrompt):
    def prompt_before(
        self, write: Callable[[], object], doubts: Callable[[], Sequence[str]]
    ) -> None:
        """Call `write`, after a prompt if `doubts` returns the names of doubtful values."""
        names = doubts()
        if not names:
            write()
            return
        text = tr(
            "{0}: beyond a limit that no document confirms (inferred). The board may reject "
            "the value or store a different value."
        )
        answer = Answer("writeAnyway", tr("Write an&yway"), write)
        self.prompt(text.format(", ".join(names)), answer, is_valid=lambda: doubts() == names)


class ChangesDialog(ReusedDialog):
    """Modeless dialog with a table of changes, a primary button and a stop button."""

    def __init__(
        self,
        device: Device,
        parent: QWidget,
        *,
        names: Names,
        describe: Callable[[TickedOf], Changes | None],
        on_action: Callable[[Rows], object],
        refresh_on: Sequence[SignalInstance] = (),
        above: QWidget | None = None,
    ) -> None:
        """Create the dialog.

        `describe` returns the content, or `None` to close the dialog. It is called when the dialog
        opens, when a row is checked or unchecked, and while the dialog is visible, when a signal
        in `refresh_on` is emitted. The primary button calls `on_action` with the checked rows.
        `above` is a widget above the rows.
        """
        super().__init__(parent)
        prefix = names.prefix
        self.setObjectName(names.dialog)
        set_look(self, "sheet")
        resize_with_font(self, _WIDTH, 1)
        self._describe = describe
        self._on_action = on_action
        self._is_rendering = False

        self._heading = named(Note(1, self), f"{prefix}Head")
        set_style_property(self._heading, "textSize", "title")
        self._caption = label(self, f"{prefix}Caption", wrap=True, size="caption")
        self._problem = named(Note(0, self), f"{prefix}Trouble")
        if above is not None:
            above.setParent(self)  # the Tab order is the order of the children
        self.rows = ComparisonView(self)
        self.findings = FindingsList(prefix, self.rows, self, is_wide=True)
        self._findings_area = ScrollBox(self.findings, self)
        set_look(self._findings_area, "inset")
        policy = QSizePolicy.Policy  # with stretch factors, Qt would ignore the size hints
        self.rows.setSizePolicy(policy.Preferred, policy.Expanding)
        self._findings_area.setSizePolicy(policy.Preferred, policy.Maximum)
        self.question = named(Question(self), f"{prefix}Question")
        message_space = MessageSpace(self, self.question)
        bar = MotorBar(device, f"{prefix}StopButton", self)
        self._close = button(self, names.close, on_click=self.close)
        self.action = button(self, names.action, confirms=True, on_click=self._on_action_clicked)
        self._bar = bar.fill(bar.armed, 1, self._close, self.action)
        if (layout := self.findings.layout()) is not None:
            layout.setContentsMargins(14, 10, 14, 10)
        self._parts = column(
            column(self._heading, self._caption, margins=0, spacing=4),
            self._problem,
            *([above] if above is not None else []),
            self.rows,
            self._findings_area,
            message_space,
            margins=(_AROUND_BUTTONS, 0, _AROUND_BUTTONS, 0),
            spacing=14,
        )
        side = _MARGIN - _AROUND_BUTTONS
        self._all = column(
            (self._parts, 1), bar, into=self, margins=(side, _MARGIN, side, side), spacing=0
        )
        self.rows.ticked_changed.connect(self.refresh)
        for changed in refresh_on:
            changed.connect(self._on_changed)

    def add_above_buttons(self, part: QWidget) -> None:
        self._insert(self._parts, self._parts.count() - 1, part)

    def add_beside_buttons(self, part: QWidget, stretch: int = 0) -> None:
        self._insert(self._bar, self._bar.indexOf(self._close), part, stretch)

    def _insert(self, into: QBoxLayout, index: int, part: QWidget, stretch: int = 0) -> None:
        into.insertWidget(index, part, stretch)
        above, beside = (
            [
                widget
                for i in range(layout.count())
                if (item := layout.itemAt(i)) and (widget := item.widget())
            ]
            for layout in (self._parts, self._bar)
        )
        tab_order(*above, self.question, *beside)

    @property
    def ticked(self) -> Rows:
        return self.rows.table.ticked

    def reset_and_show(self) -> None:
        self.rows.show_nothing()
        self.refresh()
        self.show_in_front()

    def show_problem(self, text: str) -> None:
        """Show the error of an action until the next refresh."""
        self._problem.show_note(text, alarming=True)

    @Slot()
    def _on_changed(self) -> None:
        if self.isVisible():
            self.refresh()

    @Slot()
    def refresh(self) -> None:
        if self._is_rendering:
            return
        self._is_rendering = True
        try:
            changes = self._describe(self.rows.table.ticked_of)
            if changes is not None:
                self._render(changes)
        finally:
            self._is_rendering = False
        if changes is None:
            self.close()

    def _render(self, changes: Changes) -> None:
        self.setWindowTitle(changes.heading.rstrip("."))
        self._heading.show_note(changes.heading, alarming=changes.has_failed)
        self._caption.setText(changes.caption)
        self._caption.setVisible(bool(changes.caption))
        self._problem.show_note(changes.problem, alarming=True)
        if changes.rows is not None:
            self.rows.show_comparison(
                changes.rows,
                *changes.sides,
                with_ticks=changes.with_ticks,
                outcomes=changes.outcomes,
                summary=changes.summary,
            )
        self.rows.setVisible(changes.rows is not None)
        self.findings.show_findings(changes.remarks)
        self.findings.set_can_accept(changes.can_accept)
        self._findings_area.setVisible(bool(changes.remarks))
        self.action.setText(changes.action or self.action.text())
        if not changes.action and not self.action.isHidden():
            self._close.setFocus()  # otherwise the focus would move to `Details`
        self.action.setVisible(bool(changes.action))
        self.action.setEnabled(changes.can_act)
        is_primary = bool(changes.action) and changes.can_act and not changes.is_close_default
        self.action.setDefault(is_primary)
        set_look(self.action, "primary" if bool(changes.action) and changes.can_act else "")
        self._close.setText(changes.close or tr("Cancel"))
        self._close.setDefault(not is_primary)
        set_look(self._close, "" if changes.action else "primary")
        self.question.reconsider()

    @Slot()
    def _on_action_clicked(self) -> None:
        self._on_action(self.ticked)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        center = self.geometry().center()
        for _ in range(2):  # the first pass determines the width of the rows
            self.resize(self.width(), 1)
            self.fit()
        geometry = self.geometry()
        geometry.moveCenter(center)
        self._move_to(geometry)

    def fit(self) -> None:
        self._findings_area.updateGeometry()
        self._all.activate()
        geometry = self.geometry()
        height = self._all.totalHeightForWidth(geometry.width())
        geometry.setHeight(max(geometry.height(), height))
        self._move_to(geometry)

    def _move_to(self, geometry: QRect) -> None:
        screen = QGuiApplication.screenAt(geometry.center()) or self.screen()
        self.setGeometry(fitted(geometry, screen.availableGeometry()))
