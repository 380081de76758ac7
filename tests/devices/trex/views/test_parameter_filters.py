"""The row that narrows the parameter table down, used by hand."""

import pytest
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit, QTableView
from pytestqt.qtbot import QtBot

from tests.support.window import WidgetDriver
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.linter import BoardLinter
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.views.pages.parameters.filters import ParameterFilter
from trex_gui.devices.trex.views.pages.parameters.page import ParametersPage

SPECS = parameters_of("trexjr", "1.2")
FACTORY = {spec.key: spec.default for spec in SPECS.readable}


@pytest.fixture
def device(qtbot: QtBot) -> Device:
    device = Device()
    device.parameters.load(SPECS, FACTORY, {}, power_cycled=True)
    return device


@pytest.fixture
def page(device: Device, qtbot: QtBot) -> WidgetDriver:
    page = ParametersPage(device, BoardLinter(device))
    qtbot.addWidget(page)
    page.show()
    return WidgetDriver(page, qtbot)


def shown_rows(page: WidgetDriver) -> int:
    rows = page.find(QTableView, "parametersView").model()
    assert isinstance(rows, ParameterFilter)
    return rows.shown


def shown_count(page: WidgetDriver) -> str:
    """Return the text beside the search field, which is hidden while every row is shown."""
    return page.text("parameterCount") if page.has("parameterCount") else ""


def test_search_filters_rows_and_shows_the_count(page: WidgetDriver) -> None:
    search = page.find(QLineEdit, "parameterSearch")
    assert shown_count(page) == ""
    QTest.keyClicks(search, "brake duration")
    assert shown_rows(page) == 1
    assert shown_count(page) == "1 of 20"
    QTest.keyClicks(search, " nowhere")
    assert shown_count(page) == "None of 20 matches"
    search.clear()
    assert shown_rows(page) == 20
    assert shown_count(page) == ""


def test_group_and_check_boxes_filter_rows(page: WidgetDriver, device: Device) -> None:
    group = page.combo("parameterGroup")
    group.setCurrentIndex(group.findData("serial"))
    assert shown_rows(page) == sum(spec.task == "serial" for spec in SPECS.readable)
    device.parameters.edit("serial_timeout", 7)
    device.parameters.edit("motor_mode", 1)
    page.click("modifiedOnly")
    assert shown_rows(page) == 1
    group.setCurrentIndex(0)
    assert shown_rows(page) == 2
    page.click("notDefaultOnly")
    assert shown_rows(page) == 2
