"""Translations: compiled files hold every plural form of the program's texts."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QLocale
from PySide6.QtWidgets import QApplication

from trex_gui.core.resource_files import resource
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexNoReplyError
from trex_gui.ui.translations import error_text, install_translations

ROOT = Path(__file__).parents[2]
GERMAN = """<?xml version="1.0" encoding="utf-8"?>
<TS version="2.1" language="de_DE"><context><name>MainWindow</name>
<message><source>&amp;Stop motors</source><translation>Motoren &amp;stoppen</translation></message>
</context><context><name>TrexErrors</name>
<message><source>No reply to {0}.</source><translation>Stumm: {0}</translation></message>
</context></TS>
"""


def run(tool: str, *arguments: object) -> None:
    program = shutil.which(tool, path=str(Path(sys.executable).parent))
    assert program is not None
    words = [program, *map(str, arguments)]
    subprocess.run(words, check=True, capture_output=True, text=True, timeout=50)


@pytest.mark.realtime
def test_english_plural_forms_are_complete_and_compiled(tmp_path: Path) -> None:
    committed = resource("translations/trex_gui_en.ts")
    update = tmp_path / committed.name
    shutil.copy(committed, update)
    sources = sorted((ROOT / "trex_gui").rglob("*.py"))
    run("pyside6-lupdate", "-locations", "none", "-no-obsolete", "-pluralonly", *sources,
        "-ts", update)  # fmt: skip
    text = update.read_text(encoding="utf-8")
    hint = "run packaging/bootstrap.py translations and fill in the English plural forms"
    assert "unfinished" not in text, hint
    assert re.findall("<source>.*", text) == re.findall("<source>.*", committed.read_text("utf-8"))
    run("pyside6-lrelease", update)
    compiled = resource("translations/trex_gui_en.qm").read_bytes()
    assert update.with_suffix(".qm").read_bytes() == compiled, hint


@pytest.mark.realtime
def test_language_is_one_translation_file(
    qapp: QApplication, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source = tmp_path / "trex_gui_de.ts"
    source.write_text(GERMAN, encoding="utf-8")
    run("pyside6-lrelease", source)
    monkeypatch.setattr("trex_gui.ui.translations.resource", lambda _: tmp_path)
    translators = install_translations(qapp, QLocale("de_AT"))
    assert QCoreApplication.translate("MainWindow", "&Stop motors") == "Motoren &stoppen"
    error = TrexNoReplyError(ErrorCode.NO_REPLY, "get status")
    assert error_text(error) == "Stumm: get status"
    for translator in translators:
        qapp.removeTranslator(translator)


@pytest.mark.parametrize(("count", "text"), [(1, "1 setting"), (2, "2 settings")])
def test_english_counts_have_plural_forms(qapp: QApplication, count: int, text: str) -> None:
    del qapp
    translated = QCoreApplication.translate(
        "TrexWorkspace", "%n setting(s) written and verified.", "", count
    )
    assert translated == f"{text} written and verified."
