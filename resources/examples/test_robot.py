"""Test a program of your own with a simulated board: python -m pytest test_robot.py."""

from trex_gui import Trex
from trex_gui.testing import SimulatedTrex, simulated_trex

__all__ = ["simulated_trex"]  # usually in conftest.py


def test_robot_is_stopped_at_the_end(simulated_trex: SimulatedTrex) -> None:
    with Trex(simulated_trex.url) as trex:
        trex.drive(40, 40)
        trex.wait(0.5)
        assert [motor["speed"] for motor in simulated_trex.show()["motors"][:2]] == [40, 40]
    assert all(motor["direction"] == "brake" for motor in simulated_trex.show()["motors"][:2])


def test_fault_is_reported(simulated_trex: SimulatedTrex) -> None:
    simulated_trex.do("fault 1 on")
    with Trex(simulated_trex.url) as trex:
        trex.wait(0.5)
        assert "Motor 1 fault" in [error.name for error in trex.errors() if error.is_earlier]
