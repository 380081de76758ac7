"""The keys of the parameters that code refers to; the others are only in the parameter table."""

from enum import StrEnum


class ParameterKey(StrEnum):
    """A parameter's key in the table and in settings files."""

    AUX_ACCELERATION = "aux_acceleration"
    CHANNEL_INPUT_SOURCE = "channel_input_source"
    CRC7_POLYNOMIAL = "crc7_polynomial"
    DEVICE_NUMBER = "device_number"
    FACTORY_RESET = "factory_reset"
    IGNORED_CHANNELS = "ignored_channels"
    MOTOR_MODE = "motor_mode"
    PARABOLIC_CHANNELS = "parabolic_channels"
    REQUIRED_CHANNELS = "required_channels"
    REVERSED_CHANNELS = "reversed_channels"
    SERIAL_TIMEOUT = "serial_timeout"
    UART_ERROR_SHUTDOWN = "uart_error_shutdown"
    UART_RESPONSE_DELAY = "uart_response_delay"
    UART_SETTINGS = "uart_settings"


class MotorParameter(StrEnum):
    """A parameter that each motor has; the value follows `motor1_` or `motor2_` in the key."""

    ACCELERATION = "acceleration"
    BRAKE_DURATION = "brake_duration"
    CURRENT_LIMIT = "current_limit"
    CURRENT_LIMIT_P = "current_limit_p"
    DEADBAND_BRAKE_PWM = "deadband_brake_pwm"
    PWM_MAXIMUM = "pwm_maximum"
    PWM_PRESCALER = "pwm_prescaler"

    def of(self, motor: int) -> str:
        """Return the key for motor 1 or 2."""
        return f"motor{motor}_{self}"


_PREFIXES = {"motor1_": "motor2_", "motor2_": "motor1_"}
_NAMES = {"motor1": "Motor 1", "motor2": "Motor 2"}


def other_motor_key(key: str) -> str | None:
    """Return the key that the other motor's parameter would have; `None`: of no single motor."""
    for own, other in _PREFIXES.items():
        if key.startswith(own):
            return other + key.removeprefix(own)
    return None


def motor_name(key: str) -> str:
    """Return what people call the motor of a key, such as `Motor 1`; empty for none."""
    return _NAMES.get(key.partition("_")[0], "")
