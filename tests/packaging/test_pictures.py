"""Digest of a picture: changes that affect it and changes that do not."""

import pytest
from PySide6.QtWidgets import (
    QDialog,
    QGroupBox,
    QLabel,
    QPushButton,
    QStackedWidget,
    QTabWidget,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.support.scripts import load_script
from trex_gui.ui.widgets import builders as ui

fixed_texts = load_script("pictures").fixed_texts


class SamplePage(QWidget):
    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("samplePage")
        self.label = ui.label(self, text="Speed:")
        self.value = ui.label(self, "speedValue", "12 km/h")
        self.button = ui.button(self, "goButton", "Go")
        self.box = QGroupBox("Drive", self)
        self.stack = QStackedWidget(self)
        for text in ("First", "Second"):
            self.stack.addWidget(QPushButton(text))
        self.tabs = QTabWidget(self)
        self.tabs.addTab(QLabel("In the tab"), "Errors")

    @property
    def digest(self) -> list[str]:
        return sorted(fixed_texts(self))


@pytest.fixture
def sample(qtbot: QtBot) -> SamplePage:
    sample = SamplePage()
    qtbot.addWidget(sample)
    return sample


def test_fixed_texts_contain_visible_texts_and_names(sample: SamplePage) -> None:
    digest = sample.digest
    for text in ("Speed", "Go", "Drive", "First", "Errors", "In the tab", "QLabel speedValue"):
        assert text in digest
    assert "Second" not in digest


def test_fixed_texts_change_with_texts_and_names(sample: SamplePage) -> None:
    changes = (
        lambda: sample.label.setText("Velocity:"),
        lambda: sample.button.setText("Start"),
        lambda: sample.box.setTitle("Run"),
        lambda: sample.tabs.setTabText(0, "Faults"),
        lambda: sample.button.setObjectName("startButton"),
        lambda: sample.stack.setCurrentIndex(1),
        lambda: ui.button(sample, "stopButton", "Stop"),
    )
    for change in changes:
        before = sample.digest
        change()
        assert sample.digest != before


def test_fixed_texts_ignore_measurements_fonts_and_sizes(sample: SamplePage) -> None:
    before = sample.digest
    sample.value.setText("99 km/h")
    sample.tabs.setTabText(0, "Errors (3)")
    sample.resize(2000, 2000)
    font = sample.font()
    font.setPointSize(40)
    sample.setFont(font)
    assert sample.digest == before


def test_fixed_texts_of_a_dialog_contain_every_label(qtbot: QtBot) -> None:
    dialog = QDialog()
    qtbot.addWidget(dialog)
    ui.label(dialog, "stepLabel", "Switch the board on.")
    assert "Switch the board on" in list(fixed_texts(dialog))
