"""The commands `get-settings`, `set-settings`, `check-settings`, `diff` and `audit`."""

import json
import signal
from pathlib import Path

import pytest

from tests.devices.trex.cli.conftest import becomes, changed
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_command import RunCommand, StartCommand
from trex_gui.core.files import Finding, SettingsError
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings


def stored(simulator: SimulatedDevice, key: str) -> int:
    value = simulator.show()["parameters"][key]
    assert isinstance(value, int)
    return value


def test_get_settings_saves_complete_settings_file(trexcmd: RunCommand, saved: Path) -> None:
    text = saved.read_text(encoding="utf-8")
    assert trexcmd("get-settings", "-").stdout == text
    assert trexcmd("check-settings", str(saved), TREX_PORT="").output == ""
    assert text.startswith("product: TReX\n")
    assert "rc_channel_5: {minimum: 2500" in text
    assert sum(":" in line and not line.startswith("#") for line in text.splitlines()) == 35


def test_set_settings_writes_only_differences(
    trexcmd: RunCommand, saved: Path, quick_simulator: SimulatedDevice
) -> None:
    file = changed(
        saved,
        serial_timeout=15,
        motor1_acceleration=9,
        rc_channel_2="{minimum: 2400, neutral: 3700, maximum: 5100, deadband: 60}",
    )
    result = trexcmd("set-settings", "-", stdin=file.read_text(encoding="utf-8"))
    assert "28 parameters: 2 will change, 26 match" in result.stderr
    assert "3 of 3 changes stored and verified" in result.stderr
    assert stored(quick_simulator, "serial_timeout") == 15
    assert stored(quick_simulator, "motor1_acceleration") == 9
    assert trexcmd("diff", str(file)).stdout == ""


def test_file_for_newer_firmware_is_rejected_naming_the_key(
    trexcmd: RunCommand, saved: Path, start_simulator: StartSimulator
) -> None:
    old = start_simulator("--firmware", "1.0", "--unpaced")
    result = trexcmd("set-settings", str(saved), "--port", old.url, exits=1)
    assert "uart_response_delay: a TReX 1.0 does not have this setting" in result.stderr


def test_calibrations_of_inactive_source_are_skipped_and_named(
    trexcmd: RunCommand, saved: Path
) -> None:
    line = "analog_channel_1: {minimum: 1, neutral: 500, maximum: 1000, deadband: 5}\n"
    saved.write_text(saved.read_text(encoding="utf-8") + line, encoding="utf-8")
    assert "analog_channel_1 left out" in trexcmd("set-settings", str(saved)).stderr


def test_conflicting_settings_print_a_warning(trexcmd: RunCommand, saved: Path) -> None:
    file = changed(saved, motor_mode=1, motor1_current_limit=20)
    assert "No effect in joint mode" in trexcmd("check-settings", str(file)).stderr
    assert "No effect in joint mode" in trexcmd("set-settings", str(file)).stderr


def test_check_settings_names_each_error_with_its_line(
    trexcmd: RunCommand, saved: Path, tmp_path: Path
) -> None:
    file, out = changed(saved, serial_timeout=200, motor_mode=7), tmp_path / "out.txt"
    result = trexcmd("check-settings", str(file), str(out), exits=1)
    assert f"{file}: line 7: serial_timeout: must be 0 to 127" in result.stderr
    assert "motor_mode" in result.stderr
    assert "2 errors" in result.stderr
    assert not out.exists()
    report = json.loads(trexcmd("check-settings", str(file), "--json", exits=1).stdout)
    assert not report["usable"]
    finding, _ = report["findings"]
    assert (finding["key"], finding["severity"]) == ("serial_timeout", "error")
    assert finding["line"] == 7


def test_check_settings_prints_warnings_as_json(trexcmd: RunCommand, saved: Path) -> None:
    path = changed(saved, motor1_current_limit=20, motor1_current_limit_p=0)
    result = trexcmd("check-settings", str(path), "--json")
    report = json.loads(result.stdout)
    assert report["usable"]
    assert report["findings"] == []
    warning = report["warnings"][0]
    assert set(warning) == {"rule", "keys", "message", "proposal"}
    assert warning["keys"] == ["motor1_current_limit", "motor1_current_limit_p"]


COMMENTED = """\
# The rover of the school, front axle.
product: TReX
motor_mode: 0        # two motors

serial_timeout: 0x0F # so that it stops when the cable breaks
# Do not change without asking:
motor1_acceleration: 12
"""


def test_check_settings_copies_file_and_terminates_last_line(
    trexcmd: RunCommand, tmp_path: Path
) -> None:
    file, out = tmp_path / "in.txt", tmp_path / "out.txt"
    whole = ("\ufeff" + COMMENTED.replace("\n", "\r\n")).encode()
    file.write_bytes(whole.rstrip())
    assert (
        "the last line has no line break" in trexcmd("check-settings", str(file), str(out)).stderr
    )
    assert out.read_bytes() == whole
    assert "no end" not in trexcmd("check-settings", str(out), str(file)).stderr
    assert file.read_bytes() == whole
    file.write_text(COMMENTED, encoding="utf-8")
    assert trexcmd("check-settings", str(file), "-").stdout == COMMENTED


