"""A board that comes back with other line settings, on a real port."""

from collections.abc import Callable

from tests.devices.trex.model.conftest import Connect, Until
from tests.support.program import new_controller
from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.model.controller import TrexController
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.power_cycle import PowerCycle
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.ports import Ports

NEW = LineSettings(57600, Detection.CRC7)
UART, POLYNOMIAL = "uart_settings", "crc7_polynomial"


def store(device: Device, until: Until, **wires: int) -> None:
    """Apply these parameters, and wait until that is done."""
    for key, wire in wires.items():
        device.parameters.edit(key, wire)
    device.apply()
    until(lambda: not device.applying and device.draft.pending == 0)


def restart(device: Device, until: Until, act: Callable[[], None]) -> None:
    """Let a board be without power for a moment, and wait until it was missed and is back."""
    seen: list[ConnectionState] = []

    def note() -> None:
        seen.append(device.link)

    device.link_changed.connect(note)
    act()
    until(
        lambda: ConnectionState.NOT_RESPONDING in seen and device.link is ConnectionState.CONNECTED
    )
    device.link_changed.disconnect(note)


def line_of(device: Device) -> LineSettings:
    assert device.settings is not None
    return device.settings.line


def test_reconnect_at_new_line_settings_is_saved(
    connector: TrexController,
    device: Device,
    ports: Ports,
    quick_simulator: SimulatedDevice,
    until: Until,
    connect: Connect,
) -> None:
    connect(ports.add_typed(quick_simulator.url))
    store(device, until, **{UART: NEW.to_wire(), POLYNOMIAL: 0x11})
    device.expect((ConnectionSettings("", NEW, polynomial=0x91),))
    quick_simulator.do("power off")
    until(lambda: device.link is ConnectionState.NOT_RESPONDING)
    assert connector.settings == ConnectionSettings("")
    quick_simulator.do("power on")
    until(lambda: device.link is ConnectionState.CONNECTED)
    there = ConnectionSettings(quick_simulator.url, NEW, polynomial=0x91)
    assert device.settings == there
    assert connector.settings == ConnectionSettings("", NEW, polynomial=0x91)
    assert new_controller(device, ports).settings == connector.settings
    assert device.parameters.active_of(UART) == NEW.to_wire()
    connector.leave()
    until(lambda: device.link is ConnectionState.DISCONNECTED)
    connect(ports.add_typed(quick_simulator.url))
    assert device.settings == there


def test_failed_write_of_line_settings_keeps_candidates(
    device: Device, ports: Ports, quick_simulator: SimulatedDevice, until: Until, connect: Connect
) -> None:
    connect(ports.add_typed(quick_simulator.url))
    device.expect((ConnectionSettings("", NEW),))
    PowerCycle(device).begin(failed=[UART])
    quick_simulator.do("power off")
    until(lambda: device.link is ConnectionState.NOT_RESPONDING)
    quick_simulator.do(f"eeprom uart_settings {NEW.to_wire()}")
    quick_simulator.do("power on")
    until(lambda: device.link is ConnectionState.CONNECTED)
    assert line_of(device) == NEW


def test_simulated_board_reconnects_at_its_last_settings(
    connector: TrexController, device: Device, ports: Ports, until: Until, connect: Connect
) -> None:
    connect(ports.demo_of("trex"))
    store(device, until, **{UART: NEW.to_wire()})
    device.expect((ConnectionSettings("", NEW),))
    restart(device, until, connector.demo_board.power_cycle)
    assert line_of(device) == NEW
    assert connector.settings == ConnectionSettings("")  # which are for real boards
    connector.leave()
    until(lambda: device.link is ConnectionState.DISCONNECTED)
    connect(ports.demo_of("trex"))
    assert line_of(device) == NEW


def test_new_simulated_board_uses_factory_line_settings(
    connector: TrexController, device: Device, ports: Ports, until: Until, connect: Connect
) -> None:
    connect(ports.demo_of("trex"))
    store(device, until, **{UART: NEW.to_wire()})
    device.expect((ConnectionSettings("", NEW),))
    restart(device, until, connector.demo_board.power_cycle)
    restart(device, until, connector.demo_board.restore_factory)
    assert line_of(device) == LineSettings()
    connector.simulator.stop()
    until(lambda: device.link is ConnectionState.DISCONNECTED)
    connect(ports.demo_of("trex"))
    assert line_of(device) == LineSettings()
