"""`trexcmd` in virtual time."""

import signal
from collections.abc import Callable, Sequence

import greenlet
from click.testing import CliRunner, Result

from tests.support.virtual_time import VirtualRuntime
from trex_gui.cli import main
from trex_gui.core.host import Host

TIMEOUT = 3600.0
"""Virtual seconds after which a command has hung."""


class VirtualCommand:
    """Run of `trexcmd` with the methods of `subprocess.Popen` that tests use.

    Attributes:
        returncode: exit code, or `None` while it runs.
    """

    def __init__(
        self,
        runtime: VirtualRuntime,
        arguments: Sequence[str],
        environment: dict[str, str | None],
        stdin: str | None = None,
    ) -> None:
        self.returncode: int | None = None
        self._runtime = runtime
        self._result: Result | None = None
        host = Host(runtime.open_transport, runtime.condition, runtime.start_thread, runtime.now)

        def run() -> None:
            self._task = greenlet.getcurrent()
            self._result = CliRunner().invoke(
                main, list(arguments), env=environment, input=stdin, obj=host
            )
            self.returncode = self._result.exit_code

        runtime.start_thread(run)

    def poll(self) -> int | None:
        return self.returncode

    def send_signal(self, number: int) -> None:
        """Raise a signal. An exception of its handler ends the command."""
        try:
            signal.raise_signal(number)
        except KeyboardInterrupt as error:
            self._task.throw(error)

    def terminate(self) -> None:
        self.send_signal(signal.SIGTERM)

    def wait(self, timeout: float = TIMEOUT) -> int:
        """Let time pass until the command has ended. Return its exit code."""
        assert self._runtime.run_until(lambda: self.returncode is not None, timeout)
        assert self.returncode is not None
        return self.returncode

    def communicate(self, timeout: float = TIMEOUT) -> tuple[str, str]:
        """Let time pass until the command has ended. Return stdout and stderr."""
        self.wait(timeout)
        return self.result.stdout, self.result.stderr

    def ends(self, exit_code: int) -> Result:
        """Let time pass until the command has ended. Check its exit code."""
        assert self.wait() == exit_code, self.result.output
        return self.result

    @property
    def result(self) -> Result:
        assert self._result is not None
        return self._result


StartCommand = Callable[..., VirtualCommand]
RunCommand = Callable[..., Result]
