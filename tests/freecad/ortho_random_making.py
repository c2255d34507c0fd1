"""What a user may do to make nets and structures, each thing with random numbers."""

import random
from functools import partial

import FreeCAD
import ortho_suite_tools as tools
import Part
from ortho_document_state import assert_same, snapshot

from freecad_ortho import api
from freecad_ortho.objects.net import COLOUR_MAPS, is_net
from freecad_ortho.objects.structure import is_structure
from solver.errors import InputError

OFFSETS = ("above", "centre", "below")


class Making:
    """One document and the random things that are done to it."""

    def __init__(self, seed):
        self.dice = random.Random(seed)
        self.seed, self.done = seed, []
        self.document = FreeCAD.newDocument("Random")
        self.document.UndoMode = 1

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
