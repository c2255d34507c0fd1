"""Numbers of the tables of nodes in docs/fabrication.md, on principal nets with default sizes.

Run with the project's Python:  python scripts/docs_node_tables.py KIND NET ...
with a kind of nodes, bolted, star or ball, and names of meshes in ../shared/meshes or demo_roof.
Prints a row a net: nodes, types, largest diameter, joints of beams, clashes among all parts.
"""

from __future__ import annotations

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from freecad_ortho import api  # noqa: E402
from freecad_ortho.fabrication.clash import check_clashes  # noqa: E402

# Mean edge of the nets, mm.
EDGE = 1200.0
SECTIONS = {"ball": {"section": "chs:88.9x5"}}


def main() -> None:
    """Print a row for each net that is named."""
    kind, *names = sys.argv[1:]
    for name in names:
        made = api.fabricate(
            principal(name), "beams+nodes+panels", node=kind, **SECTIONS.get(kind, {})
        )
        report, found = made.report()["nodes"], check_clashes(made.parts)
        joints = next(report[key] for key in ("cones", "end_plates", "arms") if key in report)
        assert not found.open
        types = next(t for t in made.results["nodes"].tables if t.name == "node-types.csv")
        count = sum(int(str(row[1])) for row in types.rows)
        numbers = (count, report["different"], f"{report['diameter_mm']:g}", joints)
        print(f"| {name} | {' | '.join(map(str, numbers))} | {len(found.clashes)} |", flush=True)


def principal(name: str) -> api.QuadMesh:
    """The mesh of a name as a principal net with edges of 1.2 m."""
    path = ROOT / "examples" / "data" / "demo_roof.obj"
    if name != "demo_roof":
        path = ROOT.parent / "shared" / "meshes" / f"{name}.obj"
    start = api.read_mesh(path).mesh
    return api.optimise(start.scaled(EDGE / start.mean_edge), net="principal").mesh


if __name__ == "__main__":
    main()
