"""Labels: notes, elided and muted text, page headers, signs, legend keys."""

from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import (
    QAccessible,
    QAccessibleAnnouncementEvent,
    QFontMetrics,
    QPainter,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QLabel, QLayout, QSizePolicy, QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.theme.icons import set_sign
from trex_gui.ui.theme.theme import (
    follow_theme,
    scaled_font,
    set_style_property,
    set_text_color,
    theme,
)
from trex_gui.ui.widgets.accessible import Spoken
from trex_gui.ui.widgets.builders import column, named, plain, row, set_bold
from trex_gui.ui.widgets.painted import never_mirror

_SIGN_PADDING = 2  # pixels added to the line height
PAGE_MARGINS = 16, 12, 16, 12  # pixels around a page with a `PageHead`
_TITLE_SIZE = 1.6  # relative to the font size
_LONG_TITLE = 48  # characters


class Note(QLabel):
    """Wrapped text with space for `lines` lines. With 0 lines, an empty note is hidden."""

    def __init__(self, lines: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._hides = lines == 0
        if self._hides:
            self.hide()
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Minimum)
        follow_theme(
            self, "space", lambda: self.setMinimumHeight(lines * self.fontMetrics().lineSpacing())
        )

    def show_note(self, text: str, *, alarming: bool = False, color: str = "warning") -> None:
        """Show a text. An alarming text is bold, in the theme colour `color`."""
        if self.text() != text:
            self.setText(text)
        if self._hides:
            self.setVisible(bool(text))
        set_bold(self, alarming)
        set_text_color(self, color if alarming else "")


class ElidedLabel(QLabel):
    """Elided plain text with a tool tip. The label is never narrower than the text `at_least`."""

    def __init__(self, at_least: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._at_least = at_least
        self.setTextFormat(Qt.TextFormat.PlainText)

    def show_text(self, text: str) -> None:
        if text != self.text():
            self.setText(text)
            self.setToolTip(plain(text))

    def minimumSizeHint(self) -> QSize:
        if self.wordWrap():
            return super().minimumSizeHint()
        hint = self.sizeHint()
        minimum = self.fontMetrics().horizontalAdvance(self._at_least)
        return QSize(min(hint.width(), minimum), hint.height())

    def paintEvent(self, event: QPaintEvent) -> None:
        if self.wordWrap():
            super().paintEvent(event)
            return
        rect = self.contentsRect()
        text = self.fontMetrics().elidedText(self.text(), Qt.TextElideMode.ElideRight, rect.width())
        enabled, role = self.isEnabled(), self.foregroundRole()
        with QPainter(self) as painter:
            self.style().drawItemText(
                painter, rect, self.alignment(), self.palette(), enabled, text, role
            )


class Sign(QLabel):
    """Small icon that follows the theme. Without an icon, the sign takes the same space."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        follow_theme(self, "space", self._update_space)

    def _update_space(self) -> None:
        side = self.fontMetrics().height() + _SIGN_PADDING
        self.setFixedSize(side, side)

    def show_sign(self, name: str, color: str = "icon") -> None:
        spoken = {
            "error": tr("Error"),
            "info": tr("Information"),
            "ok": tr("OK"),
            "run": tr("Now"),
            "todo": tr("Not done"),
            "warning": tr("Warning"),
        }
        self.setAccessibleName(spoken.get(name, ""))
        if name:
            set_sign(self, name, color, _SIGN_PADDING)
        else:
            follow_theme(self, "sign", self.clear)


class LinkLabel(QLabel):
    """Wrapped text with links. Tab visits and announces each link."""

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setTextFormat(Qt.TextFormat.RichText)
        self.setObjectName(name)
        self.setWordWrap(True)
        self.setTextInteractionFlags(
            Qt.TextInteractionFlag.LinksAccessibleByMouse
            | Qt.TextInteractionFlag.LinksAccessibleByKeyboard
        )

    def focusNextPrevChild(self, forward: bool) -> bool:
        moved = super().focusNextPrevChild(forward)
        if moved and self.hasSelectedText():  # Tab selects the link
            announcement = QAccessibleAnnouncementEvent(self, self.selectedText())
            QAccessible.updateAccessibility(announcement)
        return moved


class LiveLabel(QLabel, Spoken):
    """Label of a live value. Screen readers read its accessible name and its text.

    A plain label would send an event for every new text, or hide its text behind an accessible
    name.
    """

    spoken_role = QAccessible.Role.StaticText

    def __init__(self, name: str, accessible: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setTextFormat(Qt.TextFormat.PlainText)
        never_mirror(self)
        self.setObjectName(name)
        self.setAccessibleName(accessible)

    def spoken_name(self) -> str:
        return tr("{0}: {1}").format(self.accessibleName(), self.text())


class Muted(QLabel):
    def __init__(self, text: str = "", parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setText(text)
        set_text_color(self, "muted")


class PageHead(QWidget):
    """Header of a page: its title, a line about its state, and its controls."""

    def __init__(self, title: str, parent: QWidget, *controls: QWidget | QLayout) -> None:
        super().__init__(parent)
        self.title = ElidedLabel("", self)
        self._state = named(ElidedLabel("", self), "pageState")
        self.show_title(title)
        set_style_property(self._state, "textSize", "caption")
        self.sign = Sign(self)  # beside the title
        heading = row(self.title, self.sign, 1, margins=0)
        texts = column(heading, self._state, margins=0, spacing=2)
        row((texts, 1), *controls, into=self, margins=0)

    def show_title(self, text: str) -> None:
        """Show a title. A long title has a smaller font but takes the same height."""
        self.title.show_text(text)
        large = QFontMetrics(scaled_font(self.font(), _TITLE_SIZE))
        self.title.setFixedHeight(large.height() + 2)
        is_long = len(text) > _LONG_TITLE
        set_style_property(self.title, "textSize", "heading" if is_long else "title")

    def show_state(self, text: str) -> None:
        self._state.show_text(text)


class LegendKey(ElidedLabel):
    """Sample and name of a curve. `style`: pen of the sample, or `None` for a dot.

    The name is elided only if the size policy ignores the width of the label.
    """

    def __init__(
        self,
        text: str,
        color: str,
        parent: QWidget,
        style: Qt.PenStyle | None = Qt.PenStyle.SolidLine,
    ) -> None:
        super().__init__("", parent)
        self.setText(text)
        self._color = color
        self._style = style
        follow_theme(self, "space", self._update_space)

    def _update_space(self) -> None:
        self._sample = self.fontMetrics().averageCharWidth() * 3
        self.setContentsMargins(16 if self._style is None else self._sample * 4 // 3, 0, 0, 0)
        self.update()

    def minimumSizeHint(self) -> QSize:
        return self.sizeHint()

    def set_color(self, color: str) -> None:
        if color != self._color:
            self._color = color
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        color, middle = theme().color(self._color), self.height() // 2
        with QPainter(self) as painter:
            if self._style is None:
                painter.setRenderHint(QPainter.RenderHint.Antialiasing)
                painter.setPen(Qt.PenStyle.NoPen)
                painter.setBrush(color)
                painter.drawEllipse(QPointF(6, middle), 5, 5)
            else:
                painter.setPen(QPen(color, 2, self._style))
                painter.drawLine(0, middle, self._sample, middle)
