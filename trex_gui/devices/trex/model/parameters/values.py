"""Stored, edited and active values of parameters."""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field

from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.parameters import ParameterSpec, other_motor_key
from trex_gui.devices.trex.settings.accepted import Accepted
from trex_gui.devices.trex.settings.comparison import ComparisonRow


@dataclass(slots=True)
class ParameterValues:
    """Wire values by key, from a board or a file."""

    specs: dict[str, ParameterSpec] = field(default_factory=dict)  # in the order of the table
    stored: dict[str, int] = field(default_factory=dict)
    edited: dict[str, int] = field(default_factory=dict)  # values that differ from `stored`
    removed: set[str] = field(default_factory=set)  # stored keys that Save omits
    active: dict[str, int] = field(default_factory=dict)  # values in use until a power cycle
    optional: frozenset[str] = frozenset()  # keys that may have no value in a file
    problems: dict[str, str] = field(default_factory=dict)  # error texts of failed reads and writes
    # Values outside inferred limits that boards with this firmware are known to store
    accepted: Accepted = field(default_factory=dict)

    def load(
        self,
        stored: Mapping[str, int],
        *,
        keep_edits: bool = False,
        power_cycled: bool = True,
        optional: Collection[str] = (),
    ) -> None:
        """Replace the stored values. `power_cycled` makes all of them active."""
        self.optional = frozenset(optional)
        self.stored = dict(stored)
        if power_cycled:
            self.active = {}
        if not keep_edits:
            self.edited, self.removed = {}, set()
        self.active = {k: w for k, w in self.active.items() if stored.get(k) != w}
        self.edited = {
            k: w for k, w in self.edited.items() if self.can_edit(k) and stored.get(k) != w
        }
        self.removed &= self.optional & stored.keys()

    def can_edit(self, key: str) -> bool:
        return key in self.stored or key in self.optional

    def can_remove(self, key: str) -> bool:
        return key in self.optional and self.value_of(key) is not None

    # --- Values -------------------------------------------------------------------------

    def value_of(self, key: str) -> int | None:
        """Return the value after Apply or Save. `None` if there is none."""
        if key in self.removed:
            return None
        return self.edited.get(key, self.stored.get(key))

    def active_of(self, key: str) -> int | None:
        return self.active.get(key, self.stored.get(key))

    @property
    def all_stored(self) -> dict[str, int]:
        return {key: self.stored[key] for key in self.specs if key in self.stored}

    @property
    def all_shown(self) -> dict[str, int]:
        """Values after Apply or Save."""
        return {key: w for key in self.specs if (w := self.value_of(key)) is not None}

    @property
    def pending(self) -> tuple[tuple[str, int], ...]:
        return tuple(self.edited.items())

    @property
    def modified(self) -> tuple[str, ...]:
        """Keys whose values are edited or removed."""
        return tuple(filter(self.is_modified, self.specs))

    @property
    def waiting_for_power(self) -> tuple[str, ...]:
        """Names of parameters whose stored values become active at a power cycle."""
        return tuple(spec.name for spec in self.specs.values() if spec.key in self.active)

    def is_modified(self, key: str) -> bool:
        return key in self.edited or key in self.removed

    def differs_from_default(self, key: str) -> bool:
        return self.value_of(key) not in {None, self.specs[key].default}

    def is_doubtful(self, key: str, wire: int) -> bool:
        """Return whether a value is outside inferred limits, and no board is known to store it."""
        is_known = wire in self.accepted.get(key, ()) or wire == self.stored.get(key)
        return self.specs[key].is_open(wire) and not is_known

    def doubtful(self, rows: Iterable[ComparisonRow]) -> list[str]:
        """Return the doubtful values as texts for the user."""
        return [
            tr("{0} {1}").format(row.name, row.after)
            for row in rows
            if isinstance(row.after, int) and self.is_doubtful(row.key, row.after)
        ]

    def other_motor_of(self, key: str) -> str | None:
        """Return the key of the same parameter for the other motor.

        `None` if either parameter is not editable.
        """
        other_motor = other_motor_key(key)
        if other_motor is None or not self.can_edit(key) or not self.can_edit(other_motor):
            return None
        return other_motor

    # --- Changes ------------------------------------------------------------------------

    def edit(self, spec: ParameterSpec, wire: int | None) -> None:
        """Edit a value. Setting the stored value or `None` removes the edit.

        Raises:
            BadRequest: the value exceeds a limit that is not inferred.
        """
        if wire is None or wire == self.stored.get(spec.key):
            self.edited.pop(spec.key, None)
        else:
            self.edited[spec.key] = spec.check(wire, forced=True)
        self.removed.discard(spec.key)

    def remove(self, key: str) -> None:
        """Remove an optional value. Ignore required parameters."""
        if key in self.optional:
            self.edited.pop(key, None)
            if key in self.stored:
                self.removed.add(key)

    def record_stored(self, spec: ParameterSpec, wire: int) -> None:
        before = self.stored.get(spec.key)
        if spec.needs_power_cycle and before is not None:
            self.active.setdefault(spec.key, before)
            if self.active[spec.key] == wire:
                del self.active[spec.key]
        self.stored[spec.key] = wire
        if self.edited.get(spec.key) == wire:
            del self.edited[spec.key]

    def record_active(self, key: str, wire: int) -> None:
        if self.stored.get(key) == wire:
            self.active.pop(key, None)
        elif key in self.stored:
            self.active[key] = wire
