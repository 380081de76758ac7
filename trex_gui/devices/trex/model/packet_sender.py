"""Packets typed by the user: preview, sending and replies."""

from functools import partial

from PySide6.QtCore import QObject

from trex_gui.core.errors import BadRequest
from trex_gui.core.events import EventKind
from trex_gui.core.session import Outcome
from trex_gui.core.texts import hex_text
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.raw_packets import RawPacket, packets_of, parse_hexadecimal
from trex_gui.ui.traffic.send_row import PacketSender, SendPreview
from trex_gui.ui.translations import error_text

_MAX_LINES = 3


class TrexPacketSender(PacketSender):
    """Sends hexadecimal bytes to the connected board, packet by packet."""

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self.hint = tr("Hexadecimal, such as 9F 07")
        device.link_changed.connect(self.changed)
        device.motors.arming_changed.connect(self.changed)
        device.state_changed.connect(self.changed)

    def preview(self, text: str) -> SendPreview:
        if not text.strip():
            return SendPreview()
        try:
            packets = self._packets(text)
        except BadRequest as error:
            return SendPreview(blocker=str(error))
        lines, risky = [self._line(packet) for packet in packets], list(map(_is_risky, packets))
        # If there are too many packets, prefer packets that move a motor or store a value.
        by_risk = sorted(range(len(lines)), key=lambda index: not risky[index])
        shown = [lines[index] for index in sorted(by_risk[:_MAX_LINES])]
        if hidden := len(lines) - len(shown):
            shown.append(tr("and %n more packet(s)", "", hidden))
        text, details = "\n".join(shown), "\n".join(lines) if hidden else ""
        return SendPreview(text, self._blocker(packets), any(risky), details)

    def send(self, text: str) -> None:
        packets = self._packets(text)
        for packet in packets:
            if _is_risky(packet):
                note = tr("Sent by hand: {0}").format(packet.description(self._device.signature))
                self._device.events.add(EventKind.NOTE, note)
            self._device.connection.traffic.expect_typed(packet.packet.raw)
            self._device.driving.send_packet(packet, partial(self._on_replied, packet))

    def _packets(self, text: str) -> tuple[RawPacket, ...]:
        settings = self._device.settings if self._device.is_connected else None
        polynomial = None if settings is None else settings.framing.polynomial
        return packets_of(parse_hexadecimal(text), polynomial)

    def _line(self, packet: RawPacket) -> str:
        words = packet.description(self._device.signature)
        if packet.moves:
            return tr("{0} (may move a motor)").format(words)
        if packet.writes:
            return tr("{0} (stored at once, without a snapshot)").format(words)
        return words

    def _blocker(self, packets: tuple[RawPacket, ...]) -> str:
        settings = self._device.settings
        if not self._device.is_connected or settings is None:
            return tr("Connect to a board first.")
        if self._device.writer.running:
            return tr("Settings are being written.")
        moving = [packet for packet in packets if packet.moves]
        if moving and not self._device.motors.armed:
            return tr("Arm the motors first.")
        if not all(packet.is_within_stop(settings.device_number) for packet in moving):
            text = tr("A stop would not reach that board: address device {0}.")
            return text.format(settings.device_number)
        if any(packet.writes_everywhere for packet in packets):
            if settings.device_number is not None:
                text = tr("Every board on this line would store the value: address device {0}.")
                return text.format(settings.device_number)
            if self._device.driving.reaches_several:
                return tr("Every board on this line would store the value: select a board.")
        return ""

    def _on_replied(self, packet: RawPacket, outcome: Outcome) -> None:
        notifier = self._device.notifier
        if outcome.error is not None:
            text = tr("{0}: {1}")
            notifier.error.emit(text.format(packet.hexadecimal, error_text(outcome.error)))
        elif isinstance(outcome.value, bytes) and outcome.value:
            text = tr("Sent {0}; the reply is {1}.")
            notifier.info.emit(text.format(packet.hexadecimal, hex_text(outcome.value)))
        else:
            text = tr("Sent {0}; there was no reply.")
            notifier.info.emit(text.format(packet.hexadecimal))


def _is_risky(packet: RawPacket) -> bool:
    return packet.moves or packet.writes
