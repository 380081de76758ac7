"""Conversions of settings to another model or firmware."""

import pytest

from tests.devices.trex.settings.samples import TREX, TREX_JR, factory
from tests.support.matrix import sampled
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.device_table import Model
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.settings.conversion import Conversion, Fate, convert
from trex_gui.devices.trex.settings.document import Settings


def fates(conversion: Conversion) -> dict[str, Fate]:
    return {row.key: row.fate for row in conversion.rows}


def test_conversion_for_same_board_changes_no_setting() -> None:
    settings = factory()
    conversion = convert(settings, TREX, "1.2")
    assert conversion.settings == settings
    assert not conversion.has_changes
    assert set(fates(conversion).values()) == {Fate.CARRIED_OVER}


@pytest.mark.parametrize(
    ("source", "target", "wire", "converted", "reason"),
    [
        (TREX, TREX_JR, 20, 75, "The same value in steps of 0.08 A: 20 becomes 75."),
        (TREX, TREX_JR, 127, 127, "The maximum for a TReX Jr is 10.16 A."),
        (TREX, TREX_JR, 1, 3, "Rounded down to steps of 0.08 A: 1 becomes 3."),
        (TREX_JR, TREX, 60, 16, "The same value in steps of 0.3 A: 60 becomes 16."),
        (TREX_JR, TREX, 63, 16, "Rounded down to steps of 0.3 A: 63 becomes 16."),
        (TREX_JR, TREX, 5, 1, "Rounded down to steps of 0.3 A: 5 becomes 1."),
        (TREX_JR, TREX, 1, 1, "The minimum for a TReX is 0.3 A; 0 means off (twin)."),
        (TREX_JR, TREX, 0, 0, ""),
    ],
)
def test_current_limit_is_converted_and_never_raised(
    source: Model, target: Model, wire: int, converted: int, reason: str
) -> None:
    conversion = convert(Settings(source, "1.2", {"motor1_current_limit": wire}), target, "1.2")
    (row,) = conversion.rows
    assert conversion.settings.parameters == {"motor1_current_limit": converted}
    assert (row.reason, row.fate is Fate.CHANGED) == (reason, bool(reason))


@pytest.mark.parametrize("wire", sampled(range(128), every=16))
def test_converted_current_limit_permits_no_higher_current(wire: int) -> None:
    for source, target in ((TREX, TREX_JR), (TREX_JR, TREX)):
        before = Settings(source, "1.2", {"motor1_current_limit": wire})
        after = convert(before, target, "1.2").settings
        old, new = (
            settings.specs["motor1_current_limit"].scale
            * settings.parameters["motor1_current_limit"]
            for settings in (before, after)
        )
        assert new <= max(old, 0.3) + 1e-9
        assert (new == 0) == (old == 0)


def test_conversion_to_newer_firmware_keeps_actual_baud_rate() -> None:
    calibration = Calibration(2400, 3700, 5100, 60)
    settings = Settings(
        TREX_JR,
        "1.0",
        {"uart_settings": LineSettings(38400).to_wire(), "serial_timeout": 5},
        {CalibrationKey.RC_CHANNEL_2: calibration},
    )
    newer = convert(settings, TREX, "1.3")
    assert newer.settings.parameters["uart_settings"] == LineSettings(19200).to_wire()
    assert newer.settings.calibrations == settings.calibrations
    assert [row.fate for row in newer.rows] == [Fate.CHANGED, Fate.CARRIED_OVER, Fate.CARRIED_OVER]
    assert newer.rows[0].reason == "Firmware 1.0 really runs at 19200 baud when set to 38400."


def test_conversion_to_older_firmware_omits_newer_parameter() -> None:
    wire = LineSettings(38400).to_wire()
    settings = Settings(TREX, "1.2", {"uart_settings": wire, "uart_response_delay": 1})
    older = convert(settings, TREX, "1.0")
    assert older.settings.parameters == {"uart_settings": wire}, "this firmware has no such rate"
    assert fates(older)["uart_response_delay"] is Fate.LEFT_OUT
    assert older.rows[0].reason == "A TReX with firmware 1.0 does not have this setting."
