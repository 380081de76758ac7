"""Commands `query`, `led`, `speeds`, `pose` and `play`."""

from pathlib import Path

import click

from trex_gui.core.cli import (
    CommandFailed,
    FiniteRange,
    Interruption,
    all_options,
    json_option,
    port_option,
    print_json,
    reported_errors,
    say,
    timeout_option,
    traffic_option,
)
from trex_gui.core.command_io import FileName
from trex_gui.core.plugin import Lazy
from trex_gui.core.texts import counted
from trex_gui.devices.aracna.cli.session import CommandSession, port_settings
from trex_gui.devices.aracna.poses.gaits import BUILT_IN_POSES
from trex_gui.devices.aracna.poses.playing import blend_in, clamped, motor_count_warning, steps_of
from trex_gui.devices.aracna.poses.ppr import read_file
from trex_gui.devices.aracna.poses.project import Pose, Project, Sequence
from trex_gui.devices.aracna.protocol.joints import HIGHEST, Limits, factory_limits
from trex_gui.devices.aracna.session.messages import Play

_SETPOINT = click.IntRange(0, HIGHEST)  # position or speed of a motor

_line_options = all_options(
    port_option,
    timeout_option,
    traffic_option(Lazy("trex_gui.devices.aracna.session.traffic_decoder:AracnaDecoder")),
)
_no_limits_option = click.option(
    "--no-limits",
    is_flag=True,
    help="Allow every position from 0 to 1023. A joint may then hit the body or a screw.",
)


@click.group()
def aracna() -> None:
    """Query and move an Aracna, the robot with eight motors.

    The serial line is always set to 38400 baud. No command stops a running motion or switches
    the motors off. To stop the motors, cut the servo power.
    """


@aracna.command()
@_line_options
@json_option
def query(port: str | None, extra_timeout: float, *, as_json: bool) -> None:
    """Show the firmware version and the number of motors. Never moves a motor."""
    with CommandSession(port_settings(port, extra_timeout)) as session:
        robot = session.robot
    if as_json:
        row = {"port": port, "product": "Aracna", "firmware": robot.version, "motors": robot.motors}
        print_json(row)
    else:
        click.echo(f"Aracna, firmware {robot.version}, {counted(robot.motors, 'motor')}")


@aracna.command()
@_line_options
@click.argument("state", type=click.Choice(["on", "off"]))
def led(state: str, port: str | None, extra_timeout: float) -> None:
    """Switch the board's debug LED, for example to identify the robot. Never moves a motor.

    The LED is off after each start of the board. The command prints the reported state.
    """
    with CommandSession(port_settings(port, extra_timeout)) as session:
        click.echo("on" if session.set_led(on=state == "on") else "off")


@aracna.command()
@_line_options
@click.argument("values", metavar="SPEED...", nargs=-1, required=True, type=_SETPOINT)
def speeds(values: tuple[int, ...], port: str | None, extra_timeout: float) -> None:
    """Set the speed of every motor.

    Give one value for all motors, or one value for each motor. A unit is 0.67 degrees per second,
    and 0 is unlimited. The command prints the speeds that the servos report. The servos keep these
    speeds until a motion sets other speeds, or until they lose power.
    """
    with CommandSession(port_settings(port, extra_timeout)) as session:
        motors = session.robot.motors
        requested = values * motors if len(values) == 1 else values
        _check_count(requested, motors, "speeds")
        click.echo(_joined(session.set_speeds(requested)))
    session.report_faults()


@aracna.command()
@_line_options
@click.argument("values", metavar="[POSITION...]", nargs=-1, type=_SETPOINT)
@click.option("--pose", "name", metavar="NAME", help="Name of a pose: built in, or from --file.")
@click.option("--file", type=FileName(), metavar="FILE", help="Pose file (.ppr) for --pose.")
@click.option(
    "--speed",
    type=_SETPOINT,
    default=100,
    show_default=True,
    help="Speed of every motor, 0 to 1023 (0: unlimited). The speed is set before the move.",
)
@_no_limits_option
def pose(
    values: tuple[int, ...],
    name: str | None,
    file: str | None,
    *,
    speed: int,
    port: str | None,
    extra_timeout: float,
    no_limits: bool,
) -> None:
    """Move every motor to a position, 0 to 1023 (512 is the centre).

    Give one position for each motor, or the name of a pose. Positions outside the joints' limits
    are rejected, but positions of a pose are clamped. The command waits until the motion ends, then
    prints the final positions.
    """
    if bool(values) == (name is not None):
        raise click.UsageError("Give either one position for each motor, or --pose NAME.")
    if file is not None and name is None:
        raise click.UsageError("--file needs --pose NAME.")
    target = None if name is None else _pose_named(name, file)
    if target is None and not no_limits:
        _check_limits(values)
    settings = port_settings(port, extra_timeout)
    with Interruption() as interrupted, CommandSession(settings, interrupted) as session:
        motors = session.robot.motors
        if target is None:
            _check_count(values, motors, "positions")
            goals = values
        else:
            goals = _report_clamps(target, _limits(motors, lifted=no_limits))
        present = session.move(goals, (speed,) * motors)
    click.echo(_joined(present))
    session.report_faults()


