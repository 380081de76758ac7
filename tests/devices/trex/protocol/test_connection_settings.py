"""Line settings as text."""

from dataclasses import replace

import pytest

from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings


@pytest.mark.parametrize(
    ("detection", "text"),
    [
        (Detection.NONE, "57600 baud, 2 stop bits"),
        (Detection.EVEN, "57600 baud, even parity, 2 stop bits"),
        (Detection.ODD, "57600 baud, odd parity, 2 stop bits"),
        (Detection.CRC7, "57600 baud, CRC-7, 2 stop bits"),
    ],
)
def test_short_text_names_only_what_few_lines_have(detection: Detection, text: str) -> None:
    settings = ConnectionSettings("/dev/ttyUSB0", LineSettings(57600, detection, 2))
    assert settings.short == text
    assert replace(settings, line=LineSettings()).short == "19200 baud"
