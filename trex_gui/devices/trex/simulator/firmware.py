"""Simulated board with modes, safety functions and motors. Its UART is in `uart`.

Ref: TReX 1.0 command documentation; Pololu TReX User's Guide 4, 5.
"""

from collections import Counter
from functools import cache

from trex_gui.core.simulator.timeline import EPSILON
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.errors import ResultCode
from trex_gui.devices.trex.protocol.flags import (
    MOTOR_FAULTS,
    OVER_LIMITS,
    InputSource,
    Mode,
    UartError,
)
from trex_gui.devices.trex.protocol.parameters import MotorParameter, ParameterKey
from trex_gui.devices.trex.simulator.boot_modes import BootMode, boot_mode
from trex_gui.devices.trex.simulator.channel_control import ChannelControl
from trex_gui.devices.trex.simulator.channels import TICK, Channels
from trex_gui.devices.trex.simulator.memory import Eeprom, Memory
from trex_gui.devices.trex.simulator.motors import (
    FULL_SPEED,
    AuxiliaryMotor,
    Motor,
    MotorDirection,
    MotorSettings,
    SerialControl,
)
from trex_gui.devices.trex.simulator.physics import DriverOutput, Machine

MODE_JUMPERS = ("serial", "rc", "analog")

_UPDATE_TICKS = 4  # ticks between two updates of motors and safety: 100 updates a second

# Ticks between two current readings: 80 (RC) or 50 (analog) readings a second
_CURRENT_TICKS = {InputSource.RC: 5, InputSource.ANALOG: 8}

_MOTOR_KEYS = {
    number: [MotorParameter(name).of(number) for name in MotorSettings._fields] for number in (1, 2)
}
_COUNTERS = (
    "power_ups",
    "brown_outs",
    "bytes_received",
    "bytes_missed",
    "bytes_sent",
    "bytes_garbled",
    "packets",
    "packets_for_others",
)


