"""Files for other programs, each read by a library that did not write it."""

import csv
import json
import uuid
from importlib.util import find_spec
from xml.etree import ElementTree
from zipfile import ZipFile

import numpy as np
import pytest

from freecad_ortho.fabrication import FILES, Beams, Lamellas, Panels, Workshop, build, write
from freecad_ortho.fabrication.colours import colour_of
from freecad_ortho.fabrication.exchange import WRITERS, facets
from freecad_ortho.fabrication.formats import FORMATS, formats_of
from freecad_ortho.fabrication.material import MATERIALS
from freecad_ortho.fabrication.place import Place
from freecad_ortho.fabrication.production import produce
from freecad_ortho.fabrication.site import Selection
from freecad_ortho.fabrication.systems.nodes import Nodes
from solver.errors import InputError

ALL = ",".join(FORMATS)
needed = pytest.mark.skipif(
    any(each.missing for each in FORMATS.values()),
    reason="needs the packages of requirements-exchange.txt",
)


@pytest.fixture(scope="module")
def jobs(roof):
    """Beams with hubs and panes, turned and moved; drilled lamellas that are bent smoothly."""
    glass = MATERIALS["toughened-glass"]
    steel = MATERIALS["steel"]
    turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    framed = build(
        roof,
        [Beams(200, 20, ends="hub"), Nodes(), Panels(12, 10)],
        material={"beams": steel, "nodes": steel, "panels": glass},
        place=Place(turn, np.array([1e4, -2e4, 500.0])),
    )
    some = Selection(family="u", lines=(0, 3))
    bent = build(roof, [Lamellas(60, 4, smooth=True, hole=9)], selection=some)
    return {"framed": framed, "lamellas": bent}


@pytest.fixture(scope="module")
def folders(jobs, tmp_path_factory):
    root = tmp_path_factory.mktemp("exchange")
    for name, job in jobs.items():
        shop = Workshop(sheet=(12000, 4000), write=ALL, step_tolerance=0.01)
        write(job, root / name, workshop=shop, project='=Dach "ü" / 7')
    return root


def test_every_format_has_its_writer():
    assert set(WRITERS) == set(FORMATS)


def test_names_are_checked():
    assert [each.name for each in formats_of(" XLSX, ifc,ifc")] == ["ifc", "xlsx"]
    with pytest.raises(InputError, match=r"write: expected ifc, .* or drawings, got 'dwg'"):
        Workshop(write="ifc,dwg")


def test_nothing_is_written_unasked(structure, tmp_path):
    write(structure, tmp_path)
    assert not [path for each in FORMATS.values() for path in tmp_path.glob(each.file)]


def test_what_is_missing_is_said_and_leaves_the_others(structure, tmp_path, monkeypatch):
    gone = {each.package for each in FORMATS.values()} - {""}
    monkeypatch.setattr(
        "freecad_ortho.fabrication.formats.find_spec",
        lambda name: None if name in gone else find_spec(name),
    )
    write(structure, tmp_path, workshop=Workshop(write="ifc,glb,xlsx,labels,3dm,drawings,saw"))
    report = json.loads((tmp_path / "report.json").read_text())
    said = [words for words in report["messages"] if "is missing" in words]
    files = ["structure.ifc", "structure.glb", "lists.xlsx", "labels.pdf", "structure.3dm"]
    files.append("drawings.pdf")
    assert [words.split()[0] for words in said] == files
    assert said[2] == (
        "lists.xlsx is not written: the Python package 'XlsxWriter' is missing; install it with "
        "pip, or leave out xlsx"
    )
    assert "saw-list/saw-list.csv" in report["files"]
    assert not any((tmp_path / file).exists() for file in files)


@needed
def test_what_is_no_longer_asked_for_goes(structure, tmp_path):
    write(structure, tmp_path, workshop=Workshop(write="glb,xlsx"))
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["files"] == [*FILES, "structure.glb", "lists.xlsx"]
    write(structure, tmp_path, workshop=Workshop(write="xlsx"))
    assert not (tmp_path / "structure.glb").exists()


