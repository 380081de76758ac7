"""Newest samples of a board, connected or recorded."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Self, TypeVar

from trex_gui.core.recording.kinds import Marker
from trex_gui.devices.trex.client.telemetry import ModeSample, Sample
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.recording import (
    STOP,
    AuxiliarySetpointRecord,
    Header,
    Record,
    SetpointRecord,
    SettingsSnapshot,
)

SampleT = TypeVar("SampleT", bound=Sample)


@dataclass(slots=True)
class Newest:
    """The newest sample of each polled value."""

    samples: dict[type[Sample], Any] = field(default_factory=dict)

    def __copy__(self) -> Self:
        return replace(self, samples=self.samples.copy())

    def __getitem__(self, kind: type[SampleT]) -> SampleT:
        """Return a sample; KeyError while there is none."""
        sample: SampleT = self.samples[kind]
        return sample

    def get(self, kind: type[SampleT]) -> SampleT | None:
        return self.samples.get(kind)

    def take(self, sample: Sample) -> None:
        self.samples[type(sample)] = sample


@dataclass(slots=True)
class BoardSnapshot(Newest):
    """State of a board at a time of a recording. `setpoints` is by motor, 1 or 2."""

    settings: str = ""
    setpoints: Mapping[int, Drive] = field(default_factory=dict)
    auxiliary: int | None = None

    @classmethod
    def at_start(cls, header: Header) -> Self:
        return cls({ModeSample: ModeSample(header.clock, header.mode)}, header.settings)

    def take(self, record: Record) -> None:
        match record:
            case Sample():
                self.samples[type(record)] = record
            case SetpointRecord(motor=motor, drive=drive):
                self.setpoints = {**self.setpoints, motor: drive}
            case AuxiliarySetpointRecord(speed=speed):
                self.auxiliary = speed
            case Marker(kind=kind):
                if kind == STOP:
                    self.setpoints, self.auxiliary = {}, None
            case SettingsSnapshot(text=text):
                self.settings = text
