"""The board as the window sees it: the link to it, and the models that mirror it."""

import logging
from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from enum import Enum, auto

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.link.client import Counters
from trex_gui.link.explain import who_controls
from trex_gui.link.messages import (
    Batch,
    Closed,
    Connected,
    Expect,
    Occasion,
    Outcome,
    Progress,
    Reload,
    Report,
    SetAuxiliary,
    SetDrive,
    Silent,
    Stop,
    Write,
)
from trex_gui.link.next_line import where_to_look
from trex_gui.link.reading import DeviceState
from trex_gui.link.settings import LinkSettings
from trex_gui.link.telemetry import StatusNews
from trex_gui.link.writing import Written
from trex_gui.model.apply import Apply
from trex_gui.model.errors import ErrorLog
from trex_gui.model.line import Line
from trex_gui.model.motors import Motors
from trex_gui.model.parameters import Column
from trex_gui.model.settings_draft import SettingsDraft
from trex_gui.model.telemetry import Telemetry
from trex_gui.protocol.calibration import DEFAULT_CALIBRATION
from trex_gui.protocol.errors import NoReply, TrexError, sentence
from trex_gui.protocol.flags import InputSource, channel_mask, channels_in
from trex_gui.settings.document import Settings
from trex_gui.settings.errors import SettingsError
from trex_gui.settings.factory import factory_settings
from trex_gui.settings.history import History

log = logging.getLogger(__name__)

AfterStop = Callable[[TrexError | None], None]
"""Gets `None` when a stop is proved, else why it is not."""


class Link(Enum):
    """How things stand between the program and a board."""

    NONE = auto()
    OPENING = auto()
    UP = auto()
    SILENT = auto()
    CLOSING = auto()


