"""The step that learns the channels, and asks for the directions of the sticks."""

from functools import partial
from itertools import chain

from PySide6.QtCore import Signal, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.model.setup.robot_setup import RobotSetup
from trex_gui.devices.trex.model.setup.wiring import Driver
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.views.bars import ChannelBar
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import only_when_visible
from trex_gui.ui.widgets.labels import Muted, Note


class SticksPage(QWidget):
    """Leads to learning; or, with learned channels, asks for the directions of the sticks."""

    learn_requested = Signal()

    def __init__(
        self, device: Device, setup: RobotSetup, learning: Learning, parent: QWidget
    ) -> None:
        super().__init__(parent)
        self._device = device
        self._setup = setup
        self._learning = learning
        self._unclear: tuple[int, ...] = ()
        text = tr(
            "The board has to know the middle and the ends of each stick. Learning measures them "
            "in about two minutes, in a separate window, and ends with a review. The motors stay "
            "off meanwhile. Learn before you go on: the next step, which motor is which, needs the "
            "directions of the sticks."
        )
        learn_text = ui.label(self, text=text, wrap=True)
        button = partial(ui.button, self, default=False)
        text, learn = tr("&Learn channels…"), self.learn_requested
        self._learn = button("setupLearnButton", text, icon="calibrate", on_click=learn)
        self._blocker = ui.named(Note(1, self), "setupLearnBlocker")
        text = tr(
            "Already learned? Then show which way the sticks go: push, hold and click. In serial "
            "mode they move no motor."
        )
        pushed_text = ui.label(self, text=text, wrap=True)
        self._forward = button(
            "setupForwardButton", on_click=lambda: self._note((2,) if self._is_one else (1, 2))
        )
        text = tr("The stick is fully &right now")
        self._right = button("setupRightButton", text, on_click=lambda: self._note((1,)))
        self._wiring = Muted(parent=self)
        self._bars = {channel: self._make_bar(channel) for channel in (1, 2)}
        self._known = {
            channel: ui.named(Note(1, self), f"setupStick{channel}Note") for channel in self._bars
        }
        learn_row = ui.row(self._learn, (self._blocker, 1), 1)
        pushing = ui.row(self._forward, self._right, 1)
        above = learn_text, learn_row, pushed_text, pushing, self._wiring
        channels = chain.from_iterable(zip(self._known.values(), self._bars.values(), strict=True))
        ui.column(*above, *channels, 1, into=self, margins=0, spacing=10)
        device.telemetry.frame_due.connect(self._show_inputs)

    def _make_bar(self, channel: int) -> ChannelBar:
        accessible = tr("Raw input of channel {0}").format(channel)
        return ui.named(ChannelBar(self), f"setupChannel{channel}Bar", accessible=accessible)

    @property
    def _is_one(self) -> bool:
        return self._setup.driver is Driver.ONE_STICK

    def _note(self, channels: tuple[int, ...]) -> None:
        self._unclear = self._setup.note_pushed(channels)
        self.refresh()

    def refresh(self) -> None:
        blocker = self._learning.preconditions.blocker
        self._learn.setEnabled(not blocker)
        self._blocker.show_note(blocker, alarming=True)
        self._right.setVisible(self._is_one)
        one = tr("The stick is fully &forward now")
        two = tr("Both sticks are fully &forward now")
        self._forward.setText(one if self._is_one else two)
        can_push = self._device.is_connected and not self._device.writer.is_rejected
        for button in (self._forward, self._right):
            button.setEnabled(can_push)
        self._wiring.setText(self._wiring_text())
        device = self._device
        for channel, bar in self._bars.items():
            bar.set_connected(device.is_connected)
            bar.set_source(device.calibrations.source)
            bar.set_calibration(device.calibrations.stored(channel))
            is_unclear = channel in self._unclear and channel not in self._setup.rises
            self._known[channel].show_note(self._stick_text(channel), alarming=is_unclear)
        self._show_inputs()

    @Slot()
    @only_when_visible
    def _show_inputs(self) -> None:
        telemetry = self._device.telemetry
        if telemetry.raw is not None:
            for channel, bar in self._bars.items():
                bar.set_raw(telemetry.raw_of(channel))

    def _wiring_text(self) -> str:
        one = tr("Channel 1 is for left and right of the stick, channel 2 for forward and back.")
        text = one if self._is_one else tr("Channel 1 is for motor 1, channel 2 for motor 2.")
        if self._device.calibrations.source is InputSource.RC:
            text = f"{text} {tr('Each is connected to an output of your receiver.')}"
        return text

    def _stick_text(self, channel: int) -> str:
        """Return what is known of the direction of a stick, or why it could not be seen."""
        names = {1: tr("Channel 1 (motor 1)"), 2: tr("Channel 2 (motor 2)")}
        if self._is_one:
            names = {1: tr("Channel 1 (turns)"), 2: tr("Channel 2 (drives)")}
        texts = {
            None: tr("{0}: its direction is not known yet."),
            True: tr("{0}: the value rises."),
            False: tr("{0}: the value falls."),
        }
        if channel in self._unclear:
            texts[None] = tr("{0}: the stick is still near its middle. Push it all the way.")
            if self._device.telemetry.raw_of(channel) is None:
                texts[None] = tr("{0}: no signal arrives.")
        text = texts[self._setup.rises.get(channel)].format(names[channel])
        is_rc = self._device.calibrations.source is InputSource.RC
        if channel in self._unclear and channel not in self._setup.rises and is_rc:
            text = f"{text} {tr('Is the transmitter on?')}"
        return text
