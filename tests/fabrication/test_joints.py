"""Parts of several systems beside each other: hubs, panels and beams make room, panels bear."""

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.fabrication import Beams, Panels, build
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.systems import Nodes
from freecad_ortho.fabrication.systems.panels.bearing import bearings
from solver.errors import InputError
from solver.mesh.quadmesh import QuadMesh
from tests.conftest import demo_roof, grid_faces, shared_mesh, wavy_grid
from tests.fabrication.test_beam_sections_and_ends import assert_closed


@pytest.fixture(scope="module")
def plane():
    x, y = np.meshgrid(np.arange(4.0), np.arange(4.0), indexing="ij")
    points = 1000 * np.stack([x, y, 0 * x], axis=-1)
    return QuadMesh(points.reshape(-1, 3), grid_faces(4, 4))


@pytest.fixture(scope="module", params=["cut", "lift"])
def joined(request, roof):
    """With the hubs that a demanding roof of these edges takes."""
    return api.fabricate(roof, "beams+nodes+panels", at_hubs=request.param, hub_diameter=140.0)


def test_hubs_beams_and_panels_do_not_clash(joined):
    found = check_clashes(joined.parts)
    assert found.near > len(joined.parts)
    assert (found.clashes, found.open) == ((), ())


def test_panels_at_hubs_are_closed_solids(joined):
    for part in joined.results["panels"].parts[::5]:
        assert_closed(part.body)
        assert part.solid().isValid()
        assert part.solid().Volume() == pytest.approx(part.volume)
        assert part.volume == pytest.approx(part.area * part.thickness)


def test_corners_are_cut_or_panels_lifted(roof):
    cut = api.fabricate(roof, "beams+nodes+panels").results["panels"]
    lifted = api.fabricate(roof, "beams+nodes+panels", at_hubs="lift").results["panels"]
    alone = api.fabricate(roof, "beams+panels", ends="hub").results["panels"]
    assert cut.report["corners_cut"] > len(cut.parts)
    assert lifted.report["corners_cut"] == alone.report["corners_cut"] == 0
    assert cut.report["lift_max_mm"] == pytest.approx(alone.report["lift_max_mm"])
    assert lifted.report["lift_max_mm"] > alone.report["lift_max_mm"] + 1
    assert max(len(part.pattern.outline) for part in cut.parts) > 4


def test_panels_beside_hubs_alone_have_their_corners_cut_off(roof):
    made = api.fabricate(roof, "nodes+panels", at_hubs="lift")
    assert made.report()["panels"]["corners_cut"] > 0
    assert check_clashes(made.parts).clashes == ()


def test_hubs_that_take_whole_sides_lift_the_panels_or_are_refused(roof, plane):
    made = api.fabricate(roof, "beams+nodes+panels", hub_diameter=620.0)
    report = made.report()
    lifted = report["panels"]["lifted_over_hubs"]
    assert 0 < lifted < len(roof.faces)
    assert f"panels: {lifted} are lifted over hubs" in " ".join(report["messages"])
    assert check_clashes(made.parts).clashes == ()
    with pytest.raises(InputError, match="nothing of a side of the panel in face 0; take smaller"):
        build(plane, [Nodes("hub", 940), Panels(12, 8)])


def test_panels_lie_on_hubs_that_are_flush(plane):
    report = api.fabricate(plane, "beams+nodes+panels").report()["panels"]
    assert (report["corners_cut"], report["lifted_over_hubs"]) == (0, 0)
    assert report["lift_max_mm"] == pytest.approx(0, abs=1e-6)


def test_nodes_take_their_sizes_from_the_beams(roof):
    beams = Beams(160, 20, "above", ends="hub", hub_diameter=160)
    made = build(roof, [beams, Nodes("hub", 100, height=300)])
    assert {part.width for part in made.results["nodes"].parts} == {160}
    heights = [part.length for part in made.results["nodes"].parts]
    assert np.mean(heights) == pytest.approx(160, rel=0.05)
    assert check_clashes(made.parts).clashes == ()
    # The beams stand a millimetre before the faces, no more.
    beam, node = made.parts[0], made.results["nodes"].parts[made.parts[0].vertices[0]]
    assert beam.solid().distance(node.solid()) == pytest.approx(1.0, abs=0.1)


def test_what_does_not_fit_is_refused_in_words(roof):
    for system, sizes, words in (
        (
            "beams+nodes",
            {"ends": "mitred"},
            "nodes: the beams are mitred and leave no room for hubs",
        ),
        ("beams+nodes", {"node": "socket", "ends": "hub"}, "sockets hold plates that reach"),
        ("beams+nodes", {"node": "socket", "section": "hollow"}, "sockets hold plates"),
        ("nodes+lamellas", {}, "lamellas run through their crossings"),
        ("nodes+patches", {}, "the sheets run over the nodes"),
        ("beams+panels", {"at_hubs": "bend"}, "at hubs: expected cut or lift"),
    ):
        with pytest.raises(InputError, match=words):
            api.fabricate(roof, system, **sizes)


