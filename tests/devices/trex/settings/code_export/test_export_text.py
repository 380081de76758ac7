"""Text of exported programs."""

import ast
import itertools
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.devices.trex.settings.code_export.programs import (
    HERE,
    compile_,
    every_language,
    link,
    settings_for,
)
from tests.devices.trex.settings.samples import TREX, TREX_JR, any_settings, factory
from tests.support.golden import assert_matches_golden
from tests.support.matrix import examples
from trex_gui.core.code import Language, plain
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.settings.code_export import export_code, file_name
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.version import __version__

LONGEST_LINE = 100


@st.composite
def any_link(draw: st.DrawFn) -> ConnectionSettings:
    detection = draw(st.sampled_from(list(Detection)))
    line = LineSettings(draw(st.sampled_from(baud_rates())), detection, draw(st.integers(1, 2)))
    device = draw(st.none() | st.integers(0, 127))
    return ConnectionSettings("unused", line, device, draw(st.integers(0x80, 0xFF)))


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("trex_board.ino", export_code(settings_for(link()), link(), Language.ARDUINO)),
        (
            "trexjr_board.py",
            export_code(
                settings_for(link(expanded=True, crc=True), "trexjr", device_number=42),
                link(expanded=True, crc=True),
                Language.PYTHON,
            ),
        ),
    ],
    ids=["arduino", "python"],
)
def test_exported_text_matches_golden_file(name: str, text: str, tmp_path: Path) -> None:
    text = text.replace(f"TReX Studio {__version__}", "TReX Studio VERSION")
    assert_matches_golden(text, HERE / "golden" / f"{name}.txt", tmp_path)


@examples(15)
@given(settings=any_settings(), line=any_link())
def test_exported_text_has_short_ascii_lines_without_gaps(
    settings: Settings, line: ConnectionSettings
) -> None:
    for language in Language:
        text = export_code(settings, line, language)
        assert text == export_code(settings, line, language)
        assert text.isascii()
        assert text.endswith("\n")
        assert "\n\n\n\n" not in text
        assert not re.search(r"\{[{%]|[%}]\}(?!,)|[ \t]\n|\r", text)
        assert max(map(len, text.splitlines())) <= LONGEST_LINE


@examples(15)
@given(settings=any_settings(), line=any_link())
def test_exported_python_parses_in_3_8_and_has_all_values(
    settings: Settings, line: ConnectionSettings
) -> None:
    text = export_code(settings, line, Language.PYTHON)
    ast.parse(text, feature_version=(3, 8))
    table = {}
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            table[node.targets[0].id] = node.value
    specs = parameters_of(settings.product.key, settings.firmware or "1.3")
    exported = {
        specs.number(number).key: wire  # type: ignore[union-attr]
        for number, wire, _ in ast.literal_eval(table.get("PARAMETERS", ast.List([])))
    }
    assert exported == settings.parameters
    sources = {"r": InputSource.RC, "a": InputSource.ANALOG}
    calibrations = {
        CalibrationKey.of(sources[letter], channel): Calibration(*values)
        for letter, channel, values in ast.literal_eval(table.get("CALIBRATIONS", ast.List([])))
    }
    assert calibrations == settings.calibrations


def test_exported_python_passes_ruff(tmp_path: Path) -> None:
    variants = itertools.product((False, True), (False, True), (11, 12))
    for index, (expanded, crc, number) in enumerate(variants):
        line = link(expanded=expanded, crc=crc)
        text = export_code(settings_for(line, device_number=number), line, Language.PYTHON)
        (tmp_path / f"board_{index}.py").write_text(text, encoding="ascii")
    ruff = [sys.executable, "-m", "ruff"]
    style = ["--isolated", "--no-cache", "--line-length", "100", "--target-version", "py38"]
    for command in (
        [*ruff, "check", "--select", "A,B,C4,E,F,I,N,PIE,RET,RUF,SIM,UP,W", *style, str(tmp_path)],
        [*ruff, "format", "--diff", *style, str(tmp_path)],
    ):
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        assert result.returncode == 0, result.stdout


# --- Content -----------------------------------------------------------------------------


@every_language
def test_export_contains_only_code_of_its_framing(language: Language) -> None:
    settings = settings_for(link())
    compact = export_code(settings, link(), language)
    assert "crc7" not in compact
    assert "DEVICE " not in compact
    crc = export_code(settings, link(crc=True), language)
    assert "crc7" in crc
    assert "CRC_POLYNOMIAL" in crc
    assert "0x91" in crc
    expanded = export_code(settings, link(expanded=True), language)
    assert re.search(r"DEVICE (= )?11\b", expanded)
    assert "CRC_POLYNOMIAL" not in expanded


@every_language
def test_export_contains_only_given_parameters(language: Language) -> None:
    settings = Settings(TREX, "1.2", {"serial_timeout": 15})
    text = export_code(settings, link(), language)
    assert re.search(r"0x07, 15\b", text)
    assert "1.5 s" in text
    assert "0x08," not in text
    assert "CALIBRATIONS" not in text


