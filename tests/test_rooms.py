"""The rooms of the project stay apart: who may import whom (see docs and README)."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
FREECAD = ("FreeCAD", "FreeCADGui", "Part", "PySide", "PySide2", "PySide6", "pivy")
CAD = ("cadquery", "OCP", "trimesh", "matplotlib", "ezdxf", "vtk")

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


@pytest.mark.parametrize("door", ["Init.py", "InitGui.py"])
def test_doors_import_nothing_heavy(door):
    tree = ast.parse((ROOT / door).read_text(encoding="utf-8"))
    imported = set()
    for statement in statements_at_import(tree):
        if isinstance(statement, ast.Import):
            imported.update(alias.name.partition(".")[0] for alias in statement.names)
        elif isinstance(statement, ast.ImportFrom):
            imported.add((statement.module or "").partition(".")[0])
    allowed = {"__future__", "FreeCAD", "FreeCADGui", "freecad_ortho", "os", "sys"}
    assert imported <= allowed, f"{door} imports {sorted(imported - allowed)} when FreeCAD starts"


def test_the_package_behind_the_doors_is_light():
    code = (
        "import sys, freecad_ortho; print(sorted({'numpy', 'scipy', 'cadquery'} & {*sys.modules}))"
    )
    result = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert result.stdout.strip() == "[]"
