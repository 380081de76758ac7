"""Accepted values beyond inferred limits."""

from pathlib import Path

import pytest

from tests.devices.trex.settings.samples import TREX, TREX_JR
from trex_gui.core.files import SettingsError, Severity
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.settings.accepted import AcceptedValues
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.rules import lint
from trex_gui.devices.trex.settings.writer import write_settings


def test_only_inferred_limits_may_be_exceeded() -> None:
    specs = parameters_of("trex", "1.2")
    assert {spec.key for spec in specs if spec.has_open_values} == {
        "required_channels",
        "ignored_channels",
        "reversed_channels",
        "parabolic_channels",
        "uart_error_shutdown",
        "motor1_pwm_prescaler",
        "motor2_pwm_prescaler",
        "uart_response_delay",
        "channel_input_source",
    }
    for spec in specs:
        for wire in (-1, 128, 16383):
            assert not spec.is_open(wire), "a data byte has seven bits"
        assert not any(map(spec.is_open, spec.valid))
    assert specs["motor_mode"].problem(2, forced=True), "its upper limit is sourced"
    assert specs["uart_settings"].problem(11, forced=True), "no host supports these settings"


def test_accepted_values_are_saved_by_model_and_firmware(tmp_path: Path) -> None:
    store = AcceptedValues(tmp_path / "new" / "accepted.json")
    board = Signature(TREX, "1.2")
    assert store.of(board) == {}
    store.add(board, {"ignored_channels": 63})
    assert store.add(board, {"ignored_channels": 32}) == {"ignored_channels": frozenset({32, 63})}
    assert AcceptedValues(store.path).of(board) == {"ignored_channels": frozenset({32, 63})}
    assert store.of(Signature(TREX, "1.3")) == {}
    assert store.of(Signature(TREX_JR, "1.2")) == {}


@pytest.mark.parametrize(
    "text",
    ["", "[]", "[" * 5000, '{"trex 1.2": 5}', '{"trex 1.2": {"ignored_channels": ["x", 200]}}'],
)
def test_damaged_file_of_accepted_values_counts_as_empty(tmp_path: Path, text: str) -> None:
    path = tmp_path / "accepted.json"
    path.write_text(text, encoding="utf-8")
    store, board = AcceptedValues(path), Signature(TREX, "1.2")
    assert not any(store.of(board).values())
    assert store.add(board, {"ignored_channels": 63})["ignored_channels"] == {63}


def test_accepted_values_that_cannot_be_saved_are_reported(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    store = AcceptedValues(tmp_path / "file" / "accepted.json")
    with pytest.raises(SettingsError):
        store.add(Signature(TREX, "1.2"), {"ignored_channels": 63})


def test_value_beyond_inferred_limit_is_read_with_a_warning() -> None:
    settings = Settings(TREX, "1.2", {"motor1_pwm_prescaler": 5, "motor1_pwm_maximum": 63})
    text = write_settings(settings)
    assert "motor1_pwm_prescaler: 5" in text
    assert "# beyond a limit (inferred): the board decides" in text
    read, findings = read_settings(text)
    assert read == settings
    warning = next(found for found in findings if found.key == "motor1_pwm_prescaler")
    assert warning.severity is Severity.WARNING
    assert " (inferred), not 5; the board decides" in warning.message
    assert lint(settings) == ()
