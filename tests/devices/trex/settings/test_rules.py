"""Findings and proposals of the rules for settings."""

from collections.abc import Mapping
from dataclasses import replace

import pytest
from hypothesis import Phase, given
from hypothesis import strategies as st

from tests.devices.trex.settings.samples import (
    TREX,
    TREX_JR,
    any_calibration,
    factory,
    in_reverse_order,
)
from tests.support.matrix import examples
from trex_gui.devices.trex.protocol.calibration import CALIBRATION_KEYS, Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.framing import crc7
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.rules import RULES, Context, LintFinding, lint

thorough = examples(20, phases=[Phase.generate])
NO_CONTEXT = Context()
DRIVING = Context(drives_from_computer=True)


def uart(baud: int, detection: Detection = Detection.NONE, stop_bits: int = 1) -> int:
    return LineSettings(baud, detection, stop_bits).to_wire()


def trex(firmware: str | None = None, **parameters: int) -> Settings:
    return Settings(TREX, firmware, parameters)


def only_finding(settings: Settings, context: Context = NO_CONTEXT) -> LintFinding:
    (finding,) = lint(settings, context)
    return finding


def accept(settings: Settings, finding: LintFinding) -> Settings:
    return replace(settings, parameters={**settings.parameters, **finding.change})


def calibrated(key: str, *points: int) -> Settings:
    return Settings(TREX, None, {}, {CALIBRATION_KEYS[key]: Calibration(*points)})


# --- One complete finding for each rule --------------------------------------------------


