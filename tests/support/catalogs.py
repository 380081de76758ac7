"""Translations of English texts, from the translation files of the program."""

import re
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache, partial

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QTranslator
from PySide6.QtWidgets import QApplication

from tests.support.scripts import load_script
from trex_gui.core.resource_files import resource
from trex_gui.core.translation import use_translations
from trex_gui.ui.translations import CONTEXT, ENGLISH, LANGUAGES, install_translations

OTHER_LANGUAGES = sorted(LANGUAGES.keys() - {"en"})
_PLACEHOLDER = re.compile(r"%n|\{[^{}]*\}")


@contextmanager
def in_language(app: QApplication, locale: QLocale) -> Iterator[None]:
    """Use a language inside the block."""
    installed = install_translations(app, locale)
    try:
        yield
    finally:
        for translator in installed:
            app.removeTranslator(translator)
        QLocale.setDefault(ENGLISH)
        use_translations(partial(QCoreApplication.translate, CONTEXT))


def translation(language: str, text: str) -> str:
    """Return the translation of an English text, with its placeholders.

    Returns a text that is not in the translation files unchanged.
    """
    source = _source(text) or _source(text.removesuffix(":"))
    return _texts(language)[source][-1] if source else text


def translation_of_qt(language: str, text: str) -> str:
    """Return the translation of a Qt button's text."""
    return _texts_of_qt(language).translate("QPlatformTheme", text) or text


@cache
def _texts(language: str) -> dict[str, tuple[str, ...]]:
    """Return the translation or the plural forms of each source text. English has only plurals."""
    file = resource("translations") / f"trex_gui_{language}.ts"
    read = load_script("translations").read(file)
    return {text.source: forms for text, forms in read.items()}


@cache
def _texts_of_qt(language: str) -> QTranslator:
    translator = QTranslator()
    folder = QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)
    assert translator.load(QLocale(language), "qtbase", "_", folder)
    return translator


@cache
def _source(text: str) -> str | None:
    if text in _texts(OTHER_LANGUAGES[0]):
        return text
    matches = (source for pattern, source in _patterns() if pattern.fullmatch(text))
    return next(matches, None)


@cache
def _patterns() -> list[tuple[re.Pattern[str], str]]:
    """Return patterns for texts with a mnemonic and placeholders, each with its source."""
    found = []
    for source in _texts(OTHER_LANGUAGES[0]):
        has_both = "&" in source and _PLACEHOLDER.search(source)
        for form in _texts("en").get(source, (source,)) if has_both else ():
            parts = map(re.escape, _PLACEHOLDER.split(form))
            found.append((re.compile("(.+)".join(parts)), source))
    return found
