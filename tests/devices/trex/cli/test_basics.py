"""Basic commands on a simulated board."""

import json
import shlex

import pytest
from click.testing import CliRunner

from tests.devices.trex.cli.conftest import becomes
from tests.devices.trex.conftest import STOPPED, motor
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_command import RunCommand
from tests.support.virtual_devices import VirtualSimulator
from tests.support.virtual_time import VirtualRuntime
from trex_gui.cli import main
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.recording import sample_kinds
from trex_gui.ui.runtime import open_transport


def test_status_json_contains_product_and_parameters(trexcmd: RunCommand) -> None:
    report = json.loads(trexcmd("status", "--json").stdout)
    assert report["product"] == "TReX"
    assert report["firmware"] == "1.2"
    assert report["mode"] == "r"
    assert report["motor_1_current_A"] == 0.0
    assert report["channels"][0] == {"channel": 1, "raw": 3750, "pulse_us": 1500.0, "remapped": 0}
    assert len(report["parameters"]) == 28
    assert report["parameters"]["uart_settings"]["value"] == 5


def test_status_names_latched_errors_as_recordings_do(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    assert json.loads(trexcmd("status", "--json").stdout)["errors"] == []
    quick_simulator.do("fault 1 on")
    assert "Errors: Motor 1 fault" in trexcmd("status").stdout
    errors = json.loads(trexcmd("status", "--json").stdout)["errors"]
    assert errors == [{"name": "status_motor1_fault", "text": "Motor 1 fault", "is_earlier": False}]
    columns = {name for kind in sample_kinds(InputSource.RC, 0.15) for name in kind.exported}
    assert {row["name"] for row in errors} < columns
    quick_simulator.do("fault 1 off")
    report = json.loads(trexcmd("status", "--json").stdout)
    assert (report["errors"], report["motors"]) == (errors, []), "a past fault stops no motor"


def test_line_errors_of_a_search_do_not_explain_stopped_motors(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("eeprom uart_settings 8")  # 57600 baud
    quick_simulator.do("power cycle")
    trexcmd("find")
    result = trexcmd("status", "--baud", "57600")
    assert "  Nothing prevents the motors from following serial commands.\n" in result.stdout
    assert "Errors: none\n" in result.stdout
    latched = "Earlier errors, perhaps from a search for the board: UART error, Framing error"
    assert latched in result.stdout


def test_line_errors_during_the_command_explain_stopped_motors(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    assert isinstance(quick_simulator, VirtualSimulator)

    def damage_next_byte(sent: bytes) -> None:
        if sent[:1] == b"\x8f":  # the request for the currents
            quick_simulator.on_write = lambda _sent: None
            quick_simulator.do("line error framing")

    quick_simulator.on_write = damage_next_byte
    report = json.loads(trexcmd("status", "--json").stdout)
    assert [row["name"] for row in report["motors"]] == ["line_error"]
    assert {row["name"] for row in report["errors"]} >= {"status_uart_error", "uart_framing"}
    assert not any(row["is_earlier"] for row in report["errors"])


def test_status_shows_every_reason_for_stopped_motors(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    text = "  Nothing prevents the motors from following serial commands.\n"
    assert text in trexcmd("status").stdout
    assert json.loads(trexcmd("status", "--json").stdout)["motors"] == []

    quick_simulator.do("jumper mode rc", "channel 2 1680us", "power cycle", "channel 2 1680us")
    assert becomes(lambda: quick_simulator.show()["channels"][1]["raw"], 4200)
    quick_simulator.do("fault 1 on")
    text = trexcmd("status").stdout
    assert "  Channel 2 is 180 µs above neutral. Safe-start holds the motors until" in text
    assert "LEDs:                 red flickers with each packet, green flashes fast" in text
    assert "If the green LED is steady instead, safe-start is over." in text
    report = json.loads(trexcmd("status", "--json").stdout)
    assert [(row["name"], row["effect"]) for row in report["motors"]] == [
        ("channel_above", "stops"),
        ("fault", "stops"),
        ("rc_channels", "blocks"),
    ]
    assert report["leds"] == {"red": "with packets", "green": "fast flash"}


def test_status_shows_setpoints_and_log(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    sources = [row["source"] for row in json.loads(trexcmd("status", "--json").stdout)["setpoints"]]
    assert sources == ["not_armed"] * 3
    quick_simulator.do("jumper mode rc", "power cycle")
    assert becomes(lambda: quick_simulator.show()["safe_start"], False)
    quick_simulator.do("channel 2 1250us", "line error framing")
    assert becomes(lambda: quick_simulator.show()["channels"][1]["raw"], 3125)
    result = trexcmd("status").stdout
    assert "Motor 2 setpoint:     -59 (channel)\n" in result
    assert "Log:\n  Connected to TReX 1.2 on " in result
    assert "Latched before connecting, perhaps by a search for the board: Framing" in result


def test_past_serial_timeout_does_not_explain_stopped_motors(
    trexcmd: RunCommand, virtual_time: VirtualRuntime
) -> None:
    trexcmd("set", "serial_timeout", "1")
    virtual_time.sleep(0.2)
    report = json.loads(trexcmd("status", "--json").stdout)
    assert {row["name"] for row in report["errors"]} == {"status_uart_error", "uart_timeout"}
    assert report["motors"] == [], "the board receives packets again"


def test_get_shows_wire_value_and_meaning(trexcmd: RunCommand) -> None:
    assert trexcmd("get", "device_number").stdout == "7\t7\n"
    assert trexcmd("get", "Motor Mode").stdout == "0\tindependent\n"


@pytest.mark.parametrize(
    ("typed", "wire"),
    [("15", 15), ("+15", 15), ("1.5 s", 15), ("1,5 s", 15), ("1500 ms", 15), ("off", 0)],
)
def test_set_accepts_wire_and_physical_values(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, typed: str, wire: int
) -> None:
    trexcmd("set", "serial_timeout", typed)
    assert quick_simulator.show()["parameters"]["serial_timeout"] == wire


def test_set_reports_when_a_power_cycle_is_needed(trexcmd: RunCommand) -> None:
    assert "switched off and on" in trexcmd("set", "motor_mode", "joint").stderr


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ("set serial_timeout 999", "off to 12.7 s (wire value 0 to 127), not 999"),
        ("set serial_timeout soon", "off to 12.7 s, not soon"),
        ("set serial_timeout '1,000 ms'", "1,000 is ambiguous: write 1 or 1000"),
        ("set serial_timeout 5.", "5. has no unit, and a wire value must be a whole number"),
        ("set serial_timeot 2", "Did you mean serial_timeout?"),
        ("set factory_reset 127", "`trexcmd restore-defaults`"),
        ("get nosuch", "No TReX has a parameter 'nosuch'."),
        ("get factory_reset", "can only be written"),
        ("calibration set 1 99999 99999 99999 20", "a calibration value must be 0 to 16383"),
        ("calibration set 1 1ms 2V 2ms 20", "cannot contain both µs and V"),
        (
            "calibration set 1 '1,000 µs' 1500us 2000us 20",
            "MINIMUM: 1,000 is ambiguous: write 1 or 1000",
        ),
        ("calibration set 1 a 1 2 3", "counts (3750) or a value with a unit (1500us, 2.5V)"),
        ("calibration set 6 1 2 3 4", "1<=x<=5"),
        ("status --timeout nan", "nan is not a number"),
        ("status --baud 1234", "not 1234"),
        ("status --polynomial 11", "80"),
        ("status --crc --parity even", "either CRC or parity"),
        ("status --port foo://x", "'foo' is not a kind of port"),
        ("status --port socket://nohost", "socket://host:port"),
        ("list --port socket://host:99999", "socket://host:port"),
        ("aracna query --port rfc2217://:1", "rfc2217://host:port"),
        ("motor 1 20 --seconds inf", "inf is not a number"),
        ("motor 1 128", "-127 to 127"),
        ("motor 3 10", "is not one of"),
        ("motor aux -1", "0 to 127"),
        ("motor aux 5 --brake", "has no brake"),
        ("motor 1 -5 --brake", "0 to 127"),
        ("motor 1 fast", "is not a valid integer"),
        ("motor 1", "Missing argument"),
        ("motor 1 5 --seconds 0", "is not in the range x>0"),
        ("motor 1 5 --secnds 1", "unexpected extra arguments"),
        ("stream --seconds nan", "nan is not a number"),
        ("stream --seconds 0", "is not in the range x>0"),
        ("stream --json --csv -", "cannot be combined"),
        ("stream --limit 0", "is not in the range x>=1"),
        ("stream --interval -1", "is not in the range x>=0"),
        ("stream --separator ab", "is neither a character such as"),
        ("stream --separator .", "is neither a character such as"),
        ("stream --json --separator ;", "has no effect with --json"),
        ("raw GG", "GG"),
        ("raw --seconds 1 81", "--seconds needs a motor command"),
        (f"raw {'81 ' * 300}", "300 bytes are too many"),
        ("decode 8G", "hexadecimal"),
        ("decode", "Missing argument"),
        ("decode ' '", "Enter bytes in hexadecimal"),
        ("decode --crc --polynomial 11 81", "80"),
        ("export -", "Missing option '--as'"),
        ("export --as pascal -", "is not one of"),
        ("status --reserve 7", "a device number that no other device on the line has"),
        ("status --reserve 128", "0 to 127, not 128"),
        ("status --reserve x", "invalid literal"),
        ("set-settings any.txt --devices 3,3", "each device number only once"),
        ("set-settings any.txt --devices 128", "0 to 127, not '128'"),
        ("set-settings any.txt --devices ''", "0 to 127, not ''"),
        ("check-settings any.txt - --json", "cannot both use standard output"),
        ("diff - -", "standard input"),
        ("history path -- -1", "is neither the number"),
        ("history path first", "is neither the number"),
        ("history path ./1", "is neither the number"),
        ("history name 1", "Give a name"),
        ("history --find x path 1", "has no --find"),
        ("history --json show 1", "after show"),
        ("history keep 0", "Give a number of snapshots"),
        ("history keep many", "Give a number of snapshots"),
        ("history keep 10000000", "Give a number of snapshots"),
        (f"history keep {'9' * 5000}", "Give a number of snapshots"),
        ("check-settings ''", "name of the file is empty"),
        ("stop --traffic ''", "name of the file is empty"),
        ("history show ''", "name of the file is empty"),
        ("aracna play ''", "name of the file is empty"),
        ("get", "Missing argument"),
        ("fly", "No such command"),
    ],
)
def test_wrong_usage_exits_with_2_before_a_port_is_opened(words: str, sentence: str) -> None:
    result = CliRunner().invoke(main, shlex.split(words), env={"TREX_PORT": "/dev/none"})
    assert sentence in result.stderr
    assert result.exit_code == 2
    assert "Traceback" not in result.stderr


def test_stop_brakes_running_motors(trexcmd: RunCommand, quick_simulator: SimulatedDevice) -> None:
    port = open_transport(ConnectionSettings(quick_simulator.url))
    port.write(bytes.fromhex("C2 50"))
    port.wait(0.1)
    port.close()
    assert becomes(lambda: motor(quick_simulator), ("forward", 0x50))
    trexcmd("stop")
    assert motor(quick_simulator) == STOPPED


def test_missing_parameter_exits_with_1(
    trexcmd: RunCommand, start_simulator: StartSimulator
) -> None:
    url = start_simulator("--firmware", "1.0").url
    result = trexcmd("set", "uart_response_delay", "1", "--port", url, exits=1)
    assert "TReX 1.0 has no parameter" in result.stderr


def test_missing_port_is_usage_error_naming_trex_port() -> None:
    result = CliRunner().invoke(main, ["status"], env={"TREX_PORT": ""})
    assert result.exit_code == 2
    assert "TREX_PORT" in result.stderr


def test_status_names_the_options_that_reach_the_board(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("eeprom uart_settings 0x65")  # odd parity
    quick_simulator.do("power cycle")
    result = trexcmd("status", exits=1)
    assert "A TReX 1.2 responds on" in result.stderr
    assert "odd parity, but this connection uses 19200 baud." in result.stderr
    url = quick_simulator.url
    assert result.stderr.endswith(f"Use these options:\n--port {url} --baud 19200 --parity odd\n")
    trexcmd("status", "--parity", "odd")
    assert quick_simulator.show()["counters"]["packets"] > 0

    quick_simulator.do("jumper mode serial", "jumper mix on", "jumper so-ground on", "power cycle")
    assert "in learning mode" in trexcmd("status", exits=1).stderr
    quick_simulator.do("jumper mix off", "jumper so-ground off")
    assert "is in its boot loader" in trexcmd("status", "--parity", "odd", exits=1).stderr
