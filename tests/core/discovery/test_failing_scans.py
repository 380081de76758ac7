"""An internal error on one port is reported, and the port is closed."""

import logging

import pytest

from tests.core.discovery.test_scan import VIRTUAL, nobody, search
from tests.devices.trex.discovery.test_prober import wire_of
from tests.devices.trex.simulator.ports import a_board
from trex_gui.core.discovery.prober import Prober, ProberInfo
from trex_gui.core.discovery.scan import scan_port
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings


def unexpected(settings: PortSettings, *, full: bool, known: bool) -> Prober:
    raise ZeroDivisionError("on purpose")


def test_internal_error_in_search_is_reported_and_closes_port(
    caplog: pytest.LogCaptureFixture,
) -> None:
    wire = wire_of(a_board())
    with caplog.at_level(logging.ERROR):
        found = search(wire, {"one": nobody([], "One"), "odd": ProberInfo("Odd", unexpected)})
    assert found.is_fault
    assert not found.found
    assert found.lines == [
        "Internal error while searching virtual (ZeroDivisionError: on purpose)."
    ]
    assert wire.closed
    assert "ZeroDivisionError" in caplog.text


def test_internal_error_in_opening_port_is_reported(caplog: pytest.LogCaptureFixture) -> None:
    def open_wire(_settings: PortSettings) -> Transport:
        raise LookupError("on purpose")

    found = scan_port(VIRTUAL, {"one": nobody([], "One")}, open_wire=open_wire)
    assert found.is_fault
    assert "LookupError: on purpose" in str(found.error)
