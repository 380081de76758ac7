"""Parameter table of both models and every firmware, compared with the reference."""

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.parameters import (
    Grade,
    MotorParameter,
    ParameterKey,
    ParameterKind,
    ParameterSpec,
    parameters_of,
)

MODELS = ("trex", "trexjr")
FIRMWARES = ("1.0", "1.1", "1.2", "1.3")
BOARDS = [(model, firmware) for model in MODELS for firmware in FIRMWARES]

every_board = pytest.mark.parametrize(("model", "firmware"), BOARDS)
every_model = pytest.mark.parametrize("model", MODELS)

# Number → key, smallest and largest wire value, default of the TReX, default of the TReX Jr.
FACTS: dict[int, tuple[str, int, int, int, int]] = {
    0x00: ("device_number", 0, 127, 7, 7),
    0x01: ("required_channels", 0, 0x1F, 1, 1),
    0x02: ("ignored_channels", 0, 0x1F, 0, 0),
    0x03: ("reversed_channels", 0, 0x1F, 0, 0),
    0x04: ("parabolic_channels", 0, 0x1F, 0, 0),
    0x05: ("motor1_deadband_brake_pwm", 0, 127, 127, 127),
    0x06: ("motor2_deadband_brake_pwm", 0, 127, 127, 127),
    0x07: ("serial_timeout", 0, 127, 0, 0),
    0x08: ("uart_error_shutdown", 0, 1, 1, 1),
    0x09: ("motor1_pwm_prescaler", 0, 3, 1, 1),
    0x0A: ("motor2_pwm_prescaler", 0, 3, 1, 1),
    0x0B: ("motor1_pwm_maximum", 0, 127, 0x3F, 0x3F),
    0x0C: ("motor2_pwm_maximum", 0, 127, 0x3F, 0x3F),
    0x0D: ("aux_pwm_maximum", 0, 127, 0x3F, 0x3F),
    0x0E: ("motor1_acceleration", 0, 127, 0, 0),
    0x0F: ("motor2_acceleration", 0, 127, 0, 0),
    0x10: ("aux_acceleration", 0, 127, 0, 0),
    0x11: ("motor1_brake_duration", 0, 127, 0, 0),
    0x12: ("motor2_brake_duration", 0, 127, 0, 0),
    0x13: ("motor1_current_limit", 0, 127, 0, 0),
    0x14: ("motor2_current_limit", 0, 127, 0, 0),
    0x15: ("motor1_current_limit_p", 0, 127, 4, 4),
    0x16: ("motor2_current_limit_p", 0, 127, 4, 4),
    0x17: ("uart_response_delay", 0, 1, 0, 0),
    0x7B: ("motor_mode", 0, 1, 0, 0),
    0x7C: ("channel_input_source", 0, 1, 0, 0),
    0x7D: ("crc7_polynomial", 0, 127, 0x09, 0x09),
    0x7E: ("uart_settings", 0, 0x7A, 0x05, 0x05),
    0x7F: ("factory_reset", 0x7F, 0x7F, 0x7F, 0x7F),
}


def parameter(key: str, model: str = "trex") -> ParameterSpec:
    return parameters_of(model, "1.2")[key]


# Contents


@every_board
def test_board_has_exactly_the_documented_parameters(model: str, firmware: str) -> None:
    numbers = [spec.number for spec in parameters_of(model, firmware)]
    since_1_2 = [0x17] if firmware in {"1.2", "1.3"} else []
    assert numbers == [*range(0x17), *since_1_2, *range(0x7B, 0x80)]


@every_board
def test_keys_limits_and_defaults_match_reference(model: str, firmware: str) -> None:
    for spec in parameters_of(model, firmware):
        key, minimum, maximum, default_trex, default_trexjr = FACTS[spec.number]
        default = default_trex if model == "trex" else default_trexjr
        found = (spec.key, spec.minimum, spec.maximum, spec.default)
        assert found == (key, minimum, maximum, default)


@every_board
def test_only_0x7b_to_0x7f_need_power_cycle(model: str, firmware: str) -> None:
    delayed = {spec.number for spec in parameters_of(model, firmware) if spec.needs_power_cycle}
    assert delayed == {0x7B, 0x7C, 0x7D, 0x7E, 0x7F}


@every_board
def test_only_factory_reset_cannot_be_read(model: str, firmware: str) -> None:
    found = parameters_of(model, firmware)
    assert [spec.number for spec in found if not spec.readable] == [0x7F]
    assert [*found.readable] == [spec for spec in found if spec.number != 0x7F]


@every_model
def test_unknown_newer_firmware_has_all_parameters(model: str) -> None:
    for firmware in ("1.10", "2.0"):
        assert len(parameters_of(model, firmware).specs) == len(FACTS)