class Device(QObject):
    """One board, or none.

    Signals:
        link_changed: `link`, `status` or `settings`.
        state_changed: `state` was read anew, or forgotten.
        progressed: steps done, steps in all, what comes next.
        failed: why a connection ended or something asked did not work, for people.
        told: what was done without being asked, for people.
        applied: the `Written` of everything that Apply tried.
        pending_changed: how many edits of parameters and calibrations wait for Apply.

    Attributes:
        draft: what the board stores and the edits of it; `parameters`, `calibrations` and `undo`
            are its parts.
        history: what boards stored before each Apply.
    """

    link_changed = Signal()
    state_changed = Signal()
    progressed = Signal(int, int, str)
    failed = Signal(str)
    told = Signal(str)
    applied = Signal(object)
    pending_changed = Signal(int)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.telemetry = Telemetry(self)
        self.errors = ErrorLog(self)
        self.draft = SettingsDraft(self)
        self.undo = self.draft.undo
        self.parameters = self.draft.parameters
        self.calibrations = self.draft.calibrations
        self.history = History()
        self._apply = Apply(self.draft, self.history, self._ask, self)
        self.motors = Motors(self)
        self._link = Link.NONE
        self._status = self.tr("Not connected.")
        self._settings: LinkSettings | None = None
        self._state: DeviceState | None = None
        self._echo = False
        self._port_rates: frozenset[int] | None = None
        self._ordered_reset: dict[str, int] | None = None
        self._counters = Counters()
        self._may_move = False
        self._next: LinkSettings | None = None
        self._after_stop: list[AfterStop] = []
        self._line = Line(self)

        self._line.reported.connect(self._on_reported)
        self._line.closed.connect(self._on_closed)
        self.motors.requested.connect(self._on_drive_requested)
        self.motors.stop_requested.connect(self._on_stop_requested)
        self.draft.pending_changed.connect(self.pending_changed)
        self.draft.replacing.connect(self._on_replacing)
        self._apply.started.connect(self.link_changed)
        self._apply.finished.connect(self._on_applied)
        self._apply.failed.connect(self._on_apply_failed)

    # --- What is known ------------------------------------------------------------------

    @property
    def link(self) -> Link:
        """How things stand."""
        return self._link

    @property
    def status(self) -> str:
        """How things stand, as a sentence."""
        return self._status

    @property
    def settings(self) -> LinkSettings | None:
        """How the line is, or was last, opened."""
        return self._settings

    @property
    def state(self) -> DeviceState | None:
        """What the board said of itself; `None` while none answers."""
        return self._state

    @property
    def echo(self) -> bool:
        """Whether everything sent comes back: the RS-232 side of the board."""
        return self._echo

    @property
    def port_rates(self) -> frozenset[int] | None:
        """The baud rates that this computer's port can do; `None`: unknown."""
        return self._port_rates

    @property
    def counters(self) -> Counters:
        """What the line has seen since it was opened."""
        return self._counters

    def key_of(self, what: str) -> str:
        """Return the key, as a settings file spells it, of what a `Written` is about."""
        if not what.startswith("channel "):
            return what
        number = what.removeprefix("channel ")
        return f"{self.calibrations.source.value.lower()}_channel_{number}"

    def name_of(self, what: str) -> str:
        """Return the name for people of what a `Written` is about."""
        index = self.parameters.index_of(what, Column.NAME)
        return str(index.data()) if index.isValid() else what

    @property
    def is_joint(self) -> bool:
        """Whether both drivers work as one motor now, whatever is stored for the next start."""
        return self.parameters.active_of("motor_mode") == 1

    @property
    def control_text(self) -> str:
        """Who controls the motors, as a sentence; empty while no board answers."""
        if self._state is None or self._link is not Link.UP:
            return ""
        seen = self.telemetry.serial_controls
        by_serial = self._state.serial_controls if seen is None else seen
        return who_controls(self._state.mode, by_serial, joint=self.is_joint)

    @property
    def reset_ordered(self) -> bool:
        """Whether the board was told to put its parameters back when it starts the next time.

        What is written before that is wiped then.
        """
        return self._ordered_reset is not None

    @property
    def may_move(self) -> bool:
        """Whether motors were driven and no stop was proved since, connected or not."""
        return self._may_move

    @property
    def applying(self) -> bool:
        """Whether edits are being written."""
        return self._apply.running

    # --- What a person does -------------------------------------------------------------

    def connect_to(self, settings: LinkSettings) -> None:
        """Open a line and read everything; ends in `Link.UP` or in `failed`.

        A line that is open is closed first.
        """
        if self._line.is_open:
            self._next = settings
            self.disconnect_line()
            return
        self._settings = settings
        self._counters = Counters()
        self._set_link(Link.OPENING, self.tr("Connecting to {0} …").format(settings.text()))
        self._line.open(settings, may_move=self._may_move)

    def disconnect_line(self) -> None:
        """Stop the motors if they were driven, and close the line; does not wait for it."""
        if self._line.is_open and self._link is not Link.CLOSING:
            self.motors.allow(False)
            self._line.close()
            self._set_link(Link.CLOSING, self.tr("Disconnecting …"))

    def shut_down(self) -> bool:
        """Close the line and wait for it, at most a second; return whether it ended in time.

        For the end of the program only; see `Line.shut_down`.
        """
        self._next = None
        was_open = self._line.is_open
        in_time = self._line.shut_down()
        if was_open:
            self._end(None)
        return in_time

    def stop_motors(self, then: AfterStop) -> None:
        """Stop everything and disarm; `then` is told whether the board has proved it, once.

        Where the line ends before that, `then` is not called; `link_changed` tells.
        """
        self._after_stop.append(then)
        self.motors.stop()

    def reload(self) -> None:
        """Read everything from the board again."""
        self._ask(Reload, self._on_reloaded)

    def apply(self, only: Collection[str] | None = None) -> None:
        """Write every edit, or those with these keys, and read it back; see `Apply.start`.

        `applied` tells how it went. Before the first byte the line session is told where else
        to look for the board, since its power may fail right behind the write.
        """
        if self._state is not None and self._line.is_open and not self.reset_ordered:
            self._expect_after(self.parameters.all_shown)
            self._apply.start(self._state, self._settings, only)

    def reset_to_factory(self) -> None:
        """Let the board put every parameter back at its next start; a snapshot is saved first.

        Edits that wait are dropped: they were made to what will be gone. `applied` tells how it
        went.
        """
        if self._state is None or not self._line.is_open or self.applying:
            return
        defaults = factory_settings(self._state.signature.model, self._state.signature.firmware)
        self._expect_after(defaults.parameters)
        if self._apply.reset(self._state, self._settings):
            self.draft.discard_edits()

    def note_power_cycled(self) -> None:
        """Take a person's word that the board was switched off and on."""
        self._ordered_reset = None
        if self._state is not None:
            self.draft.take_state(self._state, power_cycled=True)
            self.parameters.note_in_force(self._in_force(self._state))
            self.state_changed.emit()
            self.link_changed.emit()

    def _expect_after(self, stored: Mapping[str, int]) -> None:
        """Look for the board where it will be with these values, too, should it fall silent."""
        if self._state is None or self._settings is None:
            return
        firmware = self._state.signature.firmware
        self.expect(where_to_look(self._settings, self._state.parameters, stored, firmware))

    def expect(self, settings: tuple[LinkSettings, ...]) -> None:
        """Name where else to look for the board when it falls silent; replaces what was named."""
        self._line.submit(Expect(settings))

    @property
    def pending(self) -> int:
        """How many edits of parameters and calibrations wait for Apply."""
        return self.draft.pending

    def discard_edits(self) -> None:
        """Go back to what the board stores; one step to undo."""
        self.draft.discard_edits()

    # --- Requests and their outcomes ----------------------------------------------------

    def _ask(
        self, make: Callable[[int], Reload | Stop | Write], then: Callable[[Outcome], None]
    ) -> None:
        if not self._line.ask(make, then):
            self.failed.emit(self.tr("No board is connected."))

    @Slot(object)
    def _on_drive_requested(self, wish: SetDrive | SetAuxiliary) -> None:
        if self._line.submit(wish):
            self._may_move = True

    @Slot()
    def _on_stop_requested(self) -> None:
        waiting, self._after_stop = self._after_stop, []

        def tell(outcome: Outcome) -> None:
            self._on_stopped(outcome)
            for then in waiting:
                then(outcome.error)

        if not self._line.ask(Stop, tell):
            for then in waiting:
                then(NoReply(self.tr("No board is connected.")))

    def _on_stopped(self, outcome: Outcome) -> None:
        if outcome.error is None:
            # A wish that was let through meanwhile is a motor that moves again.
            self._may_move = self.motors.armed
            self.link_changed.emit()
        elif self._link is not Link.CLOSING:
            self.failed.emit(str(outcome.error))

    def _on_reloaded(self, outcome: Outcome) -> None:
        if outcome.error is not None:
            self.failed.emit(self.tr("Reading again failed. {0}").format(outcome.error))

    @Slot(object)
    def _on_applied(self, results: tuple[Written, ...]) -> None:
        self._note_written(results)
        self.link_changed.emit()
        self.applied.emit(results)

    @Slot(str)
    def _on_apply_failed(self, reason: str) -> None:
        self.link_changed.emit()
        self.failed.emit(reason)

    def _note_written(self, results: tuple[Written, ...]) -> None:
        """Let `state` say what the board holds now."""
        if self._state is None:
            return
        if any(result.what == "factory_reset" and result.error is None for result in results):
            self._ordered_reset = dict(self._state.parameters)
        parameters, calibrations = dict(self._state.parameters), dict(self._state.calibrations)
        learned = set(channels_in(self._state.calibrated))
        for result in results:
            if isinstance(result.stored, int):
                if result.what in parameters:
                    parameters[result.what] = result.stored
            elif result.stored is not None:
                channel = int(result.what.removeprefix("channel "))
                calibrations[channel] = result.stored
                is_own = result.stored != DEFAULT_CALIBRATION[self._state.source]
                learned = (learned - {channel}) | ({channel} if is_own else set())
        self._state = replace(
            self._state,
            parameters=parameters,
            calibrations=calibrations,
            calibrated=channel_mask(learned),
        )
        if self._settings is not None and self._settings.device_number is not None:
            # A new number is obeyed at once, and the line session has followed.
            number = parameters.get("device_number", self._settings.device_number)
            self._settings = replace(self._settings, device_number=number)
        self.state_changed.emit()

    # --- Reports from the line ----------------------------------------------------------

    @Slot(object)
    def _on_reported(self, report: Report) -> None:
        match report:
            case Batch():
                self._take_samples(report)
            case Progress(done=done, total=total, what=what):
                self.progressed.emit(done, total, what)
            case Connected() | Silent() if self._link is Link.CLOSING:
                pass  # it was on its way when the line was given up
            case Connected():
                self._take_state(report)
            case Silent(reason=reason, counters=counters):
                self._counters = counters
                self._fall_silent(reason)

    @Slot(object)
    def _on_replacing(self, shown: Settings) -> None:
        """Keep edits that no board of their kind is there for any more, as a snapshot."""
        name = f"{shown.product.name} {shown.firmware or ''}".strip()
        reason = self.tr("another board; with edits that were not applied")
        try:
            self.history.take(shown, adapter="", reason=reason)
        except SettingsError as error:
            text = self.tr("The edits for the {0} before could not be saved. {1}")
            self.failed.emit(text.format(name, sentence(error)))
            return
        text = self.tr(
            "The settings of the {0} before, with the edits that were not applied, are kept in "
            "File, History."
        )
        self.told.emit(text.format(name))

    def _take_samples(self, batch: Batch) -> None:
        self._counters = batch.counters
        for sample in batch.samples:
            if isinstance(sample, StatusNews):
                self.errors.take(sample)
        self.telemetry.take(batch)
        self._allow_driving()

    def _allow_driving(self) -> None:
        """Let the motors be armed only while this program's commands reach them.

        Where channels are in control the board keeps a command until channel 5 hands over:
        what was meant for now would start later.
        """
        allowed = self._link is Link.UP and bool(self.telemetry.serial_controls)
        if allowed != self.motors.can_arm:
            if not allowed and self.motors.armed and self._link is Link.UP:
                self.motors.stop()
            self.motors.allow(allowed)

    def _take_state(self, report: Connected) -> None:
        state, occasion = report.state, report.occasion
        self._state = state
        self._echo = report.echo
        self._settings = report.settings
        self._port_rates = report.port_rates
        if occasion is Occasion.OPENED and self.pending and self._is_of(state):
            text = self.tr("Edits made before wait here: {0}. Apply writes them to this board.")
            self.told.emit(text.format(self.pending))
        if occasion is Occasion.OPENED:
            self.telemetry.begin(state.signature.model.current_unit)
        if occasion is not Occasion.RELOADED:
            self._may_move = report.may_move
            self.motors.allow(False)
        self.telemetry.note_control(state.serial_controls)
        if occasion.power_cycled or self._ordered_reset != dict(state.parameters):
            self._ordered_reset = None
        self.draft.take_state(state, power_cycled=occasion.power_cycled)
        self.parameters.note_in_force(self._in_force(state))
        self._set_link(Link.UP, self.tr("Connected to {0}.").format(state.signature))
        self._allow_driving()
        self.state_changed.emit()

    def _is_of(self, state: DeviceState) -> bool:
        """Whether the edits that wait are for this kind of board."""
        return self.parameters.model_key == state.signature.model.key

    def _in_force(self, state: DeviceState) -> dict[str, int]:
        """Return what is surely in force now of what acts only after a power cycle.

        The line itself shows the UART settings, the mode the input source; stored values
        may differ from them until the power is cycled.
        """
        in_force: dict[str, int] = {}
        if self._settings is not None:
            in_force["uart_settings"] = self._settings.line.to_wire()
            if self._settings.framing.polynomial is not None:
                in_force["crc7_polynomial"] = self._settings.polynomial & 0x7F
        if state.mode.is_serial:
            in_force["channel_input_source"] = int(state.source is InputSource.ANALOG)
        return in_force

    def _fall_silent(self, reason: str) -> None:
        self.motors.allow(False)
        self.telemetry.forget()
        self.parameters.set_editable(False)
        self._set_link(
            Link.SILENT,
            self.tr("The board has stopped answering. Is its power on? Waiting for it …"),
        )
        log.info("the board fell silent: %s", reason)

    @Slot(object)
    def _on_closed(self, last: Closed) -> None:
        self._may_move = last.may_move
        following, self._next = self._next, None
        if following is not None:
            self._forget()
            self.connect_to(following)
        else:
            self._end(last.error)

    def _forget(self) -> None:
        """Know nothing of any board any more."""
        self._state = None
        self._apply.forget()
        self.motors.allow(False)
        self.telemetry.forget()
        self.parameters.set_editable(False)
        self.state_changed.emit()

    def _end(self, error: TrexError | None) -> None:
        self._forget()
        self._set_link(Link.NONE, self.tr("Not connected."))
        if error is not None:
            self.failed.emit(str(error))

    def _set_link(self, link: Link, status: str) -> None:
        self._link = link
        self._status = status
        self.link_changed.emit()
