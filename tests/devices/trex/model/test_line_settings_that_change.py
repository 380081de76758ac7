"""A board that comes back with other line settings, on a real port."""

from collections.abc import Callable

from tests.devices.trex.model.conftest import ConnectorSetup
from tests.support.program import new_controller
from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.model.power_cycle import PowerCycle
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.ui.devices.connection import ConnectionState

NEW = LineSettings(57600, Detection.CRC7)
UART, POLYNOMIAL = "uart_settings", "crc7_polynomial"


def store(setup: ConnectorSetup, **wires: int) -> None:
    """Apply these parameters, and wait until that is done."""
    device = setup.device
    for key, wire in wires.items():
        device.parameters.edit(key, wire)
    device.writer.apply()
    setup.until(lambda: not device.writer.running and device.draft.pending == 0)


def restart(setup: ConnectorSetup, act: Callable[[], None]) -> None:
    """Let a board be without power for a moment, and wait until it was missed and is back."""
    act()
    setup.until_link(ConnectionState.NOT_RESPONDING)
    setup.until_link(ConnectionState.CONNECTED)


def line_of(setup: ConnectorSetup) -> LineSettings:
    assert setup.device.settings is not None
    return setup.device.settings.line


def test_reconnect_at_new_line_settings_is_saved(
    setup: ConnectorSetup, quick_simulator: SimulatedDevice
) -> None:
    setup.connect(setup.ports.add_typed(quick_simulator.url))
    store(setup, **{UART: NEW.to_wire(), POLYNOMIAL: 0x11})
    setup.device.connection.expect((ConnectionSettings("", NEW, polynomial=0x91),))
    quick_simulator.do("power off")
    setup.until_link(ConnectionState.NOT_RESPONDING)
    assert setup.connector.settings == ConnectionSettings("")
    quick_simulator.do("power on")
    setup.until_link(ConnectionState.CONNECTED)
    there = ConnectionSettings(quick_simulator.url, NEW, polynomial=0x91)
    assert setup.device.settings == there
    assert setup.connector.settings == ConnectionSettings("", NEW, polynomial=0x91)
    assert new_controller(setup.device, setup.ports).settings == setup.connector.settings
    assert setup.device.parameters.values.active_of(UART) == NEW.to_wire()
    setup.disconnect()
    setup.connect(setup.ports.add_typed(quick_simulator.url))
    assert setup.device.settings == there


def test_failed_write_of_line_settings_keeps_candidates(
    setup: ConnectorSetup, quick_simulator: SimulatedDevice
) -> None:
    setup.connect(setup.ports.add_typed(quick_simulator.url))
    setup.device.connection.expect((ConnectionSettings("", NEW),))
    PowerCycle(setup.device).begin(failed=[UART])
    quick_simulator.do("power off")
    setup.until_link(ConnectionState.NOT_RESPONDING)
    quick_simulator.do(f"eeprom uart_settings {NEW.to_wire()}")
    quick_simulator.do("power on")
    setup.until_link(ConnectionState.CONNECTED)
    assert line_of(setup) == NEW


def test_simulated_board_reconnects_at_its_last_settings(setup: ConnectorSetup) -> None:
    setup.connect(setup.ports.demo_of("trex"))
    store(setup, **{UART: NEW.to_wire()})
    setup.device.connection.expect((ConnectionSettings("", NEW),))
    restart(setup, setup.connector.demo_board.power_cycle)
    assert line_of(setup) == NEW
    assert setup.connector.settings == ConnectionSettings("")  # which are for real boards
    setup.disconnect()
    setup.connect(setup.ports.demo_of("trex"))
    assert line_of(setup) == NEW


def test_new_simulated_board_uses_factory_line_settings(setup: ConnectorSetup) -> None:
    setup.connect(setup.ports.demo_of("trex"))
    store(setup, **{UART: NEW.to_wire()})
    setup.device.connection.expect((ConnectionSettings("", NEW),))
    restart(setup, setup.connector.demo_board.power_cycle)
    restart(setup, setup.connector.demo_board.restore_factory)
    assert line_of(setup) == LineSettings()
    setup.connector.simulator.stop()
    setup.until_link(ConnectionState.DISCONNECTED)
    setup.connect(setup.ports.demo_of("trex"))
    assert line_of(setup) == LineSettings()