@aracna.command()
@_line_options
@click.argument("file", type=FileName())
@click.option(
    "--sequence", "name", metavar="NAME", help="Sequence to play, if the file has more than one."
)
@click.option(
    "--rounds", type=click.IntRange(1), show_default="1", help="Number of rounds to play."
)
@click.option("--loop", is_flag=True, help="Repeat the sequence until Ctrl-C.")
@click.option(
    "--scale",
    type=FiniteRange(0.05, 20),
    default=1.0,
    metavar="F",
    help="Factor by which the duration of each step is multiplied: 2 halves the speed.",
)
@_no_limits_option
def play(
    file: str,
    name: str | None,
    *,
    rounds: int | None,
    loop: bool,
    scale: float,
    port: str | None,
    extra_timeout: float,
    no_limits: bool,
) -> None:
    """Play a sequence from a pose file (.ppr), after a slow move to its first pose.

    Positions outside the joints' limits are clamped and reported. After Ctrl-C, nothing more is
    sent, but the running step continues to its end.
    """
    if loop and rounds is not None:
        raise click.UsageError("Give either --rounds or --loop, not both.")
    project = _read_project(file)
    sequence = _sequence_named(project, name)
    settings = port_settings(port, extra_timeout)
    with (
        Interruption() as interrupted,
        CommandSession(settings, interrupted, report_motors=False) as session,
    ):
        limits = _limits(session.robot.motors, lifted=no_limits)
        with reported_errors():
            steps = steps_of(sequence, project.poses, limits)
            first = blend_in(sequence, project.poses, limits)
        used_names = {step.pose_name for step in sequence.steps}
        for pose in project.poses:
            if pose.name in used_names:
                _report_clamps(pose, limits)
        session.play(Play(0, steps, 0 if loop else rounds or 1, first, time_scale=scale))
    say("Stopped." if session.halted else "Played.")
    if session.moved is not None:
        click.echo(_joined(session.moved.present))
        session.report_faults()


def _joined(values: tuple[int, ...]) -> str:
    return " ".join(map(str, values))


def _check_count(values: tuple[int, ...], motors: int, quantity: str) -> None:
    if len(values) != motors:
        raise click.UsageError(
            f"The robot has {motors} motors. Give {motors} {quantity}, not {len(values)}."
        )


def _check_limits(goals: tuple[int, ...]) -> None:
    violations = [
        f"motor {motor} must be {limit.low} to {limit.high}, not {goal}"
        for motor, (goal, limit) in enumerate(zip(goals, factory_limits(len(goals)), strict=True))
        if not limit.allows(goal)
    ]
    if violations:
        raise click.UsageError(
            f"Outside the joint limits: {'; '.join(violations)}. Add --no-limits to allow this."
        )


def _read_project(file: str) -> Project:
    with reported_errors():
        pose_file = read_file(Path(file))
    for finding in pose_file.findings:
        say(f"{file}: {finding}")
    return pose_file.project


def _pose_named(name: str, file: str | None) -> Pose:
    poses = BUILT_IN_POSES if file is None else _read_project(file).poses
    for pose in poses:
        if pose.name == name:
            return pose
    known = ", ".join(pose.name for pose in poses) or "none"
    raise click.UsageError(f"There is no pose {name!r}. Known poses: {known}.")


def _sequence_named(project: Project, name: str | None) -> Sequence:
    names = ", ".join(sequence.name for sequence in project.sequences)
    if not project.sequences:
        raise CommandFailed("The file contains no sequences.")
    if name is None:
        if len(project.sequences) > 1:
            raise click.UsageError(
                f"Select a sequence with --sequence. The file contains: {names}."
            )
        return project.sequences[0]
    if (sequence := project.sequence(name)) is None:
        raise click.UsageError(f"There is no sequence {name!r}. The file contains: {names}.")
    return sequence


def _limits(motors: int, *, lifted: bool) -> tuple[Limits, ...]:
    return (Limits(),) * motors if lifted else factory_limits(motors)


def _report_clamps(pose: Pose, limits: tuple[Limits, ...]) -> tuple[int, ...]:
    goals = clamped(pose, limits)
    if warning := motor_count_warning([pose], len(limits)):
        say(f"{pose.name}: {warning}")
    for motor, (position, goal) in enumerate(zip(pose.for_motors(len(limits)), goals, strict=True)):
        if position != goal:
            say(f"{pose.name}: motor {motor} moves to its limit {goal} instead of {position}.")
    return goals
