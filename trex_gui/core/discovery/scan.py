"""Scan of one port for devices of any kind.

The port is opened only once, because some adapters reset their board whenever the port is opened.
The settings of a device found earlier are probed first. Then these steps run until a device is
found:

1. Listen for 0.3 s at the baud rate at which boards send their start-up message. Listening is
   harmless, and the scan would wait for this time anyway.
2. Send the likely probes of each kind in the given order, with the most common kind first. Most
   boards respond within two seconds, and no kind waits for the long scan of another kind.
3. Send the other probes of each kind. They take half a minute, and few boards need them.
4. Repeat the likely probes of a kind whose only reply may have been lost.

If the kind of the device is known, this kind is probed first in steps 2 to 4. The probes of one
kind never move a device of another kind. tests/devices/aracna/session/test_discovery.py checks this
for every order.
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

_LISTEN_S = 0.3
_SAVED_BYTES = 48  # maximum number of unsolicited bytes saved for the diagnosis


@dataclass(slots=True)
class PortScan:
    """Result of a scan."""

    device: str = ""  # key of the kind of device found, or empty
    found: Sequence[FoundDevice] = ()  # all devices found, which are of the kind `device`
    diagnoses: list[Diagnosis] = field(default_factory=list)  # sorted, strongest evidence first
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
    """Search a port until one kind of device responds.

    Never raises, because a failure on one port must not stop the scan of the next port.

    Args:
        settings: the port. Its line settings are ignored.
        probers: key of each kind of device → its prober, with the most common kind first.
        first: key of the kind of device that is known for this port. `None` if unknown.
        packed: settings at which that device was found earlier. Empty if unknown.
        only_recall: probe only at the `packed` settings.
        full: probe all settings.
        progress: called before each probe.
        cancelled: called before each probe. If it returns True, the scan ends.
        open_wire: opens the port.
    """
    result = PortScan()
    initial = next(
        (info.announces_at for info in probers.values() if info.announces_at), FLUSH_LINE
    )
    running: dict[str, Prober] = {}
    probed = list(probers)
    is_shared = SHARED in packed
    try:
        wire = open_wire(settings.at(initial))
        try:
            known = probers.get(first or "") if packed and (is_shared or not full) else None
            found = known.recall(wire, settings, packed) if known and known.recall else None
            if found is not None:
                result.device, result.found = first or "", (found,)
            if found is not None or only_recall or is_shared:
                return result
            for key, info in probers.items():
                running[key] = info.create(settings, full=full, known=key == first)
            if unsolicited := wire.read(_SAVED_BYTES, _LISTEN_S):
                for prober in running.values():
                    prober.record_unsolicited(initial, unsolicited)
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
        log.exception("the scan of %s failed", settings.url)
        cause = f"{type(error).__name__}: {error}"
        text = tr("Internal error while searching {0} ({1}).").format(settings.label, cause)
        return PortScan(error=StudioError(text))
    if result.error is not None:  # silence during an incomplete scan is no evidence
        diagnoses = [item for item in diagnoses if item.evidence > Evidence.SILENCE]
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
    """Run the probers until one of them has identified its device. Return the probed kinds."""
    plan = probe_order({key: prober.parts for key, prober in running.items()}, first)
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


def probe_order(parts: Mapping[str, Sequence[int]], first: str | None) -> list[tuple[str, int]]:
    """Return pairs of kind and part in the order in which they are probed."""
    keys = sorted(parts, key=lambda key: key != first)
    count = max(map(len, parts.values()), default=0)
    return [(key, number) for number in range(count) for key in keys if number < len(parts[key])]


def _release(wire: Transport, extra: float, *, answered: bool) -> None:
    """Terminate incomplete packets, then close the port.

    Some USB boards start their boot loader when the port is closed at 1200 baud. The port is
    therefore set to the default rate first.
    """
    try:
        with contextlib.suppress(BadRequest, PortUnavailable):
            if not answered and wire.is_configurable:
                flush(wire, extra)
            wire.reconfigure(SerialFormat())
    finally:
        wire.close()
