"""The window warns about settings that do not fit together."""

from tests.support.virtual_devices import VirtualSimulator
from tests.support.window import WindowDriver
from trex_gui.devices.trex.protocol.line_settings import LineSettings


def findings(window: WindowDriver) -> list[str]:
    """Return what the window warns about."""
    names = [f"parameterFinding{index}" for index in range(3)]
    return [window.text(name) for name in names if window.has(name)]


def test_settings_check_warns_while_settings_are_edited(
    window: WindowDriver, quick_simulator: VirtualSimulator
) -> None:
    device, edit = window.device, window.device.parameters.edit
    quick_simulator.rates = frozenset({9600, 19200})
    window.connect(quick_simulator.url)
    window.open_page("parametersPage")
    assert not window.has("parameterFindings"), "a new board has no findings"

    edit("ignored_channels", 1)
    assert len(findings(window)) == 1
    window.click("acceptFinding0")
    assert device.parameters.value_of("required_channels") == 0
    window.wait(lambda: not window.has("parameterFindings"))
    assert device.draft.pending == 2
    device.draft.undo.undo()
    assert device.draft.pending == 1
    assert len(findings(window)) == 1
    device.draft.discard_edits()

    edit("uart_settings", LineSettings(76800).to_wire())
    assert "does not support 76800 baud" in "\n".join(findings(window)), "the port of this computer"
    edit("uart_settings", LineSettings(9600).to_wire())
    assert "does not support" not in "\n".join(findings(window))

    edit("ignored_channels", 1)
    assert window.has("parameterFindings")
    window.disconnect()
    assert not window.has("parameterFindings")


def test_arming_warns_about_the_serial_timeout(connected_window: WindowDriver) -> None:
    window = connected_window
    window.open_page("parametersPage")
    window.wait(lambda: window.motors.is_available)
    window.motors.arm()
    window.click("acceptFinding0")
    assert window.device.parameters.value_of("serial_timeout") == 5