class Board:
    """Controller with motors, receiver and jumpers.

    `serial` executes serial motor commands and contains the latched bits. `sticks` drives the
    motors from the channels, with serial override and safe-start.
    """

    def __init__(
        self,
        model: str = "trex",
        firmware: str = "1.2",
        *,
        eeprom: Eeprom | None = None,
        mode: str = "serial",
        mix: bool = False,
        seed: int = 0,
    ) -> None:
        self.eeprom = eeprom if eeprom is not None else Eeprom(model)
        self.model = self.eeprom.model
        self.firmware = firmware
        self.memory = Memory(self.eeprom, firmware)
        if mode not in MODE_JUMPERS:
            raise ValueError(f"the mode jumper must be {', '.join(MODE_JUMPERS)}, not {mode!r}")
        self.mode_jumper = mode  # one of `MODE_JUMPERS`, read at power-up
        self.mix = mix  # True if the mix jumper is set; read continuously
        self.so_ground = False
        self.now = self.powered_at = 0.0  # seconds since the start
        self.powered = False
        self.boots = 0  # number of power-ups
        # True if the serial timeout stops motors only while UART-Error Shutdown is on. The command
        # documentation mentions no such condition, but it exists on the twin, a qik 2s12v10.
        self.timeout_needs_shutdown = False
        self.unknown_reply = b""  # reply to a read of an unknown parameter
        self.rejection_is_error = False  # True if a rejected write is also a format error
        self.channels = Channels(InputSource.RC, seed)
        self.machine = Machine(self.model.key, self.model.current_unit, seed)
        self.physics = self.machine.motors
        self._initial_jumpers = (mode, mix)
        self.is_starved = False  # True if the board is switched on, but the battery is too low
        self.counters: Counter[str] = Counter(dict.fromkeys(_COUNTERS, 0))
        self._ticks = 0
        self.power_on()

    # Power

    def power_on(self) -> None:
        """Switch on. Read jumpers, activate stored parameters and clear latched bits."""
        self.is_starved = self.machine.is_browned_out
        if self.powered or self.is_starved:
            return
        self.powered = True
        self.powered_at = self.now
        self.boots += 1
        self.counters["power_ups"] += 1
        self.memory.load()
        jumpers = {"rc": Mode.RC, "analog": Mode.ANALOG}
        self.mode = jumpers.get(self.mode_jumper, self.memory.serial_mode)
        self.channels.start(self.mode.source)
        self._clear()
        self.boot_mode: BootMode | None = boot_mode(self)  # `None` in normal operation

    def power_off(self) -> None:
        """Switch off. The motors coast, and an unfinished write is lost."""
        self.is_starved = False
        self._lose_power()

    def _lose_power(self) -> None:
        self.powered = False
        self.boot_mode = None
        self.memory.lose_write()
        self.channels.start(self.mode.source)
        self._clear()
        for physics in self.physics:
            physics.clear_reading()

    def power_cycle(self) -> None:
        self.power_off()
        self.power_on()

    def factory_reset(self) -> None:
        self.power_off()
        self.eeprom.factory_reset()
        self.mode_jumper, self.mix = self._initial_jumpers
        self.so_ground = False
        self.channels.reset_signals()
        self.machine.factory_reset()
        self.power_on()

    def _clear(self) -> None:
        self.motors = (Motor(), Motor())
        self.aux = AuxiliaryMotor()
        self.serial = SerialControl(
            self.motors,
            self.aux,
            joint=self.memory.is_joint,
            in_control=self.powered and self.mode.is_serial,
        )
        self.sticks = ChannelControl(self.channels, self.memory, self.mode)
        self.receiving = False  # True while a packet is incomplete; an LED shows this

    @property
    def is_running(self) -> bool:
        return self.powered and self.boot_mode is None

    # Time

    def advance(self, seconds: float) -> None:
        end = self.now + seconds
        while True:
            next_tick = (self._ticks + 1) * TICK
            write_time = self.memory.busy_for
            until = min(next_tick, self.now + write_time) if write_time else next_tick
            if until > end + EPSILON:
                break
            self._advance_to(until)
            if until == next_tick:
                self._tick()
        self._advance_to(end)

    def _advance_to(self, until: float) -> None:
        if until > self.now:
            seconds, self.now = until - self.now, until
            self.memory.advance(seconds)

    def _tick(self) -> None:
        self._ticks += 1
        if self.powered:
            self.channels.tick()
            if self._ticks % _UPDATE_TICKS == 0:
                self._update()
        self.machine.advance(
            TICK, [_driver_output(motor.direction, motor.speed) for motor in self.motors]
        )
        self._check_supply()
        if self.powered and self._ticks % _CURRENT_TICKS[self.mode.source] == 0:
            for physics in self.physics:
                if self.memory.is_joint:
                    physics.clear_reading()  # joint mode has no current sensing
                else:
                    physics.measure()

    def _check_supply(self) -> None:
        if self.powered and self.machine.is_browned_out:
            self.counters["brown_outs"] += 1
            self._lose_power()
            self.is_starved = True
        elif self.is_starved and not self.machine.is_browned_out:
            self.power_on()

    def _update(self) -> None:
        if self.boot_mode is not None:
            self.boot_mode.update(TICK * _UPDATE_TICKS)
            if self.boot_mode.is_over:
                self.boot_mode = None
            return
        self._update_control()
        self.serial.check_timeout(
            self.now,
            self.memory.active[ParameterKey.SERIAL_TIMEOUT],
            shut_down=self._stops_on_timeout,
        )
        self._latch_faults()
        for number, motor, physics in zip((1, 2), self.motors, self.physics, strict=True):
            if motor.update(self._motor_settings(number), physics.reading):
                self.serial.status |= OVER_LIMITS[number]
        self.aux.update(self.memory.active[ParameterKey.AUX_ACCELERATION])

    def _motor_settings(self, number: int) -> MotorSettings:
        settings = MotorSettings(*map(self.memory.active.__getitem__, _MOTOR_KEYS[number]))
        return settings._replace(current_limit=0) if self.memory.is_joint else settings

    # Channels

    @property
    def remapped(self) -> tuple[int, ...]:
        """Reply to 0x87, -127 to 127. The first two values are for motors 1 and 2."""
        return self.sticks.remapped(mix=self.mix)

    def _update_control(self) -> None:
        timeout = self.memory.active[ParameterKey.SERIAL_TIMEOUT]
        self.serial.set_control(
            self.now, timeout, in_control=self.sticks.update(), shut_down=self._stops_on_timeout
        )
        if self.serial.in_control:
            return
        if self.sticks.safe_start:
            self.serial.stop_motors()
        else:
            self.sticks.drive(self.motors, self.aux, mix=self.mix)

    # Serial port

    def record_byte(self) -> None:
        self.counters["bytes_received"] += 1
        self.serial.last_byte = self.now

    def report_error(self, error: UartError) -> None:
        self.serial.report(error, shut_down=self._shuts_down)

    @property
    def _shuts_down(self) -> bool:
        return bool(self.memory.active[ParameterKey.UART_ERROR_SHUTDOWN])

    @property
    def _stops_on_timeout(self) -> bool:
        return self._shuts_down or not self.timeout_needs_shutdown

    def set_parameter(self, number: int, value: int) -> ResultCode:
        return self._checked(self.memory.set(number, value, self.mode))

    def calibration(self, channel: int) -> Calibration:
        return self.eeprom.calibration(self.mode.source, channel)

    def set_calibration(self, channel: int, calibration: Calibration) -> ResultCode:
        return self._checked(self.memory.set_calibration(channel, calibration, self.mode))

    def _checked(self, result: ResultCode) -> ResultCode:
        if result is not ResultCode.OK and self.rejection_is_error:
            self.report_error(UartError.FORMAT)
        return result

    # Environment

    def set_fault(self, number: int, *, fault: bool) -> None:
        self.physics[number - 1].fault = fault
        if self.powered:
            self._latch_faults()

    def force_current(self, number: int, amperes: float | None) -> None:
        """Force the measured current of motor 1 or 2. `None` restores the measurement."""
        physics = self.physics[number - 1]
        physics.forced = amperes
        if self.powered and not self.memory.is_joint and amperes is not None:
            physics.measure()

    def _latch_faults(self) -> None:
        for flag, physics in zip(MOTOR_FAULTS.values(), self.physics, strict=True):
            if physics.fault:
                self.serial.status |= flag


@cache
def _driver_output(direction: MotorDirection, speed: int) -> DriverOutput:
    """Return the output of a motor driver. Inferred: the duty cycle is speed / 127."""
    duty = speed / FULL_SPEED
    if direction is MotorDirection.BRAKE:
        return DriverOutput(brake=duty)
    return DriverOutput(duty if direction is MotorDirection.FORWARD else -duty)