@needed
def test_the_same_bytes_twice(jobs, folders, tmp_path):
    shop = Workshop(sheet=(12000, 4000), write=ALL, step_tolerance=0.01)
    write(jobs["framed"], tmp_path, workshop=shop, project='=Dach "ü" / 7')
    for each in FORMATS.values():
        found = sorted(tmp_path.glob(each.file))
        assert found, each.name
        for path in found:
            before = folders / "framed" / path.relative_to(tmp_path)
            assert path.read_bytes() == before.read_bytes(), path


def test_sides_hold_the_volume(jobs):
    for part in (part for job in jobs.values() for part in job.parts):
        found = facets.facets(part)
        assert found.volume == pytest.approx(part.volume, rel=1e-9 if found.exact else 2e-3)
        corners = found.triangles
        volume = np.einsum("tk,tk->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
        assert volume == pytest.approx(found.volume, rel=1e-9)
        if found.exact:
            sides = [ring for rings in found.sides for ring in rings]
            pairs = [pair for ring in sides for pair in zip(ring, ring[1:] + ring[:1], strict=True)]
            # Closed, and turned alike: each edge once in either direction.
            assert len(set(pairs)) == len(pairs)
            assert {pair[::-1] for pair in pairs} == set(pairs)


@needed
@pytest.mark.parametrize("name", ["framed", "lamellas"])
def test_ifc_is_valid_and_holds_every_part(jobs, folders, name):
    import ifcopenshell
    import ifcopenshell.validate
    from ifcopenshell.util import element as elements
    from ifcopenshell.util import placement

    model = ifcopenshell.open(folders / name / "structure.ifc")
    log = ifcopenshell.validate.json_logger()
    ifcopenshell.validate.validate(model, log, express_rules=True)
    assert log.statements == []
    job = jobs[name]
    (storey,) = model.by_type("IfcBuildingStorey")
    assert {each.is_a() for each in elements.get_decomposition(storey, is_recursive=False)} <= {
        *("IfcElementAssembly", "IfcCurtainWall", "IfcGrid"),
    }
    # Glass is a curtain wall, and nothing else is one.
    walls = {"panels"} if name == "framed" else set()
    assert {each.Name for each in model.by_type("IfcCurtainWall")} == walls
    products = {each.Name: each for each in model.by_type("IfcElement") if each.Tag}
    assert set(products) == {part.name for part in job.parts}
    kinds = {"beam": "IfcBeam", "panel": "IfcPlate", "node": "IfcDiscreteAccessory"}
    kinds["lamella"] = "IfcMember"
    for part in job.parts[:: max(1, len(job.parts) // 12)]:
        product = products[part.name]
        assert product.is_a() == kinds[part.kind]
        assert elements.get_material(product).Name == part.material.name
        facts = elements.get_psets(product)
        amounts = next(facts[key] for key in facts if "uantities" in key)
        assert amounts["NetVolume"] == pytest.approx(part.volume * 1e-9, rel=1e-12)
        assert amounts["NetWeight"] == pytest.approx(part.mass, rel=1e-12)
        # Plates are told by thickness and area, bars by their length.
        sizes = {"Length": part.length}
        if kinds[part.kind] == "IfcPlate":
            sizes = {"Width": part.thickness, "NetArea": part.area * 1e-6}
        for size in ("Length", "Width", "NetArea"):
            assert amounts.get(size, 0.0) == pytest.approx(sizes.get(size, 0.0), rel=1e-12)
        assert facts["Ortho_Part"]["Vertices"] == " ".join(map(str, part.vertices))
        matrix = placement.get_local_placement(product.ObjectPlacement)
        np.testing.assert_allclose(matrix[:3, 3], job.place.points(part.origin), rtol=0, atol=1e-6)


def is_shared(product):
    (shape,) = product.Representation.Representations
    return shape.Items[0].is_a("IfcMappedItem")


@needed
def test_ifc_shapes_are_where_the_parts_are(jobs, folders):
    import ifcopenshell
    from ifcopenshell import geom
    from ifcopenshell.util import shape as shapes

    model = ifcopenshell.open(folders / "framed" / "structure.ifc")
    settings = geom.settings()
    settings.set("use-world-coords", True)
    job = jobs["framed"]
    known = {part.name: part for part in job.parts}
    chosen = [each for each in model.by_type("IfcElement") if each.Tag][::9]
    for product in chosen:
        part = known[product.Name]
        made = geom.create_shape(settings, product)
        # In metres.
        points = shapes.get_vertices(made.geometry) * 1000
        volume = shapes.get_volume(made.geometry) * 1e9
        exact = facets.facets(part).exact and not is_shared(product)
        assert volume == pytest.approx(part.volume, rel=1e-6 if exact else 1e-3)
        (style,) = made.geometry.materials
        *colour, opacity = np.array(colour_of(part.material)) / 255
        assert style.diffuse.components == pytest.approx(colour)
        assert style.transparency == pytest.approx(1 - opacity, abs=1e-3)
        corners = job.place.points(part.points)
        assert np.abs(points.min(axis=0) - corners.min(axis=0)).max() < 0.1
        assert np.abs(points.max(axis=0) - corners.max(axis=0)).max() < 0.1


@needed
def test_ifc_identifiers_follow_from_names(jobs, folders, tmp_path):
    import ifcopenshell

    write(jobs["framed"].only("panels"), tmp_path, workshop=Workshop(write="ifc"), project="other")
    first, second = (
        ifcopenshell.open(folder / "structure.ifc") for folder in (folders / "framed", tmp_path)
    )
    for model in (first, second):
        names = [each.GlobalId for each in model.by_type("IfcRoot")]
        assert len(set(names)) == len(names)
        assert all(uuid.UUID(ifcopenshell.guid.expand(name)) for name in names)
    assert not {e.GlobalId for e in first.by_type("IfcPlate")} & {
        e.GlobalId for e in second.by_type("IfcPlate")
    }


@needed
def test_lines_of_the_net_are_a_grid_in_ifc(jobs, folders):
    """Named as in all files; in space where the net is, on the axes as it is seen."""
    import ifcopenshell
    from ifcopenshell.util import element as elements
    from ifcopenshell.util import placement

    job = jobs["framed"]
    model = ifcopenshell.open(folders / "framed" / "structure.ifc")
    (grid,) = model.by_type("IfcGrid")
    assert elements.get_container(grid).is_a("IfcBuildingStorey")
    lines = job.site.chosen_lines
    axes = [*grid.UAxes, *grid.VAxes]
    assert [each.AxisTag for each in axes] == [f"{line.family}{line.number}" for line in lines]
    matrix = placement.get_local_placement(grid.ObjectPlacement)
    foot, bent = grid.Representation.Representations
    assert list(foot.Items[0].Elements) == [each.AxisCurve for each in axes]
    points = job.place.points(job.site.mesh.vertices + job.site.shift)
    for axis, curve, line in zip(axes, bent.Items, lines, strict=True):
        corners = np.array([point.Coordinates for point in curve.Points])
        there = corners @ matrix[:3, :3].T + matrix[:3, 3]
        np.testing.assert_allclose(there, points[line.vertices], rtol=0, atol=1e-4)
        flat = np.array([point.Coordinates for point in axis.AxisCurve.Points])
        np.testing.assert_allclose(flat, corners[:, :2], rtol=0, atol=1e-6)
        assert np.linalg.norm(np.diff(flat, axis=0), axis=1).min() > 1e-3


@needed
def test_equal_parts_share_one_geometry_in_ifc(folders):
    import ifcopenshell

    # The net is symmetric.
    model = ifcopenshell.open(folders / "framed" / "structure.ifc")
    mapped = model.by_type("IfcMappedItem")
    assert len(mapped) > 2 * len(model.by_type("IfcRepresentationMap")) > 0


@needed
def test_lists_in_one_workbook(folders):
    from openpyxl import load_workbook

    book = load_workbook(folders / "framed" / "lists.xlsx")
    assert book.sheetnames == [
        *("mass and cost", "cost of stock", "parts", "nodes", "stock", "sheets", "off-cuts"),
    ]
    for name in ("parts", "nodes", "stock"):
        with (folders / "framed" / f"{name}.csv").open(encoding="utf-8", newline="") as stream:
            expected = list(csv.reader(stream))
        rows = [["" if x is None else x for x in row] for row in book[name].values]
        assert rows[0] == expected[0]
        assert len(rows) == len(expected)
        for row, wanted in zip(rows[1:], expected[1:], strict=True):
            assert [x if isinstance(x, str) else float(x) for x in row] == [
                x if isinstance(y, str) else float(x) for x, y in zip(wanted, row, strict=True)
            ]
    masses = book["mass and cost"]
    rows = {row[0]: row for row in masses.values if row[0] not in ("material", "total")}
    assert set(rows) == {"steel", "toughened-glass"}
    assert masses["F2"].value == "=D2*E2"
    assert book.properties.title == '=Dach "ü" / 7'


@needed
def test_masses_of_the_workbook_add_up(jobs, folders):
    from openpyxl import load_workbook

    book = load_workbook(folders / "framed" / "lists.xlsx")
    column = [cell.value for cell in next(book["parts"].iter_cols())]
    assert column[1:] == [part.name for part in jobs["framed"].parts]
    masses = {row[0]: row[3] for row in book["mass and cost"].values}
    for name, mass in jobs["framed"].masses.items():
        assert masses[name] == pytest.approx(mass, rel=1e-12)


@needed
def test_labels_are_decoded(jobs, folders):
    import pypdfium2
    import zxingcpp

    pages = pypdfium2.PdfDocument(folders / "framed" / "labels.pdf")
    names = [part.name for part in jobs["framed"].parts]
    assert len(pages) == -(-len(names) // 24)
    found = []
    for page in (pages[0], pages[len(pages) - 1]):
        found += [code.text for code in zxingcpp.read_barcodes(page.render(scale=3).to_pil())]
    last = len(names) - 24 * (len(pages) - 1)
    assert sorted(found) == sorted(names[:24] + names[-last:])
    text = pages[0].get_textpage().get_text_range()
    part = jobs["framed"].parts[0]
    assert f"{part.kind}, {part.material.name}" in text
    assert f"{part.mass:.1f} kg" in text


@needed
def test_viewers_see_every_part(jobs, folders):
    import trimesh

    scene = trimesh.load_scene(folders / "framed" / "structure.glb")
    assert set(scene.geometry) == {part.name for part in jobs["framed"].parts}
    for part in jobs["framed"].parts[::11]:
        mesh = scene.geometry[part.name].copy()
        mesh.merge_vertices()
        assert mesh.volume * 1e9 == pytest.approx(part.volume, rel=1e-3)
        low, high = (1000 * bound for bound in mesh.bounds)
        seen = part.points @ np.array([[1.0, 0, 0], [0, 0, -1.0], [0, 1.0, 0]])
        np.testing.assert_allclose(low, seen.min(axis=0), rtol=0, atol=0.1)
        np.testing.assert_allclose(high, seen.max(axis=0), rtol=0, atol=0.1)
    pane = next(part for part in jobs["framed"].parts if part.kind == "panel")
    assert scene.geometry[pane.name].visual.material.name == pane.material.name


@needed
def test_workbooks_have_no_clock(folders):
    with ZipFile(folders / "framed" / "lists.xlsx") as book:
        core = ElementTree.fromstring(book.read("docProps/core.xml"))
    assert {node.text[:4] for node in core if node.tag.endswith(("created", "modified"))} == {
        "2000"
    }


class Stopped(Exception):
    pass


@pytest.fixture(scope="module")
def produced(jobs):
    """The panes alone; the saw list, which has none of them, is of all."""
    shop = Workshop(sheet=(12000, 4000))
    return {
        name: produce(job, shop)
        for name, job in (("all", jobs["framed"]), ("panes", jobs["framed"].only("panels")))
    }


@needed
@pytest.mark.parametrize("name", FORMATS)
def test_every_writer_can_be_stopped(produced, tmp_path, name):
    """It says how far it is, without going back, and whatever that raises ends it."""
    production = produced["all" if name == "saw" else "panes"]
    seen = []
    WRITERS[name](tmp_path / "whole", production, "project", seen.append)
    assert seen == sorted(seen) and 0 <= seen[0] <= seen[-1] <= 1

    def stop(done):
        raise Stopped

    with pytest.raises(Stopped):
        WRITERS[name](tmp_path / "stopped", production, "project", stop)
