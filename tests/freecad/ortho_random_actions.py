"""What a user may do to a document, each thing with random numbers, and what must survive it."""

import random
from functools import partial

import FreeCAD
import numpy as np
import ortho_suite_tools as tools
import Part

from freecad_ortho import api
from freecad_ortho.objects.flat_patterns import is_flat_patterns
from freecad_ortho.objects.net import COLOUR_MAPS, is_net
from freecad_ortho.objects.structural_check import is_check
from freecad_ortho.objects.structure import is_structure
from solver.errors import InputError
from solver.io.polygons import read_polygons

LENGTH = 10
OFFSETS = ("above", "centre", "below")


class Sequence:
    """One document and the random things that are done to it."""

    def __init__(self, seed):
        self.dice = random.Random(seed)
        self.seed, self.done = seed, []
        self.document = FreeCAD.newDocument("Random")
        self.document.UndoMode = 1

    def run(self):
        self.import_net()
        while len(self.done) < LENGTH:
            action = self.dice.choice(ACTIONS)
            if action(self) is not False:
                self.done.append(action.__name__)
        # So each comes up in some of the sequences, however the dice fall.
        action = ACTIONS[self.seed % len(ACTIONS)]
        if action(self) is not False:
            self.done.append(action.__name__)

    def nets(self):
        return [item for item in self.document.Objects if is_net(item)]

    def structures(self, system=None):
        found = [item for item in self.document.Objects if is_structure(item)]
        return [item for item in found if system in (None, item.System)]

    def any_net(self):
        return self.dice.choice(self.nets()) if self.nets() else None

    def import_net(self):
        if self.crowded():
            return False
        rows, columns = self.dice.choice([(3, 3), (3, 4), (4, 3)])
        path = tools.wavy_mesh(f"random{rows}{columns}", rows, columns)
        api.import_net(path, self.document, self.dice.choice([None, "mm"]))

    def optimise_net(self):
        net = self.any_net()
        if net is None:
            return False
        kind = self.dice.choice(["principal", "orthogonal", "circular", "geodesic"])
        steps = self.dice.randint(1, 4)
        self.allowed_to_fail(partial(api.optimise_net, net=kind, max_steps=steps), net)

    def optimise_again(self):
        # Few are outdated by chance; the others have to stay as they are.
        nets = sorted(self.nets(), key=lambda net: not getattr(net, "Outdated", False))
        if not nets:
            return False
        self.allowed_to_fail(api.optimise_again, nets[0])

    def drag_net(self):
        net = self.any_net()
        if net is None or self.dice.random() < 0.5:
            return False
        number = self.dice.randrange(len(net.Vertices))
        place = net.Vertices[number] + FreeCAD.Vector(0, 0, self.dice.uniform(-100, 100))
        self.allowed_to_fail(partial(api.drag_net, max_steps=5), net, {number: tuple(place)})

    def set_net(self):
        net = self.any_net()
        if net is None:
            return False
        kind = self.dice.choice(["principal", "orthogonal"])
        # A closed net has no corners.
        self.allowed_to_fail(api.set_net, net, net=kind, fix="corners")

    def add_beams(self):
        net = self.any_net()
        if net is None or len(self.structures()) > 3:
            return False
        height, thickness = self.dice.uniform(50, 300), self.dice.uniform(4, 20)
        self.allowed_to_fail(api.add_beams, net, height, thickness, self.dice.choice(OFFSETS))

    def add_panels(self):
        net = self.any_net()
        if net is None or len(self.structures()) > 3:
            return False
        beams = [item for item in self.structures("Beams") if item.Net is net]
        below = self.dice.choice([None, *beams])
        gap = self.dice.uniform(5, 30)
        self.allowed_to_fail(api.add_panels, net, 12.0, gap, self.dice.choice(OFFSETS), below)

    def add_nodes(self):
        beams = self.structures("Beams")
        if not beams or len(self.structures()) > 3:
            return False
        chosen = self.dice.choice(beams)
        self.allowed_to_fail(api.add_nodes, chosen.Net, chosen)

    def add_edge_beam(self):
        net = self.any_net()
        if net is None or len(self.structures()) > 3:
            return False
        section = self.dice.choice(["plate", "tube"])
        width = self.dice.uniform(15, 80)
        self.allowed_to_fail(api.add_edge_beam, net, edge_section=section, edge_width=width)

    def add_lamellas(self):
        strip = self.dice.choice(["auto", "twisted"])
        return self.add_one(api.add_lamellas, width=self.dice.uniform(40, 90), strip=strip)

    def add_louvres(self):
        return self.add_one(api.add_louvres, tilt=self.dice.uniform(0, 40))

    def add_arches(self):
        through = self.dice.choice(["both", "u", "v"])
        return self.add_one(api.add_arches, height=self.dice.uniform(80, 300), through=through)

    def add_feet(self):
        return self.add_one(api.add_feet, foot_height=self.dice.uniform(300, 2000))

    def add_bent_panels(self):
        return self.add_one(api.add_bent_panels, gap=self.dice.uniform(2, 12))

    def add_patches(self):
        return self.add_one(api.add_patches, gap=self.dice.uniform(2, 12))

    def add_one(self, function, **sizes):
        """A structure that takes long to build, and is therefore seldom made."""
        net = self.any_net()
        if net is None or len(self.structures()) > 1 or self.dice.random() < 0.5:
            return False
        self.allowed_to_fail(function, net, **sizes)
        return True

    def allowed_to_fail(self, function, *arguments, **options):
        """A net in the middle of its optimisation may not carry what is asked for."""
        before = snapshot(self.document)
        try:
            function(*arguments, **options)
        except InputError:
            assert_same(before, snapshot(self.document), 0.0)

    def add_primitive(self):
        if self.crowded():
            return False
        name = self.dice.choice(["sphere", "catenoid", "rectangle", "helicoid"])
        self.allowed_to_fail(
            api.add_primitive, name, sampling=self.sampling(), document=self.document
        )

    def add_elliptic_net(self):
        if self.crowded():
            return False
        curve, moving = self.dice.choice([("arch", "mu"), ("loop", "mu"), ("arch", "nu")])
        self.allowed_to_fail(
            api.add_elliptic_net,
            moving,
            curve=curve,
            sampling=self.sampling(),
            document=self.document,
        )

    def add_multi_net(self):
        if self.crowded():
            return False
        api.add_multi_net(sampling=self.sampling(), document=self.document)

    def net_from_faces(self):
        if self.crowded():
            return False
        box = self.document.getObject("Dome") or self.document.addObject("Part::Feature", "Dome")
        self.document.openTransaction("Dome")
        box.Shape = Part.makeSphere(self.dice.uniform(2000, 5000)).Faces[0]
        self.document.recompute()
        self.document.commitTransaction()
        size = self.sampling()
        self.allowed_to_fail(api.net_from_faces, (box, "Face1"), sampling=size, v_part=(0.1, 0.9))

    def net_along_curvature(self):
        if self.crowded():
            return False
        vault = self.document.getObject("Vault")
        self.document.openTransaction("Vault")
        vault = vault or self.document.addObject("Part::Feature", "Vault")
        up, along = FreeCAD.Vector(), FreeCAD.Vector(0, 1, 0)
        vault.Shape = Part.makeCylinder(self.dice.uniform(2000, 4000), 5000, up, along, 120).Faces[
            0
        ]
        self.document.recompute()
        self.document.commitTransaction()
        edge = self.dice.uniform(800, 1500)
        strokes = self.dice.choice(
            [(), (vault, "Edge1"), (vault, f"Edge{self.dice.randint(1, 9)}")]
        )
        low, high = (self.dice.uniform(1000, 4000) for _ in range(2))
        x, y, z = vault.Shape.Face1.valueAt(1.0, low)
        singularities = self.dice.choice(["auto", "none", [(x, y, z, self.dice.choice([3, 5, 6]))]])
        drawn = [tuple(vault.Shape.Face1.valueAt(0.5, v)) for v in (low, high)]
        self.allowed_to_fail(
            partial(api.net_along_curvature, strokes=strokes, singularities=singularities),
            (vault, "Face1"),
            edge=edge,
            drawn_strokes=self.dice.choice([(), [drawn]]),
        )

    def form_net(self):
        net = self.any_net()
        if net is None or self.crowded():
            return False
        self.allowed_to_fail(partial(api.form_net, supports="corners"), net)

    def change_net(self):
        net = self.any_net()
        if net is None or self.crowded():
            return False
        change = self.dice.choice(["subdivide", "diagonal mesh", "mirror", "orient", "transform"])
        if len(net.Faces) > 300:
            change = "transform"
        self.allowed_to_fail(api.change_net, net, change)

    def weld_nets(self):
        if len(self.nets()) < 2 or self.crowded():
            return False
        self.allowed_to_fail(api.weld_nets, self.nets()[:2])

    def change_source(self):
        nets = [net for net in self.nets() if "SamplingU" in net.PropertiesList]
        if not nets:
            return False
        net = self.dice.choice(nets)
        self.allowed_to_fail(partial(api.change_source, sampling=self.sampling()), net)

    def show_net(self):
        net = self.any_net()
        if net is None:
            return False
        api.show_net(net, colour_map=self.dice.choice(COLOUR_MAPS))

    def crowded(self):
        return len(self.nets()) > 3

    def sampling(self):
        return self.dice.randint(3, 5), self.dice.randint(3, 5)

    def add_flat_patterns(self):
        if not self.structures() or self.document.getObject("FlatPatterns"):
            return False
        sheet = self.dice.choice([None, ("6 m", "3 m")])
        chosen = self.dice.choice(self.structures())
        self.allowed_to_fail(api.add_flat_patterns, chosen, sheet=sheet)

    def patterns(self):
        return [item for item in self.document.Objects if is_flat_patterns(item)]

    def change_flat_patterns(self):
        # Structures and their patterns seldom come by chance: those are made first.
        if not self.patterns():
            self.add_flat_patterns()
        patterns = self.patterns()
        if not patterns:
            return False
        spacing = self.dice.uniform(2, 20)
        self.allowed_to_fail(api.change_flat_patterns, self.dice.choice(patterns), spacing=spacing)

    def add_drawing_page(self):
        patterns = self.patterns()
        if not patterns or self.dice.random() < 0.2:
            return False
        self.allowed_to_fail(api.add_drawing_page, self.dice.choice(patterns))

    def add_drawing_pages(self):
        patterns = self.patterns()
        if not patterns or self.document.getObject("Page"):
            return False
        self.allowed_to_fail(api.add_drawing_pages, self.dice.choice(patterns))

    def checks(self):
        return [item for item in self.document.Objects if is_check(item)]

    def add_structural_check(self):
        net = self.any_net()
        if net is None or self.checks():
            return False
        beams = next((item for item in self.structures("Beams") if item.Net is net), None)
        chosen = self.dice.choice([None, beams])
        self.allowed_to_fail(partial(api.add_structural_check, beams=chosen, snow=1.0), net)

    def change_structural_check(self):
        if not self.checks():
            self.add_structural_check()
        if not self.checks():
            return False
        supports = self.dice.choice(["boundary", "corners:fixed", "3:pinned"])
        change = partial(api.change_structural_check, supports=supports, pieces=2)
        self.allowed_to_fail(change, self.dice.choice(self.checks()))

    def size_structural_check(self):
        checks = [item for item in self.checks() if "Invalid" not in item.State]
        if not checks or self.dice.random() < 0.5:
            return False
        names = "tube:60x40x4+tube:100x60x5"
        self.allowed_to_fail(api.size_structural_check, self.dice.choice(checks), names)

    def write_check_files(self):
        checks = [item for item in self.checks() if "Invalid" not in item.State]
        if not checks or self.dice.random() < 0.5:
            return False
        folder = tools.SCRATCH / "random-check"
        self.allowed_to_fail(api.write_check_files, self.dice.choice(checks), folder)

    def add_fem_analysis(self):
        checks = [item for item in self.checks() if "Invalid" not in item.State]
        if not checks or self.document.getObject("NetAnalysis") or self.dice.random() < 0.5:
            return False
        self.allowed_to_fail(api.add_fem_analysis, self.dice.choice(checks))

    def flip_net(self):
        net = self.any_net()
        if net is None:
            return False
        self.allowed_to_fail(api.flip_net, net)

    def change_structure(self):
        if not self.structures():
            return False
        thickness = self.dice.choice([8.0, 14.0, -1.0])
        self.allowed_to_fail(
            api.change_structure, self.dice.choice(self.structures()), thickness=thickness
        )

    def update_structures(self):
        self.allowed_to_fail(api.update_structures, self.document)

    def bake(self):
        if not self.document.Objects or self.document.getObject("Baked"):
            return False
        self.allowed_to_fail(api.bake, self.dice.choice(self.document.Objects))

    def export_fabrication(self):
        if not self.structures() or self.dice.random() < 0.7:
            return False
        chosen = self.dice.choice(self.structures())
        if "Invalid" in chosen.State:
            return False
        self.allowed_to_fail(api.export_fabrication, chosen, tools.SCRATCH / "random-files")

    def export_net(self):
        net = self.any_net()
        if net is None:
            return False
        path = tools.SCRATCH / self.dice.choice(["random.ply", "random.off", "random.json"])
        api.export_net(net, path)
        # Not as a mesh: in the middle of its optimisation a net may have faces without area.
        np.testing.assert_array_equal(np.ravel(read_polygons(path).polygons), net.Faces)

    def change_a_size(self):
        if not self.structures():
            return False
        chosen = self.dice.choice(self.structures())
        self.document.openTransaction("Size")
        if "Thickness" in chosen.PropertiesList:
            chosen.Thickness = self.dice.uniform(5, 15)
        if "Offset" in chosen.PropertiesList:
            chosen.Offset = self.dice.choice(OFFSETS).capitalize()
        self.document.recompute()
        self.document.commitTransaction()

    def move_a_vertex(self):
        net = self.any_net()
        if net is None:
            return False
        self.document.openTransaction("Move")
        points = net.Vertices
        number = self.dice.randrange(len(points))
        points[number] = points[number] + FreeCAD.Vector(0, 0, self.dice.uniform(-40, 40))
        net.Vertices = points
        self.document.recompute()
        self.document.commitTransaction()

    def delete(self):
        if not self.document.Objects:
            return False
        self.document.openTransaction("Delete")
        self.document.removeObject(self.dice.choice(self.document.Objects).Name)
        self.document.recompute()
        self.document.commitTransaction()

    def undo(self):
        if not self.document.UndoCount:
            return False
        self.document.undo()

    def redo(self):
        if not self.document.RedoCount and self.undo() is False:
            return False
        self.document.redo()

    def undo_all_and_redo_all(self):
        self.document.recompute()
        before, steps = snapshot(self.document), self.document.UndoCount
        for _ in range(steps):
            self.document.undo()
        for _ in range(steps):
            self.document.redo()
        assert_same(before, snapshot(self.document), 1e-12)

    def recompute(self):
        self.document.recompute()

    def reopen(self):
        before = snapshot(self.document)
        path = str(tools.SCRATCH / "random.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        self.document.UndoMode = 1
        # FreeCAD writes shapes with fifteen digits.
        assert_same(before, snapshot(self.document), 1e-12)

    def nonsense(self):
        before = snapshot(self.document)
        net = self.any_net()
        attempts = (
            lambda: api.add_beams(net, height=-1),
            lambda: api.add_panels(net, gap="wide"),
            lambda: api.optimise_net(net, net="fishing"),
            lambda: api.import_net(tools.write("empty.obj", ""), self.document),
        )
        try:
            self.dice.choice(attempts)()
        except InputError:
            assert_same(before, snapshot(self.document), 0.0)
            return
        raise AssertionError("nonsense was accepted")


HELPERS = (
    "add_one",
    "allowed_to_fail",
    "any_net",
    "checks",
    "crowded",
    "nets",
    "run",
    "sampling",
    "patterns",
    "structures",
)
ACTIONS = [
    value
    for name, value in vars(Sequence).items()
    if not name.startswith("_") and name not in HELPERS
]


def snapshot(document):
    """What must not change: positions, faces, settings, parts and their volumes, by object."""
    found = {}
    for item in document.Objects:
        if is_net(item):
            found[item.Name] = (tools.vertices(item).tobytes(), tuple(item.Faces)), []
        elif is_structure(item):
            solids = item.Shape.Solids
            numbers = [solid.Volume for solid in solids]
            numbers += list(item.Shape.BoundBox.Center) if solids else []
            numbers += [float(value) for value in values(item, "Length", "Distance", "Float")]
            links = [getattr(link, "Name", None) for link in values(item, "Link")]
            words = values(item, "Enumeration", "Integer")
            found[item.Name] = (tuple(item.PartNames), *links, *words), numbers
        elif is_flat_patterns(item):
            found[item.Name] = tuple(item.PartNames), [item.Shape.Length, item.Shape.Area]
        elif is_check(item):
            found[item.Name] = (item.Supports, item.Verdict), [*item.MemberUtilisation]
    return found


def values(item, *kinds):
    wanted = [f"App::Property{kind}" for kind in kinds]
    names = [n for n in item.PropertiesList if item.getTypeIdOfProperty(n) in wanted]
    return [getattr(item, name) for name in names]


def assert_same(one, two, tolerance):
    assert one.keys() == two.keys(), f"{sorted(one)} became {sorted(two)}"
    for name in one:
        assert one[name][0] == two[name][0], f"{name} changed"
        assert len(one[name][1]) == len(two[name][1]), f"{name} has other solids"
        np.testing.assert_allclose(
            one[name][1], two[name][1], rtol=tolerance, atol=1e3 * tolerance, err_msg=name
        )
