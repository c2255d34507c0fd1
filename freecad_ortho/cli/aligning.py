"""The command ``align``: a net along a design surface's lines of curvature."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from freecad_ortho.cli import options as arguments
from freecad_ortho.cli import reporting, values
from freecad_ortho.mesh_files import DEFAULT_UNIT, upright
from freecad_ortho.sources.aligning import ALIGNED, aligned_on, edge_for
from freecad_ortho.sources.source import singular
from freecad_ortho.step_faces import is_step, step_surfaces
from freecad_ortho.triangles import read_triangles
from freecad_ortho.units import millimetres_per
from freecad_ortho.words import counted
from solver.align.align import Aligned, aligned
from solver.align.crosses import Singular
from solver.io.atomic import write_text
from solver.io.points import read_points
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import FloatArray, QuadMesh

# Strokes are files here.
_SETTINGS = tuple(option for option in ALIGNED.options if option.kind != "polylines")

Waiting = Callable[[str], None]


def add(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.description = (
        "Quads along the lines that an exact net has on a surface: curvature lines for principal "
        "and developable, lines at 45 degrees to them for asymptotic and cmc. The net overhangs "
        "the border by up to a face, unless it follows it; optimise it with --close-to the same "
        "surface."
    )
    parser.add_argument("input", metavar="SURFACE.stl|obj|ply|off|glb|step")
    values.add_up(parser)
    arguments.add(parser, ALIGNED.option("net"))
    add_settings(parser)
    parser.add_argument("--report", metavar="R.json", help="border, singular vertices, remarks")
    parser.add_argument(
        "--save-singularities",
        metavar="FILE",
        help="write where other than four lines meet, as --singularities reads it",
    )
    values.add_output(parser)
    parser.add_argument("-v", "--verbose", action="store_true", help="say what is being done")
    parser.set_defaults(run=run)


def add_settings(group: argparse._ActionsContainer) -> None:
    """Options that say how a net lies on its surface."""
    for option in _SETTINGS:
        if option.name != "net":
            arguments.add(group, option)
    group.add_argument(
        "--stroke",
        action="append",
        default=[],
        metavar="FILE",
        help="points of a curve along which the net runs; may be repeated",
    )
    group.add_argument("--faces", metavar="I,J,K", help="of a STEP file, from 1 (default: all)")


def run(options: argparse.Namespace) -> int:
    """Align and write."""
    values.refuse_unwritable(options.output, options.report, options.save_singularities)
    found = align(options)
    code = values.write(
        options, found.net.mesh, found.unit, found.words, found.origin, found.net.border
    )
    about = values.origin_of(options, found.origin)
    if options.report:
        write_text(options.report, json.dumps(found.numbers(about), indent=2) + "\n")
    if options.save_singularities:
        rows = [" ".join(f"{x!r}" for x in row) for row in found.singularities(about)]
        head = f"# x y z in {found.unit}, lines that meet there\n"
        write_text(options.save_singularities, head + "".join(f"{row}\n" for row in rows))
    return code


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


def align(options: argparse.Namespace) -> Found:
    """Align as the options say; what is out of the ordinary is said on stderr."""
    on = _on_step if is_step(options.input) else _on_triangles
    with reporting.Progress(options.verbose) as progress:
        found = Found(*on(options, _follower(progress)))
    for remark in found.net.remarks:
        sys.stderr.write(f"note: {remark}\n")
    return found


def _follower(progress: reporting.Progress) -> Waiting:
    """Turn the names of steps into how far the work is; each is said once."""
    said: set[str] = set()

    def follow(step: str) -> None:
        if step not in said:
            said.add(step)
            progress(ALIGNED.stages.index(step) / len(ALIGNED.stages), step)

    return follow


def _on_step(options: argparse.Namespace, waiting: Waiting) -> tuple[Aligned, str, LocalOrigin]:
    unit = options.unit or "mm"
    numbers = values.whole_numbers("--faces", options.faces) if options.faces else ()
    told = _told(options, "mm", unit)
    scale = 1.0 / millimetres_per(unit)
    told["singularities"] = _singularities(told, options, lambda places: places / scale)
    strokes = [stroke / scale for stroke in _strokes(options)]
    surfaces = step_surfaces(options.input, numbers)
    made = aligned_on(surfaces, **told, strokes=strokes, waiting=waiting)
    return made.scaled(scale), unit, LocalOrigin(np.zeros(3))


def _on_triangles(
    options: argparse.Namespace, waiting: Waiting
) -> tuple[Aligned, str, LocalOrigin]:
    vertices, triangles, named = read_triangles(options.input, options.up)
    unit = options.unit or named or DEFAULT_UNIT
    told = _told(options, unit, unit)
    origin = LocalOrigin.of(vertices)
    near = origin.near(vertices)
    one, two = (near[triangles[:, k]] - near[triangles[:, 0]] for k in (1, 2))
    area = 0.5 * float(np.linalg.norm(np.cross(one, two), axis=1).sum())
    told["edge"] = told["edge"] or edge_for(area, told["ratio"])
    strokes = [origin.near(stroke) for stroke in _strokes(options)]
    told["singularities"] = _singularities(told, options, origin.near)
    made = aligned(near, triangles, **told, strokes=strokes, waiting=waiting)
    return made, unit, origin


def _told(options: argparse.Namespace, unit: str, bare: str) -> dict[str, Any]:
    """Settings by name, those that were not given as they usually are."""
    usual = {option.name: option.default for option in _SETTINGS}
    return usual | arguments.given(_SETTINGS, options, unit, bare=bare)


def _singularities(
    told: dict[str, Any], options: argparse.Namespace, placed: Callable[[FloatArray], FloatArray]
) -> Singular | None:
    """Where they are asked for; nothing where they are to be found."""
    if told["singularities"] is None:
        return None
    given = singular("--singularities", told["singularities"])
    return Singular(placed(upright(given.places, options.up)), given.valences)


def _strokes(options: argparse.Namespace) -> list[FloatArray]:
    """Points of the curves, in the unit of the surface."""
    return [upright(read_points(path), options.up) for path in options.stroke]
