"""Translation files are complete and compiled."""

import ast
import re
import shutil
import subprocess
import sys
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QLocale, Qt
from PySide6.QtWidgets import QApplication, QDialogButtonBox, QPushButton, QVBoxLayout, QWidget
from pytestqt.qtbot import QtBot

from tests.support.catalogs import in_language
from tests.support.keyboard import check_keyboard
from tests.support.scripts import load_script
from trex_gui.core.resource_files import resource
from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexNoReplyError
from trex_gui.ui.translations import ENGLISH, error_text, install_translations

translations = load_script("translations")
GERMAN = """<?xml version="1.0" encoding="utf-8"?>
<TS version="2.1" language="de_DE"><context><name>trex_gui</name>
<message><source>&amp;Stop motors</source><translation>Motoren &amp;stoppen</translation></message>
<message><source>No reply to {0}.</source><translation>Stumm: {0}</translation></message>
</context></TS>
"""


HINT = "run packaging/bootstrap.py translations, translate the new texts, and run it again"
FILES = sorted(resource("translations").glob("*.ts"))
program_texts = cache(translations.program_texts)


def compile_file(file: Path) -> None:
    program = shutil.which("pyside6-lrelease", path=str(Path(sys.executable).parent))
    assert program is not None
    subprocess.run([program, str(file)], check=True, capture_output=True, text=True, timeout=50)


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_translation_file_is_complete_and_compiled(file: Path, tmp_path: Path) -> None:
    update = tmp_path / file.name
    shutil.copy(file, update)
    missing, _ = translations.update(update, program_texts())
    assert missing == 0, HINT
    assert update.read_text("utf-8") == file.read_text("utf-8"), HINT
    compile_file(update)
    assert update.with_suffix(".qm").read_bytes() == file.with_suffix(".qm").read_bytes(), HINT


_FIXED_PARTS = re.compile(r"\{[^{}]*\}|%n|<[^>]*>|\*\.\w+|&(?=\w)|…$|\n")


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_translation_contains_placeholders_tags_and_mnemonic(file: Path) -> None:
    for text, forms in translations.read(file).items():
        fixed = sorted(_FIXED_PARTS.findall(text.source.replace("&&", "")))
        for form in forms:
            found = sorted(_FIXED_PARTS.findall(form.replace("&&", "")))
            uncounted = [part for part in fixed if part != "%n"]  # as in "once" for "%n times"
            assert found in ([fixed] if len(forms) == 1 else [fixed, uncounted]), (text, form)


def test_translatable_texts_are_found_in_every_kind_of_call() -> None:
    module = """
tr("page {0}").format(1)
head = [tr("a" " list") for x in y if tr("in a loop", "comment")]
NOTE = tr_noop("a table")
tr("%n step(s)", "", count)
painter.translate(1, 2)
tr(variable)
"""
    found = [(text.source, text.comment) for text in translations.texts_of_module(module)]
    expected = {("page {0}", ""), ("a list", ""), ("in a loop", "comment"), ("a table", ""),
                ("%n step(s)", "")}  # fmt: skip
    assert set(found) == expected
    assert len(found) == len(expected)


MARKS = translations.MARKS
USER_TEXTS = {"Finding", "LintFinding", "of", "_error", "_report", "_report_damaged"}
"""Callables, apart from error classes, that get texts for users. `of` creates an error."""
WORD = re.compile(r"(?:^|(?<=[ '(]))[A-Za-z]+\b")
ENGLISH_PARTS = {"cli", "simulator", "library.py", "open_board.py", "app.py"}
"""Files and packages with texts that are not translated, for the command line and for programs."""


def name_of(node: ast.expr) -> str:
    return node.attr if isinstance(node, ast.Attribute) else getattr(node, "id", "")


def user_errors(sources: Iterable[str]) -> set[str]:
    """Return the names of all subclasses of `StudioError`."""
    bases = {
        name: set(re.findall(r"\w+", parents))
        for source in sources
        for name, parents in re.findall(r"^class (\w+)\(([^)]*)\)", source, re.MULTILINE)
    }
    errors = {"StudioError"}
    while more := {name for name, parents in bases.items() if parents & errors} - errors:
        errors |= more
    return errors


def unmarked(node: ast.AST) -> Iterator[str]:
    """Yield unmarked texts of three or more words below a node."""
    if isinstance(node, ast.Call) and name_of(node.func) in {*MARKS, "Column"}:
        return
    parts = node.values if isinstance(node, ast.JoinedStr) else [node]
    text = "".join(str(part.value) if isinstance(part, ast.Constant) else "{}" for part in parts)
    is_text = isinstance(node, ast.JoinedStr | ast.Constant)
    is_comment = text.startswith("# ")  # comments in files stay in English
    if is_text and len(WORD.findall(text)) > 2 and not is_comment:
        yield text
    elif not isinstance(node, ast.JoinedStr):
        for child in ast.iter_child_nodes(node):
            yield from unmarked(child)


