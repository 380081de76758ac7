"""Rules with their findings and proposals."""

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import NamedTuple

import pytest
from hypothesis import Phase, given
from hypothesis import strategies as st

from tests.devices.trex.settings.samples import TREX, TREX_JR, any_calibration, factory
from tests.support.matrix import examples
from trex_gui.devices.trex.protocol.calibration import CALIBRATION_KEYS, Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.framing import crc7
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.rules import RULES, Context, LintFinding, lint

thorough = examples(20, phases=[Phase.generate])
NOTHING_ELSE = Context()
DRIVING = Context(drives_from_computer=True)


def uart(baud: int, detection: Detection = Detection.NONE, stop_bits: int = 1) -> int:
    return LineSettings(baud, detection, stop_bits).to_wire()


def trex(firmware: str | None = None, **parameters: int) -> Settings:
    return Settings(TREX, firmware, parameters)


class Expected(NamedTuple):
    """Expected finding."""

    rule: str
    message: str
    keys: tuple[str, ...]
    change: Mapping[str, int] = MappingProxyType({})
    proposal: str = ""


def only(given_settings: Settings, context: Context = NOTHING_ELSE) -> LintFinding:
    (found,) = lint(given_settings, context)
    return found


def accept(settings: Settings, finding: LintFinding) -> Settings:
    return replace(settings, parameters={**settings.parameters, **finding.change})


def calibrated(key: str, *points: int) -> Settings:
    return Settings(TREX, None, {}, {CALIBRATION_KEYS[key]: Calibration(*points)})


# One finding for each rule, in full


