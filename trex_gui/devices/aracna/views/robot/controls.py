"""What is done with all joints at once: move, send while dragging, speeds, limits."""

from PySide6.QtCore import Signal, Slot
from PySide6.QtWidgets import QCheckBox, QGridLayout, QHBoxLayout, QLabel, QPushButton, QWidget

from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.model.targets import CENTRE
from trex_gui.devices.aracna.poses.gaits import STAND
from trex_gui.devices.aracna.views.robot.boxes import SpeedOfAllBox
from trex_gui.devices.aracna.views.robot.words import why_not_move
from trex_gui.devices.aracna.views.typed import take_typed
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.theme.theme import tint

_WIDEST_RATE = 888.8


class Controls(QWidget):
    """The strip below the joints.

    Signals:
        move_wanted: send the sliders' goals now.
        live_toggled: whether goals are sent while somebody drags.
        limits_toggled: whether limits are shown.
    """

    move_wanted = Signal()
    live_toggled = Signal(bool)
    limits_toggled = Signal(bool)

    def __init__(self, robot: Robot, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._robot = robot

        self._move = QPushButton(self.tr("Move"), self)
        self._move.setObjectName("aracnaMoveButton")
        self._move_tip = self.tr("Send every motor to its goal, within its limits (Ctrl+M)")
        font = self._move.font()
        font.setBold(True)
        self._move.setFont(font)
        tint(self._move, "run")
        set_icon(self._move, "run", "run_text")
        self._move.setMinimumWidth(8 * self.fontMetrics().averageCharWidth() + 60)
        self._live = QCheckBox(self.tr("Send while &dragging"), self)
        self._live.setObjectName("aracnaLiveBox")
        self._live.setToolTip(
            self.tr("The newest goal is sent as soon as the robot has finished the one before")
        )
        self._rate = QLabel(self)
        self._rate.setObjectName("aracnaRateLabel")
        widest = self.fontMetrics().horizontalAdvance(self._rate_text(_WIDEST_RATE))
        self._rate.setMinimumWidth(widest + 6)
        sliders = QLabel(self.tr("Set sliders to:"), self)
        self._present = self._button("Present", self.tr("Present"), self.tr("Where the motors are"))
        self._centre = self._button(
            "Centre", self.tr("Centre"), self.tr("512 = 150° everywhere; nothing moves yet")
        )
        self._stand = self._button(
            "Stand",
            self.tr("Stand"),
            self.tr("Inner 512, outer 680 as its authors say, within the limits; no motion yet"),
        )
        self._speed = SpeedOfAllBox("aracnaSpeedAll", self.tr("Speed of all motors"), self)
        speed_label = QLabel(self.tr("S&peed of all:"), self)
        speed_label.setBuddy(self._speed)
        self._limits = QCheckBox(self.tr("&Limits instead of speeds"), self)
        self._limits.setObjectName("aracnaLimitsBox")
        self._limits.setToolTip(self.tr("How far each joint may turn; enforced before sending"))
        self._factory = self._button(
            "FactoryLimits",
            self.tr("Reset limits"),
            self.tr("Inner 50–600, outer 0–550: tuned on the robot by its authors"),
        )

        first = QHBoxLayout()
        for widget in (self._move, self._live, self._rate):
            first.addWidget(widget)
        first.addStretch(1)
        second = QHBoxLayout()
        for widget in (sliders, self._present, self._centre, self._stand):
            second.addWidget(widget)
        second.addSpacing(16)
        second.addWidget(speed_label)
        second.addWidget(self._speed)
        second.addStretch(1)
        first.addWidget(self._factory)
        first.addWidget(self._limits)
        rows = QGridLayout(self)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.addLayout(second, 0, 0)
        rows.addLayout(first, 1, 0)

        self._move.clicked.connect(self.move_wanted)
        self._live.toggled.connect(self.live_toggled)
        self._limits.toggled.connect(self._on_limits_toggled)
        self._present.clicked.connect(self.take_present)
        self._centre.clicked.connect(self.centre)
        self._stand.clicked.connect(self.stand)
        self._factory.clicked.connect(robot.limits.reset)
        self._speed.valueChanged.connect(self._on_speed_wanted)
        robot.changed.connect(self._on_changed)
        robot.link_changed.connect(self._on_changed)
        robot.limits.changed.connect(self._on_changed)
        self._on_limits_toggled(shown=False)
        self._on_changed()

    @property
    def is_live(self) -> bool:
        """Whether goals are sent while somebody drags."""
        return self._live.isChecked()

    @property
    def can_move(self) -> bool:
        """Whether a robot is there that could, and nothing is played."""
        return not why_not_move(self._robot) and self._robot.playing is None

    @Slot()
    def take_present(self) -> None:
        """Set the sliders to where the motors are."""
        take_typed()
        pairs = zip(self._robot.present, self._robot.targets.goals, strict=False)
        self._robot.targets.set_all(
            [goal if present is None else present for present, goal in pairs]
        )

    @Slot()
    def centre(self) -> None:
        """Set the sliders to the middle of the servos' travel."""
        take_typed()
        self._robot.targets.set_all((CENTRE,) * self._robot.motors)

    @Slot()
    def stand(self) -> None:
        """Set the sliders to the authors' standing pose."""
        take_typed()
        self._robot.targets.set_all(STAND.first(self._robot.motors))

    def _button(self, name: str, text: str, tip: str) -> QPushButton:
        button = QPushButton(text, self)
        button.setObjectName(f"aracna{name}Button")
        button.setToolTip(tip)
        return button

    @Slot(bool)
    def _on_limits_toggled(self, shown: bool) -> None:
        self._factory.setVisible(shown)
        self.limits_toggled.emit(shown)

    @Slot(int)
    def _on_speed_wanted(self, speed: int) -> None:
        self._robot.set_speeds((speed,) * self._robot.motors)

    @Slot()
    def _on_changed(self) -> None:
        robot = self._robot
        self._move.setEnabled(self.can_move)
        self._move.setToolTip(why_not_move(robot) or self._move_tip)
        is_idle = robot.playing is None
        is_known = any(each is not None for each in robot.present)
        self._present.setEnabled(is_idle and is_known)
        for button in (self._centre, self._stand):
            button.setEnabled(is_idle)
        self._factory.setEnabled(not robot.limits.are_factory)
        self._speed.show_speeds(robot.speeds.wanted)
        rate = robot.rate
        self._rate.setText("" if rate is None else self._rate_text(rate))

    def _rate_text(self, rate: float) -> str:
        return self.tr("{0:.1f} commands a second").format(rate)
