"""Languages of the window, from the Qt Linguist files in `resources/translations/`."""

from datetime import datetime
from functools import partial

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QTranslator
from PySide6.QtWidgets import QApplication

from trex_gui.core.errors import CodedError, describe
from trex_gui.core.resource_files import resource
from trex_gui.core.translation import tr, use_translations
from trex_gui.ui.preferences import Preferences

CONTEXT = "trex_gui"  # the only context, so that a text has one translation everywhere
ENGLISH = QLocale(QLocale.Language.English)
LANGUAGES = {"en": "English", "de": "Deutsch", "fr": "Français"}
SYSTEM_LANGUAGE = "system"
_KEY = "window/language"


def selected_language() -> str:
    """Return a key of `LANGUAGES`, or `SYSTEM_LANGUAGE`."""
    code = Preferences().text(_KEY, SYSTEM_LANGUAGE)
    return code if code in LANGUAGES else SYSTEM_LANGUAGE


def select_language(code: str) -> None:
    """Save the language for the next start of the program."""
    Preferences().set(_KEY, code)


def selected_locale() -> QLocale:
    """Return the locale of the selected language.

    If the system uses that language, return the system's locale, which also names the country.
    """
    system, code = QLocale.system(), selected_language()
    is_system = code in {SYSTEM_LANGUAGE, system.name().partition("_")[0]}
    return system if is_system else QLocale(code)


def install_translations(app: QApplication, locale: QLocale) -> list[QTranslator]:
    """Install English plural forms, and the language of `locale` if it is available.

    Numbers, dates and the layout direction follow the installed language. Visible texts do not
    change. Remove the returned translators before the next call.
    """
    folder = str(resource("translations"))
    english, catalog, qt_catalog = (QTranslator(app) for _ in range(3))
    english.load(ENGLISH, "trex_gui", "_", folder)
    installed: list[QTranslator] = [english]
    language = ENGLISH
    if locale.language() != ENGLISH.language() and catalog.load(locale, "trex_gui", "_", folder):
        language = QLocale(catalog.language())
        qt_folder = QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)
        qt_catalog.load(language, "qtbase", "_", qt_folder)  # buttons of dialogs
        installed += [qt_catalog, catalog]
    for translator in installed:
        app.installTranslator(translator)
    is_installed = locale.language() == language.language()
    formats = locale if is_installed and locale.zeroDigit() == language.zeroDigit() else language
    QLocale.setDefault(formats)
    app.setLayoutDirection(language.textDirection())
    use_translations(partial(QCoreApplication.translate, CONTEXT), formats.decimalPoint())
    return installed


def error_text(error: BaseException) -> str:
    """Return the message of an error, translated if it has a code."""
    if isinstance(error, CodedError):
        return describe(error.code, error.fields, tr)
    return str(error)


def error_sentence(error: BaseException | None) -> str:
    """Return the message of an error, ending in one full stop. Empty without an error."""
    return f"{error_text(error).rstrip('. ')}." if error is not None else ""


def local_time(moment: datetime) -> str:
    """Format a time as local time: `2026-03-14 15:09`."""
    return f"{moment.astimezone():%Y-%m-%d %H:%M}"