EXAMPLES: Mapping[str, tuple[Settings, Context, Expected]] = {
    found.rule: (given_settings, context, found)
    for given_settings, context, found in [
        (
            trex(serial_timeout=0),
            DRIVING,
            Expected(
                "no_serial_timeout",
                "Serial Timeout is off while a computer drives the motors: if the cable or the "
                "computer fails, the motors keep running at their last setpoint.",
                ("serial_timeout", "uart_error_shutdown"),
                {"serial_timeout": 5, "uart_error_shutdown": 1},
                "Set Serial Timeout to 0.5 s and UART-Error Shutdown to on",
            ),
        ),
        (
            trex(serial_timeout=5, uart_error_shutdown=0),
            NOTHING_ELSE,
            Expected(
                "timeout_without_shutdown",
                "Serial Timeout of 0.5 s may not stop the motors if the cable or the computer "
                "fails: UART-Error Shutdown is off (twin).",
                ("serial_timeout", "uart_error_shutdown"),
                {"uart_error_shutdown": 1},
                "Set UART-Error Shutdown to on",
            ),
        ),
        (
            trex(motor_mode=1, motor1_current_limit=10, motor2_current_limit=20),
            Context(),
            Expected(
                "limit_in_joint_mode",
                "No effect in joint mode: Motor 1 Current Limit (3 A) and Motor 2 Current Limit (6 "
                "A). The board measures no current then, so the motor is not protected.",
                ("motor_mode", "motor1_current_limit", "motor2_current_limit"),
                {"motor1_current_limit": 0, "motor2_current_limit": 0},
                "Set Motor 1 Current Limit and Motor 2 Current Limit to off",
            ),
        ),
        (
            trex(motor2_current_limit=10, motor2_current_limit_p=0),
            Context(),
            Expected(
                "limit_without_gain",
                "Motor 2 Current Limit is 3 A, but its proportionality constant P, which sets how "
                "strongly the limiter reacts, is 0. The limit may then have no effect (inferred).",
                ("motor2_current_limit", "motor2_current_limit_p"),
                {"motor2_current_limit_p": 4},
                "Set Motor 2 Current Limit Proportionality Constant P to 4",
            ),
        ),
        (
            trex(motor1_current_limit=10, motor1_acceleration=0),
            Context(),
            Expected(
                "limit_without_ramp",
                "Motor 1 Current Limit is 3 A and Motor 1 Acceleration is 0, so the speed changes "
                "at once. As soon as the current falls below the limit, the motor jumps back to "
                "its full target speed, so it may run in jerks (inferred).",
                ("motor1_current_limit", "motor1_acceleration"),
                {"motor1_acceleration": 10},
                "Set Motor 1 Acceleration to 1.3 s to full speed",
            ),
        ),
        (
            Settings(TREX_JR, None, {"motor2_pwm_prescaler": 0, "motor2_pwm_maximum": 63}),
            Context(),
            Expected(
                "pwm_above_rating",
                "The PWM of motor 2 runs at 19.5 kHz (inferred), but the motor driver of a TReX "
                "Jr is rated for 10 kHz; above that it gets hot. The prescaler clock / 64 gives "
                "2.44 kHz.",
                ("motor2_pwm_prescaler", "motor2_pwm_maximum"),
                {"motor2_pwm_prescaler": 1},
                "Set Motor 2 PWM Prescaler to clock / 64",
            ),
        ),
        (
            trex(required_channels=0b00111, ignored_channels=0b10110),
            Context(),
            Expected(
                "required_but_ignored",
                "Both required and ignored: channel 2 and channel 3. The signal moves nothing, but "
                "without it the motors may not run in RC mode (inferred).",
                ("required_channels", "ignored_channels"),
                {"required_channels": 1},
                "Set Required Channels to channel 1",
            ),
        ),
        (
            calibrated("rc_channel_2", 2500, 3750, 5000, 1250),
            Context(),
            Expected(
                "deadband_over_travel",
                "The deadband of RC channel 2 reaches from neutral to its minimum and maximum: "
                "there is nothing between standstill and full speed on that side.",
                ("rc_channel_2",),
            ),
        ),
        (
            calibrated("analog_channel_3", 0, 512, 1100, 20),
            Context(),
            Expected(
                "end_out_of_reach",
                "The maximum of analog channel 3, 1100, is beyond 1023, the last count that the "
                "board measures: full speed on that side is never reached.",
                ("analog_channel_3",),
            ),
        ),
        (
            trex(crc7_polynomial=0x1B, uart_settings=uart(19200, Detection.EVEN)),
            Context(),
            Expected(
                "polynomial_without_crc",
                "CRC-7 Polynomial is 0x9B instead of the default 0x89, but CRC-7 is not "
                "switched on: no packet is checked with it.",
                ("crc7_polynomial", "uart_settings"),
                {"crc7_polynomial": 9},
                "Set CRC-7 Polynomial to 0x89",
            ),
        ),
        (
            trex(crc7_polynomial=0, uart_settings=uart(19200, Detection.CRC7)),
            Context(),
            Expected(
                "crc_that_checks_nothing",
                "With 0x80 as CRC-7 Polynomial the checksum of every packet is 0, so CRC-7 detects "
                "no errors at all.",
                ("crc7_polynomial", "uart_settings"),
                {"crc7_polynomial": 9},
                "Set CRC-7 Polynomial to 0x89",
            ),
        ),
        (
            trex("1.1", uart_settings=uart(38400, Detection.ODD, 2)),
            Context(),
            Expected(
                "half_rate",
                "A TReX with firmware 1.1 set to 38400 baud really runs at 19200 baud; firmware "
                "1.2 corrects this. Programs must use 19200 baud.",
                ("uart_settings",),
                {"uart_settings": uart(19200, Detection.ODD, 2)},
                "Set UART Settings to 19200 baud, odd parity, 2 stop bits",
            ),
        ),
        (
            trex(uart_settings=uart(76800)),
            Context(port_rates=[9600, 57600, 115200]),
            Expected(
                "rate_the_port_lacks",
                "This computer's serial port does not support 76800 baud: after the next power "
                "cycle, the computer could no longer reach the board.",
                ("uart_settings",),
                {"uart_settings": uart(57600)},
                "Set UART Settings to 57600 baud, no error detection, 1 stop bit",
            ),
        ),
        (
            trex(uart_settings=uart(115200)),
            Context(active_line=LineSettings()),
            Expected(
                "line_will_change",
                "After the next power cycle, the line settings of the board will be 115200 baud, "
                "no error detection, 1 stop bit instead of 19200 baud, no error detection, 1 stop "
                "bit. Programs that use the board must then use them, too.",
                ("uart_settings",),
            ),
        ),
    ]
}


def test_every_rule_has_example() -> None:
    assert list(EXAMPLES) == list(RULES)


@pytest.mark.parametrize("rule", RULES)
def test_rule_reports_expected_finding(rule: str) -> None:
    given_settings, context, expected = EXAMPLES[rule]
    found = only(given_settings, context)
    shown = Expected(found.rule, found.message, found.keys, found.change, found.proposal)
    assert shown == expected
    if expected.change:
        assert lint(accept(given_settings, found), context) == ()


@pytest.mark.parametrize("rule", RULES)
def test_rule_is_silent_if_required_setting_is_missing(rule: str) -> None:
    given_settings, context, _ = EXAMPLES[rule]
    for key in given_settings.parameters:
        rest = {k: wire for k, wire in given_settings.parameters.items() if k != key}
        found = lint(replace(given_settings, parameters=rest), context)
        assert not [one for one in found if key in one.keys]


# What sets rules off, and what does not


@pytest.mark.parametrize("model", ["trex", "trexjr"])
@pytest.mark.parametrize("firmware", [None, "1.0", "1.3"])
def test_factory_settings_have_no_findings(model: str, firmware: str | None) -> None:
    every = Context(port_rates=baud_rates(), active_line=LineSettings())
    assert lint(factory(model, firmware), every) == ()


