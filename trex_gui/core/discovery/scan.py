"""Looking on one port for a device of any kind: one order, in the window and at the command line.

The port is opened once, for some adapters reset the board behind them each time. Then comes, and
each step only where nothing was found before it:

1. listening, at the rate at which boards say that they start: harmless, and it costs 0.3 s that
   a search would listen anyway;
2. the probable questions of each kind, the kinds as they are given, the commonest first: most
   boards answer within two seconds, and no kind waits for another one's long search;
3. what is left of each kind, in the same order: half a minute, for few boards.

A kind that the port is known to lead to goes first in 2 and in 3. What any kind asks moves no
device of any other, in whatever order: tests/aracna/link/test_searching_for_both.py goes through
all of them.
"""

import contextlib
import logging
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from trex_gui.core.discovery.flush import FLUSH_LINE, flush
from trex_gui.core.discovery.prober import (
    Diagnosis,
    Evidence,
    FoundDevice,
    Prober,
    ProberInfo,
    ScanProgress,
    ignore_step,
    never_cancelled,
)
from trex_gui.core.errors import BadRequest, PortUnavailable, StudioError
from trex_gui.core.transport.serial_port import SerialTransport, Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat

log = logging.getLogger(__name__)

_LISTEN = 0.3
"""Seconds to listen for something that talks by itself."""

_KEPT = 48
"""Bytes of it that are kept, to show them."""


@dataclass(slots=True)
class PortScan:
    """What a search of one port has come to.

    Attributes:
        device: the key of the kind that was found; empty where none was.
        found: the devices, all of that kind.
        verdicts: what was heard where none was found, the most telling first.
        error: the port could not be opened, went away, or cannot do what a search needs.
        cancelled: whether it ended early because it was asked to.
        is_fault: whether a fault of the program ended it: then `error` says so.
    """

    device: str = ""
    found: Sequence[FoundDevice] = ()
    diagnoses: list[Diagnosis] = field(default_factory=list)
    error: StudioError | None = None
    cancelled: bool = False
    is_fault: bool = False

    @property
    def lines(self) -> list[str]:
        """Why nothing was found, for people: a paragraph each."""
        first = [str(self.error)] if self.error is not None else []
        return first + [diagnosis.text for diagnosis in self.diagnoses]


def listen(wire: Transport) -> bytes:
    """Return what comes without being asked.

    Raises:
        PortUnavailable: the line is gone.
    """
    return wire.read(_KEPT, _LISTEN)


def scan_port(
    settings: PortSettings,
    seeks: Mapping[str, ProberInfo],
    *,
    first: str | None = None,
    full: bool = False,
    progress: Callable[[ScanProgress], None] = ignore_step,
    cancelled: Callable[[], bool] = never_cancelled,
    open_wire: Callable[[PortSettings], Transport] = SerialTransport,
) -> PortScan:
    """Look for devices of every kind on a port; end with the first that answers.

    Never raises: whatever goes wrong on one port, the next can still be searched.

    Args:
        settings: the port, and how patient to be; line and framing do not matter.
        seeks: how to look for each kind, by its key, the commonest first.
        first: the key of the kind that the port is known to lead to.
        full: try everything that can be tried, whatever time it takes.
        progress: called before each question.
        cancelled: asked before each question whether to end.
        open_wire: opens the port.
    """
    result = PortScan()
    try:
        _search(
            result,
            settings,
            seeks,
            first=first,
            full=full,
            progress=progress,
            cancelled=cancelled,
            open_wire=open_wire,
        )
    except Exception as error:
        log.exception("the search of %s", settings.url)
        text = f"The search of {settings.label} was ended by a fault of the program"
        result = PortScan(error=StudioError(f"{text} ({type(error).__name__}: {error})."))
        result.is_fault = True
    return result


def _search(
    result: PortScan,
    settings: PortSettings,
    seeks: Mapping[str, ProberInfo],
    *,
    first: str | None,
    full: bool,
    progress: Callable[[ScanProgress], None],
    cancelled: Callable[[], bool],
    open_wire: Callable[[PortSettings], Transport],
) -> None:
    """Fill in what `scan_port` returns."""
    opened = next((seek.announces_at for seek in seeks.values() if seek.announces_at), FLUSH_LINE)
    try:
        wire = open_wire(settings.at(opened))
    except PortUnavailable as error:
        result.error = error
        return
    seekers: dict[str, Prober] = {}
    names = {key: seek.name for key, seek in seeks.items()}
    asked = list(seeks)
    try:
        for key, seek in seeks.items():
            seekers[key] = seek.begin(settings, full=full, known=key == first)
        if heard := listen(wire):
            for seeker in seekers.values():
                seeker.note_unsolicited(opened, heard)
        asked = probe_in_order(
            wire, seekers, names, first=first, progress=progress, cancelled=cancelled
        )
    except StudioError as error:
        result.error = error
    finally:
        result.device = next((key for key, seeker in seekers.items() if seeker.found), "")
        _give_back(wire, settings.timeouts.extra, answered=bool(result.device))
    if result.device:
        result.found = seekers[result.device].found
        return
    result.cancelled = result.error is None and cancelled()
    diagnoses = [seekers[key].diagnosis() for key in asked if key in seekers]
    if result.error is not None:  # a search that was cut short says nothing by its silence
        diagnoses = [one for one in diagnoses if one.telling > Evidence.SILENCE]
    result.diagnoses = sorted(diagnoses, key=lambda diagnosis: -diagnosis.telling)


def probe_in_order(
    wire: Transport,
    seekers: Mapping[str, Prober],
    names: Mapping[str, str],
    *,
    first: str | None = None,
    progress: Callable[[ScanProgress], None],
    cancelled: Callable[[], bool],
) -> list[str]:
    """Put the questions of each kind until one is over; return the keys of those asked for.

    Raises:
        PortUnavailable: the line is gone.
    """
    plan = order({key: seeker.parts for key, seeker in seekers.items()}, first)
    totals = [seekers[key].parts[part] for key, part in plan]
    asked: dict[str, None] = {}
    for index, (key, part) in enumerate(plan):
        before = sum(totals[:index])

        def tell(
            step: ScanProgress, key: str = key, index: int = index, before: int = before
        ) -> None:
            totals[index] = step.total
            total = sum(totals)
            progress(replace(step, done=before + step.done, total=total, kind=names[key]))

        asked[key] = None
        seekers[key].ask(wire, part, tell, cancelled)
        if seekers[key].is_over or cancelled():
            break
    return list(asked)


def order(parts: Mapping[str, Sequence[int]], first: str | None) -> list[tuple[str, int]]:
    """Return which part of which kind to ask for, one after the other; see above for why."""
    keys = sorted(parts, key=lambda key: key != first)
    most = max((len(each) for each in parts.values()), default=0)
    return [(key, number) for number in range(most) for key in keys if number < len(parts[key])]


def _give_back(wire: Transport, patience: float, *, answered: bool) -> None:
    """Close the port: neither in the middle of what some board has begun to hear, nor at 1200 baud.

    Some boards with USB start their loader when a port is closed at that rate.
    """
    try:
        with contextlib.suppress(BadRequest, PortUnavailable):
            if not answered and wire.is_configurable:
                flush(wire, patience)
            wire.reconfigure(SerialFormat())
    finally:
        wire.close()
