"""Control lines: replies, effects and errors."""

from tests.support.aracna import AracnaHarness
from trex_gui.core.simulator.control_lines import GOODBYE
from trex_gui.devices.aracna.simulator.control import control, state

ACCEPTED = [
    ("reset", "the board restarts; the servos continue"),
    ("power off", "power off"),
    ("power on", "power on"),
    ("  POWER   Cycle ", "power on"),
    ("servo 0 dead", "servo 0 dead"),
    ("servo 7 alive", "servo 7 alive"),
    ("servo 1 block", "servo 1 blocked"),
    ("servo 1 free", "servo 1 free"),
    ("servo 1 load 0.25", "servo 1 loses 0.25 of its speed"),
    ("servo 1 lose position", "servo 1 does not reply to the next 1 read of position"),
    ("servo 1 lose speed 3", "servo 1 does not reply to the next 3 reads of speed"),
    ("servo power off", "servo power off"),
    ("servo power on", "servo power on"),
    ("line drop 3 sent", "bytes to lose on the way from the host: 3"),
    ("line cut 4", "the rest of a line is lost after 4 bytes"),
    ("line cut off", "no reply is cut"),
]


def test_valid_control_line_is_confirmed(harness: AracnaHarness) -> None:
    for text, reply in ACCEPTED:
        assert control(harness.line, text) == f"ok {reply}"
    assert control(harness.line, "QUIT") == GOODBYE


COMMANDS = "commands are reset, power, servo, line, show, quit"
SERVO = "usage: servo N dead|alive|block|free, servo N load F"
LINE = "usage: line mute on|off, line drop N [sent]"

REJECTED = [
    ("", f"no command; {COMMANDS}"),
    ("warp 9", f"'warp' is not a command; {COMMANDS}"),
    ("reset now", "usage: reset"),
    ("show all", "usage: show"),
    ("power", "usage: power on|off|cycle"),
    ("power maybe", "usage: power on|off|cycle"),
    ("servo", SERVO),
    ("servo 3", SERVO),
    ("servo power", SERVO),
    ("servo power maybe", SERVO),
    ("servo 3 jump", SERVO),
    ("servo 3 lose faith", SERVO),
    ("servo 8 dead", "a servo must be 0 to 7, not '8'"),
    ("servo -1 dead", "a servo must be 0 to 7, not '-1'"),
    ("servo x dead", "a servo must be 0 to 7, not 'x'"),
    ("servo 3 load 2", "a load must be 0 to 1, not '2'"),
    ("servo 3 lose speed -1", "a number of reads must be 0 to 999999999, not '-1'"),
    ("line warp", LINE),
    (f"line garbage {'00' * 10_001}", "garbage must be at most 10000 bytes, not 10001"),
    ("line drop 1 received", LINE),
    ("line cut", LINE),
    ("line cut -1", "the number of bytes must be 0 to 999999999, not '-1'"),
]


def test_invalid_control_line_is_explained_and_ignored(harness: AracnaHarness) -> None:
    before = state(harness.line)
    for text, message in REJECTED:
        assert control(harness.line, text).startswith(f"error {message}")
        assert state(harness.line) == before


def test_unpowered_board_rejects_reset(harness: AracnaHarness) -> None:
    harness.do("power off")
    reply = control(harness.line, "reset")
    assert reply == "error the board has no power; switch the power on first"


def test_show_reports_led_and_servo_states(harness: AracnaHarness) -> None:
    harness.request(b".v50,50,50,50,50,50,50,50\n")
    harness.request(b".l1\n")
    harness.do("servo 2 dead")
    harness.line.send(b".c740,740,740,740,740,740,740,740\n")
    harness.line.advance(0.5)
    shown = state(harness.line)
    assert (shown["aracna"], shown["version"], shown["motors"]) == (True, 1, 8)
    assert shown["counters"]["board"]["restarts"] == 0
    assert shown["state"] == "moving"
    assert shown["led"] is True
    first, dead = shown["servos"][0], shown["servos"][2]
    assert (first["goal"], first["speed"], first["moving"], first["torque"]) == (
        740,
        50,
        True,
        True,
    )
    assert 520 < first["position"] < 740
    assert (dead["goal"], dead["moving"], dead["alive"]) == (512, False, False)