def test_empty_settings_have_no_findings() -> None:
    every = Context(drives_from_computer=True, port_rates=[], active_line=LineSettings(1200))
    assert lint(Settings(TREX), every) == ()


def test_timeout_rule_applies_only_if_computer_drives() -> None:
    assert lint(trex(serial_timeout=0)) == ()
    assert lint(trex(serial_timeout=1), DRIVING) == ()


def test_joint_mode_finding_names_only_active_limit() -> None:
    found = only(trex(motor_mode=1, motor1_current_limit=1, motor2_current_limit=0))
    assert found.message.startswith("No effect in joint mode: Motor 1 Current Limit (0.3 A).")
    assert found.proposal == "Set Motor 1 Current Limit to off"


def test_joint_mode_limit_needs_no_gain_or_ramp() -> None:
    parameters = {"motor1_current_limit": 1, "motor1_acceleration": 0, "motor1_current_limit_p": 0}
    found = lint(Settings(TREX, None, {"motor_mode": 1, **parameters}))
    assert [one.rule for one in found] == ["limit_in_joint_mode"]


@pytest.mark.parametrize("prescaler", range(4))
@pytest.mark.parametrize("maximum", [0, 1, 61, 123, 124, 127])
def test_pwm_proposal_is_smallest_sufficient_prescaler(prescaler: int, maximum: int) -> None:
    parameters = {"motor1_pwm_prescaler": prescaler, "motor1_pwm_maximum": maximum}
    divisors = (8, 64, 256, 1024)
    frequencies = [20e6 / (divisor * (2 * maximum + 2)) for divisor in divisors]
    found = lint(Settings(TREX_JR, None, parameters))
    if frequencies[prescaler] <= 10_000:
        assert found == ()
    else:
        wanted = min(n for n, frequency in enumerate(frequencies) if frequency <= 10_000)
        assert found[0].change == {"motor1_pwm_prescaler": wanted}


def test_pwm_of_driver_with_unknown_rating_is_not_checked() -> None:
    assert lint(trex(motor1_pwm_prescaler=0, motor1_pwm_maximum=0)) == ()


@pytest.mark.parametrize(
    ("points", "ends"),
    [
        ((2500, 3750, 5000, 1249), []),
        ((2500, 3750, 5100, 1250), ["minimum"]),
        ((2400, 3750, 5000, 1250), ["maximum"]),
        ((3750, 3750, 5000, 75), []),
        ((2500, 5000, 5000, 75), []),
    ],
)
def test_deadband_reaching_end_of_travel_is_reported(
    points: tuple[int, int, int, int], ends: list[str]
) -> None:
    messages = [found.message for found in lint(calibrated("rc_channel_1", *points))]
    assert len(messages) == len(ends)
    assert all(f"to its {end}: " in "".join(messages) for end in ends)


@pytest.mark.parametrize(
    ("key", "points", "words"),
    [
        ("rc_channel_1", (1250, 3750, 6250, 75), []),
        ("rc_channel_1", (1249, 3750, 6250, 75), ["minimum"]),
        ("rc_channel_1", (1249, 3750, 6251, 75), ["minimum", "maximum"]),
        ("rc_channel_1", (1000, 1000, 5000, 75), []),
        ("analog_channel_1", (0, 1023, 1023, 20), []),
        ("analog_channel_1", (0, 2000, 2000, 20), []),
    ],
)
def test_calibration_end_out_of_reach_is_reported(
    key: str, points: tuple[int, int, int, int], words: list[str]
) -> None:
    messages = [found.message for found in lint(calibrated(key, *points))]
    assert [message.split()[1] for message in messages] == words


@pytest.mark.parametrize("key", ["rc_channel_4", "rc_channel_5"])
def test_switch_calibrations_are_not_checked(key: str) -> None:
    assert lint(calibrated(key, 0, 3750, 9000, 9000)) == ()


def test_polynomial_0x80_always_gives_checksum_zero() -> None:
    packets = [bytes([value, other]) for value in range(256) for other in (0, 85, 255)]
    assert {crc7(packet, 0x80) for packet in packets} == {0}


@pytest.mark.parametrize(("baud", "real"), [(28800, 14400), (38400, 19200)])
def test_old_firmware_is_checked_at_its_actual_baud_rate(baud: int, real: int) -> None:
    old, new = trex("1.1", uart_settings=uart(baud)), trex("1.2", uart_settings=uart(baud))
    in_use = Context(port_rates=[real], active_line=LineSettings(real))
    assert [found.rule for found in lint(old, in_use)] == ["half_rate"]
    assert [found.rule for found in lint(new, in_use)] == [
        "rate_the_port_lacks",
        "line_will_change",
    ]
    assert lint(new) == lint(trex(uart_settings=uart(baud))) == ()


