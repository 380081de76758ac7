"""Diagnosis of a failed connection."""

from dataclasses import replace
from itertools import chain, product

import pytest

from tests.support.virtual import SessionHarness, VirtualTransport
from trex_gui.core.errors import BadReply, NoReply, PortUnavailable, StudioError
from trex_gui.devices.trex.diagnosis import _plans, diagnose, explain
from trex_gui.devices.trex.discovery import attempts
from trex_gui.devices.trex.model.connection import remedies_for
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import BoardElsewhere
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.simulator.memory import Eeprom
from trex_gui.ui.notifier import Remedy

SETTINGS = ConnectionSettings("/dev/ttyUSB0")


def test_missing_reply_error_lists_checks_and_device_number() -> None:
    error = explain(SETTINGS, echo=False, error=NoReply("No reply to 81."))
    assert isinstance(error, NoReply)
    assert "/dev/ttyUSB0 at 19200 baud, no error detection, 1 stop bit" in str(error)
    assert "power" in str(error)
    assert "device number" not in str(error)
    error = explain(replace(SETTINGS, device_number=12), echo=False, error=NoReply("x"))
    assert "device number 12" in str(error)


@pytest.mark.parametrize("echo", [False, True])
def test_bad_reply_message_contains_its_error(*, echo: bool) -> None:
    error = explain(SETTINGS, echo=echo, error=BadReply("The reply 41 is corrupted."))
    assert isinstance(error, BadReply)
    assert "The reply 41 is corrupted." in str(error)


def test_port_error_is_returned_unchanged() -> None:
    error = PortUnavailable("lost")
    assert explain(SETTINGS, echo=False, error=error) is error


# --- Probes -----------------------------------------------------------------------------


def create_harness(
    line: LineSettings, *, polynomial: int = 0x89, echo: bool = False
) -> SessionHarness:
    eeprom = Eeprom()
    eeprom.write("uart_settings", line.to_wire())
    eeprom.write("crc7_polynomial", polynomial & 0x7F)
    return SessionHarness(Board(eeprom=eeprom), echo=echo)


def diagnosis_of(harness: SessionHarness, settings: ConnectionSettings) -> StudioError:
    """Return the diagnosis of a failed connection."""
    harness.line.host = settings.line
    error = diagnose(harness.client(settings), NoReply("No reply."))
    assert harness.line.host == settings.line, "the probes restore the line settings"
    return error


NONE, EVEN, ODD, CRC = (
    ConnectionSettings("virtual", LineSettings(detection=detection))
    for detection in (Detection.NONE, Detection.EVEN, Detection.ODD, Detection.CRC7)
)
OTHER_CRC = replace(CRC, polynomial=0x9D)
FAST = ConnectionSettings("virtual", LineSettings(115200))


@pytest.mark.parametrize("echo", [False, True])
@pytest.mark.parametrize(
    ("board", "used", "words"),
    [
        (EVEN, NONE, "at 19200 baud, even parity, but this connection uses 19200 baud."),
        (ODD, EVEN, "19200 baud, odd parity, but this connection uses 19200 baud, even parity"),
        (CRC, NONE, "at 19200 baud, CRC-7, but"),
        (NONE, CRC, "at 19200 baud, but this connection uses 19200 baud, CRC-7"),
        (OTHER_CRC, CRC, "with CRC polynomial 9D, but this connection uses 89"),
        (CRC, OTHER_CRC, "with CRC polynomial 89, but this connection uses 9D"),
        (NONE, FAST, "at 19200 baud, but this connection uses 115200 baud"),
        (
            NONE,
            replace(NONE, device_number=9),
            "its device number is 7, and this connection uses 9",
        ),
    ],
)
def test_board_at_other_settings_is_found(
    board: ConnectionSettings, used: ConnectionSettings, words: str, *, echo: bool
) -> None:
    cause = diagnosis_of(create_harness(board.line, polynomial=board.polynomial, echo=echo), used)
    assert isinstance(cause, BoardElsewhere)
    assert str(cause).startswith("A TReX 1.2 responds on virtual")
    assert words in str(cause)
    assert cause.settings == board


def test_quick_diagnosis_tries_no_other_polynomials() -> None:
    harness = create_harness(CRC.line, polynomial=0x9D)
    cause = diagnose(harness.client(CRC), NoReply("No reply."), quick=True)
    assert "No TReX responds" in str(cause)
    assert harness.line.now < 2


def test_board_that_responds_later_is_on_an_unreliable_line() -> None:
    cause = diagnosis_of(create_harness(NONE.line), NONE)
    assert "responds on virtual, but not every time" in str(cause)
    assert remedies_for(cause) == (Remedy.RECONNECT,)


def start_in_boot_mode(board: Board, mode: str) -> None:
    """Switch a board on with all jumpers. In serial mode, it waits for their removal."""
    board.mode_jumper = mode
    board.mix = board.so_ground = True
    board.power_off()
    board.power_on()


@pytest.mark.parametrize("used", [NONE, CRC, EVEN])
def test_boot_loader_is_reported(used: ConnectionSettings) -> None:
    harness = create_harness(NONE.line)
    start_in_boot_mode(harness.board, "serial")
    harness.board.mix = False
    harness.line.advance(0.1)
    harness.board.so_ground = False
    harness.line.advance(0.1)
    assert harness.board.boot_mode is not None
    cause = diagnosis_of(harness, used)
    assert "is in its boot loader, waiting for new firmware" in str(cause)
    assert "SO–G jumpers are off, then switch the board off and on" in str(cause)


@pytest.mark.parametrize("used", [NONE, replace(NONE, device_number=7)])
def test_error_of_silent_board_mentions_learning_mode(used: ConnectionSettings) -> None:
    harness = create_harness(NONE.line)
    start_in_boot_mode(harness.board, "rc")
    cause = diagnosis_of(harness, used)
    assert isinstance(cause, NoReply)
    assert "both LEDs blink together" in str(cause)


class QikTransport(VirtualTransport):
    """Transport of a qik, which replies to 81 with its firmware version at 38400 baud."""

    def write(self, data: bytes) -> None:
        self.sent += data
        if b"\x81" in data and getattr(self.line.host, "baud", None) == 38400:
            self.line.inject(b"2")


def test_qik_is_reported() -> None:
    harness = create_harness(NONE.line)
    harness.board.power_off()
    harness.transport = QikTransport(harness.line)
    settings = ConnectionSettings("virtual", LineSettings(38400))
    harness.line.host = settings.line
    cause = diagnose(harness.client(settings), NoReply("No reply."))
    assert "responds like a Pololu qik" in str(cause)


def test_boards_that_reply_together_are_reported() -> None:
    harness = create_harness(NONE.line)
    other = Board(eeprom=Eeprom("trexjr"), model="trexjr")
    harness.line = SimulatedBoards([harness.board, other])
    harness.transport = VirtualTransport(harness.line)
    assert "Several boards reply at once" in str(diagnosis_of(harness, NONE))


def test_diagnosis_uses_only_probes_of_a_full_scan() -> None:
    safe = set(attempts(full=True))
    for detection, baud in product(Detection, baud_rates()):
        settings = ConnectionSettings("virtual", LineSettings(baud, detection))
        plans = chain.from_iterable(_plans(settings, quick=False))
        assert set(plans) <= safe
