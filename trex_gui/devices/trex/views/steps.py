"""Dialog for tasks with several steps."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import partial

from PySide6.QtCore import QObject, QSize, Qt, Signal, Slot
from PySide6.QtGui import QHideEvent, QResizeEvent
from PySide6.QtWidgets import QAbstractButton, QBoxLayout, QPushButton, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.views.motor_controls import MotorBar
from trex_gui.ui.theme.theme import set_look
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import ConfirmButton, ReusedDialog, reserve_space
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.placement import resize_with_font
from trex_gui.ui.widgets.scroll_box import ScrollBox
from trex_gui.ui.widgets.step_strip import StepStrip

_GAP = 16  # pixels


class Page(QWidget):
    """Page of a step. `side` is the content of the card beside the page."""

    def __init__(self, name: str, heading: str = "") -> None:
        super().__init__()
        self.setObjectName(name)
        self.heading = heading
        self.side = QWidget(self)
        self.side.hide()

    def refresh(self) -> None:
        """Update the page. The dialog calls this when it shows the page and after each change."""


@dataclass(frozen=True, slots=True)
class FlowState:
    """Visible state of the dialog. The Next button is hidden if its text is empty."""

    title: str  # title of the task
    titles: Sequence[str]  # titles of all steps
    current: int  # index of the current step
    page: Page
    note: str = ""  # text below `page.side`
    is_alarming: bool = False
    undone: Collection[str] = ()  # titles of incomplete steps, even of steps still ahead
    next: str = ""
    may_go_on: bool = True
    may_go_back: bool = False
    may_skip: bool = False
    is_close_primary: bool = False
    close: str = ""


class Flow(QObject):
    changed = Signal()
    opened = Signal(bool)  # true if the dialog must be activated
    closed = Signal()  # the task has ended

    name = ""  # prefix of the object names
    size = 1040, 600  # size of the dialog in pixels

    def show_in_front(self) -> None:
        self.opened.emit(True)

    def add_buttons(self, parent: QWidget) -> Sequence[QPushButton]:
        """Create buttons in addition to Back, Skip and Next."""
        del parent
        return ()

    def state(self) -> FlowState:
        raise NotImplementedError

    def back(self) -> None: ...

    def skip(self) -> None: ...

    def next(self) -> None: ...

    def on_hidden(self, *, closed: bool) -> None:
        """Stop actions that need a visible dialog. `closed` is false for a minimized dialog."""


class _Body(QWidget):
    def __init__(self, name: str, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName(f"{name}Body")
        self.drawing, self.side = ui.Card("", self), ui.Card("", self)
        self.note = ui.named(Note(1, self), f"{name}Note")
        self._drawing = ui.column(into=self.drawing)
        self._side = ui.column((self.note, 1), into=self.side)
        self._row = ui.row((self.drawing, 5), (self.side, 3), into=self, margins=0, spacing=_GAP)
        self._page: Page | None = None

    def show_page(self, page: Page) -> bool:
        """Show a page. Return false if the page was already visible."""
        if page is self._page:
            return False
        if self._drawing.indexOf(page) < 0:
            self._drawing.addWidget(page, 1)
            self._side.insertWidget(0, page.side)
        if self._page is not None:
            self._page.hide()
            self._page.side.hide()
        page.show()
        page.side.show()
        self._page = page
        self.drawing.setTitle(page.heading)
        return True

    def show_note(self, text: str, *, alarming: bool) -> None:
        self.note.show_note(text, alarming=alarming)
        has_side = self._page is not None and self._page.side.layout() is not None
        self.side.setVisible(has_side or bool(text))

    def minimumSizeHint(self) -> QSize:
        return QSize(max(self._widths()), super().minimumSizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        direction = QBoxLayout.Direction
        is_wide = self.width() >= sum(self._widths()) + _GAP
        self._row.setDirection(direction.LeftToRight if is_wide else direction.TopToBottom)
        self._row.setStretch(1, 3 if is_wide else 0)

    def _widths(self) -> tuple[int, int]:
        side = self.side.minimumSizeHint().width() if self.side.isVisibleTo(self) else 0
        return self.drawing.minimumSizeHint().width(), side


class Steps(ReusedDialog):
    stays_on_stop = True  # a stop must not discard answers or measurements

    def __init__(self, device: Device, flow: Flow, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.flow = flow
        flow.setParent(self)
        name = flow.name
        self.setObjectName(f"{name}Dialog")
        resize_with_font(self, *flow.size)
        self._title = ui.label(self, size="title")
        self._strip = StepStrip(self)
        self._body = _Body(name, self)
        self._scroll_box = ScrollBox(self._body, self)
        bar = self._bar = MotorBar(device, f"{name}StopButton", self)
        extras = flow.add_buttons(bar)
        self._close = ui.button(
            bar, f"{name}CloseButton", tr("Close"), default=False, on_click=self.close
        )
        self._step_buttons = QWidget(bar)
        button = partial(ui.button, self._step_buttons, default=False)
        self._back = button(f"{name}BackButton", tr("&Back"), on_click=flow.back)
        skip_tip = tr("Go on without the changes of this step")
        self._skip = button(f"{name}SkipButton", tr("S&kip"), tip=skip_tip, on_click=flow.skip)
        self._next = ui.button(
            self._step_buttons, f"{name}NextButton", default=True, confirms=True, on_click=flow.next
        )
        # Buttons must not move: a second click could hit another button.
        for step_button in (self._back, self._skip, self._next):
            reserve_space(step_button)
        ui.row(self._back, self._skip, self._next, into=self._step_buttons, margins=0)
        bar.fill(*extras, bar.armed, 1, self._close, self._step_buttons)
        margins = (_GAP, _GAP, _GAP, 8)
        items = self._title, self._strip, (self._scroll_box, 1), bar
        ui.column(*items, into=self, margins=margins, spacing=12)

        flow.changed.connect(self._on_changed)
        flow.opened.connect(self._on_opened)
        flow.closed.connect(self.hide)
        device.link_changed.connect(self._on_changed)

    def setVisible(self, visible: bool) -> None:
        if visible:
            self._show(self.flow.state())
        super().setVisible(visible)

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self.flow.on_hidden(closed=not event.spontaneous())

    @Slot(bool)
    def _on_opened(self, activates: bool) -> None:
        if activates:
            self.show_in_front()
        else:
            self.setAttribute(Qt.WidgetAttribute.WA_ShowWithoutActivating)
            self.show()
            self.setAttribute(Qt.WidgetAttribute.WA_ShowWithoutActivating, False)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        if self.isVisible():
            self._show(self.flow.state())

    def _show(self, state: FlowState) -> None:
        self.setWindowTitle(state.title)
        self._title.setText(state.title)
        self._strip.show_steps(state.titles, state.current, state.undone)
        focused, step_buttons = self.focusWidget(), (self._back, self._skip, self._next)
        is_new = self._body.show_page(state.page)
        state.page.refresh()
        if is_new:
            ui.tab_order(self._bar.stop, self._body, self._bar.stop)
        self._body.show_note(state.note, alarming=state.is_alarming)
        self._back.setVisible(state.may_go_back)
        self._back.setEnabled(state.may_go_back)
        self._skip.setVisible(state.may_skip)
        self._close.setText(state.close or tr("Close"))
        self._show_next(state)
        self._step_buttons.setVisible(bool(state.next) or state.may_go_back or state.may_skip)
        self._close.setDefault(state.is_close_primary)
        set_look(self._close, "primary" if state.is_close_primary else "")
        may_move_focus = focused in {None, self, *step_buttons} and not (
            isinstance(focused, QAbstractButton) and self._is_usable(focused)
        )
        if may_move_focus or (is_new and focused not in step_buttons):
            # Enter must not press Close while Next is disabled. If the note is alarming, it may
            # press Skip.
            skip = [self._skip] if state.is_alarming else []
            buttons = [self._close] if state.is_close_primary else [self._next, *skip]
            fallback = state.page.focusProxy() or self
            usable = (button for button in buttons if self._is_usable(button))
            next(usable, fallback).setFocus()

    def _show_next(self, state: FlowState) -> None:
        text_changes = state.next != self._next.text() and self._next.isVisible()
        self._next.setVisible(bool(state.next))
        self._next.setText(state.next or tr("&Next"))
        self._next.setEnabled(state.may_go_on)
        self._next.setDefault(bool(state.next))
        if text_changes and isinstance(self._next, ConfirmButton):
            self._next.hold_off()

    def _is_usable(self, button: QAbstractButton) -> bool:
        return button.isVisibleTo(self) and button.isEnabled()
