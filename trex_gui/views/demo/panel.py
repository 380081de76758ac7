"""The dockable panel of the Demo TReX: a board in software that can be handled like a real one."""

from itertools import pairwise

from PySide6.QtCore import QSettings, Qt, Signal, Slot
from PySide6.QtGui import QCloseEvent, QHideEvent, QShowEvent
from PySide6.QtWidgets import (
    QDockWidget,
    QFrame,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from trex_gui.model.connector import Connector
from trex_gui.model.demo_snapshot import DemoSnapshot
from trex_gui.views.demo.cable import DemoCable
from trex_gui.views.demo.inputs import DemoInputs
from trex_gui.views.demo.motors import DemoMotors
from trex_gui.views.demo.supply import DemoSupply
from trex_gui.views.demo.words import led_meaning, led_patterns, state_text
from trex_gui.views.icons import set_icon
from trex_gui.views.widgets.leds import Leds
from trex_gui.views.widgets.note import Note

_WANTED = "demo_panel/wanted"


class DemoPanel(QDockWidget):
    """There while the simulated board is in use, unless its user has closed it.

    Signals:
        wanted_changed: `wanted`.
    """

    wanted_changed = Signal(bool)

    def __init__(self, connector: Connector, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("demoPanel")
        self.setWindowTitle(self.tr("Demo TReX"))
        self._connector = connector
        self._store = QSettings(self)
        self._width = self._width_before = 0
        self._wanted = self._store.value(_WANTED, "true") in {True, "true"}

        self._board = DemoBoardView(connector, self)
        scroll = QScrollArea(self)
        scroll.setFrameShape(QFrame.Shape.NoFrame)
        scroll.setWidgetResizable(True)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        scroll.setWidget(self._board)
        bar = scroll.verticalScrollBar().sizeHint().width()
        scroll.setMinimumWidth(self._board.minimumSizeHint().width() + bar)
        self.setWidget(scroll)

        connector.demo_changed.connect(self.show_if_wanted)
        self.hide()

    @property
    def wanted(self) -> bool:
        """Whether its user wants to see it, the simulated board being in use."""
        return self._wanted

    def set_wanted(self, wanted: bool) -> None:
        """Want it, or not, now and the next time."""
        if wanted != self._wanted:
            self._wanted = wanted
            self._store.setValue(_WANTED, wanted)
            self.wanted_changed.emit(wanted)
        self.show_if_wanted()

    @Slot()
    def toggle(self) -> None:
        """Want it if it was not wanted, and the other way round."""
        self.set_wanted(not self._wanted)

    @Slot()
    def show_if_wanted(self) -> None:
        """Be there, or not; the window makes room, and takes it back."""
        there = self._wanted and self._connector.demo_in_use
        if there and self.isHidden():
            self._make_room()
            self.show()
        elif not there and not self.isHidden():
            self.leave()

    def leave(self) -> None:
        """Hide; the window is as wide as before, unless its user has given it another width.

        To be called before the window's geometry is saved, too. A floating panel would even
        outlive the window.
        """
        window = self.parentWidget()
        unchanged = window is not None and window.width() in {
            self._width,
            window.minimumSizeHint().width(),
        }
        self.hide()
        if window is not None and unchanged and self._width_before:
            if layout := window.layout():
                layout.activate()
            window.resize(self._width_before, window.height())
        self._width_before = 0

    def _make_room(self) -> None:
        """Widen the window so that the pages keep their width, as far as the screen goes."""
        window = self.parentWidget()
        if window is None or self.isFloating() or not window.isVisible() or window.isMaximized():
            return
        free = window.screen().availableGeometry().right() - window.frameGeometry().right()
        self._width_before = window.width()
        self._width = window.width() + max(min(self.sizeHint().width(), free), 0)
        window.resize(self._width, window.height())

    def closeEvent(self, event: QCloseEvent) -> None:
        super().closeEvent(event)
        self.set_wanted(False)


class DemoBoardView(QWidget):
    """The board itself: LEDs, switches, sticks, motors, cable."""

    def __init__(self, connector: Connector, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._connector = connector
        self._board = connector.demo_board
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)

        self._leds = Leds(self)
        self._leds.setObjectName("demoLeds")
        self._leds.setAccessibleName(self.tr("LEDs of the board"))
        self._state = Note(2, self)
        self._state.setObjectName("demoState")
        self._supply = DemoSupply(self._board, self)
        self._inputs = DemoInputs(self._board, self)
        self._motors = DemoMotors(self._board, self)
        self._cable = DemoCable(self._board, self)
        self._factory = QPushButton(self.tr("Factory state"), self)
        self._factory.setObjectName("demoFactory")
        self._factory.setToolTip(
            self.tr("As new: stored settings, jumpers, sticks, loads and a quiet line")
        )
        set_icon(self._factory, "reload")
        self._groups = (self._supply, self._inputs, self._motors, self._cable)

        layout = QVBoxLayout(self)
        layout.setContentsMargins(6, 6, 6, 6)
        layout.setSpacing(6)
        layout.addWidget(self._leds)
        layout.addWidget(self._state)
        for group in self._groups:
            layout.addWidget(group)
        layout.addWidget(self._factory, 0, Qt.AlignmentFlag.AlignRight)
        layout.addStretch(1)
        controls = [control for group in self._groups for control in group.controls()]
        for control, following in pairwise([*controls, self._factory]):
            QWidget.setTabOrder(control, following)

        self._factory.clicked.connect(self._board.restore_factory)
        self._board.changed.connect(self._on_changed)
        connector.port_changed.connect(self._on_changed)
        self._on_changed()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._board.watch(True)
        self._on_changed()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._board.watch(False)

    @Slot()
    def _on_changed(self) -> None:
        snapshot = self._board.snapshot
        for group in (*self._groups, self._factory):
            group.setEnabled(snapshot is not None)
        if snapshot is None:
            self._leds.show_patterns(("off", "off"), ("", ""), ("", ""))
            starts = self._connector.starting or self._connector.port is not None
            self._state.show_note(
                self.tr("The simulated board is being started …")
                if starts
                else self.tr("The simulated board does not run. Press Connect."),
                alarming=not starts,
            )
            return
        red, green = led_patterns(snapshot)
        self._leds.show_patterns(
            (snapshot.leds.red, snapshot.leds.green),
            (red, green),
            (led_meaning(snapshot, red), led_meaning(snapshot, green)),
        )
        todo = self._todo(snapshot)
        self._state.show_note(todo or state_text(snapshot), alarming=bool(todo))
        for group in self._groups:
            group.show_snapshot(snapshot)

    def _todo(self, snapshot: DemoSnapshot) -> str:
        """Say what is to be done before board and program can talk again."""
        if not snapshot.line.plugged:
            return self.tr("The cable is out. Tick “Plugged in”, then press Connect.")
        if self._connector.demo_in_use and self._connector.port is None:
            if not snapshot.power:
                return self.tr("The power is off. Switch it on, then press Connect.")
            return self.tr("The cable is in again. Press Connect.")
        return ""
