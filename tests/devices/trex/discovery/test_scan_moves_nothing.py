"""What is sent before a board has answered, as a board at another rate misreads it.

To such a board every packet is other bytes, and some are motor commands then: the queries of
both error bytes, sent at 38400 baud with CRC to a board at 19200, drive motor 2. So what goes
out to a line that nobody has answered on must be harmless at every rate.
"""

import itertools

import pytest

from tests.support.matrix import sampled
from tests.support.virtual import Stage
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import TrexLine
from trex_gui.devices.trex.simulator.memory import Eeprom


def _sent_to_nobody(settings: ConnectionSettings) -> list[bytes]:
    """Return what a session sends while nothing answers."""
    stage = Stage(Board())
    stage.line.faults.mute = True
    stage.run(settings)
    return [data for _, data in stage.transport.written]


def _moves(line: TrexLine, board: Board, packets: list[bytes]) -> list[str]:
    """Send packets with gaps; return those on which a motor is told to run, however briefly."""
    moving = []
    for packet in packets:
        line.send(packet)
        runs = False
        while (event := line.next_event) is not None:
            line.advance_to(event)
            runs |= any(motor.target_direction.value != "brake" for motor in board.motors)
            runs |= board.aux.target_speed > 0
        if runs:
            moving.append(packet.hex(" "))
            board.serial.stop_motors()
    return moving


def _board(settings: LineSettings) -> Board:
    eeprom = Eeprom()
    eeprom.write("uart_settings", settings.to_wire())
    return Board(eeprom=eeprom)


@pytest.mark.parametrize(
    ("detection", "device_number"), sampled(itertools.product(Detection, (None, 7)), every=3)
)
def test_connection_probes_start_no_motor_at_any_rate(
    detection: Detection, device_number: int | None
) -> None:
    settings = ConnectionSettings("virtual", LineSettings(detection=detection), device_number)
    packets = _sent_to_nobody(settings)
    assert packets
    for own_detection in Detection:
        for own, host in itertools.permutations(baud_rates(), 2):
            board = _board(LineSettings(own, own_detection))
            line = TrexLine([board])
            line.host = LineSettings(host, detection)
            moving = _moves(line, board, packets)
            assert not moving, f"{host} to {own} baud, {own_detection.name}: {moving}"
            assert not board.memory.writes


def test_misread_packets_can_start_a_motor() -> None:
    """The danger is real: else the test above would say nothing."""
    board = _board(LineSettings(19200))
    line = TrexLine([board])
    line.host = LineSettings(38400)
    queries = [bytes.fromhex("80 07 04 50"), bytes.fromhex("80 07 05 59")]
    assert _moves(line, board, queries) == ["80 07 05 59"]
