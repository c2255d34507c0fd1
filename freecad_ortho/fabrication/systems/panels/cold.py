"""Cold-bent panels: flat plates that are pressed into faces that are not plane.

The plate becomes the hyperbolic paraboloid through the corners of the face. With w the height above
its plane, u and v along the sides, a pane of thickness t that bends by itself carries

    sigma_i = E t / (2 (1 - nu^2)) (kappa_i + nu kappa_j),

kappa_1 and kappa_2 the principal curvatures: of a rectangle a x b whose fourth corner is h off the
plane of the others +-h / (a b), sigma = G t h / (a b). Its corners are held down by
F = 2 D (1 - nu) kappa_uv, D = E t^3 / (12 (1 - nu^2)).

Sources: Timoshenko, Woinowsky-Krieger (1959), Theory of plates and shells, sections 9 to 11; Staaks
(2003), Koud getordeerde glaspanelen in blobs: the form holds up to h = 16.8 t, beyond that a plate
bends along one of its diagonals; Galuppi, Massimiani, Royer-Carfagni (2014), Buckling phenomena in
double curved cold-bent glass.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.fabrication.build_up import STRENGTHS, panes_of
from freecad_ortho.fabrication.material import Material
from freecad_ortho.fabrication.part import Measures, Part
from freecad_ortho.fabrication.ruled import RuledBody
from freecad_ortho.fabrication.systems.panels.planes import Planes
from freecad_ortho.fabrication.systems.system import Table
from solver.mesh.quadmesh import FloatArray, QuadMesh

# Displacement of a corner, in thicknesses, up to which the form holds (Staaks).
_HOLDS = 16.8
# EN 16612: share of the strength of float glass that is left under what lasts, and safety factors
# on that and on what tempering adds.
_LASTING, _ON_FLOAT, _ON_TEMPERING = 0.29, 1.8, 1.2
# Half of what may last is left for loads.
_SHARE = 0.5
# Newton's steps to where a point is in a face.
_STEPS = 8
# Places in a face, u and v, where curvatures are looked up.
_PLACES = np.array([[0.5, 0.5], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
_RING = ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
COLUMNS = ("panel", "warp_mm", "allowed_mm", "stress_MPa", "use_percent", "corner_N")


def lasting_strength(material: str, limit: float) -> float:
    """Stress that cold bending may leave in a plate, MPa.

    Of glass half of its design strength under what lasts, EN 16612, of others half of the limit.
    """
    if material not in STRENGTHS:
        return _SHARE * limit
    float_glass = STRENGTHS["glass"]
    tempering = (STRENGTHS[material] - float_glass) / _ON_TEMPERING
    return _SHARE * (_LASTING * float_glass / _ON_FLOAT + tempering)


@dataclass(frozen=True, eq=False)
class ColdBent:
    """Faces as plates are bent into them, one row a face.

    Attributes:
        planes: their planes.
        heights: (F, 4) of the corners above these, mm.
        warp: (F,) how far the fourth corner is off the plane of the others, mm.
        curvature: (F, 5, 2) principal ones at ``_PLACES``, 1/mm.
    """

    planes: Planes
    heights: FloatArray
    warp: FloatArray
    curvature: FloatArray

    @classmethod
    def of(cls, planes: Planes, mesh: QuadMesh) -> ColdBent:
        """The faces of a mesh, with the planes that are theirs."""
        corners, normal = mesh.vertices[mesh.faces], planes.frame[:, 2]
        heights = np.einsum("fck,fk->fc", corners - planes.middle[:, None], normal)
        a, b, c, d = np.moveaxis(corners, 1, 0)
        mixed = np.einsum("fk,fk->f", a - b + c - d, normal)
        return cls(planes, heights, np.abs(mixed), _principal(corners, mixed))

    @property
    def bow(self) -> FloatArray:
        """(F,) how far panels bow from their planes, mm."""
        return np.asarray(np.abs(self.heights).max(axis=1))

    def use(self, material: Material, thickness: float) -> tuple[FloatArray, FloatArray]:
        """(F,) twice: largest stress, MPa, and what plates are used to by it or by their form."""
        stress = np.zeros(len(self.warp))
        use = np.zeros(len(self.warp))
        both = self.curvature + material.poisson * self.curvature[..., ::-1]
        for own, of in _plates(material, thickness):
            factor = material.youngs_modulus * own / (2 * (1 - material.poisson**2))
            found = factor * np.abs(both).max(axis=(1, 2))
            allowed = lasting_strength(of, material.bending_limit)
            stress = np.maximum(stress, found)
            use = np.maximum(use, np.maximum(found / allowed, self.warp / (_HOLDS * own)))
        return stress, use

    def measured(
        self, measures: Sequence[Measures], material: Material, thickness: float
    ) -> list[Measures]:
        """Measures of panels that are bent in place of best planes."""
        stress, use = self.use(material, thickness)
        return [
            replace(
                each,
                gap_mm=None,
                warp_mm=float(self.warp[face]),
                cold_MPa=float(stress[face]),
                bend_use_percent=100 * float(use[face]),
            )
            for face, each in enumerate(measures)
        ]

    def table(self, panels: Sequence[Part]) -> Table:
        """The list of bent panels: warp, what would be allowed, stress and force at the corners."""
        rows = []
        for panel in panels:
            measures, material = panel.measures, panel.material
            warp, use = measures.warp_mm or 0.0, (measures.bend_use_percent or 0.0) / 100
            twist = float(np.abs(self.curvature[panel.face, 0]).max())
            stiff = sum(own**3 for own, _ in _plates(material, panel.thickness))
            force = material.youngs_modulus * stiff / (6 * (1 + material.poisson)) * twist
            rows.append(
                (
                    *(panel.name, f"{warp:.3f}", f"{warp / use:.1f}" if use else ""),
                    *(f"{measures.cold_MPa or 0.0:.3f}", f"{100 * use:.1f}", f"{force:.1f}"),
                )
            )
        return Table("cold-bending.csv", COLUMNS, tuple(rows))

    def body(self, face: int, outline: FloatArray, low: FloatArray, thickness: float) -> RuledBody:
        """The bent plate over an outline (4, 2) in the plane of its face.

        Args:
            face: its number.
            outline: its corners, measured from ``low``.
            low: (2,) where the panel's coordinates begin in the plane, mm.
            thickness: mm.
        """
        rise = self._raised(face, outline + low)
        ring = np.column_stack([outline, rise])
        corners = np.concatenate([ring, ring + [0.0, 0.0, thickness]])
        sides = ((3, 2, 1, 0), (4, 5, 6, 7), *_RING)
        return RuledBody(corners, sides, blocks=(corners,), cells=True)

    def _raised(self, face: int, points: FloatArray) -> FloatArray:
        """(N,) heights of the bent face at points (N, 2) of its plane."""
        flat, height = self.planes.flat[face], self.heights[face]
        place = np.full((len(points), 2), 0.5)
        for _ in range(_STEPS):
            weights, slopes = _bilinear(place)
            jacobian = np.moveaxis(slopes @ flat, 0, 2)
            missed = points - weights @ flat
            place = place + np.linalg.solve(jacobian, missed[..., None])[..., 0]
        return np.asarray(_bilinear(place)[0] @ height)


def bending_report(panels: Sequence[Part]) -> dict[str, object]:
    """What a report says of panels that are bent."""
    worst = max(panels, key=lambda panel: panel.measures.bend_use_percent or 0.0)
    return {
        "cold_bending": {
            "warp_max_mm": max(panel.measures.warp_mm or 0.0 for panel in panels),
            "stress_max_MPa": max(panel.measures.cold_MPa or 0.0 for panel in panels),
            "use_max_percent": worst.measures.bend_use_percent,
            "worst": worst.name,
        }
    }


def unbent(corners: FloatArray) -> FloatArray:
    """(4, 2) the flat quad that is bent into corners (4, 3): its sides have their lengths.

    What both diagonals miss is least.
    """
    ends = np.array([[0, 1], [1, 2], [2, 3], [3, 0], [0, 2], [1, 3]])
    *sides, first, second = np.linalg.norm(corners[ends[:, 1]] - corners[ends[:, 0]], axis=1)
    step, diagonal = 1e-4 * first, first
    for _ in range(_STEPS):
        less, here, more = (
            _other_diagonal(sides, diagonal + change) for change in (-step, 0.0, step)
        )
        slope = (more - less) / (2 * step)
        missed = diagonal - first + slope * (here - second)
        diagonal -= missed / (1 + slope**2)
    return _laid_out(sides, diagonal)


def _other_diagonal(sides: Sequence[float], diagonal: float) -> float:
    flat = _laid_out(sides, diagonal)
    return float(np.linalg.norm(flat[3] - flat[1]))


def _laid_out(sides: Sequence[float], diagonal: float) -> FloatArray:
    """(4, 2) a quad with these sides and its first diagonal, the first side along x."""
    a, b, c, d = sides
    at_first = np.arccos((a**2 + diagonal**2 - b**2) / (2 * a * diagonal))
    beyond = np.arccos((d**2 + diagonal**2 - c**2) / (2 * d * diagonal))
    angles = np.array([0.0, at_first, at_first + beyond])
    lengths = np.array([a, diagonal, d])
    arms = lengths[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])
    return np.concatenate([np.zeros((1, 2)), arms])


def _plates(material: Material, thickness: float) -> list[tuple[float, str]]:
    """Thickness and glass of each pane, or of what is solid."""
    panes = panes_of(material.layers)
    return [(pane.thickness, pane.of) for pane in panes] or [(thickness, material.name)]


def _principal(corners: FloatArray, mixed: FloatArray) -> FloatArray:
    """(F, 5, 2) principal curvatures of bilinear surfaces at ``_PLACES``.

    With L = N = 0: H = -F M / (E G - F2), K = -M2 / (E G - F2).
    """
    a, b, c, d = (corner[:, None] for corner in np.moveaxis(corners, 1, 0))
    u, v = _PLACES[:, :1], _PLACES[:, 1:]
    along = (1 - v) * (b - a) + v * (c - d)
    across = (1 - u) * (d - a) + u * (c - b)
    first, both, second = (
        np.einsum("fpk,fpk->fp", one, other)
        for one, other in ((along, along), (along, across), (across, across))
    )
    area = first * second - both**2
    mean = -both * mixed[:, None] / area
    root = np.sqrt(mean**2 + mixed[:, None] ** 2 / area)
    return np.stack([mean + root, mean - root], axis=-1)


def _bilinear(place: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Weights (N, 4) of the corners at places (N, 2), and their slopes (2, N, 4)."""
    u, v = place.T
    weights = np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v], axis=1)
    by_u = np.stack([v - 1, 1 - v, v, -v], axis=1)
    by_v = np.stack([u - 1, -u, u, 1 - u], axis=1)
    return weights, np.stack([by_u, by_v])
