"""One current device of several kinds."""

from typing import cast

import pytest
from PySide6.QtCore import QObject, Signal

from tests.support.program import new_plugin
from trex_gui.core.transport.settings import PortSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.device_manager import Controller, DeviceManager
from trex_gui.ui.devices.ports import Port, PortKind
from trex_gui.ui.devices.scanner import DeviceScanner
from trex_gui.ui.notifier import Remedy


class FakeDevice(QObject):
    """Device whose connection state the test sets."""

    changed = Signal()
    progressed = Signal(int, int, str)
    stop_reported = Signal(str)

    def __init__(self, key: str) -> None:
        super().__init__()
        self.plugin = new_plugin(key, key.title())
        self.link = ConnectionState.DISCONNECTED
        self.starting = False
        self.port: Port | None = None
        self.done: list[str] = []

    status = line_text = unconfirmed_stop = ""
    demo_in_use = has_line_settings = is_busy = False

    def connect_to(self, port: Port) -> None:
        self.done.append(f"connect {port.url}")
        self.port = port
        self.become(ConnectionState.CONNECTED)

    def connect_with(self, port: Port, settings: PortSettings) -> None:
        self.done.append(f"with {settings.short}")
        self.connect_to(port)

    def disconnect_device(self) -> None:
        self.done.append("leave")
        if self.link is not ConnectionState.DISCONNECTED:
            self.become(ConnectionState.DISCONNECTING)

    def press_stop(self) -> None:
        self.done.append("stop")

    def stop_now(self, *, ending: bool = False) -> None:
        self.done.append("end" if ending else "stop now")

    def stop_because(self, reason: str) -> str:
        self.done.append(f"stop: {reason}")
        return (
            f"{reason}, so {self.plugin.name} is told."
            if self.link is not ConnectionState.DISCONNECTED
            else ""
        )

    def start_shutdown(self) -> None:
        self.done.append("begin to shut down")

    def shut_down(self) -> bool:
        self.done.append("shut down")
        return self.plugin.key != "first"

    def become(self, link: ConnectionState) -> None:
        self.link = link
        self.changed.emit()


def port(url: str, device: str) -> Port:
    return Port(PortKind.TYPED, url, url, device)


class Devices:
    """Manager of two devices, and its reports of unrequested stops."""

    def __init__(self) -> None:
        self.first, self.second = FakeDevice("first"), FakeDevice("second")
        first, second = cast("list[Controller]", [self.first, self.second])
        makers = {"first": lambda: first, "second": lambda: second}
        self.manager = DeviceManager(makers, DeviceScanner())
        assert list(self.manager.controllers) == [first], "the others are made when they are needed"
        assert self.manager.controller("second") is second
        self.reports: list[str] = []
        self.manager.stop_reported.connect(self.reports.append)

    @property
    def done(self) -> list[list[str]]:
        return [self.first.done, self.second.done]


@pytest.fixture
def devices(qapp: QObject) -> Devices:
    return Devices()


