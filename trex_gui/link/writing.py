"""Writes to EEPROM that count only when they have been read back equal.

Plain functions over a `Requester`, so the command line, the session and tests share them.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from trex_gui.link.client import Requester
from trex_gui.link.reading import ATTEMPTS, Progress, ask, no_progress
from trex_gui.protocol.calibration import Calibration
from trex_gui.protocol.commands import (
    GetCalibration,
    GetParameter,
    SetCalibration,
    SetParameter,
)
from trex_gui.protocol.errors import (
    BadReply,
    BadRequest,
    NoReply,
    PortUnavailable,
    Rejected,
    ResultCode,
    TrexError,
)
from trex_gui.protocol.parameters import ParameterSet, ParameterSpec

_FAILURES = (BadRequest, Rejected, BadReply, NoReply, PortUnavailable)


@dataclass(frozen=True, slots=True)
class Written:
    """How one write went: `stored` is the value that was read back, `error` why not.

    `what` is a parameter's key, or `channel N` for a calibration.
    """

    what: str
    stored: int | Calibration | None = None
    error: TrexError | None = None


def write_parameter(request: Requester, spec: ParameterSpec, wire: int) -> int:
    """Store one parameter and return what was read back: the proof that it is stored.

    A reply that is lost on the way is no failure: only the value read back counts. The
    factory reset cannot be read back; its result code has to do.

    Raises:
        BadRequest: the table does not allow the value; nothing was sent.
        Rejected: the board refused it.
        BadReply: the value read back is another.
        NoReply: the board does not answer.
        PortUnavailable: the line is gone.
    """
    command = SetParameter(spec.number, spec.check(wire))
    if not spec.readable:
        _write(request, spec.name, command, may_fail=False)
        return wire
    stored = wire
    for _ in range(ATTEMPTS):
        _write(request, spec.name, command, may_fail=True)
        # Without CRC the line may have damaged what was read, or what was written: only two
        # equal readings speak against the write, and a write may be repeated.
        stored = ask(request, GetParameter(spec.number))
        if stored == wire or (stored := ask(request, GetParameter(spec.number))) == wire:
            return wire
    message = (
        f"{spec.name} did not stick: wrote {spec.text(wire)}, "
        f"but the board reads back {spec.text(stored)}"
    )
    raise BadReply(message)


def write_calibration(request: Requester, channel: int, wanted: Calibration) -> Calibration:
    """Store one channel's calibration for the source in force; return what was read back.

    Raises:
        BadRequest: minimum, neutral and maximum are not in order; nothing was sent.
        Rejected, BadReply, NoReply, PortUnavailable: as for `write_parameter`.
    """
    what = f"Calibration of channel {channel}"
    stored = wanted
    for _ in range(ATTEMPTS):
        _write(request, what, SetCalibration(channel, wanted), may_fail=True)
        stored = ask(request, GetCalibration(channel))
        if stored == wanted or (stored := ask(request, GetCalibration(channel))) == wanted:
            return wanted
    message = f"{what} did not stick: the board reads back {stored}"
    raise BadReply(message)


def _write(
    request: Requester, what: str, command: SetParameter | SetCalibration, *, may_fail: bool
) -> None:
    for attempt in range(ATTEMPTS):
        try:
            code = request(command)
        except (NoReply, BadReply):
            # The packet or its answer was damaged: writing the same value again is harmless.
            if attempt == ATTEMPTS - 1 and not may_fail:
                raise
            continue
        if code is not ResultCode.OK:
            raise Rejected(what, code)
        return


def write_all(
    request: Requester,
    specs: ParameterSet,
    parameters: Sequence[tuple[str, int]],
    calibrations: Sequence[tuple[int, Calibration]] = (),
    progress: Progress = no_progress,
) -> tuple[Written, ...]:
    """Store calibrations, then parameters by key, and return how each went.

    Parameters that need a power cycle come last and the serial settings after all others, so
    that an interruption leaves the board reachable. Once the line is gone, the board has
    stopped answering or has said that it is not in serial mode, the rest is not tried: it
    would fail alike.
    """
    total = len(parameters) + len(calibrations)
    results: list[Written] = []
    hopeless: TrexError | None = None

    for channel, wanted in calibrations:
        what = f"channel {channel}"
        progress(len(results), total, f"calibration of {what}")
        result = Written(what, error=hopeless)
        if hopeless is None:
            try:
                result = Written(what, write_calibration(request, channel, wanted))
            except _FAILURES as error:
                result = Written(what, error=error)
                hopeless = _if_hopeless(error)
        results.append(result)

    for key, wire in sorted(parameters, key=lambda item: _write_order(specs, item[0])):
        result = Written(key, error=hopeless)
        if hopeless is None:
            try:
                spec = specs[key]
                progress(len(results), total, spec.name)
                result = Written(key, write_parameter(request, spec, wire))
            except _FAILURES as error:
                result = Written(key, error=error)
                hopeless = _if_hopeless(error)
        results.append(result)

    progress(total, total, "done")
    return tuple(results)


def _write_order(specs: ParameterSet, key: str) -> tuple[bool, bool, int]:
    try:
        spec = specs[key]
    except BadRequest:
        return False, False, 0
    return spec.needs_power_cycle, spec.group == "serial", spec.number


def _if_hopeless(error: TrexError) -> TrexError | None:
    """Return the error when every later write would meet it too."""
    if isinstance(error, (NoReply, PortUnavailable)):
        return error
    if isinstance(error, Rejected) and error.code is ResultCode.NOT_SERIAL_MODE:
        return error
    return None