def untranslatable(module: ast.Module, errors: set[str]) -> Iterator[str]:
    """Yield unmarked texts of errors and tables, given directly or by name."""
    nodes = list(ast.walk(module))
    values = [
        argument
        for node in nodes
        if isinstance(node, ast.Call) and name_of(node.func) in errors | USER_TEXTS
        for argument in [*node.args, *(keyword.value for keyword in node.keywords)]
    ]
    names = {node.id for value in values for node in ast.walk(value) if isinstance(node, ast.Name)}
    values += [
        node.value
        for node in nodes
        if isinstance(node, ast.Assign) and {*map(name_of, node.targets)} & names
    ]
    for node in module.body:
        if isinstance(node, ast.Assign | ast.AnnAssign) and isinstance(node.value, ast.Dict):
            values += node.value.values
    for value in values:
        yield from unmarked(value)


def test_unmarked_text_of_an_error_is_found() -> None:
    module = """
TABLE = {"a": "a table of texts", "b": tr_noop("a marked text")}
class SampleError(StudioError): ...
def fail(path):
    raise SampleError(f"{path} is missing here")
def fail_later(path):
    message = "given by its name"
    if path:
        message = tr("the file {0} is missing").format(path)
    raise SampleError(message, "two words")
"""
    found = list(untranslatable(ast.parse(module), user_errors([module])))
    assert found == ["{} is missing here", "given by its name", "a table of texts"]


def test_every_text_of_an_error_can_be_translated() -> None:
    program = translations.PROGRAM
    sources = {
        path.relative_to(program): path.read_text("utf-8") for path in sorted(program.rglob("*.py"))
    }
    errors = user_errors(sources.values())
    has_texts = re.compile(rf"\b({'|'.join(errors | USER_TEXTS)})\(|^[^#\n]* = {{", re.MULTILINE)
    found = [
        f"{path}: {text}"
        for path, source in sources.items()
        if not ENGLISH_PARTS & {*path.parts} and has_texts.search(source)
        for text in untranslatable(ast.parse(source), errors)
    ]
    assert not found, "\n".join(found)


@pytest.mark.realtime
def test_translation_file_translates_texts_and_errors(
    qapp: QApplication, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source = tmp_path / "trex_gui_de.ts"
    source.write_text(GERMAN, encoding="utf-8")
    compile_file(source)
    monkeypatch.setattr("trex_gui.ui.translations.resource", lambda _: tmp_path)
    translators = install_translations(qapp, QLocale("de_AT"))
    assert tr("&Stop motors") == "Motoren &stoppen"
    assert tr("not translated") == "not translated"
    assert tr("No reply to {0}.") == "Stumm: {0}"
    assert QCoreApplication.translate("QPlatformTheme", "Cancel") == "Abbrechen"
    error = TrexNoReplyError(ErrorCode.NO_REPLY, "get status")
    assert error_text(error) == "Stumm: get status"
    # Reset the number formats for later tests.
    for translator in (*translators, *install_translations(qapp, ENGLISH)):
        qapp.removeTranslator(translator)
    monkeypatch.undo()
    install_translations(qapp, ENGLISH)


@pytest.mark.parametrize("code", ["ar_EG", "fa_IR", "he_IL", "es_ES"])
def test_english_window_has_english_layout_and_numbers(qapp: QApplication, code: str) -> None:
    with in_language(qapp, QLocale(code)):
        assert qapp.layoutDirection() is Qt.LayoutDirection.LeftToRight
        assert QLocale().toString(-61) == "-61"
        assert QCoreApplication.translate("QPlatformTheme", "Cancel") == "Cancel"


@pytest.mark.parametrize(("count", "text"), [(1, "1 setting"), (2, "2 settings")])
def test_english_counts_have_plural_forms(qapp: QApplication, count: int, text: str) -> None:
    del qapp
    assert tr("%n setting(s) written and verified.", "", count) == f"{text} written and verified."


def test_mnemonic_repeated_only_in_a_translation_is_found(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    window = QWidget()
    qtbot.addWidget(window)
    first, second = QPushButton("&Open", window), QPushButton("&Paste", window)
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close, window)
    layout = QVBoxLayout(window)
    for widget in (first, second, buttons):
        layout.addWidget(widget)
    window.show()
    translated = {"&Open": "&Kopieren", "&Paste": "&Einfügen"}
    monkeypatch.setattr("tests.support.keyboard.translation", lambda _, text: translated[text])
    check_keyboard(window)
    translated["&Paste"] = "&Klemmbrett"
    with pytest.raises(AssertionError, match=r"de: Alt.K is &Kopieren and &Klemmbrett"):
        check_keyboard(window)
    translated["&Paste"] = "Ein&setzen"
    with pytest.raises(AssertionError, match=r"de: Alt.S is Ein&setzen and &Schließen"):
        check_keyboard(window)
