"""Labels: notes that stand out, text that is cut off, muted text, signs."""

from PySide6.QtCore import QSize, Qt, Slot
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme


class Note(QLabel):
    """Wrapped text that keeps the room of `lines` lines, so that nothing jumps below it."""

    def __init__(self, lines: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._alarming = False
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Minimum)
        self.setMinimumHeight(lines * self.fontMetrics().lineSpacing())
        theme().changed.connect(self._on_theme_changed)

    def show_note(self, text: str, *, alarming: bool = False) -> None:
        """Show a text; an alarming one is bold, in the theme's colour of warnings."""
        if self.text() != text:
            self.setText(text)
        if alarming != self._alarming:
            self._alarming = alarming
            font = self.font()
            font.setBold(alarming)
            self.setFont(font)
            self._on_theme_changed()

    @Slot()
    def _on_theme_changed(self) -> None:
        name = "warning" if self._alarming else "window_text"
        palette = self.palette()
        palette.setColor(self.foregroundRole(), theme().color(name))
        self.setPalette(palette)


class ElidedLabel(QLabel):
    """Plain text whose end may be cut; the tool tip has all of it.

    `at_least` is as much text as always has room.
    """

    def __init__(self, at_least: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._at_least = at_least
        self.setTextFormat(Qt.TextFormat.PlainText)

    def show_text(self, text: str) -> None:
        """Show this, and all of it in the tool tip."""
        if text != self.text():
            self.setText(text)
            self.setToolTip(text)

    def minimumSizeHint(self) -> QSize:
        whole = self.sizeHint()
        least = self.fontMetrics().horizontalAdvance(self._at_least)
        return QSize(min(whole.width(), least), whole.height())

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        rect = self.contentsRect()
        text = self.fontMetrics().elidedText(self.text(), Qt.TextElideMode.ElideRight, rect.width())
        painter = QPainter(self)
        self.style().drawItemText(
            painter,
            rect,
            self.alignment(),
            self.palette(),
            self.isEnabled(),
            text,
            self.foregroundRole(),
        )
        painter.end()


class Sign(QLabel):
    """A small icon that follows the theme; without a name it keeps its room."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._shown = ("", "icon")
        size = self.fontMetrics().height() + 2
        self.setFixedSize(size, size)
        theme().changed.connect(self._on_theme_changed)

    def show_sign(self, name: str, color: str = "icon") -> None:
        """Show an icon in a colour of the theme; an empty name shows none."""
        if (name, color) != self._shown:
            self._shown = (name, color)
            self._on_theme_changed()

    @Slot()
    def _on_theme_changed(self) -> None:
        name, color = self._shown
        if name:
            self.setPixmap(icon(name, color).pixmap(self.size()))
        else:
            self.clear()


class Muted(QLabel):
    """Wrapped text that is there for those who want to know more."""

    def __init__(self, text: str = "", parent: QWidget | None = None) -> None:
        super().__init__(text, parent)
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.PlainText)
        theme().changed.connect(self._on_theme_changed)
        self._on_theme_changed()

    @Slot()
    def _on_theme_changed(self) -> None:
        palette = self.palette()
        palette.setColor(self.foregroundRole(), theme().color("muted"))
        self.setPalette(palette)
