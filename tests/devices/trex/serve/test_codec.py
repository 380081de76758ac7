"""Encoding of messages between a served board and its clients."""

import random
from typing import Any

import pytest
from msgspec import msgpack

from trex_gui.core.errors import BadRequest, NoReply, PortUnavailable, StudioError
from trex_gui.core.session import Closed, Outcome, Progress
from trex_gui.core.transport.traffic import TrafficDirection, TrafficEvent
from trex_gui.devices.trex.client.client import Counters
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.telemetry import (
    Control,
    Currents,
    LatchedStatus,
    ModeSample,
    Raw,
    Remapped,
)
from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.driving import requests
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import (
    BoardElsewhere,
    ErrorCode,
    Rejected,
    ResultCode,
    TrexBadReplyError,
    TrexError,
    TrexNoReplyError,
)
from trex_gui.devices.trex.protocol.flags import Mode, Status, UartError
from trex_gui.devices.trex.protocol.framing import Malformed
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.raw_packets import RawPacket
from trex_gui.devices.trex.serve import codec
from trex_gui.devices.trex.session import messages

BOARD = Signature(device_table().models[0], "1.2")
CALIBRATION = Calibration(2500, 3750, 5000, 50)
STATE = DeviceState(
    BOARD,
    Mode.SERIAL_RC,
    True,
    {"serial_timeout": 5},
    {1: CALIBRATION},
    3,
    {"motor_mode": "no reply"},
)
SETTINGS = ConnectionSettings(
    "/dev/ttyUSB0", LineSettings(115200, Detection.CRC7), 9, reserved=frozenset({1})
)
SAMPLES = (
    Raw(1.5, (1, None, 3, 4, 5)),
    Remapped(2.0, (1, -127, 3, 4, 5)),
    Currents(2.0, (1, 2)),
    LatchedStatus(3.0, Status.UART_ERROR | Status.MOTOR1_FAULT, UartError.CRC, is_whole=False),
    Control(1.0, True),
    ModeSample(1.0, Mode.RC),
)
RESULTS = (
    WriteResult("serial_timeout", 5),
    WriteResult("rc_channel_1", CALIBRATION),
    WriteResult("motor_mode", None, Rejected("motor_mode", ResultCode.BAD_VALUE)),
)
REPORTS: tuple[Any, ...] = (
    messages.Batch(SAMPLES, Counters(1, 2, 3, slowest=0.1)),
    messages.Connected(
        STATE, False, messages.ReadReason.OPENED, SETTINGS, port_rates=frozenset({9600})
    ),
    messages.GuardianChanged(True),
    messages.NotResponding("no reply", Counters()),
    requests.StopSent(),
    requests.CommandsRepeated(),
    requests.MotorsStopped(ErrorCode.NO_HEARTBEAT, True),
    requests.MotorsStopped(None, False),
    Outcome(3, b"\x0a"),
    Outcome(4, messages.Written(RESULTS, STATE, SETTINGS)),
    Outcome(5, BOARD),
    Outcome(6),
    messages.OfBoard(9, Outcome(4, messages.Written(RESULTS, STATE, SETTINGS))),
    messages.OfBoard(
        9, messages.Connected(STATE, False, messages.ReadReason.OPENED, SETTINGS.with_group((7, 9)))
    ),
    Closed(PortUnavailable("lost"), True),
    Closed(None),
    Progress(1, 2, "x"),
    messages.ProbeProgress(1, 2, "x"),
    messages.LeaseChanged("bob", "alice", False, ("bob",), may_take=True),
    messages.NetworkDelay(0.01),
    messages.Traffic((TrafficEvent(1.5, TrafficDirection.SENT, b"\x81"),)),
    codec.Welcome("arm"),
    codec.Tick(),
    codec.Refused("another version"),
)
REQUESTS: tuple[Any, ...] = (
    messages.SendPacket(1, RawPacket(Malformed(b"\x81", ""))),
    messages.Write(
        2, (("serial_timeout", 5),), ((CalibrationKey.RC_CHANNEL_1, CALIBRATION),), STATE
    ),
    messages.Write(3),
    messages.Reload(4),
    messages.ProbeNumber(5, 9),
    messages.SelectBoard(6, 9, (7, 9)),
    requests.SetMotor(1, Drive.at(-5)),
    requests.SetMotors(
        (requests.SetMotor(1, Drive.at(5)), requests.SetMotor(2, Drive.brake(7), True))
    ),
    requests.SetAuxiliary(5),
    requests.Stop(7),
    messages.ToBoard(9, requests.SetMotor(1, Drive.at(-5))),
    messages.ToBoard(9, messages.Write(2, (("serial_timeout", 5),))),
    requests.Arm(6),
    requests.Heartbeat(1.0),
    requests.Heartbeat(),
    messages.SetReconnectCandidates((SETTINGS,)),
    messages.SetWatched(False),
    messages.SetWatched(True, traffic=True),
    messages.AskLease(),
    messages.HandOver("bob"),
    messages.TakeLease(),
    messages.ReturnLease(),
    codec.Hello(1, "x"),
    codec.Alive(),
    codec.Leave(),
)


