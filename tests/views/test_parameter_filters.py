"""The row that narrows the parameter table down, used by hand."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QComboBox, QLabel, QLineEdit, QTreeView
from pytestqt.qtbot import QtBot

from trex_gui.model.device import Device
from trex_gui.model.parameter_filter import ParameterFilter
from trex_gui.protocol.parameters import parameters_of
from trex_gui.views.pages.parameters_page import ParametersPage

SPECS = parameters_of("trexjr", "1.2")
FACTORY = {spec.key: spec.default for spec in SPECS.readable}


@pytest.fixture
def device(qtbot: QtBot) -> Device:
    device = Device()
    device.parameters.load(SPECS, FACTORY, {}, power_cycled=True)
    return device


@pytest.fixture
def page(device: Device, qtbot: QtBot) -> ParametersPage:
    page = ParametersPage(device)
    qtbot.addWidget(page)
    page.show()
    return page


def rows(page: ParametersPage) -> int:
    view = page.findChild(QTreeView, "parametersView")
    assert view is not None
    rows = view.model()
    assert isinstance(rows, ParameterFilter)
    return rows.shown


def count(page: ParametersPage) -> str:
    label = page.findChild(QLabel, "parameterCount")
    assert label is not None
    return label.text() if label.isVisible() else ""


def test_typing_narrows_the_table_and_says_how_far(page: ParametersPage) -> None:
    search = page.findChild(QLineEdit, "parameterSearch")
    assert search is not None
    assert count(page) == ""
    QTest.keyClicks(search, "brake duration")
    assert rows(page) == 2
    assert count(page) == f"2 of {len(FACTORY)}"
    QTest.keyClicks(search, " nowhere")
    assert count(page) == f"None of {len(FACTORY)} matches"
    search.clear()
    assert rows(page) == len(FACTORY)
    assert count(page) == ""


def test_groups_and_ticks_narrow_it_too(page: ParametersPage, device: Device) -> None:
    group = page.findChild(QComboBox, "parameterGroup")
    modified = page.findChild(QCheckBox, "modifiedOnly")
    others = page.findChild(QCheckBox, "notDefaultOnly")
    assert group is not None
    assert modified is not None
    assert others is not None
    group.setCurrentIndex(group.findData("serial"))
    assert rows(page) == sum(spec.group == "serial" for spec in SPECS.readable)
    device.parameters.edit("serial_timeout", 7)
    device.parameters.edit("motor_mode", 1)
    QTest.mouseClick(modified, Qt.MouseButton.LeftButton)
    assert rows(page) == 1
    group.setCurrentIndex(0)
    assert rows(page) == 2
    QTest.mouseClick(others, Qt.MouseButton.LeftButton)
    assert rows(page) == 2


def test_everything_has_a_name_for_those_who_cannot_see_it(page: ParametersPage) -> None:
    for name in ("parameterSearch", "parameterGroup"):
        widget = page.findChild((QLineEdit, QComboBox)[name == "parameterGroup"], name)
        assert widget is not None
        assert widget.accessibleName()
