"""A box to type a speed in, which sends nothing that was not entered."""

from PySide6.QtCore import QEvent, QSignalBlocker, Qt, Signal, Slot
from PySide6.QtGui import QFocusEvent, QHideEvent, QKeyEvent
from PySide6.QtWidgets import QSpinBox, QWidget


class SpeedEntry(QSpinBox):
    """Asks for a speed on Enter and on steps.

    Qt's own box takes a half-typed number, too, when it loses the focus or is hidden: a motor
    would start because a person looked at another page. Here the number is given up, and the
    speed in force comes back.

    Signals:
        chosen: the speed that a person entered or stepped to.
    """

    chosen = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._wish = 0
        self._is_typed = False
        self.setKeyboardTracking(False)
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

        self.lineEdit().textEdited.connect(self._on_edited)
        self.valueChanged.connect(self._on_value_changed)

    def set_limits(self, lowest: int, highest: int) -> None:
        """Offer these speeds; a half-typed number is given up when they are others."""
        if (lowest, highest) != (self.minimum(), self.maximum()):
            with QSignalBlocker(self):
                self.setRange(lowest, highest)
            self.put(self._wish)

    def show_wish(self, speed: int) -> None:
        """Show the speed in force, now or when no half-typed number is in the box any more."""
        self._wish = speed
        if not self._is_typed:
            self.put(speed)

    def put(self, speed: int) -> None:
        """Show a speed, whatever was typed, without asking for it."""
        self._wish = speed
        self._is_typed = False
        with QSignalBlocker(self):
            self.setValue(speed)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        is_entered = event.key() in {Qt.Key.Key_Return, Qt.Key.Key_Enter}
        is_meant = is_entered and self._is_typed and self.hasAcceptableInput()
        super().keyPressEvent(event)
        if is_meant and self._is_typed:  # the number that was there before: Qt is silent
            self._on_value_changed(self.value())
        elif is_entered:
            self.put(self._wish)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self.put(self._wish)
        super().focusOutEvent(event)

    def hideEvent(self, event: QHideEvent) -> None:
        self.put(self._wish)
        super().hideEvent(event)

    def event(self, event: QEvent) -> bool:
        if event.type() in {QEvent.Type.WindowDeactivate, QEvent.Type.Close}:
            self.put(self._wish)
        return super().event(event)

    @Slot()
    def _on_edited(self) -> None:
        self._is_typed = True

    @Slot(int)
    def _on_value_changed(self, speed: int) -> None:
        self._wish = speed
        self._is_typed = False
        self.chosen.emit(speed)
