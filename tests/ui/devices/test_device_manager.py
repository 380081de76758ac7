"""Device manager: one current device among several kinds."""

from typing import cast

import pytest
from PySide6.QtCore import QObject, Signal

from tests.support.program import new_plugin
from tests.support.virtual_time import VirtualRuntime
from trex_gui.core.transport.settings import PortSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.device_manager import Controller, DeviceManager
from trex_gui.ui.devices.ports import Port, PortKind
from trex_gui.ui.devices.scanner import DeviceScanner
from trex_gui.ui.notifier import Remedy


class FakeDevice(QObject):
    """Device that records calls. The test sets its connection state."""

    changed = Signal()
    progressed = Signal(int, int, str)
    stop_reported = Signal(str)

    def __init__(self, key: str) -> None:
        super().__init__()
        self.plugin = new_plugin(key, key.title())
        self.link = ConnectionState.DISCONNECTED
        self.starting = False
        self.port: Port | None = None
        self.calls: list[str] = []

    status = line_text = unconfirmed_stop = ""
    demo_in_use = has_line_settings = is_busy = False

    def select(self, port: Port) -> None:
        self.calls.append(f"select {port.url}")

    def connect_to(self, port: Port) -> None:
        self.calls.append(f"connect {port.url}")
        self.port = port
        self.set_link(ConnectionState.CONNECTED)

    def connect_with(self, port: Port, settings: PortSettings) -> None:
        self.calls.append(f"with {settings.short}")
        self.connect_to(port)

    def disconnect_device(self) -> None:
        self.calls.append("disconnect")
        if self.link is not ConnectionState.DISCONNECTED:
            self.set_link(ConnectionState.DISCONNECTING)

    def press_stop(self) -> None:
        self.calls.append("stop")

    def stop_now(self, *, ending: bool = False) -> None:
        self.calls.append("end" if ending else "stop now")

    def stop_because(self, reason: str) -> str:
        self.calls.append(f"stop: {reason}")
        is_connected = self.link is not ConnectionState.DISCONNECTED
        return f"{reason}, so {self.plugin.name} was stopped." if is_connected else ""

    def start_shutdown(self) -> None:
        self.calls.append("start shutdown")

    def shut_down(self) -> bool:
        self.calls.append("shut down")
        return self.plugin.key != "first"

    def set_link(self, link: ConnectionState) -> None:
        self.link = link
        self.changed.emit()


def port(url: str, device: str) -> Port:
    return Port(PortKind.TYPED, url, url, device)


class Devices:
    """Manager of two devices, with its reports of unrequested stops."""

    def __init__(self) -> None:
        self.first, self.second = FakeDevice("first"), FakeDevice("second")
        first, second = cast("list[Controller]", [self.first, self.second])
        factories = {"first": lambda: first, "second": lambda: second}
        self.manager = DeviceManager(factories, DeviceScanner())
        assert list(self.manager.controllers) == [first], "the second is created on first use"
        self.reports: list[str] = []
        self.manager.stop_reported.connect(self.reports.append)

    @property
    def calls(self) -> list[list[str]]:
        return [self.first.calls, self.second.calls]


@pytest.fixture
def devices(qapp: QObject) -> Devices:
    devices = Devices()
    devices.manager.controller("second")
    return devices


