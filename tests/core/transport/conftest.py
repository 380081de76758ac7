import os
from collections.abc import Iterator

import pytest


@pytest.fixture
def terminal() -> Iterator[tuple[int, str]]:
    """Return the master end of a pseudo-terminal, and the path of the slave."""
    master, slave = os.openpty()
    yield master, os.ttyname(slave)
    for end in (master, slave):
        os.close(end)
