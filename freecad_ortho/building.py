"""From a design surface to the files of its parts: one call, kept stage by stage in a folder."""

from __future__ import annotations

import inspect
import json
import os
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass, fields, is_dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from freecad_ortho import __version__
from freecad_ortho.fabricating import fabricate, write_fabrication
from freecad_ortho.fabrication import Limits, Workshop, materials_of, systems_of
from freecad_ortho.fabrication.files import REPORT
from freecad_ortho.fabrication.report.way import Stage, StagesBefore
from freecad_ortho.keywords import Sizes, WorkshopSettings
from freecad_ortho.mesh_files import ReadMesh, read_mesh
from freecad_ortho.stages import ALIGN, FABRICATE, OPTIMISE, Stages, digest, key_of
from freecad_ortho.surface_files import Found, SurfaceFile
from freecad_ortho.units import millimetres_per
from freecad_ortho.words import counted
from solver import Constraints, NetOptions, Outcome, optimise, write_mesh
from solver.align.crosses import Singular
from solver.align.symmetry import coordinate_planes
from solver.analysis.form_check import Finding, check_form
from solver.errors import InputError
from solver.io.atomic import no_new_folders_on_failure
from solver.io.json_mesh import write_json
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nets import NETS, net_named
from solver.report import CONVERGED

if TYPE_CHECKING:
    # Of the standard library from Python 3.11 on.
    from typing_extensions import Unpack

# Nets that have lines on a surface, and as what these are found.
LINES = {name: net.lines for name, net in NETS.items() if net.lines}
ALIGNED, NET = "aligned.json", "net.json"


@dataclass(frozen=True)
class BuiltSurface:
    """What became of a surface.

    Attributes:
        aligned: the net on the surface.
        net: the exact net.
        form: what it was held against before parts were made of it.
        exact: whether it is exact.
        parts: whether there are parts: where the net is not exact, or a finding is not met, only if
            they were wanted all the same.
        report: all that ``report.json`` tells.
    """

    aligned: ReadMesh
    net: ReadMesh
    form: tuple[Finding, ...]
    exact: bool
    parts: bool
    report: dict[str, Any]


