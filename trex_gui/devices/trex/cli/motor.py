"""The motor and stop commands."""

import math
import time
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import click

from trex_gui.core.cli import CommandFailed, Interruption, reported_errors, say, seconds_option
from trex_gui.core.errors import (
    BadReply,
    BadRequest,
    NoReply,
    PortUnavailable,
    StudioError,
    describe,
)
from trex_gui.core.host import host
from trex_gui.core.session import Close, Closed, Outcome
from trex_gui.core.texts import hex_text
from trex_gui.core.transport.adapters import adapter_key
from trex_gui.core.transport.linux_ports import holder_of
from trex_gui.core.transport.urls import is_served
from trex_gui.devices.trex.board.keeper import Keeper
from trex_gui.devices.trex.board.mirror import BoardMirror, DriveLost
from trex_gui.devices.trex.cli.changes import say_warning
from trex_gui.devices.trex.cli.common import (
    boards_option,
    grouped,
    identify,
    link_options,
    link_settings,
    open_line,
)
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import DeviceState, query
from trex_gui.devices.trex.client.telemetry import Control, LatchedStatus, StatusReader
from trex_gui.devices.trex.driving.motor_driver import MotorDriver, StopRun, stop_together
from trex_gui.devices.trex.driving.motor_output import MotorOutput
from trex_gui.devices.trex.driving.requests import (
    HEARTBEAT_INTERVAL,
    Arm,
    Heartbeat,
    MotorsStopped,
    SetAuxiliary,
    SetMotor,
    Setpoint,
    Stop,
    packets,
)
from trex_gui.devices.trex.driving.timeout_stop import TimeoutStop, turning_text
from trex_gui.devices.trex.protocol.commands import GetSerialControl
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.descriptions import STOP_UNCONFIRMED, STOP_WITHOUT_EFFECT
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.serve.sessions import session_at
from trex_gui.devices.trex.session.messages import (
    Connected,
    GuardianChanged,
    NotResponding,
    OfBoard,
    ReadReason,
    Report,
    Request,
    SendPacket,
    ToBoard,
)
from trex_gui.devices.trex.settings.board_records import BoardRecord, utc_now
from trex_gui.devices.trex.settings.edit_files import BoardIdentity

_SIGNAL_CHECK_S = 0.02  # maximum seconds between two checks for signals


@click.command(context_settings={"ignore_unknown_options": True})
@link_options
@click.argument("target", metavar="1|2|aux", type=click.Choice(["1", "2", "aux"]))
@click.argument("speed", type=int)
@click.option("--accelerate", is_flag=True, help="Use the acceleration stored in the board.")
@seconds_option
@click.option("--brake", is_flag=True, help="Brake the motor. SPEED is the braking duty, 0 to 127.")
@boards_option
def motor(
    target: str,
    speed: int,
    *,
    accelerate: bool,
    seconds: float | None,
    brake: bool,
    boards: str,
    **options: Any,
) -> None:
    """Run a motor at SPEED, -127 to 127 (auxiliary motor: 0 to 127), then stop every motor.

    The motor runs until Ctrl-C, or for the time given with --seconds. At the end, the stop is
    repeated until the board confirms it, even after a signal or an error.
    """
    setpoint = _setpoint(target, speed, accelerate=accelerate, brake=brake)
    run_motors(grouped(link_settings(options), boards), [setpoint], seconds)


def run_motors(
    settings: ConnectionSettings, commands: Sequence[Setpoint | SendPacket], seconds: float | None
) -> None:
    """Arm the motors, send the commands, and stop after `seconds` or Ctrl-C.

    Raises CommandFailed if the run ends early or with an error. Even then, the motors are stopped
    if possible.
    """
    clock, open_port = host().clock, host().open_transport
    wait: Callable[[float], None] = time.sleep
    if is_served(settings.url) and host().logged:
        raise click.UsageError(
            "--traffic cannot record a served board. Use it with `trexcmd serve` instead."
        )
    if not is_served(settings.url):
        with reported_errors():  # Ctrl-C may interrupt a slow connection over the network
            transport = host().open_transport(settings)
        clock, wait, open_port = transport.clock, transport.wait, lambda _settings: transport
    with Interruption(must_finish=True) as interrupted:
        duration = math.inf if seconds is None else seconds
        run = _Run(commands, duration, interrupted, clock, wait, settings.group or (None,))
        for board in run.boards.values():
            board.adapter = adapter_key(settings.url)
        session_at(settings, run, run.handle, open_port, clock).run()
    run.conclude()


