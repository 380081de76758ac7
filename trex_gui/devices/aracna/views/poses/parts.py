"""Buttons and fields that look alike in every part of the panel."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QSpinBox, QToolButton, QWidget

from trex_gui.ui.theme.icons import set_icon


def spin_box(parent: QWidget, name: str, accessible: str) -> QSpinBox:
    """Return a number that is taken when it is complete; the wheel needs the focus."""
    box = QSpinBox(parent)
    box.setObjectName(name)
    box.setAccessibleName(accessible)
    box.setKeyboardTracking(False)
    box.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    return box


def tool_button(parent: QWidget, name: str, text: str, tip: str, icon: str = "") -> QToolButton:
    """Return a small button that the keyboard reaches."""
    button = QToolButton(parent)
    button.setObjectName(name)
    button.setText(text)
    button.setAccessibleName(tip)
    button.setToolTip(tip)
    button.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    if icon:
        set_icon(button, icon)
        if text:
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
    return button


def arrow_button(parent: QWidget, name: str, tip: str, arrow: Qt.ArrowType) -> QToolButton:
    """Return a small button with an arrow."""
    button = tool_button(parent, name, "", tip)
    button.setArrowType(arrow)
    return button


def follow(button: QToolButton, action: QAction) -> None:
    """Let a button do what an action does, and be greyed with it."""
    button.clicked.connect(action.trigger)
    action.changed.connect(lambda: button.setEnabled(action.isEnabled()))
    button.setEnabled(action.isEnabled())
