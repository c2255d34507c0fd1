"""Saves a small document as this version of the workbench does, for tests of later versions.

usage: python scripts/document_fixture.py NAME [PROJECT]

Writes tests/freecad/fixtures/NAME.FCStd and what it holds as NAME.json. NAME is the version.
PROJECT is a checkout of an older version, with its .venv, instead of this one. FreeCAD itself runs
this file again, in its window, so that colours and visibility are saved too.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "tests" / "freecad" / "fixtures"


def launch(name: str, project: Path) -> None:
    """Start FreeCAD as a new user who has the workbench of the project."""
    with tempfile.TemporaryDirectory() as home:
        for data in ("FreeCAD", "FreeCAD/v1-1"):
            mods = Path(home) / ".local" / "share" / data / "Mod"
            mods.mkdir(parents=True)
            (mods / "Ortho").symlink_to(project.resolve(), target_is_directory=True)
        settings = {"HOME": home, "ORTHO_FIXTURE": str(FOLDER / name)}
        freecad = os.environ.get("ORTHO_FREECAD", "freecad")
        command = ["xvfb-run", "-a", freecad, str(Path(__file__).resolve())]
        environment = {**os.environ, **settings, "QTWEBENGINE_DISABLE_SANDBOX": "1"}
        subprocess.run(command, env=environment, check=True, timeout=120)


def build(target: Path) -> None:
    """Save a net, beams and panels; note what they are."""
    import FreeCAD

    import freecad_ortho
    from freecad_ortho import api, convert

    document = FreeCAD.newDocument("Fixture")
    net = api.import_net(_mesh(target.parent), document)
    api.optimise_net(net, net="principal")
    beams = api.add_beams(net, height=180.0, thickness=10.0, offset="below")
    panels = api.add_panels(net, beams=beams, gap=14.0)
    panels.Label = "Roof panels"
    net.ColourMap = "Orthogonality"
    net.SourceFile = "fixture.obj"
    document.recompute()
    holds = {
        "project": freecad_ortho.__version__,
        "freecad": ".".join(FreeCAD.Version()[:3]),
        "vertices": convert.array(net.Vertices).tolist(),
        "faces": list(net.Faces),
        "report": json.loads(net.LastReport),
        "structures": {
            item.Name: {
                "label": item.Label,
                "parts": list(item.PartNames),
                "volumes": [solid.Volume for solid in item.Shape.Solids],
                "centre": list(item.Shape.CenterOfGravity),
            }
            for item in (beams, panels)
        },
    }
    # FreeCAD would keep what it overwrites beside it.
    target.with_name(target.name + ".FCStd").unlink(missing_ok=True)
    document.saveAs(str(target.with_name(target.name + ".FCStd")))
    FreeCAD.closeDocument(document.Name)
    target.with_name(target.name + ".json").write_text(json.dumps(holds), encoding="utf-8")


def _mesh(folder: Path) -> Path:
    """Write a small grid over a wave."""
    path = folder / "fixture.obj"
    lines = [f"v {1500 * i} {1400 * j + 90 * i} {60 * i * i - 40 * j * j}" for i, j in _grid(5, 4)]
    lines += [
        f"f {k(i, j)} {k(i + 1, j)} {k(i + 1, j + 1)} {k(i, j + 1)}"
        for k in (lambda i, j: 4 * i + j + 1,)
        for i, j in _grid(4, 3)
    ]
    path.write_text("\n".join(lines), encoding="utf-8")
    return path


def _grid(m: int, n: int) -> list[tuple[int, int]]:
    return [(i, j) for i in range(m) for j in range(n)]


def build_and_quit() -> None:
    """Run inside FreeCAD."""
    from PySide import QtGui

    target = Path(os.environ["ORTHO_FIXTURE"])
    try:
        build(target)
    finally:
        (target.parent / "fixture.obj").unlink(missing_ok=True)
        QtGui.QApplication.quit()


if "FreeCAD" in sys.modules:
    from PySide import QtCore

    QtCore.QTimer.singleShot(1000, build_and_quit)
elif __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    FOLDER.mkdir(exist_ok=True)
    launch(sys.argv[1], Path(sys.argv[2]) if len(sys.argv) > 2 else ROOT)
