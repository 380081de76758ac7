"""Time to read all values of a board and to write a settings file, compared to the wire.

The simulated board is a separate process behind a pseudo-terminal, at the pace of the wire. The
time on the wire is that of all bytes in both directions and of the writes to EEPROM.
"""

import statistics
import time
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import pytest

from tests.benchmarks.conftest import ReportFigure, fast_board
from tests.support.simulator import StartSimulator
from trex_gui.core.transport.serial_port import SerialTransport
from trex_gui.devices.trex.client.client import Requester, TrexClient
from trex_gui.devices.trex.client.reading import read_everything
from trex_gui.devices.trex.client.writing import write_all
from trex_gui.devices.trex.protocol.calibration import CalibrationKey
from trex_gui.devices.trex.protocol.commands import Command, ReplyT_co, SetCalibration, SetParameter
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.simulator.memory import CALIBRATION_WRITE_S, PARAMETER_WRITE_S

_ROUNDS = 25
_EEPROM_WRITE_S: dict[type[object], float] = {
    SetParameter: PARAMETER_WRITE_S,
    SetCalibration: CALIBRATION_WRITE_S,
}
_MAX_RATIO = {19200: 1.10, 115200: None}
"""Highest ratio to the time on the wire. At 115200 baud, two processes need more time to transfer a
byte than the wire."""


@pytest.mark.parametrize("baud", [19200, 115200])
def test_read_and_write_take_little_more_than_wire_time(
    baud: int, start_simulator: StartSimulator, tmp_path: Path, figure: ReportFigure
) -> None:
    line = LineSettings(baud)
    simulator = start_simulator(*fast_board(tmp_path, baud))
    settings = ConnectionSettings(simulator.url, line)
    client = TrexClient(SerialTransport(settings), settings)
    state = read_everything(client.request)
    calibrations = [
        (CalibrationKey.of(state.source, channel), calibration)
        for channel, calibration in state.calibrations.items()
    ]

    def read(request: Requester) -> None:
        read_everything(request)

    def write(request: Requester) -> None:
        parameters = [*state.parameters.items()]
        results = write_all(request, state.specs, parameters, calibrations, before=state)
        assert not any(result.error for result in results)

    for name, work in (("board read", read), ("settings file written", write)):
        duration, wire_time = _seconds(client, work)
        figure(f"whole {name} at {baud} baud", duration, "s")
        figure(
            f"whole {name} at {baud} baud to wire time",
            duration / wire_time,
            "ratio",
            at_most=_MAX_RATIO[baud],
        )
    client.close()


def _seconds(client: TrexClient, work: Callable[[Requester], None]) -> tuple[float, float]:
    """Return the seconds of some work, and the seconds of its bytes on the wire and in EEPROM.

    The first value is the sum of the median durations of each transaction and the pause after it,
    because other processes add milliseconds to some transactions.
    """
    rounds: list[list[float]] = []
    wire_time = 0.0

    def request(command: Command[ReplyT_co]) -> ReplyT_co:
        nonlocal wire_time
        rounds[-1].append(time.perf_counter())
        size = len(client.settings.framing.encode(command)) + command.reply_size()
        wire_time += client.settings.line.seconds(size) + _EEPROM_WRITE_S.get(type(command), 0.0)
        return client.request(command)

    for _ in range(_ROUNDS):
        rounds.append([])
        work(request)
        rounds[-1].append(time.perf_counter())
    transactions = zip(
        *([end - begin for begin, end in pairwise(times)] for times in rounds), strict=True
    )
    return sum(map(statistics.median, transactions)), wire_time / _ROUNDS