_STOP_ID = -1  # request ID of the final stop; packets have higher IDs

_CAUSES = {
    TimeoutStop.OFF: "Serial Timeout is off",
    TimeoutStop.DOUBTFUL: "UART-Error Shutdown is off",
    TimeoutStop.FAILED: "Serial Timeout did not stop the motors of this board when it was tried",
    TimeoutStop.REFUTED: "Serial Timeout did not stop the motors of this board when it was tried",
}


@click.command()
@link_options
@boards_option
@click.option(
    "--robots",
    multiple=True,
    metavar="NAME",
    help='Stop the served board NAME, or "all" for every served board. May be repeated.',
)
def stop(robots: tuple[str, ...], boards: str, **options: Any) -> None:
    """Brake both motors and switch the auxiliary motor off.

    The stop is repeated until the board confirms it.
    """
    if robots or is_served(options["port"] or ""):
        _stop_served(robots or [options["port"]])
        return
    settings = grouped(link_settings(options), boards)
    try:
        _stop_at(settings)
    except CommandFailed as failure:
        is_held = isinstance(failure.__cause__, PortUnavailable) and holder_of(settings.url)
        if not is_held:
            raise
        raise CommandFailed(
            f"{failure} If TReX Studio uses the port, press Esc in its window or close the window "
            "to stop the motors."
        ) from failure
    say("Stopped.")


def _stop_served(names: Sequence[str]) -> None:
    from trex_gui.devices.trex.serve.robots import Robots  # noqa: PLC0415 - an extra

    with reported_errors(), Robots() as boards:
        results = boards.stop(names)
    for url, error in results.items():
        say(f"{url}: {error or 'stopped.'}")
    if not results:
        raise CommandFailed(
            "No served board was found, so no stop was sent. If a motor is turning, cut its power."
        )
    if any(results.values()):
        raise CommandFailed(STOP_UNCONFIRMED)


def _stop_at(settings: ConnectionSettings) -> None:
    with open_line(settings) as first:
        clients = [first.to_board(settings.of_board(n)) for n in settings.group] or [first]
        runs = [
            MotorDriver(
                MotorOutput(lambda _report: None), client, StatusReader(client.transport.clock)
            ).final_stop(careful=True)
            for client in clients
        ]
        stop_together(runs)
        # Boards that have not confirmed the stop come first.
        results = sorted(zip(runs, clients, strict=True), key=lambda pair: pair[0].is_confirmed)
        problems = {client: _stop_problem(client, run) for run, client in results}
        texts = [
            f"Board {client.settings.device_number}: {text}" if settings.group else text
            for client, text in problems.items()
            if text
        ]
        if texts:
            raise CommandFailed("\n".join(texts))


def _stop_problem(client: TrexClient, run: StopRun) -> str:
    """Return the reason why a motor may still turn.

    Empty if the stop is confirmed and serial commands control the motors.
    """
    if not run.is_confirmed:
        try:
            identify(client, quick=True)  # raises an error that explains a missing reply
        except (NoReply, BadReply) as error:
            return f"{STOP_UNCONFIRMED} {error}"
        return (
            "The stop was sent repeatedly, but each time the board reported errors on the line. "
            "If a motor is still turning, cut its power."
        )
    try:
        return "" if query(client.request, GetSerialControl()) else STOP_WITHOUT_EFFECT
    except (NoReply, BadReply) as error:
        return str(error)


