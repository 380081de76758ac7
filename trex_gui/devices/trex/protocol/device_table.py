"""Board models, PWM clock and baud rates from the device table.

The table `resources/trex_parameters.toml` is the only source of these facts. Inferred facts are
marked there.
"""

import tomllib
from dataclasses import dataclass
from functools import cache
from typing import Any

from trex_gui.core.errors import BadRequest
from trex_gui.core.resource_files import resource
from trex_gui.core.translation import tr

HIGHEST_WIRE = 127


@dataclass(frozen=True, slots=True)
class Model:
    key: str
    name: str
    part: str
    signature: bytes
    signature_size: int
    current_unit: float  # amperes per count
    firmware: tuple[str, ...]
    highest_pwm: int | None  # Hz; `None` if no limit is known
    guide: str  # URL of the user's guide


@dataclass(frozen=True, slots=True)
class PwmClock:
    """Formula for the PWM frequency.

    The formula is inferred. It yields both documented frequencies.
    """

    clock: int
    divisors: tuple[int, ...]
    scale: int
    offset: int

    def maximum(self, wire: int) -> int:
        return self.scale * wire + self.offset

    def frequency(self, prescaler: int, maximum_wire: int) -> float:
        """Return the frequency in Hz. Raise BadRequest for an unknown prescaler."""
        if not 0 <= prescaler < len(self.divisors):
            text = tr("the PWM prescaler must be 0 to {0}, not {1}")
            raise BadRequest(text.format(len(self.divisors) - 1, prescaler))
        return self.clock / (self.divisors[prescaler] * (self.maximum(maximum_wire) + 1))

    def choices(self, highest: float) -> tuple[tuple[int, int], ...]:
        """Return (prescaler, maximum) pairs up to `highest` Hz, sorted by frequency.

        Both are wire values. Each frequency uses the lowest prescaler that reaches it, because this
        gives the finest speed steps.
        """
        pairs = [
            (prescaler, maximum)
            for prescaler in range(len(self.divisors))
            for maximum in range(HIGHEST_WIRE + 1)
            if self.frequency(prescaler, maximum) <= highest
            and (
                prescaler == 0
                or self.frequency(prescaler, maximum) < self.frequency(prescaler - 1, HIGHEST_WIRE)
            )
        ]
        return tuple(sorted(pairs, key=lambda pair: self.frequency(*pair)))


@dataclass(frozen=True, slots=True)
class DeviceTable:
    models: tuple[Model, ...]
    baud_rates: tuple[int, ...]
    half_rates: tuple[int, ...]  # rates that old firmware halves
    half_rate_fixed_in: str  # first firmware version without this bug
    pwm: PwmClock
    rows: tuple[dict[str, Any], ...]  # parameter entries, which `parameters` parses

    def model(self, key: str) -> Model:
        for model in self.models:
            if model.key == key:
                return model
        known = ", ".join(model.key for model in self.models)
        raise BadRequest(tr("the model must be {0}, not {1!r}").format(known, key))


@cache
def device_table() -> DeviceTable:
    data = tomllib.loads(resource("trex_parameters.toml").read_text(encoding="utf-8"))
    models = tuple(
        Model(
            key=key,
            name=row["signature"].replace("Jr", " Jr"),
            part=row["part"],
            signature=row["signature"].encode("ascii"),
            signature_size=row["signature_length"],
            current_unit=row["current_unit_ma"] / 1000,
            firmware=tuple(row["firmware"]),
            highest_pwm=row.get("max_pwm_hz"),
            guide=row["guide"],
        )
        for key, row in data["models"].items()
    )
    rates = tuple(data["uart"]["baud_codes"])
    pwm = data["pwm"]
    return DeviceTable(
        models=models,
        baud_rates=rates,
        half_rates=tuple(rates[code] for code in data["uart"]["half_rate_bug_codes"]),
        half_rate_fixed_in=data["uart"]["half_rate_bug_before"],
        pwm=PwmClock(
            clock=pwm["clock_hz"],
            divisors=tuple(pwm["prescaler_divisor"]),
            scale=pwm["maximum_from_wire"]["scale"],
            offset=pwm["maximum_from_wire"]["offset"],
        ),
        rows=tuple(data["parameter"]),
    )


@cache
def version_key(version: str) -> tuple[int, ...]:
    """Return a sort key for a firmware version: `1.10` comes after `1.9`."""
    return tuple(int(part) if part.isdigit() else 0 for part in version.split("."))
