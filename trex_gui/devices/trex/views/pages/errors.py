"""Page of reported errors and connection quality."""

from collections.abc import Sequence
from datetime import datetime

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.board.errors import UNSEEN, ErrorEntry, error_names
from trex_gui.devices.trex.board.quality import quality_text
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.flags import UartError, stops_motors
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.ui.diagnostics.problems import Problem, ProblemsPage, Reading
from trex_gui.ui.help.messages import message_topic
from trex_gui.ui.playback.transport import time_text
from trex_gui.ui.runtime import now
from trex_gui.ui.widgets import builders as ui


class ErrorsPage(ProblemsPage):
    def __init__(self, device: Device, parent: QWidget) -> None:
        self._device = device
        super().__init__("errors", device.connection.traffic, parent)
        tip = tr("Reset all counts and error times")
        title, reset = tr("Reset all co&unts"), device.board.errors.reset
        self._reset = ui.button(self, "resetCountsButton", title, tip=tip, on_click=reset)
        self.note_row.addWidget(self._reset)
        device.errors_changed.connect(self.show_problems)
        for changed in (device.link_changed, device.state_changed, device.telemetry.text_due):
            changed.connect(self.refresh)

    def problems(self) -> Sequence[Problem]:
        return [self._problem_of(entry) for entry in self._device.board.errors.occurred]

    def clear(self, key: str) -> None:
        bits = {entry.bit.name: entry.bit for entry in UNSEEN}
        self._device.board.errors.clear(bits[key])

    @Slot()
    def show_problems(self) -> None:
        super().show_problems()
        self._reset.setEnabled(bool(self._device.board.errors.occurred))

    def since(self) -> datetime | None:
        opened = self._device.board.connected_utc if self._device.is_connected else None
        return None if opened is None else opened.astimezone()

    def readings(self) -> Sequence[Reading]:
        board, opened = self._device.board, self._device.board.connected_at
        counters, quality = board.counters, board.quality
        is_open = self._device.is_connected and opened is not None
        is_known = is_open and quality.is_noisy is not None
        requests_text = tr("Requests: {0}. Requests without a reply: {1}.")
        returns_text = tr(
            "A restart is detected if the board comes back in another mode, because its "
            "power was off in the meantime. A restart in the same mode is not detected. "
            "Returns after silence: {0}."
        )
        details = requests_text.format(counters.requests, counters.missing)
        readings = (
            Reading(
                # A measurement takes at least 10 s.
                tr("Answered, last {0:.0f} s").format(quality.seconds or 10),
                f"{Number(100 * (1 - quality.lost)):.1f} %" if is_known else "–",
                f"{quality_text(quality)}\n{details}",
                is_bad=bool(quality.is_noisy),
            ),
            Reading(tr("Reads per second"), f"{quality.rate:.0f}" if quality.rate else "–"),
            Reading(tr("Slowest reply"), f"{1000 * counters.slowest:.0f} ms"),
            Reading(tr("Connected for"), time_text(now() - (opened or now()))),
            Reading(
                tr("Restarts detected"), str(board.restarts), returns_text.format(board.returns)
            ),
            Reading(tr("Corrupted replies"), str(counters.corrupted)),
        )
        return readings if is_open else [reading.unknown() for reading in readings]

    def _problem_of(self, entry: ErrorEntry) -> Problem:
        device, bit = self._device, entry.bit
        is_active = device.is_connected and device.board.errors.is_active(entry, now())
        errors_stop = device.parameters.values.stored.get(ParameterKey.UART_ERROR_SHUTDOWN) == 1
        title = error_names([entry])
        if is_active and stops_motors(bit, errors_stop=errors_stop):
            title = tr("{0}, active now, stops the motors").format(title)
        elif is_active:
            title = tr("{0}, active now").format(title)
        elif device.is_connected and entry.count:
            title = tr("{0}, no longer active").format(title)
        texts = [tr(entry.meaning)]
        if entry.count:
            texts.append(tr(entry.remedy))
        if entry.is_doubtful:
            texts.append(
                tr(
                    "The line is noisy and has no CRC, so a corrupted reply can look "
                    "like this error."
                )
            )
        times = ""
        if entry.last is not None:
            times = self.times_text(entry.count, entry.last)
        elif entry.is_earlier:
            times = tr("Latched before connecting, perhaps by a search for the board; not counted.")
        return Problem(
            str(bit.name),
            title,
            " ".join(texts),
            times,
            is_active=is_active,
            is_cleared=not entry.is_uncleared,
            page="transcript" if isinstance(bit, UartError) else "currents",
            topic=message_topic(entry.name),
            name=tr(entry.name),
            seen_at=entry.seen_at,
        )
