"""One row of the joints: goal, present position, difference, speed, limits."""

from dataclasses import dataclass

from PySide6.QtCore import QEvent, QObject, QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QLabel, QWidget

from trex_gui.devices.aracna.protocol.joints import Limits
from trex_gui.devices.aracna.protocol.units import degrees, position
from trex_gui.devices.aracna.views.robot.boxes import DegreesBox, SpeedBox, UnitsBox
from trex_gui.devices.aracna.views.robot.joint_slider import JointSlider
from trex_gui.devices.aracna.views.robot.words import joint_text, position_text, spoken_joint
from trex_gui.ui.theme.theme import theme


@dataclass(frozen=True, slots=True)
class JointState:
    """What a row shows of what is known; `alarming` lets `words` stand out."""

    present: int | None
    words: str = ""
    alarming: bool = False
    tip: str = ""


class JointRow(QObject):
    """The widgets of one motor, for a grid to place; no state of its own.

    Signals:
        wanted: a goal in units.
        grabbed: a hand is on the slider.
        released: it is not any more.
        speed_wanted: a speed setting.
        limits_wanted: lowest and highest position.
        pointed: whether the mouse or the focus is on it.
    """

    wanted = Signal(int)
    grabbed = Signal()
    released = Signal()
    speed_wanted = Signal(int)
    limits_wanted = Signal(int, int)
    pointed = Signal(bool)

    def __init__(self, motor: int, parent: QWidget) -> None:
        super().__init__(parent)
        spoken = spoken_joint(motor)
        self.name = QLabel(joint_text(motor), parent)
        self.name.setObjectName(f"aracnaName{motor}")
        self.slider = JointSlider(parent)
        self.slider.setObjectName(f"aracnaSlider{motor}")
        self.slider.setAccessibleName(self.tr("{0}: goal").format(spoken))
        self.units = UnitsBox(
            f"aracnaGoal{motor}", self.tr("{0}: goal in units").format(spoken), parent
        )
        self.degrees = DegreesBox(
            f"aracnaDegrees{motor}", self.tr("{0}: goal in degrees").format(spoken), parent
        )
        self.present = QLabel(parent)
        self.present.setObjectName(f"aracnaPresent{motor}")
        self.present.setAccessibleName(self.tr("{0}: present position").format(spoken))
        self.present.setMinimumWidth(
            self.present.fontMetrics().horizontalAdvance(position_text(1023)) + 4
        )
        self.state = QLabel(parent)
        self.state.setObjectName(f"aracnaState{motor}")
        self.state.setAccessibleName(self.tr("{0}: how it goes").format(spoken))
        self.speed = SpeedBox(f"aracnaSpeed{motor}", self.tr("{0}: speed").format(spoken), parent)
        self.low = UnitsBox(
            f"aracnaLow{motor}", self.tr("{0}: lowest position").format(spoken), parent
        )
        self.high = UnitsBox(
            f"aracnaHigh{motor}", self.tr("{0}: highest position").format(spoken), parent
        )
        self._shown = JointState(None, "?")

        self.slider.valueChanged.connect(self._on_slid)
        self.slider.grabbed.connect(self.grabbed)
        self.slider.released.connect(self.released)
        self.units.valueChanged.connect(self.wanted)
        self.degrees.valueChanged.connect(self._on_degrees_changed)
        self.speed.valueChanged.connect(self.speed_wanted)
        for box in (self.low, self.high):
            box.valueChanged.connect(self._on_limits_changed)
        for widget in self.widgets:
            widget.installEventFilter(self)
            widget.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.show_state(JointState(None))

    @property
    def widgets(self) -> tuple[QWidget, ...]:
        """Its widgets, from left to right."""
        return (
            *(self.name, self.slider, self.units, self.degrees, self.present, self.state),
            *(self.speed, self.low, self.high),
        )

    def show_goal(self, goal: int) -> None:
        """Show where it is wanted; nothing is told of it."""
        with QSignalBlocker(self.units), QSignalBlocker(self.degrees):
            if self.slider.value() != goal:
                with QSignalBlocker(self.slider):
                    self.slider.setValue(goal)
            self.units.setValue(goal)
            if position(self.degrees.value()) != goal:
                self.degrees.setValue(degrees(goal))

    def show_limits(self, limits: Limits) -> None:
        """Let goals be within these."""
        with QSignalBlocker(self.slider):
            self.slider.set_limits(limits)
        for box, value in ((self.low, limits.low), (self.high, limits.high)):
            with QSignalBlocker(box):
                box.setValue(value)

    def show_speed(self, speed: int) -> None:
        """Show the speed that is wanted."""
        if self.speed.value() != speed:
            self.speed.setValue(speed)

    def show_state(self, state: JointState) -> None:
        """Show where it is and how it goes."""
        if state == self._shown:
            return
        self._shown = state
        self.slider.set_present(state.present)
        self.present.setText(position_text(state.present))
        self.state.setText(state.words)
        self.state.setToolTip(state.tip)
        font = self.state.font()
        font.setBold(state.alarming)
        self.state.setFont(font)
        self.renew_colours()

    def renew_colours(self) -> None:
        """Take the colours of the theme as it is now."""
        palette = self.name.palette()
        name = "danger" if self._shown.alarming else "window_text"
        palette.setColor(self.state.foregroundRole(), theme().color(name))
        self.state.setPalette(palette)

    def set_marked(self, marked: bool) -> None:
        """Let the name stand out: the joint is pointed at."""
        if marked != self.name.autoFillBackground():
            self.name.setBackgroundRole(self.name.palette().ColorRole.Highlight)
            self.name.setForegroundRole(
                self.name.palette().ColorRole.HighlightedText
                if marked
                else self.name.palette().ColorRole.WindowText
            )
            self.name.setAutoFillBackground(marked)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        match event.type():
            case QEvent.Type.HoverEnter | QEvent.Type.FocusIn:
                self.pointed.emit(True)
            case QEvent.Type.HoverLeave:
                self.pointed.emit(False)
            case _:
                pass
        return super().eventFilter(watched, event)

    def _on_slid(self, value: int) -> None:
        self.wanted.emit(value)

    def _on_degrees_changed(self, angle: float) -> None:
        self.wanted.emit(position(angle))

    def _on_limits_changed(self) -> None:
        self.limits_wanted.emit(self.low.value(), self.high.value())
