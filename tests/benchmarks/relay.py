"""Relay that delays a TCP connection, or reports when a stop of a TReX passes.

    python -m tests.benchmarks.relay LISTEN_PORT TARGET_PORT DELAY_S LOSS

Only without a delay, the relay prints the time of each stop. A lost TCP packet and all later
packets are delayed by a retransmission timeout.
"""

import asyncio
import random
import sys
import time

from trex_gui.devices.trex.protocol.commands import STOP

_RETRANSMISSION_S = 0.2  # minimum of Linux
_STOP = STOP[0].opcode


async def _forward(
    reader: asyncio.StreamReader, writer: asyncio.StreamWriter, delay: float, loss: float
) -> None:
    queue: asyncio.Queue[tuple[float, bytes]] = asyncio.Queue()
    loop = asyncio.get_running_loop()

    async def send() -> None:
        while True:
            time_to_send, data = await queue.get()
            await asyncio.sleep(max(0.0, time_to_send - loop.time()))
            writer.write(data)
            await writer.drain()

    sender = asyncio.create_task(send())
    last = 0.0
    while data := await reader.read(65536):
        if not delay and data[0] == _STOP:
            print(f"stop {time.monotonic():.6f}", flush=True)
        extra = _RETRANSMISSION_S if random.random() < loss else 0.0
        last = max(last, loop.time() + delay + extra)
        queue.put_nowait((last, data))
    sender.cancel()
    writer.close()


async def _serve(listen: int, target: int, delay: float, loss: float) -> None:
    async def relay(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        replies, requests = await asyncio.open_connection("127.0.0.1", target)
        await asyncio.gather(
            _forward(reader, requests, delay, loss), _forward(replies, writer, delay, loss)
        )

    server = await asyncio.start_server(relay, "127.0.0.1", listen)
    print("ready", flush=True)
    async with server:
        await server.serve_forever()


if __name__ == "__main__":
    asyncio.run(_serve(int(sys.argv[1]), int(sys.argv[2]), *map(float, sys.argv[3:])))
