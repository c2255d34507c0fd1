"""Exact sides, bolts, assemblies and profiles of bars in IFC, read by IfcOpenShell."""

import csv

import numpy as np
import pytest

from freecad_ortho.fabrication import Beams, Lamellas, Workshop, build, write
from freecad_ortho.fabrication.exchange.assembly import write_assembly
from freecad_ortho.fabrication.exchange.ifc import write_ifc
from freecad_ortho.fabrication.place import Place
from freecad_ortho.fabrication.production import produce
from freecad_ortho.fabrication.site import Selection
from freecad_ortho.fabrication.systems.nodes import Nodes
from solver import QuadMesh
from tests.fabrication.test_exchange import needed


@needed
def test_bent_sides_are_exact_in_ifc_by_choice(tmp_path):
    """Bent lamellas and round tubes whose ends are cut; solids as the CAD kernel reads them."""
    import io

    import cadquery
    import ifcopenshell
    import ifcopenshell.validate
    from ifcopenshell import geom, ifcopenshell_wrapper

    x, y = np.meshgrid([0.0, 900, 1900], [0.0, 1000], indexing="ij")
    points = np.stack([x, y, 300 - (x - 900) ** 2 / 4e3 + y / 20], axis=-1)
    mesh = QuadMesh(points.reshape(-1, 3), np.array([[0, 2, 3, 1], [2, 4, 5, 3]]))
    settings = geom.settings()
    settings.set("iterator-output", ifcopenshell_wrapper.SERIALIZED)
    settings.set("reorient-shells", True)
    for system in (Lamellas(60, 4, smooth=True, hole=9), Beams(200, 20, section="chs:88.9x5")):
        job = build(mesh, [system])
        path = tmp_path / "structure.ifc"
        write_ifc(path, produce(job, Workshop(ifc_parts="exact")), "bent", lambda done: None)
        model = ifcopenshell.open(path)
        log = ifcopenshell.validate.json_logger()
        ifcopenshell.validate.validate(model, log, express_rules=True)
        assert log.statements == []
        products = {each.Name: each for each in model.by_type("IfcElement") if each.Tag}
        for part in job.parts[::3]:
            (shape,) = products[part.name].Representation.Representations
            assert shape.RepresentationType == "AdvancedBrep"
            made = geom.create_shape(settings, products[part.name])
            text = made.geometry.brep_data
            (solid,) = cadquery.Shape.importBrep(io.BytesIO(text.encode())).Solids()
            assert solid.isValid()
            # In metres.
            assert solid.Volume() * 1e9 == pytest.approx(part.volume, rel=1e-6)
            assert len(solid.Faces()) == len(part.solid().Faces())


@needed
def test_bolts_stand_in_ifc_where_they_are(roof, tmp_path):
    """On a storey, in the assembly of their nodes; volumes by formula, places from the list."""
    import ifcopenshell
    import ifcopenshell.validate
    from ifcopenshell import geom
    from ifcopenshell.util import element as elements
    from ifcopenshell.util import shape as shapes

    some = Selection(family="u", lines=(2, 3))
    place = Place(np.eye(3), np.array([1e4, -2e4, 500.0]))
    job = build(
        roof, [Beams(200, 20, ends="end-plate"), Nodes("bolted")], selection=some, place=place
    )
    path = tmp_path / "structure.ifc"
    write_ifc(path, produce(job), "bolts", lambda done: None)
    model = ifcopenshell.open(path)
    log = ifcopenshell.validate.json_logger()
    ifcopenshell.validate.validate(model, log, express_rules=True)
    assert log.statements == []
    (bolts,) = job.fasteners
    found = model.by_type("IfcMechanicalFastener")
    assert len(found) == bolts.count > 40
    (kind,) = model.by_type("IfcMechanicalFastenerType")
    size = bolts.bolt
    hexagon = size.corners**2 * np.sqrt(27) / 8
    ring = np.pi * (size.washer_width**2 - (size.diameter + 1) ** 2) / 4
    volume = hexagon * size.head + np.pi / 4 * size.diameter**2 * bolts.length
    volume += bolts.washers * ring * size.washer
    assert not bolts.nut
    settings = geom.settings()
    settings.set("use-world-coords", True)
    rows = zip(found, bolts.places, bolts.directions, bolts.joins, strict=True)
    for each, point, way, joins in list(rows)[::9]:
        assert each.ObjectType == kind.Name == bolts.name
        assert each.Description == f"joins {', '.join(joins)}"
        assert elements.get_container(elements.get_aggregate(each)).is_a("IfcBuildingStorey")
        assert elements.get_psets(kind)["Ortho_Fastener"]["Grip_mm"] == bolts.grip
        made = geom.create_shape(settings, each)
        assert shapes.get_volume(made.geometry) * 1e9 == pytest.approx(volume, rel=0.02)
        points = shapes.get_vertices(made.geometry) * 1000 - job.place.points(point)
        np.testing.assert_allclose((points @ way).min(), -size.head, rtol=0, atol=1e-3)
        np.testing.assert_allclose((points @ way).max(), bolts.length, rtol=0, atol=1e-3)


