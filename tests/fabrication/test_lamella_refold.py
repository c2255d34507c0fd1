"""Lamellas folded back from bends.csv alone, by someone who has nothing else."""

import csv
from collections import defaultdict
from pathlib import Path

import numpy as np
import pytest

from freecad_ortho.fabrication import Lamellas, build
from freecad_ortho.fabrication.systems.lamellas.facets import triangles, walked
from freecad_ortho.fabrication.tables import write_bends
from freecad_ortho.mesh_files import read_mesh
from solver.errors import InputError
from tests.conftest import surface_of_revolution
from tests.meshes import helicoid, scherk


def test_triangles_fill_a_side_that_is_not_convex():
    hook = np.array([(0, 0), (4, 0), (4, 4), (3, 4), (3, 1), (0, 1)], dtype=float)
    loop = [7, 2, 5, 1, 0, 3]
    points = np.zeros((8, 2))
    points[loop] = hook
    a, b, c = np.moveaxis(points[triangles(points, loop)], 1, 0)
    areas = np.linalg.det(np.stack([b - a, c - a], axis=1)) / 2
    assert len(areas) == 4 and (areas > 0).all()
    assert areas.sum() == pytest.approx(4 + 3)


def turned(vector, axis, degrees):
    angle = np.radians(degrees)
    return (
        np.cos(angle) * vector
        + np.sin(angle) * np.cross(axis, vector)
        + (1 - np.cos(angle)) * (axis @ vector) * axis
    )


def refolded(rows):
    """(N, 3) places of the axis on the bend lines, from the rows of one part."""
    numbers = {
        name: np.array([float(row[name]) for row in rows])
        for name in rows[0]
        if name not in ("part", "bend")
    }
    axis = np.column_stack([numbers["axis_x_mm"], numbers["axis_y_mm"]])
    line = np.column_stack(
        [numbers["x2_mm"] - numbers["x1_mm"], numbers["y2_mm"] - numbers["y1_mm"]]
    )
    steps = np.diff(axis, axis=0)
    place = np.zeros(3)
    x, y = steps[0] / np.linalg.norm(steps[0])
    along, across = np.array([x, y, 0.0]), np.array([-y, x, 0.0])
    found = [place]
    for number, step in enumerate(steps):
        length = np.linalg.norm(step)
        place = place + length * along
        found.append(place)
        across = turned(across, along, numbers["twist_deg"][number])
        if number + 1 == len(steps):
            break
        # In the plane of the plate, from the last step's direction.
        ahead = step / length
        left = np.array([-ahead[1], ahead[0]])
        fold = (line[number + 1] @ ahead) * along + (line[number + 1] @ left) * across
        fold /= np.linalg.norm(fold)
        after = steps[number + 1] / np.linalg.norm(steps[number + 1])
        along, across = (
            (after @ ahead) * along + (after @ left) * across,
            (after @ ahead) * across - (after @ left) * along,
        )
        # Positive where the sides rise towards whoever looks at the pattern.
        along, across = (
            turned(each, fold, -numbers["angle_deg"][number + 1]) for each in (along, across)
        )
    return np.array(found)


def misses(points, places):
    """Distances of points from places after the best rigid motion."""
    one, other = points - points.mean(axis=0), places - places.mean(axis=0)
    u, _, v = np.linalg.svd(one.T @ other)
    flip = np.diag([1.0, 1.0, np.sign(np.linalg.det(u @ v))])
    return np.linalg.norm(one @ u @ flip @ v - other, axis=1)


@pytest.mark.parametrize(
    ("mesh", "settings"),
    [
        (helicoid(), {"strip": "twisted"}),
        (scherk(), {"strip": "twisted", "pattern": "free"}),
        (scherk(), {"strip": "twisted", "stock": 3000.0, "hole": 6.0, "pattern": "free"}),
        (surface_of_revolution(), {"strip": "developable"}),
    ],
    ids=["helicoid", "scherk", "spliced", "plane faces"],
)
def test_the_file_alone_leads_back_to_the_nodes(mesh, settings, tmp_path):
    mesh = mesh.scaled(2000.0)
    structure = build(mesh, [Lamellas(**{"width": 40.0, "thickness": 3.0} | settings)])
    parts = {part.name: part for part in structure.parts if part.kind == "lamella"}
    path = tmp_path / "bends.csv"
    write_bends(path, {name: part.pattern for name, part in parts.items()})
    rows = defaultdict(list)
    with path.open(encoding="utf-8", newline="") as stream:
        for row in csv.DictReader(stream):
            rows[row["part"]].append(row)
    checked = 0
    for lamella in structure.results["lamellas"].geometry.lamellas:
        bent = np.abs(lamella.ribbon.strip.bends) > 1e-9
        nodes = [
            vertex
            for vertex, station in zip(lamella.vertices, lamella.stations, strict=True)
            if bent[station]
        ]
        found = rows[lamella.name]
        assert len(found) == len(nodes)
        if len(nodes) > 2:
            assert misses(refolded(found), mesh.vertices[nodes]).max() <= 1e-3, lamella.name
            checked += 1
    assert checked >= len(parts) / 3


def test_marks_at_crossings_are_lines_that_are_seen():
    structure = build(helicoid().scaled(3000.0), [Lamellas(40, 3, strip="twisted")])
    for part in structure.parts:
        lines = [mark.points for mark in part.pattern.marks if not mark.text]
        lengths = [np.linalg.norm(line[1] - line[0]) for line in lines]
        assert lengths and min(lengths) == pytest.approx(0.3 * 40)


def test_patterns_that_curl_are_folded_whole():
    """Beyond a right angle: where its bend lines lead on there are other pieces of it."""
    net = read_mesh(Path(__file__).parent / "fixtures" / "curled_lamellas.json").mesh
    structure = build(net, [Lamellas(width=70.9)])
    turns = []
    for part in structure.parts:
        steps = np.diff(part.pattern.axis, axis=0)
        heading = np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))
        turns.append(np.degrees(np.ptp(heading)))
        assert part.volume == pytest.approx(part.area * part.thickness, rel=1e-3), part.name
        solid = part.solid()
        assert solid.isValid() and solid.Volume() == pytest.approx(part.volume), part.name
    assert min(turns) < 100 < max(turns)


def test_walks_that_do_not_return_are_said():
    with pytest.raises(InputError, match="bend lines cross each other within its width"):
        walked({0: 1, 1: 2, 2: 1}, [0])
