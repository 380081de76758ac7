"""Filter of the parameter table."""

from dataclasses import dataclass
from enum import IntEnum, auto

from PySide6.QtCore import QModelIndex

from trex_gui.devices.trex.model.parameters.parameters import ParameterModel


class ParameterChoice(IntEnum):
    ALL = 0
    CHANGED = auto()
    NOT_DEFAULT = auto()
    FOUND = auto()


@dataclass(frozen=True, slots=True)
class ParameterFilter:
    """Conditions that a visible row meets."""

    words: tuple[str, ...] = ()  # lower case, searched in name, key and description
    shown: ParameterChoice = ParameterChoice.ALL
    found: frozenset[str] = frozenset()  # keys that a finding of the linter is about

    def rows(self, model: ParameterModel) -> list[int]:
        """Return the visible rows, with their headings."""
        rows: list[int] = []
        heading: list[int] = []
        for number, row in enumerate(model.rows):
            if not row.keys:
                heading = [number]
            elif self._accepts(model, row.keys):
                rows += [*heading, number]
                heading = []
        return rows

    def best_match(self, model: ParameterModel) -> QModelIndex:
        """Return the first visible value with all words in its name, else the first value."""
        keys = [keys[0] for row in self.rows(model) if (keys := model.rows[row].keys)]
        names = ((key, model.text.title(key).casefold()) for key in keys)
        named = (key for key, name in names if all(word in name for word in self.words))
        return model.index_of(next(named, keys[0] if keys else ""))

    def _accepts(self, model: ParameterModel, keys: tuple[str, ...]) -> bool:
        values, members = model.values, [each for key in keys for each in model.text.together(key)]
        is_shown = {
            ParameterChoice.CHANGED: values.is_modified,
            ParameterChoice.NOT_DEFAULT: values.differs_from_default,
            ParameterChoice.FOUND: self.found.__contains__,
        }.get(self.shown)
        if is_shown is not None and not any(map(is_shown, members)):
            return False
        specs = [values.specs[key] for key in members]
        texts = [each for spec in specs for each in (spec.name, spec.key, spec.description)]
        searched = " ".join((*texts, *map(model.text.title, keys))).casefold()
        return all(word in searched for word in self.words)
