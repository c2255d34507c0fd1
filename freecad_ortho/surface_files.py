"""Design surfaces in files, and nets aligned on them."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from freecad_ortho.mesh_files import DEFAULT_UNIT
from freecad_ortho.sources.aligning import aligned_on, edge_for
from freecad_ortho.step_faces import is_step, step_surfaces, triangles_on
from freecad_ortho.triangles import read_triangles
from freecad_ortho.units import millimetres_per
from freecad_ortho.words import counted
from solver.align.align import Aligned, aligned
from solver.align.crosses import Singular
from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.mesh.sampling import ParametricSurface


@dataclass(frozen=True)
class Found:
    """A net on a surface.

    Attributes:
        net: about ``origin``.
        unit: of its coordinates.
        origin: local origin of the surface.
    """

    net: Aligned
    unit: str
    origin: LocalOrigin

    @property
    def words(self) -> str:
        """What there is to say of it beside its size."""
        irregular = counted(len(self.net.irregular), "irregular vertex", "irregular vertices")
        return f"{irregular}, mean edge {self.net.mesh.mean_edge:.4g} {self.unit}"

    def in_file(self, about: LocalOrigin) -> tuple[QuadMesh, str, list[FloatArray]]:
        """Mesh, unit and border, with coordinates measured from a point."""
        back = LocalOrigin(self.origin.shift - about.shift)
        border = [back.back(line) for line in self.net.border]
        return back.back_mesh(self.net.mesh), self.unit, border

    def singularities(self, about: LocalOrigin) -> list[list[float]]:
        """Rows of x, y, z, measured from a point, and how many lines meet there."""
        singular = self.net.singular
        places = LocalOrigin(self.origin.shift - about.shift).back(singular.places)
        pairs = zip(places.tolist(), singular.valences.tolist(), strict=True)
        return [[*place, lines] for place, lines in pairs]

    def numbers(self, about: LocalOrigin) -> dict[str, Any]:
        """The report, with coordinates measured from a point."""
        mesh, unit, border = self.in_file(about)
        return {
            "unit": unit,
            "faces": len(mesh.faces),
            "irregular_vertices": self.net.irregular.tolist(),
            "irregular_places": mesh.vertices[self.net.irregular].tolist(),
            "singularities": self.singularities(about),
            "mean_edge": mesh.mean_edge,
            "border": [line.tolist() for line in border],
            "remarks": list(self.net.remarks),
        }


@dataclass(frozen=True, eq=False)
class SurfaceFile:
    """A surface as a file has it: CAD faces, or triangles.

    Attributes:
        unit: of all lengths and coordinates that are asked for and given.
        faces: CAD faces in mm, where it has them.
        mesh: points (V, 3) in ``unit`` and triangles (T, 3), where it has these instead.
    """

    unit: str
    faces: Sequence[ParametricSurface] = ()
    mesh: tuple[FloatArray, IntArray] | None = None

    @classmethod
    def read(
        cls,
        path: str | os.PathLike[str],
        unit: str | None = None,
        up: str = "z",
        faces: Sequence[int] = (),
    ) -> SurfaceFile:
        """Read a surface.

        Args:
            path: a STEP file, or one of triangles or quads.
            unit: of triangles by default what the file says, else mm.
            up: ``z``, or ``y`` for a file of triangles whose y points up.
            faces: numbers of faces of a STEP file, from 1; by default all.

        Raises:
            InputError: no such file or faces, or nothing that is a surface.
        """
        if is_step(path):
            return cls(unit or "mm", step_surfaces(path, faces))
        points, triangles, named = read_triangles(path, up)
        return cls(unit or named or DEFAULT_UNIT, mesh=(points, triangles))

    @cached_property
    def triangles(self) -> tuple[FloatArray, IntArray]:
        """Points (V, 3) in ``unit`` and triangles (T, 3) of the surface, or on it.

        Raises:
            InputError: a face that cannot be sampled.
        """
        if self.mesh is not None:
            return self.mesh
        points, triangles = triangles_on(self.faces)
        return points / millimetres_per(self.unit), triangles

    def aligned(
        self,
        *,
        edge: float = 0.0,
        ratio: float = 1.0,
        strokes: Sequence[FloatArray] = (),
        singularities: Singular | None = None,
        waiting: Callable[[str], object] = lambda stage: None,
        **told: Any,
    ) -> Found:
        """Align a net, of about 600 faces where no edge length is given.

        Settings are those of :func:`solver.align.align.aligned`.

        Raises:
            InputError: as that.
        """
        if self.mesh is None:
            # In the unit of what is asked for, as whatever is said of places and lengths is too.
            factor = 1.0 / millimetres_per(self.unit)
            made = aligned_on(
                [face.scaled(factor) for face in self.faces],
                edge=edge,
                ratio=ratio,
                strokes=strokes,
                singularities=singularities,
                waiting=waiting,
                **told,
            )
            return Found(made, self.unit, LocalOrigin(np.zeros(3)))
        points, triangles = self.mesh
        origin = LocalOrigin.of(points)
        near = origin.near(points)
        one, two = (near[triangles[:, k]] - near[triangles[:, 0]] for k in (1, 2))
        area = 0.5 * float(np.linalg.norm(np.cross(one, two), axis=1).sum())
        if singularities is not None:
            singularities = replace(singularities, places=origin.near(singularities.places))
        try:
            made = aligned(
                *(near, triangles),
                edge=edge or edge_for(area, ratio),
                ratio=ratio,
                strokes=[origin.near(stroke) for stroke in strokes],
                singularities=singularities,
                waiting=waiting,
                **told,
            )
        except InputError as error:
            told_from = _told_from(origin, str(error))
            raise InputError(f"{error}; {told_from}" if told_from else str(error)) from None
        told_from = _told_from(origin, *made.remarks)
        remarks = (*made.remarks, told_from) if told_from else made.remarks
        return Found(replace(made, remarks=remarks), self.unit, origin)


def _told_from(origin: LocalOrigin, *words: str) -> str:
    """What places in some sentences are told from, where that is not the origin of the file."""
    if not origin.far or not any(" (" in word for word in words):
        return ""
    return "places are told from (" + ", ".join(f"{x:.12g}" for x in origin.shift) + ")"
