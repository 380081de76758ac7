"""Content of the demo panel of a simulated Aracna."""

from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.aracna.model.controller import AracnaController
from trex_gui.devices.aracna.model.demo import DemoRobot, DemoServo, FirmwareState, RobotSnapshot
from trex_gui.devices.aracna.model.texts import position_text, spoken_joint
from trex_gui.devices.aracna.protocol.joints import HIGHEST, MOTORS
from trex_gui.ui.devices.demo_panel import Columns, DemoPanelBody, Rows, add_cable
from trex_gui.ui.widgets.builders import button, label, named, plain, progress_bar, row
from trex_gui.ui.widgets.labels import LiveLabel
from trex_gui.ui.widgets.leds import Lamp

RobotRows = Rows[RobotSnapshot]

_MIN_GAUGE_WIDTH = 26  # pixels


class DemoRobotView(DemoPanelBody[RobotSnapshot]):
    def __init__(self, controller: AracnaController, parent: QWidget | None = None) -> None:
        robot = controller.demo_robot
        super().__init__(robot, controller, "aracnaDemoState", state_text, parent)
        header = QWidget(self)
        tip = tr("The debug LED; it blinks while the firmware boots")
        self._lamp = named(Lamp("led_green", header), "aracnaDemoLed", tip=tip)
        self._led_text = label(header, "aracnaDemoLedText", tip=tip)
        self._boots = label(
            header, "aracnaDemoBoots", tip=tr("Number of times that the firmware has started")
        )
        row(self._lamp, (self._led_text, 1), self._boots, into=header, margins=0)
        repair = button(
            self,
            "aracnaDemoRepair",
            tr("Clear all faults"),
            icon="reload",
            tip=tr("Repair and free every servo, clear all line faults, and switch everything on"),
            on_click=robot.repair,
        )
        columns = Columns(tr("Noise"), "5.0\u00a0%")
        groups = (
            _power_rows(robot, columns, self),
            _servo_rows(robot, self),
            _cable_rows(robot, columns, self),
        )
        self.arrange(groups, repair, header)

    def show_header(self, snapshot: RobotSnapshot | None) -> None:
        is_lit = snapshot is not None and snapshot.led
        text = tr("LED: on") if is_lit else tr("LED: off")
        if snapshot is not None and snapshot.state is FirmwareState.BOOTING:
            text = tr("LED: blinks")
        self._lamp.set_lit(is_lit)
        self._led_text.setText(text)
        for widget in (self._lamp, self._led_text):
            widget.setAccessibleName(text)
        boots = "" if snapshot is None else tr("Starts: {0}").format(snapshot.boots)
        self._boots.setText(boots)


def _power_rows(robot: DemoRobot, columns: Columns, parent: QWidget) -> RobotRows:
    rows = RobotRows(tr("Power"), columns, parent)
    power = rows.check_box(
        "aracnaDemoPower",
        tr("Robot on"),
        tr("The robot's power switch, for board and servos"),
        robot.set_power,
        lambda snapshot: snapshot.power,
        accessible=tr("Robot switched on"),
    )
    restart = button(
        rows,
        "aracnaDemoRestart",
        tr("Restart board"),
        tip=tr("Reset the board: the firmware restarts, but the servos continue to their goals"),
        icon="reload",
        on_click=robot.restart,
    )
    servos = rows.check_box(
        "aracnaDemoServoPower",
        tr("Servo power"),
        tr(
            "Power of the servos only. Without power, the servos stop, go limp and lose "
            "their speeds, and the firmware waits for them."
        ),
        robot.set_servo_power,
        lambda snapshot: snapshot.servo_power,
    )

    def enable(snapshot: RobotSnapshot) -> None:
        restart.setEnabled(snapshot.power)
        servos.setEnabled(snapshot.power)

    rows.on_snapshot(enable)
    rows.add_wide((power, 1), (restart, 0))
    rows.add_wide(servos)
    rows.add_note("aracnaDemoPowerHint", 2, power_text)
    return rows


def _servo_rows(robot: DemoRobot, parent: QWidget) -> RobotRows:
    headings = (tr("Dead"), tr("Blocked"))
    rows = RobotRows(tr("Servos"), Columns("0", str(HIGHEST), headings), parent)
    rows.add_headings(tr("Real position"), *headings)
    for motor in range(MOTORS):
        _add_servo_row(motor, robot, rows)
    return rows