def test_file_that_cannot_be_edited_in_place_is_rewritten(
    trexcmd: RunCommand, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """No file is known that `amend` rejects, so the test replaces `amend`."""

    def refuse(text: str, settings: Settings) -> str:
        del text, settings
        raise SettingsError("settings", [Finding(None, None, "it cannot be changed in place")])

    monkeypatch.setattr("trex_gui.devices.trex.cli.check.amend", refuse)
    file, out = tmp_path / "in.txt", tmp_path / "out.txt"
    file.write_text(COMMENTED, encoding="utf-8")
    result = trexcmd("check-settings", str(file), str(out))
    assert "The comments and the order of settings could not be kept: " in result.stderr
    assert out.read_text(encoding="utf-8") == write_settings(read_settings(COMMENTED)[0])


FAULTY = """# My rover, do not lose this
product: trex
motor1_current_limit: 20  # about 6 A
motor1_current_limit_p: 0

serial_timeout: 1.5 s  # was off
  # between
motor1_brake_duration: 300
required_channels: 3
ignored_channels: 2"""
REPAIRED = """# My rover, do not lose this
product: TReX
motor1_current_limit: 20  # about 6 A
motor1_current_limit_p: 4

serial_timeout: 15  # was off
  # between
motor1_brake_duration: 127
required_channels: 1
ignored_channels: 2
"""


def test_fix_repairs_the_file_and_lists_each_repair(trexcmd: RunCommand, tmp_path: Path) -> None:
    path, out = tmp_path / "faulty.txt", tmp_path / "out.txt"
    path.write_text(FAULTY, encoding="utf-8")
    result = trexcmd("check-settings", str(path), str(out), "--fix")
    assert path.read_text(encoding="utf-8") == FAULTY
    assert out.read_text(encoding="utf-8") == REPAIRED
    repaired = [line.partition(": repaired: ")[2] for line in result.stderr.splitlines()]
    product, timeout, brake, gain, required, *_ = repaired
    assert product == "line 2: product: trex becomes TReX"
    assert timeout == "line 6: serial_timeout: 1.5 s becomes 15 (1.5 s)"
    assert brake == "line 8: motor1_brake_duration: 300 becomes 127 (1270 ms)"
    assert gain.startswith("Set Motor 1 Current Limit Proportionality Constant P to 4: Motor 1")
    assert required.startswith("Set Required Channels to channel 1: Both required and ignored")

    trexcmd("check-settings", str(path), "--fix")
    assert path.read_text(encoding="utf-8") == REPAIRED
    assert "nothing to repair" in trexcmd("check-settings", str(path), "--fix").stderr
    assert trexcmd("check-settings", "-", "--fix", stdin=FAULTY).stdout == REPAIRED
    report = json.loads(trexcmd("check-settings", str(path), str(out), "--fix", "--json").stdout)
    assert report["repairs"] == []


def test_fix_writes_nothing_while_errors_remain(trexcmd: RunCommand, tmp_path: Path) -> None:
    path, out = tmp_path / "faulty.txt", tmp_path / "out.txt"
    text = FAULTY + "\nserial_timer: 5\n"
    path.write_text(text, encoding="utf-8")
    for arguments in ([str(path)], [str(path), str(out)]):
        result = trexcmd("check-settings", *arguments, "--fix", exits=1)
        assert "line 11: serial_timer: there is no such setting" in result.stderr
        assert "1 error; nothing was written" in result.stderr
    assert path.read_text(encoding="utf-8") == text
    assert not out.exists()


def test_set_settings_checks_file_and_resulting_settings(
    trexcmd: RunCommand, tmp_path: Path, quick_simulator: SimulatedDevice
) -> None:
    path = tmp_path / "faulty.txt"
    path.write_text(FAULTY, encoding="utf-8")
    result = trexcmd("set-settings", str(path), exits=1)
    assert "line 6: serial_timeout: must be 0 to 127" in result.stderr
    assert quick_simulator.show()["counters"]["eeprom_writes"] == 0
    path.write_text(
        "product: TReX\nmotor1_current_limit: 20\n"
        "rc_channel_2: {minimum: 3000, neutral: 3700, maximum: 4400, deadband: 700}\n",
        encoding="utf-8",
    )
    result = trexcmd("set-settings", str(path), "--dry-run")
    assert "Motor 1 Acceleration is 0" in result.stderr, "a setting of the board"
    assert "The deadband of RC channel 2 reaches from neutral" in result.stderr


JUNIOR = """product: TReX Jr
firmware: 1.2
# what I measured
motor1_current_limit: 60  # 4.8 A
uart_response_delay: 1
serial_timeout: 5
"""


def test_check_settings_converts_for_another_board(trexcmd: RunCommand, tmp_path: Path) -> None:
    path, out = tmp_path / "junior.txt", tmp_path / "out.txt"
    path.write_text(JUNIOR, encoding="utf-8")
    result = trexcmd("check-settings", str(path), str(out), "--for", "trex-1.0")
    assert out.read_text(encoding="utf-8") == (
        "product: TReX\nfirmware: 1.0\n# what I measured\nmotor1_current_limit: 16  # 4.8 A\n"
        "# uart_response_delay: 1\nserial_timeout: 5\n"
    )
    assert "For a TReX 1.0: 1 carried over, 1 changed, 1 left out." in result.stderr
    assert "changed: Motor 1 Current Limit: 4.8 A. The same value in steps" in result.stderr
    assert "left out: Enable UART Response Delay: 1 ms → . A TReX" not in result.stderr
    assert "left out: Enable UART Response Delay: 1 ms. A TReX with firmware 1.0" in result.stderr
    assert "carried over: serial_timeout" in result.stderr
    assert path.read_text(encoding="utf-8") == JUNIOR

    report = json.loads(trexcmd("check-settings", str(path), "--for", "trex", "--json").stdout)
    assert [row["fate"] for row in report["conversion"]] == ["changed", *["carried over"] * 2]
    for options in (["--for", "jrk"], ["--for", "trex-9.9"], ["--for", "trex", "--fix"]):
        trexcmd("check-settings", str(path), *options, exits=2)
    assert path.read_text(encoding="utf-8") == JUNIOR


def test_convert_option_writes_a_file_of_the_other_model(
    trexcmd: RunCommand, tmp_path: Path, quick_simulator: SimulatedDevice
) -> None:
    path = tmp_path / "junior.txt"
    path.write_text(JUNIOR, encoding="utf-8")
    rejected = trexcmd("set-settings", str(path), exits=1).stderr
    assert "settings of a TReX Jr, but the board is a TReX 1.2; --convert carries over" in rejected
    assert quick_simulator.show()["counters"]["eeprom_writes"] == 0
    result = trexcmd("set-settings", str(path), "--convert")
    assert "For a TReX 1.2: 2 carried over, 1 changed, 0 left out." in result.stderr
    assert stored(quick_simulator, "motor1_current_limit") == 16
    assert stored(quick_simulator, "uart_response_delay") == 1


def test_diff_compares_two_files_without_a_board(trexcmd: RunCommand, saved: Path) -> None:
    other = changed(saved, serial_timeout=15)
    assert "0 → 15" in trexcmd("diff", str(saved), str(other), TREX_PORT="", exits=1).stdout
    report = json.loads(trexcmd("diff", str(saved), str(other), "--json", exits=1).stdout)
    assert report["equal"] is False
    assert [(row["key"], row["before"], row["after"]) for row in report["differing"]] == [
        ("serial_timeout", 0, 15)
    ]


@pytest.mark.parametrize("command", ["diff", "audit"])
def test_failed_or_interrupted_comparison_exits_with_2(
    start: StartCommand, saved: Path, quick_simulator: SimulatedDevice, command: str
) -> None:
    interrupted = start(command, str(saved))
    sent = quick_simulator.show()["counters"]["line"]["sent"]
    assert becomes(lambda: quick_simulator.show()["counters"]["line"]["sent"] > sent, True)
    interrupted.send_signal(signal.SIGINT)
    assert interrupted.wait() == 2
    quick_simulator.do("power off")
    assert start(command, str(saved)).wait() == 2


def test_audit_checks_settings_of_profile(
    trexcmd: RunCommand, tmp_path: Path, quick_simulator: SimulatedDevice
) -> None:
    profile = tmp_path / "profile.txt"
    calibration = "rc_channel_1: {minimum: 2500, neutral: 3750, maximum: 5000, deadband: 75}\n"
    profile.write_text(f"product: TReX\nserial_timeout: 0\nmotor_mode: 0\n{calibration}")
    equal = trexcmd("audit", str(profile))
    assert equal.stdout == ""
    assert "2 parameters: 0 will change, 2 match; 1 calibration" in equal.stderr

    quick_simulator.do("eeprom serial_timeout 7")
    different = trexcmd("audit", str(profile), exits=1)
    assert different.stdout.split() == ["serial_timeout", "7", "→", "0", "0.7", "s", "→", "off"]
    report = json.loads(trexcmd("audit", str(profile), "--json", exits=1).stdout)
    assert [row["key"] for row in report["differing"]] == ["serial_timeout"]
    assert report["equal"] is False
    ignored = trexcmd("audit", str(profile), "--ignore", "Serial Timeout", "--json")
    assert json.loads(ignored.stdout) == {"equal": True, "differing": [], "left_out": []}
    trexcmd("audit", str(profile), "--ignore", "serial_timeot", exits=2)
    assert stored(quick_simulator, "serial_timeout") == 7, "an audit writes nothing"


def test_audit_with_profile_of_other_model_exits_with_1(
    trexcmd: RunCommand, tmp_path: Path
) -> None:
    profile = tmp_path / "profile.txt"
    profile.write_text("product: TReX Jr\nserial_timeout: 0\n")
    trexcmd("audit", str(profile), exits=1)
