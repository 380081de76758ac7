"""Boards, clocks and rates in the device table."""

import pytest

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.device_table import device_table, version_key


@pytest.mark.parametrize(
    ("key", "name", "part", "signature", "size", "ampere", "highest_pwm"),
    [
        ("trex", "TReX", "DMC01", b"TReX", 7, 0.150, None),
        ("trexjr", "TReX Jr", "DMC02", b"TReXJr", 9, 0.040, 10000),
    ],
)
def test_model_matches_reference(
    key: str,
    name: str,
    part: str,
    signature: bytes,
    size: int,
    ampere: float,
    highest_pwm: int | None,
) -> None:
    model = device_table().model(key)
    assert (model.key, model.name, model.part) == (key, name, part)
    assert (model.signature, model.signature_size) == (signature, size)
    assert model.current_unit == pytest.approx(ampere)
    assert model.highest_pwm == highest_pwm
    assert model.firmware == ("1.0", "1.1", "1.2", "1.3")


@pytest.mark.parametrize("key", ["", "TReX", "trex2"])
def test_unknown_model_is_rejected_with_known_models(key: str) -> None:
    with pytest.raises(BadRequest, match=f"trex, trexjr, not '{key}'"):
        device_table().model(key)


def test_baud_rates_are_in_order_of_their_codes() -> None:
    rates = (1200, 2400, 4800, 9600, 14400, 19200, 28800, 38400, 57600, 76800, 115200)
    assert device_table().baud_rates == rates


# Prescalers divide 20 MHz by 8, 64, 256 or 1024. The wire value has the upper seven bits of the
# maximum.
@pytest.mark.parametrize(
    ("prescaler", "wire", "hertz"),
    [
        *((0, 0x3F, 19531), (0, 0x7F, 9766), (1, 0x3F, 2441), (1, 0x7F, 1221)),
        *((2, 0x3F, 610), (2, 0x7F, 305), (3, 0x3F, 153), (3, 0x7F, 76)),
    ],
)
def test_pwm_frequency_follows_prescaler_and_maximum(prescaler: int, wire: int, hertz: int) -> None:
    assert round(device_table().pwm.frequency(prescaler, wire)) == hertz


@pytest.mark.parametrize("prescaler", [-1, 4])
def test_invalid_prescaler_is_rejected_with_limits(prescaler: int) -> None:
    with pytest.raises(BadRequest, match=f"PWM prescaler must be 0 to 3, not {prescaler}"):
        device_table().pwm.frequency(prescaler, 63)


def test_versions_are_ordered_by_number() -> None:
    versions = ["1.10", "1.2", "2.0", "1.0", "1.9"]
    assert sorted(versions, key=version_key) == ["1.0", "1.2", "1.9", "1.10", "2.0"]


@pytest.mark.parametrize("version", ["", "x", "1.x", "1..2", "1.2 beta"])
def test_malformed_version_is_ordered_below_99(version: str) -> None:
    assert version_key(version) < version_key("99")
