"""Every part is a valid closed solid of the analytic volume, and neighbours share none."""

import cadquery
import numpy as np
import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Common

from freecad_ortho.fabrication import Beams, Panels, brep_text, build
from freecad_ortho.fabrication.round_tube import RoundTube
from freecad_ortho.fabrication.ruled import RuledBody

SYSTEMS = ("beams", "panels", "beams+panels")


def make(mesh, system, offset, thickness=12.0):
    systems = {"beams": Beams(200, thickness, offset), "panels": Panels(20, 15, offset)}
    return build(mesh, [systems[name] for name in system.split("+")])


def shared_volume(one, other):
    common = BRepAlgoAPI_Common(one.wrapped, other.wrapped)
    assert common.IsDone()
    return cadquery.Shape.cast(common.Shape()).Volume()


def touching_pairs(structure, count):
    """Pairs of parts whose boxes meet, spread evenly over all such pairs."""
    low = np.array([part.points.min(axis=0) for part in structure.parts])
    high = np.array([part.points.max(axis=0) for part in structure.parts])
    meet = ((low[:, None] <= high[None] + 1) & (low[None] <= high[:, None] + 1)).all(axis=2)
    pairs = np.argwhere(np.triu(meet, 1))
    return pairs[:: max(1, len(pairs) // count)]


def worst_overlap(structure, count=120):
    solids = structure.solids()
    return max(
        shared_volume(solids[i], solids[j])
        / min(structure.parts[i].volume, structure.parts[j].volume)
        for i, j in touching_pairs(structure, count)
    )


@pytest.mark.parametrize(
    ("name", "system", "offset"),
    [
        ("roof", "beams", "above"),
        ("roof", "beams+panels", "below"),
        ("roof", "panels", "above"),
        ("skewed", "beams", "below"),
        ("skewed", "beams+panels", "centre"),
        ("dodecahedron", "beams", "centre"),
        ("dodecahedron", "beams+panels", "above"),
        ("dodecahedron", "panels", "below"),
        ("twisted", "beams+panels", "centre"),
        ("twisted", "panels", "centre"),
    ],
)
def test_solids_are_valid_closed_and_of_analytic_volume(meshes, name, system, offset):
    structure = make(meshes[name], system, offset)
    mesh = meshes[name]
    counts = {"beams": len(mesh.connectivity.edges), "panels": len(mesh.faces)}
    assert len(structure.parts) == sum(counts[name] for name in system.split("+"))
    for part, solid in zip(structure.parts, structure.solids(), strict=True):
        assert solid.isValid(), part.name
        assert solid.Volume() == pytest.approx(part.volume, rel=1e-9), part.name
        assert len(solid.Shells()) == 1
        counts = [0, 0]
        for loop in part.body.loops:
            for pair in zip(loop, loop[1:] + loop[:1], strict=True):
                counts[pair[0] < pair[1]] += 1
        assert counts[0] == counts[1] == len(solid.Edges())


@pytest.mark.parametrize("name", ["roof", "skewed", "dodecahedron"])
@pytest.mark.parametrize("system", SYSTEMS)
def test_neighbours_share_no_volume(meshes, name, system):
    assert worst_overlap(make(meshes[name], system, "centre")) <= 1e-6


@pytest.mark.parametrize("offset", ["above", "below"])
def test_thick_plates_on_ridges_and_valleys_share_no_volume(roof, offset):
    beams = Beams(300, 60, offset)
    panels = Panels(60, 8, offset)
    assert worst_overlap(build(roof, [beams, panels]), 80) <= 1e-6
    assert worst_overlap(build(roof, [panels]), 80) <= 1e-6


def test_overlap_check_can_fail(roof):
    structure = make(roof, "beams", "centre")
    solid = structure.parts[0].solid()
    assert shared_volume(solid, solid.translate(cadquery.Vector(0, 0, 5))) > 1.0


def test_solids_stand_where_the_corners_are(structure):
    for part, solid in zip(structure.parts, structure.solids(), strict=True):
        found = np.array([vertex.toTuple() for vertex in solid.Vertices()])
        assert len(found) == len(part.points)
        gap = np.linalg.norm(found[:, None] - part.points[None], axis=2)
        assert gap.min(axis=0).max() <= 1e-8


def test_far_from_the_origin_nothing_changes(roof):
    far = roof.with_vertices(roof.vertices + [4e8, 5e8, 1e5])
    structure = make(far, "beams+panels", "centre")
    assert structure.axes.twist.max() <= 1e-7
    for part in structure.parts[::11]:
        assert part.solid().isValid()
        assert part.solid().Volume() == pytest.approx(part.volume, rel=1e-9)
        assert np.abs(structure.place.points(part.points) - [4e8, 5e8, 1e5]).max() <= 2e4


def test_compound_keeps_the_order_and_crosses_as_text(structure):
    compound = structure.compound()
    assert compound.isValid()
    shape = cadquery.Shape.importBrep(_stream(brep_text(compound)))
    volumes = [solid.Volume() for solid in shape.Solids()]
    assert volumes == pytest.approx([part.volume for part in structure.parts], rel=1e-9)


def _stream(text):
    from io import BytesIO

    return BytesIO(text.encode())


def test_a_wedge_has_half_the_volume_of_its_box():
    corners = np.array([(0, 0, 0), (3, 0, 0), (0, 4, 0), (0, 0, 5), (3, 0, 5), (0, 4, 5)]) + 7.0
    sides = (0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)
    assert RuledBody(corners, sides).volume == pytest.approx(3 * 4 * 5 / 2)


def test_the_prism_around_a_tube_ends_in_the_planes_that_cut_it():
    ends = np.array([[2.0, 1.0, 0.5], [3.0, -1.0, 2.0]])
    ends /= np.linalg.norm(ends, axis=1)[:, None]
    tube = RoundTube(np.array([0.0, 10.0, 20.0]), np.array([50.0, 900.0]), ends, 60.0, 4.0)
    for ring, station, normal in zip(
        tube.around().corners.reshape(2, -1, 3), tube.stations, ends, strict=True
    ):
        assert (ring - [station, 10.0, 20.0]) @ normal == pytest.approx(0.0, abs=1e-9)
