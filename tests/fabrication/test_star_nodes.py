"""Stars of plates: arms in the planes of their beams, equal cover plates, bolts within reach."""

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.fabrication.bolts import BOLTS, LENGTHS, bolt_of
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.limits import OK
from freecad_ortho.fabrication.report.adjustment import adjustment
from freecad_ortho.fabrication.step import read_step, write_step
from solver.errors import InputError
from tests.fabrication.test_beam_sections_and_ends import assert_closed


@pytest.fixture(scope="module")
def joined(roof):
    """Plates on stars under panels."""
    return api.fabricate(roof, "beams+nodes+panels", node="star")


@pytest.mark.parametrize("bolt", BOLTS.values(), ids=lambda bolt: bolt.name)
def test_bolts_reach_through_plates_and_nut(bolt):
    length = bolt.through(40.0)
    assert length in LENGTHS
    needed = 40.0 + 2 * bolt.washer + bolt.nut + bolt.pitch
    assert needed <= length < needed + 10
    assert 0.79 * bolt.diameter < bolt.nut < bolt.diameter


@pytest.mark.parametrize("name", ["roof", "skewed", "dodecahedron"])
@pytest.mark.parametrize("section", ["plate", "I", "T"])
def test_nothing_clashes_with_default_sizes(meshes, name, section):
    made = api.fabricate(meshes[name], "beams+nodes+panels", node="star", section=section)
    found = check_clashes(made.parts)
    assert found.near > len(made.parts)
    assert (found.clashes, found.open) == ((), ())
    assert not any(part.assembly for part in made.results["nodes"].parts)


def test_solids_are_valid_with_the_volume_of_the_formula(joined, tmp_path):
    parts = [*joined.results["nodes"].parts[::9], *joined.results["beams"].parts[::9]]
    for part in parts:
        whole = part.body.whole
        assert_closed(whole)
        bored = sum(np.pi / 4 * hole.diameter**2 for hole in part.pattern.holes)
        assert part.volume == pytest.approx(whole.volume - bored * part.thickness, rel=1e-12)
    write_step(tmp_path / "star.step", parts)
    for (_, shape), part in zip(read_step(tmp_path / "star.step"), parts, strict=True):
        assert shape.isValid()
        assert shape.Volume() == pytest.approx(part.volume, rel=1e-9)


def holes_of(part):
    """(N, 3) middles of the holes of a part where it is built in."""
    return part.origin + np.array([drill.centre for drill in part.body.drills]) @ part.frame


def test_holes_of_arm_beam_and_cover_plates_are_in_line(joined):
    parts = {part.name: part for part in joined.parts}
    covers = [part for part in parts.values() if part.kind == "cover-plate"]
    assert len(covers) == 4 * len(joined.results["beams"].parts)
    for cover in covers[::11]:
        beam = parts[cover.name.split("-")[0]]
        [vertex] = cover.vertices
        arms = [p for p in parts.values() if p.kind == "node" and p.vertices == (vertex,)]
        behind = np.concatenate([holes_of(part) for part in (beam, *arms)])
        through = cover.frame[2]
        for hole in holes_of(cover):
            apart = behind - hole
            beside = np.linalg.norm(apart - np.outer(apart @ through, through), axis=1)
            assert beside[np.abs(apart @ through) < 30].min() < 1e-6


def test_holes_keep_the_distances_of_the_rules(joined):
    bolt = bolt_of("M16")
    for part in joined.parts:
        if part.kind == "panel":
            continue
        outline = part.pattern.outline
        sides = np.roll(outline, -1, axis=0) - outline
        inward = np.stack([-sides[:, 1], sides[:, 0]], axis=1)
        inward /= np.linalg.norm(inward, axis=1)[:, None]
        places = np.array([hole.centre for hole in part.pattern.holes])
        margins = np.einsum("hsk,sk->hs", places[:, None] - outline, inward)
        assert margins.min() >= bolt.edge - 1e-9
        apart = np.linalg.norm(places[:, None] - places, axis=2)
        assert apart[apart > 0].min() >= bolt.spacing - 1e-9