def test_stop_continues_while_a_device_is_created(
    qapp: QObject, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The stop can come from another thread while the device is being created."""
    devices, stops = Devices(), list[bool]()

    def stop_now(*, ending: bool = False) -> None:
        devices.manager.controller("second")
        stops.append(ending)

    monkeypatch.setattr(devices.first, "stop_now", stop_now)
    devices.manager.stop_now(ending=True)
    assert stops == [True]


def test_previous_device_disconnects_before_the_next_connects(devices: Devices) -> None:
    was_idle = devices.manager.is_idle
    devices.manager.connect_to(port("a", "first"))
    assert devices.first.calls == ["connect a"]
    assert (was_idle, devices.manager.is_idle) == (True, False)
    devices.manager.connect_to(port("b", "second"))
    assert devices.first.calls[-1] == "disconnect"
    assert (devices.second.calls, devices.manager.current.plugin.key) == ([], "first")
    devices.first.set_link(ConnectionState.DISCONNECTED)
    assert devices.second.calls == ["connect b"]
    assert devices.manager.current.plugin.key == "second"


def test_disconnect_cancels_the_pending_connection(devices: Devices) -> None:
    devices.manager.connect_to(port("a", "first"))
    devices.manager.connect_to(port("b", "second"))
    devices.manager.disconnect_device()
    devices.first.set_link(ConnectionState.DISCONNECTED)
    assert devices.second.calls == []


def test_last_selected_port_is_connected(devices: Devices) -> None:
    devices.manager.connect_to(port("a", "first"))
    devices.manager.connect_to(port("b", "second"))
    devices.manager.connect_with(port("c", "second"), PortSettings(""))
    assert not devices.manager.switch_to("second", lambda: None), "a connection is pending"
    devices.first.set_link(ConnectionState.DISCONNECTED)
    assert devices.second.calls == ["with 9600 baud", "connect c"]


def test_port_is_selected_only_by_an_idle_device_of_its_kind(devices: Devices) -> None:
    devices.manager.select(port("a", "second"))
    devices.manager.select(port("b", "first"))
    devices.manager.connect_to(port("c", "first"))
    devices.manager.select(port("d", "first"))
    assert devices.calls == [["select b", "connect c"], []]


def test_disconnection_by_the_user_ends_with_the_next_connection(devices: Devices) -> None:
    devices.manager.disconnect_device()
    assert devices.manager.user_disconnected
    devices.manager.connect_to(port("a", "first"))
    assert not devices.manager.user_disconnected


def test_callback_runs_once_after_the_next_connection(
    devices: Devices, virtual_time: VirtualRuntime
) -> None:
    calls: list[str] = []
    devices.manager.when_connected(lambda: calls.append("connected"))
    devices.first.set_link(ConnectionState.CONNECTING)
    virtual_time.advance(0.01)
    assert calls == []
    for _ in range(2):
        devices.first.set_link(ConnectionState.CONNECTED)
        virtual_time.advance(0.01)
    assert calls == ["connected"]


def test_switch_waits_for_disconnection(devices: Devices) -> None:
    devices_used: list[str] = []

    def record_device() -> None:
        devices_used.append(devices.manager.current.plugin.key)

    devices.manager.connect_to(port("a", "first"))
    assert not devices.manager.switch_to("second", record_device), "the first is connected"
    assert (devices_used, devices.first.link) == ([], ConnectionState.CONNECTED)
    devices.manager.disconnect_device()
    assert devices.manager.switch_to("second", record_device)
    assert devices_used == []
    devices.first.set_link(ConnectionState.DISCONNECTED)
    assert devices_used == ["second"]
    assert devices.manager.switch_to("first", record_device)
    assert devices.manager.switch_to("first", record_device)
    assert devices_used == ["second", "first", "first"]
    assert devices.second.link is ConnectionState.DISCONNECTED


def test_all_devices_are_shut_down_after_a_timeout(devices: Devices) -> None:
    assert not devices.manager.shut_down()
    assert [calls[-1] for calls in devices.calls] == ["shut down", "shut down"]


def test_shutdown_starts_on_all_devices_before_waiting(
    devices: Devices, monkeypatch: pytest.MonkeyPatch
) -> None:
    reports: list[list[str]] = []

    def shut_down() -> bool:
        reports.append(list(devices.second.calls))
        return True

    monkeypatch.setattr(devices.first, "shut_down", shut_down)
    assert devices.manager.shut_down()
    assert reports == [["start shutdown"]]


def test_unconfirmed_stops_of_all_devices_are_listed(devices: Devices) -> None:
    assert devices.manager.unconfirmed_stop == ""
    devices.second.unconfirmed_stop = "The second may turn."
    assert devices.manager.unconfirmed_stop == "The second may turn."
    devices.first.unconfirmed_stop = "The first may turn."
    assert devices.manager.unconfirmed_stop == "The first may turn.\nThe second may turn."


def test_automatic_stop_reaches_all_and_current_device_reports_it(devices: Devices) -> None:
    devices.manager.connect_to(port("b", "second"))
    assert devices.first.calls == ["disconnect"], "although it is not connected"
    devices.manager.stop_because("The screen was locked")
    assert [calls[-1] for calls in devices.calls] == ["stop: The screen was locked"] * 2
    assert devices.reports == ["The screen was locked, so Second was stopped."]


def test_stop_report_is_forwarded_only_for_the_current_device(devices: Devices) -> None:
    devices.second.stop_reported.emit("The second has stopped.")
    assert devices.reports == []
    devices.first.stop_reported.emit("The first has stopped.")
    assert devices.reports == ["The first has stopped."]


def test_unconnected_stop_is_reported_only_with_remedies(devices: Devices) -> None:
    devices.manager.stop_because("The screen was locked")
    assert devices.reports == []
    devices.manager.stop_because("An internal error occurred", (Remedy.REPORT,))
    assert devices.reports == ["An internal error occurred."]


def test_manual_and_system_stops_reach_every_device(devices: Devices) -> None:
    devices.manager.press_stop()
    devices.manager.stop_now()
    devices.manager.stop_now(ending=True)
    assert devices.calls == [["stop", "stop now", "end"]] * 2
