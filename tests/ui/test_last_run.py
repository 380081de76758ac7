"""What the window says at its start of the guardian and of the last run."""

from pathlib import Path

import pytest

from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.core.guardian.log import log_file
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


def test_stop_is_reported_once_the_board_is_connected_that_was_named_at_the_start(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    log_file().parent.mkdir(parents=True, exist_ok=True)
    log_file().write_text("2026-11-23 12:03:05 unconfirmed: Text.\n", encoding="utf-8")
    window.program.connect_to_port(quick_simulator.url)
    window.program.report_last_run()
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    text = "If a motor still turns, cut its power."
    window.wait_for_text("bannerText", text)
    assert text in window.program.workspace("trex").log.entries[-1].text
