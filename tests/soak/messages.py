"""Send messages to the server of a board, without a real network. No motor may move.

First, watchers send changed and replayed messages. Then two drivers use a simulated network that
loses, delays and reorders messages.
"""

import logging
import random
import time
from typing import Any

from tests.devices.trex.serve.test_codec import REQUESTS
from tests.devices.trex.serve.test_server import CONNECTED, LossyNetwork, ServerHarness
from trex_gui.devices.trex.driving.requests import Arm, Heartbeat, SetAuxiliary, SetMotor, SetMotors
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.serve.codec import Alive, encode_request
from trex_gui.devices.trex.serve.lease import Party, Role
from trex_gui.devices.trex.session.messages import AskLease, SendPacket

_MOVES = SetMotor | SetMotors | SetAuxiliary | Arm | Heartbeat


def _moves(request: Any) -> bool:
    return isinstance(request, _MOVES) or (
        isinstance(request, SendPacket) and (request.packet.moves or request.packet.writes)
    )


def _changed(data: bytes, generator: random.Random) -> bytes:
    changed = bytearray(data)
    for _ in range(generator.randint(0, 3)):
        changed[generator.randrange(len(changed))] = generator.randrange(256)
    return bytes(changed[: generator.choice((len(changed), generator.randrange(len(changed)) + 1))])


def attack(seconds: float, seed: int) -> list[str]:
    """Send messages of two watchers, and repeat messages of the driver."""
    generator, end, count = random.Random(seed), time.monotonic() + seconds, 0
    driver = ServerHarness()
    driver.server.report(CONNECTED)
    driver.join("alice")
    driver.join("watcher", Role.WATCH)
    recorded = [
        driver.message("alice", request)
        for request in (AskLease(), Arm(), SetMotor(1, Drive.at(50)), Heartbeat(), Alive())
    ]
    for data in recorded:
        driver.server.handle(driver.parties["alice"], data)
    driver.session.clear()
    driver.received.clear()
    stranger = Party("id-stranger", "stranger", Role.WATCH)
    while time.monotonic() < end:
        for _ in range(1000):
            count += 1
            driver.now += 0.005
            sender = generator.choice(
                (driver.parties["watcher"], stranger, driver.parties["alice"])
            )
            data = generator.choice(recorded)
            if sender != driver.parties["alice"]:
                request = generator.choice(REQUESTS)
                data = _changed(encode_request(request, count, driver.now, driver.now), generator)
            driver.server.handle(sender, data)
        driver.received.clear()
        if moved := [request for request in driver.session if _moves(request)]:
            return [f"message {count}: {moved[0]}"]
        driver.session.clear()
    print(f"{count} messages, none moved a motor; refused: {dict(driver.server.refused)}")
    return []


def run(seconds: float, seed: int) -> list[str]:
    logging.getLogger("trex_gui.devices.trex.serve").setLevel(logging.CRITICAL)
    failures = attack(seconds / 2, seed)
    end, network = time.monotonic() + seconds / 2, LossyNetwork(seed)
    try:
        while time.monotonic() < end:
            network.run_until(network.server.lease.number + 100)
    except AssertionError as error:
        return [*failures, f"hand-over {network.server.lease.number}: {error}"]
    print(f"{network.server.lease.number} hand-overs, {network.moves} setpoints while armed")
    return failures
