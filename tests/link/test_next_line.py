"""How a board is reached after its next start follows from what it stores."""

import pytest

from trex_gui.link.next_line import after_power_cycle, where_to_look
from trex_gui.link.settings import LinkSettings
from trex_gui.link.timeouts import Timeouts
from trex_gui.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.protocol.parameters import parameters_of

NOW = LinkSettings("/dev/ttyUSB0", name="adapter", timeouts=Timeouts(extra=0.1))
FACTORY = {spec.key: spec.default for spec in parameters_of("trex", "1.2").readable}


def test_a_new_board_stays_where_it_is() -> None:
    assert after_power_cycle(NOW, FACTORY, "1.2") == NOW


@pytest.mark.parametrize("baud", baud_rates())
@pytest.mark.parametrize("detection", list(Detection))
def test_stored_uart_settings_are_those_of_the_line(baud: int, detection: Detection) -> None:
    line = LineSettings(baud, detection, 2)
    coming = after_power_cycle(NOW, {"uart_settings": line.to_wire()}, "1.2")
    assert coming is not None
    assert coming.line == line
    assert (coming.url, coming.name, coming.timeouts) == (NOW.url, NOW.name, NOW.timeouts)


def test_old_firmware_runs_two_rates_at_half() -> None:
    stored = {"uart_settings": LineSettings(38400).to_wire()}
    coming = after_power_cycle(NOW, stored, "1.1")
    assert coming is not None
    assert coming.line.baud == 19200


def test_a_stored_polynomial_gets_its_highest_bit_back() -> None:
    stored = {"uart_settings": LineSettings(19200, Detection.CRC7).to_wire()}
    coming = after_power_cycle(NOW, {**stored, "crc7_polynomial": 0x15}, "1.2")
    assert coming is not None
    assert coming.polynomial == 0x95
    assert coming.framing.polynomial == 0x95


def test_a_device_number_matters_only_to_who_uses_one() -> None:
    stored = {"device_number": 9}
    assert after_power_cycle(NOW, stored, "1.2") == NOW
    addressed = LinkSettings("/dev/ttyUSB0", device_number=7)
    coming = after_power_cycle(addressed, stored, "1.2")
    assert coming is not None
    assert coming.device_number == 9


def test_nobody_can_say_where_a_value_leads_that_names_no_rate() -> None:
    assert after_power_cycle(NOW, {"uart_settings": 0x0F}, "1.2") is None


def test_nowhere_else_is_looked_where_nothing_of_the_line_changes() -> None:
    assert where_to_look(NOW, FACTORY, {**FACTORY, "serial_timeout": 5}, "1.2") == ()


def test_a_polynomial_that_is_lost_on_the_way_is_the_factorys() -> None:
    crc = LineSettings(19200, Detection.CRC7)
    link = LinkSettings("/dev/ttyUSB0", line=crc, polynomial=0x91)
    before = {**FACTORY, "uart_settings": crc.to_wire(), "crc7_polynomial": 0x11}
    places = where_to_look(link, before, {**before, "crc7_polynomial": 0x15}, "1.2")
    assert [place.polynomial for place in places] == [0x95, 0x89]
    assert {place.line for place in places} == {crc}


def test_a_number_that_is_lost_on_the_way_is_the_factorys() -> None:
    link = LinkSettings("/dev/ttyUSB0", device_number=20)
    before = {**FACTORY, "device_number": 20}
    places = where_to_look(link, before, {**before, "device_number": 9}, "1.2")
    assert [place.device_number for place in places] == [9, 7]


def test_old_and_new_line_are_both_looked_at_with_what_may_be_lost() -> None:
    crc = LineSettings(57600, Detection.CRC7)
    after = {**FACTORY, "uart_settings": crc.to_wire(), "crc7_polynomial": 0x15}
    places = where_to_look(NOW, FACTORY, after, "1.2")
    assert {(place.line, place.framing.polynomial) for place in places} >= {
        (crc, 0x95),
        (crc, 0x89),
    }
