"""Sentences about a line and a board, for the user."""

import pytest

from trex_gui.core.errors import BadReply, NoReply, PortUnavailable
from trex_gui.devices.trex.client.client import diagnose
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings

SETTINGS = ConnectionSettings("/dev/ttyUSB0")


def test_missing_reply_message_lists_checks() -> None:
    error = diagnose(SETTINGS, echo=False, error=NoReply("No reply to 81."))
    assert isinstance(error, NoReply)
    assert "/dev/ttyUSB0 at 19200 baud, no error detection, 1 stop bit" in str(error)
    assert "power" in str(error)
    assert "device number" not in str(error)


def test_missing_reply_message_names_device_number() -> None:
    settings = ConnectionSettings("/dev/ttyUSB0", device_number=12)
    error = diagnose(settings, echo=False, error=NoReply("x"))
    assert "device number is 12" in str(error)


def test_echo_without_board_is_explained() -> None:
    error = diagnose(SETTINGS, echo=True, error=NoReply("x"))
    assert isinstance(error, NoReply)
    assert "TX and RX are joined" in str(error)


@pytest.mark.parametrize("echo", [False, True])
def test_bad_reply_message_contains_its_error(*, echo: bool) -> None:
    error = diagnose(SETTINGS, echo=echo, error=BadReply("The reply 41 is corrupted."))
    assert isinstance(error, BadReply)
    assert "The reply 41 is corrupted." in str(error)


def test_port_error_is_returned_unchanged() -> None:
    gone = PortUnavailable("gone")
    assert diagnose(SETTINGS, echo=False, error=gone) is gone


def test_framing_has_crc_only_if_line_has_one() -> None:
    plain = ConnectionSettings("x", device_number=7, polynomial=0x91)
    assert (plain.framing.device_number, plain.framing.polynomial) == (7, None)
    crc = ConnectionSettings("x", LineSettings(detection=Detection.CRC7), polynomial=0x91)
    assert (crc.framing.device_number, crc.framing.polynomial) == (None, 0x91)
