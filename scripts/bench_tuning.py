"""Doubles and halves every number of the solver and prints what changes on the authors' meshes.

Run with the project's Python:
    python scripts/bench_tuning.py [--write] [--quick] [NUMBER ...]

A case is *elsewhere* where a vertex of its mesh comes to lie more than 0.01 mean edges from its
usual place. ``--write`` puts the table into docs/tuning.md, ``--quick`` leaves large and hard cases
out.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np
from bench import ROOT, SHARED, write

from freecad_ortho import api
from freecad_ortho.words import counted
from solver import Constraints, NetOptions, Outcome, QuadMesh, optimise
from solver.tuning import Tuning

# What the paper's authors made their meshes for.
CASES = {
    "heart": "principal",
    "conical1": "conical",
    "botanic-garden-bubble-0": "principal",
    "complete01": "asymptotic --diagonal",
    "cmc1": "cmc",
    "knet1": "asymptotic",
    "enneper2": "asymptotic --diagonal",
    "chebyshev_sphere": "chebyshev",
    "quad_dome": "stress",
    "6-sub-lifted": "stress",
    "wein99_diag": "cmc --diagonal",
    "helical-minimal": "asymptotic",
    "gnet1": "geodesic",
}
# Those of fewer than a thousand vertices that are near to their net.
QUICK = ("heart", "cmc1", "knet1", "chebyshev_sphere", "quad_dome", "6-sub-lifted")
MOST_STEPS = 200
MOVED = 0.01


@dataclass(frozen=True)
class Case:
    """A mesh and the net that it is to become; with a handle that is drawn aside or without."""

    name: str
    mesh: QuadMesh
    net: str
    pulled: bool = False

    def outcome(self, tuning: Tuning) -> Outcome:
        """Optimise with these numbers."""
        net, _, diagonal = self.net.partition(" --")
        wanted = None
        if self.pulled:
            middle = len(self.mesh.vertices) // 2
            lift = self.mesh.mean_edge * self.mesh.vertex_normals[middle]
            wanted = Constraints(handles={middle: self.mesh.vertices[middle] + lift})
        return optimise(
            self.mesh,
            net,
            options=NetOptions(diagonal=bool(diagonal)),
            constraints=wanted,
            max_steps=MOST_STEPS,
            tuning=tuning,
        )


def cases(quick: bool) -> Iterator[Case]:
    """All cases whose mesh is there."""
    for name, net in CASES.items():
        path = SHARED / f"{name}.obj"
        if path.is_file() and (name in QUICK or not quick):
            yield Case(f"{name} {net}", api.read_mesh(path).mesh, net)
    dome = SHARED / "quad_dome.obj"
    if dome.is_file():
        yield Case("quad_dome, a handle", api.read_mesh(dome).mesh, "principal", pulled=True)


def scaled(value: Any, factor: float) -> Any:
    """A number, or several of them, times a factor; counts stay whole and at least one."""
    if isinstance(value, tuple):
        return tuple(factor * part for part in value)
    return max(1, round(factor * value)) if isinstance(value, int) else factor * value


def effect(found: dict[str, Outcome], usual: dict[str, Outcome]) -> str:
    """What is different from usual, in words."""
    before, after = (
        sum(outcome.report.iterations for outcome in each.values()) for each in (usual, found)
    )
    words = [] if before == after else [f"{after} steps"]
    moved = {}
    for name, outcome in found.items():
        old = usual[name]
        if outcome.report.status != old.report.status:
            words.append(f"{name}: {outcome.report.status}")
        else:
            ways = np.linalg.norm(outcome.mesh.vertices - old.mesh.vertices, axis=1)
            moved[name] = ways.max() / old.report.mean_edge
    far = {name: way for name, way in moved.items() if way > MOVED}
    if far:
        most = max(far, key=far.__getitem__)
        words.append(f"{counted(len(far), 'case')} elsewhere, {most} by {far[most]:.2g}")
    return "; ".join(words) or "nothing"


def written(value: Any) -> str:
    """A number or several as they stand in the table."""
    return ", ".join(f"{part:g}" for part in (value if isinstance(value, tuple) else (value,)))


def main() -> None:
    """Print a row a number."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true", help="update docs/tuning.md")
    parser.add_argument("--quick", action="store_true", help="without large and hard cases")
    parser.add_argument("names", nargs="*", metavar="NUMBER", help="only these numbers")
    options = parser.parse_args()
    asked, plain = list(cases(options.quick)), Tuning()
    if not asked:
        sys.exit(f"{SHARED} is missing: these are the meshes that the numbers are tried on")
    usual = {case.name: case.outcome(plain) for case in asked}
    steps = sum(outcome.report.iterations for outcome in usual.values())
    lines = [
        f"{len(asked)} cases, {steps} steps as it is.",
        "",
        "| number | value | halved | doubled |",
        "| --- | ---: | --- | --- |",
    ]
    print(lines[0], flush=True)
    for item in fields(Tuning):
        if options.names and item.name not in options.names:
            continue
        value = getattr(plain, item.name)
        effects = []
        for factor in (0.5, 2.0):
            other = replace(plain, **{item.name: scaled(value, factor)})
            effects.append(effect({case.name: case.outcome(other) for case in asked}, usual))
        lines.append(f"| {item.name} | {written(value)} | {effects[0]} | {effects[1]} |")
        print(lines[-1], flush=True)
    if options.write and not options.names:
        write(ROOT / "docs" / "tuning.md", "tuning", "\n".join(lines))


if __name__ == "__main__":
    main()
