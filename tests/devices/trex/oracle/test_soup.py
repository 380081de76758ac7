"""The oracle against the simulator, byte for byte, on whatever a line may carry.

The long run is a million bytes and takes minutes: `pytest tests/oracle --all`.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from random import Random

import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from tests.devices.trex.oracle.device import Oracle, table
from tests.devices.trex.oracle.framing import COMMANDS, NO_COMMANDS, data_bytes, sealed
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
TALKATIVE = [command for command in COMMANDS if command < 0xC0] + [0x9F, 0xAF] * 3
REPORTED = [0x0007, 0x0009, 0x7B00, 0x7B01, 0x7C00, 0x7C01, 0x7E05, 0x7E25, 0x7F7F]  # to write
READABLE_SETTINGS = {0x05, 0x25}  # at the rate and in the shape that the line here has

# No wait here ends near a multiple of 0.1 s after the last byte: that is where timeouts fall.
MOMENT = 0.003  # longer than a reply and its optional delay
WRITE = 0.05  # longer than EEPROM takes, which is 4 ms or 32 ms
SETTLE = 0.22  # until every signal has been measured


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
    """One board and one oracle that hear the same bytes."""

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
        self._learn_who_controls()

    def connect(self, signals: list[str]) -> None:
        self.setup.signals = signals
        for channel, text in enumerate(signals, 1):
            self.board.channels.signals[channel] = Signal.parse(text, SOURCES[self.oracle.source])
        self._wait(SETTLE)
        self.oracle.raw = self.board.channels.raw

    def drive(self, stream: bytes) -> None:
        for byte in stream:
            self._step(byte)

    def pause(self, tenths: int) -> None:
        self._wait(tenths * 0.1 + 0.02)
        self._compare_latches()

    def power_cycle(self, signals: Callable[[str], list[str]]) -> None:
        """Unless the line would then be set otherwise than ours, where no byte gets through."""
        if self.oracle.stored("uart_settings") in READABLE_SETTINGS:
            self.board.power_cycle()
            self.oracle.power_cycle()
            self.connect(signals(self.oracle.source))
            self._learn_who_controls()

    def _learn_who_controls(self) -> None:
        """Ask the board who controls, as the end of safe-start depends on sticks and time."""
        if self.setup.mode == "serial":
            return
        packet = sealed(b"\x83", self.oracle.polynomial)
        self.line.send(packet)
        self._wait(MOMENT)
        self.oracle.safe_start = self.line.receive()[0] == 0
        for byte in packet:
            self.oracle.feed(byte)

    def _wait(self, seconds: float) -> None:
        self.line.advance(seconds)
        self.oracle.pause(seconds)

    def _step(self, byte: int) -> None:
        self.stream.append(byte)
        self.line.send(bytes([byte]))
        self.line.advance(MOMENT)
        reply = self.line.receive()
        self.oracle.measured = reply
        expected = self.oracle.feed(byte)
        self.oracle.pause(MOMENT)
        if self.oracle.wrote:
            self._wait(WRITE)
            reply += self.line.receive()
        if reply != expected:
            self._differs("The reply", reply.hex(" "), expected.hex(" "))
        self._compare_latches()

    def _compare_latches(self) -> None:
        """The UART error byte, and of the status byte what is not the motors'."""
        port = self.board.serial
        board = f"{int(port.uart_errors):02x} {int(port.status) & 0x0F:02x}"
        oracle = f"{self.oracle.uart_errors:02x} {self.oracle.status:02x}"
        if board != oracle:
            self._differs("What is latched (UART errors, status)", board, oracle)

    def _differs(self, what: str, simulator: str, oracle: str) -> None:
        pytest.fail(
            f"{what} differs after byte {len(self.stream) - 1}, the last of\n"
            f"  {self.stream.hex(' ')}\n"
            f"simulator: {simulator or 'nothing'}\n"
            f"oracle:    {oracle or 'nothing'}\n"
            f"{self.setup}\nraw: {self.oracle.raw}"
        )


def fourteen_bits(values: Calibration) -> bytes:
    return b"".join(bytes([value & 0x7F, value >> 7]) for value in values)


