"""Robot setup: steps, presets and edits."""

from collections.abc import Mapping, Sequence
from enum import Enum, auto
from functools import cache

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.resource_files import resource
from trex_gui.core.translation import tr
from trex_gui.devices.trex.driving.timeout_stop import with_shutdown
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.model.learning.preconditions import mode_blocker
from trex_gui.devices.trex.model.setup.pulses import MotorPulses
from trex_gui.devices.trex.model.setup.wiring import Driver, Movement, Wiring
from trex_gui.devices.trex.protocol.flags import channel_mask, channels_in
from trex_gui.devices.trex.protocol.parameters import MotorParameter, ParameterKey
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.ui.devices.connection import ConnectionState

LIMITS = tuple(MotorParameter.CURRENT_LIMIT.of(motor) for motor in (1, 2))

_RAMPS = (
    MotorParameter.ACCELERATION,
    MotorParameter.BRAKE_DURATION,
    MotorParameter.CURRENT_LIMIT_P,
)


class Preset(Enum):
    """Kind of robot. The value is the name of a sample file."""

    TANK = "tank_with_mix.txt"
    ROVER = "rover_with_serial_override.txt"
    AUTONOMOUS = "autonomous_robot.txt"

    @property
    def product(self) -> str:
        return _sample(self.value).product.key

    def values(self, model: str) -> Mapping[str, int]:
        """Return wire values by key for a model.

        Current limits are omitted if the sample is for another model, because units and ratings
        differ.
        """
        sample = _sample(self.value).parameters
        keys = [parameter.of(motor) for motor in (1, 2) for parameter in _RAMPS]
        return {key: sample[key] for key in (*keys, *(LIMITS if model == self.product else ()))}


@cache
def _sample(name: str) -> Settings:
    settings, _ = read_settings((resource("samples") / name).read_bytes(), name)
    return settings


_REVERSED = ParameterKey.REVERSED_CHANNELS
_STICKS = (1, 2)  # channels that drive the robot

TIMEOUT_WIRE = 5  # proposed serial timeout: 0.5 s, as in the samples

_PUSHED = 0.25  # minimum offset of a pushed stick, as a fraction of the channel's range


class SetupStep(Enum):
    DRIVER = auto()
    JUMPERS = auto()
    STICKS = auto()
    MOTORS = auto()
    LIMITS = auto()
    TIMEOUT = auto()
    REVIEW = auto()


