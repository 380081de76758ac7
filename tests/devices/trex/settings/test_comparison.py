"""Comparisons of settings."""

from dataclasses import replace

import pytest
from hypothesis import Phase, given

from tests.devices.trex.settings.samples import TREX, TREX_JR, any_settings, factory
from tests.support.matrix import examples
from trex_gui.devices.trex.protocol.calibration import CALIBRATION_KEYS, Calibration, CalibrationKey
from trex_gui.devices.trex.settings.comparison import ComparisonRow, compare
from trex_gui.devices.trex.settings.document import Settings

modest = examples(12, phases=[Phase.generate])
RC_1 = CalibrationKey.RC_CHANNEL_1
STICK = Calibration(2500, 3750, 5000, 75)
STICK_TEXT = "1000 / 1500 / 2000 µs, deadband 30 µs"


def changed(settings: Settings, **parameters: int) -> Settings:
    return replace(settings, parameters={**settings.parameters, **parameters})


def test_row_has_raw_and_readable_values() -> None:
    (row,) = compare(
        Settings(TREX, None, {"serial_timeout": 0}), Settings(TREX, None, {"serial_timeout": 15})
    ).rows
    assert row == ComparisonRow("serial_timeout", "Serial Timeout", 0, 15, "off", "1.5 s")
    assert row.changed
    assert not row.is_missing
    assert not row.is_calibration


def test_calibration_is_compared_in_one_row() -> None:
    after = replace(STICK, maximum=5100)
    (row,) = compare(
        Settings(TREX, None, {}, {RC_1: STICK}), Settings(TREX, None, {}, {RC_1: after})
    ).rows
    assert (row.key, row.name) == ("rc_channel_1", "Calibration of RC channel 1")
    assert (row.before, row.after) == (STICK, after)
    assert row.text_before == STICK_TEXT
    assert row.text_after == "1000 / 1500 / 2040 µs, deadband 30 µs"
    assert row.changed
    assert row.is_calibration


def test_rows_follow_table_order_with_calibrations_last() -> None:
    before = factory()
    rows = compare(before, before).rows
    assert [row.key for row in rows] == [
        *(spec.key for spec in before.specs.readable),
        *CALIBRATION_KEYS,
    ]


@pytest.mark.parametrize(
    ("before", "after", "summary"),
    [
        ({}, {}, "0 parameters: 0 will change, 0 match"),
        ({"serial_timeout": 1}, {"serial_timeout": 1}, "1 parameter: 0 will change, 1 match"),
        (
            {"serial_timeout": 1, "motor_mode": 0},
            {"serial_timeout": 2, "motor_mode": 0},
            "2 parameters: 1 will change, 1 match",
        ),
        (
            {"serial_timeout": 1, "motor_mode": 0},
            {"serial_timeout": 2},
            "2 parameters: 1 will change, 0 match, 1 not given",
        ),
        ({}, {"serial_timeout": 0}, "1 parameter: 1 will change, 0 match"),
    ],
)
def test_summary_counts_changed_matching_and_missing_values(
    before: dict[str, int], after: dict[str, int], summary: str
) -> None:
    assert compare(Settings(TREX, None, before), Settings(TREX, None, after)).summary() == summary


def test_summary_counts_calibrations_separately() -> None:
    before = factory()
    after = replace(
        changed(before, serial_timeout=5, motor_mode=1),
        calibrations={**before.calibrations, RC_1: replace(STICK, deadband=0)},
    )
    comparison = compare(before, after)
    assert comparison.summary() == (
        "28 parameters: 2 will change, 26 match; 10 calibrations: 1 will change, 9 match"
    )
    assert (comparison.changed, comparison.equal) == (3, 35)


def test_report_lists_only_differences() -> None:
    before = factory()
    after = replace(
        changed(before, serial_timeout=15, device_number=8),
        calibrations={
            **before.calibrations,
            RC_1: Calibration(2000, 3750, 5100, 75),
            CalibrationKey.RC_CHANNEL_2: STICK,
        },
    )
    assert compare(before, after).report().splitlines() == [
        "device_number         7 → 8",
        "serial_timeout        0 → 15       off → 1.5 s",
        "rc_channel_1 minimum  2500 → 2000  1000 µs → 800 µs",
        "rc_channel_1 maximum  5000 → 5100  2000 µs → 2040 µs",
    ]


