"""What the window says at its start of the guardian and of the last run."""

from pathlib import Path

import pytest

from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.core.guardian.log import log_file
from trex_gui.core.transport.driven import driven_file, driven_note
from trex_gui.core.transport.settings import PortSettings, SerialFormat
from trex_gui.ui.devices.connection import ConnectionState


@pytest.mark.parametrize(
    ("result", "said"),
    [
        ("confirmed", "stopped them at 2026-11-23 12:03:05, and the board confirmed that."),
        ("unconfirmed", "If a motor still turns, cut its power."),
    ],
)
def test_stop_by_guardian_is_reported_once(window: WindowDriver, result: str, said: str) -> None:
    log_file().parent.mkdir(parents=True, exist_ok=True)
    log_file().write_text(f"2026-11-23 12:03:05 {result}: Text.\n", encoding="utf-8")
    window.program.report_last_run()
    window.wait_for_text("bannerText", said)
    window.program.window.open_file(Path("picture.unknown"))
    window.wait_for_text("bannerText", "picture.unknown")
    window.program.report_last_run()
    window.wait_for_files()
    assert "picture.unknown" in window.text("bannerText")


def test_crash_is_reported_with_the_stop_or_without(window: WindowDriver) -> None:
    window.program.report_last_run(has_crashed=True)
    window.wait_for_text("bannerText", "did not end properly the last time")
    assert window.has("bannerReport")
    window.click("bannerDismiss")

    log_file().parent.mkdir(parents=True, exist_ok=True)
    log_file().write_text("2026-11-23 12:03:05 unconfirmed: Text.\n", encoding="utf-8")
    window.program.report_last_run(has_crashed=True)
    window.wait_for_text("bannerText", "If a motor still turns, cut its power.")
    window.click("bannerReport")
    assert window.dialog("reportDialog").root.isVisible()


def test_every_stop_is_reported_unconfirmed_ones_first(window: WindowDriver) -> None:
    log_file().parent.mkdir(parents=True, exist_ok=True)
    lines = ("12:00:01 unconfirmed", "12:00:02 unconfirmed", "12:00:03 confirmed")
    log_file().write_text("".join(f"2026-11-23 {line}: Text.\n" for line in lines))
    window.program.report_last_run()
    window.wait_for_text("bannerText", "confirmed that")
    first, second = window.text("bannerText").splitlines()
    assert "2026-11-23 12:00:01, 2026-11-23 12:00:02, which the board did not confirm" in first
    assert "2026-11-23 12:00:03, and the board confirmed" in second


def test_board_that_was_left_running_is_reported_first_until_it_is_stopped(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    url = "/dev/ttyNONE"
    file = driven_file(url)
    file.parent.mkdir(parents=True)
    note = driven_note("TReX 1.2", PortSettings(url, SerialFormat(19200)))
    stop = "stop: d07f7ff000 84 1 1 0 0.05"
    file.write_text(f"{note}{stop}\nsince: 2026-11-28 12:00:00\nguardian: 999999\n")
    danger = "Motors may still be turning: no stop of the TReX 1.2 at /dev/ttyNONE"
    window.program.report_last_run(has_crashed=True)
    window.wait_for_text("bannerText", danger)
    window.connect(quick_simulator.url)  # another one
    window.wait_for_files()
    assert window.text("bannerText").startswith(danger)
    window.click("bannerStop")
    window.wait_for_text("bannerText", "There is no port /dev/ttyNONE")
    assert window.text("bannerText").startswith(danger)
    file.unlink()
    window.click("bannerStop")
    window.wait_for_files()
    window.program.report_last_run()


def test_proper_end_is_not_reported(window: WindowDriver) -> None:
    window.program.report_last_run()
    window.wait_for_files()
    assert not window.has("bannerText")


def test_stop_that_the_program_repeated_is_not_reported(window: WindowDriver) -> None:
    log_file().parent.mkdir(parents=True, exist_ok=True)
    log_file().write_text("2026-11-23 12:03:05 repeated: Text.\n", encoding="utf-8")
    window.program.report_last_run()
    window.wait_for_files()
    assert not window.has("bannerText")


def test_stop_is_still_reported_once_the_board_is_connected_that_was_named_at_the_start(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    log_file().parent.mkdir(parents=True, exist_ok=True)
    log_file().write_text("2026-11-23 12:03:05 unconfirmed: Text.\n", encoding="utf-8")
    window.program.connect_to_port(quick_simulator.url)
    window.program.report_last_run()
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    text = "If a motor still turns, cut its power."
    window.wait_for_text("bannerText", text)
    entries = window.program.workspace("trex").log.entries
    assert [text in entry.text for entry in entries].count(True) == 1
