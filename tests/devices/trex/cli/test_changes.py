"""Messages and snapshots of commands that change a board."""

from pathlib import Path

import pytest

from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_command import RunCommand
from tests.support.virtual_devices import VirtualSimulator, VirtualTransport
from trex_gui.devices.trex.settings.history import SettingsHistory

CALIBRATION = ("calibration", "set", "2", "2400", "3700", "5100", "60")

one_setting = pytest.mark.parametrize(
    ("words", "message", "reason"),
    [
        (("set", "Serial Timeout", "1.5 s"), "0 → 15  off → 1.5 s", "trexcmd set serial_timeout"),
        (CALIBRATION, "2500 → 2400  1000 µs → 960 µs", "trexcmd calibration set 2"),
    ],
    ids=["set", "calibration set"],
)

NEW_SETTINGS = "product: TReX\n# Note on serial_timeout: the radio drops out\nserial_timeout: 15\n"

every_write = pytest.mark.parametrize(
    "words",
    [
        ("set", "serial_timeout", "15"),
        CALIBRATION,
        ("set-settings", "-"),
        ("restore-defaults", "--yes"),
    ],
    ids=["set", "calibration set", "set-settings", "restore-defaults"],
)


def read_settings_text(trexcmd: RunCommand) -> str:
    return trexcmd("get-settings", "-").stdout


# --- One setting ------------------------------------------------------------------------


@one_setting
def test_changing_one_setting_shows_and_snapshots_old_value(
    trexcmd: RunCommand, words: tuple[str, ...], message: str, reason: str
) -> None:
    result = trexcmd(*words)
    assert message in " ".join(result.stderr.split("\n")).replace("   ", "  ")
    assert "→" not in result.stdout
    (snapshot,) = SettingsHistory().snapshots()
    assert snapshot.reason == reason
    assert str(snapshot.path) in result.stderr
    saved = SettingsHistory().load(snapshot)
    assert saved.parameters["serial_timeout"] == 0
    assert len(saved.parameters) == 28
    assert {calibration.minimum for calibration in saved.calibrations.values()} == {2500}


@every_write
def test_nothing_is_stored_if_snapshot_fails(
    trexcmd: RunCommand, tmp_path: Path, words: tuple[str, ...]
) -> None:
    before = read_settings_text(trexcmd)
    file = tmp_path / "file"
    file.write_text("", encoding="utf-8")
    result = trexcmd(*words, stdin=NEW_SETTINGS, TREX_STUDIO_DATA=str(file), exits=1)
    assert "it cannot be written" in result.stderr
    assert result.stdout == ""
    assert read_settings_text(trexcmd) == before


@one_setting
def test_unchanged_setting_is_not_written_again(
    trexcmd: RunCommand,
    monkeypatch: pytest.MonkeyPatch,
    words: tuple[str, ...],
    message: str,
    reason: str,
) -> None:
    del message, reason
    first = trexcmd(*words)
    monkeypatch.setattr("trex_gui.devices.trex.board.keeper.write_all", None)  # calling it fails
    second = trexcmd(*words)
    assert second.stdout == first.stdout
    assert "already has this value; nothing is written" in second.stderr
    assert len(SettingsHistory().snapshots()) == 1


@every_write
def test_nothing_is_written_or_saved_in_rc_mode(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, words: tuple[str, ...]
) -> None:
    quick_simulator.do("jumper mode rc", "power cycle")
    assert "not in serial mode" in trexcmd(*words, stdin=NEW_SETTINGS, exits=1).stderr
    assert not SettingsHistory().snapshots()
    assert quick_simulator.show()["counters"]["eeprom_writes"] == 0
    assert "Note on" not in read_settings_text(trexcmd)


def test_set_warns_of_conflicting_settings(trexcmd: RunCommand) -> None:
    trexcmd("set", "motor1_current_limit", "20")
    result = trexcmd("set", "motor_mode", "joint")
    assert "Warning: No effect in joint mode: Motor 1 Current Limit" in result.stderr


# --- Settings files ---------------------------------------------------------------------


def test_diff_reports_settings_for_different_models(trexcmd: RunCommand, tmp_path: Path) -> None:
    files = [tmp_path / "first.txt", tmp_path / "second.txt"]
    for file, product in zip(files, ("TReX", "TReX Jr"), strict=True):
        file.write_text(f"product: {product}\nserial_timeout: 15\n", encoding="utf-8")
    first, second = map(str, files)
    sentence = f"for different models: {first} (TReX) and {second} (TReX Jr)."
    assert sentence in trexcmd("diff", first, second, TREX_PORT="", exits=1).stderr
    assert "different models" not in trexcmd("diff", first, first, TREX_PORT="").stderr
    sentence = f"for different models: the board (TReX) and {second} (TReX Jr)."
    assert sentence in trexcmd("diff", second, exits=1).stderr
    assert "different models" not in trexcmd("diff", first, exits=1).stderr


