"""Measures the structural check beside PyNiteFEA and CalculiX: what is off, seconds, memory.

Run with the project's Python:  python scripts/bench_frame.py [--write]

Each row runs in a process of its own, so that peak memory is its own. PyNiteFEA and CalculiX's
``ccx`` are asked where they are installed; their rows are left out elsewhere. ``--write`` puts the
table into docs/benchmarks.md.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from importlib.util import find_spec
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from freecad_ortho import api  # noqa: E402
from freecad_ortho.structural.calculix import input_file  # noqa: E402
from freecad_ortho.structural.check import check_model  # noqa: E402
from freecad_ortho.structural.combinations import usual  # noqa: E402
from freecad_ortho.structural.design import Design  # noqa: E402
from freecad_ortho.structural.model import Model, model_of  # noqa: E402
from solver.frame.model import Frame, Loads, Supports  # noqa: E402
from solver.frame.response import response  # noqa: E402
from solver.frame.system import FrameSystem  # noqa: E402
from solver.mesh.primitives import primitive  # noqa: E402
from solver.mesh.quadmesh import FloatArray, QuadMesh  # noqa: E402
from tests.solver.frame import frames  # noqa: E402

ENGINES = ("own", "PyNiteFEA", "CalculiX")
# Alike about all axes, so that no program's way to turn sections counts.
SECTION = "chs:88.9x5"
LENGTH, FORCE, RADIUS = 3000.0, 1000.0, 2000.0
# Members from which on other programs take minutes and longer.
_MOST = 5000


@dataclass(frozen=True)
class Case:
    """A frame under one load.

    Attributes:
        frame: of members.
        supports: of its nodes.
        loads: on it.
        known: largest displacement by a closed form, None where there is none.
        model: that the frame is of, for CalculiX.
    """

    frame: Frame
    supports: Supports
    loads: Loads
    known: float | None = None
    model: Model | None = None


def cantilever() -> Case:
    """A force at the tip: P L^3 / (3 E I)."""
    built = frames.straight(1, LENGTH, about_z=frames.ABOUT_Y)
    loads = Loads.none(built)
    loads.nodal[1, 2] = -FORCE
    known = FORCE * LENGTH**3 / (3 * frames.YOUNGS * frames.ABOUT_Y)
    return Case(built, Supports.at(2, {0: frames.RIGID}), loads, known)


def bow() -> Case:
    """A quarter ring that sticks out: P R^3 (pi / (4 E I) + (3 pi / 4 - 2) / (G J)), Roark."""
    count = 160
    at = np.linspace(0, np.pi / 2, count + 1)
    points = RADIUS * np.stack([np.cos(at), np.sin(at), 0 * at], axis=1)
    built = frames.polyline(points, about_z=frames.ABOUT_Y)
    loads = Loads.none(built)
    loads.nodal[count, 2] = -FORCE
    bent = np.pi / (4 * frames.YOUNGS * frames.ABOUT_Y)
    twisted = (3 * np.pi / 4 - 2) / (frames.SHEAR * frames.TORSION)
    known = FORCE * RADIUS**3 * (bent + twisted)
    return Case(built, Supports.at(count + 1, {0: frames.RIGID}), loads, known)


def of_net(mesh: QuadMesh) -> Case:
    """A shell with pinned borders under its snow; mesh in mm."""
    model = model_of(mesh, Design.of({"section": SECTION, "snow": 1.5, "self_weight": False}))
    return Case(model.frame, model.supports, model.cases[0].loads, model=model)


def dome() -> Case:
    """A shell of 5 x 7 vertices."""
    mesh = primitive("translational", 7, 5)
    return of_net(mesh.with_vertices(2000.0 * mesh.vertices))


def roof() -> Case:
    """The demo roof."""
    net = api.read_mesh(ROOT / "examples" / "data" / "demo_roof.obj")
    return of_net(net.mesh.scaled(1000.0 if net.unit == "m" else 1.0))


def large() -> Case:
    """A shell of 100 x 100 vertices."""
    mesh = primitive("translational", 100, 100)
    return of_net(mesh.with_vertices(20_000.0 * mesh.vertices))


CASES = {
    "cantilever": cantilever,
    "quarter ring": bow,
    "dome": dome,
    "demo roof": roof,
    "100 x 100 nodes": large,
}


def own(case: Case) -> float:
    """Largest displacement by the project's own frame."""
    found = response(FrameSystem(case.frame, case.supports), case.loads)
    return float(np.linalg.norm(found.displacements[:, :3], axis=1).max())


def pynite(case: Case) -> float:
    """The same by PyNiteFEA."""
    from Pynite import FEModel3D

    frame, of, other = case.frame, case.frame.stiffness, FEModel3D()
    poisson = of.youngs[0] / (2 * of.shear[0]) - 1
    other.add_material("steel", of.youngs[0], of.shear[0], poisson, 0.0)
    other.add_section("tube", of.area[0], of.about_y[0], of.about_z[0], of.torsion[0])
    used = np.unique(frame.members).tolist()
    for node in used:
        other.add_node(str(node), *frame.nodes[node].tolist())
        if case.supports.fixed[node].any():
            other.def_support(str(node), *case.supports.fixed[node].tolist())
    for member, (one, two) in enumerate(frame.members.tolist()):
        other.add_member(str(member), str(one), str(two), "steel", "tube")
        for name, size in zip(("FX", "FY", "FZ"), case.loads.spread[member].tolist(), strict=True):
            if size:
                other.add_member_dist_load(str(member), name, size, size)
    for node, direction in np.argwhere(case.loads.nodal[:, :3] != 0).tolist():
        size = float(case.loads.nodal[node, direction])
        other.add_node_load(str(node), ("FX", "FY", "FZ")[direction], size)
    other.analyze_linear()
    names = [other.nodes[str(node)] for node in used]
    moved = [[n.DX["Combo 1"], n.DY["Combo 1"], n.DZ["Combo 1"]] for n in names]
    return float(np.linalg.norm(moved, axis=1).max())