@needed
@pytest.mark.parametrize("by", ["lines", "rings"])
def test_assemblies_in_ifc_are_lines_or_rings(roof, tmp_path, by):
    """As the sequences of assembly have them; bolts stand with what they join."""
    import ifcopenshell
    import ifcopenshell.validate
    from ifcopenshell.util import element as elements

    job = build(
        roof,
        [Beams(200, 20, ends="end-plate"), Nodes("bolted")],
        selection=Selection(lines=(2, 3, 4)),
    )
    shop = Workshop(ifc_assemblies=by)
    files = [tmp_path / name / "some.ifc" for name in ("once", "twice")]
    for file in files:
        file.parent.mkdir()
        write_ifc(file, produce(job, shop), "some", lambda done: None)
    assert files[0].read_bytes() == files[1].read_bytes()
    write_assembly(tmp_path / "assembly", produce(job), "some", lambda done: None)
    with (tmp_path / "assembly" / f"sequence-by-{by[:-1]}.csv").open(newline="") as stream:
        rows = {row["name"]: row for row in csv.DictReader(stream)}
    model = ifcopenshell.open(files[0])
    log = ifcopenshell.validate.json_logger()
    ifcopenshell.validate.validate(model, log)
    assert log.statements == []
    found = {each.Name: each for each in model.by_type("IfcElement") if each.Tag}
    assert set(found) == {part.name for part in job.parts}
    homes = {name: elements.get_aggregate(each).Name for name, each in found.items()}
    assert len(set(homes.values())) > 1
    for part in job.parts:
        row = rows[part.name]
        if by == "lines" and row["line"]:
            assert homes[part.name] == f"line {row['family']}{row['line']}"
        elif by == "rings" and "-" not in part.name:
            assert homes[part.name] == f"ring {row['ring']}"
        # End plates stand with their beam.
        assert homes[part.name] == homes.get(part.name.split("-")[0], homes[part.name])
    bolts = model.by_type("IfcMechanicalFastener")
    assert len(bolts) == job.fasteners[0].count
    for bolt, joins in zip(bolts, job.fasteners[0].joins, strict=True):
        assert elements.get_aggregate(bolt).Name == homes[joins[0]]
    # Some stand between two assemblies.
    assert any(homes[one] != homes[other] for one, other in job.fasteners[0].joins)


@needed
@pytest.mark.parametrize(
    ("section", "kind", "sizes"),
    [
        ("HEB160", "IfcIShapeProfileDef", {"OverallDepth": 160, "WebThickness": 8}),
        ("UPE160", "IfcUShapeProfileDef", {"Depth": 160, "FlangeWidth": 70}),
        ("tee:IPE200", "IfcTShapeProfileDef", {"Depth": 100, "FlangeThickness": 8.5}),
        ("tube:100x60x5", "IfcRectangleHollowProfileDef", {"XDim": 60, "YDim": 100}),
        ("chs:88.9x5", "IfcCircleHollowProfileDef", {"Radius": 44.45, "WallThickness": 5}),
        ("GL24h:80x200", "IfcRectangleProfileDef", {"XDim": 80, "YDim": 200}),
    ],
)
def test_bars_have_their_profile_in_ifc(roof, tmp_path, section, kind, sizes):
    import ifcopenshell
    import ifcopenshell.validate
    from ifcopenshell.util import element as elements

    job = build(roof, [Beams(200, 20, section=section)], selection=Selection("u", (3,)))
    write(job, tmp_path, workshop=Workshop(write="ifc"))
    model = ifcopenshell.open(tmp_path / "structure.ifc")
    log = ifcopenshell.validate.json_logger()
    ifcopenshell.validate.validate(model, log)
    assert log.statements == []
    (shape,) = model.by_type("IfcProfileDef")
    assert (shape.is_a(), shape.ProfileName) == (kind, section)
    assert {name: getattr(shape, name) for name in sizes} == pytest.approx(sizes)
    for bar in model.by_type("IfcBeam"):
        profiles = elements.get_material(bar)
        assert profiles.MaterialProfiles[0].Profile == shape
        assert profiles.MaterialProfiles[0].Material.Name == job.parts[0].material.name


@needed
def test_own_sections_have_no_profile_and_no_code(roof, tmp_path):
    import ifcopenshell

    section = "polygon:0,0 60,0 60,80 0,80"
    job = build(roof, [Beams(200, 20, section=section)], selection=Selection("u", (3,)))
    write(job, tmp_path, workshop=Workshop(write="ifc,nc1,saw"))
    model = ifcopenshell.open(tmp_path / "structure.ifc")
    assert not model.by_type("IfcProfileDef")
    assert len(model.by_type("IfcBeam")) == len(job.parts)
    assert not (tmp_path / "nc1").exists()
    rows = (tmp_path / "saw-list" / "saw-list.csv").read_text(encoding="utf-8").splitlines()
    assert len(rows) == 1 + len(job.parts)
