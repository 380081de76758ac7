"""Recording of a board's reports and setpoints."""

from collections import deque
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path

from PySide6.QtCore import QObject, Slot

from trex_gui.core.events import Event, EventKind
from trex_gui.core.recording.automatic import automatic_path, remove_oldest
from trex_gui.core.translation import tr
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.telemetry import ModeSample
from trex_gui.devices.trex.driving.requests import SetMotor, SetpointRequest, setpoints_in
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.recording import (
    FORMAT,
    AuxiliarySetpointRecord,
    BoardSnapshot,
    Header,
    OtherBoardRecord,
    Record,
    SetpointRecord,
    SettingsSnapshot,
    setpoint_record,
    settings_text,
)
from trex_gui.devices.trex.session.messages import Batch, Connected, Report
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.runtime import new_timer, now
from trex_gui.ui.workers.record_thread import RecordThread

_ON_KEY = "recording/keep_events"


class Recorder(RecordThread[Record]):
    """Records the session of a device in a file.

    A recording ends with the connection. It also ends when the board or its input source
    changes, because the header would then be wrong. It continues while the board does not respond.
    """

    _watcher = "recording"  # name for `Connection.watch`

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._board: tuple[object, ...] = ()
        self._settings = ""
        # Board number → unit of its current readings (A per count)
        self._others: dict[int, float] = {}  # other boards of the group
        self._recorded: dict[int, float] = {}  # other boards that the header lists

        device.sampled.connect(self._on_sampled)
        device.connection.member_reported.connect(self._on_other_board)
        device.connection.started.connect(self._others.clear)
        device.events.happened.connect(self.put_event)
        device.motors.requested.connect(self._on_requested)
        device.state_changed.connect(self._on_state_changed)
        device.link_changed.connect(self._on_link_changed)
        self.changed.connect(lambda: device.connection.watch(self._watcher, self.recording))

    @property
    def is_available(self) -> bool:
        return self._device.is_connected and self._device.state is not None

    def start(self, path: Path) -> bool:
        state = self._device.state
        if state is None or not self.can_record:
            return False
        self.start_recording(path, FORMAT, self._header_of(state))
        return True

    def _header_of(self, state: DeviceState) -> Header:
        settings = self._device.settings
        number = settings.device_number if settings is not None else None
        self._recorded = self._others.copy()
        header = Header.of(state, now(), number, self._recorded)
        self._board, self._settings = self._identity(state), header.settings
        return header

    @Slot(object)
    def _on_sampled(self, batch: Batch) -> None:
        self.put(*batch.samples)

    @Slot(int, object)
    def _on_other_board(self, number: int, report: Report) -> None:
        if isinstance(report, Connected):
            self._others.setdefault(number, report.state.signature.model.current_unit)
        elif isinstance(report, Batch) and number in self._recorded:
            self.put(*(OtherBoardRecord(number, sample) for sample in report.samples))

    @Slot(object)
    def _on_requested(self, request: SetpointRequest) -> None:
        time, settings = now(), self._device.settings
        own = None if settings is None else settings.device_number
        for number, routed in self._device.driving.routed(request):
            for setpoint in setpoints_in(routed):
                record = setpoint_record(setpoint, time)
                if number in {None, own}:
                    self.put(record)
                elif number in self._recorded:
                    self.put(OtherBoardRecord(number, record))

    @Slot()
    def _on_state_changed(self) -> None:
        state = self._device.state
        if state is None or not self.recording:
            return
        if self._identity(state) == self._board:
            self._put_settings(state)
        else:
            self.stop_early(tr("Recording {0} ended: the board or its input source has changed."))

    def _identity(self, state: DeviceState) -> tuple[object, ...]:
        return state.signature, state.source, self._device.connection.selection

    def _put_settings(self, state: DeviceState) -> None:
        if (text := settings_text(state)) != self._settings:
            self._settings = text
            self.put(SettingsSnapshot(now(), text))

    @Slot()
    def _on_link_changed(self) -> None:
        if self.recording and self._device.link is ConnectionState.DISCONNECTED:
            self.stop_early(tr("Recording {0} ended because the connection was closed."))
        self.changed.emit()


_BEFORE = 20.0  # s recorded before a fault or stop
_AFTER = 10.0  # s recorded after the last fault or stop
_MAX_LENGTH = 120.0  # s; repeated faults do not extend a file further
_START_DELAY = 0.5  # s; recording must not slow down the stop