@pytest.mark.parametrize("number", [0x18, 0x40, 0x7A, 0x80, -1])
def test_undocumented_number_is_no_parameter(number: int) -> None:
    assert parameters_of("trex", "1.2").number(number) is None


@every_model
def test_every_parameter_has_name_and_description(model: str) -> None:
    for spec in parameters_of(model, "1.3"):
        assert spec.name
        assert len(spec.description) > 20
        assert spec.description.endswith(".")


@every_model
def test_choice_parameter_has_a_word_for_every_value(model: str) -> None:
    for spec in parameters_of(model, "1.3"):
        if spec.kind is ParameterKind.CHOICE:
            assert set(spec.choices) == spec.valid
            assert len(set(spec.choices.values())) == len(spec.choices)
        else:
            assert not spec.choices


@every_model
def test_keys_and_names_are_unique(model: str) -> None:
    found = parameters_of(model, "1.3").specs
    assert len({spec.key for spec in found}) == len(found)
    assert len({spec.name for spec in found}) == len(found)


def test_default_prescaler_is_sourced_only_for_trex_jr() -> None:
    assert parameter("motor1_pwm_prescaler", "trexjr").grade("default") is Grade.SOURCED
    assert parameter("motor1_pwm_prescaler", "trex").grade("default") is Grade.INFERRED


def test_weakest_evidence_of_several_fields_counts() -> None:
    assert parameter("serial_timeout").grade("min", "max") is Grade.SOURCED
    assert parameter("motor_mode").grade("min", "max") is Grade.INFERRED


@every_model
def test_facts_of_the_twin_have_its_grade(model: str) -> None:
    """The facts are in the guide of the qik 2s12v10, pages 20 to 22."""
    found = parameters_of(model, "1.3").specs
    graded = {
        (spec.key.removeprefix("motor1_"), field)
        for spec in found
        for field, grade in spec.grades.items()
        if grade is Grade.TWIN and not spec.key.startswith("motor2_")
    }
    assert graded == {
        ("serial_timeout", "default"),
        ("brake_duration", "default"),
        *(("current_limit", field) for field in ("min", "max", "default", "zero")),
        *(("current_limit_p", field) for field in ("min", "max", "default")),
    }


# Limits


@every_model
def test_wire_value_is_valid_only_within_limits(model: str) -> None:
    for spec in parameters_of(model, "1.3"):
        for wire in range(-1, 130):
            allowed = spec.minimum <= wire <= spec.maximum
            if spec.kind is ParameterKind.UART:
                allowed = allowed and wire & 0x0F <= 10
            assert (spec.problem(wire) is None) is allowed


@every_model
def test_rejected_wire_value_names_parameter_value_and_limits(model: str) -> None:
    for spec in parameters_of(model, "1.3"):
        wire = spec.maximum + 1
        with pytest.raises(BadRequest) as caught:
            spec.check(wire)
        sentence = str(caught.value)
        assert sentence.startswith(f"{spec.name} must be ")
        assert sentence.endswith(f"not {wire}")
        limits = {
            ParameterKind.CHANNELS: ["1 to 5", "0 to 31"],
            ParameterKind.UART: ["0 to 10"],
            ParameterKind.CHOICE: [f"{wire} ({word})" for wire, word in spec.choices.items()],
            ParameterKind.RESET: ["127"],
            ParameterKind.ACCELERATION: ["0.1 to 12.7 s to full speed, or no ramp", "0 to 127"],
        }.get(spec.kind, [f"{spec.minimum} to {spec.maximum}", spec.text(spec.maximum)])
        for limit in limits:
            assert limit in sentence


# Text


def different_specs() -> list[ParameterSpec]:
    """Return the parameters of all models, without duplicates."""
    specs = [spec for model in MODELS for spec in parameters_of(model, "1.3")]
    return [*{tuple(map(spec.text, sorted(spec.valid))): spec for spec in specs}.values()]


def test_value_text_can_be_typed_back_in_any_case() -> None:
    for spec in different_specs():
        for wire in spec.valid:
            text = spec.text(wire)
            assert spec.wire(text) == spec.wire(f"  {text.upper()} ") == wire


def test_number_can_be_typed_without_unit_and_with_comma() -> None:
    for spec in different_specs():
        if spec.kind is ParameterKind.NUMBER:
            for wire in sorted(spec.valid - {0})[::7]:
                number = spec.text(wire).removesuffix(spec.unit).strip()
                assert spec.wire(number) == wire
                assert spec.wire(number.replace(".", ",")) == wire
                assert spec.wire(number + spec.unit) == wire