class SoupRunner:
    """Boards to be tried, and what to pour over them."""

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
        """As a person would set it for either source, or just within the rules."""
        top = self.random.choice((1024, 5500, 16384))
        minimum, neutral, maximum = sorted(self.random.randrange(top) for _ in range(3))
        neutral = self.random.choice((minimum, neutral, neutral, neutral, maximum))
        deadband = self.random.randrange(self.random.choice((1, 100, 1000, 16384)))
        return Calibration(minimum, neutral, max(maximum, minimum + 1), deadband)

    def edge(self, raw: int) -> Calibration:
        """One in which this value stands at an end, at neutral, half-way or at the deadband."""
        near = max(0, raw + self.random.randint(-1, 1))
        width = self.random.choice((0, 1, 2, 10, 300))
        below, above = max(0, near - width), near + width
        low, high = max(0, below - width), above + width + 1
        ends = self.random.choice(
            ((low, below, near), (near, above, high), (below, near, high), (below, below, high))
        )
        return Calibration(*ends, self.random.choice((0, width, max(0, width - 1), width + 1)))

    def event(self, duel: OracleComparison) -> None:
        """Now and then something that is not a byte."""
        match self.random.randrange(30):
            case 0:
                duel.power_cycle(self.signals)
            case 1 | 2 if duel.setup.mode == "serial":
                duel.connect(self.signals(duel.oracle.source))
            case 3:
                duel.pause(self.random.randrange(7))

    def spoonful(self, oracle: Oracle) -> bytes:
        kind = self.random.randrange(20)
        if kind < 2:
            return self.some_bytes((256, 128)[kind], 10)
        if kind == 2:
            return bytes([self.random.choice(NO_COMMANDS)]) + self.some_bytes(128, 2)
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
        command = self.random.choice(TALKATIVE if self.chance(0.8) else COMMANDS)
        packet = bytes([command]) + self.data(command, oracle)
        if self.chance(0.4):
            number = oracle.stored("device_number") if self.chance(0.8) else self.byte()
            packet = bytes([0x80, number, command & 0x7F]) + packet[1:]
        if self.chance(0.05):  # a checksum of another kind, or none, or one too many
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
                return random.choice(REPORTED).to_bytes(2) + closing
            if self.chance(0.2):
                return bytes([self.byte(), self.byte()]) + closing
            one = random.choice(list(known.values()))
            value = random.randint(max(0, one.minimum - 1), min(127, one.maximum + 2))
            return bytes([one.number, value]) + closing
        if command in CALIBRATIONS:
            values = self.calibration()
            if self.chance(0.2):
                values = Calibration(values[1], values[0], values[2], values[3])
            return fourteen_bits(values) + closing
        return bytes(self.byte() for _ in range(data_bytes(command) or 0))

    def some_bytes(self, top: int, most: int) -> bytes:
        return bytes(self.random.randrange(top) for _ in range(self.random.randint(1, most)))

    def byte(self) -> int:
        return self.random.randrange(128)

    def chance(self, share: float) -> bool:
        return self.random.randrange(100) < share * 100


def pour(random: Random, size: int) -> int:
    """Pour soup over one board until it has heard so many bytes. Return how many it were."""
    cook = SoupRunner(random)
    duel = OracleComparison(cook.setup())
    while len(duel.stream) < size:
        cook.event(duel)
        duel.drive(cook.spoonful(duel.oracle))
    return len(duel.stream)


# Streams are short and shown whole; shrinking one outlasts the time that a test has.
WITHIN_TIME = examples(
    25,
    phases=(Phase.explicit, Phase.reuse, Phase.generate),
    suppress_health_check=list(HealthCheck),
)


def poured(examples: int, length: int) -> int:
    """Let hypothesis choose soups, others each time. Return how many bytes were compared."""
    total = 0

    @settings(WITHIN_TIME, max_examples=examples)
    @given(seed=st.integers(0, 2**64 - 1))
    def pour_one(seed: int) -> None:
        nonlocal total
        total += pour(Random(seed), length)

    pour_one()
    return total


def test_simulator_matches_oracle_on_ten_thousand_bytes() -> None:
    assert poured(25, 400) >= 10_000


@pytest.mark.slow
@pytest.mark.timeout(3600)
def test_simulator_matches_oracle_on_a_million_bytes() -> None:
    assert poured(2100, 500) >= 1_000_000


