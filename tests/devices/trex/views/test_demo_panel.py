"""Demo panel: texts, LEDs, sliders and visibility."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from PySide6.QtCore import QLocale, QSettings, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.support.catalogs import in_language
from tests.support.mouse import turn_wheel
from tests.support.program import trex
from tests.support.window import WindowDriver
from trex_gui.composition import build
from trex_gui.devices.trex.driving.board_reasons import LED_TEXTS, PACKETS
from trex_gui.devices.trex.model.demo import DemoJumpers, DemoLeds, DemoSnapshot, read_snapshot
from trex_gui.devices.trex.protocol.flags import Mode
from trex_gui.devices.trex.simulator.control import control
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.views.demo_panel import led_patterns, led_words, state_text
from trex_gui.ui.devices.demo_panel import DemoDock
from trex_gui.ui.devices.ports import Port, PortKind
from trex_gui.ui.program import Program
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.builders import ComboBox
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.leds import Leds, is_lit
from trex_gui.ui.widgets.sliders import StickSlider

# --- Texts ------------------------------------------------------------------------------


def _running_board() -> DemoSnapshot:
    """Return the state of a board in serial mode, two seconds after its start."""
    line = SimulatedBoards([Board()])
    line.advance(2)
    return read_snapshot(control(line, "show").removeprefix("ok "))


SERIAL = _running_board()
RC = replace(
    SERIAL,
    mode=Mode.RC,
    jumpers=DemoJumpers("rc", mix=False, so_ground=False),
    serial_controls=False,
    leds=DemoLeds("off", "on"),
)


def test_packet_led_is_shown_without_flicker() -> None:
    assert LED_TEXTS[PACKETS].startswith(led_words(PACKETS))
    for flicker in ("on", "off"):
        assert led_patterns(replace(SERIAL, leds=DemoLeds("on", flicker))) == ("on", PACKETS)
        assert led_patterns(replace(RC, leds=DemoLeds(flicker, "on"))) == (PACKETS, "on")


def test_dark_led_is_described_in_french(qapp: QApplication) -> None:
    with in_language(qapp, QLocale("fr")):
        assert led_words("off") == "éteinte"


@pytest.mark.parametrize(
    ("snapshot", "text"),
    [
        (SERIAL, "Serial commands control the motors (serial mode)."),
        (RC, "RC mode. The sticks"),
        (replace(RC, mode=Mode.ANALOG), "Analog mode."),
        (replace(RC, safe_start=True), "Safe-start"),
        (replace(RC, serial_controls=True, override=True), "channel 5 overrides"),
        (replace(RC, power=False), "does not reply"),
        (replace(SERIAL, boot_mode="boot loader: requested"), "Boot loader"),
    ],
)
def test_board_state_is_described(snapshot: DemoSnapshot, text: str) -> None:
    assert text in state_text(snapshot)


# --- LEDs -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("pattern", "lit", "dark"),
    [
        ("blink 1/s", 0.2, 0.7),
        ("blink 4/s", 0.05, 0.2),
        ("alternate 1/s", 0.2, 0.7),
        ("short flash 1/s", 0.05, 0.5),
        ("fast flash", 0.01, 0.1),
    ],
)
def test_pattern_is_lit_and_dark_in_turn(pattern: str, lit: float, dark: float) -> None:
    assert not is_lit("unknown", lit)
    assert is_lit(pattern, 0.0), "lit at time 0, when the pictures of the help are taken"
    assert is_lit(pattern, lit)
    assert is_lit(pattern, lit + 3)
    assert not is_lit(pattern, dark)


def test_alternating_leds_are_never_lit_together() -> None:
    for tenth in range(40):
        seconds = tenth / 10
        first = is_lit("alternate 1/s", seconds)
        assert is_lit("alternate 1/s", seconds, second=True) is not first


def test_leds_blink_and_are_explained(qtbot: QtBot) -> None:
    leds = Leds()
    qtbot.addWidget(leds)
    leds.show()
    leds.show_patterns(("on", "blink 4/s"), ("on", "blink 4/s"))
    red, green = leds.lamps
    qtbot.waitUntil(lambda: green.lit)
    qtbot.waitUntil(lambda: not green.lit)
    assert red.lit
    assert red.accessibleName() == red.toolTip() == "Red LED: on"
    assert green.accessibleName() == "Green LED: blink 4/s"
    leds.show_patterns(("on", "blink 4/s"), meaning="learns")
    assert green.accessibleName() == "Green LED: learns"


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_lit_led_differs_without_colour(qtbot: QtBot, qapp: QApplication, scheme: str) -> None:
    theme().install(qapp)
    theme().set_scheme("dark" if scheme == "dark" else "light")
    leds = Leds()
    qtbot.addWidget(leds)
    green = leds.lamps[1]
    pictures = []
    for lit in (False, True):
        green.set_lit(lit)
        image = green.grab().toImage()
        middle, side = image.pixelColor(image.rect().center()), image.width() // 3
        pictures.append((middle.lightness(), image.pixelColor(side, side).lightness()))
    assert pictures[0] != pictures[1]
    assert pictures[1][0] != pictures[1][1], "a lit LED has a glint"
    assert pictures[0][0] == pictures[0][1]


# --- Slider and note --------------------------------------------------------------------


@pytest.fixture
def slider(qtbot: QtBot) -> StickSlider:
    slider = StickSlider(900, 2100, 1500, "bar")
    qtbot.addWidget(slider)
    slider.resize(200, slider.sizeHint().height())
    slider.show()
    return slider


def test_slider_moves_with_the_mouse_and_follows_the_board(
    slider: StickSlider, qtbot: QtBot
) -> None:
    slider.setValue(2000)
    with qtbot.waitSignal(slider.valueChanged):
        QTest.mouseDClick(slider, Qt.MouseButton.LeftButton)
    assert slider.value() == 1500
    assert not slider.isSliderDown()
    with qtbot.assertNotEmitted(slider.valueChanged):
        slider.follow(1800)
    assert slider.value() == 1800
    slider.setSliderDown(True)
    slider.follow(1000)
    assert slider.value() == 1800


def test_wheel_changes_only_the_focused_widget(slider: StickSlider, qtbot: QtBot) -> None:
    combo = ComboBox()
    qtbot.addWidget(combo)
    combo.addItems(["a", "b", "c"])
    combo.setCurrentIndex(1)
    combo.show()
    for widget in (slider, combo):
        widget.clearFocus()
        turn_wheel(widget)
    assert (slider.value(), combo.currentIndex()) == (1500, 1)
    for widget in (slider, combo):
        widget.activateWindow()
        widget.setFocus()
        qtbot.waitUntil(widget.hasFocus)
        turn_wheel(widget)
    assert slider.value() > 1500
    assert combo.currentIndex() == 0


def test_alarming_note_is_bold_and_coloured(qtbot: QtBot, qapp: QApplication) -> None:
    theme().install(qapp)
    note = Note(2)
    qtbot.addWidget(note)
    note.show_note("short")
    assert note.minimumHeight() == 2 * note.fontMetrics().lineSpacing()
    note.show_note("now!", alarming=True)
    note.ensurePolished()
    assert note.font().bold()
    assert note.palette().color(note.foregroundRole()) == theme().color("warning")
    note.show_note("normal")
    assert not note.font().bold()
    assert note.palette().color(note.foregroundRole()) == theme().color("window_text")


# --- Visibility -------------------------------------------------------------------------


def panel_of(window: WindowDriver) -> DemoDock:
    return window.find(DemoDock, "demoPanel")


@pytest.fixture
def panel(window: WindowDriver) -> DemoDock:
    return panel_of(window)


@pytest.fixture
def restart(program: Program, qtbot: QtBot) -> Callable[[Program], WindowDriver]:
    """Function that closes a program and starts the next one."""

    def restart_program(before: Program) -> WindowDriver:
        before.window.close()
        if before is not program:
            trex(before).controller.shut_down()
        after = build()
        qtbot.addWidget(after.window)
        after.window.show()
        return WindowDriver(after, qtbot)

    return restart_program


def test_panel_is_shown_with_the_demo_unless_closed(window: WindowDriver, panel: DemoDock) -> None:
    connector, action = trex(window.program).controller, window.action("demo")
    demo = window.program.ports.demo_of("trex")
    assert panel.isHidden()
    assert not action.isEnabled()

    connector.connect_to(demo)
    assert panel.isVisible()
    assert window.window.dockWidgetArea(panel) is Qt.DockWidgetArea.RightDockWidgetArea
    assert action.isEnabled()
    assert action.isChecked()
    assert not window.is_enabled("demoInput1"), "the simulator is starting"
    assert "is starting" in window.text("demoState")
    connector.disconnect_device()
    assert panel.isHidden()

    connector.connect_to(demo)
    assert panel.isVisible()
    connector.connect_to(Port(PortKind.TYPED, "/dev/ttyNothing9", "x", "trex"))
    assert panel.isHidden()

    connector.connect_to(demo)
    panel.close()
    assert not action.isChecked()
    connector.disconnect_device()
    connector.connect_to(demo)
    assert panel.isHidden(), "the user closed the panel"
    action.trigger()
    assert panel.isVisible()
    assert action.isChecked()
    action.trigger()
    assert panel.isHidden()


def test_panel_is_restored_at_the_next_start(
    program: Program, panel: DemoDock, restart: Callable[[Program], WindowDriver]
) -> None:
    trex(program).controller.connect_to(program.ports.demo_of("trex"))
    program.window.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, panel)

    window = restart(program)
    second = window.program
    assert panel_of(window).isHidden()
    trex(second).controller.connect_to(second.ports.demo_of("trex"))
    assert panel_of(window).isVisible()
    area = second.window.dockWidgetArea(panel_of(window))
    assert area is Qt.DockWidgetArea.LeftDockWidgetArea

    panel_of(window).close()
    window = restart(second)
    third = window.program
    trex(third).controller.connect_to(third.ports.demo_of("trex"))
    assert panel_of(window).isHidden(), "the user closed the panel"
    trex(third).controller.shut_down()


@pytest.mark.qt_log_ignore("This plugin does not support")  # offscreen
def test_panel_closes_with_the_connection_and_the_window(
    window: WindowDriver, panel: DemoDock
) -> None:
    connector, demo = trex(window.program).controller, window.program.ports.demo_of("trex")
    window.window.setGeometry(0, 0, 780, 620)  # on a screen of width 800
    before = window.window.width()
    connector.connect_to(demo)
    window.wait(panel.isVisible)
    connector.disconnect_device()
    window.wait(lambda: window.window.width() == before)

    connector.connect_to(demo)
    panel.setFloating(True)
    window.window.close()
    assert panel.isHidden()
    assert QSettings().value("window/state") is not None