@every_model
def test_every_value_from_0_to_127_has_a_text(model: str) -> None:
    for spec in parameters_of(model, "1.3"):
        for wire in range(128):
            assert spec.text(wire)


@pytest.mark.parametrize(
    ("key", "model", "wire", "text"),
    [
        ("device_number", "trex", 7, "7"),
        ("required_channels", "trex", 0x13, "channels 1, 2, 5"),
        ("ignored_channels", "trex", 0, "none"),
        ("motor1_deadband_brake_pwm", "trex", 0, "coast"),
        ("serial_timeout", "trex", 0, "off"),
        ("serial_timeout", "trex", 15, "1.5 s"),
        ("uart_error_shutdown", "trex", 1, "on"),
        ("motor1_pwm_maximum", "trex", 0x3F, "127"),
        ("motor1_acceleration", "trex", 0, "no ramp"),
        ("motor1_brake_duration", "trex", 127, "1270 ms"),
        ("motor1_current_limit", "trex", 0, "off"),
        ("motor1_current_limit", "trex", 1, "0.3 A"),
        ("motor1_current_limit", "trexjr", 1, "0.08 A"),
        ("motor2_current_limit", "trexjr", 100, "8 A"),
        ("motor_mode", "trex", 1, "joint"),
        ("channel_input_source", "trex", 1, "analog"),
        ("crc7_polynomial", "trex", 0x09, "0x89"),
        ("uart_settings", "trex", 0x05, "19200 baud, no error detection, 1 stop bit"),
        ("uart_settings", "trex", 0x3A, "115200 baud, CRC-7, 2 stop bits"),
        ("uart_settings", "trex", 0x73, "9600 baud, odd parity, 2 stop bits"),
    ],
)
def test_value_text_matches_reference(key: str, model: str, wire: int, text: str) -> None:
    assert parameter(key, model).text(wire) == text


@pytest.mark.parametrize(
    ("key", "text", "wire"),
    [
        ("serial_timeout", "1500 ms", 15),
        ("serial_timeout", ".5", 5),
        ("serial_timeout", "2.", 20),
        ("serial_timeout", "0", 0),
        ("serial_timeout", "0 s", 0),
        ("serial_timeout", "1.54 s", 15),
        ("serial_timeout", "1.56 s", 16),
        ("motor1_brake_duration", "500 ms", 50),
        ("motor1_brake_duration", "no braking", 0),
        ("motor1_deadband_brake_pwm", "100%", 127),
        ("motor1_acceleration", "5 per 100 ms", 5),
        ("motor1_acceleration", "5", 5),
        ("motor1_acceleration", "500 ms to full speed", 25),
        ("motor1_acceleration", "0 s", 0),
        ("required_channels", "1, 2, 5", 0x13),
        ("required_channels", "Channel 3", 0x04),
        ("required_channels", "1 2 5", 0x13),
        ("required_channels", "5+2+1", 0x13),
        ("required_channels", "1;2;5", 0x13),
        ("crc7_polynomial", "0x09", 0x09),
        ("crc7_polynomial", "137", 0x09),
        ("crc7_polynomial", "9", 0x09),
        ("uart_settings", "0x0A", 0x0A),
        ("factory_reset", "127", 0x7F),
        # Where 0 means "off", it is the opposite of a very small value, not its neighbour.
        ("serial_timeout", "0.04 s", 1),
        ("serial_timeout", "40 ms", 1),
        ("motor1_current_limit", "100 mA", 1),
        ("motor2_current_limit", "0.1 A", 1),
        ("motor1_acceleration", "0.4", 1),
        ("motor2_acceleration", "0.4", 1),
        ("aux_acceleration", "0.4", 1),
    ],
)
def test_value_can_be_typed_in_other_forms(key: str, text: str, wire: int) -> None:
    assert parameter(key).wire(text) == wire


