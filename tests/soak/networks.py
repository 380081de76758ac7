"""Cut the network while motors are turning. The server at the robot must stop them.

Needs root for the network namespace of the driver. Each trial is a kind of cut and a program that
drives through `trexcmd serve`. The measured time ends at the motors of the simulated board.
"""

import os
import random
import shutil
import signal
import socket
import statistics
import subprocess
import sys
import tempfile
import time
from collections import defaultdict
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from tests.support.simulator import SimulatorProcess
from trex_gui.core.transport.urls import Address
from trex_gui.devices.trex.cli.serve import add_user

ROOT = Path(__file__).parents[2]
LIMIT = 0.6  # seconds from the cut to the stop of the motors
_WAIT = 20.0
_NET = f"10.{os.getpid() % 200}.{os.getpid() // 200 % 200}"
_SPACE = f"trex{os.getpid()}"
_HERE, _THERE = f"veth-h{os.getpid()}"[:15], f"veth-t{os.getpid()}"[:15]

_DRIVES = """
import sys
from trex_gui import Trex
with Trex(sys.argv[1]) as trex:
    trex.drive(50, 50)
    trex.wait(0.2)
    print("drives", flush=True)
    trex.wait(60)
"""
_ROUTER = """
import sys, time, zenoh
config = zenoh.Config()
config.insert_json5("mode", '"router"')
config.insert_json5("listen/endpoints", f'["tcp/{sys.argv[1]}"]')
config.insert_json5("connect/endpoints", f'["tcp/{sys.argv[2]}"]')
config.insert_json5("scouting/multicast/enabled", "false")
user, secret, users = sys.argv[3:]
ours = f'{{user: "{user}", password: "{secret}", dictionary_file: "{users}"}}'
config.insert_json5("transport/auth/usrpwd", ours)
with zenoh.open(config):
    print("routes", flush=True)
    time.sleep(600)
"""


def _ip(*words: str) -> None:
    subprocess.run(["ip", *words], check=True, capture_output=True)


@contextmanager
def namespace() -> Iterator[None]:
    """Create a network of two hosts. This host has address 1, the namespace address 2."""
    _ip("netns", "add", _SPACE)
    try:
        _ip("link", "add", _HERE, "type", "veth", "peer", "name", _THERE, "netns", _SPACE)
        _connect()
        yield
    finally:
        _ip("netns", "del", _SPACE)


def _connect() -> None:
    """Restore the network after any cut."""
    inside = "netns", "exec", _SPACE, "ip"
    _ip("addr", "replace", f"{_NET}.1/24", "dev", _HERE)
    _ip("link", "set", _HERE, "up")
    _ip(*inside, "addr", "replace", f"{_NET}.2/24", "dev", _THERE)
    _ip(*inside, "link", "set", _THERE, "up")
    _ip(*inside, "link", "set", "lo", "up")
    for words, device in (((), _HERE), (inside, _THERE)):
        _ip(*words, "neigh", "flush", "dev", device, "nud", "permanent")


def _link_down(_driver: int, _router: int) -> None:
    _ip("netns", "exec", _SPACE, "ip", "link", "set", _THERE, "down")


def _lose_all(_driver: int, _router: int) -> None:
    """Drop all packets while both ends see a working link."""
    wrong = "lladdr", "02:00:00:00:00:01", "dev"
    inside = "netns", "exec", _SPACE, "ip"
    _ip(*inside, "neigh", "replace", f"{_NET}.1", *wrong, _THERE)
    _ip("neigh", "replace", f"{_NET}.2", *wrong, _HERE)


def _asleep(driver: int, router: int) -> None:
    os.kill(driver, signal.SIGSTOP)
    _link_down(driver, router)


CUTS: dict[str, Callable[[int, int], None]] = {
    "link down": _link_down,
    "all packets lost": _lose_all,
    "killed": lambda driver, _: os.kill(driver, signal.SIGKILL),
    "suspended": lambda driver, _: os.kill(driver, signal.SIGSTOP),
    "asleep": _asleep,
    "router killed": lambda _, router: os.kill(router, signal.SIGKILL),
}


