"""The rooms of the project stay apart: who may import whom (see README)."""

import ast
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PACKAGES = ("solver", "freecad_ortho")
FREECAD = ("FreeCAD", "FreeCADGui", "Part", "PySide", "PySide2", "PySide6", "pivy")
CAD = ("cadquery", "OCP", "trimesh", "matplotlib", "ezdxf", "shapely", "vtk")
# From the ground up: a room imports only from those before it, within functions and for types too.
ROOMS = (
    "answers", "solver", "units", "written", "packages", "preferences", "resources",
    "file_libraries", "vtk_files", "rhino_files", "mesh_files", "step_faces", "triangles",
    "sources", "fabrication", "structural", "option_keywords", "keywords", "fabricating",
    "standing", "surface_files", "stages", "building", "calls", "convert", "objects", "view",
    "documents", "stand_in", "api", "cli", "window", "panels", "commands",
)  # fmt: skip

# How many imports of the project's own modules wait until they are needed: what works without a
# window waits for what is in it, buttons for the panels that they open, and an analysis for
# FreeCAD's FEM workbench, which is not always there. No more are wanted.
DEFERRED = {
    "__main__": 1, "api": 1, "commands": 23, "convert": 1, "documents": 5, "fabrication": 1,
    "objects": 1,
}  # fmt: skip

# Inside the solver, from the ground up; nothing that a file imports, anywhere in it, is above it.
LAYERS = (
    "errors", "option", "sentence", "tuning", "isolated", "mesh", "io", "multinet",
    "mesh.primitives", "offset", "linear", "statics", "frame", "analysis", "align", "terms",
    "report", "problem", "nets", "analysis.start", "candidate", "plan", "wishes",
    "assembly", "point", "damped_step", "relaxation", "gauss_newton", "nearest", "grouping",
    "repetition", "best", "summary", "last_phase", "along", "whole_plan", "run", "optimise",
    "session", "solve",
    "analysis.advisor", "analysis.check", "analysis.fields", "formfinding", "unroll",
)  # fmt: skip

IMPORT_ALL = """
import importlib, pkgutil, sys

class Blocked:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in {blocked!r}:
            raise ImportError(name + " is blocked in this room")

sys.meta_path.insert(0, Blocked())
package = importlib.import_module({package!r})
names = [module.name for module in pkgutil.walk_packages(package.__path__, {package!r} + ".")]
for name in names:
    importlib.import_module(name)
print(len(names))
"""


def import_all(package, blocked):
    code = IMPORT_ALL.format(package=package, blocked=blocked)
    return subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False
    )


@pytest.mark.parametrize(
    ("package", "blocked"),
    [
        ("solver", FREECAD + CAD),
        ("freecad_ortho.sources", FREECAD + CAD),
        ("freecad_ortho.fabrication", FREECAD),
    ],
)
def test_imports_without(package, blocked):
    result = import_all(package, blocked)
    assert result.returncode == 0, result.stderr
    folder = ROOT.joinpath(*package.split("."))
    files = [path for path in folder.rglob("*.py") if path != folder / "__init__.py"]
    assert int(result.stdout) == len(files)


def test_blocking_works():
    result = import_all("freecad_ortho.fabrication", (*FREECAD, "freecad_ortho"))
    assert result.returncode != 0
    assert "is blocked in this room" in result.stderr


def test_command_line_starts_without_freecad_and_cad():
    code = f"import sys; sys.modules.update(dict.fromkeys({FREECAD + CAD!r})); "
    code += "import freecad_ortho, freecad_ortho.__main__, freecad_ortho.cli.commands"
    result = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert result.returncode == 0, result.stderr


def statements_at_import(tree):
    """Everything that runs when the file is loaded: all but the bodies of functions."""
    for child in ast.iter_child_nodes(tree):
        if not isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            yield child
            yield from statements_at_import(child)


def modules_at_import(tree):
    """Names of the modules, and what might be modules, that a file needs to be loaded."""
    for statement in statements_at_import(tree):
        if isinstance(statement, ast.Import):
            yield from (alias.name for alias in statement.names)
        elif isinstance(statement, ast.ImportFrom):
            yield from (f"{statement.module}.{alias.name}" for alias in statement.names)


def room_of(module):
    name = module.removeprefix("freecad_ortho.").partition(".")[0]
    return ROOMS.index(name) if name in ROOMS else None


