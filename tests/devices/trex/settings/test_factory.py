"""What a new board holds, as far as it is known."""

import pytest

from trex_gui.devices.trex.protocol.device_table import Model, device_table
from trex_gui.devices.trex.settings.document import REACH, serial_defaults

BOARDS = [(model, firmware) for model in device_table().models for firmware in model.firmware]


@pytest.mark.parametrize(("model", "firmware"), BOARDS, ids=lambda part: getattr(part, "key", part))
def test_serial_defaults_contain_only_connection_settings(model: Model, firmware: str) -> None:
    settings = serial_defaults(model, firmware)
    assert set(settings.parameters) <= set(REACH)
    assert {"uart_settings", "crc7_polynomial", "device_number"} <= set(settings.parameters)
    assert "serial_timeout" not in settings.parameters
