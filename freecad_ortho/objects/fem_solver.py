"""CalculiX in the FEM workbench for the analysis of a net: FreeCAD's solver, and some things more.

Sections turn by the axes of the net, each member by its own, where FreeCAD turns all of an analysis
by one angle from directions of its own; loads act along members; joints give, supports are springs
and panels stiffen. Loaded only where the FEM workbench is.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import FreeCAD
from femmesh.meshsetsgetter import MeshSetsGetter
from femsolver import run
from femsolver.calculix import solver as calculix
from femsolver.calculix import tasks
from femsolver.calculix.writer import FemInputWriterCcx
from femtools import membertools
from PySide import QtCore

from freecad_ortho.objects.fem_loads import is_loads

try:
    # From FreeCAD 1.1 on its writer heeds these, and the older proxy has others.
    from femobjects.solver_calculix import SolverCalculiX as Current
except ImportError:
    Current = None

_STEP, _END, _ELEMENT, _SECTION = "*STEP", "*END STEP", "TYPE=B32,", "*BEAM SECTION"
_OLD_SECTION = "*BEAM GENERAL SECTION"
# Seconds between looks for work that waits for the window.
_PAUSE = 0.02


class Solver(calculix.Proxy):
    """Proxy of the solver: "Run solver" and a double click do as with FreeCAD's own."""

    def add_attributes(self, obj: Any) -> None:
        """Give a new or an older solver the properties that FreeCAD's writer heeds."""
        if Current is None:
            super().add_attributes(obj)
            return
        for item in Current._get_properties(self):
            if item.name not in obj.PropertiesList:
                item.add_to_object(obj)

    def createMachine(self, obj: Any, directory: str, testmode: bool = False) -> Any:
        """FreeCAD's steps, with another way to write the input."""
        return Machine(
            solver=obj,
            directory=directory,
            check=tasks.Check(),
            prepare=Prepare(),
            solve=tasks.Solve(),
            results=Results(),
            testmode=testmode,
        )


class _Errand(QtCore.QObject):
    """Has work of another thread done in the one of the window."""

    asked = QtCore.Signal()

    def __init__(self, work: Callable[[], None]) -> None:
        super().__init__()
        self._work, self._done = work, threading.Event()
        self._error: Exception | None = None
        self.moveToThread(QtCore.QCoreApplication.instance().thread())
        self.asked.connect(self._run, QtCore.Qt.QueuedConnection)

    @QtCore.Slot()
    def _run(self) -> None:
        try:
            self._work()
        except Exception as error:
            self._error = error
        finally:
            self._done.set()

    def run(self) -> None:
        """Wait until it is done; raise what it raised."""
        self.asked.emit()
        self._done.wait()
        if self._error is not None:
            raise self._error


def _beside_the_window() -> bool:
    return bool(FreeCAD.GuiUp) and threading.current_thread() is not threading.main_thread()


class Machine(run.Machine):
    """FreeCAD's, of which the window does not wait in vain where it is waited for."""

    def join(self) -> None:
        """Wait for the end, and do meanwhile what only the window's thread can."""
        if not FreeCAD.GuiUp or _beside_the_window():
            super().join()
            return
        while self._thread is not None and self._thread.is_alive():
            QtCore.QCoreApplication.processEvents(QtCore.QEventLoop.ExcludeUserInputEvents)
            self._thread.join(_PAUSE)


class Results(tasks.Results):
    """FreeCAD's reading of results, in the thread that documents belong to."""

    def run(self) -> None:
        """Put them into the document; FreeCAD 1.1 waits for its window there."""
        if _beside_the_window():
            _Errand(super().run).run()
        else:
            super().run()