@pytest.mark.parametrize("room", ROOMS)
def test_rooms_import_downwards(room):
    folder = ROOT / room if room == "solver" else ROOT / "freecad_ortho" / room
    paths = sorted(folder.rglob("*.py")) if folder.is_dir() else [folder.with_suffix(".py")]
    assert paths
    for path in paths:
        for module in every_import(path):
            below = room_of(module)
            assert below is None or below <= ROOMS.index(room), f"{path} imports {module}"


def deferred_imports(path):
    """Imports of the project's own modules that a file makes when a function is called."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    functions = [item for item in ast.walk(tree) if isinstance(item, ast.FunctionDef)]
    inside = {id(item): item for function in functions for item in ast.walk(function)}
    for item in inside.values():
        if isinstance(item, ast.ImportFrom) and item.module.partition(".")[0] in PACKAGES:
            yield item


def test_imports_within_functions_become_fewer():
    found = Counter()
    for path in sorted((ROOT / "freecad_ortho").rglob("*.py")):
        room = path.relative_to(ROOT / "freecad_ortho").parts[0].removesuffix(".py")
        found[room] += len(list(deferred_imports(path)))
    assert +found == DEFERRED, (
        "import at the top of the file; where there are fewer now, say so here"
    )


def layer_of(module):
    """Number of the layer of the solver that a module is in, by the longest name that fits."""
    name = module.removeprefix("solver").removeprefix(".")
    fits = [layer for layer in LAYERS if f"{name}.".startswith(f"{layer}.")]
    assert fits, f"solver.{name} is in no layer; name it in LAYERS"
    return LAYERS.index(max(fits, key=len))


def every_import(path):
    """Modules of the project that a file imports, anywhere in it."""
    for item in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(item, ast.ImportFrom) and item.module.partition(".")[0] in PACKAGES:
            for alias in item.names:
                inner = Path(*item.module.split("."), alias.name)
                is_module = (ROOT / inner).is_dir() or (ROOT / inner).with_suffix(".py").is_file()
                yield f"{item.module}.{alias.name}" if is_module else item.module
        elif isinstance(item, ast.Import):
            yield from (alias.name for alias in item.names)


def test_layers_of_the_solver_import_downwards():
    seen = set()
    for path in sorted((ROOT / "solver").rglob("*.py")):
        module = ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")
        if module == "solver":
            continue
        here = layer_of(module)
        seen.add(here)
        for other in every_import(path):
            if other.partition(".")[0] != "solver":
                continue
            assert layer_of(other) <= here, f"{module} imports {other}, which is above it"
    assert len(seen) == len(LAYERS), "a layer is empty"


@pytest.mark.parametrize("room", ["solver", "freecad_ortho"])
def test_no_files_import_each_other_in_a_circle(room):
    """Not even within functions, or for their types alone."""
    paths = sorted((ROOT / room).rglob("*.py"))
    files = {
        ".".join(path.relative_to(ROOT).with_suffix("").parts): path
        for path in paths
        if path.name != "__init__.py"
    }
    imports = {name: set(every_import(path)) & set(files) - {name} for name, path in files.items()}
    while free := [name for name, others in imports.items() if not others & set(imports)]:
        for name in free:
            del imports[name]
    assert not imports, f"in a circle, or above one: {sorted(imports)}"


@pytest.mark.parametrize("door", ["Init.py", "InitGui.py"])
def test_doors_import_nothing_heavy(door):
    tree = ast.parse((ROOT / door).read_text(encoding="utf-8"))
    imported = {module.partition(".")[0] for module in modules_at_import(tree)}
    allowed = {"__future__", "FreeCAD", "FreeCADGui", "freecad_ortho", "os", "sys"}
    assert imported <= allowed, f"{door} imports {sorted(imported - allowed)} when FreeCAD starts"


def test_the_package_behind_the_doors_is_light():
    code = "import sys, freecad_ortho.answers; "
    code += "print(sorted({'numpy', 'scipy', 'cadquery', 'solver'} & {*sys.modules}))"
    result = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert result.stdout.strip() == "[]"


def test_no_two_public_classes_share_a_name():
    seen = {}
    for path in sorted(path for room in PACKAGES for path in (ROOT / room).rglob("*.py")):
        for item in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(item, ast.ClassDef) and not item.name.startswith("_"):
                seen.setdefault(item.name, []).append(path.relative_to(ROOT).as_posix())
    twice = {name: paths for name, paths in seen.items() if len(paths) > 1}
    assert len(seen) > 400
    assert not twice