def test_cover_plates_are_alike_and_listed(joined):
    groups = {part.name for part in joined.results["nodes"].parts if part.kind == "cover-plate"}
    shapes = {
        (part.length, part.width, part.volume)
        for part in joined.results["nodes"].parts
        if part.name in groups
    }
    assert len(shapes) == 1
    bolts, types = joined.results["nodes"].tables
    report = joined.report()["nodes"]
    assert bolts.rows[0][4] == report["bolts"] == 8 * len(joined.results["beams"].parts)
    assert sum(row[1] for row in types.rows) == len(joined.mesh.vertices)
    assert report["different"] == len(types.rows) < len(joined.mesh.vertices)


def test_what_joints_give_on_site_is_said(joined, roof):
    """Holes are 2 mm wider than M16: 1 mm of play each, through both groups of a cover plate."""
    words = adjustment(joined.report()["nodes"])
    assert "1 mm shorter at each end" in words and "move by 2 mm along itself" in words
    bolted = api.fabricate(roof, "beams+nodes", node="bolted").report()["nodes"]
    words = adjustment(bolted)
    assert "takes shims of up to 6 mm" in words and "by 1 mm across" in words
    assert adjustment({"kind": "hub"}) == ""


def test_bolts_that_cannot_be_reached_are_said_in_the_verdict(roof):
    made = api.fabricate(roof, "beams+nodes", node="star", hub_diameter=220.0)
    verdicts = dict(zip((part.name for part in made.parts), made.verdicts, strict=True))
    words = [words for words in verdicts.values() if words != OK]
    assert len(words) == made.report()["nodes"]["not_put_on"] > 0
    assert "the bolts of beam B" in words[0]
    assert "a wrench for M16 needs 27 mm" in " ".join(words)


def test_beams_too_short_for_their_cover_plates_are_refused(roof):
    """Cover plates of both ends would lie on each other."""
    shortest = roof.edge_lengths.min()
    for edge, fits in ((450.0, False), (700.0, True)):
        mesh = roof.scaled(edge / shortest)
        if fits:
            made = api.fabricate(mesh, "beams+nodes", node="star")
            assert check_clashes(made.parts).clashes == ()
        else:
            with pytest.raises(InputError, match=r"beam ends: B.* take .*; with bolts M12 all"):
                api.fabricate(mesh, "beams+nodes", node="star")


@pytest.mark.parametrize(
    "values, words",
    [
        ({"hub_diameter": 100}, "hub: at N.* degrees, where the cover plates of a star of 100 mm"),
        ({"height": 70}, "bolts: the lowest web is .* 2 of M12, the smallest, take 61.2 mm"),
        ({"section": "tube:100x60x5"}, "ends: cover plates join webs of plates, got section tube"),
        ({"bolts": 0}, "bolts: expected a whole number, 1 to 2, got 0"),
        ({"thickness": 100}, "M16 through 200 mm .* holds 127 mm; take thinner plates"),
    ],
)
def test_what_does_not_fit_is_one_line(roof, values, words):
    with pytest.raises(InputError, match=words) as caught:
        api.fabricate(roof, "beams+nodes", node="star", **values)
    assert "\n" not in str(caught.value)


def test_webs_without_room_take_smaller_bolts_and_say_so(roof):
    """Cover plates of 70 mm: 2 of M16 take 83.6 mm, 2 of M12 61.2."""
    made = api.fabricate(roof, "beams+nodes", node="star", height=90.0)
    [words] = [words for words in made.report()["messages"] if "no room for 2 of M16" in words]
    ends = 2 * len(made.results["beams"].parts)
    assert f"all {ends} bolted ends have M12" in words
    assert {row[0] for table in made.results["nodes"].tables[:1] for row in table.rows} == {"M12"}
    assert {hole.diameter for part in made.parts for hole in part.pattern.holes} == {13.0}
    assert not any(part.assembly for part in made.parts)
