"""What a window with a TReX says when the program stops the motors by itself: what is proved."""

import sys
from collections.abc import Callable, Iterator

import pytest
from PySide6.QtWidgets import QApplication, QLabel
from pytestqt.qtbot import QtBot

from tests.end_to_end.test_every_stop_cause import is_stopped
from tests.support.causes import Causes, watched
from tests.support.simulator import SimulatedDevice
from trex_gui.link.explain import BEYOND_A_STOP
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

LOCKED = "The screen was locked"
MISTAKEN = "The program made a mistake (ValueError)"


@pytest.fixture
def causes(program: Program, qtbot: QtBot, qapp: QApplication) -> Iterator[Causes]:
    with watched(program, qtbot, qapp) as causes:
        yield causes


class Scene:
    """A person at a window, in which something happens."""

    def __init__(self, program: Program, qtbot: QtBot) -> None:
        self.program, self.device = program, program.device
        self._qtbot = qtbot

    def wait(self, condition: Callable[[], bool]) -> None:
        self._qtbot.waitUntil(condition, timeout=15_000)

    def drive(self) -> None:
        """Let a motor run."""
        motors = self.device.motors
        self.wait(lambda: self.device.link is Link.UP and motors.can_arm)
        motors.arm()
        motors.set_speed(1, 60)
        self.wait(lambda: self.device.may_move)

    def text(self, name: str) -> str:
        label = self.program.window.findChild(QLabel, name)
        assert label is not None, name
        return label.text()


@pytest.fixture
def scene(program: Program, qtbot: QtBot) -> Scene:
    return Scene(program, qtbot)


@pytest.fixture
def driving(scene: Scene, quick_simulator: SimulatedDevice) -> Scene:
    """A board whose first motor runs."""
    scene.device.connect_to(LinkSettings(quick_simulator.url))
    scene.drive()
    scene.wait(lambda: quick_simulator.show()["motors"][0]["speed"] == 60)
    return scene


@pytest.mark.parametrize(
    ("cause", "reason"), [("make_a_mistake", MISTAKEN), ("lock_the_screen", LOCKED)]
)
def test_the_demo_is_said_to_be_stopped_once_it_is_proved(
    cause: str, reason: str, scene: Scene, causes: Causes
) -> None:
    scene.program.connect_to_demo("trex")
    scene.wait(lambda: scene.device.link is Link.UP)
    scene.drive()
    getattr(causes, cause)()
    scene.wait(lambda: causes.banner == f"{reason}, so the motors were stopped.")
    assert not scene.device.may_move
    first, *_, last = causes.told
    assert first == f"{reason}. The stop was sent, and is not confirmed yet."
    assert last == causes.banner


def test_the_row_below_and_the_list_of_events_give_the_reason_and_claim_no_more(
    driving: Scene, causes: Causes
) -> None:
    causes.lock_the_screen()
    driving.wait(lambda: causes.banner == f"{LOCKED}, so the motors were stopped.")
    assert driving.text("motorStateLabel") == f"Stopped. {LOCKED}."
    assert f"Stop: {LOCKED}." in [event.text for event in driving.device.events.all]


def test_a_mistake_is_still_reported_and_the_window_goes_on(
    driving: Scene, causes: Causes, quick_simulator: SimulatedDevice
) -> None:
    causes.make_a_mistake()
    driving.wait(lambda: causes.banner == f"{MISTAKEN}, so the motors were stopped.")
    assert causes.mistakes == [ValueError]
    assert is_stopped(quick_simulator)
    driving.drive()
    driving.wait(lambda: quick_simulator.show()["motors"][0]["speed"] == 60)


def test_of_a_board_that_is_silent_no_stop_is_claimed_before_it_answers_again(
    driving: Scene, causes: Causes, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("line mute on")
    causes.lock_the_screen()
    said = (
        f"{LOCKED}. The stop was sent, but the board does not confirm it. If a motor still turns, "
        "cut its power."
    )
    driving.wait(lambda: causes.banner == said)
    assert not [text for text in causes.told if "were stopped" in text]
    assert driving.device.may_move
    quick_simulator.do("line mute off")
    driving.wait(lambda: causes.banner == f"{LOCKED}, so the motors were stopped.")
    driving.wait(lambda: not driving.device.may_move)
    assert is_stopped(quick_simulator)


def test_where_channels_drive_the_stop_is_said_not_to_reach_the_motors(
    scene: Scene, causes: Causes, quick_simulator: SimulatedDevice
) -> None:
    for line in ("jumper mode rc", "power off", "power on"):
        quick_simulator.do(line)
    scene.device.connect_to(LinkSettings(quick_simulator.url))
    scene.wait(lambda: scene.device.link is Link.UP)
    causes.lock_the_screen()
    scene.wait(lambda: causes.banner == f"{LOCKED}. {BEYOND_A_STOP}")
    for line in ("jumper mode serial", "power off", "power on"):
        quick_simulator.do(line)


def test_motors_that_were_left_turning_are_said_to_be_out_of_reach(
    driving: Scene, causes: Causes, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("line unplug")
    driving.wait(lambda: driving.device.link is Link.NONE)
    assert driving.device.may_move
    causes.lock_the_screen()
    said = (
        "No board is connected that could be stopped, and motors may still turn: cut their power."
    )
    driving.wait(lambda: causes.banner == f"{LOCKED}. {said}")
    assert len(causes.told) == 1


def test_with_nothing_connected_a_locked_screen_is_no_news_and_a_mistake_is(
    scene: Scene, causes: Causes
) -> None:
    causes.lock_the_screen()
    causes.make_a_mistake()
    scene.wait(lambda: bool(causes.told))
    assert causes.told == [f"{MISTAKEN}."]
    scene.wait(lambda: causes.banner == f"{MISTAKEN}.")


def test_nothing_is_said_to_have_been_stopped_when_a_board_is_connected_later(
    scene: Scene, causes: Causes, quick_simulator: SimulatedDevice
) -> None:
    causes.lock_the_screen()
    causes.make_a_mistake()
    scene.wait(lambda: bool(causes.told))
    scene.device.connect_to(LinkSettings(quick_simulator.url))
    scene.wait(lambda: scene.device.link is Link.UP and scene.device.motors.can_arm)
    assert scene.text("motorStateLabel") == "Not armed: nothing is sent before Run motor."


def test_a_line_that_is_lost_with_the_stop_claims_nothing(
    driving: Scene, causes: Causes, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("line unplug")
    causes.lock_the_screen()  # before the window has seen that the cable is gone, or behind it
    driving.wait(lambda: driving.device.link is Link.NONE and bool(causes.told))
    driving.wait(lambda: not causes.told[-1].endswith("is not confirmed yet."))
    assert not [text for text in causes.told if "were stopped" in text]
    assert causes.told[-1].endswith("cut its power.") or causes.told[-1].endswith("their power.")