@pytest.mark.parametrize("report", REPORTS, ids=lambda message: type(message).__name__)
def test_report_is_decoded_unchanged(report: Any) -> None:
    head, received = codec.decode_report(codec.with_header(codec.encode_report(report), 1, 2.5), 2)
    assert list(head) == [1, 2.5]
    assert repr(received) == repr(report)


@pytest.mark.parametrize("request_", REQUESTS, ids=lambda message: type(message).__name__)
def test_request_is_decoded_unchanged(request_: Any) -> None:
    head, received = codec.decode_request(codec.encode_request(request_, 1, 2.5), 2)
    assert list(head) == [1, 2.5]
    assert repr(received) == repr(request_), "enums keep their type"


@pytest.mark.parametrize(
    "error",
    [
        NoReply("nothing"),
        TrexNoReplyError(ErrorCode.NO_REPLY, "86 1F"),
        TrexBadReplyError(ErrorCode.PARAMETER_MISMATCH, "motor_mode", 1, 2),
        TrexError(ErrorCode.STRAY_WRITE, "x", (TrexError(ErrorCode.CLOSED), "y")),
        Rejected("motor_mode", ResultCode.NOT_SERIAL_MODE),
        BoardElsewhere(ErrorCode.OTHER_NUMBER, "port", "TReX 1.2", 9, 7, SETTINGS),
    ],
    ids=lambda error: type(error).__name__,
)
def test_error_keeps_its_type_and_text(error: StudioError) -> None:
    _, outcome = codec.decode_report(
        codec.with_header(codec.encode_report(Outcome(1, error=error))), 0
    )
    assert isinstance(outcome, Outcome)
    assert str(outcome.error) == str(error)
    kind = TrexNoReplyError if isinstance(error, BoardElsewhere) else type(error)
    assert type(outcome.error).__name__ == kind.__name__


@pytest.mark.parametrize(
    "body",
    [
        {"_type": "Exec", "code": "x"},
        {"_type": "Stop", "id": "1"},
        {"_type": "Stop", "id": 1, "more": 2},
        {"_type": "SetMotor", "motor": 1, "drive": 5, "accelerate": False},
        {"_type": "Arm", "selection": True},
        {"_type": "ToBoard", "number": 9, "request": {"_type": "TakeLease"}},
        [],
        None,
    ],
)
def test_message_of_another_structure_is_rejected(body: object) -> None:
    with pytest.raises(BadRequest):
        codec.decode_request(msgpack.encode([1, 2.0, 3.0, body]), 3)


@pytest.mark.parametrize(
    "event", [["1.5", "SENT", b"", ""], [1.5, "SENT", 5, ""], [1.5, "SENT", b"", 5]]
)
def test_traffic_of_other_types_is_rejected(event: list[object]) -> None:
    with pytest.raises(BadRequest):
        codec.decode_report(msgpack.encode([{"_type": "Traffic", "events": [event]}]), 0)


@pytest.mark.parametrize("head", [[1, 2.0], [1, 2.0, float("nan")], [1, 2.0, "3"], [1, 2.0, True]])
def test_header_without_finite_numbers_is_rejected(head: list[object]) -> None:
    with pytest.raises(BadRequest):
        codec.decode_request(msgpack.encode([*head, {"_type": "Arm", "selection": 0}]), 3)


def test_corrupted_message_raises_only_bad_request() -> None:
    chance = random.Random(1)
    for _ in range(3000):
        data = bytearray(codec.encode_request(chance.choice(REQUESTS), 1, 2.0, 3.0))
        for _ in range(chance.randint(1, 4)):
            data[chance.randrange(len(data))] = chance.randrange(256)
        try:
            codec.decode_request(bytes(data), 3)
        except BadRequest:
            continue
    with pytest.raises(BadRequest):
        codec.decode_request(b"\x91" * 5000, 3)
