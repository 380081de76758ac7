"""Models, parameters, safe-start and jumpers, from User's Guide 4 and other sources."""

import pytest

from tests.devices.trex.conformance.trex import Trex, only

# Models


@only(model="trexjr")
def test_trex_jr_signature_has_nine_bytes(trex: Trex) -> None:
    """The sources are F2170 and two clients."""
    assert trex.request("81") == "54 52 65 58 4A 72 31 2E 32"
    trex.assert_silence(0.02)


@only(model="trexjr")
def test_trex_jr_current_is_in_units_of_40_ma(trex: Trex) -> None:
    """The sources are F13311 and a client."""
    trex.control("current 1 2")
    trex.control("current 2 0.4")
    trex.wait(0.02)
    assert trex.request("8F") == "32 0A"


@only(model="trexjr", firmware="1.3")
def test_trex_jr_firmware_1_3_has_parameter_17(trex: Trex) -> None:
    """F12089 and F20957: the version 1.3 only marks a change of the board."""
    assert bytes.fromhex(trex.request("81")) == b"TReXJr1.3"
    assert trex.request("9F 17") == "00"


# Parameters


@pytest.mark.parametrize(("wire", "below", "above"), [(1, 2, 3), (100, 200, 201)])
def test_current_limit_is_twice_its_parameter(
    trex: Trex, wire: int, below: int, above: int
) -> None:
    """F13311: the parameter is half the limit, in the unit of the current."""
    trex.set_parameters(motor2_current_limit=wire)
    for counts, status in ((below, "00"), (above, "80")):
        trex.control(f"current 2 {counts * 0.150:.3f}")
        trex.send("CE 01")
        trex.wait(0.025)
        assert trex.request("84") == status


def test_serial_timeout_counts_tenths_of_a_second(trex: Trex) -> None:
    """Two clients say "x0.1 s, max 13 s"."""
    trex.set_parameters(serial_timeout=2)
    trex.send("C2 20")
    for state in trex.watch(0.24):
        direction = state["motors"][0]["direction"]
        if trex.most_updates <= 19:
            assert direction == "forward"
        elif trex.fewest_updates >= 22:
            assert direction == "brake"
    assert direction == "brake"


def test_ignored_channel_is_held_at_neutral(trex: Trex) -> None:
    """User's Guide 4.c: parameter 0x02."""
    trex.connect(c1="2000us", c2="2000us", c3="2000us")
    assert trex.request("AF 02 05 55 2A") == "00"
    assert trex.request("87 07") == "00 7F 00"


def test_new_board_requires_only_channel_1(trex: Trex) -> None:
    """User's Guide 4.c. Inferred: bit n is channel n+1."""
    assert trex.request("9F 01") == "01"
    for channel in (2, 3, 4, 5):
        trex.control(f"channel {channel} silent")
    trex.start("rc")
    trex.connect(c1="2000us")
    assert trex.motor(1) == ("forward", 127)


# Safe-start


def assert_stick_prevents_start(trex: Trex, channel: int) -> None:
    trex.control(f"channel {channel} 2000us")
    trex.restart_in("rc")
    for state in trex.watch(0.15):
        assert state["safe_start"]
        assert [motor["direction"] for motor in state["motors"]] == ["brake", "brake"]
        assert state["aux"]["speed"] == 0


def assert_channel_5_prolongs_safe_start(trex: Trex) -> None:
    trex.send("D6 30 40")
    trex.control("channel 5 1000us")
    trex.restart_in("rc")
    for state in trex.watch(0.15):
        assert state["safe_start"]
        assert not state["serial_controls"]


@pytest.mark.parametrize("channel", [1, 2, 3])
def test_motors_stay_off_until_channels_were_near_neutral(trex: Trex, channel: int) -> None:
    """User's Guide 4.e: safe-start at power-up."""
    assert_stick_prevents_start(trex, channel)
    trex.connect(**{f"c{channel}": "1500us"})
    trex.connect(**{f"c{channel}": "2000us"})
    state = trex.show()
    assert not state["safe_start"]
    assert [*(motor["speed"] for motor in state["motors"]), state["aux"]["speed"]][channel - 1]


def test_safe_start_lasts_while_channel_5_overrides(trex: Trex) -> None:
    """User's Guide 4.e: only with "ch 5 not overriding"."""
    assert_channel_5_prolongs_safe_start(trex)
    trex.connect(c5="1500us")
    assert not trex.show()["safe_start"]


@only(harness="parser")  # the line does not affect safe-start
@pytest.mark.parametrize("moment", [0.0025, 0.0075])
def test_safe_start_holds_at_any_power_up_time_between_pulses(trex: Trex, moment: float) -> None:
    """User's Guide 4.e: "all motor channels near neutral, and ch 5 not overriding, all at once"."""
    for channel in (1, 2, 3):
        trex.wait(moment - trex.now() % 0.01 + 0.01)
        assert_stick_prevents_start(trex, channel)
        trex.connect(**{f"c{channel}": "rest"})
    trex.wait(moment - trex.now() % 0.01 + 0.01)
    assert_channel_5_prolongs_safe_start(trex)


@only(harness="parser")  # the line does not affect safe-start
@pytest.mark.parametrize(("silence", "runs"), [(0.4, True), (0.6, False)])
def test_silent_required_channel_starts_safe_start_after_500_ms(
    trex: Trex, silence: float, runs: bool
) -> None:
    """User's Guide 4.c: safe-start begins after more than 500 ms."""
    trex.set_parameters(required_channels=2)
    trex.start("rc")
    trex.connect(c1="2000us")
    trex.control("channel 2 silent")
    trex.wait(silence)
    assert (trex.motor(1)[0] == "forward") is runs
    assert trex.show()["safe_start"] is not runs


# Jumpers and joint mode


def test_mix_jumper_never_alters_serial_motor_commands(trex: Trex) -> None:
    """FV9053. The jumper does alter remapped values in serial mode."""
    trex.control("jumper mix on")
    trex.send("D6 30 40")
    trex.connect(c2="2000us")
    assert (trex.motor(1), trex.motor(2)) == (("forward", 0x30), ("reverse", 0x40))
    assert trex.request("87 03") == "7F 7F"


def test_joint_mode_accepts_motor_1_and_auxiliary_commands(trex: Trex) -> None:
    """Manual of the TReX Jr, page 6. Motor 2 does not exist in joint mode."""
    trex.set_parameters(motor_mode=1)
    trex.send("C2 44", "CA 33", "F0 22")
    assert trex.motor(1) == ("forward", 0x44)
    assert trex.motor(2)[1] == 0
    assert trex.show()["aux"]["speed"] == 0x22


def test_joint_mode_does_not_mix_channels(trex: Trex) -> None:
    """The source is page 6 of the manual of the TReX Jr."""
    trex.control("jumper mix on")
    trex.set_parameters(motor_mode=1)
    trex.connect(c1="2000us", c2="1500us")
    assert trex.request("87 01") == "7F"
    trex.connect(c1="1500us", c2="2000us")
    assert trex.request("87 01") == "00"
