"""Messages cross threads and processes: each must be the same on the other side."""

import pickle
from typing import TypeVar

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.devices.trex.recording.samples import polled
from tests.devices.trex.session.helpers import among, run_for, staged
from trex_gui.core.errors import BadReply, NoReply
from trex_gui.core.session import Close, Closed, Outcome, Progress
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.client.client import Counters
from trex_gui.devices.trex.client.telemetry import (
    Currents,
    Sample,
)
from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.driving.requests import (
    Arm,
    Heartbeat,
    MotorsStopped,
    SetAuxiliary,
    SetMotor,
    SetMotors,
    Stop,
    StopSent,
)
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.commands import (
    COMMANDS,
    DriveBoth,
    GetCalibration,
    GetSignature,
    SetCalibration,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.raw_packets import packets_of
from trex_gui.devices.trex.session.messages import (
    Batch,
    Connected,
    GuardianChanged,
    NotResponding,
    ProbeProgress,
    Reload,
    Report,
    Request,
    RunCommand,
    SendPacket,
    SetReconnectCandidates,
    Write,
)

ThingT = TypeVar("ThingT")

LEARNED = Calibration(2500, 3750, 5000, 75)

REQUESTS: list[Request] = [
    RunCommand(1, GetSignature()),
    RunCommand(2, DriveBoth(Drive.at(5), Drive.brake(), accelerate=True)),
    RunCommand(3, SetCalibration(2, LEARNED)),
    RunCommand(4, GetCalibration(3)),
    SendPacket(5, *packets_of(bytes.fromhex("C2 50"), None)),
    SetMotor(1, Drive.at(-127), accelerate=True),
    SetMotors((SetMotor(1, Drive.at(5)), SetMotor(2, Drive.brake(3)))),
    SetAuxiliary(127),
    Stop(5),
    Stop(5, lockout=3.0),
    Arm(),
    Heartbeat(),
    Write(6, (("serial_timeout", 5),), ((CalibrationKey.RC_CHANNEL_1, LEARNED),)),
    Reload(7),
    SetReconnectCandidates((ConnectionSettings("", LineSettings(9600)),)),
    Close(),
]

REPORTS: list[Report] = [
    Progress(1, 2, "x"),
    ProbeProgress(1, 2, "x"),
    NotResponding("x", Counters(requests=3)),
    MotorsStopped(ErrorCode.NO_HEARTBEAT, confirmed=False),
    Batch((Currents(1.0, (3, 4)),), Counters(1, 2, 3, 4, 0.5)),
    Outcome(1, LEARNED),
    Outcome(2, (WriteResult(CalibrationKey.RC_CHANNEL_1, LEARNED), WriteResult("motor_mode", 1))),
    Closed(None),
    Closed(None, may_move=True),
]


def there_and_back(thing: ThingT) -> ThingT:
    copy: ThingT = pickle.loads(pickle.dumps(thing))
    return copy


@pytest.mark.parametrize("request_", REQUESTS, ids=str)
def test_request_survives_pickling(request_: Request) -> None:
    assert there_and_back(request_) == request_


@pytest.mark.parametrize("report", REPORTS, ids=lambda report: type(report).__name__)
def test_report_survives_pickling(report: Report) -> None:
    assert there_and_back(report) == report


@given(samples=st.tuples(*polled.values()))
def test_sample_of_each_polled_value_survives_pickling(samples: tuple[Sample, ...]) -> None:
    assert there_and_back(samples) == samples


def test_every_command_survives_pickling() -> None:
    for opcode, cls in COMMANDS.items():
        data = b"\x00" * (cls.data_size - 2) + b"\x55\x2a" if 0xA0 <= opcode <= 0xAF else None
        command = cls.from_packet(opcode, data or b"\x01" * cls.data_size)
        assert there_and_back(RunCommand(1, command)) == RunCommand(1, command)


def test_error_with_cause_can_be_pickled() -> None:
    error = BadReply("the error")
    error.__cause__ = NoReply("the cause")
    assert str(there_and_back(error)) == "the error"


@pytest.mark.parametrize("model", ["trex", "trexjr"])
def test_all_reports_of_session_survive_pickling(model: str) -> None:
    stage, settings = staged(model=model)
    stage.script.at(
        1.0, Write(1, (("serial_timeout", 5),), ((CalibrationKey.RC_CHANNEL_1, LEARNED),))
    )
    stage.script.at(1.5, Stop(2)).at(1.6, Reload(3)).at(2.2, stage.board.power_off)
    reports = run_for(stage, 3.0, settings)
    assert {type(report) for report in reports} == {
        Progress, Connected, GuardianChanged, Batch, Outcome, NotResponding, StopSent, Closed,
    }  # fmt: skip
    for report in reports:
        assert there_and_back(report) == report


def test_pickled_state_knows_its_parameters() -> None:
    stage, settings = staged(model="trexjr", firmware="1.0")
    state = among(run_for(stage, 1.0, settings), Connected)[0].state
    copy = there_and_back(state)
    assert copy == state
    assert copy.specs == state.specs


def test_link_settings_survive_pickling() -> None:
    line = LineSettings(115200, Detection.CRC7, 2)
    settings = ConnectionSettings(
        "/dev/ttyUSB0", line, 7, 0x89, timeouts=Timeouts(extra=0.5), name="here"
    )
    assert there_and_back(settings) == settings