def test_creating_a_device_does_not_end_a_stop(
    qapp: QObject, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The stop comes from another thread."""
    first, second = FakeDevice("first"), FakeDevice("second")
    controller = cast("Controller", first)
    makers = {"first": lambda: controller, "second": lambda: cast("Controller", second)}
    manager = DeviceManager(makers, DeviceScanner())
    stops: list[bool] = []

    def stop_now(*, ending: bool = False) -> None:
        manager.controller("second")
        stops.append(ending)

    monkeypatch.setattr(first, "stop_now", stop_now)
    manager.stop_now(ending=True)
    assert stops == [True]


def test_previous_device_disconnects_before_the_next_connects(devices: Devices) -> None:
    was_idle = devices.manager.is_idle
    devices.manager.connect_to(port("a", "first"))
    assert devices.first.done == ["connect a"]
    assert (was_idle, devices.manager.is_idle) == (True, False)
    devices.manager.connect_to(port("b", "second"))
    assert devices.first.done[-1] == "leave"
    assert (devices.second.done, devices.manager.current.plugin.key) == ([], "first")
    devices.first.become(ConnectionState.DISCONNECTED)
    assert devices.second.done == ["connect b"]
    assert devices.manager.current.plugin.key == "second"


def test_leaving_cancels_the_pending_connection(devices: Devices) -> None:
    devices.manager.connect_to(port("a", "first"))
    devices.manager.connect_to(port("b", "second"))
    devices.manager.disconnect_device()
    devices.first.become(ConnectionState.DISCONNECTED)
    assert devices.second.done == []


def test_last_chosen_port_is_connected(devices: Devices) -> None:
    devices.manager.connect_to(port("a", "first"))
    devices.manager.connect_to(port("b", "second"))
    devices.manager.connect_with(port("c", "second"), PortSettings(""))
    assert not devices.manager.switch_to("second", lambda: None), "a file does not replace it"
    devices.first.become(ConnectionState.DISCONNECTED)
    assert devices.second.done == ["with 9600 baud", "connect c"]


def test_switch_waits_for_disconnection(devices: Devices) -> None:
    used: list[str] = []

    def record_kind() -> None:
        used.append(devices.manager.current.plugin.key)

    devices.manager.connect_to(port("a", "first"))
    assert not devices.manager.switch_to("second", record_kind), (
        "a connected device is not disconnected for it"
    )
    assert (used, devices.first.link) == ([], ConnectionState.CONNECTED)
    devices.manager.disconnect_device()
    assert devices.manager.switch_to("second", record_kind)
    assert used == []
    devices.first.become(ConnectionState.DISCONNECTED)
    assert used == ["second"]
    assert devices.manager.switch_to("first", record_kind)
    assert devices.manager.switch_to("first", record_kind)
    assert used == ["second", "first", "first"]
    assert devices.second.link is ConnectionState.DISCONNECTED


def test_all_devices_are_shut_down_after_a_timeout(devices: Devices) -> None:
    assert not devices.manager.shut_down()
    assert [done[-1] for done in devices.done] == ["shut down", "shut down"]


def test_shutdown_starts_on_all_devices_before_waiting(
    devices: Devices, monkeypatch: pytest.MonkeyPatch
) -> None:
    reports: list[list[str]] = []

    def shut_down() -> bool:
        reports.append(list(devices.second.done))
        return True

    monkeypatch.setattr(devices.first, "shut_down", shut_down)
    assert devices.manager.shut_down()
    assert reports == [["begin to shut down"]]


def test_unconfirmed_stops_of_all_devices_are_listed(devices: Devices) -> None:
    assert devices.manager.unconfirmed_stop == ""
    devices.second.unconfirmed_stop = "The second may turn."
    assert devices.manager.unconfirmed_stop == "The second may turn."
    devices.first.unconfirmed_stop = "The first may turn."
    assert devices.manager.unconfirmed_stop == "The first may turn.\nThe second may turn."


def test_automatic_stop_reaches_all_and_current_device_reports(devices: Devices) -> None:
    devices.manager.connect_to(port("b", "second"))
    assert devices.first.done == ["leave"], "it is left although it is idle"
    devices.manager.stop_because("It rains")
    assert [done[-1] for done in devices.done] == ["stop: It rains"] * 2
    assert devices.reports == ["It rains, so Second is told."]


def test_stop_report_is_forwarded_only_for_the_current_device(devices: Devices) -> None:
    devices.second.stop_reported.emit("The second stands.")
    assert devices.reports == []
    devices.first.stop_reported.emit("The first stands.")
    assert devices.reports == ["The first stands."]


def test_unconnected_stop_is_reported_only_with_remedies(devices: Devices) -> None:
    devices.manager.stop_because("It rains")
    assert devices.reports == []
    devices.manager.stop_because("The roof fell in", (Remedy.REPORT,))
    assert devices.reports == ["The roof fell in."]


def test_stop_of_the_user_and_of_the_system_reach_every_device(devices: Devices) -> None:
    devices.manager.press_stop()
    devices.manager.stop_now()
    devices.manager.stop_now(ending=True)
    assert devices.done == [["stop", "stop now", "end"]] * 2
