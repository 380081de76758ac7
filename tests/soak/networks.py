"""Cut the network while motors are turning. The server at the robot must stop them.

Root is needed for the network namespace of the driver. Each trial cuts the connection of a program
that drives through `trexcmd serve`. The measured time ends when the motors of the board stop.
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

from tests.soak.deaths import turns, wait
from tests.support.simulator import SimulatorProcess
from trex_gui.core.transport.urls import Address
from trex_gui.devices.trex.cli.serve import add_user

ROOT = Path(__file__).parents[2]
LIMIT = 0.6  # seconds from the cut to the stop of the motors
_NET = f"10.{os.getpid() % 200}.{os.getpid() // 200 % 200}"
_NAMESPACE = f"trex{os.getpid()}"
_HOST_LINK, _DRIVER_LINK = f"veth-h{os.getpid()}"[:15], f"veth-t{os.getpid()}"[:15]

_DRIVER = """
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
    _ip("netns", "add", _NAMESPACE)
    try:
        _ip(
            "link",
            "add",
            _HOST_LINK,
            "type",
            "veth",
            "peer",
            "name",
            _DRIVER_LINK,
            "netns",
            _NAMESPACE,
        )
        _connect()
        yield
    finally:
        _ip("netns", "del", _NAMESPACE)


def _connect() -> None:
    """Set up the network, or repair it after a cut."""
    inside = "netns", "exec", _NAMESPACE, "ip"
    _ip("addr", "replace", f"{_NET}.1/24", "dev", _HOST_LINK)
    _ip("link", "set", _HOST_LINK, "up")
    _ip(*inside, "addr", "replace", f"{_NET}.2/24", "dev", _DRIVER_LINK)
    _ip(*inside, "link", "set", _DRIVER_LINK, "up")
    _ip(*inside, "link", "set", "lo", "up")
    for words, device in (((), _HOST_LINK), (inside, _DRIVER_LINK)):
        _ip(*words, "neigh", "flush", "dev", device, "nud", "permanent")


def _link_down(_driver: int, _router: int) -> None:
    _ip("netns", "exec", _NAMESPACE, "ip", "link", "set", _DRIVER_LINK, "down")


def _lose_packets(_driver: int, _router: int) -> None:
    """Drop all packets while both ends see a working link."""
    wrong = "lladdr", "02:00:00:00:00:01", "dev"
    inside = "netns", "exec", _NAMESPACE, "ip"
    _ip(*inside, "neigh", "replace", f"{_NET}.1", *wrong, _DRIVER_LINK)
    _ip("neigh", "replace", f"{_NET}.2", *wrong, _HOST_LINK)


def _sleep(driver: int, router: int) -> None:
    os.kill(driver, signal.SIGSTOP)
    _link_down(driver, router)


CUTS: dict[str, Callable[[int, int], None]] = {
    "link down": _link_down,
    "all packets lost": _lose_packets,
    "killed": lambda driver, _: os.kill(driver, signal.SIGKILL),
    "suspended": lambda driver, _: os.kill(driver, signal.SIGSTOP),
    "asleep": _sleep,
    "router killed": lambda _, router: os.kill(router, signal.SIGKILL),
}


class ServedBoard:
    """Served board, and drivers in another network namespace."""

    def __init__(self, stack: ExitStack, folder: Path) -> None:
        self.board = SimulatorProcess()
        stack.callback(self.board.end)
        self._environment = {**os.environ, "TREX_STUDIO_DATA": str(folder)}
        self._users = folder / "users"
        self._secret = add_user(self._users, "driver", "drive")
        self._dictionary = folder / "dictionary"  # for the engine of the router
        self._dictionary.write_text(f"driver:{self._secret}\n", "utf-8")
        self._stack = stack
        with socket.socket() as listener:
            listener.bind(("", 0))
            self._port = listener.getsockname()[1]
        arguments = [
            "serve",
            "--port",
            self.board.url,
            "--name",
            "arm",
            "--users",
            str(self._users),
        ]
        self._start(
            [sys.executable, "-m", "trex_gui.cli", *arguments, "--listen", f"{_NET}.1:{self._port}"]
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
            endpoints = f"{_NET}.1:{port}", f"{_NET}.1:{self._port}"
            arguments = *endpoints, "driver", self._secret, str(self._dictionary)
            router = self._start([sys.executable, "-c", _ROUTER, *arguments])
            assert router.stdout is not None
            router.stdout.readline()
        url = Address(f"{_NET}.1", "arm", "driver", port).url
        inside = ["ip", "netns", "exec", _NAMESPACE]
        driver = self._start([*inside, sys.executable, "-c", _DRIVER, url])
        try:
            assert driver.stdout is not None
            if driver.stdout.readline() != "drives\n":
                raise TimeoutError("the motors never turned")
            time.sleep(random.random() / 5)
            CUTS[cut](driver.pid, router.pid if router else 0)
            return wait(lambda: not turns(self.board), "the motors never stopped")
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
        print("networks: skipped, because root and ip are needed")
        return []
    generator, end = random.Random(seed), time.monotonic() + seconds
    durations: dict[str, list[float]] = defaultdict(list)
    failures: list[str] = []
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="trex-net")))
        stack.enter_context(namespace())
        board = ServedBoard(stack, folder)
        while time.monotonic() < end:
            cut = generator.choice(list(CUTS))
            try:
                durations[cut].append(board.trial(cut))
            except (TimeoutError, AssertionError) as error:
                failures.append(f"{cut}: {error}")
                continue
            if durations[cut][-1] > LIMIT:
                failures.append(f"{cut}: {durations[cut][-1]:.3f} s")
    for cut, times in sorted((cut, times) for cut, times in durations.items() if times):
        median, worst = statistics.median(times), max(times)
        print(f"{cut}: {len(times)} trials, median {median:.3f} s, worst {worst:.3f} s")
    return failures