class RobotSetup(QObject):
    """Assistant that sets up a robot in steps.

    Only `next` edits settings. Nothing is written to the board.
    """

    changed = Signal()

    def __init__(self, device: Device, learning: Learning, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.step = SetupStep.DRIVER
        self.driver = Driver.ONE_STICK
        self.movements: dict[int, Movement] = {}  # motor → movement that the user reported
        # Channel (1 or 2) → true if its input rises when the stick moves forward or right
        self.rises: dict[int, bool] = {}
        self.preset: Preset | None = None  # source of the ramps; `None` retains the board's ramps
        # Wire value for both motors; `None` retains the board's limits
        self.current_limit: int | None = None
        self.timeout = TIMEOUT_WIRE  # wire value of the serial timeout
        self.pulses = MotorPulses(device, self)
        self._device = device
        self._learning = learning
        self._completed: set[SetupStep] = set()  # steps that were completed with `next`

        learning.edited.connect(self._handle_learned)
        learning.stored.connect(self._handle_learned)
        device.link_changed.connect(self._on_link_changed)
        device.state_changed.connect(self.changed)
        device.motors.board_changed.connect(self._clear)
        device.draft.pending_changed.connect(self.changed)
        device.mix_jumper.changed.connect(self.changed)

    # --- State --------------------------------------------------------------------------

    @property
    def steps(self) -> tuple[SetupStep, ...]:
        left_out = SetupStep.TIMEOUT if self.driver.uses_sticks else SetupStep.STICKS
        return tuple(step for step in SetupStep if step is not left_out)

    @property
    def wiring(self) -> Wiring | None:
        return Wiring.from_movements(self.movements)

    @property
    def knows_sticks(self) -> bool:
        """True if the input directions of both drive channels are known."""
        return all(channel in self.rises for channel in _STICKS)

    @property
    def open_steps(self) -> Sequence[SetupStep]:
        return [
            step for step in self.steps if step is not SetupStep.REVIEW and not self._is_done(step)
        ]

    def _is_done(self, step: SetupStep) -> bool:
        device, driver = self._device, self.driver
        match step:
            case SetupStep.DRIVER:
                return True
            case SetupStep.JUMPERS if driver.uses_sticks and device.mix_jumper.is_on is not None:
                is_correct = device.mix_jumper.is_on is (driver is Driver.ONE_STICK)
                return is_correct and step in self._completed
            case SetupStep.STICKS:
                return self.knows_sticks
            case SetupStep.MOTORS if device.is_connected and device.board.is_joint:
                return True  # both outputs drive one motor
            case SetupStep.MOTORS:
                wiring = self.wiring
                if wiring is None or wiring.rewiring(driver):
                    return False
                knows_enough = self.knows_sticks or not driver.uses_sticks
                return knows_enough and not self._edits_of(step)
        return step in self._completed and not self._edits_of(step)

    @property
    def edits(self) -> Mapping[str, int]:
        return {} if self.blocker else self._edits_of(self.step)

    def _edits_of(self, step: SetupStep) -> Mapping[str, int]:
        parameters = self._device.parameters
        return {
            key: wire
            for key, wire in self._values_of(step).items()
            if parameters.values.can_edit(key) and parameters.values.value_of(key) != wire
        }

    @property
    def blocker(self) -> str:
        device = self._device
        if self.step not in {SetupStep.MOTORS, SetupStep.LIMITS, SetupStep.TIMEOUT}:
            return ""
        if not device.is_connected or device.state is None:
            return tr("Connect to a board first.")
        if device.writer.running:
            return tr("Settings are being written.")
        return mode_blocker(device)

    def _values_of(self, step: SetupStep) -> Mapping[str, int]:
        match step:
            case SetupStep.MOTORS:
                return self._directions()
            case SetupStep.LIMITS:
                limit = self.current_limit
                model = self._device.parameters.model_key
                values = {} if self.preset is None else self.preset.values(model)
                ramps = {key: wire for key, wire in values.items() if key not in LIMITS}
                return ramps | ({} if limit is None else dict.fromkeys(LIMITS, limit))
            case SetupStep.TIMEOUT:
                return with_shutdown(self.timeout)
        return {}

    def _directions(self) -> Mapping[str, int]:
        wiring, driver = self.wiring, self.driver
        if not (driver.uses_sticks and self.knows_sticks and wiring) or wiring.rewiring(driver):
            return {}
        to_reverse = wiring.channels_to_reverse(driver)
        reversed_ = set(channels_in(self._device.parameters.values.value_of(_REVERSED) or 0))
        sticks = {n for n in _STICKS if self.rises[n] == (n in to_reverse)}
        return {_REVERSED: channel_mask(reversed_.difference(_STICKS) | sticks)}

    # --- User actions -------------------------------------------------------------------

    def select_driver(self, driver: Driver) -> None:
        if driver is not self.driver:
            self.driver = driver
            self.rises.clear()  # a channel that meant right may now mean forward
            self._completed.discard(SetupStep.JUMPERS)
            self.changed.emit()

    def record_pushed(self, channels: Sequence[int]) -> tuple[int, ...]:
        """Record the direction of pushed sticks. Return the channels without a detected push."""
        for channel in channels:
            self.rises.pop(channel, None)
            raw = self._device.telemetry.raw_of(channel)
            calibration = self._device.calibrations.stored(channel)
            if raw is not None and calibration is not None:
                offset = raw - calibration.neutral
                if abs(offset) >= _PUSHED * (calibration.maximum - calibration.minimum):
                    self.rises[channel] = offset > 0
        self.changed.emit()
        return tuple(channel for channel in channels if channel not in self.rises)

    def record_movement(self, motor: int, movement: Movement) -> None:
        self.movements[motor] = movement
        self.changed.emit()

    def clear_movements(self) -> None:
        self.movements.clear()
        self.changed.emit()

    def select_preset(self, preset: Preset | None) -> None:
        model = self._device.parameters.model_key
        self.preset = preset
        self.current_limit = None
        if preset is not None and not self._device.board.is_joint:
            self.current_limit = preset.values(model).get(LIMITS[0])
        self.changed.emit()

    def select_current_limit(self, wire: int) -> None:
        self.current_limit = wire
        self.changed.emit()

    def select_timeout(self, wire: int) -> None:
        self.timeout = wire
        self.changed.emit()

    def next(self) -> None:
        """Edit the settings of this step, then open the next step."""
        if edits := self.edits:
            with self._device.draft.one_edit(tr("Set up my robot")):
                for key, wire in edits.items():
                    self._device.parameters.edit(key, wire, alone=True)
        if self.step is not SetupStep.JUMPERS or not self._device.writer.is_rejected:
            self._completed.add(self.step)
        self._move(1)

    def skip(self) -> None:
        self._completed.discard(self.step)
        self._move(1)

    def back(self) -> None:
        self._move(-1)

    def stop(self) -> None:
        self.pulses.stop(tr("The assistant was closed."))

    def go_to(self, step: SetupStep) -> None:
        if self.step is SetupStep.MOTORS and step is not self.step:
            self.pulses.stop(tr("Another step of the assistant was opened."))
        self.step = step
        self.changed.emit()

    def _move(self, offset: int) -> None:
        steps = self.steps
        index = steps.index(self.step) + offset
        if 0 <= index < len(steps):
            self.go_to(steps[index])

    # --- Signals from the device --------------------------------------------------------

    @Slot()
    def _handle_learned(self) -> None:
        for channel in self._learning.channels:
            if channel.can_be_used and channel.choice is not None and channel.number in _STICKS:
                self.rises[channel.number] = not channel.choice.reversed_
        self.changed.emit()

    @Slot()
    def _on_link_changed(self) -> None:
        if self._device.link is ConnectionState.DISCONNECTED:
            self._clear()
        self.changed.emit()

    @Slot()
    def _clear(self) -> None:
        self.movements.clear()
        self.rises.clear()
        self._completed.clear()
        self.preset = self.current_limit = None
