"""Arming and confirmed stops of boards that are driven together."""

from dataclasses import replace

import pytest

from tests.devices.trex.session.group_harness import (
    FORWARD,
    GROUP,
    OPENED,
    GroupHarness,
    reports_of,
    run_sequences,
    stop_delays,
)
from tests.devices.trex.session.helpers import of_type, outcomes, read_at, run_for
from trex_gui.core.errors import BadRequest, NoReply
from trex_gui.core.session import Closed
from trex_gui.devices.trex.driving.requests import Arm, MotorsStopped, Stop
from trex_gui.devices.trex.protocol.commands import STOP, Command, SetParameter
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.protocol.framing import Framing
from trex_gui.devices.trex.protocol.raw_packets import packets_of
from trex_gui.devices.trex.session.messages import (
    Connected,
    Reload,
    SelectBoard,
    SendPacket,
    ToBoard,
    Write,
)


@pytest.fixture
def harness() -> GroupHarness:
    return GroupHarness()


def test_group_reads_drives_and_stops_every_board(harness: GroupHarness) -> None:
    harness.drive(until=3.0)
    moving = read_at(harness, 3.0, lambda: harness.moving)
    harness.script.at(3.0, Stop(5))
    stopped = read_at(harness, 3.1, lambda: harness.moving)
    reports = run_for(harness, 4.0, GROUP)
    for number in harness.boards:
        (report,) = of_type(reports_of(number, reports), Connected)
        assert report.state.parameters["device_number"] == number
        assert report.settings == replace(GROUP, device_number=number)
    assert (moving, stopped) == ([{7, 9}], [set()])
    assert outcomes(reports)[5].error is None


def test_motors_rest_until_group_is_armed(harness: GroupHarness) -> None:
    harness.script.at(OPENED, ToBoard(9, FORWARD))
    harness.script.at(OPENED, FORWARD)
    moving = read_at(harness, 3.0, lambda: harness.moving)
    run_for(harness, 4.0, GROUP)
    assert moving == [set()]
    assert harness.transport.guardian.watched == []


@pytest.mark.parametrize("moment", [0.05, 0.3, 0.4])
def test_motors_rest_until_every_board_is_read(harness: GroupHarness, moment: float) -> None:
    for step in (Arm(), ToBoard(7, FORWARD), ToBoard(9, FORWARD)):
        harness.script.at(moment, step)
    moving = [read_at(harness, moment + 0.1 * step, lambda: harness.moving) for step in range(20)]
    run_for(harness, 4.0, GROUP)
    assert moving == [[set()]] * 20


@pytest.mark.parametrize(
    "command",
    [SetParameter(0, 12), SetParameter(0, 7)],
    ids=["free number", "taken number"],
)
def test_typed_packet_changes_no_device_number_of_a_group(
    harness: GroupHarness, command: Command[object]
) -> None:
    (raw,) = packets_of(Framing(9, None).encode(command), None)
    harness.drive(until=3.5, actions={3.0: SendPacket(5, raw)})
    harness.script.at(3.5, Stop(6))
    moving = read_at(harness, 3.6, lambda: harness.moving)
    reports = run_for(harness, 4.0, GROUP)
    assert isinstance(outcomes(reports)[5].error, BadRequest)
    assert harness.ninth.eeprom["device_number"] == 9
    assert outcomes(reports)[6].error is None
    assert moving == [set()]


def test_stop_is_sent_to_both_boards_at_once_and_confirmed() -> None:
    """Check 60 stops. The soak test checks 100,000."""
    sent, confirmed = stop_delays(60, seed=1)
    assert max(sent) <= 0.020
    assert max(confirmed) <= 0.060


@pytest.mark.parametrize("number", [7, 9])
@pytest.mark.parametrize("cause", ["power loss", "stop of this board"])
def test_loss_of_one_board_stops_the_other(harness: GroupHarness, number: int, cause: str) -> None:
    if cause == "power loss":
        harness.drive(until=3.5, actions={3.0: harness.boards[number].power_off})
    else:
        harness.drive(until=3.0)
        harness.script.at(3.0, ToBoard(number, Stop(1)))
    moving = read_at(harness, 3.6, lambda: harness.moving)
    reports = run_for(harness, 4.0, GROUP)
    assert moving == [set()]
    (stopped,) = of_type(reports_of(16 - number, reports), MotorsStopped)
    assert stopped == MotorsStopped(ErrorCode.LEFT_GROUP, confirmed=True, board=number)


def test_random_sequences_move_no_motor_without_arming() -> None:
    assert run_sequences(60, seed=1) == []


def test_missing_heartbeats_stop_every_board(harness: GroupHarness) -> None:
    harness.drive(until=3.0)
    moving = read_at(harness, 3.7, lambda: harness.moving)
    reports = run_for(harness, 4.0, GROUP)
    assert moving == [set()]
    assert all(of_type(reports_of(number, reports), MotorsStopped) for number in harness.boards)


def test_stop_sequence_of_guardian_contains_every_board(harness: GroupHarness) -> None:
    harness.drive(until=3.0)
    run_for(harness, 3.0, GROUP)
    sequence = next(
        watched for watched in harness.transport.guardian.watched if watched is not None
    )
    for number in harness.boards:
        framing = replace(GROUP, device_number=number, group=()).framing
        assert b"".join(map(framing.encode, STOP)) in sequence.packets
    assert len(sequence.queries) == 2


def test_error_names_missing_board_of_a_group(harness: GroupHarness) -> None:
    harness.ninth.power_off()
    (closed,) = of_type(run_for(harness, 4.0, GROUP), Closed)
    assert isinstance(closed.error, NoReply)
    assert "Board 9" in str(closed.error)


@pytest.mark.parametrize(
    "request_",
    [SelectBoard(1, 9), Write(1, (("device_number", 5),)), ToBoard(5, Reload(1))],
    ids=["selection", "number", "board outside the group"],
)
def test_group_rejects_selection_new_number_and_other_boards(
    harness: GroupHarness, request_: SelectBoard | Write | ToBoard
) -> None:
    harness.script.at(OPENED, request_)
    reports = run_for(harness, 4.0, GROUP)
    assert isinstance(outcomes(reports)[1].error, BadRequest)
