"""The dockable panel of the Demo TReX: a board in software that can be handled like a real one."""

from PySide6.QtWidgets import QPushButton, QWidget

from trex_gui.devices.trex.model.controller import TrexController
from trex_gui.devices.trex.model.demo.snapshot import DemoSnapshot
from trex_gui.devices.trex.views.demo.board_cable import DemoCable
from trex_gui.devices.trex.views.demo.inputs import DemoInputs
from trex_gui.devices.trex.views.demo.motors import DemoMotors
from trex_gui.devices.trex.views.demo.supply import DemoSupply
from trex_gui.devices.trex.views.demo.words import led_meaning, led_patterns, state_text
from trex_gui.ui.devices.demo.dock import DemoDock
from trex_gui.ui.devices.demo.view import DemoPanelBody
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.widgets.leds import Leds


class DemoPanel(DemoDock):
    """The dock of the simulated TReX."""

    def __init__(self, controller: TrexController, parent: QWidget | None = None) -> None:
        super().__init__("demoPanel", "demo_panel/wanted", controller, parent)
        self.setWindowTitle(self.tr("Demo TReX"))
        self.hold(DemoBoardView(controller, self))
        controller.changed.connect(self.show_if_wanted)


class DemoBoardView(DemoPanelBody[DemoSnapshot]):
    """The board itself: LEDs, switches, sticks, motors, cable."""

    def __init__(self, controller: TrexController, parent: QWidget | None = None) -> None:
        board = controller.demo_board
        super().__init__(board, controller, "demoState", parent)
        self._leds = Leds(self)
        self._leds.setObjectName("demoLeds")
        self._leds.setAccessibleName(self.tr("LEDs of the board"))
        factory = QPushButton(self.tr("Factory state"), self)
        factory.setObjectName("demoFactory")
        factory.setToolTip(
            self.tr("As new: stored settings, jumpers, sticks, loads and a quiet line")
        )
        set_icon(factory, "reload")

        groups = (
            DemoSupply(board, self),
            DemoInputs(board, self),
            DemoMotors(board, self),
            DemoCable(board, self),
        )
        self.arrange(self._leds, groups, factory)

        factory.clicked.connect(board.restore_factory)
        controller.changed.connect(self.renew)

    def absent_text(self, *, starts: bool) -> str:
        """Say that the board does not run, or that it is being started."""
        if starts:
            return self.tr("The simulated board is being started …")
        return self.tr("The simulated board does not run. Press Connect.")

    def state_text(self, snapshot: DemoSnapshot) -> str:
        """Say what the board does, and what it waits for."""
        return state_text(snapshot)

    def show_head(self, snapshot: DemoSnapshot | None) -> None:
        """Show the LEDs of the board."""
        if snapshot is None:
            self._leds.show_patterns(("off", "off"), ("", ""), ("", ""))
            return
        red, green = led_patterns(snapshot)
        self._leds.show_patterns(
            (snapshot.leds.red, snapshot.leds.green),
            (red, green),
            (led_meaning(snapshot, red), led_meaning(snapshot, green)),
        )
