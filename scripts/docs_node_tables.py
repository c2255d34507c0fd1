"""Numbers of the tables of nodes in docs/fabrication.md, on principal nets with default sizes.

Run with the project's Python:  python scripts/docs_node_tables.py KIND NET ... [--edge 1.2]
with a kind of nodes, bolted, star, ball or through, or all of them, every; names of meshes in
../shared/meshes or demo_roof, and the mean edge of the nets in m.
Prints a row a net: nodes, types, largest diameter, joints of beams, clashes among all parts; of
beams that run through stars, edges where lines give way, fins and arms, splices, cover plates and
clashes. With every: parts with each kind, mitred beams first, and clashes and parts beyond limits
where there are any, or what a refusal says.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from freecad_ortho import api  # noqa: E402
from freecad_ortho.fabrication.clash import check_clashes  # noqa: E402
from freecad_ortho.fabrication.limits import OK  # noqa: E402
from solver.errors import InputError  # noqa: E402

SECTIONS = {"ball": {"section": "chs:88.9x5"}}
THROUGH = ("stars", "turned", "arms", "splices", "cover_plates")


def main() -> None:
    """Print a row for each net that is named."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("kind")
    parser.add_argument("nets", nargs="+")
    parser.add_argument("--edge", type=float, default=1.2, help="mean edge, m")
    asked = parser.parse_args()
    kind = asked.kind
    for name in asked.nets:
        net = principal(name, 1000 * asked.edge)
        if kind == "every":
            print(f"| {name} | {' | '.join(every_kind(net))} |", flush=True)
            continue
        made = api.fabricate(net, "beams+nodes+panels", node=kind, **SECTIONS.get(kind, {}))
        report, found = made.report()["nodes"], check_clashes(made.parts)
        assert not found.open
        if kind == "through":
            numbers = [report[key] for key in THROUGH]
            print(
                f"| {name} | {' | '.join(map(str, numbers))} | {len(found.clashes)} |", flush=True
            )
            continue
        joints = next(report[key] for key in ("cones", "end_plates", "arms") if key in report)
        types = next(t for t in made.results["nodes"].tables if t.name == "node-types.csv")
        count = sum(int(str(row[1])) for row in types.rows)
        numbers = [count, report["different"], f"{report['diameter_mm']:g}", joints]
        print(f"| {name} | {' | '.join(map(str, numbers))} | {len(found.clashes)} |", flush=True)


def every_kind(net: api.QuadMesh) -> list[str]:
    """What comes of a net with mitred beams and with each kind of nodes, panels on them."""
    found = []
    for kind in ("mitred", "hub", "bolted", "star", "through", "ball"):
        system = "beams+panels" if kind == "mitred" else "beams+nodes+panels"
        settings = {} if kind == "mitred" else {"node": kind, **SECTIONS.get(kind, {})}
        try:
            made = api.fabricate(net, system, **settings)
        except InputError as refusal:
            found.append(str(refusal))
            continue
        clashes = check_clashes(made.parts)
        failed = sum(verdict != OK for verdict in made.verdicts)
        doubts = len(clashes.clashes) + len(clashes.open)
        said = f"{doubts} clashes, {failed} beyond limits" if doubts or failed else ""
        found.append(f"{len(made.parts)} {said}".strip())
    return found


def principal(name: str, edge: float = 1200.0) -> api.QuadMesh:
    """The mesh of a name as a principal net with edges of this length, mm."""
    path = ROOT / "examples" / "data" / "demo_roof.obj"
    if name != "demo_roof":
        path = ROOT.parent / "shared" / "meshes" / f"{name}.obj"
    start = api.read_mesh(path).mesh
    return api.optimise(start.scaled(edge / start.mean_edge), net="principal").mesh


if __name__ == "__main__":
    main()
