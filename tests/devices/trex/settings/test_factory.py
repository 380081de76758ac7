"""What a new board holds, as far as it is known."""

import pytest

from trex_gui.devices.trex.protocol.device_table import Model, device_table
from trex_gui.devices.trex.settings.document import REACH, factory_settings, serial_defaults
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings

BOARDS = [(model, firmware) for model in device_table().models for firmware in model.firmware]


@pytest.mark.parametrize(("model", "firmware"), BOARDS, ids=lambda part: getattr(part, "key", part))
def test_factory_settings_make_complete_settings_file(model: Model, firmware: str) -> None:
    settings = factory_settings(model, firmware)
    again, findings = read_settings(write_settings(settings))
    assert again == settings
    assert not findings
    assert settings.parameters.keys() == {spec.key for spec in settings.specs.readable}


@pytest.mark.parametrize(("model", "firmware"), BOARDS, ids=lambda part: getattr(part, "key", part))
def test_serial_defaults_contain_only_connection_settings(model: Model, firmware: str) -> None:
    settings = serial_defaults(model, firmware)
    assert set(settings.parameters) <= set(REACH)
    assert {"uart_settings", "crc7_polynomial", "device_number"} <= set(settings.parameters)
    assert "serial_timeout" not in settings.parameters