@pytest.mark.parametrize(("thickness", "gap"), [(20, 8), (60, 8), (20, 40), (20, 20), (12, 10)])
@pytest.mark.parametrize("edge", ["square", "bevel"])
def test_bearing_on_a_plane_in_closed_form(plane, thickness, gap, edge):
    made = build(plane, [Beams(200, thickness), Panels(12, gap, edge=edge)])
    for part in made.results["panels"].parts:
        assert part.measures.bearing_mm == pytest.approx(thickness / 2 - gap / 2)
    verdicts = dict(zip((part.name for part in made.parts), made.verdicts, strict=True))
    if thickness / 2 - gap / 2 >= 5:
        assert set(verdicts.values()) == {"ok"}
        assert made.report()["messages"] == []
    else:
        assert "steel needs 5 mm of bearing" in verdicts["P0000"]
        assert ("beside a beam" in verdicts["P0000"]) == (gap == 40)
        # Half of a beam that is 9 mm wider, less what panels may rise on it.
        wider = "beams 9 mm thicker" if thickness == 12 else "thicker beams"
        assert f"take a smaller gap, {wider}" in " ".join(made.report()["messages"])


def test_glass_needs_more_bearing_than_steel(plane):
    for material, passes in (("steel", True), ("panels=glass", False)):
        made = api.fabricate(plane, "beams+panels", material=material)
        assert (not made.report()["verdict"]["failed"]) == passes


def test_bearing_is_what_the_solids_overlap_by(roof):
    """Each panel's lower edge against the beam's side, from the parts alone."""
    made = build(roof, [Beams(200, 30), Panels(12, 8)])
    beams = made.results["beams"].parts
    for panel in made.results["panels"].parts:
        widths = []
        under = panel.points[:4]
        for side, edge in enumerate(roof.connectivity.face_edges[panel.face].tolist()):
            ends = np.stack([under[side], under[(side + 1) % 4]])
            along = np.linspace(0, 1, 2001)[:, None]
            local = (ends[0] + along * (ends[1] - ends[0]) - beams[edge].origin) @ (
                beams[edge].frame.T
            )
            inner = np.sign(((under.mean(axis=0) - beams[edge].origin) @ beams[edge].frame.T)[2])
            top = beams[edge].body.corners[6:]
            reach = top[np.sign(top[:, 2]) == inner][:, 0]
            over = (local[:, 0] >= reach.min()) & (local[:, 0] <= reach.max())
            widths.append(15 - (inner * local[over, 2]).max())
        assert panel.measures.bearing_mm == pytest.approx(min(widths), abs=0.02)


def test_bearing_of_sides_askew_to_their_beams_is_least_where_the_beams_end(plane):
    """Sides that reach 500 mm beyond both ends of their edges, from on it to 10 mm beside it."""
    made = build(plane, [Beams(200, 20)])
    net, beams = plane.connectivity, made.results["beams"].geometry
    corner = made.site.mesh.vertices[plane.faces]
    ahead = (np.roll(corner, -1, axis=1) - corner) / 1000
    inwards = np.cross([0.0, 0, 1], ahead)
    sides = np.stack([corner - 500 * ahead, corner + 1500 * ahead + 10 * inwards], axis=2)
    found = bearings(net, beams, sides)
    inside = ~net.boundary_edges[net.face_edges]
    whole = inside & ~net.boundary_vertices[np.roll(plane.faces, -1, axis=1)]
    assert whole.sum() > 4
    # Four beams meet at the end: each is cut back there by half its width.
    assert found[whole] == pytest.approx(10 - 10 * (1500 - 10) / 2000)


def test_panels_without_beams_on_two_sides_bear_on_nothing(roof):
    made = api.fabricate(roof, "beams+panels", family="u", lines=[0])
    bearing = [part.measures.bearing_mm for part in made.results["panels"].parts]
    assert max(bearing) <= 0
    assert "ends 0 mm beside" not in " ".join(made.verdicts)


@pytest.mark.parametrize("sizes", [{}, {"panel_edge": "bevel"}, {"at_hubs": "lift"}])
def test_the_clear_gap_is_the_distance_of_the_solids(roof, sizes):
    made = api.fabricate(roof, "beams+nodes+panels", **sizes)
    panels = made.results["panels"].parts
    left, right = roof.connectivity.edge_faces[~roof.connectivity.boundary_edges].T
    pairs = zip(left.tolist(), right.tolist(), strict=True)
    nearest = min(panels[i].solid().distance(panels[j].solid()) for i, j in pairs)
    said = made.report()["panels"]["clear_gap_min_mm"]
    assert said <= nearest + 1e-6
    assert said == pytest.approx(nearest, abs=0.02)


def test_the_clear_gap_of_faces_that_are_not_planar():
    """The two sides of a joint rise differently: the plates are no nearer for that."""
    net = wavy_grid(4, 6, shear=0.25, height=0.2)
    net = net.scaled(1000 / net.mean_edge)
    made = api.fabricate(net, "beams+panels")
    panels = made.results["panels"].parts
    pairs = net.connectivity.edge_faces[~net.connectivity.boundary_edges].tolist()
    nearest = min(panels[i].solid().distance(panels[j].solid()) for i, j in pairs)
    said = made.report()["panels"]["clear_gap_min_mm"]
    assert said <= nearest + 1e-6
    assert said == pytest.approx(nearest, abs=0.005)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["heart", "conical1", "botanic-garden-bubble-0", "demo roof"])
def test_defaults_are_sound_on_real_nets(name):
    mesh = demo_roof() if name == "demo roof" else shared_mesh(name)
    mesh = mesh if name == "demo roof" else mesh.scaled(1000 / mesh.mean_edge)
    made = api.fabricate(api.optimise(mesh, net="principal").mesh, "beams+nodes+panels")
    assert made.report()["verdict"]["failed"] == {}
    assert check_clashes(made.parts).clashes == ()
