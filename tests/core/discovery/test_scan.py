"""Scan of one port for devices of any kind."""

import logging
from collections.abc import Callable

import pytest

from tests.devices.trex.discovery.test_prober import Wire, wire_of
from tests.devices.trex.simulator.ports import create_board
from trex_gui.core.discovery.prober import (
    FLUSH_BYTE,
    FLUSH_LINE,
    Diagnosis,
    Evidence,
    Prober,
    ProberInfo,
    ScanProgress,
)
from trex_gui.core.discovery.scan import PortScan, probe_order, scan_port
from trex_gui.core.errors import BadRequest, PortUnavailable
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat
from trex_gui.devices.trex.discovery import TREX_PROBER
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import LineSettings

VIRTUAL = PortSettings("virtual", SerialFormat(9600))


class RecordingProber:
    """Prober that finds nothing and records its calls."""

    parts = (2, 3)
    found = ()
    is_over = False

    def __init__(self, calls: list[str], name: str, diagnosis: Diagnosis) -> None:
        self._calls = calls
        self._name = name
        self._diagnosis = diagnosis

    def record_unsolicited(self, line: SerialFormat, data: bytes) -> None:
        self._calls.append(f"{self._name} received {data!r} at {line.baud}")

    def probe(
        self,
        wire: Transport,
        part: int,
        progress: Callable[[ScanProgress], None],
        cancelled: Callable[[], bool],
    ) -> None:
        for done in range(self.parts[part]):
            if cancelled():
                return
            progress(ScanProgress(done, self.parts[part], SerialFormat()))
        self._calls.append(f"{self._name} {part}")

    def diagnosis(self) -> Diagnosis:
        return self._diagnosis


def silent_prober(calls: list[str], name: str, evidence: Evidence = Evidence.SILENCE) -> ProberInfo:
    diagnosis = Diagnosis(evidence, f"No {name}.")
    announces_at = SerialFormat(38400) if name == "Talker" else None
    return ProberInfo(
        name,
        lambda _settings, *, full, known: RecordingProber(calls, name, diagnosis),
        announces_at,
    )


def search(wire: Wire, probers: dict[str, ProberInfo], first: str | None = None) -> PortScan:
    return scan_port(VIRTUAL, probers, first=first, open_wire=lambda _settings: wire)


def test_likely_settings_of_the_expected_kind_come_first() -> None:
    parts = {"common": (5, 83), "rare": (5, 9)}
    as_listed = [("common", 0), ("rare", 0), ("common", 1), ("rare", 1)]
    assert (
        probe_order(parts, None)
        == probe_order(parts, "common")
        == probe_order(parts, "unknown")
        == as_listed
    )
    assert probe_order(parts, "rare") == [("rare", 0), ("common", 0), ("rare", 1), ("common", 1)]
    assert probe_order({"common": (5, 83), "rare": (5,)}, None) == as_listed[:3]


def test_search_follows_order_and_opens_port_once() -> None:
    calls: list[str] = []
    opened: list[PortSettings] = []
    wire = wire_of(create_board())
    wire.line.faults.mute = True

    def open_wire(settings: PortSettings) -> Wire:
        opened.append(settings)
        return wire

    probers = {"one": silent_prober(calls, "One"), "two": silent_prober(calls, "Two")}
    scan_port(VIRTUAL, probers, first="two", open_wire=open_wire)
    assert calls == ["Two 0", "One 0", "Two 1", "One 1"]
    assert [settings.line for settings in opened] == [FLUSH_LINE]
    assert wire.closed


def test_progress_counts_probes_and_names_device_kind() -> None:
    steps: list[ScanProgress] = []
    wire = wire_of(create_board())
    probers = {"one": silent_prober([], "One"), "two": silent_prober([], "Two")}
    scan_port(VIRTUAL, probers, progress=steps.append, open_wire=lambda _settings: wire)
    assert [step.done for step in steps] == list(range(10))
    assert {step.total for step in steps} == {10}
    assert [step.kind for step in steps] == ["One"] * 2 + ["Two"] * 2 + ["One"] * 3 + ["Two"] * 3


@pytest.mark.parametrize(("baud", "earlier"), [(57600, []), (4800, ["Other 0"])])
def test_trex_is_found_at_likely_rate_before_other_probes(baud: int, earlier: list[str]) -> None:
    calls: list[str] = []
    probers = {"trex": TREX_PROBER, "other": silent_prober(calls, "Other")}
    wire = wire_of(create_board(settings=LineSettings(baud).to_wire()))
    result = search(wire, probers)
    assert (result.device, [found.name for found in result.found]) == ("trex", ["TReX 1.2"])
    assert result.found[0].settings == ConnectionSettings("virtual", LineSettings(baud))
    assert calls == earlier
    assert earlier or wire.line.now < 2.5


def test_unsolicited_data_is_received_at_rate_of_device_kind() -> None:
    calls: list[str] = []
    probers = {"trex": TREX_PROBER, "talker": silent_prober(calls, "Talker")}
    board = create_board()
    board.power_off()
    wire = wire_of(board)
    read = wire.read
    wire.read = lambda size, seconds: b"$GPGGA" if seconds == 0.3 else read(size, seconds)  # type: ignore[method-assign]
    opened: list[int] = []

    def open_wire(settings: PortSettings) -> Wire:
        opened.append(settings.line.baud)
        return wire

    result = scan_port(VIRTUAL, probers, open_wire=open_wire)
    assert opened == [38400]
    assert calls[0] == "Talker received b'$GPGGA' at 38400"
    assert "it sent 24 47 50 47 47 41 at 38400 baud" in result.lines[0]


