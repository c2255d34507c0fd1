"""Typical details of docs/details.md: their pictures, and their dimensions held against rules.

Run with the project's Python:  python scripts/docs_details.py [table | NAME ...]
``table`` writes the table of dimensions alone; a name makes the picture of that detail.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from freecad_ortho import api  # noqa: E402
from freecad_ortho.fabrication.bolts import bolt_of  # noqa: E402
from freecad_ortho.fabrication.part import Part  # noqa: E402
from freecad_ortho.fabrication.structure import Structure  # noqa: E402
from solver.mesh.quadmesh import FloatArray, QuadMesh  # noqa: E402

PAGE = ROOT / "docs" / "details.md"
PICTURES = ROOT / "docs" / "pictures" / "details"
ROWS, COLUMNS = 6, 7
BOLT = bolt_of("M16")


class Detail(NamedTuple):
    """A structure, and where it is looked at.

    Attributes:
        systems: joined by +.
        values: their options.
        materials: of the systems, None for steel.
        place: row and column on the net, whole numbers for its vertices.
        reach: how far around parts are shown, mm.
        sliced: whether what is in front of the place is cut away.
        above: how far above the place its middle is, mm.
        camera: direction to it.
        bare: whether the panel that is nearest to the camera is left out.
        lifted: how far the lamella of family v is drawn above its place, mm.
    """

    systems: str
    values: dict[str, Any]
    materials: str | None = None
    place: tuple[float, float] = (2, 3)
    reach: float = 420.0
    sliced: bool = False
    above: float = 0.0
    camera: tuple[float, float, float] = (0.7, -1.0, 0.72)
    bare: bool = False
    lifted: float = 0.0


TUBES = {"section": "tube:100x60x5"}
LAMELLAS: dict[str, Any] = {"width": 100.0, "thickness": 8.0, "hole": 11.0, "strip": "twisted"}
DETAILS = {
    "bolted": Detail("beams+nodes+panels", {"node": "bolted", **TUBES}),
    "star": Detail("beams+nodes+panels", {"node": "star", "section": "I", "thickness": 10.0}),
    "through": Detail(
        "beams+nodes",
        {"node": "through", "splice_every": 2},
        place=(2.3, 3),
        reach=800.0,
    ),
    "ball": Detail("beams+nodes+panels", {"node": "ball", "section": "chs:88.9x5"}),
    "edge": Detail(
        "edge-beam+beams+nodes+panels",
        {"edge_section": "tube", "node": "bolted", "panel_thickness": 20.0, **TUBES},
        place=(0, 3),
        reach=650.0,
        bare=True,
    ),
    "foot": Detail(
        "beams+nodes+feet",
        {"node": "bolted", "foot_at": "boundary", **TUBES},
        place=(0, 3),
        reach=800.0,
    ),
    "frame": Detail(
        "beams+panels",
        {"frame": "plate", "panel_edge": "bevel", "section": "tube:160x60x5"},
        "steel,panels=glass:6/16/44.2",
        place=(2.5, 3),
        reach=175.0,
        sliced=True,
        above=105.0,
        camera=(0.35, -1.0, 0.5),
    ),
    "silicone": Detail(
        "beams+panels",
        {"frame": "silicone", "section": "tube:160x60x5"},
        "steel,panels=glass:8/16/44.2",
        place=(2.5, 3),
        reach=175.0,
        sliced=True,
        above=105.0,
        camera=(0.35, -1.0, 0.5),
    ),
    "cassette": Detail(
        "beams+panels",
        {"fold": 40.0, "panel_thickness": 2.0, "section": "tube:100x60x5"},
        "steel,panels=aluminium",
        place=(2, 3),
        reach=330.0,
        above=60.0,
        bare=True,
    ),
    "crossing": Detail(
        "lamellas", {"width": 100.0, "thickness": 8.0}, reach=240.0, lifted=90.0, above=20.0
    ),
    "cleat": Detail(
        "lamellas",
        {**LAMELLAS, "cleats": True},
        place=(0, 3),
        reach=260.0,
        camera=(0.5, 1.0, 0.9),
    ),
    "lamella-foot": Detail(
        "lamellas+feet",
        {**LAMELLAS, "cleats": True, "foot_at": "boundary", "foot_height": 400.0},
        place=(0, 3),
        reach=330.0,
        above=-60.0,
        camera=(1.0, -0.7, 0.5),
    ),
}
# Nodes have pictures of their own, by docs_nodes.py.
DRAWN = tuple(name for name in DETAILS if name not in ("bolted", "star", "ball"))


def main() -> None:
    """Make what is named, by default all."""
    wanted = sys.argv[1:] or ["table", *DRAWN]
    if "table" in wanted:
        write_table()
    if names := [name for name in wanted if name != "table"]:
        draw(names)


def net() -> QuadMesh:
    """A vault with waves: meridians and parallels about a level line, so flat orthogonal faces."""
    along, angle = np.meshgrid(
        np.linspace(0, 6.0, ROWS), np.radians(np.linspace(60.0, 120.0, COLUMNS)), indexing="ij"
    )
    radius = 8.0 + 0.4 * np.sin(0.9 * along)
    points = np.stack([-radius * np.cos(angle), along, radius * np.sin(angle)], axis=-1)
    number = np.arange(ROWS * COLUMNS).reshape(ROWS, COLUMNS)
    corners = number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]
    return QuadMesh(1000 * points.reshape(-1, 3), np.stack(corners, axis=-1).reshape(-1, 4))


def built(detail: Detail) -> Structure:
    """The whole structure."""
    material = {} if detail.materials is None else {"material": detail.materials}
    return api.fabricate(net(), detail.systems, **material, **detail.values)


def place_of(detail: Detail, mesh: QuadMesh) -> FloatArray:
    """(3,) where it is looked at, mm."""
    row, column = detail.place
    grid = mesh.vertices.reshape(ROWS, COLUMNS, 3)
    low, part = int(row), row - int(row)
    return np.asarray(
        (1 - part) * grid[low, int(column)] + part * grid[low + (part > 0), int(column)]
    )


class Dimension(NamedTuple):
    """A dimension of a detail; mm unless its name says otherwise.

    Attributes:
        detail: its name.
        words: what is measured.
        found: on the parts: of all of them the worst.
        least: that the rule asks for.
        rule: where that is from.
    """

    detail: str
    words: str
    found: float
    least: float
    rule: str

    @property
    def holds(self) -> bool:
        """Whether the rule is kept, to a thousandth."""
        return self.found >= self.least - 1e-3


EC3 = "EN 1993-1-8, table 3.3"


def dimensions() -> Iterator[Dimension]:
    """Those of all details, measured on their parts."""
    made = {name: built(detail) for name, detail in DETAILS.items()}
    plates = of_kind(made["bolted"], "end-plate")
    yield Dimension("bolted", "bolt to the edge of an end plate", edges(plates), 1.2 * 18, EC3)
    yield Dimension("bolted", "bolt to bolt", apart(plates), 2.2 * 18, EC3)
    drilled = [*of_kind(made["star"], "cover-plate"), *of_kind(made["star"], "node")]
    yield Dimension("star", "bolt to the edge of a plate", edges(drilled), 1.2 * 18, EC3)
    yield Dimension("star", "bolt to bolt", apart(drilled), 2.2 * 18, EC3)
    joined = [part for part in made["through"].parts if part.kind in ("cover-plate", "beam")]
    yield Dimension("through", "bolt to the edge of a plate", edges(joined), 1.2 * 18, EC3)
    yield from _of_balls(made["ball"])
    yield from _of_feet(made["foot"])
    yield from _of_lamellas(made)
    bearing = [part.measures.bearing_mm or 0.0 for part in of_kind(made["edge"], "panel")]
    yield Dimension("edge", "panel on beams", min(bearing), 5.0, "of metal, see workshop.md")
    frame = made["frame"].report()["panels"]["frame"]
    yield Dimension(
        "frame", "glass under pressure plates", frame["cover_min_mm"], 10, "DIN 18008-2"
    )
    yield Dimension(
        "frame",
        "joint between panes",
        made["frame"].report()["panels"]["clear_gap_min_mm"],
        20.0,
        "frame less twice the edge cover",
    )
    glued = made["silicone"]
    borne = glued.report()["panels"]["silicone"]["wind_min_kN_m2"]
    short = max(part.pattern.size.min() for part in of_kind(glued, "panel") if part.pattern)
    rule = "2 x 0.14 MPa x 12 mm / shorter side, EAD 090010"
    yield Dimension("silicone", "wind that the bite bears, kN/m2", borne, 3360.0 / short, rule)
    sheets = of_kind(made["cassette"], "panel")
    deep = min(float(np.ptp(part.body.points[:, 2])) for part in sheets)
    yield Dimension("cassette", "fold, measured outside", deep, 40.0, "as it is asked for")
    taken = made["cassette"].report()["panels"]["cassettes"]["allowance_mm"]
    allowance = np.pi / 2 * (2.0 + 0.65 / 2 * 2.0)
    yield Dimension("cassette", "sheet that a fold takes", taken, allowance, "DIN 6935")
    slots = made["crossing"].report()["lamellas"]
    yield Dimension(
        "crossing",
        "slot of a lamella 8 mm thick",
        slots["slot_width_min_mm"],
        9.0,
        "thickness and clearance",
    )


def _of_balls(made: Structure) -> Iterator[Dimension]:
    """Threads, sleeves and what is left between holes."""
    rule = "typical, after JGJ 7-2010, 5.3"
    tables = {table.name: table for table in made.results["nodes"].tables}
    bolts = dict(zip(tables["bolts.csv"].columns, tables["bolts.csv"].rows[0], strict=True))
    yield Dimension("ball", "thread in the ball", float(str(bolts["thread_mm"])), 1.1 * 16, rule)
    sleeves = [
        float(np.ptp(part.body.points[:, :2], axis=0).max()) for part in of_kind(made, "sleeve")
    ]
    yield Dimension("ball", "sleeve across its corners", min(sleeves), 1.8 * 16, rule)
    walls = []
    for ball in of_kind(made, "node"):
        ways = ball.body.ways  # type: ignore[attr-defined]
        angle = np.arccos(np.clip((ways @ ways.T)[~np.eye(len(ways), dtype=bool)], -1, 1)).min()
        bottom = ball.body.seat - ball.body.depth  # type: ignore[attr-defined]
        walls.append(2 * (bottom * np.tan(angle / 2)) - BOLT.drill)
    yield Dimension("ball", "between holes, at their ends", float(min(walls)), 3.0, "own rule")


def _of_feet(made: Structure) -> Iterator[Dimension]:
    """Anchors in base plates."""
    bases = [part for part in of_kind(made, "foot-plate") if part.name.endswith("base")]
    yield Dimension("foot", "anchor to the edge of the base plate", edges(bases), 1.2 * 18, EC3)
    [post, *_] = of_kind(made, "foot")
    beside = min(
        float(np.linalg.norm(hole.centre - base.pattern.size / 2)) - post.width / 2
        for base in bases
        if base.pattern is not None
        for hole in base.pattern.holes
    )
    yield Dimension("foot", "anchor to the post, for a wrench", beside, BOLT.wrench, "ISO 7738")


def _of_lamellas(made: Mapping[str, Structure]) -> Iterator[Dimension]:
    """Bolts in cleats, and in fins of feet."""
    least = 1.2 * LAMELLAS["hole"]
    for detail, kind, words in (
        ("cleat", "cleat", "bolt to the edge of a cleat"),
        ("lamella-foot", "fin", "bolt to the edge of a fin"),
    ):
        yield Dimension(detail, words, edges(of_kind(made[detail], kind)), least, EC3)


def of_kind(made: Structure, kind: str) -> list[Part]:
    """Its parts of a kind."""
    return [part for part in made.parts if part.kind == kind]


def edges(parts: list[Part]) -> float:
    """Least distance of a hole's middle from the outline of its plate, mm."""
    import shapely

    return min(
        float(shapely.LinearRing(part.pattern.outline).distance(shapely.Point(hole.centre)))
        for part in parts
        if part.pattern is not None
        for hole in part.pattern.holes
    )


