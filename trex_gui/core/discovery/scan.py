"""Scan of one port for devices of any kind, in the window and on the command line.

The port is opened once, because some adapters reset their board each time. If a device was found
on the port earlier, its settings are probed first. Each step follows only if the previous steps
found nothing:

1. listening at the baud rate at which boards announce that they start: harmless, and a scan would
   listen for these 0.3 s anyway;
2. the likely probes of each kind, in the given order, the most common kind first: most boards
   respond within two seconds, and no kind waits for the long scan of another;
3. the other probes of each kind, in the same order: half a minute, for few boards;
4. the likely probes again, for a kind whose only reply may have been lost.

A kind that the port is known to have goes first in steps 2 to 4. The probes of one kind move no
device of another kind, in any order: tests/devices/aracna/session/test_discovery.py checks all.
"""

import contextlib
import logging
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from trex_gui.core.discovery.prober import (
    FLUSH_LINE,
    Diagnosis,
    Evidence,
    FoundDevice,
    Prober,
    ProberInfo,
    ScanProgress,
    flush,
    ignore_step,
    never_cancelled,
)
from trex_gui.core.errors import BadRequest, PortUnavailable, StudioError
from trex_gui.core.translation import tr
from trex_gui.core.transport.serial_port import SerialTransport, Transport
from trex_gui.core.transport.settings import SHARED, PortSettings, SerialFormat

log = logging.getLogger(__name__)

_LISTEN = 0.3  # seconds
_KEPT = 48  # unsolicited bytes that are kept for the diagnosis


@dataclass(slots=True)
class PortScan:
    device: str = ""  # key of the found kind; empty if nothing was found
    found: Sequence[FoundDevice] = ()  # the devices, all of that kind
    diagnoses: list[Diagnosis] = field(default_factory=list)  # strongest evidence first
    error: StudioError | None = None
    cancelled: bool = False

    @property
    def lines(self) -> list[str]:
        first = [str(self.error)] if self.error is not None else []
        return first + [diagnosis.text for diagnosis in self.diagnoses]


def scan_port(
    settings: PortSettings,
    probers: Mapping[str, ProberInfo],
    *,
    first: str | None = None,
    packed: str = "",
    only_recall: bool = False,
    full: bool = False,
    progress: Callable[[ScanProgress], None] = ignore_step,
    cancelled: Callable[[], bool] = never_cancelled,
    open_wire: Callable[[PortSettings], Transport] = SerialTransport,
) -> PortScan:
    """Search a port for devices of every kind, until one kind responds.

    Never raises, so that a failure on one port does not stop the scan of the next port. The line
    settings of `settings` are ignored. `probers` are by key of the kind, the most common first.
    `first` is the known kind of the port, found there with the `packed` settings. `only_recall`
    probes nothing else. `progress` and `cancelled` are called before each probe.
    """
    result = PortScan()
    opened = next((info.announces_at for info in probers.values() if info.announces_at), FLUSH_LINE)
    running: dict[str, Prober] = {}
    probed = list(probers)
    is_shared = SHARED in packed
    try:
        wire = open_wire(settings.at(opened))
        try:
            known = probers.get(first or "") if packed and (is_shared or not full) else None
            found = known.recall(wire, settings, packed) if known and known.recall else None
            if found is not None:
                result.device, result.found = first or "", (found,)
            if found is not None or only_recall or is_shared:
                return result
            for key, info in probers.items():
                running[key] = info.begin(settings, full=full, known=key == first)
            if heard := wire.read(_KEPT, _LISTEN):
                for prober in running.values():
                    prober.record_unsolicited(opened, heard)
            probed = _probe_in_order(
                wire, running, probers, first=first, progress=progress, cancelled=cancelled
            )
        except StudioError as error:
            result.error = error
        finally:
            for key in [key for key, prober in running.items() if prober.found]:
                result.device, result.found = key, running[key].found
            _release(wire, settings.timeouts.extra, answered=is_shared or bool(result.found))
        if result.found:
            return result
        result.cancelled = result.error is None and cancelled()
        diagnoses = [running[key].diagnosis() for key in probed if key in running]
    except PortUnavailable as error:
        return PortScan(error=error)
    except Exception as error:
        log.exception("scan of %s", settings.url)
        cause = f"{type(error).__name__}: {error}"
        text = tr("Internal error while searching {0} ({1}).").format(settings.label, cause)
        return PortScan(error=StudioError(text))
    if result.error is not None:  # silence during an incomplete search is no evidence
        diagnoses = [one for one in diagnoses if one.evidence > Evidence.SILENCE]
    result.diagnoses = sorted(diagnoses, key=lambda diagnosis: -diagnosis.evidence)
    return result


def _probe_in_order(
    wire: Transport,
    running: Mapping[str, Prober],
    probers: Mapping[str, ProberInfo],
    *,
    first: str | None,
    progress: Callable[[ScanProgress], None],
    cancelled: Callable[[], bool],
) -> list[str]:
    """Send the probes of each kind until one prober is over. Return the keys of probed kinds."""
    plan = order({key: prober.parts for key, prober in running.items()}, first)
    totals = [running[key].parts[part] for key, part in plan]
    probed: dict[str, None] = {}
    for index, (key, part) in enumerate(plan):
        before = sum(totals[:index])

        def report(
            step: ScanProgress, key: str = key, index: int = index, before: int = before
        ) -> None:
            totals[index] = step.total
            total = sum(totals)
            progress(replace(step, done=before + step.done, total=total, kind=probers[key].name))

        probed[key] = None
        running[key].probe(wire, part, report, cancelled)
        if running[key].is_over or cancelled():
            break
    return list(probed)


def order(parts: Mapping[str, Sequence[int]], first: str | None) -> list[tuple[str, int]]:
    """Return the parts of each kind in the order of the scan."""
    keys = sorted(parts, key=lambda key: key != first)
    most = max((len(each) for each in parts.values()), default=0)
    return [(key, number) for number in range(most) for key in keys if number < len(parts[key])]


def _release(wire: Transport, extra: float, *, answered: bool) -> None:
    """Close the port, but not at 1200 baud. End packets that boards have begun.

    Some USB boards start their boot loader when a port is closed at 1200 baud.
    """
    try:
        with contextlib.suppress(BadRequest, PortUnavailable):
            if not answered and wire.is_configurable:
                flush(wire, extra)
            wire.reconfigure(SerialFormat())
    finally:
        wire.close()
