"""Lease to drive, held by one client as long as its heartbeats arrive."""

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
    """A user who may connect, identified by a secret."""

    name: str
    role: Role
    secret: str


@dataclass(frozen=True, slots=True)
class Party:
    """A client of the server, and its user."""

    id: str  # of the client
    user: str
    role: Role


@dataclass(slots=True)
class Lease:
    """State of the lease. Times are in seconds of a monotonic clock.

    The caller stops the motors whenever a holder loses the lease.
    """

    holder: Party | None = None
    number: int = 0  # counts the holders, so that every new holder has a new number
    waiting: list[Party] = field(default_factory=list)  # in the order of their requests
    _alive_at: float = 0.0

    def request(self, party: Party, now: float) -> bool:
        """Grant a free lease to a party, or queue the party. Return whether it holds the lease."""
        if party.role < Role.DRIVE:
            return False
        if self.holder is None or self.holder == party:
            self._grant(party, now)
        elif party not in self.waiting:
            self.waiting.append(party)
        return self.holder == party

    def hand_over(self, by: Party, user: str, now: float) -> bool:
        """Hand the lease of `by` over to a user's waiting party. Return whether that succeeded."""
        heir = next((one for one in self.waiting if one.user == user), None)
        if heir is None or by != self.holder:
            return False
        self._grant(heir, now)
        return True

    def claim(self, by: Party, now: float) -> bool:
        """Take the lease from its holder, as only an owner may. Return whether that succeeded."""
        if by.role < Role.OWN:
            return False
        self._grant(by, now)
        return True

    def remove(self, party: Party) -> bool:
        """Remove a party. Return whether it held the lease, which is then free."""
        self.waiting = [one for one in self.waiting if one != party]
        if party != self.holder:
            return False
        self.holder = None
        return True

    def record_heartbeat(self, party: Party, now: float) -> None:
        if party == self.holder:
            self._alive_at = now

    def seconds_left(self, now: float) -> float:
        """Return the seconds until the lease ends without a heartbeat. Infinite if it is free."""
        if self.holder is None:
            return float("inf")
        return self._alive_at + LEASE_TIMEOUT - now

    def _grant(self, party: Party, now: float) -> None:
        if party != self.holder:
            self.holder, self.number = party, self.number + 1
        self.waiting = [one for one in self.waiting if one != party]
        self._alive_at = now
