"""Each message has a help section, and each help section has a message."""

import ast
import inspect
import re
from collections.abc import Iterator

from PySide6.QtCore import QCoreApplication, QTranslator
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from trex_gui.core.errors import PortFault
from trex_gui.core.recording.kinds import RecordingError
from trex_gui.core.recording.store import _NOT_OPENED
from trex_gui.devices.aracna.session.errors import ErrorCode as RobotErrorCode
from trex_gui.devices.aracna.views import help as aracna
from trex_gui.devices.trex.board.errors import UNSEEN
from trex_gui.devices.trex.driving.blockers import DriveBlocker, Reason
from trex_gui.devices.trex.protocol.errors import ErrorCode, Rejected, ResultCode, TrexError
from trex_gui.devices.trex.settings import reader, rules
from trex_gui.devices.trex.views import help as trex
from trex_gui.ui.help.messages import heading_of, texts_of
from trex_gui.ui.help.pages import MESSAGES, HelpPage, anchor_of, pages
from trex_gui.ui.translations import CONTEXT, error_sentence


def messages_page() -> HelpPage:
    (page,) = (page for page in pages() if page.name == MESSAGES)
    return page


def explained_headings() -> set[str]:
    """Return the headings of the sections on messages."""
    lines = messages_page().text.splitlines()
    return {line.removeprefix("### ") for line in lines if line.startswith("### ")}


def message_headings() -> set[str]:
    """Return a heading for each message that needs a section."""
    texts = [*texts_of(ErrorCode), *texts_of(RobotErrorCode), *texts_of(PortFault)]
    texts += _messages_of_rules()
    texts += [blocker.text for blocker in DriveBlocker]
    texts += [entry.name for entry in UNSEEN]
    return {heading for text in texts if (heading := heading_of(text))}


def _messages_of_rules() -> Iterator[str]:
    """Yield the texts of the rules that have more than 8 words. Shorter texts are fragments."""
    for node in ast.walk(ast.parse(inspect.getsource(rules))):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "tr":
            text = str(ast.literal_eval(node.args[0]))
            if len(text.split()) > 8:
                yield text


def test_each_message_has_a_section_and_each_section_a_message() -> None:
    assert explained_headings() == message_headings()


def test_problem_sections_begin_with_the_text_of_their_cards() -> None:
    texts = {section.title: section.text for section in messages_page().sections}
    for entry in UNSEEN:
        assert texts[entry.name].startswith(f"{entry.meaning} {entry.remedy}")


def test_every_code_of_settings_files_is_explained() -> None:
    lines = messages_page().text.splitlines()
    rows = [line.split("|")[1] for line in lines if line.startswith("| `")]
    assert sorted(re.findall(r"`(\w+)`", " ".join(rows))) == sorted(reader._MESSAGES)


def test_every_explanation_has_at_least_30_characters() -> None:
    headings = explained_headings()
    explanations = [part for part in messages_page().sections if part.title in headings]
    assert not [section.title for section in explanations if len(section.text) < 30]


def test_heading_is_the_first_clause_of_a_message() -> None:
    assert heading_of("{0}: the board rejects this (code 2)") == "The board rejects this (code 2)"
    assert heading_of("No reply to {0}.") == "No reply to …"
    assert heading_of("{name} is {now:.2f} V; reduce it.") == "… is … V"
    assert not heading_of("{0}")


def topic(text: str) -> str:
    return trex.message_help().topic(text)


def test_message_leads_to_its_section(qtbot: QtBot) -> None:
    error = TrexError(ErrorCode.NO_REPLY, "C1 02")
    assert topic(error_sentence(error)) == "messages.md#no-reply-to-"
    line = f"2026-11-23 12:00:00  ⚠ The settings could not be read again. {error_sentence(error)}"
    assert topic(line) == "messages.md#no-reply-to-"
    rejected = Rejected("Serial Timeout", ResultCode.BAD_VALUE)
    assert topic(error_sentence(rejected)) == "messages.md#the-board-rejects-this-value-code-2"
    blocked = Reason(DriveBlocker.CHANNEL_ABOVE, (1, "12 %", "3 %")).text()
    assert topic(blocked) == f"messages.md#{anchor_of('Channel … is … above neutral')}"
    robot = aracna.message_help().topic("The robot is stuck: nothing was sent.")
    assert robot == "messages.md#the-robot-is-stuck"


def test_port_that_cannot_be_opened_leads_to_its_section(qtbot: QtBot) -> None:
    for fault in PortFault:
        message = fault.value.format("/dev/ttyUSB0", "another program", "busy")
        assert topic(message) == f"messages.md#{anchor_of(heading_of(fault.value))}"
        assert aracna.message_help().topic(message) == topic(message)


def test_message_without_a_code_has_no_section(qtbot: QtBot) -> None:
    error = RecordingError("flight.trexrec", _NOT_OPENED.format("Permission denied"))
    assert not topic(error_sentence(error))
    assert not topic("The log was written to /tmp/log.txt.")
    assert not topic("")


def test_message_that_quotes_another_leads_to_its_own_section(qtbot: QtBot) -> None:
    inner = TrexError(ErrorCode.NO_REPLY, "C1 02")
    outer = TrexError(ErrorCode.STRAY_WRITE, "Serial Timeout", inner)
    assert topic(error_sentence(outer)).startswith("messages.md#the-line-corrupted-bytes-while")


class _UpperCaseTranslator(QTranslator):
    """Translates every text of the program into capital letters."""

    def translate(self, context: str, text: str, comment: str | None = None, n: int = -1) -> str:
        return text.upper() if context == CONTEXT else ""


def test_translated_message_leads_to_its_section(qtbot: QtBot, qapp: QApplication) -> None:
    translator = _UpperCaseTranslator()
    assert QCoreApplication.installTranslator(translator)
    try:
        text = error_sentence(TrexError(ErrorCode.OVERTAKEN_BY_STOP))
        assert text == "NOTHING WAS SENT, BECAUSE A STOP WAS REQUESTED FIRST."
        assert topic(text) == "messages.md#nothing-was-sent-because-a-stop-was-requested-first"
    finally:
        QCoreApplication.removeTranslator(translator)
