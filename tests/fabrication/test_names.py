"""One count: the number in a name is that of the vertex, edge, face or line it belongs to."""

import re
from types import SimpleNamespace

import pytest
import shapely

from freecad_ortho.fabrication import Beams, Panels, build
from freecad_ortho.fabrication.nodes import nodes
from freecad_ortho.fabrication.systems import Nodes
from freecad_ortho.fabrication.systems.beams.frames import edge_name
from freecad_ortho.fabrication.systems.beams.parts import name_after


@pytest.fixture(scope="module")
def joined(roof):
    return build(roof, [Beams(200, 12, ends="hub"), Panels(20, 15), Nodes()])


def number(name):
    return int(re.search(r"\d+", name)[0])


def test_names_have_the_numbers_of_lists_and_messages(joined, roof):
    net = roof.connectivity
    for part in joined.parts:
        if part.kind == "panel":
            assert number(part.name) == part.face
        elif part.kind == "node":
            assert (number(part.name),) == part.vertices
        else:
            chosen = [edge == number(part.name) for edge in range(len(net.edges))]
            first, second = part.vertices
            assert edge_name(roof, chosen) == (
                f"edge {number(part.name)} (vertices {first} and {second})"
            )
    for node in nodes(joined.site, joined.parts):
        assert number(node.name) == node.vertex


def test_beams_are_engraved_with_the_names_of_their_nodes(joined):
    made = {part.name for part in joined.results["nodes"].parts}
    for part in joined.results["beams"].parts:
        texts = {mark.text for mark in part.pattern.marks if mark.text}
        assert texts <= made
        assert {number(text) for text in texts} == set(part.vertices)


def test_plates_along_lines_are_named_after_them(roof):
    structure = build(roof, [Beams(200, 12, ends="lapped")])
    for part in structure.parts:
        assert part.name == f"B-{part.family.upper()}{part.line:03d}"
        engraved = {text for mark in part.pattern.marks for text in mark.text.split()}
        assert {f"N{vertex:04d}" for vertex in part.vertices} <= engraved
        # They stand on the plate, half way up it.
        plate = shapely.Polygon(part.pattern.outline)
        places = [mark.points[0] for mark in part.pattern.marks if mark.text]
        for place in [part.pattern.label, *places]:
            room = plate.exterior.distance(shapely.Point(place))
            assert plate.contains(shapely.Point(place)) and room > 0.4 * 200


def test_a_line_in_several_stretches_has_a_letter_for_each_further_one():
    def named(*names):
        return name_after("V001", [SimpleNamespace(name=name) for name in names])

    assert named("U000", "U001", "V000") == "V001"
    assert named("U000", "U001", "V000", "V001") == "V001b"
    assert named("U000", "U001", "V001", "V001b-1", "V001b-2") == "V001c"
