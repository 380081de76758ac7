"""Settings as rows of a table, with what they mean to a person in a comment."""

from collections.abc import Iterable
from dataclasses import dataclass

from trex_gui.devices.trex.code_export.language import Language
from trex_gui.devices.trex.code_export.text import plain
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import InputSource, Mode
from trex_gui.devices.trex.protocol.parameters import ParameterSpec
from trex_gui.devices.trex.settings.document import CALIBRATION_FIELDS, CALIBRATION_KEYS, Settings
from trex_gui.devices.trex.settings.writer import calibration_text, check_keys, parameter_text

_LETTERS = {mode.source: mode.value for mode in Mode if mode.is_serial}
"""What 0x82 answers in serial mode, by the inputs whose calibrations the board shows then."""

_COMMENT_COLUMN = 42
"""Where comments begin at the latest, unless the code before them is longer."""


@dataclass(frozen=True, slots=True)
class TableRow:
    """One line of a table: code, and what follows it as a comment."""

    code: str
    comment: str = ""


@dataclass(frozen=True, slots=True)
class Tables:
    """What of some settings can be stored, in the order in which it should be.

    Attributes:
        parameters: with their wire values; those come last that make the board another to
            talk to, so that an interruption leaves it reachable.
        calibrations: by input source and channel.
        left_out: a sentence for each value that the board would refuse.
    """

    parameters: tuple[tuple[ParameterSpec, int], ...]
    calibrations: tuple[tuple[InputSource, int, Calibration], ...]
    left_out: tuple[str, ...]

    @classmethod
    def of(cls, settings: Settings) -> "Tables":
        """Sort out settings.

        Raises:
            BadRequest: they hold a key that their model and firmware do not have.
        """
        check_keys(settings)
        left_out = []
        parameters = []
        for spec in settings.specs.readable:
            wire = settings.parameters.get(spec.key)
            if wire is None:
                continue
            if problem := spec.problem(wire):
                left_out.append(problem)
            else:
                parameters.append((spec, wire))
        calibrations = []
        for key, (source, channel) in CALIBRATION_KEYS.items():
            calibration = settings.calibrations.get((source, channel))
            if calibration is None:
                continue
            if problem := calibration.problem():
                left_out.append(f"{key}: {problem}")
            else:
                calibrations.append((source, channel, calibration))
        parameters.sort(key=lambda pair: _order(pair[0]))
        return cls(tuple(parameters), tuple(calibrations), tuple(left_out))

    def wire(self, key: str) -> int | None:
        """Return the wire value that a parameter is to have; `None` when it is not stored."""
        return next((wire for spec, wire in self.parameters if spec.key == key), None)

    def parameter_rows(self, language: Language) -> str:
        """Return the table of parameters."""
        return _aligned(language, [_parameter(language, *pair) for pair in self.parameters])

    def calibration_rows(self, language: Language) -> str:
        """Return the table of calibrations."""
        return _aligned(language, [_calibration(language, *place) for place in self.calibrations])


def _order(spec: ParameterSpec) -> tuple[bool, bool, int]:
    return spec.needs_power_cycle, spec.group == "serial", spec.number


def _parameter(language: Language, spec: ParameterSpec, wire: int) -> TableRow:
    number, name = f"0x{spec.number:02X}", plain(spec.name)
    meaning = plain(parameter_text(spec, wire))
    match language:
        case Language.PYTHON:
            return TableRow(f'({number}, {wire}, "{name}"),', meaning)
        case Language.C:
            return TableRow(f'{{{number}, {wire}, "{name}"}},', meaning)
        case Language.ARDUINO:  # names would take a quarter of an Uno's memory
            return TableRow(f"{{{number}, {wire}}},", f"{name}: {plain(spec.text(wire))}")


def _calibration(
    language: Language, source: InputSource, channel: int, calibration: Calibration
) -> TableRow:
    letter = _LETTERS[source]
    values = ", ".join(str(getattr(calibration, field)) for field in CALIBRATION_FIELDS)
    text = plain(calibration_text(source, calibration))
    if language is Language.PYTHON:
        return TableRow(f'("{letter}", {channel}, ({values})),', text)
    return TableRow(f"{{'{letter}', {channel}, {{{values}}}}},", text)


def _aligned(language: Language, rows: Iterable[TableRow]) -> str:
    """Return rows under each other, their comments too."""
    rows = list(rows)
    # ruff's and black's style has two blanks before a comment and none to align them.
    is_aligned = language is not Language.PYTHON
    width = max((len(row.code) for row in rows), default=0) if is_aligned else 0
    width = min(width, _COMMENT_COLUMN)
    return "\n".join(
        f"{row.code:{width}}{language.comment} {row.comment}" if row.comment else row.code
        for row in rows
    )
