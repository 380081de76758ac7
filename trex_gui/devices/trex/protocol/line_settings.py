"""Baud rate, error detection and stop bits of the line (parameter 0x7E).

Ref: Pololu TReX Jr User's Guide 5.a (rates, defaults); User's Guide 5.e of both models (CRC-7). The
parameter table marks inferred bit fields.
"""

from dataclasses import dataclass, field
from enum import IntEnum

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.core.transport.settings import Parity, SerialFormat
from trex_gui.devices.trex.protocol.device_table import device_table, version_key


class Detection(IntEnum):
    """Error detection. The value is the field in bits 6:5 of parameter 0x7E.

    All values except CRC-7 are inferred from register bits of the board's processor.
    """

    NONE = 0x00
    CRC7 = 0x20
    EVEN = 0x40
    ODD = 0x60


_TWO_STOP_BITS = 0x10
_BAUD_FIELD = 0x0F
_DETECTION_FIELD = 0x60


def baud_rates() -> tuple[int, ...]:
    return device_table().baud_rates


_PARITIES = {Detection.EVEN: Parity.EVEN, Detection.ODD: Parity.ODD}


@dataclass(frozen=True, slots=True, init=False)
class LineSettings(SerialFormat):
    """Settings of the board's serial line. The defaults are the factory defaults."""

    parity: Parity = field(init=False)
    detection: Detection = field(default=Detection.NONE)

    def __init__(
        self, baud: int = 19200, detection: Detection = Detection.NONE, stop_bits: int = 1
    ) -> None:
        SerialFormat.__init__(self, baud, _PARITIES.get(detection, Parity.NONE), stop_bits)
        object.__setattr__(self, "detection", detection)

    @classmethod
    def from_wire(cls, wire: int) -> "LineSettings":
        """Decode the value of parameter 0x7E. Raise BadRequest if it is invalid."""
        if not 0 <= wire <= 0x7F:
            text = tr("UART settings must be a wire value from 0 to 127, not {0}")
            raise BadRequest(text.format(wire))
        code = wire & _BAUD_FIELD
        if code >= len(baud_rates()):
            raise BadRequest(
                tr("UART settings {0:#04x} do not contain a valid baud rate").format(wire)
            )
        detection = Detection(wire & _DETECTION_FIELD)
        return cls(baud_rates()[code], detection, 2 if wire & _TWO_STOP_BITS else 1)

    def to_wire(self) -> int:
        """Return the value of parameter 0x7E. Raise BadRequest if no board has these settings."""
        if self.baud not in baud_rates():
            rates = ", ".join(map(str, baud_rates()))
            raise BadRequest(tr("a TReX runs at {0} baud, not {1}").format(rates, self.baud))
        if self.stop_bits not in {1, 2}:
            text = tr("the number of stop bits must be 1 or 2, not {0}")
            raise BadRequest(text.format(self.stop_bits))
        stop = _TWO_STOP_BITS if self.stop_bits == 2 else 0
        return baud_rates().index(self.baud) | self.detection | stop

    def real_baud(self, firmware: str) -> int:
        """Return the actual rate of the board in bit/s.

        Firmware before 1.2 halves two of the baud rates (forum thread 1491). The version is sourced
        for the Jr (forum thread 5011), and inferred for the TReX.
        """
        table = device_table()
        is_old = version_key(firmware) < version_key(table.half_rate_fixed_in)
        return self.baud // 2 if is_old and self.baud in table.half_rates else self.baud

    @property
    def has_crc(self) -> bool:
        return self.detection is Detection.CRC7

    @property
    def detection_text(self) -> str:
        """Error detection in words, such as `even parity`, or an empty string."""
        return "CRC-7" if self.has_crc else super(LineSettings, self).detection_text
