"""Dialog for a board that does not respond."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import QPushButton, QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.views.board.jumpers import JumperPicture
from trex_gui.devices.trex.views.start_texts import ttl_wiring
from trex_gui.devices.trex.views.steps import Flow, FlowState, Page
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.frame.wiring_sketch import WiringSketch
from trex_gui.ui.notifier import ConnectWith
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Muted
from trex_gui.ui.widgets.leds import Leds

# Red and green LED patterns, description, meaning, remedy.
_LED_STATES = (
    (
        ("off", "off"),
        tr_noop("Both off"),
        tr_noop("No power"),
        tr_noop(
            "Check the supply and its leads. If only a blue LED is lit, the board has no firmware."
        ),
    ),
    (
        ("on", "off"),
        tr_noop("Red on"),
        tr_noop("Running: serial commands control the motors"),
        tr_noop(
            "Compare the wires with the picture, then search with “Find”. The green LED "
            "lights while the board receives a command. If it never lights, nothing arrives."
        ),
    ),
    (
        ("off", "on"),
        tr_noop("Green on, or flashing fast"),
        tr_noop("Running: the channels control the motors"),
        tr_noop(
            "Proceed as above: the board also responds in RC and analog mode. The red LED "
            "lights while the board receives a command. Fast flashes mean safe-start. Five "
            "flashes at power-up show which channels are learned."
        ),
    ),
    (
        ("blink 1/s", "blink 1/s"),
        tr_noop("Both blink together, or both on"),
        tr_noop("Learning mode"),
        tr_noop(
            "The board does not respond while it learns its channels. Remove the SO–G jumper, "
            "then switch the board off and on."
        ),
    ),
    (
        ("alternate 1/s", "alternate 1/s"),
        tr_noop("Red and green alternate"),
        tr_noop("Waiting for the boot loader handshake"),
        tr_noop(
            "Switch the board off, remove the mix and SO–G jumpers, and switch it on. If its "
            "serial settings are lost, continue with the handshake instead."
        ),
    ),
    (
        ("off", "short flash 1/s"),
        tr_noop("Green flashes once a second"),
        tr_noop("Boot loader, waiting for new firmware"),
        tr_noop("Switch the board off and on, with the jumpers removed."),
    ),
)
"""Ref: guide 4.e, manual pages 10-11, forum threads 1769 and 5011."""


class LedsPage(Page):
    def __init__(self) -> None:
        super().__init__("checkLedsPage", tr("What the LEDs show"))
        rows = ui.grid(self, margins=0, spacing=(16, 8), stretch=[(1, 1)])
        for row, (patterns, *texts) in enumerate(_LED_STATES):
            description, meaning, remedy = map(tr, texts)
            leds, caption = Leds(self), ui.label(self, text=description, wrap=True)
            leds.show_patterns(patterns, meaning=description)
            title = ui.label(self, text=meaning, bold=True, wrap=True)
            # The layout is not aligned, because an aligned layout cuts off wrapped text.
            about = ui.column(title, Muted(remedy, self), 1, margins=0, spacing=0)
            rows.addLayout(ui.column(leds, caption, 1, margins=0, spacing=0), row, 0)
            rows.addLayout(about, row, 1)
        rows.setRowStretch(len(_LED_STATES), 1)
        sketch = WiringSketch(ttl_wiring(), "checkWiring", self.side)
        text = tr("The mode jumper may also be on: the board responds in every mode.")
        ui.column((sketch, 1), Muted(text, self.side), into=self.side, margins=0)


@dataclass(frozen=True, slots=True)
class _Step:
    """Step of the boot loader handshake, and the state of the board after this step."""

    title: str
    instruction: str
    jumpers: tuple[bool, bool, *tuple[str, ...]]  # mix is on, SO–G is on, jumpers to move
    leds: tuple[str, str]
    led_text: str
    received: str


_STEPS = (
    _Step(
        tr_noop("Jumpers"),
        tr_noop("Switch the board off. Remove the mode jumper. Put the mix and SO–G jumpers on."),
        (True, True, "mode", "mix", "so_ground"),
        ("off", "off"),
        tr_noop("Both off"),
        tr_noop("Nothing: the board has no power."),
    ),
    _Step(
        tr_noop("Switch on"),
        tr_noop("Switch the board on."),
        (True, True),
        ("alternate 1/s", "alternate 1/s"),
        tr_noop("Red and green alternate, about once a second."),
        tr_noop("Nothing: the SO–G jumper connects SO to ground."),
    ),
    _Step(
        tr_noop("Mix: off"),
        tr_noop("Remove the mix jumper. Leave the power on."),
        (False, True, "mix"),
        ("alternate 4/s", "alternate 4/s"),
        tr_noop("Red and green alternate, four times as fast."),
        tr_noop("Nothing: the SO–G jumper connects SO to ground."),
    ),
    _Step(
        tr_noop("SO–G: off"),
        tr_noop("Remove the SO–G jumper. Leave the power on."),
        (False, False, "so_ground"),
        ("off", "short flash 1/s"),
        tr_noop("Green flashes once a second"),
        tr_noop(
            "The boot loader answers each byte with a question mark. The serial settings should "
            "now be the factory settings."
        ),
    ),
    _Step(
        tr_noop("Connect"),
        tr_noop(
            "Switch the board off and on, with all three jumpers removed. Then connect at "
            "19200 baud, without parity or CRC."
        ),
        (False, False),
        ("on", "off"),
        tr_noop("Five flashes, then red stays on."),
        tr_noop("The TReX responds at the factory settings."),
    ),
)
"""Ref: forum threads 1769 and 4631. The restored settings are inferred."""


class HandshakePage(Page):
    def __init__(self) -> None:
        super().__init__("handShakePage", tr("Jumpers and LEDs"))
        self._picture = JumperPicture(self)
        self._to_do = ui.label(self.side, "handShakeToDo", wrap=True, size="heading")
        self._leds = ui.label(self.side, "handShakeLeds", wrap=True)
        self._received = ui.label(self.side, "handShakeReceived", wrap=True)
        text = tr(
            "Restores the factory serial settings (inferred). If the LEDs alternate for only "
            "three seconds, start again."
        )
        titles = (tr("What the LEDs show"), tr("What this computer receives"))
        leds, received = (Muted(title, self.side) for title in titles)
        ui.column((self._picture, 0, Qt.AlignmentFlag.AlignCenter), into=self, margins=0)
        items = self._to_do, leds, self._leds, received, self._received, Muted(text, self.side)
        ui.column(*items, into=self.side, margins=0)

    def show_step(self, step: _Step) -> None:
        mix, so_ground, *to_move = step.jumpers
        self._picture.show_jumpers(mix, so_ground=so_ground, to_move=to_move, leds=step.leds)
        self._to_do.setText(tr(step.instruction))
        self._leds.setText(tr(step.led_text))
        self._received.setText(tr(step.received))


class CheckBoardFlow(Flow):
    connect_requested = Signal(object)  # `ConnectWith`
    find_requested = Signal()

    name = "check"

    def __init__(self, device: Device) -> None:
        super().__init__()
        self._device = device
        self._index = 0
        self._pages = LedsPage(), HandshakePage()
        self._failure = ""  # message about the last attempt to connect
        device.link_changed.connect(self._on_link_changed)
        device.request_failed.connect(self._on_failed)

    def show_in_front(self) -> None:
        self._failure = ""
        super().show_in_front()

    def add_buttons(self, parent: QWidget) -> Sequence[QPushButton]:
        button = partial(ui.button, parent, default=False)
        self._find = button("checkFindButton", tr("&Find now"), on_click=self.find_requested)
        tip = tr("Connects at 19200 baud, without parity or CRC, to any device number")
        text = tr("&Connect at factory settings")
        self._connect = button("checkConnectButton", text, tip=tip, on_click=self._connect_now)
        return self._find, self._connect

    def state(self) -> FlowState:
        leds, hand_shake = self._pages
        is_disconnected = self._device.link is ConnectionState.DISCONNECTED
        is_last = self._index == len(_STEPS)
        for button in (self._find, self._connect):
            button.setEnabled(is_disconnected)
        self._connect.setVisible(not is_last)
        if self._index:
            hand_shake.show_step(_STEPS[self._index - 1])
        status = "" if is_disconnected else self._device.status
        return FlowState(
            title_of(tr("&Board does not respond…")),
            [tr("LEDs"), *(tr(step.title) for step in _STEPS)],
            self._index,
            hand_shake if self._index else leds,
            note=self._failure or status,
            is_alarming=bool(self._failure),
            next=self._connect.text() if is_last else tr("&Next"),
            may_go_on=is_disconnected or not is_last,
            may_go_back=self._index > 0,
        )

    def back(self) -> None:
        self._index -= 1
        self.changed.emit()

    def next(self) -> None:
        if self._index == len(_STEPS):
            self._connect_now()
        else:
            self._index += 1
            self.changed.emit()

    def on_hidden(self, *, closed: bool) -> None:
        if closed:
            self._index = 0

    def _connect_now(self) -> None:
        self.connect_requested.emit(ConnectWith(ConnectionSettings("")))

    @Slot()
    def _on_link_changed(self) -> None:
        if self._device.link is not ConnectionState.DISCONNECTED:
            self._failure = ""
            self.changed.emit()

    @Slot(str)
    def _on_failed(self, reason: str) -> None:
        self._failure = reason
        self.changed.emit()
