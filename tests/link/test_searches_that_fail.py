"""A fault of the program on one port: it is told, and the port is given back."""

import logging

import pytest

from tests.emulator.ports import a_board
from tests.link.test_discovery import wire_of
from tests.link.test_seeking import VIRTUAL, nobody, search
from trex_gui.link.seekers import Seek, Seeker
from trex_gui.link.seeking import search_port
from trex_gui.link.settings import LinkSettings
from trex_gui.link.transport import Transport


def odd(settings: LinkSettings, *, full: bool, known: bool) -> Seeker:
    raise ZeroDivisionError("on purpose")


def test_internal_error_in_search_is_reported_and_closes_port(
    caplog: pytest.LogCaptureFixture,
) -> None:
    wire = wire_of(a_board())
    with caplog.at_level(logging.ERROR):
        found = search(wire, {"one": nobody([], "One"), "odd": Seek("Odd", odd)})
    assert found.is_fault
    assert not found.found
    assert found.lines == [
        "The search of virtual was ended by a fault of the program (ZeroDivisionError: on purpose)."
    ]
    assert wire.closed
    assert "ZeroDivisionError" in caplog.text


def test_internal_error_in_opening_port_is_reported(caplog: pytest.LogCaptureFixture) -> None:
    def open_wire(_settings: LinkSettings) -> Transport:
        raise LookupError("on purpose")

    found = search_port(VIRTUAL, {"one": nobody([], "One")}, open_wire=open_wire)
    assert found.is_fault
    assert "LookupError: on purpose" in str(found.error)