def _setpoint(target: str, speed: int, *, accelerate: bool, brake: bool) -> Setpoint:
    try:
        if target == "aux":
            if brake:
                raise click.UsageError("The auxiliary motor has no brake.")
            setpoint: Setpoint = SetAuxiliary(speed, accelerate)
        else:
            drive = Drive.brake(speed) if brake else Drive.at(speed)
            setpoint = SetMotor(int(target), drive, accelerate)
        for command in packets([setpoint]):
            command.data()
    except BadRequest as error:
        raise click.UsageError(str(error)) from error
    return setpoint


class _ReadOnlyKeeper(Keeper):
    """Keeper that saves nothing, because a run changes no settings."""

    def save(self, board: BoardIdentity, record: BoardRecord | None) -> None:
        pass


@dataclass(slots=True)
class _Run:
    """Inbox and listener of a session that drives motors on this thread.

    The motors are armed after the first round of polling, which reads the latched errors and
    checks that serial commands control the motors.
    """

    _commands: Sequence[Setpoint | SendPacket]
    _seconds: float
    _interrupted: Interruption
    _clock: Callable[[], float]
    _wait: Callable[[float], None]
    _numbers: Sequence[int | None]  # device numbers of a group; `None` for a single board
    _requests: deque[Request] = field(default_factory=deque)
    _keepers: dict[int | None, Keeper] = field(init=False)
    boards: dict[int | None, BoardMirror] = field(init=False)
    _now: float = 0.0
    _end: float = math.inf
    _heartbeat_at: float = math.inf
    _is_running: bool = False
    _is_ending: bool = False
    _is_guarded: bool = False
    # Board number → True if serial commands control the motors
    _by_serial: dict[int | None, bool] = field(default_factory=dict)
    _reason: str | None = None
    _stop_error: StudioError | None = None
    _line_error: StudioError | None = None

    def __post_init__(self) -> None:
        self._keepers = {number: _ReadOnlyKeeper(say, say_warning) for number in self._numbers}
        self.boards = {n: BoardMirror(keeper.memory) for n, keeper in self._keepers.items()}

    # --- The inbox ----------------------------------------------------------------------

    def get(self, seconds: float) -> Request | None:
        if not self._requests and seconds > 0:
            self._wait(min(seconds, _SIGNAL_CHECK_S))
        now = self._now = self._clock()
        if self._interrupted or now >= self._end:
            self._finish()
        if self._requests:
            return self._requests.popleft()
        if now >= self._heartbeat_at:
            self._heartbeat_at = now + HEARTBEAT_INTERVAL
            return Heartbeat()
        return None

    def _start(self) -> None:
        self._is_running = True
        self._requests += (Arm(), *self._addressed(self._commands))
        self._heartbeat_at = self._now + HEARTBEAT_INTERVAL
        self._end = self._now + self._seconds
        endless = math.isinf(self._seconds)
        say("Running until Ctrl-C." if endless else f"Running for {self._seconds:g} s.")

    def _addressed(self, commands: Sequence[Setpoint | SendPacket]) -> list[Request]:
        return [
            command if number is None else ToBoard(number, command)
            for number in self._numbers
            for command in commands
        ]

    def _finish(self, reason: str | None = None) -> None:
        if not self._is_ending:
            self._is_ending = True
            self._reason = reason
            self._requests.append(Stop(_STOP_ID) if self._is_running else Close())

    # --- Reports ------------------------------------------------------------------------

    def handle(self, report: Report) -> None:
        number, inner = self._numbers[0], report
        if isinstance(report, OfBoard):
            number, inner = report.number, report.report
        if number in self.boards:  # a server may also report other boards
            self._handle(number, inner)

    def _handle(self, number: int | None, report: Report) -> None:
        if isinstance(report, Connected) and report.occasion is not ReadReason.OPENED:
            is_changed = report.occasion is ReadReason.SETTING_CHANGED
            cause = "A setting of the board changed" if is_changed else "The board was restarted"
            self._finish(self._named(number, f"{cause}, so the motors were stopped."))
            return  # no file may be saved while motors may turn
        for event in self.boards[number].handle(report, self._now, utc_now()):
            match event:
                case LatchedStatus():
                    self._handle_status(number, event)
                case Control(by_serial=by_serial):
                    self._handle_control(number, by_serial=by_serial)
                case DriveLost(reason=reason):
                    self._finish(self._named(number, reason))
        match report:
            case GuardianChanged(is_ready=is_ready):
                self._is_guarded = is_ready
            case Connected(state=state):
                self._handle_connected(number, state)
            case NotResponding(reason=reason):
                text = f"The board has stopped responding: {reason}"
                self._finish(self._named(number, text))
            case MotorsStopped(reason=ErrorCode() as code, board=stopped):
                self._finish(describe(code, (stopped,)))
            case Outcome():
                self._handle_outcome(report)
            case Closed(error=error):
                self._line_error = error

    def _handle_outcome(self, outcome: Outcome) -> None:
        if outcome.id == _STOP_ID:
            self._stop_error = outcome.error
            self._requests.append(Close())
        elif outcome.error is not None:
            self._finish(str(outcome.error))
        elif isinstance(outcome.value, bytes) and outcome.value:
            try:
                click.echo(hex_text(outcome.value))
            except (click.ClickException, OSError) as error:  # must not end the session early
                self._finish(str(error))

    def _handle_connected(self, number: int | None, state: DeviceState) -> None:
        board = self.boards[number]
        if not state.serial_controls:
            self._finish(self._named(number, board.control_text))
            return
        if board.is_joint and any(isinstance(c, SetMotor) and c.motor == 2 for c in self._commands):
            say("Warning: in joint mode both drivers work as motor 1. Motor 2 ignores commands.")
        self._keepers[number].load()
        timeout_stop = board.timeout_stop
        if not timeout_stop.is_reliable:
            program = "" if self._is_guarded else ", or if this program is killed"
            is_doubtful = timeout_stop is TimeoutStop.DOUBTFUL
            verb, grade = ("may keep", " (twin)") if is_doubtful else ("keeps", "")
            needed = {"serial_timeout": '"0.5 s"', "uart_error_shutdown": "on"}.items()
            missing = [f"`trexcmd set {k} {v}`" for k, v in needed if not state.parameters.get(k)]
            remedy = " and ".join(missing)
            warning = "Warning" if number is None else f"Warning, board {number}"
            say(
                f"{warning}: {_CAUSES[timeout_stop]}, so the motor {verb} running if the cable or "
                f"this computer fails{program}{grade}.{remedy and f' Remedy: {remedy}.'}"
            )

    def _named(self, number: int | None, text: str) -> str:
        return text if number is None else f"Board {number}: {text}"

    def _handle_status(self, number: int | None, latched: LatchedStatus) -> None:
        names = self._named(number, ", ".join(latched.names))
        if not self._is_running:
            say(f"Errors latched before this run: {names}.")
        elif latched.uart & UartError.TIMEOUT:
            self._finish(f"The board reports: {names}.")
        elif not self._is_ending and not latched.stops_motors():  # otherwise, `DriveLost` follows
            say(f"The board reports: {names}.")
            if latched.uart:  # the board may have stopped the motors
                setpoints = [c for c in self._commands if not isinstance(c, SendPacket)]
                self._requests += self._addressed(setpoints)

    def _handle_control(self, number: int | None, *, by_serial: bool) -> None:
        self._by_serial[number] = by_serial
        all_by_serial = len(self._by_serial) == len(self._numbers) and all(self._by_serial.values())
        if all_by_serial and not self._is_running and not self._is_ending:
            self._start()

    # --- The end ------------------------------------------------------------------------

    def conclude(self) -> None:
        """Report the end of the run. Raises CommandFailed if it ended early or with an error."""
        error = self._line_error or self._stop_error
        if error is not None:
            text = str(error)
            if self._is_running and isinstance(error, PortUnavailable):
                motors = {c.motor for c in self._commands if not isinstance(c, SendPacket)}
                remedy = self.boards[self._numbers[0]].silence_remedy
                text = f"{turning_text(motors)} {remedy} {text}"
            raise CommandFailed(text) from error
        if self._is_running:
            say("Stopped.")
        elif not self._reason:
            raise CommandFailed("Interrupted before the motor was started.")
        if self._reason:
            raise CommandFailed(self._reason)
