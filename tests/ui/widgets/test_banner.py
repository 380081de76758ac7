"""Banner with messages and their buttons."""

import pytest
from PySide6.QtCore import QPoint
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit, QWidget
from pytestqt.qtbot import QtBot

from tests.support.window import LEFT, WidgetDriver
from trex_gui.core.errors import BadReply, InternalError, PortUnavailable, StudioError
from trex_gui.ui.notifier import Answer, CopyCommand, Notifier, Remedies, Remedy, remedies_of
from trex_gui.ui.runtime import runtime
from trex_gui.ui.widgets.builders import column
from trex_gui.ui.widgets.messages import Banner

FIND, RECONNECT = Remedy.FIND, Remedy.RECONNECT


def test_buttons_act_and_disappear_with_their_message(qtbot: QtBot) -> None:
    notifier = Notifier()
    banner = Banner(None, notifier)
    qtbot.addWidget(banner)
    driver = WidgetDriver(banner, qtbot)
    selected: list[Remedy] = []
    banner.chosen.connect(selected.append)

    notifier.report("Permission denied.", (CopyCommand("sudo usermod"), RECONNECT, FIND))
    QTest.mouseClick(driver.button("bannerReconnect"), LEFT, pos=QPoint(8, 8))
    assert not selected, "the button has just appeared under the pointer"
    driver.click("bannerReconnect")
    driver.click("bannerFind")
    assert selected == [RECONNECT, FIND]
    driver.click("bannerCopy")
    assert QGuiApplication.clipboard().text() == "sudo usermod"
    assert driver.button("bannerCopy").text() == "Copied"

    for signal in (notifier.error, notifier.info):
        notifier.report("Gone.", (RECONNECT,))
        assert not driver.has("bannerFind")
        signal.emit("Something else.")
        assert not driver.has("bannerReconnect")
        assert banner.text == "Something else."


def test_message_with_a_report_button_survives_a_connection(qtbot: QtBot) -> None:
    notifier = Notifier()
    banner = Banner(None, notifier)
    qtbot.addWidget(banner)
    driver = WidgetDriver(banner, qtbot)
    for remedies, text in (((RECONNECT,), ""), ((Remedy.REPORT,), "It failed.")):
        notifier.report("It failed.", remedies)
        notifier.cleared.emit()
        assert banner.text == text
    driver.click("bannerDismiss")
    assert not banner.text
    assert not driver.has("bannerReport")


def test_only_information_disappears_automatically(qtbot: QtBot) -> None:
    window, notifier = QWidget(), Notifier()
    qtbot.addWidget(window)
    banner, editor = Banner(window, notifier), QLineEdit(window)
    column((editor, 1), banner, into=window)
    window.resize(400, 400)
    window.show()
    editor.setFocus()
    notifier.info.emit("Written.")
    qtbot.waitUntil(lambda: not banner.text)
    notifier.error.emit("Not written.")
    runtime().sleep(60)
    assert banner.text == "Not written."
    notifier.prompt("Write?", Answer("yes", "Yes", lambda: None))
    runtime().sleep(60)
    assert banner.text == "Write?"


@pytest.mark.parametrize(
    ("error", "may_be_found", "remedies"),
    [
        (PortUnavailable("gone"), False, (RECONNECT,)),
        (PortUnavailable("denied", command="sudo"), False, (CopyCommand("sudo"), RECONNECT)),
        (BadReply("not like a TReX"), True, (FIND,)),
        (StudioError("other"), False, ()),
        (InternalError("internal"), True, (Remedy.REPORT,)),
    ],
)
def test_remedies_follow_from_the_error(
    error: StudioError, may_be_found: bool, remedies: Remedies
) -> None:
    assert remedies_of(error, may_be_found=may_be_found) == remedies
