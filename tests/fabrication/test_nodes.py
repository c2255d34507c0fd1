"""Hubs and sockets: faces square to the beams, no clash, equal ones grouped, printable."""

import numpy as np
import pytest
from scipy.spatial import ConvexHull

from freecad_ortho import api
from freecad_ortho.fabrication import Beams, build
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.files import write
from freecad_ortho.fabrication.systems import Nodes
from freecad_ortho.fabrication.systems.nodes.hubs import hub
from freecad_ortho.fabrication.systems.nodes.sockets import least_radius, socket
from freecad_ortho.fabrication.systems.panels.hubs import Stands, corner_cuts
from freecad_ortho.fabrication.systems.panels.planes import Planes
from solver.errors import InputError
from solver.mesh.quadmesh import QuadMesh
from tests.fabrication.conftest import grid_faces
from tests.fabrication.test_beam_sections_and_ends import assert_closed

HUBS = Nodes("hub", 120, bore=20, height=160, thickness=10)
SOCKETS = Nodes("socket", 90, height=160, thickness=10)


def test_square_hub_in_closed_form():
    body = hub(np.radians([0, 90, 180, 270]), 50, -10, 30, 20)
    assert body.volume == pytest.approx((100**2 - np.pi * 10**2) * 40)
    assert body.solid().Volume() == pytest.approx(body.volume)
    assert np.abs(body.outline) == pytest.approx(50)


def test_a_straight_corner_of_a_panel_is_cut_square_to_its_sides():
    triangle = np.array([[0.0, 0, 0], [1000, 0, 0], [2000, 0, 0], [1000, 1500, 0]])
    planes = Planes.of(QuadMesh(triangle, np.array([[2, 3, 0, 1]])))
    square = np.array([[-50.0, -50, 0], [50, -50, 0], [50, 50, 0], [-50, 50, 0]])
    hub = np.stack([square - [0, 0, 90], square + [0, 0, 90]]) + triangle[1]
    found = corner_cuts(planes, np.array([[0.0], [10.0]]), Stands({1: hub}, True, 3.0))
    inwards = found.inwards[0, 3] @ planes.frame[0, :2]
    np.testing.assert_allclose(inwards, [0.0, 1.0, 0.0], atol=1e-12)
    # The panel begins 3 mm beyond the hub, 50 mm from its side; its middle is 375 mm from there.
    assert found.begins[0, 3] == pytest.approx(53.0 - 375.0)
    assert np.isneginf(found.begins[0, :3]).all()


@pytest.mark.parametrize(
    "degrees", [[0], [0, 180], [30, 230], [150, 290], [0, 95, 170], [0, 60, 130, 200, 290]]
)
def test_socket_is_a_disc_with_pillars(degrees):
    angles, half = np.radians(degrees), 4.0
    body = socket(angles, 40.0, half, np.array([-10.0, 0.0, 25.0]))
    assert_closed(body)
    solid = body.solid()
    assert solid.isValid()
    assert solid.Volume() == pytest.approx(body.volume)
    heights = body.corners[:, 2]
    assert set(heights) == {-10.0, 0.0, 25.0}
    # For the clash check it is convex blocks that fill it.
    assert sum(block.volume for block in body.blocks) == pytest.approx(body.volume)
    for block in body.blocks:
        assert ConvexHull(block.corners).volume == pytest.approx(block.volume)
    # Nothing of a pillar stands in a slot.
    for angle in angles:
        along = np.array([np.cos(angle), np.sin(angle)])
        for block in body.blocks[1:]:
            ahead = block.corners[:, :2] @ along
            beside = block.corners[:, :2] @ [-along[1], along[0]]
            inside = (np.abs(beside) < half - 1e-9) & (ahead > 1e-9)
            assert not inside.any()
    assert least_radius(angles, half) < 40


@pytest.mark.parametrize("name", ["roof", "skewed", "dodecahedron"])
@pytest.mark.parametrize("ends, nodes", [("hub", HUBS), ("lapped", SOCKETS)])
def test_no_clash_with_the_beams(meshes, name, ends, nodes):
    beams = Beams(160, 10, ends=ends, hub_diameter=120)
    made = build(meshes[name], [beams, nodes])
    joints = made.results["nodes"].parts
    assert [part.name for part in joints] == [
        f"N{vertex:04d}" for vertex in range(len(meshes[name].vertices))
    ]
    for part in joints[::7]:
        assert part.solid().isValid()
        assert part.solid().Volume() == pytest.approx(part.volume)
    found = check_clashes(made.parts)
    assert found.near > len(joints)
    assert found.clashes == ()


def test_beams_stand_on_the_faces_of_hubs(skewed):
    made = build(skewed, [Beams(160, 10, ends="hub", hub_diameter=120, clearance=2), HUBS])
    beams, hubs = made.results["beams"].parts, made.results["nodes"].parts
    for beam in beams[::9]:
        for vertex in beam.vertices:
            points = (beam.points - hubs[vertex].origin) @ hubs[vertex].frame.T
            outline = hubs[vertex].body.outline
            side = np.roll(outline, -1, axis=0) - outline
            normal = np.stack([side[:, 1], -side[:, 0]], axis=1)
            normal /= np.linalg.norm(normal, axis=1)[:, None]
            apart = (points[:, None, :2] - outline) @ np.eye(2)
            distance = np.einsum("pfk,fk->pf", apart, normal).min(axis=0)
            assert np.isclose(distance, 2).any()  # parallel to a face, the clearance away


def test_equal_nodes_are_one_file(tmp_path):
    """On a flat square grid all hubs are cubes alike; sockets differ inside, at rim and corners."""
    import trimesh

    x, y = np.meshgrid(800.0 * np.arange(4), 800.0 * np.arange(5), indexing="ij")
    flat = QuadMesh(np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3), grid_faces(4, 5)[:, ::-1])
    for nodes, groups in ((HUBS, [20]), (SOCKETS, [4, 6, 10])):
        made = build(flat, [nodes])
        report = made.report()["nodes"]
        assert report["different"] == len(groups)
        assert sorted(len(some) for some in report["equal"].values()) == groups
        files = write(made, tmp_path / nodes.kind)
        printed = [path for path in files if path.suffix == ".stl"]
        assert [path.stem for path in printed] == list(report["equal"])
        for path, part in zip(printed, made.results["nodes"].joints, strict=True):
            surface = trimesh.load(path)
            assert surface.is_watertight
            assert surface.volume == pytest.approx(part.volume, rel=2e-3)
            assert surface.bounds[0, 2] == pytest.approx(0)


@pytest.mark.parametrize(
    "values, words",
    [
        ({"node": "glue"}, "node: expected hub, bolted, star, ball, through or socket, got 'glue'"),
        ({"hub_diameter": 6}, "hub: N0000 has .* take at least .* mm hub diameter"),
        ({"hub_diameter": 12, "node": "socket"}, "hub: the socket N0000 leaves no pillars"),
        ({"bore": 99}, "bore: expected 0 to 80 mm in a hub of 100 mm, got 99"),
        ({"socket_depth": -1}, "socket depth: expected a number above 0 mm"),
    ],
)
def test_joints_that_do_not_fit_are_one_line(roof, values, words):
    with pytest.raises(InputError, match=words) as caught:
        api.fabricate(roof, "nodes", **values)
    assert "\n" not in str(caught.value)