@pytest.mark.parametrize(
    ("rates", "used", "wanted"),
    [
        ([], None, None),
        ([250_000], None, None),
        ([9600, 19200], None, 19200),
        ([115200], None, 115200),
        ([9600, 19200], LineSettings(9600), 9600),
        ([9600, 19200], LineSettings(76800), "silent"),
        ([19200, 38400, 57600], None, 57600),
    ],
)
def test_proposed_baud_rate_is_supported_by_port(
    rates: list[int], used: LineSettings | None, wanted: int | str | None
) -> None:
    context = Context(port_rates=rates, active_line=used)
    found = [
        one
        for one in lint(trex("1.0", uart_settings=uart(76800)), context)
        if one.rule == "rate_the_port_lacks"
    ]
    if wanted == "silent":
        assert found == []
    else:
        (one,) = found
        assert one.change == ({} if wanted is None else {"uart_settings": uart(int(wanted))})
        assert bool(one.proposal) == bool(one.change)


def test_next_faster_rate_is_proposed_without_slower_one() -> None:
    context = Context(port_rates=[115200, 9600, 19200])
    (found,) = lint(trex(uart_settings=uart(2400)), context)
    assert found.change == {"uart_settings": uart(9600)}


def test_invalid_values_are_not_checked() -> None:
    broken = Settings(
        TREX_JR,
        "1.0",
        {
            "uart_settings": 0x0F,
            "motor1_pwm_prescaler": 9,
            "motor1_pwm_maximum": 0,
            "required_channels": 99,
            "ignored_channels": 31,
            "motor_mode": 7,
            "motor1_current_limit": 1,
        },
        {CalibrationKey.RC_CHANNEL_1: Calibration(9, 8, 7, 6)},
    )
    assert lint(broken, Context(port_rates=[])) == ()


# All rules, any settings


JUDGED = {key for found in EXAMPLES.values() for key in found[2].keys}
JUDGED |= {key.replace("motor2", "motor1") for key in JUDGED}
JUDGED |= {key.replace("motor1", "motor2") for key in JUDGED}
VALUES = {
    # Small values and the ends are where the oddities are.
    spec.key: st.sampled_from(sorted(spec.valid)[:3]) | st.sampled_from(sorted(spec.valid))
    for spec in factory().specs
    if spec.key in JUDGED
}


@st.composite
def any_unusual_settings(draw: st.DrawFn) -> Settings:
    """Settings that often break rules."""
    key = st.sampled_from(sorted(JUDGED & set(CALIBRATION_KEYS)))
    calibrations = draw(st.dictionaries(key, any_calibration(), max_size=2))
    return Settings(
        product=draw(st.sampled_from([TREX, TREX_JR])),
        firmware=draw(st.sampled_from([None, "1.0", "1.2"])),
        parameters=draw(st.fixed_dictionaries({}, optional=VALUES)),
        calibrations={CALIBRATION_KEYS[key]: found for key, found in calibrations.items()},
    )


@st.composite
def any_context(draw: st.DrawFn) -> Context:
    rates = st.sampled_from(baud_rates())
    lines = st.builds(
        LineSettings, rates, st.sampled_from(list(Detection)), st.sampled_from([1, 2])
    )
    return Context(
        drives_from_computer=draw(st.booleans()),
        port_rates=draw(st.none() | st.sets(rates)),
        active_line=draw(st.none() | lines),
    )


def is_reported(found: LintFinding, after: tuple[LintFinding, ...]) -> bool:
    """Return whether a finding is reported again."""
    return any((one.rule, one.keys) == (found.rule, found.keys) for one in after)


@thorough
@given(given_settings=any_unusual_settings(), context=any_context())
def test_any_proposal_is_valid_and_clears_its_finding(
    given_settings: Settings, context: Context
) -> None:
    specs = given_settings.specs
    findings, better = lint(given_settings, context), given_settings
    order = [list(RULES).index(one.rule) for one in findings]
    assert order == sorted(order)
    for found in findings:
        better = accept(better, found)
        assert set(found.keys) <= {spec.key for spec in specs} | set(CALIBRATION_KEYS)
        assert set(found.change) <= set(found.keys)
        assert all(specs[key].problem(wire) is None for key, wire in found.change.items())
        assert bool(found.change) == bool(found.proposal)
        if found.change:
            assert not is_reported(found, lint(accept(given_settings, found), context))
    assert not any(found.change for found in lint(better, context))
    turned = replace(
        given_settings,
        parameters=dict(reversed([*given_settings.parameters.items()])),
        calibrations=dict(reversed([*given_settings.calibrations.items()])),
    )
    assert lint(turned, context) == findings
