import pytest

from trex_gui.core.transport.adapters import Adapter

FTDI = Adapter("0403:6001", "A50285BI", "1-2")
FIRST_INTERFACE = Adapter("0403:6010", "FT4ABCDE", "1-2:1.0")
NO_NUMBER = Adapter("1a86:7523", "", "1-2")
SHARED_NUMBER = Adapter("10c4:ea60", "0001", "1-2")


@pytest.mark.parametrize(
    ("first", "second", "is_same"),
    [
        (FTDI, Adapter("0403:6001", "A50285BI", "1-3.1"), True),
        (FTDI, Adapter("0403:6001", "A50285BJ", "1-2"), False),
        (FIRST_INTERFACE, Adapter("0403:6010", "FT4ABCDE", "1-3:1.0"), True),
        (FIRST_INTERFACE, Adapter("0403:6010", "FT4ABCDE", "1-2:1.1"), False),
        (NO_NUMBER, NO_NUMBER, True),
        (NO_NUMBER, Adapter("1a86:7523", "", "1-3"), False),
        (SHARED_NUMBER, Adapter("10c4:ea60", "0001", "1-2"), True),
        (SHARED_NUMBER, Adapter("10c4:ea60", "0001", "1-3"), False),
    ],
)
def test_adapter_is_identified_by_serial_number_or_usb_location(
    first: Adapter, second: Adapter, is_same: bool
) -> None:
    assert first.is_same(second) is is_same
    assert (first.key == second.key) is is_same
