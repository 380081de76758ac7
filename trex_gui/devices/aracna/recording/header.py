"""Of what a recording of an Aracna is."""

import json
import math
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Any

from trex_gui import __version__
from trex_gui.devices.aracna.poses.project import MOST_MOTORS
from trex_gui.devices.aracna.protocol.units import DEGREES_PER_SECOND, DEGREES_PER_UNIT

ROBOT = "Aracna"


@dataclass(frozen=True, slots=True)
class Header:
    """Of what a recording is.

    Attributes:
        started: when, in UTC.
        clock: what the session's clock said then, in seconds.
        version: of the robot's firmware.
        motors: how many there are.
    """

    started: datetime
    clock: float
    version: int
    motors: int

    def to_json(self) -> str:
        """Return it as one line of JSON; units stand beside what they belong to."""
        return json.dumps(
            {
                "started_utc": self.started.astimezone(UTC).isoformat(),
                "clock_s": self.clock,
                "robot": ROBOT,
                "firmware": self.version,
                "motors": self.motors,
                "degrees_per_position_unit": DEGREES_PER_UNIT,
                "degrees_per_second_per_speed_unit": DEGREES_PER_SECOND,
                "program": f"TReX Studio {__version__}",
            }
        )

    @classmethod
    def from_json(cls, text: str) -> "Header":
        """Return the header of a line of JSON.

        Raises:
            ValueError: it is none, or of something else than an Aracna.
        """
        try:
            data: Any = json.loads(text)
            robot = data["robot"]
            header = cls(
                started=datetime.fromisoformat(data["started_utc"]).astimezone(UTC),
                clock=float(data["clock_s"]),
                version=int(data["firmware"]),
                motors=int(data["motors"]),
            )
        except KeyError as error:
            raise ValueError(f"it lacks {error}") from error
        except (TypeError, AttributeError, RecursionError, OverflowError) as error:
            raise ValueError(str(error)) from error
        if robot != ROBOT:
            raise ValueError(f"it is of {robot!r}, not of {ROBOT}")
        if not 1 <= header.motors <= MOST_MOTORS:
            raise ValueError(f"{header.motors} motors are not 1 to {MOST_MOTORS}")
        if not math.isfinite(header.clock):
            raise ValueError("its time is no number")
        return header
