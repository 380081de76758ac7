"""How a sequence or gait is played: rounds, speed, blending, and the buttons."""

from dataclasses import dataclass

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import (
    QCheckBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from trex_gui.devices.aracna.views.poses.parts import spin_box
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.widgets.note import Note

_MOST_ROUNDS = 999
_SLOWEST, _FASTEST = 10, 400  # percent


@dataclass(frozen=True, slots=True)
class PlayChoices:
    """How it is to be played; `rounds` is 0 for ever, `time_scale` 2 is half as fast."""

    rounds: int
    time_scale: float
    blend_in: bool
    blend_out: bool


class PlayBar(QWidget):
    """Controls and a summary; a part of the panel, which says what they act on.

    Signals:
        play_clicked: a person wants it.
        choices_changed: how it is to be played is another now.
        scale_changed: the factor on every step's time is another, also while something plays.
    """

    play_clicked = Signal()
    choices_changed = Signal()
    scale_changed = Signal(float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaPlayBar")
        self._play = QPushButton(self.tr("Pla&y"), self)
        self._play.setObjectName("aracnaPlay")
        set_icon(self._play, "run")
        self._rounds: QSpinBox = spin_box(self, "aracnaRounds", self.tr("Rounds"))
        self._rounds.setRange(1, _MOST_ROUNDS)
        self._loop = QCheckBox(self.tr("&Loop"), self)
        self._loop.setObjectName("aracnaLoop")
        self._loop.setToolTip(self.tr("Go on until somebody ends it."))
        self._speed: QSpinBox = spin_box(self, "aracnaSpeedScale", self.tr("Speed in percent"))
        self._speed.setRange(_SLOWEST, _FASTEST)
        self._speed.setSingleStep(10)
        self._speed.setValue(100)
        self._speed.setSuffix(self.tr(" %"))
        self._speed.setToolTip(
            self.tr("Also while it plays, from the next step on. 50 %: each step takes twice.")
        )
        self._blend_in = QCheckBox(self.tr("Blend &in"), self)
        self._blend_in.setObjectName("aracnaBlendIn")
        self._blend_in.setToolTip(self.tr("First go slowly, in 3 s, to where it begins."))
        self._blend_in.setChecked(True)
        self._blend_out = QCheckBox(self.tr("Blend o&ut to stand"), self)
        self._blend_out.setObjectName("aracnaBlendOut")
        self._blend_out.setToolTip(self.tr("At the end go slowly, in 3 s, to the pose “stand”."))
        self._summary = Note(2, self)
        self._summary.setObjectName("aracnaPlaySummary")
        self._summary.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)

        choices = QGridLayout()
        choices.setHorizontalSpacing(8)
        choices.setVerticalSpacing(3)
        for column, (text, field, box) in enumerate(
            (
                (self.tr("&Rounds"), self._rounds, self._loop),
                (self.tr("S&peed"), self._speed, None),
            )
        ):
            label = QLabel(text, self)
            label.setBuddy(field)
            choices.addWidget(label, 0, 3 * column)
            choices.addWidget(field, 0, 3 * column + 1)
            if box is not None:
                choices.addWidget(box, 0, 3 * column + 2)
        choices.setColumnStretch(5, 1)
        blends = QHBoxLayout()
        blends.addWidget(self._blend_in)
        blends.addWidget(self._blend_out)
        blends.addStretch(1)
        buttons = QHBoxLayout()
        buttons.addWidget(self._play)
        buttons.addStretch(1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addLayout(choices)
        layout.addLayout(blends)
        layout.addWidget(self._summary)
        layout.addLayout(buttons)

        self._play.clicked.connect(self._on_play_clicked)
        self._rounds.valueChanged.connect(self.choices_changed)
        self._loop.toggled.connect(self._on_loop_toggled)
        self._blend_in.toggled.connect(self._on_blend_toggled)
        self._blend_out.toggled.connect(self._on_blend_toggled)
        self._speed.valueChanged.connect(self._on_speed_changed)

    @property
    def choices(self) -> PlayChoices:
        """How it is to be played."""
        return PlayChoices(
            0 if self._loop.isChecked() else self._rounds.value(),
            100 / self._speed.value(),
            self._blend_in.isChecked(),
            self._blend_out.isChecked(),
        )

    def allow(self, *, play: bool, why: str) -> None:
        """Let it be played; `why` says what is lacking."""
        self._play.setEnabled(play)
        self._play.setToolTip(why)

    def show_summary(self, text: str, *, alarming: bool) -> None:
        """Say what would be played, and what cannot be as it is written."""
        self._summary.show_note(text, alarming=alarming)
        self._summary.setAccessibleName(text or self.tr("Nothing to play"))

    @Slot()
    def _on_play_clicked(self) -> None:
        self.play_clicked.emit()

    @Slot(bool)
    def _on_loop_toggled(self, checked: bool) -> None:
        self._rounds.setEnabled(not checked)
        self.choices_changed.emit()

    @Slot()
    def _on_blend_toggled(self) -> None:
        self.choices_changed.emit()

    @Slot()
    def _on_speed_changed(self) -> None:
        self.choices_changed.emit()
        self.scale_changed.emit(self.choices.time_scale)
