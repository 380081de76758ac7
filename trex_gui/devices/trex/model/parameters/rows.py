"""Rows of the parameter table: headings, and settings of both motors or of the board."""

from dataclasses import dataclass

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.parameters.text import ParameterColumn, ParameterText
from trex_gui.devices.trex.model.parameters.values import ParameterValues
from trex_gui.devices.trex.protocol.parameters import other_motor_key

_PINNED = "pinned"  # the group of the rows that the user has pinned to the top


@dataclass(frozen=True, slots=True)
class ParameterRow:
    """A heading, or one setting. `keys` has a key for each motor, or one key for the board."""

    group: str
    name: str = ""
    keys: tuple[str, ...] = ()

    @property
    def pin(self) -> str:
        """Key of a row in the preferences, without the motor."""
        return self.keys[0].removeprefix("motor1_")


class ParameterRows(list[ParameterRow]):
    """Pinned rows, then the other rows grouped by task."""

    def __init__(self, values: ParameterValues, text: ParameterText) -> None:
        super().__init__()
        self._values = values
        self._text = text
        self.places: dict[str, tuple[int, int]] = {}  # row and column by key
        self.pinned: tuple[str, ...] = ()  # by `ParameterRow.pin`
        self.titles = {
            _PINNED: tr("Pinned"),
            "motors": tr("Motors and speed ramp"),
            "braking": tr("Braking"),
            "current": tr("Current"),
            "pwm": tr("PWM"),
            "channels": tr("Inputs"),
            "serial": tr("Serial"),
            "system": tr("System"),
        }

    def arrange(self) -> None:
        groups: dict[str, list[ParameterRow]] = {group: [] for group in self.titles}
        for key, spec in self._values.specs.items():
            is_named_by_another = key != self._text.together(key)[-1] or key.startswith("motor2_")
            if not is_named_by_another:
                other = other_motor_key(key)
                keys = (key,) if other is None else (key, other)
                row = ParameterRow(spec.task, self._text.short_title(key), keys)
                if row.pin in self.pinned:
                    row = ParameterRow(_PINNED, row.name, keys)
                groups[row.group].append(row)
        groups[_PINNED].sort(key=lambda row: self.pinned.index(row.pin))
        self.clear()
        for group, rows in groups.items():
            if rows:
                self += [ParameterRow(group, self.titles[group]), *rows]
        self.places = {
            each: (place, column)
            for place, row in enumerate(self)
            for column, key in enumerate(row.keys, ParameterColumn.MOTOR1)
            for each in self._text.together(key)
        }

    def is_pinned(self, key: str) -> bool:
        return self[self.places[key][0]].group == _PINNED

    def with_toggled(self, key: str) -> tuple[str, ...]:
        """Return the pinned rows after the row of this key is pinned or unpinned."""
        pin = self[self.places[key][0]].pin
        others = [each for each in self.pinned if each != pin]
        return (*others,) if self.is_pinned(key) else (*others, pin)
