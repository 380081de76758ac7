"""Units of displayed values and of numbers that are typed without a unit."""

import pytest
from PySide6.QtCore import QEvent, QObject, QSignalBlocker
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QSpinBox, QWidget
from pytestqt.qtbot import QtBot

from tests.devices.trex.views.parameters import ParametersDriver
from tests.support.pages.channels import channels_page
from tests.support.simulator import SimulatedDevice
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.model.channel_text import input_text
from trex_gui.devices.trex.protocol.calibration import HIGHEST_CODED
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.views.count_editor import CountEditor, UnitSpinBox
from trex_gui.devices.trex.views.pages.parameters.editors import NumberEditor, editor_for
from trex_gui.ui.units import units

SPECS = parameters_of("trexjr", "1.2")
ACCELERATION = "motor1_acceleration"

pytestmark = pytest.mark.usefixtures("qapp")


class PaintCounter(QObject):
    """Counts the paint events of a widget."""

    def __init__(self, widget: QWidget) -> None:
        super().__init__(widget)
        self._count = 0
        widget.installEventFilter(self)

    def count_new(self) -> int:
        """Return the number of paint events since the last call."""
        count, self._count = self._count, 0
        return count

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        del watched
        self._count += event.type() is QEvent.Type.Paint
        return False


def parsed(editor: UnitSpinBox, text: str) -> int | None:
    """Return the value of an input, or `None` if it is invalid."""
    try:
        return editor.parse(text)
    except BadRequest:
        return None


@pytest.mark.parametrize("own_first", [False, True])
@pytest.mark.parametrize("source", InputSource)
def test_displayed_count_is_parsed_as_that_count(source: InputSource, own_first: bool) -> None:
    units().set_order(own_first=own_first)
    editor = CountEditor(source)
    for count in (0, 1, 2, 511, 1023, 3092, 3750, HIGHEST_CODED):
        with QSignalBlocker(editor):
            editor.setValue(count)
        text, other_text = editor.text(), editor.other_text
        assert (parsed(editor, text), parsed(editor, other_text)) == (count, count)
        assert (text == str(count)) is own_first
        if not own_first:
            assert text.endswith(source.unit)


@pytest.mark.parametrize(
    ("own_first", "typed", "count"),
    [
        (False, "1500", 3750),
        (True, "1500", 1500),
        *((own_first, "1500 µs", 3750) for own_first in (False, True)),
        *((own_first, "1,5 ms", 3750) for own_first in (False, True)),
        *((own_first, "1500 counts", 1500) for own_first in (False, True)),
        (False, "1.2", 3),
        (True, "1.2", None),
        (True, "1,500", None),
        (True, "1500.", None),
        *((own_first, "1,500 µs", None) for own_first in (False, True)),
        *((own_first, "1500 #", 1500) for own_first in (False, True)),
        *((False, typed, None) for typed in ("2.5 V", "fast", "99999", "-1", "")),
    ],
)
def test_number_without_a_unit_has_the_displayed_unit(
    own_first: bool, typed: str, count: int | None
) -> None:
    units().set_order(own_first=own_first)
    assert parsed(CountEditor(InputSource.RC), typed) == count


@pytest.mark.parametrize(
    ("typed", "physical", "own"),
    [
        ("2", 6, 2),
        ("0", 0, 0),
        ("127", None, 127),
        ("-1", None, None),
        ("0.5", 25, None),
        ("2 s", 6, 6),
        ("500 ms", 25, 25),
        ("0,1 s", 127, 127),
        ("20 s", None, None),
        ("10 per 100 ms", 10, 10),
        ("no ramp", 0, 0),
    ],
)
def test_acceleration_is_never_misread(typed: str, physical: int | None, own: int | None) -> None:
    for own_first, wire in ((False, physical), (True, own)):
        units().set_order(own_first=own_first)
        editor = editor_for(SPECS[ACCELERATION])
        assert isinstance(editor, UnitSpinBox)
        assert parsed(editor, typed) == wire, own_first


@pytest.mark.parametrize("own_first", [False, True])
def test_displayed_number_is_parsed_as_that_value(own_first: bool) -> None:
    units().set_order(own_first=own_first)
    tested = 0
    for spec in SPECS.readable:
        editor = editor_for(spec)
        if isinstance(editor, NumberEditor):
            tested += 1
            for wire in {min(spec.valid), spec.default, max(spec.valid), *sorted(spec.valid)[::9]}:
                text = editor.textFromValue(wire)
                assert editor.parse(text) == wire, (spec.key, text)
                if own_first:
                    assert text == str(wire)
                    assert editor.parse(spec.text(wire) if spec.unit else text) == wire
    assert tested > 5


def test_switch_changes_cells_help_and_open_editor_at_once(qtbot: QtBot) -> None:
    parameters = ParametersDriver(qtbot)
    parameters.load(SPECS, serial_timeout=13, motor1_acceleration=10)
    parameters.go_to("serial_timeout")
    pwm = parameters.cell("motor1_pwm_maximum").data()
    mode = parameters.cell("motor_mode").data()
    assert parameters.cell("serial_timeout").data() == "1.3 s"

    paints = PaintCounter(parameters.view.viewport())
    parameters.wait(lambda: not paints.count_new())
    units().set_order(own_first=True)
    parameters.wait(paints.count_new)
    assert parameters.cell("serial_timeout").data() == "13"
    assert parameters.cell(ACCELERATION).data() == "10"
    assert parameters.text("parameterValue") == "13"
    assert parameters.cell("motor1_pwm_maximum").data() == pwm
    assert parameters.cell("motor_mode").data() == mode

    editor = parameters.open_with_keys(ACCELERATION)
    assert isinstance(editor, NumberEditor)
    assert editor.text() == "10"
    editor.stepUp()
    assert editor.text() == "11"
    editor.selectAll()
    QTest.keyClicks(editor, "2")
    units().set_order(own_first=False)
    assert editor.text() == "6.3 s to full speed", "the typed 2 does not become 2 s"
    parameters.go_to("serial_timeout")
    parameters.wait_for_value(ACCELERATION, 2)


def test_switch_changes_channels_at_once(qtbot: QtBot, quick_simulator: SimulatedDevice) -> None:
    assert input_text(InputSource.RC, 3092) == "1237 µs (3092)"
    with channels_page(qtbot) as page:
        page.connect(quick_simulator.url)
        quick_simulator.do("channel 1 1800us")
        page.wait(lambda: page.input(1).startswith("1800 µs (4500)"))
        neutral = page.find(QSpinBox, "neutralEdit")
        assert neutral.text() == "1500 µs"

        units().set_order(own_first=True)
        assert page.input(1).startswith("4500 (1800 µs)")
        assert neutral.text() == "3750"
        page.type_into("neutralEdit", "3800")
        assert page.shown().neutral == 3800
        page.type_into("neutralEdit", "1500 µs")
        assert page.shown().neutral == 3750
        page.wait(lambda: "4500 (1800 µs)" in page.live)