# --- Baud rates of the port -------------------------------------------------------------


@pytest.mark.parametrize("command", ["set", "set-settings", "set-settings --dry-run"])
@pytest.mark.parametrize("rates", [frozenset({9600, 19200}), None])
def test_baud_rate_that_port_lacks_prints_warning(
    trexcmd: RunCommand,
    quick_simulator: SimulatedDevice,
    tmp_path: Path,
    command: str,
    rates: frozenset[int] | None,
) -> None:
    assert isinstance(quick_simulator, VirtualSimulator)
    quick_simulator.rates = rates
    file = tmp_path / "line.txt"
    file.write_text("product: TReX\nuart_settings: 10\n", encoding="utf-8")
    words = ("uart_settings", "10") if command == "set" else (str(file),)
    result = trexcmd(*command.split(), *words)
    reports = "This computer's serial port does not support 115200 baud" in result.stderr
    assert reports is (rates is not None)


def test_port_rates_are_queried_before_anything_is_sent(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, monkeypatch: pytest.MonkeyPatch
) -> None:
    events: list[str] = []

    def rates(_: VirtualTransport, _rates: object) -> None:
        events.append("queried")

    assert isinstance(quick_simulator, VirtualSimulator)
    monkeypatch.setattr(VirtualTransport, "rates", rates)
    quick_simulator.on_write = lambda _: events.append("sent")
    trexcmd("set", "serial_timeout", "15")
    assert events.count("queried") == 1
    assert events[0] == "queried"
    assert "sent" in events


# --- Factory defaults -------------------------------------------------------------------