def build_surface(
    surface: str | os.PathLike[str],
    folder: str | os.PathLike[str],
    system: str = "beams+panels",
    *,
    net: str = "principal",
    edge: float = 0.0,
    ratio: float = 1.0,
    border: str = "trim",
    stands_on: str = "boundary",
    strokes: Sequence[FloatArray] = (),
    singularities: Singular | None = None,
    symmetry: str = "none",
    unit: str | None = None,
    up: str = "z",
    faces: Sequence[int] = (),
    within: float | None = None,
    options: NetOptions | None = None,
    material: str = "steel",
    limits: Limits | None = None,
    workshop: WorkshopSettings | None = None,
    go_on: bool = False,
    again: bool = False,
    progress: Callable[[str], object] = lambda stage: None,
    **sizes: Unpack[Sizes],
) -> BuiltSurface:
    """Align a net on a surface, make it exact near to it, check its form, make parts and files.

    The folder holds the files and the report that the command ``build`` writes. A stage that is
    there already, made from the same surface and settings by a call like this, is not made again.

    Args:
        surface: a STEP file, or one of triangles or quads.
        folder: made when missing; other files in it stay.
        system: names of systems joined by "+".
        net: what the net becomes, one of :data:`LINES`.
        edge: wanted edge length, by default for about 600 faces.
        ratio: edge length of the other family of lines over that.
        border: ``trim`` lets the net overhang, ``follow`` bends it to the border.
        stands_on: ``boundary`` or ``corners``: what carries the shell that a stress net follows.
        strokes: polylines (n, 3) on the surface along which lines of the net run.
        singularities: where the net has irregular vertices; the fewest that it needs by default.
        symmetry: ``auto`` or ``x``, ``y``, ``z``, ``x,y``: planes in which it is its mirror image.
        unit: of the surface, and of all lengths above; by default what the file says, else mm.
        up: ``z``, or ``y`` for a file of triangles whose y points up.
        faces: numbers of faces of a STEP file, from 1; by default all.
        within: how far from the surface the net may be, in ``unit``; by default 1 % of its size.
        options: of the net.
        material: as for ``fabricate``.
        limits: what the parts are held against.
        workshop: what they are cut from, as for ``write_fabrication``, mm.
        go_on: make parts even where the form check fails.
        again: make every stage anew.
        progress: called with the name of each stage as it begins; may raise to stop.
        sizes: of the systems, in mm, as for ``fabricate``.

    Raises:
        InputError: a file, a setting or a surface that cannot be used.
        OutputError: the folder cannot be written.
    """
    # What no surface is needed for is refused before minutes are spent on one.
    lines = lines_of(net)
    systems_of(system, sizes, materials_of(material, system.split("+"), None))
    Workshop.of(workshop or {})
    lying: dict[str, Any] = {"edge": edge, "ratio": ratio, "border": border, "stands_on": stands_on}
    lying |= {"strokes": strokes, "singularities": singularities, "symmetry": symmetry}
    asked: dict[str, dict[str, Any]] = {
        ALIGN: {"unit": unit, "up": up, "faces": faces} | lying,
        OPTIMISE: {"net": net, "within": within, "options": options},
        FABRICATE: {"system": system, "material": material, "limits": limits}
        | {"workshop": workshop, **sizes},
    }
    stages = Stages(
        Path(folder),
        _keys(asked, surface, lines),
        {"surface": Path(surface).name, "version": __version__},
        again,
    )
    read = SurfaceFile.read(surface, unit, up, faces)

    def align() -> None:
        with no_new_folders_on_failure(stages.folder), kept(ALIGN) as (staging, entry):
            keep_aligned(read.aligned(net=lines, **lying), staging, entry)

    def make_exact() -> None:
        aligned = read_mesh(stages.folder / ALIGNED)
        planes = mirror_planes(aligned.mesh, symmetry)
        near = Constraints(close_to=read.triangles, symmetry=planes)
        with kept(OPTIMISE) as (staging, entry):
            outcome = optimise(aligned.mesh, net, constraints=near, within=within, options=options)
            keep_outcome_of(aligned, outcome, staging, entry)

    def make_parts() -> None:
        begin, read = time.monotonic(), read_mesh(stages.folder / NET)
        parts = fabricate(
            read.mesh,
            system,
            unit=read.unit,
            material=material,
            limits=limits,
            border=read.border,
            **sizes,
        )
        project, way = Path(surface).stem, way_of(stages)
        write_fabrication(parts, folder, project=project, way=way, **(workshop or {}))
        entry = {"words": counted(len(parts.parts), "part"), **_told(asked[FABRICATE], begin)}
        stages.enter(FABRICATE, entry, _report(stages)["files"])

    @contextmanager
    def kept(name: str) -> Iterator[tuple[Path, dict[str, Any]]]:
        begin = time.monotonic()
        with stages.made(name) as (staging, entry):
            yield staging, entry
            entry |= _told(asked[name], begin)

    for name, make in ((ALIGN, align), (OPTIMISE, make_exact), (FABRICATE, make_parts)):
        if stages.entry(name) is None and (name != FABRICATE or go_on or not failures(stages)):
            progress(name)
            make()
    return _built(stages)


def _told(asked: Mapping[str, Any], begin: float) -> dict[str, Any]:
    """What the report tells of a stage: settings that are not the usual ones, and its seconds."""
    usual = inspect.signature(build_surface).parameters
    settings = {
        name: _plain(value)
        for name, value in asked.items()
        if name not in usual or _plain(value) != _plain(usual[name].default)
    }
    return {"settings": settings, "seconds": round(time.monotonic() - begin, 3)}


def _plain(value: Any) -> Any:
    """A value as a report can hold it."""
    if is_dataclass(value) and not isinstance(value, type):
        return {field.name: _plain(getattr(value, field.name)) for field in fields(value)}
    if isinstance(value, Mapping):
        return {str(name): _plain(one) for name, one in value.items()}
    if isinstance(value, QuadMesh):
        return [value.vertices.tolist(), value.connectivity.polygons]
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [_plain(one) for one in value]
    return value if value is None or isinstance(value, str | int | float) else str(value)


def _keys(
    asked: Mapping[str, Mapping[str, Any]], surface: str | os.PathLike[str], lines: str
) -> dict[str, str]:
    """Keys of the stages; each is made from the one before it."""
    keys: dict[str, str] = {}
    key = key_of(digest(os.fspath(surface)), lines)
    for name, settings in asked.items():
        key = keys[name] = key_of(key, _plain(settings))
    return keys


def _report(stages: Stages) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((stages.folder / REPORT).read_text(encoding="utf-8"))
    return found


