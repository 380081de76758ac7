"""One device at a time, whatever kind it is of."""

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
    """A device whose connection does what the test says; see `DeviceController`."""

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

    def leave(self) -> None:
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

    def begin_to_shut_down(self) -> None:
        self.done.append("begin to shut down")

    def shut_down(self) -> bool:
        self.done.append("shut down")
        return self.plugin.key != "first"

    def become(self, link: ConnectionState) -> None:
        self.link = link
        self.changed.emit()


def port(url: str, device: str) -> Port:
    return Port(PortKind.TYPED, url, url, device)


@pytest.fixture
def devices(qapp: QObject) -> tuple[FakeDevice, FakeDevice]:
    return FakeDevice("first"), FakeDevice("second")


@pytest.fixture
def board(devices: tuple[FakeDevice, FakeDevice]) -> DeviceManager:
    first, second = cast("list[Controller]", list(devices))
    manager = DeviceManager({"first": lambda: first, "second": lambda: second}, DeviceScanner())
    assert list(manager.controllers) == [first], "the others are made when they are needed"
    assert manager.controller("second") is second
    return manager


def test_device_that_is_made_during_a_stop_does_not_end_it(
    devices: tuple[FakeDevice, FakeDevice], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The stop comes from another thread."""
    first, second = devices
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


def test_first_device_is_current_by_default(
    board: DeviceManager, devices: tuple[FakeDevice, FakeDevice]
) -> None:
    assert board.current.plugin.key == "first"
    assert board.is_idle
    board.connect_to(port("a", "first"))
    assert devices[0].done == ["connect a"]
    assert not board.is_idle


def test_previous_device_disconnects_before_the_next_connects(
    board: DeviceManager, devices: tuple[FakeDevice, FakeDevice]
) -> None:
    first, second = devices
    board.connect_to(port("a", "first"))
    board.connect_to(port("b", "second"))
    assert first.done[-1] == "leave"
    assert (second.done, board.current.plugin.key) == ([], "first")
    first.become(ConnectionState.DISCONNECTED)
    assert second.done == ["connect b"]
    assert board.current.plugin.key == "second"


def test_idle_previous_device_is_left_too(
    board: DeviceManager, devices: tuple[FakeDevice, FakeDevice]
) -> None:
    board.connect_to(port("b", "second"))
    assert devices[0].done == ["leave"]
    assert devices[1].done == ["connect b"]


def test_leaving_cancels_the_pending_connection(
    board: DeviceManager, devices: tuple[FakeDevice, FakeDevice]
) -> None:
    first, second = devices
    board.connect_to(port("a", "first"))
    board.connect_to(port("b", "second"))
    board.leave()
    first.become(ConnectionState.DISCONNECTED)
    assert second.done == []


def test_last_chosen_port_is_connected(
    board: DeviceManager, devices: tuple[FakeDevice, FakeDevice]
) -> None:
    first, second = devices
    board.connect_to(port("a", "first"))
    board.connect_to(port("b", "second"))
    board.connect_with(port("c", "second"), PortSettings(""))
    first.become(ConnectionState.DISCONNECTED)
    assert second.done == ["with 9600 baud", "connect c"]


def test_another_kind_is_used_once_the_current_one_is_disconnected(
    board: DeviceManager, devices: tuple[FakeDevice, FakeDevice]
) -> None:
    used: list[str] = []

    def note() -> None:
        used.append(board.current.plugin.key)

    first, second = devices
    board.connect_to(port("a", "first"))
    assert not board.switch_to("second", note), "a connected device is not disconnected for it"
    assert (used, first.link) == ([], ConnectionState.CONNECTED)
    board.leave()
    assert board.switch_to("second", note)
    assert used == []
    first.become(ConnectionState.DISCONNECTED)
    assert used == ["second"]
    assert board.switch_to("first", note)
    assert board.switch_to("first", note)
    assert used == ["second", "first", "first"]
    assert second.link is ConnectionState.DISCONNECTED


def test_connection_that_waits_is_not_replaced_by_a_file(
    board: DeviceManager, devices: tuple[FakeDevice, FakeDevice]
) -> None:
    first, second = devices
    board.connect_to(port("a", "first"))
    board.connect_to(port("b", "second"))
    assert not board.switch_to("second", lambda: None)
    first.become(ConnectionState.DISCONNECTED)
    assert second.done == ["connect b"]


def test_stop_reaches_every_device(
    board: DeviceManager, devices: tuple[FakeDevice, FakeDevice]
) -> None:
    board.press_stop()
    assert [device.done for device in devices] == [["stop"], ["stop"]]


def test_every_device_is_shut_down_when_one_does_not_end(
    board: DeviceManager, devices: tuple[FakeDevice, FakeDevice]
) -> None:
    assert not board.shut_down()
    assert [device.done[-1] for device in devices] == ["shut down", "shut down"]


def test_shutdown_begins_on_all_devices_before_waiting(
    board: DeviceManager, devices: tuple[FakeDevice, FakeDevice], monkeypatch: pytest.MonkeyPatch
) -> None:
    first, second = devices
    reports: list[list[str]] = []

    def shut_down() -> bool:
        reports.append(list(second.done))
        return True

    monkeypatch.setattr(first, "shut_down", shut_down)
    assert board.shut_down()
    assert reports == [["begin to shut down"]]


def test_unconfirmed_stops_of_all_devices_are_listed(
    board: DeviceManager, devices: tuple[FakeDevice, FakeDevice]
) -> None:
    assert board.unconfirmed_stop == ""
    devices[1].unconfirmed_stop = "The second may turn."
    assert board.unconfirmed_stop == "The second may turn."
    devices[0].unconfirmed_stop = "The first may turn."
    assert board.unconfirmed_stop == "The first may turn.\nThe second may turn."


@pytest.fixture
def reports(board: DeviceManager) -> list[str]:
    """What was told of stops that nobody asked for."""
    reports: list[str] = []
    board.stop_reported.connect(reports.append)
    return reports


def test_automatic_stop_reaches_all_and_current_device_reports(
    board: DeviceManager, devices: tuple[FakeDevice, FakeDevice], reports: list[str]
) -> None:
    board.connect_to(port("b", "second"))
    board.stop_because("It rains")
    assert [device.done[-1] for device in devices] == ["stop: It rains"] * 2
    assert reports == ["It rains, so Second is told."]


def test_stop_report_is_forwarded_only_for_the_current_device(
    board: DeviceManager, devices: tuple[FakeDevice, FakeDevice], reports: list[str]
) -> None:
    devices[1].stop_reported.emit("The second stands.")
    assert reports == []
    devices[0].stop_reported.emit("The first stands.")
    assert reports == ["The first stands."]


def test_unconnected_stop_is_reported_only_with_remedies(
    board: DeviceManager, reports: list[str]
) -> None:
    board.stop_because("It rains")
    assert reports == []
    board.stop_because("The roof fell in", (Remedy.REPORT,))
    assert reports == ["The roof fell in."]


def test_emergency_stop_reaches_every_device(
    board: DeviceManager, devices: tuple[FakeDevice, FakeDevice]
) -> None:
    board.stop_now()
    board.stop_now(ending=True)
    assert [device.done for device in devices] == [["stop now", "end"]] * 2