def test_restore_defaults_lists_changes_before_prompt(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("eeprom serial_timeout 15", "eeprom motor1_acceleration 9")
    quick_simulator.do("eeprom device_number 9", "power cycle")
    before = read_settings_text(trexcmd)
    trexcmd("restore-defaults", stdin="", exits=1)
    result = trexcmd("restore-defaults", stdin="n\n", exits=1)
    messages, prompt, _ = result.stderr.partition("Reset every parameter")
    assert prompt
    assert "3 of 28 parameters will change:\n" in messages
    rows = {line.split()[0]: line.split()[1:4] for line in messages.splitlines() if "→" in line}
    assert rows == {
        "device_number": ["9", "→", "7"],
        "motor1_acceleration": ["9", "→", "0"],
        "serial_timeout": ["15", "→", "0"],
    }
    assert result.stdout == ""
    assert not SettingsHistory().snapshots()
    quick_simulator.do("power cycle")
    assert read_settings_text(trexcmd) == before


def test_restore_defaults_names_inferred_defaults(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("eeprom device_number 9", "power cycle")
    assert "confirms" not in trexcmd("restore-defaults", stdin="n\n", exits=1).stderr
    quick_simulator.do("eeprom motor1_acceleration 9")
    messages = trexcmd("restore-defaults", stdin="n\n", exits=1).stderr
    assert "No source confirms these defaults: Motor 1 Acceleration (inferred).\n" in messages


def test_restore_defaults_without_changes_still_prompts(trexcmd: RunCommand) -> None:
    result = trexcmd("restore-defaults", stdin="n\n", exits=1)
    assert "Every parameter already has its default" in result.stderr
    assert "Reset every parameter" in result.stderr


# --- Replaced board ---------------------------------------------------------------------


@every_write
def test_replaced_board_is_not_written_to(
    trexcmd: RunCommand,
    quick_simulator: VirtualSimulator,
    start_simulator: StartSimulator,
    words: tuple[str, ...],
) -> None:
    replacement = start_simulator("--unpaced", "--model", "trexjr")
    assert isinstance(replacement, VirtualSimulator)
    boards = (quick_simulator, replacement)

    def stored_values() -> list[object]:
        states = [board.show() for board in boards]
        return [(state["parameters"], state["calibrations"]) for state in states]

    def replace_after_snapshot(_data: bytes) -> None:
        if SettingsHistory().snapshots():
            quick_simulator.on_write = lambda _data: None
            quick_simulator.move_cable_to(replacement)

    before = stored_values()
    quick_simulator.on_write = replace_after_snapshot
    result = trexcmd(*words, stdin=NEW_SETTINGS, exits=1)
    assert "Another board responds now: TReX Jr 1.2. Nothing was " in result.stderr
    assert result.stdout == ""
    assert replacement.host is None
    for board in boards:
        board.do("power cycle")  # completes a reset to the defaults
    assert stored_values() == before


# --- Records of a board -----------------------------------------------------------------


def test_notes_of_a_file_are_saved_for_its_board(trexcmd: RunCommand, tmp_path: Path) -> None:
    file = tmp_path / "board.txt"
    note = "# Note on motor_mode: two motors\nmotor_mode"
    file.write_text(read_settings_text(trexcmd).replace("motor_mode", note))
    differing = trexcmd("diff", str(file), exits=1).stdout
    assert differing.split() == ["motor_mode", "note", "two", "motors"]
    result = trexcmd("set-settings", str(file))
    assert "1 note saved on this computer, because a board cannot store notes." in result.stderr
    assert trexcmd("diff", str(file)).stdout == ""
    assert "# Note on motor_mode: two motors\nmotor_mode: 0 " in read_settings_text(trexcmd)
    trexcmd("set", "serial_timeout", "1.5 s")
    (snapshot,) = SettingsHistory().snapshots()
    assert SettingsHistory().load(snapshot).notes == {"motor_mode": "two motors"}
    assert trexcmd("export", "--as", "python", "-").stdout.count("# motor_mode: two motors") == 1


def test_last_applied_settings_are_compared_with_board(trexcmd: RunCommand) -> None:
    unrecorded = trexcmd("diff", "--last", exits=2)
    assert "No settings have been applied to this board from this computer." in unrecorded.stderr
    trexcmd("diff", exits=2)
    trexcmd("diff", "--last", "x.txt", exits=2)

    trexcmd("set", "serial_timeout", "1.5 s")
    trexcmd("set", "device_number", "9")  # the record follows the number
    assert trexcmd("diff", "--last", "--device", "9").stdout == ""
    trexcmd("raw", "AF 07 00 55 2A")  # a change that is not recorded
    changed = trexcmd("diff", "--last", exits=1)
    assert " ".join(changed.stdout.split()) == "serial_timeout 0 → 15 off → 1.5 s"
    assert "New: the settings applied on 20" in changed.stderr


def test_forced_open_value_is_stored_and_recorded(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    refused = trexcmd("set", "ignored_channels", "63", exits=2)
    assert "(inferred): --force lets the board decide" in refused.stderr
    rejected = trexcmd("set", "ignored_channels", "63", "--force", exits=1)
    assert "Ignored Channels: the board rejects this value" in rejected.stderr

    quick_simulator.do("accept ignored_channels 127 31")
    altered = trexcmd("set", "ignored_channels", "32", "--force", exits=1)
    assert "wire 32" in altered.stderr, "the requested value"
    assert "none" in altered.stderr, "the stored value"
    trexcmd("set", "ignored_channels", "63", exits=2)  # neither value is recorded

    quick_simulator.do("accept ignored_channels 127")
    accepted = trexcmd("set", "ignored_channels", "63", "--force")
    assert "Recorded as accepted by a TReX 1.2: ignored_channels 63." in accepted.stderr
    assert quick_simulator.show()["parameters"]["ignored_channels"] == 63
    trexcmd("set", "ignored_channels", "0")
    trexcmd("set", "ignored_channels", "63")  # a recorded value needs no --force

    file = tmp_path / "board.txt"
    trexcmd("get-settings", str(file))
    assert "ignored_channels: 63" in file.read_text(encoding="utf-8")
    trexcmd("set-settings", str(file))
    file.write_text("product: TReX\nreversed_channels: 33\n", encoding="utf-8")
    result = trexcmd("set-settings", str(file), exits=1)
    assert "line 2: warning: reversed_channels: should be 0 to 31" in result.stderr
    assert "--force lets the board decide" in result.stderr
    quick_simulator.do("accept reversed_channels 127")
    trexcmd("set-settings", str(file), "--force")


def test_snapshot_is_saved_and_defaults_are_restored_at_next_power_up(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    trexcmd("set", "serial_timeout", "15")
    trexcmd("calibration", "set", "1", "2400", "3700", "5100", "60")
    result = trexcmd("restore-defaults", stdin="y\n")
    snapshot, *_ = SettingsHistory().snapshots()
    assert snapshot.reason == "trexcmd restore-defaults"
    assert SettingsHistory().load(snapshot).parameters["serial_timeout"] == 15
    assert "Switch the board off and on" in result.stderr
    assert "19200 baud" in result.stderr
    quick_simulator.do("power cycle")
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 0
    assert "2400 3700 5100 60" in trexcmd("calibration", "get").stdout


def test_set_settings_takes_snapshot_before_writing(trexcmd: RunCommand, tmp_path: Path) -> None:
    path = tmp_path / "new.txt"
    path.write_text("product: TReX\nserial_timeout: 7\n", encoding="utf-8")
    trexcmd("set-settings", "--dry-run", str(path))
    assert not SettingsHistory().snapshots()
    trexcmd("set-settings", "-", stdin="product: TReX\nserial_timeout: 0\n")
    assert not SettingsHistory().snapshots(), "no setting changes"
    result = trexcmd("set-settings", str(path))
    (snapshot,) = SettingsHistory().snapshots()
    assert str(snapshot.path) in result.stderr
    assert SettingsHistory().load(snapshot).parameters["serial_timeout"] == 0
    trexcmd("set-settings", str(snapshot.path))
    assert trexcmd("get", "serial_timeout").stdout.startswith("0\t")
