"""The window reports automatic stops and their confirmation by the board."""

from collections.abc import Iterator

import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.support.causes import Causes, watched
from tests.support.pages.motors import is_stopped
from tests.support.simulator import SimulatedDevice
from tests.support.window import TIMEOUT_MS, WindowDriver
from trex_gui.devices.trex.protocol.descriptions import STOP_WITHOUT_EFFECT
from trex_gui.ui.devices.connection import ConnectionState

LOCKED = "The screen was locked"
INTERNAL_ERROR = "Internal error (ValueError)"
NOT_ARMED = "Not armed: no motor is driven."


def stopped(reason: str) -> str:
    """Return the banner text of a confirmed stop."""
    return f"{reason}, so the motors were stopped."


@pytest.fixture
def causes(window: WindowDriver, qtbot: QtBot, qapp: QApplication) -> Iterator[Causes]:
    with watched(window.program, qtbot, qapp) as causes:
        yield causes


def drive(window: WindowDriver, simulator: SimulatedDevice | None = None) -> None:
    window.wait(
        lambda: window.device.link is ConnectionState.CONNECTED and window.motors.is_available
    )
    window.motors.arm()
    window.motors.set_speed(1, 60)
    window.wait(lambda: window.device.may_move)
    if simulator is not None:
        window.wait(lambda: simulator.show()["motors"][0]["speed"] == 60)


def wait_for_banner(window: WindowDriver, causes: Causes, text: str) -> None:
    def check() -> None:
        assert causes.banner == text

    window.qtbot.waitUntil(check, timeout=TIMEOUT_MS)


def test_window_shows_stop_reason_and_can_arm_again(
    connected_window: WindowDriver, causes: Causes, quick_simulator: SimulatedDevice
) -> None:
    window = connected_window
    drive(window, quick_simulator)
    causes.lock_the_screen()
    wait_for_banner(window, causes, stopped(LOCKED))
    assert window.text("motorStateLabel") == f"Stopped. {LOCKED}."
    assert f"Stop: {LOCKED}." in [event.text for event in window.device.events.all]
    assert not causes.exceptions

    drive(window, quick_simulator)
    causes.raise_in_slot()
    wait_for_banner(window, causes, stopped(INTERNAL_ERROR))
    assert causes.exceptions == [ValueError]
    assert is_stopped(quick_simulator)
    drive(window, quick_simulator)


def test_repeated_error_disarms_motors_again(
    connected_window: WindowDriver, causes: Causes, quick_simulator: SimulatedDevice
) -> None:
    window = connected_window
    drive(window, quick_simulator)
    causes.raise_in_slot()
    wait_for_banner(window, causes, stopped(INTERNAL_ERROR))
    window.motors.arm()
    assert window.motors.armed
    causes.raise_in_slot()  # within a second
    window.wait(lambda: not window.motors.armed)
    reports = len(causes.reports)
    causes.raise_in_slot()
    window.wait(lambda: len(causes.exceptions) == 3)
    window.wait(lambda: not window.device.may_move)
    assert len(causes.reports) <= reports + 1, "at most the result of the stop is reported"


def test_stop_stays_unconfirmed_while_board_does_not_reply(
    connected_window: WindowDriver, causes: Causes, quick_simulator: SimulatedDevice
) -> None:
    window = connected_window
    drive(window, quick_simulator)
    quick_simulator.do("line mute on")
    causes.lock_the_screen()
    unconfirmed = (
        f"{LOCKED}. The stop was sent, but the board does not confirm it. If a motor is "
        "still turning, cut its power."
    )
    window.wait(lambda: unconfirmed in causes.reports)
    window.wait(lambda: causes.banner.startswith("Motor 1 may still be turning."))
    assert not [text for text in causes.reports if "were stopped" in text]
    assert window.device.may_move
    quick_simulator.do("line mute off")
    window.wait(lambda: stopped(LOCKED) in causes.reports)
    window.wait(lambda: not window.device.may_move)
    assert is_stopped(quick_simulator)

    drive(window, quick_simulator)
    quick_simulator.do("line unplug")
    window.wait(lambda: window.device.link is ConnectionState.DISCONNECTED)
    assert window.device.may_move
    causes.reports.clear()
    causes.lock_the_screen()
    unreachable = (
        "Motors may still be turning: cut their power. No board is connected, so no stop can be "
        "sent."
    )
    window.wait(lambda: causes.reports == [f"{LOCKED}. {unreachable}"])
    assert causes.banner.startswith("Motor 1 may still be turning.")


def test_stop_stays_unconfirmed_when_board_is_unplugged(
    connected_window: WindowDriver, causes: Causes, quick_simulator: SimulatedDevice
) -> None:
    window = connected_window
    drive(window, quick_simulator)
    quick_simulator.do("line unplug")
    causes.lock_the_screen()  # the window may not have detected the unplugged cable yet
    window.wait(lambda: window.device.link is ConnectionState.DISCONNECTED and causes.reports)
    window.wait(lambda: not causes.reports[-1].endswith("is not confirmed yet."))
    assert not [text for text in causes.reports if "were stopped" in text]
    assert causes.reports[-1].endswith("cut its power.") or causes.reports[-1].endswith(
        "their power."
    )


def test_no_stop_is_reported_without_stoppable_motors(
    window: WindowDriver, causes: Causes, quick_simulator: SimulatedDevice
) -> None:
    causes.lock_the_screen()
    causes.raise_in_slot()
    window.wait(lambda: causes.reports)
    assert causes.reports == [f"{INTERNAL_ERROR}."]
    wait_for_banner(window, causes, f"{INTERNAL_ERROR}.")

    window.connect(quick_simulator.url)
    window.wait(lambda: window.motors.is_available)
    assert window.text("motorStateLabel") == NOT_ARMED, (
        "the screen lock stops no board that connects later"
    )

    quick_simulator.do("jumper mode rc", "power off", "power on")
    window.wait(
        lambda: window.device.link is ConnectionState.CONNECTED and not window.motors.is_available
    )
    causes.lock_the_screen()
    wait_for_banner(window, causes, f"{LOCKED}. {STOP_WITHOUT_EFFECT}")
