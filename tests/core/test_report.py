"""Support report."""

import zipfile
from pathlib import Path

import pytest

from trex_gui.core import report
from trex_gui.core.errors import StudioError
from trex_gui.core.files import SettingsError, log_folder
from trex_gui.core.log_file import log_files
from trex_gui.core.report import Mask, ReportFile, create_report, save_report

MASK = Mask("/home/mary", "mary", "Rover-Lab.example.org", ("A9007L6T", "0001", "7"))


@pytest.mark.parametrize(
    ("text", "masked"),
    [
        ("Saved /home/mary/robots/tank.txt.", "Saved ~/robots/tank.txt."),
        ("/home/maryann/x and /Users/bob/y", "/home/<user>/x and /Users/<user>/y"),
        (r"C:\Users\Bob Smith\x, D:/Users/bob/x", r"C:\Users\<user>\x, D:/Users/<user>/x"),
        ("mary on rover-lab; MARY@Rover-Lab.example.org", "<user> on <computer>; <mail>"),
        ("summary, maryland, mary's", "summary, maryland, <user>'s"),
        ("SNR=A9007L6T LOCATION=1-2", "SNR=<serial 1> LOCATION=1-2"),
        (
            "/dev/serial/by-id/usb-FTDI_FT232R_USB_UART_XYZ123-if00-port0",
            "/dev/serial/by-id/usb-FTDI_FT232R_USB_UART_<serial>-if00-port0",
        ),
        ("usb-FTDI_UART_XYZ123-if00 is gone", "usb-FTDI_UART_<serial>-if00 is gone"),
        ("/dev/cu.usbserial-XYZ123: x", "/dev/cu.usbserial-<serial>: x"),
        ("/dev/tty.usbserial-A9007L6T.", "/dev/tty.usbserial-<serial>."),
        ("/dev/cu.JohnsAirPods-Serial, /dev/cu.John", "/dev/cu.<serial>, /dev/cu.<serial>"),
        ("/dev/cu.SLAB_USBtoUART, /dev/cu.debug-console: x", None),
        ("USB VID:PID=0403:6001 SER=XYZ987Q", "USB VID:PID=0403:6001 SER=<serial>"),
        ("USB VID:PID=10C4:EA60 SER=0001 LOCATION=1-1", None),
        (
            r"BTHENUM\{00001101-0000-1000-8000-00805F9B34FB}\7&2A&0&A4C138AABBCC_C00000000",
            r"BTHENUM\{00001101-0000-1000-8000-00805F9B34FB}\7&2A&0&<address>_C00000000",
        ),
        ("socket://bobs-pi:2000 at 10.0.0.7", "socket://<address>:2000 at <address>"),
        ("socket://[2001:db8::1]:20", "socket://<address>:20"),
        ("rfc2217://bob:word@nas:20", "rfc2217://<address>:20"),
        ("trex://bob@nas/arm, trex://nas/arm", "trex://<address>/arm, trex://<address>/arm"),
        ("socket://localhost.bobs.org:20", "socket://<address>:20"),
        ("2001:db8::8a2e:370:7334, A4:C1:38:AA:BB:CC", "<address>, <address>"),
        ("2026-11-23 21:05:18.250 spy:///dev/ttyUSB0 socket://[::1]:20", None),
        ("/media/bob/STICK/x, /run/media/bob/x", "/media/<user>/STICK/x, /run/media/<user>/x"),
        (r'"C:\\Users\\bob\\x" \\bobs-nas\x', r'"C:\\Users\\<user>\\x" \\<computer>\x'),
        ("socket://127.0.0.1:2000 /dev/ttyUSB0 COM3", "socket://127.0.0.1:2000 /dev/ttyUSB0 COM3"),
        ("TReX 1.2 replied 54 52 65 58 at 19200 baud", None),
    ],
)
def test_personal_names_are_masked(text: str, masked: str | None) -> None:
    assert MASK.clean(text) == (text if masked is None else masked)


@pytest.mark.parametrize("number", range(8))  # the order of a set would differ
def test_full_name_of_the_computer_is_masked(number: int) -> None:
    name = f"rover{number}.smith.example"
    assert Mask(computer=name).clean(f"{name}, rover{number}") == "<computer>, <computer>"


def test_common_and_short_names_are_not_masked() -> None:
    assert Mask("/root", "Root", "pi").clean("Root of /root/x, pi") == "Root of ~/x, pi"
    assert Mask("/", "me", "").clean("some / of me") == "some / of me"


def test_home_folder_of_windows_is_masked_with_either_slash() -> None:
    mask = Mask(r"C:\Users\Mary Ann")
    assert mask.clean(r"C:\Users\Mary Ann\x, C:/Users/Mary Ann/y") == r"~\x, ~/y"


def test_report_contains_parts_and_reasons_for_missing_parts(tmp_path: Path) -> None:
    def fail() -> str:
        raise StudioError("No TReX responds on /home/mary/port.")

    parts = {"log.txt": lambda: "by mary \udce9\n", "status.txt": fail, "empty.txt": lambda: ""}
    files = create_report(parts, MASK)
    texts = {file.name: file.text for file in files}
    assert texts["log.txt"] == "by <user> \udce9\n"
    assert texts["status.txt"] == "Not available: No TReX responds on ~/port.\n"
    assert "empty.txt" not in texts
    assert "Python: " in texts["versions.txt"]
    assert texts["ports.txt"]

    path = tmp_path / "report.zip"
    save_report(path, files)
    with zipfile.ZipFile(path) as archive:
        assert archive.namelist() == [file.name for file in files]
        assert archive.read("log.txt") == b"by <user> \\udce9\n"


def test_report_contains_newest_entries_of_all_log_files(monkeypatch: pytest.MonkeyPatch) -> None:
    def program_log() -> str:
        files = create_report({}, MASK)
        return next((file.text for file in files if file.name == "program.txt"), "")

    assert not program_log()
    log_folder().mkdir(parents=True)
    *_, older, newest = log_files()
    older.write_text("by mary: 1\nby mary: 2\n", encoding="utf-8")
    newest.write_text("by mary: 3\n", encoding="utf-8")
    assert program_log() == "by <user>: 1\nby <user>: 2\nby <user>: 3\n"
    monkeypatch.setattr(report, "_LARGEST_LOG", 15)
    assert program_log() == ": 2\nby <user>: 3\n"


def test_failed_save_of_report_leaves_no_file(tmp_path: Path) -> None:
    path = tmp_path / "report.zip"
    path.mkdir()
    with pytest.raises(SettingsError):
        save_report(path, [ReportFile("a", "b")])
    assert list(tmp_path.iterdir()) == [path]
