"""Translation of texts and numbers in packages without Qt."""

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

import pytest
from PySide6.QtCore import QCoreApplication

from trex_gui.core.translation import Number, tr, use_translations
from trex_gui.devices.trex.driving.blockers import DriveBlocker, Reason
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.parameters import ParameterSpec, parameters_of
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_in_place import amend
from trex_gui.devices.trex.settings.writer import write_settings
from trex_gui.ui.translations import CONTEXT

_WORDS = {
    "off": "aus",
    "Serial Timeout": "Serielles Timeout",
    "Format error": "Formatfehler",
    "CRC error": "CRC-Fehler",
}


def _english(text: str, _comment: str, _count: int) -> str:
    return text


@pytest.fixture
def german() -> Iterator[None]:
    use_translations(lambda text, _comment, _count: _WORDS.get(text, text), ",")
    yield
    use_translations(partial(QCoreApplication.translate, CONTEXT))  # as other tests expect


def timeout() -> ParameterSpec:
    return parameters_of("trex", "1.2")["serial_timeout"]


def test_texts_are_english_without_a_window() -> None:
    assert tr("off") == "off"
    assert tr("%n setting(s) of {0}", "", 3).format(4) == "3 setting(s) of 4"
    assert timeout().text(0) == "off"
    assert timeout().text(15) == "1.5 s"
    assert f"{Number(2.5):.2f} A" == "2.50 A"


@pytest.mark.usefixtures("german")
def test_parameters_and_numbers_follow_the_language() -> None:
    assert timeout().name == "Serielles Timeout"
    assert timeout().text(0) == "aus"
    assert timeout().text(15) == "1,5 s"
    assert f"{Number(11.96):.1f} V, {Number(0.5):g}" == "12,0 V, 0,5"
    assert f"{Number(0.125):.1%}" == "12,5\u00a0%"


@pytest.mark.usefixtures("german")
def test_names_of_errors_in_a_reason_are_translated() -> None:
    reason = Reason(DriveBlocker.LINE_ERROR, (("Format error", "CRC error"),))
    assert "(Formatfehler, CRC-Fehler)" in reason.text()


@pytest.mark.usefixtures("german")
def test_every_shown_value_can_be_entered() -> None:
    trex, junior = (parameters_of(model, "1.2").readable for model in ("trex", "trexjr"))
    for spec in (*trex, *(spec for spec in junior if spec not in trex)):
        values = {min(spec.valid), spec.default, max(spec.valid), *sorted(spec.valid)[::9]}
        for wire in values:
            assert spec.wire(spec.text(wire)) == wire
    assert timeout().wire("1.5") == timeout().wire("1,5") == 15


@pytest.mark.usefixtures("german")
def test_settings_files_are_equal_in_every_language() -> None:
    trex = device_table().model("trex")
    settings = Settings(trex, "1.2", {"serial_timeout": 15})
    text = write_settings(settings)
    assert "serial_timeout: 15              # 1.5 s\n" in text
    edited = amend(text, replace(settings, parameters={"serial_timeout": 0}))
    assert "serial_timeout: 0               # off\n" in edited
    assert timeout().text(0) == "aus"


def test_parameters_return_to_english_after_another_language(german: None) -> None:
    assert timeout().text(0) == "aus"
    use_translations(_english)
    assert timeout().text(0) == "off"
