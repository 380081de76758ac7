"""Send messages to the server of a board, without a real network. No motor may move.

First, a watcher and a stranger send changed messages, and messages of the driver are replayed. Then
two drivers use a simulated network that loses, delays and reorders messages.
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
    """Send messages of a watcher and a stranger, and repeat messages of the driver."""
    generator, end, count = random.Random(seed), time.monotonic() + seconds, 0
    harness = ServerHarness()
    harness.server.report(CONNECTED)
    driver, watcher = harness.join("driver"), harness.join("watcher", Role.WATCH)
    stranger = Party("id-stranger", "stranger", Role.WATCH)
    recorded = [
        harness.message("driver", request)
        for request in (AskLease(), Arm(), SetMotor(1, Drive.at(50)), Heartbeat(), Alive())
    ]
    for data in recorded:
        harness.server.handle(driver, data)
    harness.session.clear()
    harness.received.clear()
    while time.monotonic() < end:
        for _ in range(1000):
            count += 1
            harness.now += 0.005
            sender = generator.choice((watcher, stranger, driver))
            data = generator.choice(recorded)
            if sender != driver:
                request, now = generator.choice(REQUESTS), harness.now
                data = _changed(encode_request(request, count, now, now), generator)
            harness.server.handle(sender, data)
        harness.received.clear()
        if moved := [request for request in harness.session if _moves(request)]:
            return [f"message {count}: {moved[0]}"]
        harness.session.clear()
    print(f"{count} messages, none moved a motor; refused: {dict(harness.server.refused)}")
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
