"""The command `replay`."""

from pathlib import Path

import pytest

from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_command import RunCommand


@pytest.fixture
def transcript(tmp_path: Path) -> Path:
    return tmp_path / "traffic.txt"


def replace_last_reply(file: Path, request: str, old: str, new: str) -> None:
    """Replace the reply to the last of several equal requests in a transcript."""
    head, found, tail = file.read_text(encoding="utf-8").rpartition(f"\t{request}\t{old}\t")
    assert found
    file.write_text(f"{head}\t{request}\t{new}\t{tail}", encoding="utf-8")


def test_replayed_transcript_of_the_simulator_has_no_difference(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, transcript: Path
) -> None:
    trexcmd("set", "motor_1_acceleration", "12")
    trexcmd("calibration", "set", "2", "2400", "3700", "5100", "60")
    quick_simulator.do("channel 2 1900us")
    words = ("--traffic", str(transcript))
    trexcmd("set", "serial_timeout", "1.5 s", *words)
    result = trexcmd("replay", str(transcript))
    assert "no difference" in result.stdout
    assert "TReX 1.2, 28 stored values from the file" in result.stderr

    trexcmd("status", *words)
    trexcmd("replay", str(transcript))  # measurements may differ
    trexcmd("motor", "1", "60", "--seconds", "0.4", *words)
    trexcmd("replay", str(transcript))


@pytest.mark.parametrize(
    ("options", "command"),
    [
        ("--model trexjr --firmware 1.0", ("get-settings", "-")),
        ("--mode analog", ("get-settings", "-")),
        ("--echo", ("get-settings", "-")),
        ("--device 9", ("raw", "80 09 1F 07")),  # the number is read from the answered packet
    ],
)
def test_replayed_board_starts_in_the_state_of_the_transcript(
    trexcmd: RunCommand,
    start_simulator: StartSimulator,
    transcript: Path,
    options: str,
    command: tuple[str, ...],
) -> None:
    simulator = start_simulator(*options.split())
    trexcmd(*command, "--port", simulator.url, "--traffic", str(transcript))
    trexcmd("replay", str(transcript))


@pytest.mark.parametrize("polynomial", ["89", "95"])
def test_replay_detects_crc_and_its_polynomial(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, transcript: Path, polynomial: str
) -> None:
    trexcmd("set", "crc7_polynomial", f"0x{polynomial}")
    trexcmd("set", "uart_settings", "37")
    quick_simulator.do("power cycle")
    words = ("--crc", "--polynomial", polynomial, "--traffic", str(transcript))
    trexcmd("get", "device_number", *words)
    trexcmd("replay", str(transcript))


def test_replay_skips_probes_of_a_search(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, transcript: Path
) -> None:
    trexcmd("set", "uart_settings", "9600 baud, no error detection, 1 stop bit")
    quick_simulator.do("power cycle")
    trexcmd("find", "--traffic", str(transcript))
    text = transcript.read_text(encoding="utf-8")
    assert "\tsearch: get signature → no reply" in text
    assert "nothing to compare" in trexcmd("replay", str(transcript), exits=1).stderr

    words = ("--baud", "9600", "--traffic", str(transcript))
    trexcmd("get", "serial_timeout", *words)
    rows = transcript.read_text(encoding="utf-8").partition("meaning\n")[2]
    transcript.write_text(text + rows, encoding="utf-8")
    trexcmd("replay", str(transcript))


def test_first_difference_is_shown_with_its_line_number(
    trexcmd: RunCommand, transcript: Path
) -> None:
    trexcmd("set", "serial_timeout", "1.5 s", "--traffic", str(transcript))
    replace_last_reply(transcript, "AF 07 0F 55 2A", "00", "03")
    replace_last_reply(transcript, "81", "54 52 65 58 31 2E 32", "")
    result = trexcmd("replay", str(transcript), exits=1)
    assert "AF 07 0F 55 2A\n  file:      03" in result.stdout
    assert "  simulator: 00  (set Serial Timeout to 1.5 s (15) → stored)" in result.stdout
    number = int(result.stdout.split(":")[0].removeprefix("Line "))
    assert "\tAF 07" in transcript.read_text(encoding="utf-8").splitlines()[number - 1]
    result = trexcmd("replay", "--all", str(transcript), exits=1)
    assert "Replies differ in 2 of" in result.stderr
    assert result.stdout.count("simulator:") == 2


@pytest.mark.parametrize(
    "text", ["", "product: TReX\n", "time\tfault\tsent\treceived\ttook_ms\tmeaning\nx\n"]
)
def test_file_that_is_no_transcript_is_rejected(
    trexcmd: RunCommand, transcript: Path, text: str
) -> None:
    transcript.write_text(text, encoding="utf-8")
    assert "traffic log" in trexcmd("replay", str(transcript), exits=1).stderr
    trexcmd("replay", str(transcript.with_name("missing")), exits=1)