def test_missing_value_is_reported_as_not_given() -> None:
    before = Settings(TREX, None, {"motor_mode": 1}, {RC_1: STICK})
    after = Settings(TREX, None, {"serial_timeout": 1})
    comparison = compare(before, after)
    assert comparison.report().splitlines() == [
        "serial_timeout  not given → 1                  not given → 0.1 s",
        "motor_mode      1 → not given                  joint → not given",
        f"rc_channel_1    2500 3750 5000 75 → not given  {STICK_TEXT} → not given",
    ]
    assert [row.changed for row in comparison.rows] == [True, False, False]
    assert [row.is_missing for row in comparison.rows] == [False, True, True]


def test_equal_settings_have_empty_report() -> None:
    assert compare(factory(), factory()).report() == ""


# --- Other firmware or model -------------------------------------------------------------


def test_parameter_missing_in_older_firmware_is_left_out() -> None:
    old, new = factory("trex", "1.1"), changed(factory("trex", "1.2"), uart_response_delay=1)
    sentence = (
        "Enable UART Response Delay (1 ms) is left out: a TReX with firmware 1.1 does not have "
        "this setting."
    )
    for comparison in (compare(old, new), compare(new, old)):
        assert comparison.left_out == (sentence,)
        assert comparison.report() == sentence
        assert "uart_response_delay" not in {row.key for row in comparison.rows}
        assert comparison.summary() == (
            "27 parameters: 0 will change, 27 match; 10 calibrations: 0 will change, 10 match; "
            "1 cannot be carried over"
        )


def test_value_with_other_meaning_on_other_model_is_left_out() -> None:
    before, after = factory("trexjr"), changed(factory("trex"), motor2_current_limit=10)
    comparison = compare(before, after)
    assert comparison.left_out == (
        "Motor 2 Current Limit is left out: 10 means 3 A to a TReX, but 0.8 A to a TReX Jr.",
    )
    assert "motor2_current_limit" not in {row.key for row in comparison.rows}


def test_value_that_means_off_is_compared_across_models() -> None:
    before = Settings(TREX_JR, None, {"motor1_current_limit": 10})
    (row,) = compare(before, Settings(TREX, None, {"motor1_current_limit": 0})).rows
    assert (row.text_before, row.text_after) == ("0.8 A", "off")


def test_notes_of_second_settings_are_offered_and_reported() -> None:
    values = {"motor_mode": 1, "serial_timeout": 5}
    before = Settings(
        TREX, None, values, notes={"motor_mode": "one", "serial_timeout": "slow\nnet"}
    )
    after = replace(before, parameters={**values, "serial_timeout": 9}, notes={"motor_mode": "two"})
    comparison = compare(before, after)
    assert {row.key: (row.changed, row.adds_note) for row in comparison.differing} == {
        "serial_timeout": (True, False),
        "motor_mode": (False, True),
    }
    assert (comparison.changed, comparison.offered, comparison.equal) == (1, 2, 1)
    lines = [" ".join(line.split()) for line in comparison.report().splitlines()]
    assert lines == [
        "serial_timeout 5 → 9 0.5 s → 0.9 s",
        "serial_timeout note slow / net",
        "motor_mode note one → two",
    ]


@modest
@given(before=any_settings(), after=any_settings())
def test_every_setting_has_row_or_is_left_out(before: Settings, after: Settings) -> None:
    comparison = compare(before, after)
    keys = {*before.parameters, *after.parameters}
    calibrations = {*before.calibrations, *after.calibrations}
    assert len(comparison.rows) + len(comparison.left_out) == len(keys) + len(calibrations)
    missing = sum(row.is_missing for row in comparison.rows)
    assert comparison.changed + comparison.equal + missing == len(comparison.rows)
    for row in comparison.differing:
        assert row.key in comparison.report()
    assert [row.changed for row in comparison.rows] == [
        row.after is not None and row.after != row.before for row in comparison.rows
    ]
