"""motor, stop: driving, and an end to it whatever happens."""

import math
from dataclasses import dataclass
from typing import Any

import click

from trex_gui.core.cli.console import CommandFailed, Interruption, UsageError, say
from trex_gui.core.errors import BadReply, BadRequest, NoReply, PortUnavailable
from trex_gui.core.transport.port_holder import holder_of
from trex_gui.devices.trex.cli.common import identify, link_options, link_settings, open_line
from trex_gui.devices.trex.cli.status import names_of
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.explanations import BEYOND_A_STOP, who_controls
from trex_gui.devices.trex.client.reading import ask
from trex_gui.devices.trex.client.telemetry import StatusReader
from trex_gui.devices.trex.driving.stopping import stop_and_confirm
from trex_gui.devices.trex.protocol.commands import (
    Command,
    Drive,
    DriveAuxiliary,
    DriveMotor,
    GetMode,
    GetParameter,
    GetSerialControl,
    Signature,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.flags import Status, UartError
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey
from trex_gui.devices.trex.protocol.parameters import parameter_number, parameters_of

_LOOK = 0.1
"""Seconds between two looks at the board while a motor runs; each feeds its serial timeout."""

_SLICE = 0.02
_FAILURES = 3
_ENDS_A_RUN = Status.MOTOR1_FAULT | Status.MOTOR2_FAULT


@click.command(context_settings={"ignore_unknown_options": True})
@link_options
@click.argument("which", metavar="1|2|aux", type=click.Choice(["1", "2", "aux"]))
@click.argument("speed", type=int)
@click.option("--accelerate", is_flag=True, help="Go there at the acceleration that is set.")
@click.option(
    "--seconds",
    type=click.FloatRange(0, min_open=True),
    metavar="S",
    help="Run so long; without it, until Ctrl-C.",
)
@click.option("--brake", is_flag=True, help="Brake; SPEED is the strength of it, 0 to 127.")
def motor(
    which: str,
    speed: int,
    *,
    accelerate: bool,
    seconds: float | None,
    brake: bool,
    **options: Any,
) -> None:
    """Run a motor at SPEED, -127 to 127 (auxiliary motor 0 to 127), then stop every motor.

    Runs until Ctrl-C, or for --seconds. However it ends (a signal and an error too), all motors
    are stopped and the board is asked until it proves that.
    """
    command = _order(which, speed, accelerate=accelerate, brake=brake)
    with open_line(link_settings(options)) as client:
        signature = identify(client)
        _check_control(client, which)
        timeout = _timeout(client, signature)
        reader = StatusReader(client.transport.clock)
        if old := names_of(reader.read(client.request)):
            say(f"Noticed before: {', '.join(old)}.")
        with Interruption(precious=True) as interrupted:
            reason: str | None = None
            try:
                run = _Run(command, seconds, timeout)
                reason = run.until_done(client, reader, interrupted)
            except (NoReply, BadReply) as error:
                reason = f"The board has stopped answering: {error}"
            except PortUnavailable as error:
                raise PortUnavailable(f"{error} {_what_now(timeout)}") from error
            finally:
                _stop(client, reader, timeout)
    say("Stopped.")
    if reason:
        raise CommandFailed(reason)


@click.command()
@link_options
def stop(**options: Any) -> None:
    """Brake both motors and switch the auxiliary motor off, until the board confirms it."""
    settings = link_settings(options)
    try:
        _stop_at(settings)
    except CommandFailed as refusal:
        held = isinstance(refusal.__cause__, PortUnavailable) and holder_of(settings.url)
        if not held:
            raise
        raise CommandFailed(
            f"{refusal} If that is TReX Studio: Esc in its window stops the motors, and so does "
            "ending it."
        ) from refusal
    say("Stopped.")


def _stop_at(settings: ConnectionSettings) -> None:
    with open_line(settings) as client:
        reader = StatusReader(client.transport.clock)
        if not stop_and_confirm(client, reader, careful=True).confirmed:
            identify(client)  # says why nothing answers
            raise NoReply(
                "The stop was sent, but the board reports errors on the line each time. "
                "If a motor still turns, cut its power."
            )
        if not ask(client.request, GetSerialControl()):
            raise CommandFailed(BEYOND_A_STOP)


def _order(which: str, speed: int, *, accelerate: bool, brake: bool) -> Command[None]:
    """Return the command that was asked for.

    Raises:
        Usage: there is no such command.
    """
    try:
        if which == "aux":
            if brake:
                raise UsageError("The auxiliary motor has no brake.")
            order: Command[None] = DriveAuxiliary(speed, accelerate)
        else:
            drive = Drive.brake(speed) if brake else Drive.at(speed)
            order = DriveMotor(int(which), drive, accelerate)
        order.data()
    except BadRequest as error:
        raise UsageError(str(error)) from error
    return order


def _check_control(client: TrexClient, which: str) -> None:
    """Refuse where the motors would not obey, and an order would only wait in the board."""
    mode = ask(client.request, GetMode())
    joint = ask(client.request, GetParameter(parameter_number(ParameterKey.MOTOR_MODE))) == 1
    if not ask(client.request, GetSerialControl()):
        raise CommandFailed(who_controls(mode, by_serial=False, joint=joint))
    if joint and which == "2":
        say("Warning: in joint mode both drivers work as motor 1; motor 2 is ignored.")


def _timeout(client: TrexClient, signature: Signature) -> float:
    """Return the board's serial timeout in seconds, 0 for none; warn where there is none."""
    spec = parameters_of(signature.model.key, signature.firmware)[ParameterKey.SERIAL_TIMEOUT]
    wire = ask(client.request, GetParameter(spec.number))
    if not wire:
        say(
            "Warning: Serial Timeout is off, so the motor goes on when the cable or this computer "
            'fails. `trexcmd set serial_timeout "0.5 s"` switches it on.'
        )
    return wire * spec.scale


@dataclass(frozen=True, slots=True)
class _Run:
    """What to do, for how long, and how soon the board must hear of us; all in seconds."""

    command: Command[None]
    seconds: float | None
    timeout: float

    def until_done(
        self, client: TrexClient, reader: StatusReader, interrupted: Interruption
    ) -> str | None:
        """Drive until it is time to stop; return why that is too early, else `None`."""
        clock = client.transport.clock
        every = min(_LOOK, self.timeout / 3) if self.timeout else _LOOK
        client.request(self.command)
        begun = looked = clock()
        end = math.inf if self.seconds is None else begun + self.seconds
        say("Running; Ctrl-C stops." if self.seconds is None else f"Running {self.seconds:g} s.")
        failures = 0
        while not interrupted and (now := clock()) < end:
            if (rest := min(looked + every, end) - now) > 0:
                client.transport.wait(min(_SLICE, rest))
                continue
            looked = now
            try:
                news = reader.read(client.request)
                controls = client.request(GetSerialControl())
                failures = 0
            except (NoReply, BadReply):
                failures += 1
                if failures == _FAILURES:
                    raise
                continue
            if not controls and not ask(client.request, GetSerialControl()):
                return "Channel 5 has taken the motors away from the serial port."
            if news is None:
                continue
            names = ", ".join(names_of(news))
            if news.status & _ENDS_A_RUN or news.uart & UartError.TIMEOUT:
                return f"The board reports: {names}."
            say(f"The board reports: {names}.")
            if news.uart:
                # It may have stopped the motors for it, or have lost the order.
                client.request(self.command)
        return None


def _what_now(timeout: float) -> str:
    if timeout:
        return f"The board stops its motors by itself {timeout:g} s after the last byte."
    return "If a motor still turns, cut its power."


def _stop(client: TrexClient, reader: StatusReader, timeout: float) -> None:
    """Stop everything.

    Raises:
        Refused: the board does not prove it.
    """
    try:
        confirmed = stop_and_confirm(client, reader, careful=True).confirmed
    except PortUnavailable as error:
        raise PortUnavailable(f"{error} {_what_now(timeout)}") from error
    if not confirmed:
        raise CommandFailed(
            f"The stop was sent, but the board does not confirm it. {_what_now(timeout)}"
        )
