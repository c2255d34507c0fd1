"""The scale between a field's values and colours: its range, and the labels of the legend."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from freecad_ortho.view.colours import palette
from solver.analysis.fields import Field
from solver.mesh.quadmesh import FloatArray

_METRE = 1000.0  # mm
# Parts of the values that an automatic range leaves out at its open end, where few are huge.
_OUTLIERS = 0.02
_UNITS = {1: "mm", 0: "", -1: "1/m", -2: "1/m²"}


@dataclass(frozen=True)
class ColourScale:
    """A range of values from blue to red.

    Attributes:
        low: blue at and below this value, in the units of ``shown``.
        high: red at and above this value.
        decades: both are powers of ten, and the scale is logarithmic.
        signed: white at zero.
        unit: behind the numbers.
    """

    low: float
    high: float
    decades: bool = False
    signed: bool = False
    unit: str = ""

    @classmethod
    def of_decades(cls, lowest: int, highest: int) -> ColourScale:
        """The scale of a residual between two powers of ten."""
        return cls(float(lowest), float(max(highest, lowest + 1)), decades=True)

    @classmethod
    def automatic(cls, field: Field) -> ColourScale:
        """The scale that shows what there is."""
        values = shown(field)
        values = values[np.isfinite(values)]
        if not len(values):
            return cls.between(field, 0.0, 1.0)
        if field.signed:
            most = float(np.quantile(np.abs(values), 1 - _OUTLIERS)) or 1.0
            return cls.between(field, -most, most)
        low, high = float(values.min()), float(np.quantile(values, 1 - _OUTLIERS))
        return cls.between(field, low, high)

    @classmethod
    def between(cls, field: Field, low: float, high: float) -> ColourScale:
        """The scale between two values; a range without width is widened around the lower."""
        high = max(low, high)
        # Rounding alone must not be drawn as blue and red.
        least = 1e-6 * max(abs(low), abs(high)) or 1.0
        if high - low < least:
            low, high = low - least / 2, high + least / 2
        unit = field.unit or _UNITS[field.dimension]
        return cls(low, high, signed=field.signed, unit="°" if unit == "degrees" else unit)

    def fractions(self, values: FloatArray) -> FloatArray:
        """(N,) places on the scale, 0 at its blue and 1 at its red end, NaN where no value is."""
        if self.decades:
            with np.errstate(divide="ignore"):
                values = np.log10(values)
            values = np.where(np.isneginf(values), self.low, values)
        values = np.where(np.isposinf(values), self.high, values)
        return np.asarray((values - self.low) / (self.high - self.low))

    def colours(self, field: Field) -> FloatArray:
        """(N, 3) RGB of a field's values."""
        return palette(self.fractions(shown(field)), self.signed)

    def labels(self) -> list[tuple[float, str]]:
        """Places on the scale and what stands there."""
        if self.decades:
            decades = range(round(self.low), round(self.high) + 1)
            return [
                ((decade - self.low) / (self.high - self.low), _power_of_ten(decade))
                for decade in decades
            ]
        places = np.linspace(0.0, 1.0, 5)
        values = self.low + places * (self.high - self.low)
        digits = 2 - math.floor(math.log10(np.abs(values).max()))
        digits += max(0, math.ceil(math.log10(np.abs(values).max() / (self.high - self.low))))
        return [
            (float(place), self.text(round(float(value), digits) + 0.0))
            for place, value in zip(places, values, strict=True)
        ]

    def text(self, value: float) -> str:
        """A value with its unit."""
        if self.decades:
            return f"{value:.1e}"
        joint = "" if self.unit in ("", "°") else " "
        return f"{value:.7g}{joint}{self.unit}"


def shown(field: Field) -> FloatArray:
    """Values of a mesh in mm in the units of the scale: curvatures a metre, lengths in mm."""
    return field.values * (_METRE**-field.dimension if field.dimension < 0 else 1.0)


def _power_of_ten(exponent: int) -> str:
    return f"{10.0**exponent:g}" if abs(exponent) <= 2 else f"1e{exponent}"
