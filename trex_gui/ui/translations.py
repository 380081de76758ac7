"""Languages of the window, compiled from Qt Linguist files in `resources/translations/`."""

from datetime import datetime
from functools import partial

from PySide6.QtCore import QCoreApplication, QLocale, QTranslator
from PySide6.QtWidgets import QApplication

from trex_gui.core.errors import CodedError, describe
from trex_gui.core.resource_files import resource

ENGLISH = QLocale(QLocale.Language.English)


def install_translations(app: QApplication, locale: QLocale) -> list[QTranslator]:
    """Use the plural forms of English and the language of `locale`, as far as they are there."""
    installed = []
    languages = {language.language(): language for language in (ENGLISH, locale)}
    for language in languages.values():
        translator = QTranslator(app)
        if translator.load(language, "trex_gui", "_", str(resource("translations"))):
            app.installTranslator(translator)
            installed.append(translator)
    return installed


class Plural:
    """Texts with a count outside of QObjects: `lupdate` finds no count in `translate`."""

    @staticmethod
    def tr(text: str, comment: str, count: int) -> str:
        return QCoreApplication.translate("Plural", text, comment, count)


def error_text(error: BaseException) -> str:
    """Return the message of an error in the language of the window, as far as it has a code."""
    if isinstance(error, CodedError):
        translate = partial(QCoreApplication.translate, error.context)
        return describe(error.code, error.fields, translate)
    return str(error)


def error_sentence(error: BaseException | None) -> str:
    """Return the message of an error as one sentence with one full stop."""
    return f"{error_text(error).rstrip('. ')}." if error is not None else ""


def local_time(moment: datetime) -> str:
    """Return a moment as `2026-03-14 15:09` in local time."""
    return f"{moment.astimezone():%Y-%m-%d %H:%M}"