class EventRecorder(Recorder):
    """Records each fault and stop in a separate file.

    The last seconds are buffered in memory. Faults, tripped current limits and serial timeouts are
    always recorded. Stops and a lost board are recorded only if this program drove a motor. No
    separate file is written while the user records.
    """

    _watcher = "event recording"

    def __init__(self, device: Device, user: Recorder, parent: QObject | None = None) -> None:
        self._recent = deque[Record]()
        self._template: Header | None = None  # header for the connected board
        self._before: BoardSnapshot | None = None  # state of the board before `_recent`
        self._driven: dict[int, bool] = {}  # motor (0: auxiliary) → true while driven
        self._event: Event | None = None  # cause of the recording
        self._user_recorder = user  # recorder that the user starts
        super().__init__(device, parent)
        self.is_on = Preferences().flag(_ON_KEY, default=True)
        start_ms, end_ms = round(1000 * _START_DELAY), round(1000 * _AFTER)
        self._start_timer = new_timer(self, start_ms, self._on_start_due, single_shot=True)
        self._end_timer = new_timer(self, end_ms, self.stop, single_shot=True)

    def set_on(self, on: bool) -> None:
        self.is_on = on
        Preferences().set(_ON_KEY, on)

    @Slot(int, object)
    def _on_other_board(self, number: int, report: Report) -> None:
        super()._on_other_board(number, report)
        if not self.recording:  # the next header lists every board of the group
            self._recorded = self._others

    @property
    def cause(self) -> str:
        return "" if self._event is None else self._event.text

    def put(self, *records: Record) -> None:
        super().put(*records)
        self._recent.extend(records)
        oldest = self._recent[-1].time - _BEFORE if self._recent else 0.0
        while self._recent and self._recent[0].time < oldest:
            record = self._recent.popleft()
            if self._before is not None:
                self._before.update(record)

    @Slot(object)
    def put_event(self, event: Event) -> None:
        super().put_event(event)
        if self.is_on and self._template is not None and self._is_relevant(event):
            self._save(event)
        if event.kind is EventKind.STOP:
            self._driven.clear()

    def _is_relevant(self, event: Event) -> bool:
        if event.kind in {EventKind.FAULT, EventKind.OVER_LIMIT, EventKind.TIMEOUT}:
            return True
        is_loss = event.kind is EventKind.LINK and event.is_problem
        return (is_loss or event.kind is EventKind.STOP) and any(self._driven.values())

    def _save(self, event: Event) -> None:
        if self._user_recorder.recording:
            return
        if self.recording:
            if self.seconds < _MAX_LENGTH:
                self._end_timer.start()
        elif not self._start_timer.isActive():
            self._event = event
            self._start_timer.start()
            self._end_timer.start()

    @Slot()
    def _on_start_due(self) -> None:
        if self._worker is None:
            self._start()
        elif self._end_timer.isActive():  # the last recording is still being written to a slow disk
            self._start_timer.start()

    def _start(self) -> None:
        self._start_timer.stop()
        header, before, event = self._template, self._before, self._event
        if header is None or before is None or event is None:
            return
        start = self._recent[0].time if self._recent else now()
        header = replace(
            header,
            started=datetime.now(UTC) - timedelta(seconds=now() - start),
            clock=start,
            mode=before[ModeSample].mode,
            settings=before.settings,
            others=self._recorded.copy(),
        )
        initial: list[Record] = [
            SetpointRecord(start, motor, drive) for motor, drive in before.setpoints.items()
        ]
        if before.auxiliary is not None:
            initial.append(AuxiliarySetpointRecord(start, before.auxiliary))
        when = datetime.now().astimezone() - timedelta(seconds=now() - event.time)
        path = automatic_path(when, event.kind.value)
        self.start_recording(path, FORMAT, header, (*initial, *self._recent), prepare=remove_oldest)

    @Slot()
    def stop(self) -> None:
        self._start_timer.stop()
        self._end_timer.stop()
        super().stop()

    @Slot(object)
    def _on_requested(self, request: SetpointRequest) -> None:
        super()._on_requested(request)
        for setpoint in setpoints_in(request):
            if isinstance(setpoint, SetMotor):
                drive = setpoint.drive
                self._driven[setpoint.motor] = bool(drive.speed) and not drive.is_brake
            else:
                self._driven[0] = bool(setpoint.speed)

    @Slot()
    def _on_state_changed(self) -> None:
        state = self._device.state
        if state is None:
            return
        if self._template is not None and self._identity(state) == self._board:
            self._put_settings(state)
            return
        self._finish()
        self._template = header = self._header_of(state)
        self._before = BoardSnapshot.at_start(header)

    @Slot()
    def _on_link_changed(self) -> None:
        if self._device.link is ConnectionState.DISCONNECTED:
            self._finish()
        self.changed.emit()

    def _finish(self) -> None:
        if self._start_timer.isActive() and self._worker is None:
            self._start()
        self.stop()
        self._recent.clear()
        self._driven.clear()
        self._template = self._before = None

    def shut_down(self) -> bool:
        self._finish()
        return super().shut_down()
