"""Messages between server and clients, and their encoding.

A message contains the name of its type and its fields, encoded as MessagePack. The decoder checks
the type of each field. It accepts only message types that are listed in this module.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import IntEnum, StrEnum
from functools import cache
from typing import Any, get_args

import cattrs
from cattrs.preconf.msgspec import make_converter
from cattrs.strategies import configure_tagged_union, include_subclasses
from msgspec import msgpack

from trex_gui.core.errors import (
    BadReply,
    BadRequest,
    CodedError,
    InternalError,
    NoReply,
    PortShared,
    PortUnavailable,
    StudioError,
)
from trex_gui.core.session import Outcome
from trex_gui.core.transport.traffic import TrafficDirection, TrafficEvent
from trex_gui.devices.trex.client.telemetry import Sample
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.device_table import Model, device_table
from trex_gui.devices.trex.protocol.errors import (
    ErrorCode,
    OtherBoard,
    Rejected,
    ResultCode,
    Skipped,
    TrexBadReplyError,
    TrexError,
    TrexInternalError,
    TrexNoReplyError,
    TrexRequestError,
)
from trex_gui.devices.trex.protocol.flags import Mode, Status, UartError, seven_bits
from trex_gui.devices.trex.protocol.framing import Malformed
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.protocol.raw_packets import RawPacket
from trex_gui.devices.trex.session.messages import (
    BoardReport,
    BoardRequest,
    ProbeProgress,
    ReadReason,
    ToBoard,
    Written,
)
from trex_gui.devices.trex.session.messages import Report as SessionReport
from trex_gui.devices.trex.session.messages import Request as SessionRequest

VERSION = 1  # of the messages; a server refuses clients with another version


@dataclass(frozen=True, slots=True)
class Hello:
    """First message of a client."""

    version: int
    program: str  # name and version, for the log


@dataclass(frozen=True, slots=True)
class Alive:
    """Periodic message of a running client."""


@dataclass(frozen=True, slots=True)
class Leave:
    """Last message of a client."""


@dataclass(frozen=True, slots=True)
class Welcome:
    """First message to an accepted client. The newest reports of the session follow."""

    name: str  # name of the served board


@dataclass(frozen=True, slots=True)
class Tick:
    """Periodic message of a running server."""


@dataclass(frozen=True, slots=True)
class Refused:
    """Last message to a client that the server refuses or drops."""

    reason: str


ClientRequest = Hello | Alive | Leave
ServerReport = Welcome | Tick | Refused

MAX_REQUEST_SIZE = 8192  # bytes; a `Write` of all settings and their previous values needs 3000

Request = SessionRequest | ClientRequest
Report = SessionReport | ServerReport
_REQUESTS: Any = Request
_REPORTS: Any = Report | ProbeProgress

_TO_BOARD: Any = BoardRequest  # requests inside a `ToBoard`
_OF_BOARD: Any = BoardReport  # reports inside an `OfBoard`

_VALUES: Any = Written | Signature  # values of an `Outcome`, besides bytes and `None`

_ERRORS: dict[str, type[Any]] = {
    kind.__name__: kind
    for kind in (
        StudioError,
        BadReply,
        BadRequest,
        InternalError,
        NoReply,
        PortShared,
        PortUnavailable,
        OtherBoard,
        Rejected,
        Skipped,
        TrexBadReplyError,
        TrexError,
        TrexInternalError,
        TrexNoReplyError,
        TrexRequestError,
    )
}


def inner_request(request: Request) -> Request:
    return request.request if isinstance(request, ToBoard) else request


def encode_request(request: Request, *header: float) -> bytes:
    return msgpack.encode([*header, _codec().unstructure(request, _REQUESTS)])


def decode_request(data: bytes, header_size: int) -> tuple[tuple[float, ...], Request]:
    """Return the numbers in the header, and the request.

    Raises:
        BadRequest: the bytes are not a request.
    """
    return _decode(data, header_size, _REQUESTS)


def encode_report(report: Report) -> Any:
    """Return the report as plain data, to which `with_header` adds a header."""
    return _codec().unstructure(report, _REPORTS)


def with_header(report: Any, *header: float) -> bytes:
    return msgpack.encode([*header, report])


def decode_report(data: bytes, header_size: int) -> tuple[tuple[float, ...], Report]:
    """Return the numbers in the header, and the report.

    Raises:
        BadRequest: the bytes are not a report.
    """
    return _decode(data, header_size, _REPORTS)


def _decode(data: bytes, header_size: int, union: Any) -> tuple[tuple[float, ...], Any]:
    try:
        *header, body = msgpack.decode(data)
        return _check_header(header, header_size), _codec().structure(body, union)
    except Exception as error:
        raise BadRequest(f"invalid message: {error!r:.200}") from error


def _check_header(header: list[Any], size: int) -> tuple[float, ...]:
    is_number = [type(value) in {int, float} and math.isfinite(value) for value in header]
    if len(header) != size or not all(is_number):
        raise ValueError(f"the header must be {size} numbers")
    return tuple(header)


@cache
def _codec() -> cattrs.Converter:
    codec = make_converter(forbid_extra_keys=True, detailed_validation=False)
    for kind in (int, float, str, bytes, bool):
        codec.register_structure_hook(kind, _strict(kind))
    # Instead of the `int` and `str` hooks
    for base, plain in ((IntEnum, int), (StrEnum, str), (Status, int), (UartError, int)):
        codec.register_structure_hook(base, _member_hook(plain))
    for enum in (ErrorCode, ReadReason, Mode):
        codec.register_unstructure_hook(enum, lambda member: member.name)
        codec.register_structure_hook(enum, lambda name, kind: kind[name])
    codec.register_unstructure_hook(Model, lambda model: model.key)
    codec.register_structure_hook(Model, lambda key, _: device_table().model(key))
    codec.register_unstructure_hook(LineSettings, lambda line: line.to_wire())
    codec.register_structure_hook(LineSettings, lambda wire, _: LineSettings.from_wire(wire))
    codec.register_unstructure_hook(
        ConnectionSettings, lambda value: [value.url, value.name, value.packed, *value.group]
    )
    codec.register_structure_hook(ConnectionSettings, lambda parts, _: _decode_settings(*parts))
    codec.register_unstructure_hook(
        TrafficEvent, lambda event: [event.time, event.direction.name, event.data, event.text]
    )
    codec.register_structure_hook(TrafficEvent, lambda parts, _: _decode_traffic_event(*parts))
    codec.register_unstructure_hook(RawPacket, lambda raw: raw.packet.raw)
    codec.register_structure_hook(
        RawPacket, lambda raw, _: RawPacket(Malformed(_strict(bytes)(raw, bytes), ""))
    )
    for error in (StudioError, StudioError | None):
        codec.register_unstructure_hook(error, _encode_error)
        codec.register_structure_hook(error, lambda data, _: _decode_error(data))
    codec.register_unstructure_hook(Outcome, lambda outcome: _encode_outcome(outcome, codec))
    codec.register_structure_hook(Outcome, lambda data, _: _decode_outcome(data, codec))
    include_subclasses(Sample, codec, union_strategy=configure_tagged_union)
    for union in (_VALUES, _OF_BOARD, _TO_BOARD, _REQUESTS, _REPORTS):
        configure_tagged_union(union, codec)
    return codec


def _strict(kind: type) -> Callable[[Any, Any], Any]:
    """Return a hook that accepts only values of type `kind`. An `int` is a valid `float`."""

    def check(value: Any, _kind: Any) -> Any:
        if type(value) is kind or (kind is float and type(value) is int):
            return value
        raise ValueError(f"expected {kind.__name__}, not {value!r:.40}")

    return check


def _member_hook(plain: type) -> Callable[[Any, Any], Any]:
    return lambda value, kind: kind(_strict(plain)(value, plain))


def _decode_traffic_event(time: Any, direction: str, data: Any, text: Any) -> TrafficEvent:
    values = zip((time, data, text), (float, bytes, str), strict=True)
    time, data, text = (_strict(kind)(value, kind) for value, kind in values)
    return TrafficEvent(time, TrafficDirection[direction], data, text)


def _decode_settings(*parts: Any) -> ConnectionSettings:
    url, name, packed = (_strict(str)(text, str) for text in parts[:3])
    numbers = tuple(seven_bits(_strict(int)(number, int), "device number") for number in parts[3:])
    return replace(ConnectionSettings(url, name=name).unpacked(packed), group=numbers)


_FIELD = str | int | float


def _encode_error(error: StudioError | None) -> Any:
    if error is None:
        return None
    kind = next(cls.__name__ for cls in type(error).__mro__ if cls.__name__ in _ERRORS)
    if not isinstance(error, CodedError):
        return [kind, "", str(error)]
    code = error.result.name if isinstance(error, Rejected) else error.code.name
    return [kind, code, *map(_encode_field, error.fields)]


def _encode_field(field: object) -> _FIELD:
    if isinstance(field, int | float):
        return field
    return " ".join(map(str, field)) if isinstance(field, tuple) else str(field)


def _decode_error(data: Any) -> StudioError | None:
    match data:
        case None:
            return None
        case ["Rejected", str(result), str(name)]:
            return Rejected(name, ResultCode[result])
        case [str(kind), str(code), *fields] if all(isinstance(field, _FIELD) for field in fields):
            arguments = [ErrorCode[code], *fields] if code else fields
            error: StudioError = _ERRORS[kind](*arguments)
            return error
    raise ValueError("invalid error")


def _encode_outcome(outcome: Outcome, codec: cattrs.Converter) -> Any:
    value: Any = outcome.value
    if isinstance(value, get_args(_VALUES)):
        value = codec.unstructure(value, _VALUES)
    return {"id": outcome.id, "value": value, "error": _encode_error(outcome.error)}


def _decode_outcome(data: Any, codec: cattrs.Converter) -> Outcome:
    number, value, error = (data[key] for key in ("id", "value", "error"))
    if isinstance(value, dict):
        value = codec.structure(value, _VALUES)
    elif not (value is None or isinstance(value, bytes)):
        raise ValueError("invalid value of an outcome")
    return Outcome(_strict(int)(number, int), value, _decode_error(error))
