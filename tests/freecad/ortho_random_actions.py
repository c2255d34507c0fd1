"""What a user may do to a document, each thing with random numbers, and what must survive it."""

from functools import partial

import FreeCAD
import numpy as np
import ortho_suite_tools as tools
from ortho_document_state import assert_same, snapshot
from ortho_random_making import OFFSETS, Making

from freecad_ortho import api
from freecad_ortho.objects.flat_patterns import is_flat_patterns
from freecad_ortho.objects.structural_check import is_check
from solver.errors import InputError
from solver.io.polygons import read_polygons

LENGTH = 10


class Sequence(Making):
    """One document and the random things that are done to it."""

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
    for name, value in (*vars(Making).items(), *vars(Sequence).items())
    if not name.startswith("_") and name not in HELPERS
]