def test_diagnoses_of_all_kinds_are_sorted_by_evidence() -> None:
    probers = {
        "silent": silent_prober([], "Silent"),
        "known": silent_prober([], "Known", Evidence.KNOWN),
        "echo": silent_prober([], "Echo", Evidence.ECHO),
        "mute": silent_prober([], "Mute"),
        "strange": silent_prober([], "Strange", Evidence.STRANGE),
    }
    assert search(wire_of(create_board()), probers).lines == [
        "No Known.",
        "No Strange.",
        "No Echo.",
        "No Silent.",
        "No Mute.",
    ]


def test_cancelled_search_is_reported_as_cancelled() -> None:
    steps: list[ScanProgress] = []
    calls: list[str] = []
    wire = wire_of(create_board())
    result = scan_port(
        VIRTUAL,
        {"one": silent_prober(calls, "One"), "two": silent_prober(calls, "Two")},
        progress=steps.append,
        cancelled=lambda: len(steps) == 2,
        open_wire=lambda _settings: wire,
    )
    assert result.cancelled
    assert calls == ["One 0"]
    assert result.lines == ["No One."], "the other kind was not probed"
    assert wire.closed


@pytest.mark.parametrize(
    ("error", "text"),
    [
        (PortUnavailable("It is in use by a terminal."), "It is in use by a terminal."),
        (
            LookupError("on purpose"),
            "Internal error while searching virtual (LookupError: on purpose).",
        ),
    ],
)
def test_unopened_port_reports_only_its_error(error: Exception, text: str) -> None:
    def refuse(settings: PortSettings) -> Wire:
        raise error

    result = scan_port(VIRTUAL, {"one": silent_prober([], "One")}, open_wire=refuse)
    assert result.lines == [text]
    assert not result.cancelled


@pytest.mark.parametrize("evidence", [Evidence.SILENCE, Evidence.STRANGE])
def test_port_loss_is_reported_before_evidence(evidence: Evidence) -> None:
    wire = wire_of(create_board())

    class LostPort(RecordingProber):
        def probe(
            self,
            wire: Transport,
            part: int,
            progress: Callable[[ScanProgress], None],
            cancelled: Callable[[], bool],
        ) -> None:
            raise PortUnavailable("It is gone.")

    diagnosis = Diagnosis(evidence, "No Two.")
    lost = ProberInfo("Two", lambda _settings, *, full, known: LostPort([], "Two", diagnosis))
    result = search(wire, {"one": silent_prober([], "One", evidence), "two": lost})
    diagnoses = ["No One.", "No Two."] if evidence else []
    assert result.lines == ["It is gone.", *diagnoses]
    assert wire.closed


def test_search_ends_with_flush_byte_and_default_settings() -> None:
    wire = wire_of(create_board())
    search(wire, {"one": silent_prober([], "One")})
    assert bytes(wire.sent) == FLUSH_BYTE
    assert wire.configured[-1] == SerialFormat()
    # After a flush byte at another rate, the found board would report an error.
    wire = wire_of(create_board())
    search(wire, {"trex": TREX_PROBER})
    assert not bytes(wire.sent).endswith(FLUSH_BYTE)


def test_unsupported_baud_rates_are_reported() -> None:
    board = create_board()
    board.power_off()
    wire = wire_of(board)
    wire.unsupported_rates = frozenset({14400, 76800})
    (line,) = search(wire, {"trex": TREX_PROBER}).lines
    assert "does not support 14400, 76800 baud" in line


def test_report_counts_rates_with_unknown_replies() -> None:
    board = create_board()
    board.power_off()
    wire = wire_of(board)
    read = wire.read
    wire.read = lambda size, seconds: read(size, seconds) or b"ERR"  # type: ignore[method-assign]
    (line,) = search(wire, {"trex": TREX_PROBER}).lines
    assert "it sent 45 52 52 at 1200 baud" in line
    assert "data at 88 other settings" in line


def test_port_without_flush_rate_is_reported_and_closed() -> None:
    wire = wire_of(create_board())
    reconfigure = wire.reconfigure

    def reject_flush_rate(line: SerialFormat) -> None:
        if line == FLUSH_LINE:
            raise BadRequest("the port cannot be set to 1200 baud")
        reconfigure(line)

    wire.reconfigure = reject_flush_rate  # type: ignore[method-assign]
    result = search(wire, {"trex": TREX_PROBER})
    assert not result.device
    assert "does not support 1200" in result.lines[0]
    assert wire.closed


def test_internal_error_in_search_is_reported_and_closes_port(
    caplog: pytest.LogCaptureFixture,
) -> None:
    def fail(settings: PortSettings, *, full: bool, known: bool) -> Prober:
        raise ZeroDivisionError("on purpose")

    wire = wire_of(create_board())
    with caplog.at_level(logging.ERROR):
        found = search(wire, {"one": silent_prober([], "One"), "odd": ProberInfo("Odd", fail)})
    assert not found.found
    assert found.lines == [
        "Internal error while searching virtual (ZeroDivisionError: on purpose)."
    ]
    assert wire.closed
    assert "ZeroDivisionError" in caplog.text
