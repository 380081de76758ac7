"""Text of written settings files."""

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


def test_notes_are_comments_above_their_settings() -> None:
    notes = {
        "serial_timeout": "radio drops out\nsee the log of 3 May",
        "rc_channel_2": "new stick",
        "motor_mode": "two motors",
    }
    parameters = {"device_number": 7, "serial_timeout": 0}
    settings = replace(factory(), parameters=parameters, notes=notes)
    text = write_settings(settings)
    assert "device_number: 7\n# Note on serial_timeout: radio drops out\n" in text
    assert "# Note on serial_timeout: see the log of 3 May\nserial_timeout: 0 " in text
    assert "\n# Note on rc_channel_2: new stick\nrc_channel_2: {minimum" in text
    assert text.endswith("\n\n# Note on motor_mode: two motors\n")
    assert read_settings(text)[0] == settings

    for line in ("# note on serial_timeout: x", "#Note on motor_mode: x", "# Note on speed: x"):
        assert read_settings(f"{text}{line}\n")[0] == settings, "the line is an ordinary comment"
    changed = replace(settings, notes={"serial_timeout": "no", "device_number": "left arm"})
    amended = amend(text, changed)
    assert "# Note on device_number: left arm\ndevice_number: 7" in amended
    assert "# Note on serial_timeout: no\nserial_timeout: 0 " in amended
    assert amended.count("# Note on") == 2


def test_file_without_firmware_and_settings_has_one_line() -> None:
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


@pytest.mark.parametrize("line", ["a\nproduct: Tic", "\x00\x1b[2J", "\ud800", "a\u2028b", "\t%"])
def test_title_is_written_only_as_comment(line: str) -> None:
    text = write_settings(factory(), title_lines=["bench", line, ""])
    assert text.startswith("product: TReX\n# bench\n")
    assert read_settings(text.encode("utf-8")) == (factory(), ())


def test_invalid_value_is_written_as_comment() -> None:
    settings = factory()
    broken = Calibration(0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF)
    key = CalibrationKey.RC_CHANNEL_2
    invalid = replace(
        settings,
        parameters={**settings.parameters, "uart_settings": 12},
        calibrations={**settings.calibrations, key: broken},
    )
    text = write_settings(invalid)
    assert "\n# uart_settings: 12  # left out: " in text
    assert "\n# rc_channel_2: {minimum: 65535, " in text
    read, findings = read_settings(text)
    assert [finding.message for finding in findings] == [
        "1 of 28 parameters is missing: uart_settings"
    ]
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
