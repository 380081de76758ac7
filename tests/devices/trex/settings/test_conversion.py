"""Conversions of settings to another model or firmware."""

import pytest

from tests.support.matrix import sampled
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.settings.conversion import Conversion, Fate, convert
from trex_gui.devices.trex.settings.document import Settings, factory_settings

TREX, JR = device_table().model("trex"), device_table().model("trexjr")


def fates(conversion: Conversion) -> dict[str, Fate]:
    return {row.key: row.fate for row in conversion.rows}


def test_conversion_for_the_same_board_carries_everything_over() -> None:
    settings = factory_settings(TREX, "1.2")
    conversion = convert(settings, TREX, "1.2")
    assert conversion.settings == settings
    assert not conversion.alters
    assert set(fates(conversion).values()) == {Fate.CARRIED_OVER}


@pytest.mark.parametrize(
    ("source", "target", "wire", "converted", "reason"),
    [
        (TREX, JR, 20, 75, "The same value in steps of 0.08 A: 20 becomes 75."),
        (TREX, JR, 127, 127, "A TReX Jr has at most 10.16 A."),
        (TREX, JR, 1, 3, "Rounded down to steps of 0.08 A: 1 becomes 3."),
        (JR, TREX, 60, 16, "The same value in steps of 0.3 A: 60 becomes 16."),
        (JR, TREX, 63, 16, "Rounded down to steps of 0.3 A: 63 becomes 16."),
        (JR, TREX, 5, 1, "Rounded down to steps of 0.3 A: 5 becomes 1."),
        (JR, TREX, 1, 1, "A TReX has at least 0.3 A; 0 switches it off (twin)."),
        (JR, TREX, 0, 0, ""),
    ],
)
def test_current_limit_stays_in_amperes_and_is_never_raised(
    source: object, target: object, wire: int, converted: int, reason: str
) -> None:
    assert isinstance(source, type(TREX))
    assert isinstance(target, type(TREX))
    settings = Settings(source, "1.2", {"motor1_current_limit": wire})
    (row,) = convert(settings, target, "1.2").rows
    assert convert(settings, target, "1.2").settings.parameters == {
        "motor1_current_limit": converted
    }
    assert (row.reason, row.fate is Fate.CHANGED) == (reason, bool(reason))


@pytest.mark.parametrize("wire", sampled(range(128), every=16))
def test_converted_limit_lets_no_more_current_through(wire: int) -> None:
    for source, target in ((TREX, JR), (JR, TREX)):
        before = Settings(source, "1.2", {"motor1_current_limit": wire})
        after = convert(before, target, "1.2").settings
        old, new = (
            each.specs["motor1_current_limit"].scale * each.parameters["motor1_current_limit"]
            for each in (before, after)
        )
        assert new <= max(old, 0.3) + 1e-9
        assert (new == 0) == (old == 0)


def test_older_firmware_loses_its_settings_and_keeps_the_real_baud_rate() -> None:
    line = LineSettings(38400)
    calibration = Calibration(2400, 3700, 5100, 60)
    settings = Settings(
        JR,
        "1.0",
        {"uart_settings": line.to_wire(), "serial_timeout": 5},
        {CalibrationKey.RC_CHANNEL_2: calibration},
    )
    newer = convert(settings, TREX, "1.3")
    assert newer.settings.parameters["uart_settings"] == LineSettings(19200).to_wire()
    assert newer.settings.calibrations == settings.calibrations
    assert [row.fate for row in newer.rows] == [Fate.CHANGED, Fate.CARRIED_OVER, Fate.CARRIED_OVER]
    assert newer.rows[0].reason == "Firmware 1.0 really runs at 19200 baud when set to 38400."

    settings = Settings(TREX, "1.2", {"uart_settings": line.to_wire(), "uart_response_delay": 1})
    older = convert(settings, TREX, "1.0")
    assert older.settings.parameters == {"uart_settings": line.to_wire()}, "no such rate: a warning"
    assert fates(older)["uart_response_delay"] is Fate.LEFT_OUT
    assert older.rows[0].reason == "A TReX with firmware 1.0 does not have it."
