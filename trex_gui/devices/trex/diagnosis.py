"""Diagnosis of a line on which no TReX replies.

After a failed connection, the program sends probes at the settings in use, with every other kind of
error detection, and at the factory settings. No probe moves a motor. The replies reveal a board at
other settings, a boot loader, or a qik. A board in learning mode stays silent, because a jumper
connects its transmit line (SO) to ground.
"""

import contextlib
from collections.abc import Callable
from dataclasses import replace

from trex_gui.core.discovery.prober import ScanProgress, flush, ignore_step, never_cancelled
from trex_gui.core.errors import BadReply, BadRequest, NoReply, StudioError
from trex_gui.core.translation import tr
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.discovery import FoundBoard, TrexProber, attempts
from trex_gui.devices.trex.probe import Attempt
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import (
    BoardElsewhere,
    ErrorCode,
    TrexBadReplyError,
    TrexNoReplyError,
    readings_differ,
)
from trex_gui.devices.trex.protocol.framing import DEFAULT_POLYNOMIAL
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings


def explain(settings: ConnectionSettings, *, echo: bool, error: StudioError) -> StudioError:
    """Return the error to report after a query failed with `error`."""
    line_text = settings.text()
    if readings_differ(error):
        return error
    if isinstance(error, BadReply):
        return TrexBadReplyError(ErrorCode.OTHER_DEVICE, line_text, error)
    if not isinstance(error, NoReply):
        return error
    if echo:
        return TrexNoReplyError(ErrorCode.ECHO_ONLY, line_text)
    if settings.device_number is not None:
        line_text += ", " + tr("device number {0}").format(settings.device_number)
    return TrexNoReplyError(ErrorCode.NO_BOARD, line_text)


def diagnose(
    client: TrexClient,
    error: StudioError,
    *,
    quick: bool = False,
    progress: Callable[[ScanProgress], None] = ignore_step,
    cancelled: Callable[[], bool] = never_cancelled,
) -> StudioError:
    """Probe the line, and return the error to report.

    This takes one second on a silent local line. With CRC, the probes with other polynomials take
    seven seconds. `quick` skips them. The line settings are restored at the end.
    """
    settings, wire = client.settings, client.transport
    explanation = explain(settings, echo=client.echo, error=error)
    can_probe = not settings.reserved and isinstance(error, NoReply | BadReply)
    if readings_differ(error) or not can_probe:
        return explanation
    client.drain()
    prober = TrexProber(settings, plans=_plans(settings, quick=quick))
    try:
        for part in range(len(prober.parts)):
            prober.probe(wire, part, progress, cancelled)
            if prober.is_over or cancelled():
                break
    finally:
        with contextlib.suppress(BadRequest):
            flush(wire, settings.timeouts.extra)
            wire.reconfigure(settings.line)
    if prober.found:
        return _found_error(settings, prober.found[0])
    return prober.recognized or explanation


def _plans(settings: ConnectionSettings, *, quick: bool) -> list[list[Attempt]]:
    """Return the likely probes, as the first plan.

    With CRC, a second plan contains the other polynomials, unless `quick` is True.
    """
    line = settings.line
    likely = [
        Attempt.at(settings),
        *(
            Attempt(replace(line, detection=detection))
            for detection in (Detection.NONE, Detection.EVEN, Detection.ODD)
        ),
        Attempt(replace(line, detection=Detection.CRC7), (DEFAULT_POLYNOMIAL,)),
        Attempt(LineSettings()),
    ]
    plans = [list(dict.fromkeys(likely))]
    if line.has_crc and not quick:
        all_probes = attempts(full=True)
        plans.append([probe for probe in all_probes if probe.line == line and probe not in likely])
    return [[probe for probe in plan if not probe.is_unsafe] for plan in plans]


def _found_error(settings: ConnectionSettings, board: FoundBoard) -> StudioError:
    used, actual = settings.line, board.settings.line
    number = settings.device_number
    names = settings.label, board.name
    if (actual.baud, actual.detection) != (used.baud, used.detection):
        code, texts = ErrorCode.OTHER_LINE, (actual.short, used.short)
    elif actual.has_crc and board.settings.polynomial != settings.polynomial:
        polynomials = f"{board.settings.polynomial:02X}", f"{settings.polynomial:02X}"
        code, texts = ErrorCode.OTHER_POLYNOMIAL, polynomials
    elif number is not None and board.device_number != number:
        code, texts = ErrorCode.OTHER_NUMBER, (str(board.device_number), str(number))
    else:
        return TrexNoReplyError(ErrorCode.REPLIES_LOST, *names)
    return BoardElsewhere(code, *names, *texts, board.settings)
