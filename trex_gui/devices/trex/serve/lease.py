"""Lease of a board. One client at a time may drive, as long as its heartbeats arrive."""

from dataclasses import dataclass, field
from enum import IntEnum

LEASE_TIMEOUT = 0.5  # seconds without a heartbeat; a robot at full speed moves 1 m in this time


class Role(IntEnum):
    """Permissions of a user. Each role includes the roles before it."""

    WATCH = 0  # watch and stop
    DRIVE = 1  # hold a lease that is free or handed over
    OWN = 2  # take the lease from its holder


@dataclass(frozen=True, slots=True)
class User:
    """User who may connect, identified by a secret."""

    name: str
    role: Role
    secret: str


@dataclass(frozen=True, slots=True)
class Party:
    """Identity of a client: its id, user and role."""

    id: str
    user: str
    role: Role


@dataclass(slots=True)
class Lease:
    """State of the lease. Times are in seconds of a monotonic clock.

    The caller must stop the motors whenever a holder loses the lease.
    """

    holder: Party | None = None
    number: int = 0  # increases with each new holder
    waiting: list[Party] = field(default_factory=list)  # in the order of their requests
    _alive_at: float = 0.0

    def request(self, party: Party, now: float) -> bool:
        """Grant a free lease, or queue the party. Return whether the party holds the lease."""
        if party.role < Role.DRIVE:
            return False
        if self.holder is None or self.holder == party:
            self._grant(party, now)
        elif party not in self.waiting:
            self.waiting.append(party)
        return self.holder == party

    def hand_over(self, by: Party, user: str, now: float) -> bool:
        """Hand the lease over to a waiting user. Return whether this succeeded.

        It fails if the user is not waiting, or if `by` does not hold the lease.
        """
        successor = next((party for party in self.waiting if party.user == user), None)
        if successor is None or by != self.holder:
            return False
        self._grant(successor, now)
        return True

    def claim(self, by: Party, now: float) -> bool:
        """Take the lease from its holder. Return False if `by` is not an owner."""
        if by.role < Role.OWN:
            return False
        self._grant(by, now)
        return True

    def remove(self, party: Party) -> bool:
        """Remove the party from the lease and the queue. Return whether it held the lease."""
        self.waiting = [other for other in self.waiting if other != party]
        if party != self.holder:
            return False
        self.holder = None
        return True

    def record_heartbeat(self, party: Party, now: float) -> None:
        if party == self.holder:
            self._alive_at = now

    def seconds_left(self, now: float) -> float:
        """Return the seconds until the lease times out, or infinity without a holder."""
        if self.holder is None:
            return float("inf")
        return self._alive_at + LEASE_TIMEOUT - now

    def _grant(self, party: Party, now: float) -> None:
        if party != self.holder:
            self.holder, self.number = party, self.number + 1
        self.waiting = [other for other in self.waiting if other != party]
        self._alive_at = now