def apart(parts: list[Part]) -> float:
    """Least distance of two holes in one plate, mm."""
    found = []
    for part in parts:
        assert part.pattern is not None
        places = np.array([hole.centre for hole in part.pattern.holes])
        away = np.linalg.norm(places[:, None] - places, axis=2)
        found.append(float(away[away > 0].min(initial=np.inf)))
    return min(found)


def table() -> str:
    """The lines of the page's table."""
    rows = [
        f"| {one.detail} | {one.words} | {one.found:.1f} | {one.least:.1f} | {one.rule} |"
        for one in dimensions()
    ]
    head = ["| detail | dimension | is, mm | at least | by |", "| --- | --- | ---: | ---: | --- |"]
    return "\n".join([*head, *rows])


def write_table() -> None:
    """Put the table into the page."""
    begin, end = "<!-- details table: begin -->", "<!-- details table: end -->"
    before, _, rest = PAGE.read_text(encoding="utf-8").partition(begin)
    after = rest.partition(end)[2]
    PAGE.write_text(f"{before}{begin}\n{table()}\n{end}{after}", encoding="utf-8")


def draw(names: list[str]) -> None:
    """Have FreeCAD draw details from near."""
    from docs_pictures import draw_in_freecad, shrink

    PICTURES.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        order = {"paths": [str(ROOT), str(ROOT / "scripts")], "names": names, "folder": folder}
        draw_in_freecad("docs_details_freecad.py", order, Path(folder), seconds=900)
        for name in names:
            shrink(Path(folder) / f"{name}.png", PICTURES / f"{name}.png", 800)


if __name__ == "__main__":
    main()
