"""What the very first start shows: three ways to begin."""

from collections.abc import Callable

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.theme.theme import follow_theme, scaled_font
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Muted

_SHOWN = "start/welcomed"


def is_first_start() -> bool:
    """Whether the welcome was never shown, nor was a window closed here."""
    store = Preferences()
    return not store.flag(_SHOWN, default=False) and store.data("window/state").isEmpty()


class Welcome(QWidget):
    """Offers to connect a board, to find it, and to try the demo."""

    connect_chosen = Signal()

    def __init__(
        self,
        about: str,
        find: Callable[[], object],
        demo: Callable[[], object],
        parent: QWidget | None = None,
    ) -> None:
        """`about` says what the program is for, and what is needed."""
        super().__init__(parent)
        self.setObjectName("welcome")
        title = ui.label(self, "welcomeTitle", tr("Welcome to TReX Studio"))
        follow_theme(title, "font", lambda: title.setFont(scaled_font(self.font(), 1.6)))
        choices = ui.grid(margins=0, spacing=(16, 12), stretch=[(1, 1)])
        for row, (name, text, icon, act, meaning) in enumerate(
            (
                (
                    "welcomeConnect",
                    tr("Connect my &board"),
                    "connect",
                    self.connect_chosen.emit,
                    tr("Shows the wiring for your adapter or receiver, then connects."),
                ),
                (
                    "welcomeFind",
                    tr("Find &my board…"),
                    "find",
                    find,
                    tr(
                        "The board is wired, but you do not know its port or its serial settings. "
                        "The search moves no motor of a TReX."
                    ),
                ),
                (
                    "welcomeDemo",
                    tr("&Try the demo"),
                    "run",
                    demo,
                    tr("A simulated board: nothing can be damaged."),
                ),
            )
        ):
            button = ui.button(self, name, text, icon=icon, tip=meaning, on_click=act)
            choices.addWidget(button, row, 0)
            choices.addWidget(Muted(meaning, self), row, 1, Qt.AlignmentFlag.AlignVCenter)
        ui.column(
            title,
            ui.label(self, "welcomeText", about, wrap=True),
            choices,
            into=self,
            margins=(0, 24, 0, 0),
            spacing=20,
        )

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        Preferences().set(_SHOWN, True)
