"""Bevels and mitres in the written files: lines, angles and the side that is seen agree."""

import csv
import math

import ezdxf
import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.fabrication import Beams, Panels, Workshop, build, write
from freecad_ortho.fabrication.bevels import bevels_of
from freecad_ortho.fabrication.bodies import BOX_SIDES, Polyhedron
from solver.mesh.quadmesh import QuadMesh
from tests.conftest import grid_faces


def table(path):
    with path.open(newline="") as stream:
        return list(csv.DictReader(stream))


@pytest.fixture(scope="module")
def written(skewed, tmp_path_factory):
    """Mitred beams, and panels whose bevels open and undercut."""
    folder = tmp_path_factory.mktemp("bevels")
    structure = build(skewed, [Beams(160, 12), Panels(20, 15, edge="bevel")])
    write(structure, folder, workshop=Workshop(dxf="blocks"))
    return structure, folder


@pytest.fixture(scope="module")
def barrel():
    """A flat arc of cylinder, 4 x 3 faces."""
    angle, y = np.meshgrid(np.linspace(-0.4, 0.4, 5), 500.0 * np.arange(4), indexing="ij")
    points = np.stack([3000 * np.sin(angle), y, 3000 * np.cos(angle)], axis=-1)
    return QuadMesh(points.reshape(-1, 3), grid_faces(5, 4))


def distance(point, start, end):
    """Of a point from the line through two others."""
    along = (end - start) / np.linalg.norm(end - start)
    arm = point - start
    return abs(float(arm[0] * along[1] - arm[1] * along[0]))


def test_angles_say_how_far_lines_lie_from_the_outline(written):
    """A bevel through a panel is its whole thickness deep, a mitre half of a beam's."""
    folder = written[1]
    parts = {row["name"]: row for row in table(folder / "parts.csv")}
    blocks = ezdxf.readfile(folder / "flat.dxf").blocks
    rows = table(folder / "bevels.csv")
    assert {parts[row["part"]]["kind"] for row in rows} == {"beam", "panel"}
    assert {row["line_on"] for row in rows} == {"side seen", "far side"}
    for row in rows:
        part, angle = parts[row["part"]], float(row["angle_deg"])
        assert (row["line_on"] == "far side") == (angle < 0)
        line = np.array([float(row[key]) for key in ("x1_mm", "y1_mm", "x2_mm", "y2_mm")])
        middle = line.reshape(2, 2).mean(axis=0)
        (cut,) = blocks.get(row["part"]).query('*[layer=="CUT"]')
        outline = np.array(cut.get_points("xy"))
        sides = zip(outline, np.roll(outline, -1, axis=0), strict=True)
        nearest = min(distance(middle, start, end) for start, end in sides)
        deep = float(part["thickness_mm"]) / (2 if part["kind"] == "beam" else 1)
        assert nearest == pytest.approx(deep * math.tan(math.radians(abs(angle))), abs=2e-4)


def test_drawing_and_lists_have_the_same_bevels(written):
    folder = written[1]
    blocks, rows = ezdxf.readfile(folder / "flat.dxf").blocks, table(folder / "bevels.csv")
    for part in table(folder / "parts.csv"):
        own = [row for row in rows if row["part"] == part["name"]]
        block = blocks.get(part["name"])
        lines = block.query('LINE[layer=="BEVEL"]')
        drawn = [[*line.dxf.start.vec2, *line.dxf.end.vec2] for line in lines]
        listed = [[float(row[k]) for k in ("x1_mm", "y1_mm", "x2_mm", "y2_mm")] for row in own]
        assert np.array(drawn) == pytest.approx(np.array(listed), abs=1e-6)
        dashed = [line.dxf.linetype == "FAR_SIDE" for line in lines]
        assert dashed == [row["line_on"] == "far side" for row in own]
        angles = [float(row["angle_deg"]) for row in own]
        texts = [text.dxf.text for text in block.query('TEXT[layer=="BEVEL"]')]
        assert texts == [f"{angle:+.1f}" for angle in angles]
        assert int(part["bevels"]) == len(own)
        if angles:
            assert abs(float(part["bevel_max_deg"])) == pytest.approx(
                max(map(abs, angles)), rel=1e-5
            )
        else:
            assert part["bevel_max_deg"] == ""


def test_the_side_that_is_seen_is_the_one_that_is_said(written):
    structure, folder = written
    mesh = structure.mesh
    seen = {row["name"]: row["seen_from"] for row in table(folder / "parts.csv")}
    normals = mesh.face_normals
    for part in structure.parts:
        towards = part.frame[2]
        if part.kind == "panel":
            assert seen[part.name] == "above"
            assert towards @ normals[part.face] > 0.99
        else:
            assert seen[part.name] == "right"
            start, end = mesh.vertices[list(part.vertices)]
            up = structure.axes.directions[list(part.vertices)].sum(axis=0)
            assert towards @ np.cross(end - start, up) > 0


def test_square_plates_have_none(roof, tmp_path):
    write(build(roof, [Panels(20, 15)]), tmp_path)
    assert table(tmp_path / "bevels.csv") == []
    assert {row["bevels"] for row in table(tmp_path / "parts.csv")} == {"0"}


def frustum(inset):
    """A plate of 100 x 60 x 10, its upper side drawn in on all sides by so much, mm."""
    low = np.array([[0, 0], [100, 0], [100, 60], [0, 60]], dtype=float)
    high = low + inset * np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]])
    corners = [np.column_stack([ring, np.full(4, z)]) for ring, z in ((low, 0), (high, 10))]
    return Polyhedron(np.concatenate(corners), BOX_SIDES)


@pytest.mark.parametrize("inset", [2.0, -2.0, 0.0, 1e-8])
def test_bevels_of_a_frustum(inset):
    bevels = bevels_of(frustum(inset))
    assert len(bevels) == (4 if abs(inset) == 2 else 0)
    for bevel in bevels:
        assert bevel.angle_deg == pytest.approx(math.degrees(math.atan2(inset, 10)))
        assert bevel.hidden == (inset < 0)
        # The inner line: of the upper side where that is smaller, else of the lower.
        inner = abs(inset) if inset > 0 else 0.0
        low, high = [inner, inner], [100 - inner, 60 - inner]
        assert (
            (bevel.points >= np.array(low) - 1e-9) & (bevel.points <= np.array(high) + 1e-9)
        ).all()


@pytest.mark.parametrize(
    ("system", "sizes", "side"),
    [
        ("lamellas", {"width": 40, "thickness": 3}, "right"),
        ("lamellas", {"width": 40, "thickness": 3, "position": "lying", "layers": 2}, "above"),
        ("arches", {"height": 60, "thickness": 5}, "right"),
        ("louvres", {"tilt": 20}, "above"),
        ("bent-panels", {}, "above"),
        ("patches", {}, "above"),
    ],
)
def test_lists_say_the_side_of_every_system(barrel, tmp_path, system, sizes, side):
    """Solids lie in the coordinates of their patterns: z is towards who looks at them."""
    structure = api.fabricate(barrel, system, unit="mm", **sizes)
    write(structure, tmp_path)
    rows = {row["name"]: row["seen_from"] for row in table(tmp_path / "parts.csv")}
    assert set(rows.values()) == {side}
    for part in structure.parts:
        up = barrel.vertex_normals[list(part.vertices)].mean(axis=0)
        towards = up if side == "above" else np.cross(part.frame[0], up)
        assert part.frame[2] @ towards > 0.5 * np.linalg.norm(towards)
