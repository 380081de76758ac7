"""Who drives: one client at a time, as long as its heartbeats arrive."""

from dataclasses import dataclass, field
from enum import IntEnum

LEASE_TIMEOUT = 0.5
"""Seconds without a heartbeat after which a lease ends and the motors are stopped.

A motor at full speed moves a robot by a metre in that time.
"""


class Role(IntEnum):
    """Permissions of a user. Each role includes the roles before it."""

    WATCH = 0  # see everything, stop, ask for the lease
    DRIVE = 1  # hold the lease when it is free or handed over
    OWN = 2  # take the lease from its holder


@dataclass(frozen=True, slots=True)
class User:
    """Somebody who may connect, known by a secret."""

    name: str
    role: Role
    secret: str


@dataclass(frozen=True, slots=True)
class Party:
    """One client of the server."""

    id: str  # of the client
    user: str
    role: Role


@dataclass(slots=True)
class Lease:
    """State of the lease. Times are in seconds of a monotonic clock.

    The caller stops the motors whenever `number` changes or the lease ends.
    """

    holder: Party | None = None
    number: int = 0  # counts the holders; a message with another number is of an earlier lease
    waiting: list[Party] = field(default_factory=list)  # those that asked, the first one first
    _alive_at: float = 0.0

    def request(self, party: Party, now: float) -> bool:
        """Give a free lease to a party, or let it wait. Return whether it holds the lease."""
        if party.role < Role.DRIVE:
            return False
        if self.holder is None or self.holder == party:
            self._grant(party, now)
        elif party not in self.waiting:
            self.waiting.append(party)
        return self.holder == party

    def hand_over(self, by: Party, user: str, now: float) -> bool:
        """Hand the lease of `by` to the waiting party of a user. Return whether it did."""
        heir = next((one for one in self.waiting if one.user == user), None)
        if heir is None or by != self.holder:
            return False
        self._grant(heir, now)
        return True

    def claim(self, by: Party, now: float) -> bool:
        """Take the lease from its holder, which only an owner may. Return whether it did."""
        if by.role < Role.OWN:
            return False
        self._grant(by, now)
        return True

    def remove(self, party: Party) -> bool:
        """Forget a party. Return whether it held the lease, which is free now."""
        self.waiting = [one for one in self.waiting if one != party]
        if party != self.holder:
            return False
        self.holder = None
        return True

    def record_heartbeat(self, party: Party, now: float) -> None:
        if party == self.holder:
            self._alive_at = now

    def seconds_left(self, now: float) -> float:
        """Return how long the lease lives without another heartbeat. Infinite if it is free."""
        if self.holder is None:
            return float("inf")
        return self._alive_at + LEASE_TIMEOUT - now

    def _grant(self, party: Party, now: float) -> None:
        if party != self.holder:
            self.holder, self.number = party, self.number + 1
        self.waiting = [one for one in self.waiting if one != party]
        self._alive_at = now
