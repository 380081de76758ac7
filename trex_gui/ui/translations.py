"""Languages of the window, compiled from Qt Linguist files in `resources/translations/`."""

from PySide6.QtCore import QCoreApplication, QLocale, QTranslator
from PySide6.QtWidgets import QApplication

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