def _wait(happened: Callable[[], object], what: str) -> float:
    begun = time.monotonic()
    while not happened():
        if time.monotonic() > begun + _WAIT:
            raise TimeoutError(what)
        time.sleep(0.002)
    return time.monotonic() - begun


def _turns(board: SimulatorProcess) -> bool:
    return any(motor["direction"] != "brake" for motor in board.show()["motors"])


class Networks:
    """A served board, and drivers in another network namespace."""

    def __init__(self, stack: ExitStack, folder: Path) -> None:
        self.board = SimulatorProcess()
        stack.callback(self.board.end)
        self._environment = {**os.environ, "TREX_STUDIO_DATA": str(folder)}
        self._users = folder / "users"
        self._secret = add_user(self._users, "driver", "drive")
        self._dictionary = folder / "dictionary"  # for the engine of the router
        self._dictionary.write_text(f"driver:{self._secret}\n", "utf-8")
        self._stack = stack
        with socket.socket() as found:
            found.bind(("", 0))
            self._port = found.getsockname()[1]
        words = ["serve", "--port", self.board.url, "--name", "arm", "--users", str(self._users)]
        self._start(
            [sys.executable, "-m", "trex_gui.cli", *words, "--listen", f"{_NET}.1:{self._port}"]
        )
        time.sleep(2.0)

    def _start(self, command: list[str]) -> "subprocess.Popen[str]":
        process = subprocess.Popen(
            command,
            cwd=ROOT,
            env={**self._environment, "TREX_SECRET": self._secret},
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )
        self._stack.callback(process.wait)
        self._stack.callback(process.kill)
        return process

    def trial(self, cut: str) -> float:
        """Cut the network while a program drives. Return the seconds until the motors stopped."""
        port, router = self._port, None
        if cut == "router killed":
            port += 1
            ends = f"{_NET}.1:{port}", f"{_NET}.1:{self._port}"
            words = *ends, "driver", self._secret, str(self._dictionary)
            router = self._start([sys.executable, "-c", _ROUTER, *words])
            assert router.stdout is not None
            router.stdout.readline()
        url = Address(f"{_NET}.1", "arm", "driver", port).url
        inside = ["ip", "netns", "exec", _SPACE]
        driver = self._start([*inside, sys.executable, "-c", _DRIVES, url])
        try:
            assert driver.stdout is not None
            if driver.stdout.readline() != "drives\n":
                raise TimeoutError("it never drove")
            time.sleep(random.random() / 5)
            CUTS[cut](driver.pid, router.pid if router else 0)
            return _wait(lambda: not _turns(self.board), "it was never stopped")
        finally:
            for process in filter(None, (driver, router)):
                process.kill()
                process.wait()
                if process.stdout is not None:
                    process.stdout.close()
            _connect()


def run(seconds: float, seed: int) -> list[str]:
    """Cut the network in random ways. Return the failures."""
    if not shutil.which("ip") or os.geteuid() != 0:
        print("networks: needs root and ip, left out")
        return []
    chance, end = random.Random(seed), time.monotonic() + seconds
    took: dict[str, list[float]] = defaultdict(list)
    short: list[str] = []
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="trex-net")))
        stack.enter_context(namespace())
        networks = Networks(stack, folder)
        while time.monotonic() < end:
            cut = chance.choice(list(CUTS))
            try:
                took[cut].append(networks.trial(cut))
            except (TimeoutError, AssertionError) as error:
                short.append(f"{cut}: {error}")
                continue
            if took[cut][-1] > LIMIT:
                short.append(f"{cut}: {took[cut][-1]:.3f} s")
    for cut, times in sorted((cut, times) for cut, times in took.items() if times):
        median, worst = statistics.median(times), max(times)
        print(f"{cut}: {len(times)} trials, median {median:.3f} s, worst {worst:.3f} s")
    return short