@pytest.mark.parametrize(
    ("key", "text", "limits"),
    [
        ("serial_timeout", "13 s", "12.7 s"),
        ("serial_timeout", "12.74 s", "12.7 s"),
        ("serial_timeout", "-1", "12.7 s"),
        ("serial_timeout", "-0.04 s", "12.7 s"),
        ("serial_timeout", "", "12.7 s"),
        ("serial_timeout", "1.5 A", "12.7 s"),
        ("serial_timeout", "1.5 s 2", "12.7 s"),
        ("serial_timeout", "1e1", "12.7 s"),
        ("serial_timeout", "nan", "12.7 s"),
        ("device_number", "128", "0 to 127"),
        ("device_number", "7 s", "0 to 127"),
        ("device_number", "7.4", "0 to 127"),  # a fraction of a numbered value
        ("device_number", "-0.4", "0 to 127"),
        ("required_channels", "6", "1 to 5"),
        ("required_channels", "0", "1 to 5"),
        ("required_channels", "1, x", "1 to 5"),
        ("required_channels", ",", "1 to 5"),
        ("required_channels", "channels", "1 to 5"),
        ("uart_error_shutdown", "2", "off or on"),
        ("uart_error_shutdown", "0.6", "off or on"),
        ("motor_mode", "0.4", "joint"),
        ("motor1_pwm_maximum", "300", "1 to 255"),
        ("motor1_pwm_maximum", "0", "1 to 255"),
        ("motor1_current_limit", "38.2 A", "38.1 A"),
        ("motor1_acceleration", "5 m", "0.1 to 12.7 s"),
        ("crc7_polynomial", "0x100", "0x80 to 0xFF"),
        ("crc7_polynomial", "0xZZ", "0x80 to 0xFF"),
        ("factory_reset", "0", "127"),
    ],
)
def test_invalid_text_is_rejected_with_limits(key: str, text: str, limits: str) -> None:
    with pytest.raises(BadRequest, match=re.escape(limits)) as caught:
        parameter(key).wire(text)
    assert str(caught.value).startswith(parameter(key).name)
    assert str(caught.value).endswith(f"not {text or 'an empty text'}")
    assert "127 to 127" not in str(caught.value), "a single value is no range"


@examples(30)
@given(text=st.text(max_size=12) | st.from_regex(r"[-+]?[0-9]{0,4}[.,]?[0-9]{0,3} ?[msAk%x]{0,2}"))
def test_any_text_gives_valid_value_or_is_rejected(text: str) -> None:
    for key in ("serial_timeout", "required_channels", "crc7_polynomial", "motor1_pwm_maximum"):
        spec = parameter(key)
        try:
            wire = spec.wire(text)
        except BadRequest:
            continue
        assert wire in spec.valid


@pytest.mark.parametrize("text", ["0x0B", "115200", "fast"])
def test_rejected_uart_settings_show_expected_format(text: str) -> None:
    with pytest.raises(BadRequest, match=r"\d+ baud, .*, \d stop bits?\b"):
        parameter("uart_settings").wire(text)


def test_very_long_numbers_are_rejected() -> None:
    for spec in different_specs():
        for text in ("9" * 5000, "0x" + "9" * 5000, "-" + "9" * 5000):
            with pytest.raises(BadRequest):
                spec.wire(text)


@pytest.mark.parametrize(
    ("key", "text"),
    [("serial_timeout", "127"), ("required_channels", "31"), ("motor1_current_limit", "100")],
)
def test_rejection_does_not_contradict_typed_number(key: str, text: str) -> None:
    # "Serial Timeout is off to 12.7 s (wire value 0 to 127), not 127" contradicts itself.
    with pytest.raises(BadRequest) as caught:
        parameter(key).wire(text)
    assert "wire value" not in str(caught.value)


# Search


@pytest.mark.parametrize("key", ["serial-timeout", " SERIAL_TIMEOUT ", "serial timeout"])
def test_case_and_separators_of_a_key_are_ignored(key: str) -> None:
    assert parameters_of("trex", "1.0")[key].number == 0x07


@every_model
def test_every_parameter_is_found_by_its_name_and_key(model: str) -> None:
    for spec in parameters_of(model, "1.3"):
        found = parameters_of("trex", "1.3")
        assert found[spec.name].number == found[spec.key].number == spec.number


@pytest.mark.parametrize(
    ("wrong", "proposal"),
    [
        ("serial_timout", "serial_timeout"),
        ("motor1_curent_limit", "motor1_current_limit"),
        ("uart_setting", "uart_settings"),
        ("xyzzy", None),
        ("", None),
    ],
)
def test_unknown_key_is_rejected_with_similar_key(wrong: str, proposal: str | None) -> None:
    with pytest.raises(BadRequest, match="has no parameter") as caught:
        parameters_of("trex", "1.0")[wrong]
    hint = re.search(r"did you mean (\w+)\?", str(caught.value))
    assert (hint and hint[1]) == proposal


def test_newer_parameter_is_rejected_with_board_and_firmware() -> None:
    with pytest.raises(BadRequest, match=r"TReX Jr 1\.1 has no parameter 'uart_response_delay'"):
        parameters_of("trexjr", "1.1")["uart_response_delay"]


def test_keys_in_code_are_in_the_table() -> None:
    of_motors = {parameter.of(motor) for parameter in MotorParameter for motor in (1, 2)}
    assert {*ParameterKey, *of_motors} <= {spec.key for spec in parameters_of("trex", "1.3")}
    assert [key.name for key in ParameterKey] == [key.upper() for key in ParameterKey]
