"""A working copy beside the device's: what is stored, and what would be written."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field

from trex_gui.devices.trex.protocol.parameters import ParameterSpec


@dataclass(slots=True)
class Draft:
    """What the device stores and what we would write; dirty is the difference.

    Attributes:
        stored: wire value by key, as read back.
        edited: wire value by key where it differs from what is stored.
        removed: keys that are stored and would be left out; only an open-ended draft has them.
        active: wire value that is still in force by key, for what was stored since the last
            power cycle and acts only after the next.
        open_to: keys that need not be stored to be edited, nor stay; empty for a board, which
            stores each of its parameters.
    """

    stored: dict[str, int] = field(default_factory=dict)
    edited: dict[str, int] = field(default_factory=dict)
    removed: set[str] = field(default_factory=set)
    active: dict[str, int] = field(default_factory=dict)
    open_to: frozenset[str] = frozenset()

    def load(
        self,
        stored: Mapping[str, int],
        *,
        keep_edits: bool = False,
        power_cycled: bool = True,
        open_to: Collection[str] = (),
    ) -> None:
        """Take everything that was read from a device, or that a file gives.

        With `power_cycled`, what was stored is taken to be in force now.
        """
        pending = dict(self.edited) if keep_edits else {}
        unwanted = set(self.removed) if keep_edits else set()
        self.open_to = frozenset(open_to)
        self.stored = dict(stored)
        self.active = (
            {} if power_cycled else {k: w for k, w in self.active.items() if stored.get(k) != w}
        )
        self.edited = {k: w for k, w in pending.items() if self.takes(k) and stored.get(k) != w}
        self.removed = unwanted & self.open_to & stored.keys()

    def takes(self, key: str) -> bool:
        """Whether a value can be edited."""
        return key in self.stored or key in self.open_to

    def value(self, key: str) -> int | None:
        """What would be in the device after Apply; `None` when it was not read, or left out."""
        if key in self.removed:
            return None
        return self.edited.get(key, self.stored.get(key))

    def is_modified(self, key: str) -> bool:
        """Whether the edited value differs from the stored one."""
        return key in self.edited or key in self.removed

    def edit(self, spec: ParameterSpec, wire: int | None) -> None:
        """Take an edit; editing back to the stored value, or `None`, forgets it.

        Raises:
            BadRequest: the table does not allow the value.
        """
        if wire is None or wire == self.stored.get(spec.key):
            self.edited.pop(spec.key, None)
        else:
            self.edited[spec.key] = spec.check(wire)
        self.removed.discard(spec.key)

    def leave_out(self, key: str) -> None:
        """Wish that nothing be given for a key; without effect where each has a value."""
        if key in self.open_to:
            self.edited.pop(key, None)
            if key in self.stored:
                self.removed.add(key)

    def note_stored(self, spec: ParameterSpec, wire: int) -> None:
        """Take what was read back after a write."""
        before = self.stored.get(spec.key)
        if spec.needs_power_cycle and before is not None:
            active = self.active.setdefault(spec.key, before)
            if active == wire:
                del self.active[spec.key]
        self.stored[spec.key] = wire
        if self.edited.get(spec.key) == wire:
            del self.edited[spec.key]

    def note_in_force(self, key: str, wire: int) -> None:
        """Take what is surely in force now, whatever is stored for the next start."""
        if key in self.stored:
            if self.stored[key] == wire:
                self.active.pop(key, None)
            else:
                self.active[key] = wire

    @property
    def pending(self) -> tuple[tuple[str, int], ...]:
        """What Apply would write: key and wire value."""
        return tuple(self.edited.items())
