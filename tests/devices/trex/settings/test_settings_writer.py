"""The text of a settings file, as a person meets it."""

from dataclasses import replace

import pytest
from ruamel.yaml import YAML

from tests.devices.trex.settings.samples import TREX, TREX_JR, factory
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.calibration import CALIBRATION_KEYS, Calibration, CalibrationKey
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_in_place import amend
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings

FACTORY = """\
product: TReX
# Factory defaults
firmware: 1.2

# Serial
device_number: 7
serial_timeout: 0               # off
uart_error_shutdown: 1          # on
uart_response_delay: 0          # off
crc7_polynomial: 9              # 0x89
uart_settings: 5                # 19200 baud, no error detection, 1 stop bit

# Channels
required_channels: 1            # channel 1
ignored_channels: 0             # none
reversed_channels: 0            # none
parabolic_channels: 0           # none
channel_input_source: 0         # RC

# Motors
motor1_deadband_brake_pwm: 127  # 100 %
motor2_deadband_brake_pwm: 127  # 100 %
motor1_pwm_prescaler: 1         # clock / 64, 2441 Hz
motor2_pwm_prescaler: 1         # clock / 64, 2441 Hz
motor1_pwm_maximum: 63          # 127, 2441 Hz
motor2_pwm_maximum: 63          # 127, 2441 Hz
aux_pwm_maximum: 63             # 127
motor1_acceleration: 0          # no ramp
motor2_acceleration: 0          # no ramp
aux_acceleration: 0             # no ramp
motor1_brake_duration: 0        # no braking
motor2_brake_duration: 0        # no braking
motor1_current_limit: 0         # off
motor2_current_limit: 0         # off
motor1_current_limit_p: 4
motor2_current_limit_p: 4
motor_mode: 0                   # independent
"""

RC = "{minimum: 2500, neutral: 3750, maximum: 5000, deadband: 75}"
RC_TEXT = "1000 / 1500 / 2000 µs, deadband 30 µs"
ANALOG = "{minimum: 0, neutral: 512, maximum: 1023, deadband: 20}"
ANALOG_TEXT = "0.00 / 2.50 / 5.00 V, deadband 0.10 V"


def test_notes_are_comments_above_their_settings() -> None:
    notes = {
        "serial_timeout": "radio drops out\nsee the log of 3 May",
        "rc_channel_2": "new stick",
        "motor_mode": "two motors",
    }
    given = factory()
    parameters = {key: given.parameters[key] for key in ("device_number", "serial_timeout")}
    settings = replace(given, parameters=parameters, notes=notes)
    text = write_settings(settings)
    assert "device_number: 7\n# Note on serial_timeout: radio drops out\n" in text
    assert "# Note on serial_timeout: see the log of 3 May\nserial_timeout: 0 " in text
    assert "\n# Note on rc_channel_2: new stick\nrc_channel_2: {minimum" in text
    assert text.endswith("\n\n# Note on motor_mode: two motors\n")
    assert read_settings(text)[0] == settings

    for line in ("# note on serial_timeout: x", "#Note on motor_mode: x", "# Note on speed: x"):
        assert read_settings(f"{text}{line}\n")[0] == settings, "a comment like any other"
    changed = replace(settings, notes={"serial_timeout": "no", "device_number": "left one"})
    amended = amend(text, changed)
    assert "# Note on device_number: left one\ndevice_number: 7" in amended
    assert "# Note on serial_timeout: no\nserial_timeout: 0 " in amended
    assert amended.count("# Note on") == 2


def test_factory_settings_are_written_as_expected_text() -> None:
    rc = [f"rc_channel_{channel}: {RC}  # {RC_TEXT}" for channel in range(1, 6)]
    analog = [f"analog_channel_{channel}: {ANALOG}  # {ANALOG_TEXT}" for channel in range(1, 6)]
    calibrations = [
        "",
        "# Calibrations for RC pulses, in counts of 0.4 µs",
        *rc,
        "",
        "# Calibrations for analog voltages, in counts of 4.89 mV",
        *analog,
    ]
    text = write_settings(factory(), title_lines=["Factory defaults"])
    assert text.splitlines() == FACTORY.splitlines() + calibrations
    assert text.endswith("}  # " + ANALOG_TEXT + "\n")


def test_file_without_firmware_and_settings_is_one_line() -> None:
    assert write_settings(Settings(TREX_JR)) == "product: TReX Jr\n"


def test_standard_yaml_parser_reads_same_values() -> None:
    data = YAML(typ="safe", pure=True).load(write_settings(factory()))
    assert data["product"] == "TReX"
    assert data["rc_channel_5"] == {
        "minimum": 2500,
        "neutral": 3750,
        "maximum": 5000,
        "deadband": 75,
    }
    assert {key: data[key] for key in factory().parameters} == factory().parameters


def test_changing_one_value_changes_one_line() -> None:
    settings = factory()
    changed = replace(settings, parameters={**settings.parameters, "serial_timeout": 127})
    before, after = write_settings(settings), write_settings(changed)
    differing = [line for line in after.splitlines() if line not in before.splitlines()]
    assert differing == ["serial_timeout: 127             # 12.7 s"]


def test_physical_values_depend_on_model() -> None:
    limits = [
        write_settings(Settings(model, None, {"motor1_current_limit": 100})).split("# ")[-1]
        for model in (TREX, TREX_JR)
    ]
    assert limits[0] != limits[1]


def test_written_text_does_not_depend_on_order_of_settings() -> None:
    settings = factory()
    turned = replace(
        settings,
        parameters=dict(reversed(list(settings.parameters.items()))),
        calibrations=dict(reversed(list(settings.calibrations.items()))),
    )
    assert write_settings(turned) == write_settings(settings)


@pytest.mark.parametrize("line", ["a\nproduct: Tic", "\x00\x1b[2J", "\ud800", "a\u2028b", "\t%"])
def test_title_cannot_become_setting_or_damage_file(line: str) -> None:
    text = write_settings(factory(), title_lines=[line, ""])
    assert read_settings(text.encode("utf-8")) == (factory(), ())


def test_invalid_value_is_written_as_comment() -> None:
    settings = factory()
    broken = Calibration(0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF)
    key = CalibrationKey.RC_CHANNEL_2
    unexpected = replace(
        settings,
        parameters={**settings.parameters, "uart_settings": 12},
        calibrations={**settings.calibrations, key: broken},
    )
    text = write_settings(unexpected)
    assert "\n# uart_settings: 12  # left out: " in text
    assert "\n# rc_channel_2: {minimum: 65535, " in text
    read, findings = read_settings(text)
    assert [found.message for found in findings] == ["1 of 28 parameters is missing: uart_settings"]
    assert "uart_settings" not in read.parameters
    assert key not in read.calibrations
    assert len(read.calibrations) == len(CALIBRATION_KEYS) - 1


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        (
            Settings(TREX, "1.0", {"uart_response_delay": 1}),
            "a TReX 1.0 has no uart_response_delay",
        ),
        (Settings(TREX, None, {"factory_reset": 127}), "a TReX has no factory_reset"),
        (Settings(TREX, "1.2", {"speed": 1}), "a TReX 1.2 has no speed"),
    ],
    ids=["newer firmware", "factory reset", "unknown"],
)
def test_setting_unknown_to_board_is_rejected(settings: Settings, words: str) -> None:
    with pytest.raises(BadRequest, match=words):
        write_settings(settings)
