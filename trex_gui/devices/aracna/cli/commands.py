"""query, pose, speeds, play."""

import json

import click

from trex_gui.core.cli.console import Interruption, UsageError, refusals, say
from trex_gui.core.cli.options import json_option, port_option, timeout_option
from trex_gui.devices.aracna.cli import files, motion
from trex_gui.devices.aracna.cli.format import listed
from trex_gui.devices.aracna.cli.session import Talk, settings_of
from trex_gui.devices.aracna.poses.playing import blend_in, steps_of
from trex_gui.devices.aracna.session.messages import Play, Report, SpeedsHeld

_POSITION = click.IntRange(0, 1023)
_SCALES = click.FloatRange(0.05, 20)

_no_limits_option = click.option(
    "--no-limits",
    is_flag=True,
    help="Allow every position from 0 to 1023. A joint may hit the body or a screw then.",
)


@click.group()
def aracna() -> None:
    """Ask and move an Aracna, the robot with eight motors.

    It is reached at 38400 baud, 8N1. Nothing on its link stops a motion that runs or switches
    motors off: only servo power does.
    """


@aracna.command()
@port_option
@timeout_option
@json_option
def query(port: str | None, patience: float, *, as_json: bool) -> None:
    """Show the firmware's version and how many motors it has. Moves nothing."""
    with Talk(settings_of(port, patience)) as talk:
        robot = talk.robot
    if as_json:
        row = {"port": port, "product": "Aracna", "firmware": robot.version, "motors": robot.motors}
        click.echo(json.dumps(row, indent=2, ensure_ascii=False))
    else:
        click.echo(f"Aracna, firmware {robot.version}, {robot.motors} motors")


@aracna.command()
@port_option
@timeout_option
@click.argument("values", metavar="SPEED...", nargs=-1, required=True, type=_POSITION)
def speeds(values: tuple[int, ...], port: str | None, patience: float) -> None:
    """Set the speed of every motor: one value for all, or one for each.

    A unit is 0.67 degrees a second; 0 is no standstill, but as fast as the servo can. Prints what
    the servos hold then. They keep it until they lose power.
    """
    with Talk(settings_of(port, patience), _print_speeds) as talk:
        motors = talk.robot.motors
        wanted = values * motors if len(values) == 1 else _for_each(values, motors, "speeds")
        motion.conclude(motion.set_speeds(talk, wanted))


def _print_speeds(report: Report) -> None:
    if isinstance(report, SpeedsHeld):
        click.echo(listed(report.held))


@aracna.command()
@port_option
@timeout_option
@click.argument("values", metavar="[POSITION...]", nargs=-1, type=_POSITION)
@click.option("--pose", "name", metavar="NAME", help="Go to a pose of --file, or a known one.")
@click.option("--file", metavar="FILE", help="Pose file (.ppr) with the pose.")
@click.option(
    "--speed",
    type=_POSITION,
    default=100,
    show_default=True,
    help="Speed of every motor, set first: where the motors are nobody knows before they move. "
    "0 is as fast as they can.",
)
@_no_limits_option
def pose(
    values: tuple[int, ...],
    name: str | None,
    file: str | None,
    *,
    speed: int,
    port: str | None,
    patience: float,
    no_limits: bool,
) -> None:
    """Send every motor to a position, 0 to 1023 (512 is the centre), and wait.

    Takes one position for each motor, or the name of a pose: positions outside the joints' limits
    are refused, those of a pose are cut to them. Prints where the motors are in the end.
    """
    if bool(values) == (name is not None):
        raise UsageError("Give either one position for each motor, or --pose NAME.")
    if file is not None and name is None:
        raise UsageError("--file needs --pose NAME.")
    meant = None if name is None else files.pose_named(name, file)
    if meant is None and not no_limits:
        motion.check_limits(values)
    settings = settings_of(port, patience)
    with Interruption() as interrupted:
        watch = motion.Watch(interrupted)
        with Talk(settings, watch.hear, interrupted.__bool__) as talk:
            motors = talk.robot.motors
            if meant is None:
                goals = _for_each(values, motors, "positions")
            else:
                goals = files.cut(meant, files.limits_of(motors, lifted=no_limits))
            moved = motion.move(talk, watch, goals, (speed,) * motors)
    click.echo(listed(moved.present))
    motion.conclude(watch.amiss)


@aracna.command()
@port_option
@timeout_option
@click.argument("file")
@click.option("--sequence", "name", metavar="NAME", help="Which one, where the file has several.")
@click.option("--rounds", type=click.IntRange(1), default=1, show_default=True)
@click.option("--loop", is_flag=True, help="Play it until Ctrl-C.")
@click.option(
    "--scale",
    type=_SCALES,
    default=1.0,
    metavar="F",
    help="Factor on the times of all steps: 2 is half as fast.",
)
@_no_limits_option
def play(
    file: str,
    name: str | None,
    *,
    rounds: int,
    loop: bool,
    scale: float,
    port: str | None,
    patience: float,
    no_limits: bool,
) -> None:
    """Play a sequence of a pose file (.ppr); to where it begins it goes slowly.

    Positions outside the joints' limits are cut to them, and that is told. Ctrl-C sends nothing
    more; the step that runs goes on to its end.
    """
    project = files.read_project(file)
    sequence = files.sequence_named(project, name)
    settings = settings_of(port, patience)
    with Interruption() as interrupted:
        watch = motion.Watch(interrupted, motors=False)
        with Talk(settings, watch.hear, interrupted.__bool__) as talk:
            limits = files.limits_of(talk.robot.motors, lifted=no_limits)
            with refusals():
                steps = steps_of(sequence, project.poses, limits)
                first = blend_in(sequence, project.poses, limits)
            for used in project.poses:
                if used.name in {step.pose_name for step in sequence.steps}:
                    files.cut(used, limits)
            motion.play(
                talk,
                watch,
                Play(talk.next_id(), steps, 0 if loop else rounds, first, time_scale=scale),
            )
    say("Halted." if watch.halted else "Played.")
    if (moved := watch.moved) is not None:
        click.echo(listed(moved.present))
        motion.conclude(watch.amiss)


def _for_each(values: tuple[int, ...], motors: int, what: str) -> tuple[int, ...]:
    if len(values) != motors:
        raise UsageError(
            f"The robot has {motors} motors, which need {motors} {what}, not {len(values)}."
        )
    return values