def calculix(case: Case) -> float:
    """The same of the nodes of the net by CalculiX, from the input file that a check writes."""
    text = input_file(case.model) if case.model is not None else None
    if text is None:
        raise ValueError("CalculiX is asked for nets only")
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "model.inp").write_text(text, encoding="utf-8")
        alone = {**os.environ, "OMP_NUM_THREADS": "1"}
        subprocess.run(["ccx", "model"], cwd=folder, env=alone, capture_output=True, check=True)
        rows = _numbers(Path(folder, "model.dat").read_text(encoding="utf-8"))
    return float(np.linalg.norm(rows[: len(case.frame.nodes)], axis=1).max())


def _numbers(text: str) -> FloatArray:
    """(n, 3) displacements of the first step, node by node."""
    rows = []
    for line in text.splitlines():
        words = line.split()
        if len(words) == 4 and words[0].isdigit():
            rows.append([float(word) for word in words[1:]])
    return np.array(rows)


ANSWERS = {"own": own, "PyNiteFEA": pynite, "CalculiX": calculix}


def measured(name: str, engine: str) -> dict[str, float | int | None]:
    """One row, in this process."""
    case = CASES[name]()
    if engine == "PyNiteFEA" or case.known is not None:
        case = replace(case, frame=_without_shear(case.frame))
    start = time.perf_counter()
    moved = ANSWERS[engine](case)
    seconds = time.perf_counter() - start
    who = resource.RUSAGE_CHILDREN if engine == "CalculiX" else resource.RUSAGE_SELF
    # What is off is told from the same beams: those of Euler for PyNiteFEA, of Timoshenko else.
    known = case.known or own(case)
    return {
        "nodes": len(np.unique(case.frame.members)),
        "members": len(case.frame.members),
        "seconds": seconds,
        "mb": resource.getrusage(who).ru_maxrss / 1024,
        "moved": moved,
        "off": abs(moved / known - 1),
    }


def _without_shear(frame: Frame) -> Frame:
    endless = np.full(len(frame.members), np.inf)
    return replace(
        frame, stiffness=replace(frame.stiffness, shear_area_y=endless, shear_area_z=endless)
    )


def rows() -> Iterator[str]:
    """The table."""
    yield "| case | nodes | members | program | seconds | MB | largest displacement, mm | off |"
    yield "| --- | ---: | ---: | --- | ---: | ---: | ---: | ---: |"
    for name, case in CASES.items():
        for engine in ENGINES:
            there = find_spec("Pynite") if engine == "PyNiteFEA" else shutil.which("ccx")
            pointless = engine == "CalculiX" and case in (cantilever, bow)
            if engine != "own" and (not there or pointless):
                continue
            command = [sys.executable, __file__, "--one", name, engine]
            size = len(case().frame.members)
            if engine != "own" and size > _MOST:
                yield f"| {name} | | {size:,} | {engine} | not tried | | | |"
                continue
            found = json.loads(subprocess.run(command, capture_output=True, check=True).stdout)
            off = "" if engine == "own" and case not in (cantilever, bow) else f"{found['off']:.0e}"
            yield (
                f"| {name} | {found['nodes']:,} | {found['members']:,} | {engine} | "
                f"{found['seconds']:.2f} | {found['mb']:.0f} | {found['moved']:.3f} | {off} |"
            )
    yield ""
    yield from whole_check()


def whole_check() -> Iterator[str]:
    """The whole check of the demo roof: all combinations, five modes of each."""
    case = roof()
    if case.model is None:
        return
    design = Design.of(
        {"section": "tube:100x60x5", "material": "S355", "snow": 1.5, "panels": 0.4,
         "wind": "0.6@x"}
    )  # fmt: skip
    model = model_of(case.model.mesh, design)
    for words, chosen in (("first order", False), ("second order", True)):
        asked = replace(model, design=replace(design, second_order=chosen))
        start = time.process_time()
        found = check_model(asked, usual(model.cases))
        yield (
            f"The whole check of the demo roof, {words}, {len(found.strength)} combinations with "
            f"{design.modes} buckling modes each: {time.process_time() - start:.1f} s of "
            "processor time.  "
        )


def main() -> None:
    """Print the table, or one row of it as JSON."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true", help="into docs/benchmarks.md")
    parser.add_argument("--one", nargs=2, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.one:
        print(json.dumps(measured(*options.one)))
        return
    text = "\n".join(rows())
    print(text)
    if options.write:
        path = ROOT / "docs" / "benchmarks.md"
        begin, end = "<!-- frame table: begin -->", "<!-- frame table: end -->"
        head, rest = path.read_text(encoding="utf-8").split(begin)
        tail = rest.split(end)[1]
        path.write_text(f"{head}{begin}\n{text}\n{end}{tail}", encoding="utf-8")


if __name__ == "__main__":
    main()
