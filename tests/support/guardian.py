"""Guardian in virtual time, where no second process can open the port."""

from trex_gui.core.guardian.guardian import StopSequence


class VirtualGuardian:
    """Records its messages. It has acted once a test sets `has_acted`.

    Attributes:
        watched: received stop sequences in order. `None`: no motor may move.
        confirms: whether the board confirms the stop.
    """

    def __init__(self) -> None:
        self.is_ready = True
        self.has_acted = False
        self.has_ended = False
        self.confirms = False
        self.watched: list[StopSequence | None] = []

    def wait_until_ready(self, seconds: float) -> None:
        del seconds

    def watch(self, sequence: StopSequence | None) -> None:
        self.watched.append(sequence)

    def stop(self, seconds: float) -> bool:
        del seconds
        return self.confirms

    def end(self) -> bool:
        self.has_ended = True
        return self.has_acted and self.confirms