class Sets(MeshSetsGetter):
    """Elements of members, which are numbered one member after the other: nothing is searched."""

    def get_element_rotation1D_elements(self) -> None:
        """Each member with the direction of its section's width."""
        mesh = self.mesh_object
        each = mesh.ElementsPerMember
        rows = [
            {"ids": _elements(member, each), "direction": width, "beam_axis_m": width}
            for member, width in enumerate(mesh.SectionWidths)
        ]
        found = self.member.geos_beamrotation or [{}]
        found[0] |= {"FEMRotations1D": rows, "ShortName": "R0"}
        self.member.geos_beamrotation = found

    def get_element_geometry1D_elements(self) -> None:
        """Elements of each section."""
        self._shared(self.member.geos_beamsection, "B")

    def get_material_elements(self) -> None:
        """Elements of each material."""
        self._shared(self.member.mats_linear, "M")

    def get_constraints_fixed_nodes(self) -> None:
        """Nodes that cannot move."""
        super().get_constraints_fixed_nodes()
        self._of_the_net(self.member.cons_fixed)

    def get_constraints_displacement_nodes(self) -> None:
        """Nodes that cannot move some ways."""
        super().get_constraints_displacement_nodes()
        self._of_the_net(self.member.cons_displacement)

    def _of_the_net(self, owners: list[dict[str, Any]]) -> None:
        """Leave out ends of members that are linked to a node in their place."""
        count = getattr(self.mesh_object, "NetNodes", 0)
        for owner in owners:
            owner["Nodes"] = [node for node in owner["Nodes"] if not count or node <= count]

    def _shared(self, owners: list[dict[str, Any]], letter: str) -> None:
        """Hand elements to those that name edges, the others to one that names none."""
        each, count = self.mesh_object.ElementsPerMember, len(self.mesh_object.SectionWidths)
        left = set(range(count))
        for number, owner in enumerate(owners):
            named = [name for _, names in owner["Object"].References for name in names]
            members = [int(name.removeprefix("Edge")) - 1 for name in named]
            left -= set(members)
            owner["ShortName"] = f"{letter}{number}"
            owner["FEMElements"] = [one for k in members for one in _elements(k, each)]
        for owner in owners:
            if not owner["Object"].References:
                owner["FEMElements"] = [one for k in sorted(left) for one in _elements(k, each)]


class Prepare(run.Prepare):
    """Write the input of CalculiX."""

    def run(self) -> None:
        """FreeCAD's input with the loads, and with sections that its writer has not."""
        mesh = membertools.get_mesh_to_solve(self.analysis)[0]
        members = membertools.AnalysisMember(self.analysis)
        sets = Sets(self.analysis, self.solver, mesh, members)
        sets.get_mesh_sets()
        writer = FemInputWriterCcx(
            self.analysis, self.solver, mesh, sets.member, self.directory, sets.mat_geo_sets
        )
        path = writer.write_solver_input()
        if not path:
            self.pushStatus("Writing solver input failed.")
            self.fail()
            return
        hollow = {
            one["ccx_elset_name"]: one["beamsection_obj"].Wall.getValueAs("mm").Value
            for one in sets.mat_geo_sets
            if hasattr(one.get("beamsection_obj"), "Wall")
        }
        links = list(getattr(mesh, "Links", []))
        complete(Path(path), hollow, links, list(_forces(self.analysis)))
        # Where FreeCAD's next steps look for the name.
        tasks._inputFileName = Path(path).stem


def complete(path: Path, hollow: dict[str, float], links: list[str], forces: list[str]) -> None:
    """Put into an input file what FreeCAD's writer has not.

    Args:
        path: of the file, which is written anew.
        hollow: walls, mm, of rectangular sections that are hollow, by the names of their sets.
        links: lines of joints that give and springs.
        forces: lines of the loads.
    """
    found: list[str] = []
    lines = iter(path.read_text(encoding="utf-8").splitlines())
    for line in lines:
        # Pipes and boxes are there with reduced integration only.
        line = line.replace(_ELEMENT, "TYPE=B32R,").replace(_OLD_SECTION, _SECTION)
        words = {word.partition("=")[0]: word.partition("=")[2] for word in line.split(", ")}
        if line.startswith(_SECTION) and words.get("ELSET") in hollow:
            wall = f"{hollow[words['ELSET']]:.13G}"
            found += [line.replace("SECTION=RECT", "SECTION=BOX")]
            line = ",".join([next(lines), wall, wall, wall, wall])
        if line.startswith(_STEP):
            found += links
        if line.startswith(_END):
            found += forces
        found.append(line)
    path.write_text("\n".join(found) + "\n", encoding="utf-8")


def _forces(analysis: Any) -> Iterator[str]:
    for item in analysis.Group:
        if not is_loads(item) or not item.Factor:
            continue
        yield f"** {item.LoadCase}, {item.Factor:g} times"
        yield "*CLOAD"
        for node, force in enumerate(item.Forces, 1):
            for direction, value in enumerate(force, 1):
                if value:
                    yield f"{node}, {direction}, {item.Factor * value:.13G}"


def _elements(member: int, each: int) -> list[int]:
    return list(range(each * member + 1, each * (member + 1) + 1))


def create(document: Any) -> Any:
    """Add the solver to a document: static, linear."""
    from femtools import femutils

    solver = femutils.createObject(document, "SolverCalculiX", Solver, calculix.ViewProxy)
    # FreeCAD 1.1 asks for the solids that CalculiX makes of beams, whose nodes are not the net's.
    solver.BeamShellResultOutput3D = False
    return solver
