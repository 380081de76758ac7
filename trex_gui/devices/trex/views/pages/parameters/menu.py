"""What can be done with the current row of the parameter table, as menu and as shortcuts."""

from collections.abc import Callable

from PySide6.QtCore import QModelIndex, QObject, QPoint, Qt, Slot
from PySide6.QtGui import QAction, QGuiApplication, QKeySequence
from PySide6.QtWidgets import QMenu

from trex_gui.devices.trex.model.parameters.parameters import ParameterModel, Role
from trex_gui.devices.trex.protocol.parameters import ParameterSpec, motor_name
from trex_gui.devices.trex.views.pages.parameters.view import ParameterView
from trex_gui.ui.theme.icons import set_icon


class ParameterMenu(QObject):
    """Belongs to a view; its shortcuts act on the current row while the view has the focus."""

    def __init__(self, model: ParameterModel, view: ParameterView) -> None:
        super().__init__(view)
        self._model = model
        self._view = view
        self._edit = self._action("editParameter", self.tr("Edit"))
        self._reset = self._action("resetParameter", self.tr("Back to default"), "default")
        self._reset.setShortcut(QKeySequence("Ctrl+Backspace"))
        self._restore = self._action("restoreParameter", self.tr("Back to what is stored"))
        self._leave_out = self._action("leaveOutParameter", self.tr("Leave out of the file"))
        self._to_other_motor = self._action("copyToTwin", "")
        self._copy = self._action("copyParameter", self.tr("Copy"), "copy")
        self._copy.setShortcut(QKeySequence.StandardKey.Copy)
        self._menu = QMenu(view)
        self._menu.setObjectName("parameterMenu")
        self._menu.addAction(self._edit)
        self._menu.addSeparator()
        self._menu.addActions([self._reset, self._restore, self._leave_out, self._to_other_motor])
        self._menu.addSeparator()
        self._menu.addAction(self._copy)
        for action in (self._reset, self._copy):
            action.setShortcutContext(Qt.ShortcutContext.WidgetShortcut)
            view.addAction(action)

        self._edit.triggered.connect(lambda: view.begin_edit(view.currentIndex()))
        self._reset.triggered.connect(lambda: self._with_key(model.reset))
        self._restore.triggered.connect(lambda: self._with_key(model.restore))
        self._leave_out.triggered.connect(lambda: self._with_key(model.leave_out))
        self._to_other_motor.triggered.connect(lambda: self._with_key(model.copy_to_other_motor))
        self._copy.triggered.connect(self._on_copy)
        view.menu_wanted.connect(self._on_menu_wanted)

    def _action(self, name: str, text: str, icon: str = "") -> QAction:
        action = QAction(text, self)
        action.setObjectName(name)
        if icon:
            set_icon(action, icon)
        return action

    def _with_key(self, act: Callable[[str], None]) -> None:
        spec = self._spec()
        if spec is not None and self._view.isEnabled():
            act(spec.key)

    def _spec(self) -> ParameterSpec | None:
        found = self._view.currentIndex().data(Role.SPEC)
        return found if isinstance(found, ParameterSpec) else None

    @Slot(QPoint)
    def _on_menu_wanted(self, place: QPoint) -> None:
        self._prepare(self._view.currentIndex())
        self._menu.popup(place)

    def _prepare(self, index: QModelIndex) -> None:
        """Say what each action would do with a row, and grey what would do nothing."""
        spec = self._spec()
        if spec is None:
            return
        model, key = self._model, spec.key
        stored = model.stored_of(key)
        self._edit.setEnabled(model.knows(key))
        self._reset.setText(model.text.reset_text(spec))
        self._reset.setEnabled(index.data(Role.RESET) is not None)
        back = self.tr("Back to what is stored")
        if stored is not None:
            back = self.tr("{0}: {1}").format(back, model.text.with_wire(spec, stored))
        self._restore.setText(back)
        self._restore.setEnabled(model.is_modified(key))
        self._leave_out.setVisible(model.can_leave_out(key))
        other_motor = model.other_motor_of(key)
        self._to_other_motor.setVisible(other_motor is not None)
        if other_motor is not None:
            self._to_other_motor.setText(
                self.tr("Give {0} the same").format(motor_name(other_motor))
            )
            self._to_other_motor.setEnabled(
                model.value_of(key) not in {None, model.value_of(other_motor)}
            )
        self._copy.setText(self.tr("Copy as “{0}”").format(self._line(key)))
        self._copy.setEnabled(model.value_of(key) is not None)

    def _line(self, key: str) -> str:
        """A parameter as a line of a settings file."""
        return f"{key}: {self._model.value_of(key)}"

    @Slot()
    def _on_copy(self) -> None:
        spec = self._spec()
        if spec is not None and self._model.value_of(spec.key) is not None:
            QGuiApplication.clipboard().setText(self._line(spec.key))
