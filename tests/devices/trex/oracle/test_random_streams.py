"""Simulator compared to the oracle, byte by byte, on random streams.

The long test compares a million bytes and takes minutes. Option `--all` selects it.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from random import Random

import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from tests.devices.trex.oracle.device import Oracle, table
from tests.devices.trex.oracle.framing import COMMANDS, UNKNOWN_COMMANDS, data_bytes, sealed
from tests.devices.trex.oracle.remapping import Calibration
from tests.support.matrix import examples
from trex_gui.devices.trex.protocol.calibration import Calibration as BoardCalibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.simulator.channels import Signal
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.simulator.memory import Eeprom

SOURCES = {"rc": InputSource.RC, "analog": InputSource.ANALOG}
MASKS = ("ignored_channels", "reversed_channels", "parabolic_channels")
CALIBRATIONS = range(0xA0, 0xA5)
COMMANDS_WITH_REPLY = [command for command in COMMANDS if command < 0xC0] + [0x9F, 0xAF] * 3
# Number and value
SPECIAL_WRITES = (0x0007, 0x0009, 0x7B00, 0x7B01, 0x7C00, 0x7C01, 0x7E05, 0x7E25, 0x7F7F)
READABLE_SETTINGS = {0x05, 0x25}  # with the baud rate and character format of this line

# Timeouts end at multiples of 0.1 s after the last byte. No wait ends near such a time.
REPLY_S = 0.003  # longer than a reply and its optional delay
WRITE_S = 0.05  # longer than a write to EEPROM, which takes 4 ms or 32 ms
MEASURE_S = 0.22  # until every signal has been measured


@dataclass
class Setup:
    """State of a board before the first byte."""

    model: str = "trex"
    firmware: str = "1.2"
    mode: str = "serial"
    mix: bool = False
    parameters: dict[str, int] = field(default_factory=dict)
    calibrations: dict[tuple[str, int], Calibration] = field(default_factory=dict)
    signals: list[str] = field(default_factory=lambda: ["rest"] * 5)


class OracleComparison:
    """Simulated board and oracle that receive the same bytes."""

    def __init__(self, setup: Setup) -> None:
        self.setup = setup
        self.stream = bytearray()
        eeprom = Eeprom(setup.model)
        for key, value in setup.parameters.items():
            eeprom.write(key, value)
        for (source, channel), calibration in setup.calibrations.items():
            eeprom.write_calibration(SOURCES[source], channel, BoardCalibration(*calibration))
        self.board = Board(
            setup.model, setup.firmware, eeprom=eeprom, mode=setup.mode, mix=setup.mix, seed=0
        )
        self.line = SimulatedBoards([self.board], paced=False, seed=0)
        model, jumpers = (setup.model, setup.firmware), (setup.mode, setup.mix)
        self.oracle = Oracle(*model, *jumpers, setup.parameters, setup.calibrations)
        self.connect(setup.signals)
        self._read_safe_start()

    def connect(self, signals: list[str]) -> None:
        self.setup.signals = signals
        for channel, text in enumerate(signals, 1):
            self.board.channels.signals[channel] = Signal.parse(text, SOURCES[self.oracle.source])
        self._wait(MEASURE_S)
        self.oracle.raw = self.board.channels.raw

    def send(self, stream: bytes) -> None:
        for byte in stream:
            self._step(byte)

    def pause(self, tenths: int) -> None:
        self._wait(tenths * 0.1 + 0.02)
        self._compare_latches()

    def power_cycle(self, signals: Callable[[str], list[str]]) -> None:
        """Cycle the power, unless the board would then use other line settings."""
        if self.oracle.stored("uart_settings") in READABLE_SETTINGS:
            self.board.power_cycle()
            self.oracle.power_cycle()
            self.connect(signals(self.oracle.source))
            self._read_safe_start()

    def _read_safe_start(self) -> None:
        """Read safe-start from the board, because it depends on sticks and time."""
        if self.setup.mode == "serial":
            return
        packet = sealed(b"\x83", self.oracle.polynomial)
        self.line.send(packet)
        self._wait(REPLY_S)
        self.oracle.safe_start = self.line.receive()[0] == 0
        for byte in packet:
            self.oracle.feed(byte)

    def _wait(self, seconds: float) -> None:
        self.line.advance(seconds)
        self.oracle.pause(seconds)

    def _step(self, byte: int) -> None:
        self.stream.append(byte)
        self.line.send(bytes([byte]))
        self.line.advance(REPLY_S)
        reply = self.line.receive()
        self.oracle.measured = reply
        expected = self.oracle.feed(byte)
        self.oracle.pause(REPLY_S)
        if self.oracle.wrote:
            self._wait(WRITE_S)
            reply += self.line.receive()
        if reply != expected:
            self._fail("The reply", reply.hex(" "), expected.hex(" "))
        self._compare_latches()

    def _compare_latches(self) -> None:
        """Compare the UART error byte and the status byte without the bits of the motors."""
        port = self.board.serial
        board = f"{int(port.uart_errors):02x} {int(port.status) & 0x0F:02x}"
        oracle = f"{self.oracle.uart_errors:02x} {self.oracle.status:02x}"
        if board != oracle:
            self._fail("The latched state (UART errors, status)", board, oracle)

    def _fail(self, subject: str, simulator: str, oracle: str) -> None:
        pytest.fail(
            f"{subject} differs after byte {len(self.stream) - 1}, the last of\n"
            f"  {self.stream.hex(' ')}\n"
            f"simulator: {simulator or 'nothing'}\n"
            f"oracle:    {oracle or 'nothing'}\n"
            f"{self.setup}\nraw: {self.oracle.raw}"
        )


def fourteen_bits(values: Calibration) -> bytes:
    return b"".join(bytes([value & 0x7F, value >> 7]) for value in values)


class StreamGenerator:
    """Creates random boards, signals and streams."""

    def __init__(self, random: Random) -> None:
        self.random = random

    def setup(self, mode: str = "") -> Setup:
        random = self.random
        parameters = {mask: random.randrange(32) for mask in MASKS if self.chance(0.4)}
        parameters |= {
            "motor_mode": int(self.chance(0.2)),
            "channel_input_source": random.randrange(2),
            "uart_settings": random.choice((0x05, 0x25)),
            "serial_timeout": random.choice((0, 0, 2, 5)),
            "crc7_polynomial": random.choice((0x09, self.byte(), self.byte())),
            "device_number": random.choice((7, 7, self.byte())),
        }
        channels = [(source, channel) for source in SOURCES for channel in range(1, 6)]
        mode = mode or random.choice(("serial", "serial", "serial", "rc", "analog"))
        source = ("rc", "analog")[parameters["channel_input_source"]]
        return Setup(
            random.choice(("trex", "trexjr")),
            random.choice(("1.0", "1.1", "1.2", "1.3")),
            mode,
            self.chance(0.5),
            parameters,
            {channel: self.calibration() for channel in channels if self.chance(0.4)},
            self.signals(source if mode == "serial" else mode),
        )

    def signals(self, source: str) -> list[str]:
        return [self.signal(source) for _ in range(5)]

    def signal(self, source: str) -> str:
        if source == "analog":
            return f"{self.random.randrange(5001) / 1000}V"
        if self.chance(0.2):
            return self.random.choice(("invalid", "silent"))
        return f"{self.random.randrange(450, 2551)}us"

    def calibration(self) -> Calibration:
        """Return a calibration that is typical of a source, or barely valid."""
        top = self.random.choice((1024, 5500, 16384))
        minimum, neutral, maximum = sorted(self.random.randrange(top) for _ in range(3))
        neutral = self.random.choice((minimum, neutral, neutral, neutral, maximum))
        deadband = self.random.randrange(self.random.choice((1, 100, 1000, 16384)))
        return Calibration(minimum, neutral, max(maximum, minimum + 1), deadband)

    def edge_calibration(self, raw: int) -> Calibration:
        """Return a calibration with this value at an end, neutral, a middle or the deadband."""
        near = max(0, raw + self.random.randint(-1, 1))
        width = self.random.choice((0, 1, 2, 10, 300))
        below, above = max(0, near - width), near + width
        low, high = max(0, below - width), above + width + 1
        ends = self.random.choice(
            ((low, below, near), (near, above, high), (below, near, high), (below, below, high))
        )
        return Calibration(*ends, self.random.choice((0, width, max(0, width - 1), width + 1)))

    def event(self, comparison: OracleComparison) -> None:
        """Rarely change signals, pause or cycle the power."""
        match self.random.randrange(30):
            case 0:
                comparison.power_cycle(self.signals)
            case 1 | 2 if comparison.setup.mode == "serial":
                comparison.connect(self.signals(comparison.oracle.source))
            case 3:
                comparison.pause(self.random.randrange(7))

    def bytes_for(self, oracle: Oracle) -> bytes:
        kind = self.random.randrange(20)
        if kind < 2:
            return self.some_bytes((256, 128)[kind], 10)
        if kind == 2:
            return bytes([self.random.choice(UNKNOWN_COMMANDS)]) + self.some_bytes(128, 2)
        if kind == 3:
            return b"\xff" * self.random.randint(1, 3)
        if kind == 4:
            status = sealed(bytes([self.random.choice((0x84, 0x85))]), oracle.polynomial)
            return status * self.random.randint(1, 3)
        packet = self.packet(oracle)
        if kind == 5:
            return packet[: self.random.randint(1, len(packet))]
        if kind == 6:
            cut = self.random.randint(1, len(packet))
            return packet[:cut] + bytes([self.random.randrange(128, 256)]) + packet[cut:]
        if kind == 7:
            at = self.random.randrange(len(packet))
            return packet[:at] + self.some_bytes(256, 1) + packet[at + 1 :]
        return packet

    def packet(self, oracle: Oracle) -> bytes:
        command = self.random.choice(COMMANDS_WITH_REPLY if self.chance(0.8) else COMMANDS)
        packet = bytes([command]) + self.data(command, oracle)
        if self.chance(0.4):
            number = oracle.stored("device_number") if self.chance(0.8) else self.byte()
            packet = bytes([0x80, number, command & 0x7F]) + packet[1:]
        if self.chance(0.05):  # a wrong, missing or unexpected CRC
            return sealed(packet, self.random.choice((None, 0x80 | self.byte())))
        return sealed(packet, oracle.polynomial)

    def data(self, command: int, oracle: Oracle) -> bytes:
        random = self.random
        known = table(oracle.model, oracle.firmware)
        closing = b"\x55\x2a" if self.chance(0.9) else self.some_bytes(128, 1) * 2
        if command in {0x86, 0x87}:
            return bytes([random.randrange(32) if self.chance(0.9) else self.byte()])
        if command == 0x9F:
            return bytes([random.choice(list(known)) if self.chance(0.8) else self.byte()])
        if command == 0xAF:
            if self.chance(0.3):
                return random.choice(SPECIAL_WRITES).to_bytes(2) + closing
            if self.chance(0.2):
                return bytes([self.byte(), self.byte()]) + closing
            parameter = random.choice(list(known.values()))
            value = random.randint(max(0, parameter.minimum - 1), min(127, parameter.maximum + 2))
            return bytes([parameter.number, value]) + closing
        if command in CALIBRATIONS:
            values = self.calibration()
            if self.chance(0.2):
                values = Calibration(values[1], values[0], values[2], values[3])
            return fourteen_bits(values) + closing
        return bytes(self.byte() for _ in range(data_bytes(command) or 0))

    def some_bytes(self, limit: int, max_count: int) -> bytes:
        return bytes(self.random.randrange(limit) for _ in range(self.random.randint(1, max_count)))

    def byte(self) -> int:
        return self.random.randrange(128)

    def chance(self, probability: float) -> bool:
        return self.random.randrange(100) < probability * 100


def compare_stream(random: Random, size: int) -> int:
    """Compare a stream of at least `size` bytes on one board. Return its size."""
    generator = StreamGenerator(random)
    comparison = OracleComparison(generator.setup())
    while len(comparison.stream) < size:
        generator.event(comparison)
        comparison.send(generator.bytes_for(comparison.oracle))
    return len(comparison.stream)


# Without shrinking, which would exceed the time limit of a test. Streams are short anyway.
WITHOUT_SHRINKING = examples(
    25,
    phases=(Phase.explicit, Phase.reuse, Phase.generate),
    suppress_health_check=list(HealthCheck),
)


def compare_streams(examples: int, size: int) -> int:
    """Compare streams that hypothesis seeds. Return the number of compared bytes."""
    total = 0

    @settings(WITHOUT_SHRINKING, max_examples=examples)
    @given(seed=st.integers(0, 2**64 - 1))
    def compare_seeded(seed: int) -> None:
        nonlocal total
        total += compare_stream(Random(seed), size)

    compare_seeded()
    return total


def test_simulator_matches_oracle_on_ten_thousand_bytes() -> None:
    assert compare_streams(25, 400) >= 10_000


@pytest.mark.slow
@pytest.mark.timeout(3600)
def test_simulator_matches_oracle_on_a_million_bytes() -> None:
    assert compare_streams(2100, 500) >= 1_000_000


@pytest.mark.parametrize(("mix", "joint"), [(False, 0), (True, 0), (True, 1)])
@pytest.mark.parametrize("source", ["rc", "analog"])
def test_remapped_channels_match_oracle_over_full_range(mix: bool, joint: int, source: str) -> None:
    """Channel 4 flips, and every channel passes both of its ends."""
    parameters = {
        "motor_mode": joint,
        "channel_input_source": int(source == "analog"),
        "reversed_channels": 0b01001 if mix else 0b00010,
        "parabolic_channels": 0b00110,
    }
    changed = Calibration(1800, 3600, 5900, 11) if source == "rc" else Calibration(60, 300, 999, 0)
    calibrations = {(source, 2): changed, (source, 3): changed}
    comparison = OracleComparison(Setup(mix=mix, parameters=parameters, calibrations=calibrations))
    for step in range(53):
        parts = [(step * stride % 53) / 52 for stride in (1, 7, 11, 13, 17)]
        if source == "rc":
            comparison.connect([f"{500 + round(2000 * part)}us" for part in parts])
        else:
            comparison.connect([f"{5 * part:.4f}V" for part in parts])
        comparison.send(bytes.fromhex("86 1f 87 1f"))


@WITHOUT_SHRINKING
@given(random=st.randoms(use_true_random=False))
def test_remapped_values_match_oracle_at_calibration_edges(random: Random) -> None:
    """Signals remain constant. Calibrations change, so that their edges pass the signals."""
    generator = StreamGenerator(random)
    setup = generator.setup("serial")
    setup.parameters["uart_settings"] = 0x05
    comparison = OracleComparison(setup)
    for _ in range(5):
        for command, raw in zip(CALIBRATIONS, comparison.board.channels.raw, strict=True):
            comparison.send(
                bytes([command]) + fourteen_bits(generator.edge_calibration(raw or 0)) + b"\x55\x2a"
            )
        comparison.send(b"\x87\x1f")


@pytest.mark.parametrize("firmware", ["1.0", "1.2"])
def test_parameters_match_oracle_at_limits_of_their_values(firmware: str) -> None:
    comparison = OracleComparison(Setup(firmware=firmware))
    for number in range(128):
        values = {0, 1, 127}
        if parameter := table("trex", firmware).get(number):
            values |= {parameter.minimum, parameter.maximum, min(127, parameter.maximum + 1)}
        for value in range(128) if number == 0x7E else sorted(values):
            comparison.send(bytes([0x9F, number, 0xAF, number, value, 0x55, 0x2A, 0x9F, number]))


@pytest.mark.parametrize(("mode", "signal"), [("rc", "1000us"), ("analog", "0.1V")])
def test_safe_start_continues_if_override_is_on_at_power_up(mode: str, signal: str) -> None:
    comparison = OracleComparison(Setup(mode=mode, signals=["rest"] * 4 + [signal]))
    comparison.oracle.safe_start = True
    comparison.send(b"\x83")
