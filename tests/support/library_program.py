"""Program that uses the library, in virtual time."""

from collections.abc import Callable

import click

from tests.support.virtual_time import VirtualRuntime
from trex_gui.core.host import Host


class Program:
    """Runs a function in a separate thread with the library's context."""

    def __init__(self, runtime: VirtualRuntime, run: Callable[[], object]) -> None:
        self.runtime = runtime
        self.error: BaseException | None = None
        self.has_ended = False
        host = Host(runtime.open_transport, runtime.condition, runtime.start_thread, runtime.now)

        def live() -> None:
            with click.Context(click.Command("program"), obj=host):
                try:
                    run()
                except BaseException as error:  # noqa: BLE001 - raised again in the test
                    self.error = error
            self.has_ended = True

        runtime.start_thread(live)

    def until(self, condition: Callable[[], object]) -> None:
        assert self.runtime.run_until(condition, 60)

    def end(self) -> None:
        self.until(lambda: self.has_ended)
        if self.error is not None:
            raise self.error
