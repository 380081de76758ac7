"""Motors that were left turning behind a lost line, and a board at another port."""

import sys

import pytest
from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")


class Person:
    """Drives a board whose cable then comes off."""

    def __init__(self, program: Program, qtbot: QtBot) -> None:
        self.device = program.device
        self.wait = qtbot.waitUntil
        self.told: list[str] = []
        label = program.window.findChild(QLabel, "bannerText")
        assert label is not None
        self.banner = label
        self.device.failed.connect(self.told.append)

    def lose(self, board: SimulatedDevice) -> None:
        """Drive a motor and lose the line to it."""
        device = self.device
        device.connect_to(LinkSettings(board.url))
        self.wait(lambda: device.link is Link.UP and device.motors.can_arm)
        device.motors.arm()
        device.motors.set_speed(1, 60)
        self.wait(lambda: device.may_move and bool(board.show()["motors"][0]["speed"]))
        board.do("line unplug")
        self.wait(lambda: device.link is Link.NONE)
        assert device.may_move
        self.told.clear()

    def connect(self, url: str) -> None:
        self.device.connect_to(LinkSettings(url))
        self.wait(lambda: self.device.link is Link.UP and not self.device.may_move)


@pytest.fixture
def person(program: Program, qtbot: QtBot) -> Person:
    return Person(program, qtbot)


def test_a_proof_of_another_board_is_told_to_be_none_of_the_first(
    person: Person, start_simulator: StartSimulator
) -> None:
    first, second = start_simulator(), start_simulator()
    person.lose(first)
    person.connect(second.url)
    person.wait(lambda: bool(person.told))
    (told,) = person.told
    assert first.url in told
    assert "cut the power of the first" in told
    person.wait(lambda: person.banner.isVisible() and person.banner.text() == told)
    person.device.disconnect_line()
    person.wait(lambda: person.device.link is Link.NONE)
    person.connect(second.url)
    assert person.told == [told], "once"


def test_the_board_itself_needs_no_word_of_it(
    person: Person, start_simulator: StartSimulator
) -> None:
    board = start_simulator()
    person.lose(board)
    board.do("line plug")
    person.connect(board.url)
    assert board.show()["motors"][0]["direction"] == "brake"
    assert person.told == []
