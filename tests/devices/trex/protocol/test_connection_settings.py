"""Line settings as text."""

import pytest

from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings


@pytest.mark.parametrize(
    ("detection", "text"),
    [
        (Detection.NONE, "57600 8N2"),
        (Detection.EVEN, "57600 8E2"),
        (Detection.ODD, "57600 8O2"),
        (Detection.CRC7, "57600 8N2 CRC"),
    ],
)
def test_short_text_uses_notation_of_terminal_programs(detection: Detection, text: str) -> None:
    settings = ConnectionSettings("/dev/ttyUSB0", LineSettings(57600, detection, 2))
    assert settings.short == text
