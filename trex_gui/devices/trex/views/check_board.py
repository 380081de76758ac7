"""Dialog for a board that does not respond: what its LEDs mean, and its serial settings."""

from dataclasses import dataclass
from functools import partial

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import QTabWidget, QWidget

from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.views.jumper_sketch import JumperPlaces, JumperSketch
from trex_gui.devices.trex.views.start_texts import ttl_wiring
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.frame.wiring_sketch import WiringSketch
from trex_gui.ui.notifier import ConnectWith
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import ReusedDialog, keep_room
from trex_gui.ui.widgets.labels import Muted, Note
from trex_gui.ui.widgets.leds import Leds
from trex_gui.ui.widgets.placement import resize_with_font
from trex_gui.ui.widgets.scroll_box import ScrollBox
from trex_gui.ui.widgets.step_strip import StepStrip


@dataclass(frozen=True, slots=True)
class _Sight:
    """What the red and the green LED show, what it means, and what to do."""

    leds: tuple[str, str]
    shown: str
    meaning: str
    to_do: str


_SIGHTS = (
    _Sight(
        ("off", "off"),
        tr_noop("Both off"),
        tr_noop("No power"),
        tr_noop(
            "Check the supply and its leads. If only a blue LED is lit, the board has no firmware.",
        ),
    ),
    _Sight(
        ("on", "off"),
        tr_noop("Red on"),
        tr_noop("Running, serial commands control the motors"),
        tr_noop(
            "Compare the wires with the picture, then search with Find. Green lights while the "
            "board receives a command: if it never does, nothing arrives.",
        ),
    ),
    _Sight(
        ("off", "on"),
        tr_noop("Green on, or flashing fast"),
        tr_noop("Running, the channels control the motors"),
        tr_noop(
            "As above: the board responds in RC and analog mode, too. Red lights while it "
            "receives a command. Fast flashes are safe-start; five at the start say which channels "
            "are learned.",
        ),
    ),
    _Sight(
        ("blink 1/s", "blink 1/s"),
        tr_noop("Both blink together, or both on"),
        tr_noop("Learning mode"),
        tr_noop(
            "The board does not respond while it learns its channels. Remove the SO–G jumper, "
            "then switch the board off and on.",
        ),
    ),
    _Sight(
        ("alternate 1/s", "alternate 1/s"),
        tr_noop("Red and green alternate"),
        tr_noop("Waiting for the boot loader hand-shake"),
        tr_noop(
            "Switch the board off, remove the mix and SO–G jumpers, and switch it on. Or go on "
            "with the hand-shake for lost serial settings.",
        ),
    ),
    _Sight(
        ("off", "short flash 1/s"),
        tr_noop("Green flashes once a second"),
        tr_noop("Boot loader, waiting for new firmware"),
        tr_noop("Switch the board off and on, with the jumpers removed."),
    ),
)
"""Ref: the reference's table of LED patterns (guide 4.e, manual pages 10-11, forum 1769, 5011)."""


class SightsPage(QWidget):
    """The LED patterns of a board."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("checkLedsPage")
        rows = ui.grid(margins=0, spacing=(16, 8), stretch=[(1, 1)])
        for number, sight in enumerate(_SIGHTS):
            leds = Leds(self)
            leds.show_patterns(sight.leds, ("", ""), (tr(sight.shown),) * 2)
            shown = ui.label(self, text=tr(sight.shown), wrap=True)
            meaning = ui.label(self, text=tr(sight.meaning), bold=True, wrap=True)
            # Without an alignment: with one, text that wraps would not get its height.
            about = ui.column(meaning, Muted(tr(sight.to_do), self), 1, margins=0, spacing=0)
            rows.addLayout(ui.column(leds, shown, 1, margins=0, spacing=0), number, 0)
            rows.addLayout(about, number, 1)
        rows.setRowStretch(len(_SIGHTS), 1)
        ui.column(rows, into=self, margins=12)


@dataclass(frozen=True, slots=True)
class _Step:
    """One step: what to do, where the jumpers are then, what LEDs show and what arrives."""

    title: str
    to_do: str
    jumpers: tuple[bool, bool, str]  # whether mix and SO–G are on, and which one to move now
    leds: tuple[str, str]
    shown: str
    received: str


_STEPS = (
    _Step(
        tr_noop("Jumpers"),
        tr_noop(
            "Switch the board off. Remove the mode jumper. Put the mix and SO–G jumpers on.",
        ),
        (True, True, "mode"),
        ("off", "off"),
        tr_noop("Both are off."),
        tr_noop("Nothing: the board has no power."),
    ),
    _Step(
        tr_noop("Switch on"),
        tr_noop("Switch the board on."),
        (True, True, ""),
        ("alternate 1/s", "alternate 1/s"),
        tr_noop("Red and green alternate, about once a second."),
        tr_noop("Nothing: the SO–G jumper holds its line to ground."),
    ),
    _Step(
        tr_noop("Mix off"),
        tr_noop("Remove the mix jumper. Leave the power on."),
        (False, True, "mix"),
        ("alternate 4/s", "alternate 4/s"),
        tr_noop("Red and green alternate, four times as fast."),
        tr_noop("Nothing: the SO–G jumper holds its line to ground."),
    ),
    _Step(
        tr_noop("SO–G off"),
        tr_noop("Remove the SO–G jumper. Leave the power on."),
        (False, False, "so_ground"),
        ("off", "short flash 1/s"),
        tr_noop("Green flashes briefly, once a second."),
        tr_noop(
            "The boot loader answers each byte with a question mark. The serial settings should "
            "be those of the factory now.",
        ),
    ),
    _Step(
        tr_noop("Connect"),
        tr_noop(
            "Switch the board off and on, with all three jumpers removed. Then connect at 19200 "
            "baud, without parity and CRC.",
        ),
        (False, False, ""),
        ("on", "off"),
        tr_noop("Five flashes, then red stays on."),
        tr_noop("The TReX responds at the factory settings."),
    ),
)
"""Ref: forum threads 1769 and 4631. Inferred: which settings are restored."""


class HandShakePage(QWidget):
    """One step at a time; the last one ends with a connection."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("handShakePage")
        self._at = 0
        text = tr(
            "Search with Find first: it finds a board at any of its settings. If that fails, "
            "these steps from Pololu's support forum restore the serial settings of the factory "
            "(inferred). One user saw the LEDs alternate for three seconds only, and nothing was "
            "restored: then begin again. Compare the other settings with your last snapshot "
            "afterwards (Ctrl+H)."
        )
        intro = Muted(text, self)
        self._strip = StepStrip(self)
        self._step = _StepView(self)
        button = partial(ui.button, self, default=False)
        self._back = button("handShakeBack", tr("&Back"), on_click=partial(self._go, -1))
        self._next = button("handShakeNext", tr("&Next"), on_click=partial(self._go, 1))
        for each in (self._back, self._next):
            keep_room(each)
        step, buttons = ScrollBox(self._step, self), ui.row(1, self._back, self._next)
        ui.column(intro, self._strip, (step, 1), buttons, into=self, margins=12, spacing=10)
        self.begin()

    def begin(self) -> None:
        self._at = 0
        self._go(0)

    def _go(self, steps: int) -> None:
        self._at += steps
        self._strip.show_steps([tr(step.title) for step in _STEPS], self._at)
        self._step.show_step(_STEPS[self._at])
        self._back.setEnabled(self._at > 0)
        self._next.setEnabled(self._at < len(_STEPS) - 1)


