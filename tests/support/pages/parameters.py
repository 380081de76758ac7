"""Driver of the Parameters page."""

from PySide6.QtCore import QModelIndex, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QSpinBox

from tests.support.window import WidgetDriver, WindowDriver
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.views.pages.parameters.view import ParameterView


class ParametersPage(WidgetDriver):
    """Parameters page. The constructor opens it."""

    def __init__(self, window: WindowDriver) -> None:
        super().__init__(window.open_page("parametersPage").root, window.qtbot)
        self.view = self.find(ParameterView, "parametersView")

    def index_of(self, key: str) -> QModelIndex:
        """Return the position of a parameter's value in the view."""
        model = self.view.model()
        assert isinstance(model, ParameterModel)
        return model.index_of(key)

    def edit(self, key: str, text: str) -> None:
        """Open the editor of a parameter with the mouse. Enter a valid value."""
        index = self.index_of(key)
        self.view.scrollTo(index)
        place = self.view.visualRect(index).center()
        left = Qt.MouseButton.LeftButton
        QTest.mouseClick(self.view.viewport(), left, pos=place)
        QTest.mouseDClick(self.view.viewport(), left, pos=place)
        editor = self.view.indexWidget(index)
        assert isinstance(editor, QSpinBox)
        editor.selectAll()
        QTest.keyClicks(editor, text)
        QTest.keyClick(editor, Qt.Key.Key_Return)
        self.wait_for_no_editor(key)

    def wait_for_no_editor(self, key: str) -> None:
        self.wait(lambda: self.view.indexWidget(self.index_of(key)) is None)