EXAMPLES: Mapping[str, tuple[Settings, Context, LintFinding]] = {
    expected.rule: (settings, context, expected)
    for settings, context, expected in [
        (
            trex(serial_timeout=0),
            DRIVING,
            LintFinding(
                "no_serial_timeout",
                ("serial_timeout", "uart_error_shutdown"),
                "Serial Timeout is off while a computer drives the motors: if the cable or the "
                "computer fails, the motors keep running at their last setpoint.",
                {"serial_timeout": 5, "uart_error_shutdown": 1},
                "Set Serial Timeout to 0.5 s and UART-Error Shutdown to on",
            ),
        ),
        (
            trex(serial_timeout=5, uart_error_shutdown=0),
            NO_CONTEXT,
            LintFinding(
                "timeout_without_shutdown",
                ("serial_timeout", "uart_error_shutdown"),
                "Serial Timeout of 0.5 s may not stop the motors if the cable or the computer "
                "fails: UART-Error Shutdown is off (twin).",
                {"uart_error_shutdown": 1},
                "Set UART-Error Shutdown to on",
            ),
        ),
        (
            trex(motor_mode=1, motor1_current_limit=10, motor2_current_limit=20),
            Context(),
            LintFinding(
                "limit_in_joint_mode",
                ("motor_mode", "motor1_current_limit", "motor2_current_limit"),
                "No effect in joint mode: Motor 1 Current Limit (3 A) and Motor 2 Current Limit (6 "
                "A). In this mode the board measures no current, so the motor is not protected.",
                {"motor1_current_limit": 0, "motor2_current_limit": 0},
                "Set Motor 1 Current Limit and Motor 2 Current Limit to off",
            ),
        ),
        (
            trex(motor2_current_limit=10, motor2_current_limit_p=0),
            Context(),
            LintFinding(
                "limit_without_gain",
                ("motor2_current_limit", "motor2_current_limit_p"),
                "Motor 2 Current Limit is 3 A, but its proportionality constant P, which sets how "
                "strongly the limiter reacts, is 0. Therefore, the limit may have no effect "
                "(inferred).",
                {"motor2_current_limit_p": 4},
                "Set Motor 2 Current Limit Proportionality Constant P to 4",
            ),
        ),
        (
            trex(motor1_current_limit=10, motor1_acceleration=0),
            Context(),
            LintFinding(
                "limit_without_ramp",
                ("motor1_current_limit", "motor1_acceleration"),
                "Motor 1 Current Limit is 3 A and Motor 1 Acceleration is 0, so the speed changes "
                "at once. As soon as the current falls below the limit, the motor jumps back to "
                "its full target speed, so it may run in jerks (inferred).",
                {"motor1_acceleration": 10},
                "Set Motor 1 Acceleration to 1.3 s to full speed",
            ),
        ),
        (
            Settings(TREX_JR, None, {"motor2_pwm_prescaler": 0, "motor2_pwm_maximum": 63}),
            Context(),
            LintFinding(
                "pwm_above_rating",
                ("motor2_pwm_prescaler", "motor2_pwm_maximum"),
                "The PWM of motor 2 runs at 19.5 kHz (inferred), but the motor driver of a TReX "
                "Jr is rated for 10 kHz. Above this frequency, the driver gets hot. Prescaler "
                "clock / 64 gives 2.44 kHz.",
                {"motor2_pwm_prescaler": 1},
                "Set Motor 2 PWM Prescaler to clock / 64",
            ),
        ),
        (
            trex(required_channels=0b00111, ignored_channels=0b10110),
            Context(),
            LintFinding(
                "required_but_ignored",
                ("required_channels", "ignored_channels"),
                "Both required and ignored: channel 2 and channel 3. The signal controls nothing, "
                "but without the signal the motors may not run in RC mode (inferred).",
                {"required_channels": 1},
                "Set Required Channels to channel 1",
            ),
        ),
        (
            calibrated("rc_channel_2", 2500, 3750, 5000, 1250),
            Context(),
            LintFinding(
                "deadband_over_travel",
                ("rc_channel_2",),
                "The deadband of RC channel 2 reaches from neutral to its minimum and maximum: "
                "there is nothing between standstill and full speed on that side.",
                {},
                "",
            ),
        ),
        (
            calibrated("analog_channel_3", 0, 512, 1100, 20),
            Context(),
            LintFinding(
                "end_out_of_reach",
                ("analog_channel_3",),
                "The maximum of analog channel 3, 1100, is beyond 1023, the last count that the "
                "board measures: full speed on that side is never reached.",
                {},
                "",
            ),
        ),
        (
            trex(crc7_polynomial=0x1B, uart_settings=uart(19200, Detection.EVEN)),
            Context(),
            LintFinding(
                "polynomial_without_crc",
                ("crc7_polynomial", "uart_settings"),
                "CRC-7 Polynomial is 0x9B instead of the default 0x89, but CRC-7 is not "
                "switched on: no packet is checked with it.",
                {"crc7_polynomial": 9},
                "Set CRC-7 Polynomial to 0x89",
            ),
        ),
        (
            trex(crc7_polynomial=0, uart_settings=uart(19200, Detection.CRC7)),
            Context(),
            LintFinding(
                "crc_that_checks_nothing",
                ("crc7_polynomial", "uart_settings"),
                "With 0x80 as CRC-7 Polynomial the checksum of every packet is 0, so CRC-7 detects "
                "no errors at all.",
                {"crc7_polynomial": 9},
                "Set CRC-7 Polynomial to 0x89",
            ),
        ),
        (
            trex("1.1", uart_settings=uart(38400, Detection.ODD, 2)),
            Context(),
            LintFinding(
                "half_rate",
                ("uart_settings",),
                "A TReX with firmware 1.1 set to 38400 baud really runs at 19200 baud; firmware "
                "1.2 corrects this. Programs must use 19200 baud.",
                {"uart_settings": uart(19200, Detection.ODD, 2)},
                "Set UART Settings to 19200 baud, odd parity, 2 stop bits",
            ),
        ),
        (
            trex(uart_settings=uart(76800)),
            Context(port_rates=[9600, 57600, 115200]),
            LintFinding(
                "rate_the_port_lacks",
                ("uart_settings",),
                "This computer's serial port does not support 76800 baud: after the next power "
                "cycle, the computer could no longer reach the board.",
                {"uart_settings": uart(57600)},
                "Set UART Settings to 57600 baud, no error detection, 1 stop bit",
            ),
        ),
        (
            trex(uart_settings=uart(115200)),
            Context(active_line=LineSettings()),
            LintFinding(
                "line_will_change",
                ("uart_settings",),
                "After the next power cycle, the line settings of the board will be 115200 baud, "
                "no error detection, 1 stop bit instead of 19200 baud, no error detection, 1 stop "
                "bit. Programs that use the board must then use the new line settings.",
                {},
                "",
            ),
        ),
    ]
}


