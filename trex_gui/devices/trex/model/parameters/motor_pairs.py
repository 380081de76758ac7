"""Which parameters are the same thing for the one motor and for the other."""

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
