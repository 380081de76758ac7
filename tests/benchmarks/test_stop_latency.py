"""Time from the press of a button or the move of a slider to its bytes on the wire.

The window paints, telemetry runs at full rate, and the simulated board is a separate process at the
pace of the wire. Each figure is compared to its minimum: the remaining time of the transaction at
the moment of the press. A board does not listen while it replies.
"""

import random
import statistics
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QSlider

from tests.benchmarks.conftest import ReportFigure, fast_board
from tests.support.simulator import StartSimulator
from tests.support.window import WindowDriver
from trex_gui.core.transport.serial_port import SerialTransport
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.protocol.commands import STOP, Command, ReplyT_co
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.framing import Framing, Reply
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.ui.devices.connection import ConnectionState

_PRESSES = 1000
_STOP_BYTES = STOP[0].opcode.to_bytes()
_ADDED_MS = 10.0
"""Highest median delay that the program may add to the minimum, even on a busy computer."""


class WireRecorder:
    """Records sent bytes and transactions with their times on `time.perf_counter`."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.writes: list[tuple[float, bytes]] = []
        self.transactions: list[tuple[float, float]] = []
        write, transact = SerialTransport.write, TrexClient._transact

        def record_write(port: SerialTransport, data: bytes) -> None:
            self.writes.append((time.perf_counter(), data))
            write(port, data)

        def record_transaction(
            client: TrexClient, command: Command[ReplyT_co], framing: Framing
        ) -> Reply[ReplyT_co]:
            start = time.perf_counter()
            try:
                return transact(client, command, framing)
            finally:
                self.transactions.append((start, time.perf_counter()))

        monkeypatch.setattr(SerialTransport, "write", record_write)
        monkeypatch.setattr(TrexClient, "_transact", record_transaction)

    def clear(self) -> None:
        self.writes.clear()
        self.transactions.clear()

    def first_after(self, moment: float, matches: Callable[[bytes], bool]) -> float | None:
        """Return the time of the first matching bytes after a moment."""
        return next((at for at, data in self.writes if at >= moment and matches(data)), None)

    def remaining_transaction_time(self, moment: float) -> float:
        """Return the seconds from a moment to the end of its transaction."""
        return next((end - moment for start, end in self.transactions if start <= moment < end), 0)


def speed_of(number: int) -> int:
    return 1 + number % 100


def is_drive(data: bytes, number: int) -> bool:
    """Return whether this is the setpoint of a move and not a repeated older setpoint."""
    return 0xC0 <= data[0] <= 0xEF and data[1] == speed_of(number)


@pytest.mark.timeout(600)
@pytest.mark.parametrize("baud", [19200, 115200])
def test_delay_added_between_press_and_wire_stays_below_limit(
    baud: int,
    window: WindowDriver,
    start_simulator: StartSimulator,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    figure: ReportFigure,
) -> None:
    recorder = WireRecorder(monkeypatch)
    line = LineSettings(baud)
    simulator = start_simulator(*fast_board(tmp_path, baud))
    device, qtbot = window.device, window.qtbot
    device.connect_to(ConnectionSettings(simulator.url, line))
    qtbot.waitUntil(
        lambda: device.link is ConnectionState.CONNECTED and device.motors.is_available,
        timeout=20_000,
    )
    device.motors.lockout = 0.0
    window.window.pages.setCurrentIndex(3)  # Currents, with the live plot
    stop = window.button("stopButton")
    slider = window.find(QSlider, "motor1Slider")
    pauses = random.Random(1)

    def measure(
        action: Callable[[int], object], matches: Callable[[bytes, int], bool]
    ) -> tuple[list[float], list[float]]:
        delays, minimums = [], []
        for number in range(_PRESSES):
            device.motors.arm()
            qtbot.wait(pauses.randint(25, 45))  # at any time between two polls
            assert device.motors.armed, device.motors.stop_reason or device.status
            recorder.clear()
            pressed = time.perf_counter()
            action(number)
            sent: float | None = None
            end = pressed + 2
            while sent is None and time.perf_counter() < end:
                qtbot.wait(1)
                sent = recorder.first_after(pressed, lambda data: matches(data, number))  # noqa: B023
            assert sent is not None, device.motors.stop_reason or device.status
            delays.append(1000 * (sent - pressed))
            minimums.append(1000 * recorder.remaining_transaction_time(pressed))
        return delays, minimums

    def press_stop(_: int) -> None:
        QTest.mouseClick(stop, Qt.MouseButton.LeftButton)

    measured = {
        "slider": measure(lambda number: slider.setValue(speed_of(number)), is_drive),
        "stop": measure(press_stop, lambda data, _: data[:1] == _STOP_BYTES),
    }
    for name, (delays, minimums) in measured.items():
        ordered = sorted(delays)
        added = [delay - minimum for delay, minimum in zip(delays, minimums, strict=True)]
        figure(f"{name} to wire at {baud} baud, median", statistics.median(delays), "ms")
        figure(f"{name} to wire at {baud} baud, 99 %", ordered[len(delays) * 99 // 100], "ms")
        figure(f"{name} to wire at {baud} baud, worst", ordered[-1], "ms")
        figure(f"least possible for {name} at {baud} baud", statistics.median(minimums), "ms")
        figure(
            f"added for {name} at {baud} baud, median",
            statistics.median(added),
            "ms",
            at_most=_ADDED_MS,
        )