def _add_servo_row(motor: int, robot: DemoRobot, rows: RobotRows) -> None:
    joint = spoken_joint(motor)
    spoken = tr("{0}: real position").format(joint)
    gauge = progress_bar(rows, f"aracnaDemoGauge{motor}", spoken)
    gauge.setRange(0, HIGHEST)
    gauge.setMinimumWidth(_MIN_GAUGE_WIDTH)
    value = LiveLabel(f"aracnaDemoPosition{motor}", spoken, rows)
    dead = rows.check_box(
        f"aracnaDemoDead{motor}",
        "",
        tr(
            "{0} does not respond, as if it were unplugged: its speed reads as −1, and a "
            "move waits indefinitely"
        ).format(joint),
        lambda checked: robot.set_dead(motor, checked),
        lambda snapshot: snapshot.servos[motor].dead,
        accessible=tr("{0}: dead").format(joint),
    )
    blocked = rows.check_box(
        f"aracnaDemoBlocked{motor}",
        "",
        tr("{0} is blocked: it remains “moving”, and the firmware waits").format(joint),
        lambda checked: robot.set_blocked(motor, checked),
        lambda snapshot: snapshot.servos[motor].blocked,
        accessible=tr("{0}: blocked").format(joint),
    )
    name = rows.add_row(f"<b>{motor}</b>", gauge, value, (dead, blocked))
    name.setToolTip(plain(joint))
    name.setBuddy(dead)

    def update(snapshot: RobotSnapshot) -> None:
        servo = snapshot.servos[motor]
        gauge.setValue(servo.position)
        value.setText(str(servo.position))
        text = servo_text(servo, snapshot.servo_power)
        for widget in (gauge, value):
            widget.setToolTip(plain(text))

    rows.on_snapshot(update)


def _cable_rows(robot: DemoRobot, columns: Columns, parent: QWidget) -> RobotRows:
    rows = RobotRows(tr("Cable"), columns, parent)
    plugged = rows.check_box(
        "aracnaDemoCable",
        tr("Plugged in"),
        tr(
            "When the cable is unplugged, the port disappears, but a running motion continues "
            "to its goal"
        ),
        robot.set_plugged,
        lambda snapshot: snapshot.line.plugged,
        accessible=tr("Cable plugged in"),
    )
    noise = tr(
        "Percentage of bytes that are corrupted, in both directions. The protocol does not "
        "detect corrupted bytes, and a corrupted command may restart the firmware."
    )
    loss_tip = tr(
        "A command that loses a byte may have too few values, which restarts the firmware"
    )
    add_cable(
        rows,
        robot,
        "aracnaDemo",
        mute=tr("The return wire is broken: the robot executes commands, but no reply arrives"),
        noise=noise,
        faults=(
            (tr("Reply byte"), "drop 1"),
            (tr("Command byte"), "drop 1 sent"),
            (tr("End of reply"), "cut 6"),  # 6 bytes: `.c`, a position and its comma
        ),
        choice=("aracnaDemoLoss", tr("Simulated loss"), loss_tip),
        once=("aracnaDemoLose", tr("Lose"), tr("Takes effect in the next transfer")),
        cause=robot.lose,
        before=[(plugged, 1)],
    )
    return rows


def state_text(snapshot: RobotSnapshot) -> str:
    if snapshot.is_stuck:
        if not snapshot.servo_power:
            return tr("Moving indefinitely: waiting for servos that have no power.")
        return tr("Moving indefinitely: waiting for a servo that is blocked or dead.")
    return {
        FirmwareState.OFF: tr(
            "The power is off: the robot does not reply, and no servo holds its position."
        ),
        FirmwareState.BOOTING: tr("Booting: blinks for a second and reads nothing."),
        FirmwareState.IDLE: tr("Idle: waiting for commands."),
        FirmwareState.ANSWERING: tr("Idle: waiting for commands."),  # too brief to show
        FirmwareState.SPEEDS: tr("Setting speeds and reading them back from the servos."),
        FirmwareState.MOVING: tr("Moving: reads nothing until every servo has arrived."),
    }[snapshot.state]


def power_text(snapshot: RobotSnapshot) -> tuple[str, bool]:
    if not snapshot.power:
        return tr("The robot's switch is off: board and servos have no power."), False
    if not snapshot.servo_power:
        return tr("Servo power is off: no servo moves, holds its position or replies."), True
    text = tr("To stop a motion, switch off the servo power: the protocol has no stop command.")
    return text, snapshot.is_moving


def servo_text(servo: DemoServo, powered: bool) -> str:
    if not powered:
        activity = tr("no power")
    elif servo.dead:
        activity = tr("dead")
    elif not servo.torque:
        activity = tr("limp until its first goal")
    elif not servo.moving:
        activity = tr("holds")
    elif servo.cannot_move:
        activity = tr("cannot reach {0}").format(servo.goal)
    else:
        activity = tr("moving to {0}").format(servo.goal)
    return f"{position_text(servo.position)}, {activity}"
