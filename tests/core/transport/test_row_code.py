"""Traffic rows as source code."""

import pytest

from trex_gui.core.code import Language
from trex_gui.core.transport.row_code import rows_as_code
from trex_gui.core.transport.traffic import Transaction
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.session.traffic_decoder import TrexDecoder

SETTINGS = ConnectionSettings("virtual")
ROWS = (
    Transaction(1, 0.0, note="Opened */ \\", settings=SETTINGS, is_over=True),
    Transaction(2, 0.1, b"\x81", b"TReX1.2", settings=SETTINGS, is_over=True),
    Transaction(3, 0.2, b"\xc2\x50", settings=SETTINGS, is_over=True),
)


class Port:
    """Port that records its calls."""

    def __init__(self) -> None:
        self.calls: list[object] = []

    def write(self, data: bytes) -> None:
        self.calls.append(data)

    def read(self, size: int) -> None:
        self.calls.append(size)

    def flush(self) -> None: ...


def test_python_sends_the_bytes_and_waits_for_replies() -> None:
    names: dict[str, object] = {}
    code = rows_as_code(ROWS, TrexDecoder(), Language.PYTHON)
    exec(code, names)
    send, port = names["send_copied_requests"], Port()
    assert callable(send)
    send(port)
    assert port.calls == [b"\x81", 7, b"\xc2\x50"]
    assert "19200 baud, no error detection, 1 stop bit" in code
    assert "# set motor 1 to forward 80" in code


@pytest.mark.parametrize("language", Language)
def test_line_events_become_comments_and_motor_commands_add_a_warning(language: Language) -> None:
    code = rows_as_code(ROWS[:1], TrexDecoder(), language)
    assert "Opened" in code
    assert "WARNING" not in code
    assert "WARNING: the motors may move" in rows_as_code(ROWS, TrexDecoder(), language)
    assert code.count("write(") == rows_as_code((), TrexDecoder(), language).count("write(")