def _built(stages: Stages) -> BuiltSurface:
    aligned, net = (read_mesh(stages.folder / name) for name in (ALIGNED, NET))
    return BuiltSurface(
        aligned,
        net,
        tuple(findings_of(stages)),
        is_exact(stages),
        stages.entry(FABRICATE) is not None,
        _report(stages),
    )


def mirror_planes(aligned: QuadMesh, symmetry: str | None) -> str:
    """Letters of the planes through 0 in which a net stays symmetric, where that was asked for."""
    return "" if symmetry in (None, "none") else coordinate_planes(aligned)


def lines_of(net: str) -> str:
    """The lines that a net starts from.

    Raises:
        InputError: a net that has none on a surface.
    """
    asked = net_named(net)
    if asked.name not in LINES:
        raise InputError(
            f"net: a surface has no lines for {asked.name} nets; build makes {', '.join(LINES)}"
        )
    return LINES[asked.name]


def keep_aligned(found: Found, folder: Path, entry: dict[str, Any]) -> None:
    """Write the files of a net on its surface, and what the report tells of it."""
    keep = LocalOrigin(0.0 * found.origin.shift)
    mesh, unit, border = found.in_file(keep)
    write_json(folder / ALIGNED, mesh, unit, border)
    write_mesh((folder / ALIGNED).with_suffix(".obj"), mesh, unit)
    numbers = found.numbers(keep)
    # The border is in the file of the net.
    del numbers["border"]
    entry |= {"words": f"{counted(len(mesh.faces), 'quad')}, {found.words}", "numbers": numbers}


def keep_outcome_of(
    aligned: ReadMesh, outcome: Outcome, folder: Path, entry: dict[str, Any]
) -> None:
    """Write the files of an exact net, in the coordinates of ``aligned``, and tell of its form."""
    mesh, report = outcome.mesh, outcome.report
    write_json(folder / NET, mesh, aligned.unit, aligned.border)
    write_mesh((folder / NET).with_suffix(".obj"), mesh, aligned.unit)
    findings = check_form(
        aligned.mesh, mesh, report.form, report.within, overhangs=bool(aligned.border)
    )
    entry |= {
        "words": report.message,
        "numbers": report.as_dict(),
        "exact": report.status == CONVERGED,
        "form": [asdict(finding) for finding in findings],
        "unit": aligned.unit,
    }


def findings_of(stages: Stages) -> list[Finding]:
    """What the form of the net was held against."""
    return [Finding(**told) for told in (stages.entry(OPTIMISE) or {})["form"]]


def is_exact(stages: Stages) -> bool:
    """Whether the net is exact."""
    return bool((stages.entry(OPTIMISE) or {})["exact"])


def failures(stages: Stages) -> list[str]:
    """Why the net is not fit to be built; nothing where it is."""
    if not is_exact(stages):
        return ["the net is not exact"]
    return [finding.measure for finding in findings_of(stages) if not finding.met]


def measured(finding: Finding, unit: str) -> str:
    """A measure of form in words."""
    if finding.measure == "folded faces":
        return counted(int(finding.value), "folded face") if finding.value else "no folded faces"
    if finding.measure in ("off the surface", "off the border"):
        return f"{finding.value * millimetres_per(unit):,.3g} mm {finding.measure} at most"
    of_start = " of the start's" * (finding.measure == "shortest edge")
    return f"{finding.measure} {finding.value:.2f}{of_start}"


def form_words(stages: Stages) -> str:
    """All measures of form in words."""
    unit = (stages.entry(OPTIMISE) or {})["unit"]
    return ", ".join(measured(finding, unit) for finding in findings_of(stages))


def way_of(stages: Stages) -> StagesBefore:
    """The stages before the parts, for the reports."""
    align, optimised = (stages.entry(name) or {} for name in (ALIGN, OPTIMISE))
    failed = failures(stages)
    return StagesBefore(
        [
            Stage(ALIGN, _words_of(align["settings"]), align["words"]),
            Stage(OPTIMISE, _words_of(optimised["settings"]), optimised["words"]),
            Stage(
                "form check",
                f"fails: {', '.join(failed)}" if failed else "holds",
                form_words(stages),
            ),
        ],
        stages.numbers(),
    )


def _words_of(settings: dict[str, Any]) -> str:
    return ", ".join(f"{name.replace('_', ' ')} {value}" for name, value in settings.items())
