"""Corruption of single packets on their way to a board."""

from collections.abc import Callable

from tests.support.virtual import SessionHarness


def corrupt_packet(
    harness: SessionHarness, start: bytes, corrupted: bytes, after: Callable[[], None] | None = None
) -> None:
    """Replace the start of the first packet that begins with `start`, then call `after`."""
    write, pending = harness.transport.write, [start]

    def corrupt(data: bytes) -> None:
        if not pending or not data.startswith(start):
            write(data)
            return
        write(corrupted + data[len(pending.pop()) :])
        if after is not None:
            after()

    harness.transport.write = corrupt  # type: ignore[method-assign]
