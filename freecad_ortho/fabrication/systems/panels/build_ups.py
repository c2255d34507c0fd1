"""Panels of a build-up: their bodies where layers stand back at the edges, and a list of layers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise

import numpy as np

from freecad_ortho.fabrication.bodies import Body, Divided, Loops, Polyhedron
from freecad_ortho.fabrication.build_up import MaterialLayer
from freecad_ortho.fabrication.material import Material
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.pattern import polygon_area
from freecad_ortho.fabrication.plate_bodies import Pierced, plate_body
from freecad_ortho.fabrication.systems.panels.geometry import inset
from freecad_ortho.fabrication.systems.system import Table
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, unit_rows

COLUMNS = (
    *("part", "layer", "kind", "of", "thickness_mm", "density_kg_m3", "step_mm"),
    *("length_mm", "width_mm", "area_mm2", "mass_kg"),
)


@dataclass(frozen=True, eq=False)
class BuiltUp:
    """A plate and its layers.

    Attributes:
        under: (N, 2) its lower outline, before layers are set back.
        over: (N, 2) its upper one, with sides parallel to those.
        thickness: mm.
        cutouts: openings.
        layers: the uppermost first; one for what is solid.
    """

    under: FloatArray
    over: FloatArray
    thickness: float
    cutouts: tuple[FloatArray, ...]
    layers: tuple[MaterialLayer, ...]

    @classmethod
    def of(
        cls,
        outlines: tuple[FloatArray, FloatArray],
        thickness: float,
        material: Material,
        name: str,
        cutouts: tuple[FloatArray, ...] = (),
    ) -> BuiltUp:
        """The layers of a panel of this material.

        Raises:
            InputError: layers that are set back so far that nothing is left of a side.
        """
        layers = material.layers or (
            MaterialLayer("plate", material.name, thickness, material.density),
        )
        made = cls(*outlines, thickness, cutouts, layers)
        deepest = max(layer.step for layer in layers)
        if deepest > 0:
            made._refuse_deep(deepest, name)
        return made

    def outlines(self, step: float, low: float, high: float) -> tuple[FloatArray, FloatArray]:
        """(N, 2) twice: at two levels, its sides set back by a step, mm."""
        rise = self.over - self.under
        rings = [self.under + level / self.thickness * rise for level in (low, high)]
        if step > 0:
            rings = [inset(ring[None], np.full((1, len(ring)), step))[0] for ring in rings]
        return rings[0], rings[1]

    def levels(self) -> list[tuple[float, float]]:
        """Lower and upper level of each layer, mm."""
        tops = self.thickness - np.cumsum([0.0, *(layer.thickness for layer in self.layers)])
        return [(low, high) for high, low in pairwise(tops.tolist())]

    @property
    def whole(self) -> Polyhedron:
        """The plate before layers are set back, without openings."""
        body = plate_body(self.under, self.over, self.thickness)
        assert isinstance(body, Polyhedron)
        return body

    def below(self, depth: float) -> FloatArray:
        """(N, 2) outline below the lowest layer, within it and, at a depth, within the joints."""
        step = self.layers[-1].step
        lowest, deep = self.outlines(step, 0.0, -depth)
        side = unit_rows(np.roll(lowest, -1, axis=0) - lowest)
        arms = deep - lowest
        within = np.maximum(side[:, 0] * arms[:, 1] - side[:, 1] * arms[:, 0], 0.0)
        return np.asarray(inset(lowest[None], within[None])[0])

    @property
    def above(self) -> FloatArray:
        """(N, 2) outline of the upper side of the uppermost layer."""
        return self.outlines(self.layers[0].step, 0.0, self.thickness)[1]

    @property
    def bends(self) -> bool:
        """Whether it is a plain plate with four corners."""
        plain = not self.cutouts and max(layer.step for layer in self.layers) == 0
        return plain and len(self.under) == 4

    def body(self) -> Body:
        """The solid of all layers that stand on each other."""
        whole: Polyhedron = self.whole
        runs = self._runs()
        if len(runs) > 1:
            whole = _stepped([(*self.outlines(*run), *run[1:]) for run in runs])
        return Pierced(whole, self.cutouts, self.thickness) if self.cutouts else whole

    def _runs(self) -> list[tuple[float, float, float]]:
        """Step, lower and upper level of layers of one size that lie on each other, lowest first.

        The outermost levels are those of the plate, to the last digit.
        """
        pairs = list(zip(self.layers, self.levels(), strict=True))[::-1]
        runs = []
        for step, some in groupby(pairs, key=lambda pair: pair[0].step):
            levels = [level for _, each in some for level in each]
            runs.append((step, min(levels), max(levels)))
        step, _, high = runs[0]
        runs[0] = (step, 0.0, high)
        return runs

    def volumes(self) -> list[float]:
        """Of each layer, mm3."""
        openings = sum(abs(polygon_area(cutout)) for cutout in self.cutouts)
        found = []
        for layer, (low, high) in zip(self.layers, self.levels(), strict=True):
            under, over = self.outlines(layer.step, low, high)
            both = polygon_area((under + over) / 2)
            # The rule of Simpson is exact where outlines grow evenly.
            area = (polygon_area(under) + 4 * both + polygon_area(over)) / 6
            found.append((area - openings) * (high - low))
        return found

    def weighed(self, density: float) -> float:
        """Volume of this density that weighs what the layers do, mm3."""
        volumes = zip(self.layers, self.volumes(), strict=True)
        return sum(layer.density * volume for layer, volume in volumes) / density

    def rows(self, name: str) -> list[tuple[object, ...]]:
        """One row a layer, for the list of them."""
        made: list[tuple[object, ...]] = []
        volumes = self.volumes()
        for number, (layer, levels) in enumerate(zip(self.layers, self.levels(), strict=True)):
            under, over = self.outlines(layer.step, *levels)
            larger = max(under, over, key=polygon_area)
            length, width = np.ptp(larger, axis=0).tolist()
            area = polygon_area(larger) - sum(abs(polygon_area(hole)) for hole in self.cutouts)
            made.append(
                (
                    *(name, number + 1, layer.kind, layer.of, f"{layer.thickness:g}"),
                    *(f"{layer.density:g}", f"{layer.step:g}", f"{length:.6f}", f"{width:.6f}"),
                    *(f"{area:.6f}", f"{volumes[number] * 1e-9 * layer.density:.6f}"),
                )
            )
        return made

    def _refuse_deep(self, step: float, name: str) -> None:
        for ring in (self.under, self.over):
            side = np.roll(ring, -1, axis=0) - ring
            smaller = inset(ring[None], np.full((1, len(ring)), step))[0]
            left = np.roll(smaller, -1, axis=0) - smaller
            if (np.einsum("nd,nd->n", left, side) <= 0).any():
                raise InputError(
                    f"panels: layers set back by {step:g} mm leave nothing of a side of {name}; "
                    "take a smaller step, or leave such pieces out by a larger least width"
                )


def _stepped(blocks: Sequence[tuple[FloatArray, FloatArray, float, float]]) -> Divided:
    """Plates that stand on each other, the lowest first; each step between them is plane.

    Args:
        blocks: lower and upper outline (N, 2), lower and upper level, mm.
    """
    count = len(blocks[0][0])
    rings = [
        np.column_stack([ring, np.full(count, level)])
        for under, over, low, high in blocks
        for ring, level in ((under, low), (over, high))
    ]
    loops: Loops = (
        tuple(range((len(rings) - 1) * count, len(rings) * count)),
        tuple(reversed(range(count))),
        *(
            (low + k, low + (k + 1) % count, high + (k + 1) % count, high + k)
            for low, high in pairwise(range(0, len(rings) * count, count))
            for k in range(count)
        ),
    )
    pieces = [
        Polyhedron(piece.corners + [0.0, 0.0, low], piece.loops)
        for under, over, low, high in blocks
        for piece in plate_body(under, over, high - low).pieces()
    ]
    return Divided(np.concatenate(rings), loops, tuple(pieces))


def layers_table(names: Sequence[str], plates: Sequence[BuiltUp]) -> Table:
    """The list of the layers of panels with these names."""
    pairs = zip(names, plates, strict=True)
    rows = [row for name, built_up in pairs for row in built_up.rows(name)]
    return Table("layers.csv", COLUMNS, tuple(rows))


def build_up_report(material: Material, parts: Sequence[Part]) -> dict[str, object]:
    """What a report says of a build-up."""
    return {
        "build_up": {
            "name": material.name,
            "thickness_mm": material.thickness,
            "weight_kg_m2": sum(layer.weight for layer in material.layers),
            "heaviest_kg": max(part.mass for part in parts),
            "layers": [
                {
                    "kind": layer.kind,
                    "of": layer.of,
                    "thickness_mm": layer.thickness,
                    "density_kg_m3": layer.density,
                    "step_mm": layer.step,
                }
                for layer in material.layers
            ],
        }
    }
