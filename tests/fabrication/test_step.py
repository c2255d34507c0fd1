"""STEP files: small, whole, the same every time; shared geometry loses nothing."""

import re
from collections import Counter

import numpy as np
import pytest
from OCP.Interface import Interface_Static
from scipy.spatial import cKDTree

from freecad_ortho.fabrication import Beams, Lamellas, Panels, Workshop, build
from freecad_ortho.fabrication.bodies import BOX_SIDES, Polyhedron
from freecad_ortho.fabrication.material import MATERIALS
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.pattern import FlatPattern
from freecad_ortho.fabrication.place import Place
from freecad_ortho.fabrication.site import Selection
from freecad_ortho.fabrication.step import read_step, write_step
from freecad_ortho.fabrication.step_text import compacted
from solver.errors import InputError, OrthoError
from tests.meshes import helicoid


def plate(ring, name):
    """A plate of 10 mm of a plane outline (4, 3)."""
    body = Polyhedron(np.concatenate([ring, ring + [0, 0, 10.0]]), BOX_SIDES)
    pattern = FlatPattern(ring[:, :2], (), np.zeros(2), 1.0)
    origin = np.array([10.0, 20.0, 30.0])
    return Part(
        *(name, "panel", body, origin, np.eye(3), pattern, 900.0, 400.0, 10.0, 1.0, body.volume),
        MATERIALS["steel"],
    )


def entities(path):
    return re.findall(rb"#(\d+)=([^;]*);\n", path.read_bytes())


@pytest.fixture(scope="module")
def twisted_lamellas():
    net = helicoid(rows=9, columns=7).scaled(1000.0)
    return build(net, [Lamellas(width=40, thickness=4, layers=2, strip="twisted")]).parts[:4]


def test_files_are_in_mm_whatever_unit_the_kernel_was_set_to(tmp_path):
    ring = np.array([[0, 0, 0], [900.0, 0, 0], [900, 400, 0], [0, 400, 0]])
    before = Interface_Static.CVal_s("xstep.cascade.unit")
    write_step(tmp_path / "plain.step", [plate(ring, "P0000")])
    try:
        assert Interface_Static.SetCVal_s("xstep.cascade.unit", "M")
        write_step(tmp_path / "set.step", [plate(ring, "P0000")])
        ((name, shape),) = read_step(tmp_path / "set.step")
    finally:
        Interface_Static.SetCVal_s("xstep.cascade.unit", before)
    text = (tmp_path / "set.step").read_text()
    assert text == (tmp_path / "plain.step").read_text()
    assert re.findall(r"SI_UNIT\((\S+?),\.METRE\.\)", text) == [".MILLI."]
    # Who wrote it and for whom is not said.
    head = "".join(text.partition("ENDSEC;")[0].split())
    assert "FILE_NAME('structure','2000-01-01T00:00:00',(''),('')," in head
    box = shape.BoundingBox()
    assert name == "P0000"
    assert (box.xlen, box.ylen, box.zlen) == pytest.approx((900, 400, 10))
    assert (box.xmin, box.ymin, box.zmin) == pytest.approx((10, 20, 30))


@pytest.mark.parametrize("text", ["", "half a file", "ISO-10303-21;\nHEADER;"])
def test_a_file_that_is_none_is_refused(tmp_path, text):
    (tmp_path / "broken.step").write_text(text)
    with pytest.raises(OrthoError, match=r"broken\.step: cannot be read back as STEP"):
        read_step(tmp_path / "broken.step")


def test_beams_take_a_third_of_what_the_kernel_writes(roof, tmp_path):
    """With curves in the parameters of planes they were 24 kB each, now less than 8 kB."""
    parts = build(roof, [Beams(200, 12)]).parts
    write_step(tmp_path / "beams.step", parts, shared_within=0)
    assert (tmp_path / "beams.step").stat().st_size < 8150 * len(parts)
    kinds = Counter(
        re.match(rb"\(?\s*(\w+)", body)[1] for _, body in entities(tmp_path / "beams.step")
    )
    assert not kinds[b"PCURVE"] and not kinds[b"SURFACE_CURVE"]
    # Each solid has its own corners and edges.
    assert kinds[b"VERTEX_POINT"] == 12 * len(parts) and kinds[b"EDGE_CURVE"] == 18 * len(parts)
    assert kinds[b"CARTESIAN_POINT"] < 14 * len(parts)


def corners(shape):
    return np.array([vertex.toTuple() for vertex in shape.Vertices()])