def test_every_rule_has_example() -> None:
    assert list(EXAMPLES) == list(RULES)


@pytest.mark.parametrize("rule", RULES)
def test_rule_reports_expected_finding(rule: str) -> None:
    settings, context, expected = EXAMPLES[rule]
    finding = only_finding(settings, context)
    assert finding == expected
    if expected.change:
        assert lint(accept(settings, finding), context) == ()


@pytest.mark.parametrize("rule", RULES)
def test_rule_is_silent_if_required_setting_is_missing(rule: str) -> None:
    settings, context, _ = EXAMPLES[rule]
    for key in settings.parameters:
        parameters = {**settings.parameters}
        del parameters[key]
        findings = lint(replace(settings, parameters=parameters), context)
        assert not [finding for finding in findings if key in finding.keys]


# --- Conditions of single rules ----------------------------------------------------------


@pytest.mark.parametrize("model", ["trex", "trexjr"])
@pytest.mark.parametrize("firmware", [None, "1.0", "1.3"])
def test_factory_settings_have_no_findings(model: str, firmware: str | None) -> None:
    context = Context(port_rates=baud_rates(), active_line=LineSettings())
    assert lint(factory(model, firmware), context) == ()


def test_empty_settings_have_no_findings() -> None:
    context = Context(drives_from_computer=True, port_rates=[], active_line=LineSettings(1200))
    assert lint(Settings(TREX), context) == ()


def test_timeout_rule_applies_only_if_computer_drives() -> None:
    assert lint(trex(serial_timeout=0)) == ()
    assert lint(trex(serial_timeout=1), DRIVING) == ()


def test_joint_mode_finding_names_only_active_limit() -> None:
    finding = only_finding(trex(motor_mode=1, motor1_current_limit=1, motor2_current_limit=0))
    assert finding.message.startswith("No effect in joint mode: Motor 1 Current Limit (0.3 A).")
    assert finding.proposal == "Set Motor 1 Current Limit to off"


def test_joint_mode_limit_needs_no_gain_or_ramp() -> None:
    parameters = {"motor1_current_limit": 1, "motor1_acceleration": 0, "motor1_current_limit_p": 0}
    settings = Settings(TREX, None, {"motor_mode": 1, **parameters})
    assert only_finding(settings).rule == "limit_in_joint_mode"


@pytest.mark.parametrize("prescaler", range(4))
@pytest.mark.parametrize("maximum", [0, 1, 61, 123, 124, 127])
def test_pwm_proposal_is_smallest_sufficient_prescaler(prescaler: int, maximum: int) -> None:
    parameters = {"motor1_pwm_prescaler": prescaler, "motor1_pwm_maximum": maximum}
    divisors = (8, 64, 256, 1024)
    frequencies = [20e6 / (divisor * (2 * maximum + 2)) for divisor in divisors]
    findings = lint(Settings(TREX_JR, None, parameters))
    if frequencies[prescaler] <= 10_000:
        assert findings == ()
    else:
        valid = (number for number, frequency in enumerate(frequencies) if frequency <= 10_000)
        assert findings[0].change == {"motor1_pwm_prescaler": min(valid)}


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
    messages = [finding.message for finding in lint(calibrated("rc_channel_1", *points))]
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
    messages = [finding.message for finding in lint(calibrated(key, *points))]
    assert [message.split()[1] for message in messages] == words


@pytest.mark.parametrize("key", ["rc_channel_4", "rc_channel_5"])
def test_switch_calibrations_are_not_checked(key: str) -> None:
    assert lint(calibrated(key, 0, 3750, 9000, 9000)) == ()


def test_polynomial_0x80_always_gives_checksum_zero() -> None:
    packets = [bytes([value, other]) for value in range(256) for other in (0, 85, 255)]
    assert {crc7(packet, 0x80) for packet in packets} == {0}


