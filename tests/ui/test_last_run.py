"""Startup messages about the guardian and the last run."""

from collections.abc import Callable
from functools import partial

import pytest
from pytestqt.qtbot import QtBot

from tests.core.transport.test_driven import write_driven_file
from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.core.guardian.log import log_file
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.files import background
from trex_gui.ui.last_run import report_last_run, stop_running_boards
from trex_gui.ui.notifier import Notifier


class Messages(list[tuple[str, str]]):
    """Kind and text of each message of a notifier."""

    def __init__(self, qtbot: QtBot) -> None:
        self.notifier = Notifier()
        for kind in ("info", "error", "danger"):
            getattr(self.notifier, kind).connect(lambda text, kind=kind: self.append((kind, text)))
        self._qtbot = qtbot

    def of(self, report: Callable[[Notifier], None]) -> list[tuple[str, str]]:
        """Run a function that reports. Return its messages."""
        self.clear()
        report(self.notifier)
        self._qtbot.waitUntil(lambda: not background)
        return list(self)


@pytest.fixture
def messages(qtbot: QtBot) -> Messages:
    return Messages(qtbot)


def log_stops(*stops: str) -> None:
    """Write stops to the log of the guardian. `stops`: time and result of each."""
    log_file().parent.mkdir(parents=True, exist_ok=True)
    log_file().write_text("".join(f"2026-11-23 {stop}: Text.\n" for stop in stops))


@pytest.mark.parametrize(
    ("result", "text"),
    [
        ("confirmed", "stopped them at 2026-11-23 12:03:05, and the board confirmed the stop."),
        ("unconfirmed", "If a motor is still turning, cut its power."),
    ],
)
def test_stop_by_guardian_is_reported_once(messages: Messages, result: str, text: str) -> None:
    log_stops(f"12:03:05 {result}")
    assert [text in message for _, message in messages.of(report_last_run)] == [True]
    assert messages.of(report_last_run) == []


def test_crash_is_reported_if_there_was_no_stop(window: WindowDriver) -> None:
    window.program.report_last_run(has_crashed=True)
    window.wait_for_text("bannerText", "did not end properly last time")
    assert window.has("bannerReport")


def test_stop_is_reported_instead_of_a_crash(window: WindowDriver) -> None:
    log_stops("12:03:05 unconfirmed")
    window.program.report_last_run(has_crashed=True)
    window.wait_for_text("bannerText", "If a motor is still turning, cut its power.")
    assert "did not end properly" not in window.text("bannerText")
    window.click("bannerReport")
    assert window.dialog("reportDialog").root.isVisible()


def test_unconfirmed_stops_are_reported_before_confirmed_stops(messages: Messages) -> None:
    log_stops("12:00:01 unconfirmed", "12:00:02 unconfirmed", "12:00:03 confirmed")
    [(_, text)] = messages.of(report_last_run)
    first, second = text.splitlines()
    assert "2026-11-23 12:00:01, 2026-11-23 12:00:02, but the board did not confirm" in first
    assert "2026-11-23 12:00:03, and the board confirmed" in second


def test_running_board_is_reported_first_until_it_is_stopped(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    url = "/dev/ttyNONE"
    file = write_driven_file(url)
    danger = "Motors may still be turning: no stop has been confirmed for the TReX 1.2"
    window.program.report_last_run(has_crashed=True)
    window.wait_for_text("bannerText", danger)
    window.connect(quick_simulator.url)  # not the running board
    window.wait_for_files()
    assert window.text("bannerText").startswith(danger)
    window.click("bannerStop")
    window.wait_for_text("bannerText", "There is no port /dev/ttyNONE")
    assert window.text("bannerText").startswith(danger)
    file.unlink()
    window.click("bannerStop")
    window.wait_for_files()
    assert not window.has("bannerText")


def test_stop_of_each_running_board_is_tried_and_reported(messages: Messages) -> None:
    write_driven_file("/dev/ttyNONE1")
    write_driven_file("/dev/ttyNONE2")
    [(kind, text)] = messages.of(stop_running_boards)
    assert kind == "danger"
    dangers, errors = text.splitlines()[:2], text.splitlines()[2:]
    for lines, start in ((dangers, "Motors may still be turning"), (errors, "There is no port")):
        assert [line.startswith(start) for line in lines] == [True, True]
        assert all(f"/dev/ttyNONE{number}" in "".join(lines) for number in (1, 2))


def test_unconfirmed_stop_is_reported_again_while_a_board_runs(messages: Messages) -> None:
    file = write_driven_file("/dev/ttyNONE")
    log_stops("12:03:05 unconfirmed")
    for _ in range(2):  # because a new connection clears the first message
        [(kind, text)] = messages.of(report_last_run)
        assert kind == "danger"
        assert text.splitlines()[1].endswith("If a motor is still turning, cut its power.")
    file.unlink()
    [(kind, text)] = messages.of(report_last_run)
    assert (kind, text.count("\n")) == ("error", 0)
    assert messages.of(report_last_run) == []


def test_proper_end_and_repeated_stop_are_not_reported(messages: Messages) -> None:
    assert messages.of(report_last_run) == []
    log_stops("12:03:05 repeated")
    assert messages.of(report_last_run) == []


def test_report_of_a_stop_survives_a_connection_and_is_logged_once(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    log_stops("12:03:05 unconfirmed")
    window.program.connect_to_port(quick_simulator.url)
    window.program.report_last_run()
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    text = "If a motor is still turning, cut its power."
    window.wait_for_text("bannerText", text)
    entries = window.program.workspace("trex").log.entries
    assert sum(text in entry.text for entry in entries) == 1


def test_stops_after_the_start_of_the_program_are_not_reported(messages: Messages) -> None:
    log_stops("12:03:05 unconfirmed")
    log_file().write_text(log_file().read_text() + "2999-01-01 12:00:00 confirmed: Text.\n")
    file = write_driven_file("/dev/ttyUSB0")
    file.write_text(file.read_text().replace("2026-11-28", "2999-01-01"))
    ((_, text),) = messages.of(partial(report_last_run, until="2030"))
    assert text.count("2026-11-23 12:03:05") == 1
    assert "2999" not in text
    ((_, text),) = messages.of(partial(report_last_run, until="9999"))
    assert text.count("2999") == 1