@pytest.mark.parametrize("within", [0.0, 0.001, 0.5])
def test_equal_parts_are_one_product_in_several_places(roof, tmp_path, within):
    """The roof has a plane of symmetry and rings of equal faces; each part is found by its name."""
    parts = build(roof, [Beams(200, 12), Panels(20, 15)]).parts
    write_step(tmp_path / "roof.step", parts, shared_within=within)
    products = (tmp_path / "roof.step").read_bytes().count(b"=PRODUCT(") - 1
    assert products == len(parts) if not within else products < 0.9 * len(parts)
    read = read_step(tmp_path / "roof.step")
    assert [name for name, _ in read] == [part.name for part in parts]
    for (_, solid), part in zip(read, parts, strict=True):
        one, other = corners(solid), part.points
        assert cKDTree(one).query(other)[0].max() <= within + 1e-6
        assert cKDTree(other).query(one)[0].max() <= within + 1e-6
        assert solid.isValid() and solid.Volume() > 0


def test_mirror_images_share_no_product(tmp_path):
    """A placement turns and moves; what is mirrored is another solid."""
    prism = np.array([[0, 0, 0], [900, 0, 0], [700, 300, 0], [0, 400, 0]], float)
    one = plate(prism, "B0000")
    turned = plate(prism @ np.array([[-1, 0, 0], [0, -1, 0], [0, 0, 1]]), "B0001")
    mirrored = plate((prism * [-1, 1, 1])[::-1], "B0002")
    write_step(tmp_path / "three.step", [one, turned, mirrored], shared_within=0.001)
    assert (tmp_path / "three.step").read_bytes().count(b"=PRODUCT(") == 1 + 2
    for (_, solid), part in zip(
        read_step(tmp_path / "three.step"), [one, turned, mirrored], strict=True
    ):
        assert cKDTree(corners(solid)).query(part.points)[0].max() < 1e-6


def test_parts_in_place_have_the_coordinates_of_the_structure_and_no_places(roof, tmp_path):
    """Whoever looks each component up among all products, as FreeCAD does, has nothing to look."""
    some = Selection(lines=(2, 3))
    parts = build(roof, [Beams(200, 12), Lamellas(40, 3)], selection=some).parts
    turned = Place(np.array([[0, -1.0, 0], [1, 0, 0], [0, 0, 1]]), np.array([1e4, 0, 5.0]))
    for place in (Place(), turned):
        write_step(tmp_path / "roof.step", parts, place, in_place=True)
        text = (tmp_path / "roof.step").read_bytes()
        assert text.count(b"=PRODUCT(") == len(parts)
        assert b"NEXT_ASSEMBLY" not in text and b"ITEM_DEFINED_TRANSFORMATION" not in text
        for (name, solid), part in zip(read_step(tmp_path / "roof.step"), parts, strict=True):
            assert name == part.name and solid.wrapped.Location().IsIdentity()
            stands = place.points(part.points)
            assert cKDTree(stands).query(corners(solid))[0].max() <= 1e-6
            assert solid.isValid() and solid.Volume() == pytest.approx(part.volume, rel=1e-6)
    with pytest.raises(InputError, match=r"stand 500 km from the origin.*local origin"):
        far = Place(origin=np.array([5e8, 0, 0]))
        write_step(tmp_path / "far.step", parts, far, in_place=True)
    with pytest.raises(InputError, match="in-place share no product; leave the step tolerance out"):
        Workshop(step="in-place", step_tolerance=0.001)


def test_a_tolerance_beyond_that_of_lists_is_refused():
    with pytest.raises(InputError, match=r"step tolerance: expected 0 to 0\.5 mm, got 2"):
        Workshop(step_tolerance=2.0)


def test_no_geometry_is_written_twice_and_numbers_run_on(structure, tmp_path):
    write_step(tmp_path / "all.step", structure.parts)
    found = entities(tmp_path / "all.step")
    assert [int(number) for number, _ in found] == list(range(1, len(found) + 1))
    shared = [
        body for _, body in found if body.startswith((b"CARTESIAN_POINT", b"DIRECTION", b"LINE"))
    ]
    assert len(set(shared)) == len(shared)
    used = {int(number) for _, body in found for number in re.findall(rb"#(\d+)", body)}
    assert used <= set(range(1, len(found) + 1))


@pytest.mark.parametrize("in_place", [False, True])
def test_every_shape_stands_on_a_placement_of_its_own(structure, tmp_path, in_place):
    """OpenCASCADE goes through all that refers to it: shared by all, time would grow by squares."""
    write_step(tmp_path / "all.step", structure.parts, in_place=in_place)
    found = dict(entities(tmp_path / "all.step"))
    refers = {number: re.findall(rb"#(\d+)", body) for number, body in found.items()}
    shapes = {
        number: {k for k in refers[number] if found[k].startswith(b"AXIS2_PLACEMENT_3D")}
        for number, body in found.items()
        if re.match(rb"(ADVANCED_BREP_)?SHAPE_REPRESENTATION", body)
    }
    stands = Counter(k for placements in shapes.values() for k in placements)
    assert len(shapes) == len(structure.parts) + (not in_place)
    assert set(stands.values()) == {1}
    moves = [number for number, body in found.items() if b"_WITH_TRANSFORMATION(" in body]
    assert len(moves) == (0 if in_place else len(structure.parts))
    for part, whole, move in map(refers.get, moves):
        start, end = refers[move]
        assert start in shapes[part] and end in shapes[whole]


