"""Sample files for users, and golden files of written settings."""

from pathlib import Path

import pytest

from tests.devices.trex.settings.samples import factory
from tests.support.golden import assert_matches_golden
from trex_gui.core.files import load
from trex_gui.core.resource_files import resource
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.settings.document import (
    LINK_KEYS,
    Settings,
    serial_defaults,
    specs_for,
)
from trex_gui.devices.trex.settings.edit_in_place import amend
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.rules import Context, lint
from trex_gui.devices.trex.settings.writer import parameter_line, write_settings

SAMPLES = {
    "trex_factory_defaults.txt": Context(),
    "trexjr_factory_defaults.txt": Context(),
    "tank_with_mix.txt": Context(),
    "rover_with_serial_override.txt": Context(drives_from_computer=True),
    "autonomous_robot.txt": Context(drives_from_computer=True),
}
"""Name of each sample, and context of its robot."""

GOLDEN = Path(__file__).parent / "golden"
BOARDS = [(model.key, firmware) for model in device_table().models for firmware in model.firmware]

every_sample = pytest.mark.parametrize("name", SAMPLES)
every_board = pytest.mark.parametrize(("model", "firmware"), BOARDS)


def text_of(name: str) -> str:
    return load(resource(f"samples/{name}")).decode("utf-8")


def settings_of(name: str) -> Settings:
    return read_settings(text_of(name))[0]


def test_sample_list_matches_sample_folder() -> None:
    assert {path.name for path in resource("samples").iterdir()} == set(SAMPLES)


@every_sample
def test_sample_is_read_without_findings(name: str) -> None:
    settings, findings = read_settings(text_of(name), name)
    assert findings == ()
    # A sample applies to every firmware, and retains the calibrations of the board.
    assert settings.firmware is None
    specs = specs_for(settings.product, settings.product.firmware[0]).readable
    assert set(settings.parameters) == {spec.key for spec in specs}
    assert settings.calibrations == {}


@every_sample
def test_sample_passes_every_rule(name: str) -> None:
    assert lint(settings_of(name), SAMPLES[name]) == ()


@every_sample
def test_sample_lines_match_written_parameter_lines(name: str) -> None:
    settings = settings_of(name)
    lines = [line for line in text_of(name).splitlines() if line and not line.startswith("#")]
    specs = {spec.key: spec for spec in settings.specs}
    for line in lines[1:]:
        key = line.partition(":")[0]
        assert line == parameter_line(specs[key], settings.parameters[key], settings)


@every_sample
def test_sample_has_comments_and_short_lines(name: str) -> None:
    lines = text_of(name).splitlines()
    assert lines[1].startswith("# ")
    assert sum(line.startswith("# ") for line in lines) >= 12
    assert all(len(line) <= 100 and line == line.rstrip() for line in lines)


@every_sample
def test_edited_sample_keeps_its_comments(name: str) -> None:
    text, settings = text_of(name), settings_of(name)
    assert amend(text, settings) == text
    other = factory(settings.product.key, None)
    after = amend(text, other)
    assert read_settings(after)[0] == other
    comments = [line for line in text.splitlines() if line.startswith("#")]
    assert [line for line in after.splitlines() if line.startswith("#")] == comments


@pytest.mark.parametrize("model", ["trex", "trexjr"])
def test_factory_samples_match_factory_settings(model: str) -> None:
    settings = settings_of(f"{model}_factory_defaults.txt")
    expected = factory(model, "1.0")
    assert (settings.product, settings.parameters) == (expected.product, expected.parameters)


def test_autonomous_sample_uses_timeout_and_error_detection() -> None:
    parameters = settings_of("autonomous_robot.txt").parameters
    assert parameters["serial_timeout"] == 5
    assert parameters["uart_error_shutdown"] == 1
    line = LineSettings.from_wire(parameters["uart_settings"])
    assert line == LineSettings(115200, Detection.CRC7, 1)


# --- Golden files ------------------------------------------------------------------------


def test_golden_files_match_the_list_of_boards() -> None:
    expected = {f"{model}-{firmware}.txt" for model, firmware in BOARDS}
    assert {path.name for path in GOLDEN.glob("*.txt")} == expected


@every_board
def test_written_factory_settings_match_golden_file(
    model: str, firmware: str, tmp_path: Path
) -> None:
    golden = GOLDEN / f"{model}-{firmware}.txt"
    assert_matches_golden(write_settings(factory(model, firmware)), golden, tmp_path)


@every_board
def test_golden_file_is_read_without_findings(model: str, firmware: str) -> None:
    data = (GOLDEN / f"{model}-{firmware}.txt").read_bytes()
    assert read_settings(data) == (factory(model, firmware), ())


@every_board
def test_serial_defaults_contain_only_connection_settings(model: str, firmware: str) -> None:
    keys = set(serial_defaults(device_table().model(model), firmware).parameters)
    assert keys >= {"uart_settings", "crc7_polynomial", "device_number"}
    assert keys <= set(LINK_KEYS)
    assert "serial_timeout" not in keys
