"""trexcmd find and list, for a port with a robot, a board, or nothing."""

import json

from tests.support.simulator import SimulatedDevice
from tests.support.virtual_command import RunCommand
from tests.support.virtual_time import VirtualRuntime
from trex_gui.core.transport.settings import PortSettings


def test_find_reports_aracna_and_trex_in_same_format(
    trexcmd: RunCommand, robot: SimulatedDevice, quick_simulator: SimulatedDevice
) -> None:
    rows = []
    for url in (robot.url, quick_simulator.url):
        rows += json.loads(trexcmd("find", "--json", "--port", url).stdout)
    assert [(row["product"], row["baud"]) for row in rows] == [("Aracna", 38400), ("TReX", 19200)]


def test_find_on_silent_port_reports_each_device_kind(
    trexcmd: RunCommand, robot: SimulatedDevice
) -> None:
    robot.do("power off")
    result = trexcmd("find", "--port", robot.url)
    assert result.exit_code == 1
    _, trex, aracna, summary = result.stderr.splitlines()
    assert trex.startswith(f"No TReX responds on {robot.url} at any baud rate")
    assert aracna.startswith(f"No Aracna responds on {robot.url} at 38400 baud")
    assert summary == "Error: No board was found."


def test_find_reports_port_in_use_once(
    trexcmd: RunCommand, robot: SimulatedDevice, virtual_time: VirtualRuntime
) -> None:
    other = virtual_time.open_transport(PortSettings(robot.url))
    result = trexcmd("find", "--port", robot.url)
    other.close()
    assert result.exit_code == 1
    assert result.stderr.count("is in use") == 1
    assert "answers" not in result.stderr


def test_list_shows_silent_port_as_nothing_answers(
    trexcmd: RunCommand, robot: SimulatedDevice
) -> None:
    robot.do("power off")
    assert trexcmd("list").stdout == f"{robot.url}\tno reply\n"