@pytest.mark.parametrize(("mix", "joint"), [(False, 0), (True, 0), (True, 1)])
@pytest.mark.parametrize("source", ["rc", "analog"])
def test_remapped_channels_match_oracle_over_full_range(mix: bool, joint: int, source: str) -> None:
    """A sweep in which channel 4 flips and every channel passes both of its ends."""
    parameters = {
        "motor_mode": joint,
        "channel_input_source": int(source == "analog"),
        "reversed_channels": 0b01001 if mix else 0b00010,
        "parabolic_channels": 0b00110,
    }
    unexpected = (
        Calibration(1800, 3600, 5900, 11) if source == "rc" else Calibration(60, 300, 999, 0)
    )
    calibrations = {(source, 2): unexpected, (source, 3): unexpected}
    duel = OracleComparison(Setup(mix=mix, parameters=parameters, calibrations=calibrations))
    for step in range(53):
        parts = [(step * stride % 53) / 52 for stride in (1, 7, 11, 13, 17)]
        if source == "rc":
            duel.connect([f"{500 + round(2000 * part)}us" for part in parts])
        else:
            duel.connect([f"{5 * part:.4f}V" for part in parts])
        duel.drive(bytes.fromhex("86 1f 87 1f"))


@WITHIN_TIME
@given(random=st.randoms(use_true_random=False))
def test_remapped_values_match_oracle_at_calibration_edges(random: Random) -> None:
    """The signals stay, and calibrations are laid so that their edges pass over them."""
    cook = SoupRunner(random)
    setup = cook.setup("serial")
    setup.parameters["uart_settings"] = 0x05
    duel = OracleComparison(setup)
    for _ in range(5):
        for command, raw in zip(CALIBRATIONS, duel.board.channels.raw, strict=True):
            duel.drive(bytes([command]) + fourteen_bits(cook.edge(raw or 0)) + b"\x55\x2a")
        duel.drive(b"\x87\x1f")


@pytest.mark.parametrize("firmware", ["1.0", "1.2"])
def test_parameters_match_oracle_at_edges_of_their_values(firmware: str) -> None:
    duel = OracleComparison(Setup(firmware=firmware))
    for number in range(128):
        values = {0, 1, 127}
        if one := table("trex", firmware).get(number):
            values |= {one.minimum, one.maximum, min(127, one.maximum + 1)}
        for value in range(128) if number == 0x7E else sorted(values):
            duel.drive(bytes([0x9F, number, 0xAF, number, value, 0x55, 0x2A, 0x9F, number]))


def test_power_cycle_parameters_match_oracle() -> None:
    duel = OracleComparison(Setup(mix=True))
    for write in ("7b 01", "7c 01", "7d 65", "00 09", "7f 7f", "00 08"):
        duel.drive(bytes.fromhex(f"af {write} 55 2a 82 86 1f 87 1f 9f 7b 9f 7c 9f 00"))
        duel.power_cycle(SoupRunner(Random(write)).signals)
        duel.drive(bytes.fromhex("82 86 1f 87 1f 9f 7b 9f 7c 9f 7d 9f 7e 9f 7f 9f 00"))


def test_motors_at_rest_draw_no_current() -> None:
    for joint in (0, 1):
        duel = OracleComparison(Setup(parameters={"motor_mode": joint}))
        duel.line.send(b"\x8f")
        duel.line.advance(MOMENT)
        assert duel.line.receive() == b"\0\0"


@pytest.mark.parametrize(("mode", "away"), [("rc", "1000us"), ("analog", "0.1V")])
def test_override_matches_oracle_after_safe_start(mode: str, away: str) -> None:
    duel = OracleComparison(Setup(mode=mode))
    duel.drive(b"\x83")
    duel.connect(["rest"] * 4 + [away])
    duel.oracle.safe_start = False
    duel.drive(b"\x83\x85\x84")


@pytest.mark.parametrize(("mode", "away"), [("rc", "1000us"), ("analog", "0.1V")])
def test_override_since_power_up_keeps_safe_start(mode: str, away: str) -> None:
    duel = OracleComparison(Setup(mode=mode, signals=["rest"] * 4 + [away]))
    duel.oracle.safe_start = True
    duel.drive(b"\x83")
