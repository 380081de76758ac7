"""Stored, edited and active values of parameters."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field

from trex_gui.devices.trex.protocol.parameters import ParameterSpec


@dataclass(slots=True)
class Draft:
    """Wire values by key: those of a board or a file, and the edits that Apply or Save writes."""

    stored: dict[str, int] = field(default_factory=dict)
    edited: dict[str, int] = field(default_factory=dict)  # values that differ from `stored`
    removed: set[str] = field(default_factory=set)  # stored keys that Save leaves out
    active: dict[str, int] = field(default_factory=dict)  # unlike `stored` until a power cycle
    optional: frozenset[str] = frozenset()  # keys that may have no value, as those of a file

    def load(
        self,
        stored: Mapping[str, int],
        *,
        keep_edits: bool = False,
        power_cycled: bool = True,
        optional: Collection[str] = (),
    ) -> None:
        """Replace the stored values; `power_cycled` makes all of them active."""
        self.optional = frozenset(optional)
        self.stored = dict(stored)
        if power_cycled:
            self.active = {}
        if not keep_edits:
            self.edited, self.removed = {}, set()
        self.active = {k: w for k, w in self.active.items() if stored.get(k) != w}
        self.edited = {
            k: w for k, w in self.edited.items() if self.accepts(k) and stored.get(k) != w
        }
        self.removed &= self.optional & stored.keys()

    def accepts(self, key: str) -> bool:
        """Whether the parameter can be edited."""
        return key in self.stored or key in self.optional

    def value(self, key: str) -> int | None:
        """Return the value after Apply or Save; `None`: not read, or left out."""
        if key in self.removed:
            return None
        return self.edited.get(key, self.stored.get(key))

    def is_modified(self, key: str) -> bool:
        return key in self.edited or key in self.removed

    def edit(self, spec: ParameterSpec, wire: int | None) -> None:
        """Edit a value; the stored value, or `None`, drops the edit.

        Raises:
            BadRequest: the value is outside limits that are not inferred.
        """
        if wire is None or wire == self.stored.get(spec.key):
            self.edited.pop(spec.key, None)
        else:
            self.edited[spec.key] = spec.check(wire, forced=True)
        self.removed.discard(spec.key)

    def leave_out(self, key: str) -> None:
        """Give an optional parameter no value; has no effect on others."""
        if key in self.optional:
            self.edited.pop(key, None)
            if key in self.stored:
                self.removed.add(key)

    def note_stored(self, spec: ParameterSpec, wire: int) -> None:
        """Take a value that was read back after a write."""
        before = self.stored.get(spec.key)
        if spec.needs_power_cycle and before is not None:
            self.active.setdefault(spec.key, before)
            if self.active[spec.key] == wire:
                del self.active[spec.key]
        self.stored[spec.key] = wire
        if self.edited.get(spec.key) == wire:
            del self.edited[spec.key]

    def note_active(self, key: str, wire: int) -> None:
        """Take a value that is known to be active, whatever is stored."""
        if self.stored.get(key) == wire:
            self.active.pop(key, None)
        elif key in self.stored:
            self.active[key] = wire

    @property
    def pending(self) -> tuple[tuple[str, int], ...]:
        """Keys and values that Apply or Save writes."""
        return tuple(self.edited.items())