@pytest.mark.parametrize(("baud", "actual"), [(28800, 14400), (38400, 19200)])
def test_old_firmware_is_checked_at_its_actual_baud_rate(baud: int, actual: int) -> None:
    old, new = trex("1.1", uart_settings=uart(baud)), trex("1.2", uart_settings=uart(baud))
    context = Context(port_rates=[actual], active_line=LineSettings(actual))
    assert [finding.rule for finding in lint(old, context)] == ["half_rate"]
    assert [finding.rule for finding in lint(new, context)] == [
        "rate_the_port_lacks",
        "line_will_change",
    ]
    assert lint(new) == lint(trex(uart_settings=uart(baud))) == ()


@pytest.mark.parametrize(
    ("rates", "active", "proposed"),
    [
        ([], None, None),
        ([250_000], None, None),
        ([9600, 19200], None, 19200),
        ([115200], None, 115200),
        ([9600, 19200], LineSettings(9600), 9600),
        ([9600, 19200], LineSettings(76800), "no finding"),
        ([19200, 38400, 57600], None, 57600),
    ],
)
def test_proposed_baud_rate_is_supported_by_port(
    rates: list[int], active: LineSettings | None, proposed: int | str | None
) -> None:
    context = Context(port_rates=rates, active_line=active)
    findings = [
        finding
        for finding in lint(trex("1.0", uart_settings=uart(76800)), context)
        if finding.rule == "rate_the_port_lacks"
    ]
    if proposed == "no finding":
        assert findings == []
    else:
        (finding,) = findings
        change = {} if proposed is None else {"uart_settings": uart(int(proposed))}
        assert finding.change == change
        assert bool(finding.proposal) == bool(change)


def test_next_faster_rate_is_proposed_without_slower_one() -> None:
    context = Context(port_rates=[115200, 9600, 19200])
    finding = only_finding(trex(uart_settings=uart(2400)), context)
    assert finding.change == {"uart_settings": uart(9600)}


def test_invalid_values_are_not_checked() -> None:
    invalid = Settings(
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
    assert lint(invalid, Context(port_rates=[])) == ()


# --- All rules, any settings -------------------------------------------------------------


CHECKED = {key for _, _, expected in EXAMPLES.values() for key in expected.keys}
CHECKED |= {key.replace("motor2", "motor1") for key in CHECKED}
CHECKED |= {key.replace("motor1", "motor2") for key in CHECKED}
VALUES = {
    # Most findings concern small values.
    spec.key: st.sampled_from(sorted(spec.valid)[:3]) | st.sampled_from(sorted(spec.valid))
    for spec in factory().specs
    if spec.key in CHECKED
}


@st.composite
def any_unusual_settings(draw: st.DrawFn) -> Settings:
    """Settings that often have findings."""
    key = st.sampled_from(sorted(CHECKED & set(CALIBRATION_KEYS)))
    calibrations = draw(st.dictionaries(key, any_calibration(), max_size=2))
    return Settings(
        product=draw(st.sampled_from([TREX, TREX_JR])),
        firmware=draw(st.sampled_from([None, "1.0", "1.2"])),
        parameters=draw(st.fixed_dictionaries({}, optional=VALUES)),
        calibrations={CALIBRATION_KEYS[key]: value for key, value in calibrations.items()},
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


@thorough
@given(settings=any_unusual_settings(), context=any_context())
def test_any_proposal_is_valid_and_resolves_its_finding(
    settings: Settings, context: Context
) -> None:
    specs = settings.specs
    findings, improved = lint(settings, context), settings
    order = [list(RULES).index(finding.rule) for finding in findings]
    assert order == sorted(order)
    for finding in findings:
        improved = accept(improved, finding)
        assert set(finding.keys) <= {spec.key for spec in specs} | set(CALIBRATION_KEYS)
        assert set(finding.change) <= set(finding.keys)
        assert all(specs[key].problem(wire) is None for key, wire in finding.change.items())
        assert bool(finding.change) == bool(finding.proposal)
        if finding.change:
            remaining = lint(accept(settings, finding), context)
            assert (finding.rule, finding.keys) not in [
                (other.rule, other.keys) for other in remaining
            ]
    assert not any(finding.change for finding in lint(improved, context))
    assert lint(in_reverse_order(settings), context) == findings