@every_language
def test_communication_parameters_are_exported_last(language: Language) -> None:
    text = export_code(factory(), link(), language)
    rows = [int(number, 16) for number in re.findall(r"[({](0x[0-9A-F]{2}), \d+", text)]
    assert len(rows) == len(factory().parameters)
    assert rows[-8:] == [0x00, 0x07, 0x08, 0x17, 0x7B, 0x7C, 0x7D, 0x7E]


@every_language
def test_header_names_board_and_warns_of_running_motors(language: Language) -> None:
    def header(**parameters: int) -> str:
        text = export_code(Settings(TREX_JR, "1.2", parameters), link(), language)
        plain_text = re.sub(r"^[ *]+", "", text[:2200], flags=re.MULTILINE)
        return re.sub(r"\s+", " ", plain_text)

    assert f"Written by TReX Studio {__version__} for a TReX Jr with firmware 1.2" in header()
    assert "mode jumper" in header()
    assert "keep running" in header()
    assert "unless Serial Timeout and UART-Error Shutdown (twin) are set on the board" in header()
    timeout_off = header(serial_timeout=0)
    assert "Serial Timeout (parameter 0x07) is off" in timeout_off
    assert "UART-Error Shutdown (parameter 0x08; twin), it should stop the motors" in timeout_off
    assert "It may need UART-Error Shutdown" in header(serial_timeout=15, uart_error_shutdown=0)
    assert "received nothing for 1.5 s" in header(serial_timeout=15, uart_error_shutdown=1)


@every_language
def test_changed_line_settings_are_announced(language: Language) -> None:
    def announced(line: ConnectionSettings, **parameters: int) -> str:
        text = export_code(Settings(TREX, "1.2", parameters), line, language)
        match = re.search(r"speaks at (.*)\.", text)
        return match[1] if match else ""

    fast = LineSettings(115200, Detection.CRC7)
    assert not announced(link(), uart_settings=5)
    assert not announced(link(), crc7_polynomial=0x33)  # has no effect without CRC
    assert not announced(link(crc=True), uart_settings=0x25, crc7_polynomial=0x11)
    assert announced(link(), uart_settings=0x0A) == "115200 baud, no error detection, 1 stop bit"
    assert announced(link(crc=True), crc7_polynomial=0x09).endswith("polynomial 0x89")
    assert "CRC-7, 1 stop bit" in announced(link(), uart_settings=fast.to_wire())


@every_language
def test_invalid_values_are_reported_and_omitted(language: Language) -> None:
    settings = Settings(
        TREX,
        "1.2",
        {"uart_settings": 0x0F, "serial_timeout": 3},
        {CalibrationKey.RC_CHANNEL_2: Calibration(9, 8, 7, 0)},
    )
    text = export_code(settings, link(), language)
    assert "0x7E," not in text
    assert "UART Settings must be" in text
    assert "rc_channel_2: minimum 9 is above neutral 8" in text
    assert "CALIBRATIONS" not in text


def test_unknown_parameter_and_baud_rate_are_rejected() -> None:
    with pytest.raises(BadRequest, match="serial_timeoot"):
        export_code(Settings(TREX, "1.2", {"serial_timeoot": 1}), link(), Language.PYTHON)
    with pytest.raises(BadRequest, match="12345"):
        export_code(factory(), link(baud=12345), Language.PYTHON)


def test_file_is_named_after_board_and_language() -> None:
    names = [file_name(factory("trexjr"), language) for language in Language]
    assert names == ["trexjr_board.ino", "trexjr_board.py"]
    assert file_name(factory(), Language.PYTHON) == "trex_board.py"


# --- Special characters ------------------------------------------------------------------

SPECIAL = '*/ "??/ \\ µΩ\n# /* %d {x} """ \' \x00 \u202e @baud@ \\'


@given(st.text() | st.text(st.sampled_from('*/?=\\"\n\r\0a'), max_size=6))
def test_plain_is_safe_and_idempotent_for_any_text(text: str) -> None:
    code = plain(f"before{text}after")
    assert code.startswith("before")
    assert code.endswith("after")
    assert not re.search(r'[^ -~]|\*/|/\*|\?\?|"|\\', code)
    assert plain(code) == code


def test_plain_keeps_units_readable() -> None:
    assert plain("1500 µs − 5 … é") == "1500 us - 5 ... e"


@every_language
def test_code_compiles_with_special_characters_in_names(language: Language, tmp_path: Path) -> None:
    product = replace(TREX, name=SPECIAL)
    settings = replace(factory(), product=product, firmware=f"1.2.{SPECIAL}")
    text = export_code(settings, link(), language)
    path = tmp_path / file_name(settings, language)
    path.write_text(text, encoding="ascii")
    match language:
        case Language.PYTHON:
            compile(text, file_name(settings, language), "exec")
        case Language.ARDUINO:
            includes = ["-I", str(HERE / "arduino"), "-include", "Arduino.h"]
            warnings = ["-Wall", "-Wextra", "-Werror"]
            compile_(["g++", *warnings, *includes, "-fsyntax-only", "-x", "c++", str(path)])
