"""Texts and numbers of packages without Qt in the language of the window."""

from collections.abc import Iterator

import pytest

from trex_gui.core.translation import Number, tr, use_translations
from trex_gui.devices.trex.protocol.parameters import ParameterSpec, parameters_of

_WORDS = {"off": "aus", "Serial Timeout": "Serielles Timeout"}


def _english(text: str, _comment: str) -> str:
    return text


@pytest.fixture
def german() -> Iterator[None]:
    use_translations(lambda text, _comment: _WORDS.get(text, text), ",")
    yield
    use_translations(_english)


def timeout() -> ParameterSpec:
    return parameters_of("trex", "1.2")["serial_timeout"]


def test_texts_are_english_without_a_window() -> None:
    assert tr("off") == "off"
    assert timeout().text(0) == "off"
    assert timeout().text(15) == "1.5 s"
    assert f"{Number(2.5):.2f} A" == "2.50 A"


@pytest.mark.usefixtures("german")
def test_parameters_and_numbers_follow_the_language() -> None:
    assert timeout().name == "Serielles Timeout"
    assert timeout().text(0) == "aus"
    assert timeout().text(15) == "1,5 s"
    assert f"{Number(11.96):.1f} V, {Number(0.5):g}" == "12,0 V, 0,5"


@pytest.mark.usefixtures("german")
@pytest.mark.parametrize("wire", [0, 1, 15, 127])
def test_every_shown_value_can_be_typed_back(wire: int) -> None:
    assert timeout().wire(timeout().text(wire)) == wire


@pytest.mark.usefixtures("german")
def test_numbers_with_a_point_are_understood_in_every_language() -> None:
    assert timeout().wire("1.5") == timeout().wire("1,5") == 15


def test_parameters_are_in_english_again_after_another_language(german: None) -> None:
    assert timeout().text(0) == "aus"
    use_translations(_english)
    assert timeout().text(0) == "off"
