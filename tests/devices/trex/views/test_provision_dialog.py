"""Dialog that sets up one board after another."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QLineEdit, QTableWidget

from tests.support.keyboard import check_keyboard
from tests.support.simulator import SimulatedDevice
from tests.support.window import LEFT, WindowDriver
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.model.provision import Provision, ProvisionStep
from trex_gui.devices.trex.settings.provision_record import ProvisionRecord
from trex_gui.devices.trex.views.provision import ProvisionFlow
from trex_gui.devices.trex.views.steps import Steps
from trex_gui.ui.widgets.behaviour import HoldButton

INTERRUPTED = "ended during the motor test"


class ProvisionDialogDriver:
    """Provisioning dialog, a connected board, and the files of the dialog."""

    def __init__(self, window: WindowDriver, board: SimulatedDevice, folder: Path) -> None:
        self.window, self.board = window, board
        self.profile, self.record = folder / "profile.txt", folder / "record.csv"
        lines = ("product: TReX", "firmware: 1.2", "serial_timeout: 5", "motor1_acceleration: 20")
        self.profile.write_text("\n".join(lines), "utf-8")
        window.trigger("provision")
        dialogs = window.find_all(Steps)
        (self.dialog,) = (found for found in dialogs if isinstance(found.flow, ProvisionFlow))
        assert isinstance(self.dialog.flow, ProvisionFlow)
        self.work: Provision = self.dialog.flow.work

    def start(self, *, turns_motors: bool = False) -> None:
        find = self.window.find
        find(QLineEdit, "provisionProfile").setText(str(self.profile))
        find(QLineEdit, "provisionRecord").setText(str(self.record))
        find(QCheckBox, "provisionMotors").setChecked(turns_motors)
        self.press_next()

    def press_next(self) -> None:
        self.window.wait(lambda: self.window.is_enabled("provisionNextButton"))
        self.window.click("provisionNextButton")

    def wait_for(self, step: ProvisionStep) -> None:
        self.window.wait(lambda: self.work.step is step)

    def connect_new_board(self) -> None:
        self.board.do("power off")
        self.wait_for(ProvisionStep.WAIT)
        self.board.do("factory", "power on")
        self.wait_for(ProvisionStep.REVIEW)

    @property
    def rows(self) -> list[list[str]]:
        return [line.split(",") for line in self.record.read_text("utf-8").splitlines()[1:]]


@pytest.fixture
def harness(
    connected_window: WindowDriver, quick_simulator: SimulatedDevice, tmp_path: Path
) -> ProvisionDialogDriver:
    return ProvisionDialogDriver(connected_window, quick_simulator, tmp_path)


def test_each_board_is_set_up_with_one_click(harness: ProvisionDialogDriver) -> None:
    check_keyboard(harness.dialog)
    harness.start()
    for number in (1, 2, 3):
        harness.wait_for(ProvisionStep.REVIEW)
        assert f"robot {number}, device number {number}" in harness.window.text("provisionBoard")
        assert harness.dialog.focusWidget() is harness.window.button("provisionNextButton")
        harness.press_next()
        harness.wait_for(ProvisionStep.UNPLUG)
        harness.window.wait(lambda: len(harness.work.done) == number)  # noqa: B023 - within the loop
        stored = harness.board.show()["parameters"]
        assert (stored["serial_timeout"], stored["motor1_acceleration"]) == (5, 20)
        assert f"robot {number}: written and verified" in harness.window.text("provisionBoard")
        harness.connect_new_board()
    check_keyboard(harness.dialog)
    assert harness.window.find(QTableWidget, "provisionDone").rowCount() == 3
    assert [row[1:4] for row in harness.rows] == [
        [f"robot {number}", str(number), "TReX 1.2"] for number in (1, 2, 3)
    ]
    assert {(row[-2], row[-1]) for row in harness.rows} == {("ok", "new")}


def test_skipped_board_is_unchanged(harness: ProvisionDialogDriver) -> None:
    before = harness.board.show()["parameters"]
    harness.start()
    harness.wait_for(ProvisionStep.REVIEW)
    harness.window.click("provisionSkipButton")
    harness.window.wait(lambda: bool(harness.work.done))
    assert harness.board.show()["parameters"] == before
    assert [(row[2], row[-2]) for row in harness.rows] == [("7", "skipped")]


def test_board_lost_before_writing_is_dropped(harness: ProvisionDialogDriver) -> None:
    harness.start()
    harness.wait_for(ProvisionStep.REVIEW)
    harness.board.do("power off")
    harness.wait_for(ProvisionStep.WAIT)
    assert not harness.window.is_enabled("provisionNextButton")
    assert harness.rows == []


def test_number_of_a_board_lost_during_writing_is_reserved(harness: ProvisionDialogDriver) -> None:
    harness.start()
    harness.wait_for(ProvisionStep.REVIEW)
    harness.press_next()
    harness.window.wait(lambda: harness.window.device.writer.running)
    harness.board.do("power off")
    harness.window.wait(lambda: len(harness.work.done) == 1)
    (row,) = harness.rows
    assert row[2] == "1"
    assert row[-2] not in {"ok", "begun"}
    assert ProvisionRecord(harness.record).free_number() == 2


def test_profile_of_another_model_is_named_and_not_written(harness: ProvisionDialogDriver) -> None:
    harness.profile.write_text("product: TReX Jr\nserial_timeout: 5\n", "utf-8")
    harness.start()
    harness.wait_for(ProvisionStep.UNPLUG)
    assert "for a TReX Jr, not a TReX" in harness.window.text("provisionNote")
    assert harness.rows == []


def test_file_that_is_no_record_is_not_overwritten(harness: ProvisionDialogDriver) -> None:
    harness.record.write_text("my,table\n", "utf-8")
    harness.start()
    harness.window.wait_for_text("provisionTrouble", "is not a record of boards")
    assert harness.work.step is ProvisionStep.PROFILE
    assert harness.record.read_text("utf-8") == "my,table\n"


def test_record_that_cannot_be_saved_is_saved_again(
    harness: ProvisionDialogDriver, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = harness.board.show()["parameters"]
    harness.start()
    harness.wait_for(ProvisionStep.REVIEW)
    with monkeypatch.context() as patch:

        def fail(_record: ProvisionRecord) -> None:
            raise BadRequest("The disk is full.")

        patch.setattr(ProvisionRecord, "save", fail)
        harness.press_next()
        harness.window.wait_for_text("provisionNote", "disk is full")
        assert harness.board.show()["parameters"] == before, "the number is not recorded yet"
    harness.press_next()
    harness.window.wait(lambda: len(harness.work.done) == 1)
    assert harness.rows[0][-2] == "ok"


@pytest.mark.parametrize(
    ("end", "result"),
    [
        (lambda harness: harness.press_next(), "ok"),
        (lambda harness: harness.window.click("provisionSkipButton"), INTERRUPTED),
        (lambda harness: harness.dialog.close(), INTERRUPTED),
        (lambda harness: harness.board.do("power off"), INTERRUPTED),
    ],
    ids=["turned", "skipped", "closed", "lost"],
)
def test_motors_turn_while_a_button_is_held(
    harness: ProvisionDialogDriver, end: Callable[[ProvisionDialogDriver], object], result: str
) -> None:
    def speed() -> tuple[str, int]:
        motor = harness.board.show()["motors"][0]
        return motor["direction"], motor["speed"]

    harness.start(turns_motors=True)
    harness.wait_for(ProvisionStep.REVIEW)
    harness.press_next()
    harness.wait_for(ProvisionStep.MOTORS)
    check_keyboard(harness.dialog)
    harness.window.click("provisionWheelsFree")
    harness.window.wait(lambda: harness.window.is_enabled("provisionRunButton"))
    harness.window.click("provisionRunButton")
    harness.window.wait(lambda: harness.window.is_enabled("provisionHold1"))
    button = harness.window.find(HoldButton, "provisionHold1")
    QTest.mousePress(button, LEFT)
    harness.window.wait(lambda: speed() == ("forward", 25))
    QTest.mouseRelease(button, LEFT)
    harness.window.wait(lambda: speed()[0] == "brake")
    end(harness)
    harness.window.wait(lambda: len(harness.work.done) == 1)
    assert not harness.window.motors.armed
    assert harness.rows[0][-2] == result


def test_closed_dialog_sets_up_no_other_board(harness: ProvisionDialogDriver) -> None:
    harness.start()
    harness.wait_for(ProvisionStep.REVIEW)
    harness.press_next()
    harness.dialog.close()
    harness.wait_for(ProvisionStep.PROFILE)
    assert harness.rows[0][-2] == "ok", "a started write is completed and recorded"
    assert harness.board.show()["parameters"]["serial_timeout"] == 5