class _StepView(QWidget):
    """What to do in a step, and what shows that it was done."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("handShakeStep")
        self._sketch = JumperSketch(self)
        self._to_do = ui.label(self, "handShakeToDo", wrap=True, bold=True)
        self._leds = Leds(self)
        self._shown = ui.label(self, "handShakeLeds", wrap=True)
        self._received = ui.label(self, "handShakeReceived", wrap=True)
        titles = (tr("What the LEDs show"), tr("What this computer receives"))
        leds, received = (Muted(title, self) for title in titles)
        shown = ui.row(self._leds, (self._shown, 1))
        items = self._to_do, leds, shown, received, self._received, 1
        about = ui.column(*items, margins=0, spacing=8)
        top = Qt.AlignmentFlag.AlignTop
        ui.row((self._sketch, 0, top), (about, 1), into=self, margins=0, spacing=20)

    def show_step(self, step: _Step) -> None:
        self._sketch.show_boards(JumperPlaces(tr("Jumpers"), "", *step.jumpers))
        self._to_do.setText(tr(step.to_do))
        self._leds.show_patterns(step.leds, ("", ""), (tr(step.shown),) * 2)
        self._shown.setText(tr(step.shown))
        self._received.setText(tr(step.received))


class CheckBoardDialog(ReusedDialog):
    """Not modal: it is read beside the board, and Stop stays in reach."""

    connect_requested = Signal(object)  # a `ConnectWith`
    find_requested = Signal()

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("checkBoardDialog")
        self.setWindowTitle(tr("Board does not respond"))
        resize_with_font(self, 860, 560)
        self._device = device
        title = tr("Ways to a board that responds")
        tabs = ui.named(QTabWidget(self), "checkTabs", accessible=title)
        tabs.setDocumentMode(True)  # else its background is brighter than muted text bears
        self._steps = HandShakePage(tabs)
        wires = QWidget(tabs)
        caption = Muted(tr("Mode may also be on: the board responds in every mode."), wires)
        sketch = WiringSketch(ttl_wiring(), "checkWiring", wires)
        ui.column((sketch, 1), caption, into=wires, margins=12)
        tabs.addTab(ScrollBox(SightsPage(tabs), tabs), tr("&What the board shows"))
        tabs.addTab(self._steps, tr("&Lost serial settings"))
        tabs.addTab(wires, tr("W&iring"))
        self._result = ui.named(Note(2, self), "checkResult")
        button = partial(ui.button, self)
        self._find = button("checkFindButton", tr("&Find now"), icon="find", default=True)
        self._connect = button(
            "checkConnectButton",
            tr("&Connect at factory settings"),
            icon="connect",
            default=False,
            tip=tr("19200 baud, without parity and CRC, whatever the device number"),
            on_click=lambda: self.connect_requested.emit(ConnectWith(ConnectionSettings(""))),
        )
        close = button("checkCloseButton", tr("Close"), default=False, on_click=self.close)
        buttons = ui.row(self._find, self._connect, 1, close)
        ui.column((tabs, 1), self._result, buttons, into=self)
        self._find.clicked.connect(self.find_requested)
        device.link_changed.connect(self._on_link_changed)
        device.request_failed.connect(self._on_failed)

    def open_dialog(self) -> None:
        if not self.isVisible():
            self._steps.begin()
            self._result.show_note("")
        self._on_link_changed()
        self.show_in_front()

    @Slot()
    def _on_link_changed(self) -> None:
        is_free = self._device.link is ConnectionState.DISCONNECTED
        for button in (self._find, self._connect):
            button.setEnabled(is_free)
        if not is_free:
            self._result.show_note(self._device.status)

    @Slot(str)
    def _on_failed(self, reason: str) -> None:
        if self.isVisible():
            self._result.show_note(reason, alarming=True)
