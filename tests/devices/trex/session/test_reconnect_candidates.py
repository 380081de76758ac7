"""How a board is reached after its next start follows from what it stores."""

import pytest

from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.session.reconnecting import (
    after_power_cycle,
    reconnect_candidates,
)

NOW = ConnectionSettings("/dev/ttyUSB0", name="adapter", timeouts=Timeouts(extra=0.1))
FACTORY = {spec.key: spec.default for spec in parameters_of("trex", "1.2").readable}


def test_factory_settings_leave_line_unchanged() -> None:
    assert after_power_cycle(NOW, FACTORY, "1.2") == NOW


@pytest.mark.parametrize("baud", baud_rates())
@pytest.mark.parametrize("detection", list(Detection))
def test_stored_uart_settings_become_line_settings(baud: int, detection: Detection) -> None:
    line = LineSettings(baud, detection, 2)
    coming = after_power_cycle(NOW, {"uart_settings": line.to_wire()}, "1.2")
    assert coming is not None
    assert coming.line == line
    assert (coming.url, coming.name, coming.timeouts) == (NOW.url, NOW.name, NOW.timeouts)


def test_old_firmware_runs_38400_baud_at_half_rate() -> None:
    stored = {"uart_settings": LineSettings(38400).to_wire()}
    coming = after_power_cycle(NOW, stored, "1.1")
    assert coming is not None
    assert coming.line.baud == 19200


def test_stored_polynomial_regains_its_highest_bit() -> None:
    stored = {"uart_settings": LineSettings(19200, Detection.CRC7).to_wire()}
    coming = after_power_cycle(NOW, {**stored, "crc7_polynomial": 0x15}, "1.2")
    assert coming is not None
    assert coming.polynomial == 0x95
    assert coming.framing.polynomial == 0x95


def test_stored_device_number_is_used_only_when_addressed() -> None:
    stored = {"device_number": 9}
    assert after_power_cycle(NOW, stored, "1.2") == NOW
    addressed = ConnectionSettings("/dev/ttyUSB0", device_number=7)
    coming = after_power_cycle(addressed, stored, "1.2")
    assert coming is not None
    assert coming.device_number == 9


def test_invalid_uart_settings_predict_no_line() -> None:
    assert after_power_cycle(NOW, {"uart_settings": 0x0F}, "1.2") is None


def test_unchanged_line_has_no_reconnect_candidates() -> None:
    assert reconnect_candidates(NOW, FACTORY, {**FACTORY, "serial_timeout": 5}, "1.2") == ()


def test_reconnect_candidates_include_factory_polynomial() -> None:
    crc = LineSettings(19200, Detection.CRC7)
    link = ConnectionSettings("/dev/ttyUSB0", line=crc, polynomial=0x91)
    before = {**FACTORY, "uart_settings": crc.to_wire(), "crc7_polynomial": 0x11}
    places = reconnect_candidates(link, before, {**before, "crc7_polynomial": 0x15}, "1.2")
    assert [place.polynomial for place in places] == [0x95, 0x89]
    assert {place.line for place in places} == {crc}


def test_reconnect_candidates_include_factory_device_number() -> None:
    link = ConnectionSettings("/dev/ttyUSB0", device_number=20)
    before = {**FACTORY, "device_number": 20}
    places = reconnect_candidates(link, before, {**before, "device_number": 9}, "1.2")
    assert [place.device_number for place in places] == [9, 7]


def test_new_line_is_probed_with_new_and_factory_polynomial() -> None:
    crc = LineSettings(57600, Detection.CRC7)
    after = {**FACTORY, "uart_settings": crc.to_wire(), "crc7_polynomial": 0x15}
    places = reconnect_candidates(NOW, FACTORY, after, "1.2")
    assert {(place.line, place.framing.polynomial) for place in places} >= {
        (crc, 0x95),
        (crc, 0x89),
    }