def test_twisted_lamellas_are_valid_and_small_without_flat_curves(twisted_lamellas, tmp_path):
    write_step(tmp_path / "lamellas.step", twisted_lamellas)
    assert b"PCURVE" not in (tmp_path / "lamellas.step").read_bytes()
    read = read_step(tmp_path / "lamellas.step")
    assert [name for name, _ in read] == [part.name for part in twisted_lamellas]
    for (_, solid), part in zip(read, twisted_lamellas, strict=True):
        assert solid.isValid()
        assert solid.Volume() == pytest.approx(part.volume, rel=1e-4)


def test_equal_geometry_is_one_and_topology_is_not():
    text = b"""ISO-10303-21;
HEADER;
ENDSEC;
DATA;
#1 = VERTEX_POINT('',#3);
#2 = VERTEX_POINT('a #3; b',#4);
#3 = CARTESIAN_POINT('',(1.E+03,-0.,
    2.5E-02));
#4 = CARTESIAN_POINT('',(1000.,0.,0.025));
#5 = LINE('',#3,#7);
#6 = LINE('',#4,#8);
#7 = VECTOR('',#9,1.);
#8 = VECTOR('',#10,1.);
#9 = DIRECTION('',(0.,0.,1.));
#10 = DIRECTION('',(0.,1.E-17,1.));
#11 = EDGE_CURVE('',#1,#2,#6,.T.);
ENDSEC;
END-ISO-10303-21;
"""
    assert (
        compacted(text)
        == b"""ISO-10303-21;
HEADER;
ENDSEC;
DATA;
#1=VERTEX_POINT('',#3);
#2=VERTEX_POINT('a #3; b',#3);
#3=CARTESIAN_POINT('',(1000.,0.,0.025));
#4=LINE('',#3,#5);
#5=VECTOR('',#6,1.);
#6=DIRECTION('',(0.,0.,1.));
#7=EDGE_CURVE('',#1,#2,#4,.T.);
ENDSEC;
END-ISO-10303-21;
"""
    )


def test_products_have_colours_and_layers(roof, tmp_path):
    from OCP.Quantity import Quantity_Color
    from OCP.STEPCAFControl import STEPCAFControl_Reader
    from OCP.TCollection import TCollection_ExtendedString
    from OCP.TDF import TDF_LabelSequence
    from OCP.TDocStd import TDocStd_Document
    from OCP.XCAFDoc import XCAFDoc_ColorType, XCAFDoc_DocumentTool

    material = {"beams": MATERIALS["steel"], "panels": MATERIALS["glass"]}
    some = Selection(family="u", lines=(3,))
    parts = build(roof, [Beams(200, 20), Panels(12, 10)], material=material, selection=some).parts
    write_step(tmp_path / "painted.step", parts)
    document = TDocStd_Document(TCollection_ExtendedString("BinXCAF"))
    reader = STEPCAFControl_Reader()
    reader.SetColorMode(True)
    reader.SetLayerMode(True)
    reader.ReadFile(str(tmp_path / "painted.step"))
    assert reader.Transfer(document)
    shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    colours = XCAFDoc_DocumentTool.ColorTool_s(document.Main())
    layers = XCAFDoc_DocumentTool.LayerTool_s(document.Main())
    labels = TDF_LabelSequence()
    shapes.GetShapes(labels)
    found = Counter()
    for number in range(1, labels.Length() + 1):
        label, colour = labels.Value(number), Quantity_Color()
        if not shapes.IsSimpleShape_s(label):
            continue
        named = layers.GetLayers(label)
        (layer,) = (named.Value(k).ToExtString() for k in range(1, named.Length() + 1))
        shape = shapes.GetShape_s(label)
        kinds = (XCAFDoc_ColorType.XCAFDoc_ColorGen, XCAFDoc_ColorType.XCAFDoc_ColorSurf)
        assert any(colours.GetColor(shape, kind, colour) for kind in kinds)
        found[layer, round(colour.Red(), 3) < round(colour.Blue(), 3)] += 1
    kinds = Counter(part.kind for part in parts)
    assert found == {(kind, True): count for kind, count in kinds.items()}
