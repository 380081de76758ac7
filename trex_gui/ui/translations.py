"""Languages of the window, compiled from Qt Linguist files in `resources/translations/`."""

from datetime import datetime
from functools import partial

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QTranslator
from PySide6.QtWidgets import QApplication

from trex_gui.core.errors import CodedError, describe
from trex_gui.core.resource_files import resource
from trex_gui.core.translation import tr, use_translations
from trex_gui.ui.preferences import Preferences

CONTEXT = "trex_gui"  # the only one in the files: a text has one translation everywhere
ENGLISH = QLocale(QLocale.Language.English)
LANGUAGES = {"en": "English", "de": "Deutsch", "fr": "Français"}  # of the window
AS_THE_SYSTEM = "system"
_KEY = "window/language"


def chosen_language() -> str:
    """Return the code of the selected language, or `AS_THE_SYSTEM`."""
    wanted = Preferences().text(_KEY, AS_THE_SYSTEM)
    return wanted if wanted in LANGUAGES else AS_THE_SYSTEM


def select_language(code: str) -> None:
    """Save the language for the next time that the window opens."""
    Preferences().set(_KEY, code)


def chosen_locale() -> QLocale:
    """Return the locale of the window. The system's locale if it has the selected language."""
    system, code = QLocale.system(), chosen_language()
    is_of_system = code in {AS_THE_SYSTEM, system.name().partition("_")[0]}
    return system if is_of_system else QLocale(code)


def install_translations(app: QApplication, locale: QLocale) -> list[QTranslator]:
    """Install English plural forms, and the language of `locale` if it is available.

    Numbers, dates and the direction of the layout follow the language that is shown. Earlier
    texts do not change. Remove the returned translators before installing another language.
    """
    folder = str(resource("translations"))
    english, catalog, of_qt = (QTranslator(app) for _ in range(3))
    english.load(ENGLISH, "trex_gui", "_", folder)
    installed: list[QTranslator] = [english]
    shown = ENGLISH
    if locale.language() != ENGLISH.language() and catalog.load(locale, "trex_gui", "_", folder):
        shown = QLocale(catalog.language())
        qt_folder = QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)
        of_qt.load(shown, "qtbase", "_", qt_folder)  # the buttons of dialogs
        installed += [of_qt, catalog]
    for translator in installed:
        app.installTranslator(translator)
    is_shown = (locale.language(), locale.zeroDigit()) == (shown.language(), shown.zeroDigit())
    formats = locale if is_shown else shown
    QLocale.setDefault(formats)
    app.setLayoutDirection(shown.textDirection())
    use_translations(partial(QCoreApplication.translate, CONTEXT), formats.decimalPoint())
    return installed


def error_text(error: BaseException) -> str:
    """Return the message of an error, in the language of the window if it has a code."""
    if isinstance(error, CodedError):
        return describe(error.code, error.fields, tr)
    return str(error)


def error_sentence(error: BaseException | None) -> str:
    """Return the message of an error as one sentence with one full stop."""
    return f"{error_text(error).rstrip('. ')}." if error is not None else ""


def local_time(moment: datetime) -> str:
    """Return a moment as `2026-03-14 15:09` in local time."""
    return f"{moment.astimezone():%Y-%m-%d %H:%M}"
