"""The steps behind demo.sh: optimise, fabricate, FreeCAD model, picture, closing table.

Called by demo.sh, which has checked the options and installed what is needed.
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

import demo_picture
import demo_table

from freecad_ortho.fabrication.files import FILES as FABRICATION_FILES
from freecad_ortho.units import MILLIMETRES
from solver.errors import OrthoError
from solver.io.atomic import staged_folder
from solver.io.obj import read_obj
from solver.mesh.intake import quad_mesh
from solver.mesh.quadmesh import QuadMesh

ROOT = Path(__file__).resolve().parents[1]
FREECAD_SECONDS = 900
FILES = (*FABRICATION_FILES, "model.FCStd", "preview.png", "principal.obj")


class DemoError(Exception):
    """One line for the user, and the exit code."""

    def __init__(self, message: str, code: int = 1) -> None:
        super().__init__(message)
        self.code = code


@dataclass(frozen=True)
class Job:
    """What the user wants built, lengths in mm."""

    mesh: Path
    unit: str
    height: float
    thickness: float
    panel_thickness: float
    gap: float


def main() -> int:
    """Run every step; the files appear in the folder together at the end."""
    started = time.monotonic()
    options = read_options()
    try:
        job, drawn = plan(options)
        with staged_folder(options.out) as folder:
            say("principal mesh ...")
            optimised = optimise(job, folder)
            say("beams and panels ...")
            fabricated = fabricate(job, folder)
            principal = load(folder / "principal.obj")[0].scaled(MILLIMETRES[job.unit])
            say("FreeCAD model and picture ...")
            pictures = build_model(job, folder)
            exact = optimised["status"] == "converged"
            demo_picture.compose(folder / "preview.png", pictures, drawn, principal, exact)
            for path in pictures.values():
                path.unlink()
            report = {"optimise": optimised, "fabricate": fabricated}
            (folder / "report.json").write_text(json.dumps(report, indent=2) + "\n", "utf-8")
            with (folder / "parts.csv").open(encoding="utf-8", newline="") as stream:
                parts = list(csv.DictReader(stream))
            missing = [name for name in FILES if not (folder / name).exists()]
            if missing:
                raise DemoError(f"not written: {', '.join(missing)}; please report this")
    except (DemoError, OrthoError) as error:
        say(f"demo.sh: {error}")
        return getattr(error, "code", 2)
    except KeyboardInterrupt:
        say("demo.sh: stopped; nothing was written")
        return 130
    seconds = time.monotonic() - started
    print(demo_table.table(drawn, principal, optimised, parts, options.out, FILES, seconds))
    return 0


def read_options() -> argparse.Namespace:
    """Read what demo.sh hands over."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=Path)
    parser.add_argument("--mesh", type=Path, default=ROOT / "examples" / "data" / "demo_roof.obj")
    parser.add_argument("--unit", choices=MILLIMETRES)
    parser.add_argument("--height", type=float)
    parser.add_argument("--thickness", type=float)
    parser.add_argument("--panel-thickness", type=float)
    return parser.parse_args()


def plan(options: argparse.Namespace) -> tuple[Job, QuadMesh]:
    """Settle unit and dimensions; return them with the mesh as drawn, in mm."""
    mesh, named = load(options.mesh)
    unit = options.unit or named
    if unit not in MILLIMETRES:
        unit = likely_unit(mesh.mean_edge)
        say(
            f"unit: taken as {unit}, which makes the mean edge "
            f"{mesh.mean_edge * MILLIMETRES[unit]:,.0f} mm; give --unit for another"
        )
    drawn = mesh.scaled(MILLIMETRES[unit])
    # Ordinary building quads get the usual plates; small or huge ones plates in proportion.
    edge = drawn.mean_edge
    factor = 1.0 if 500 <= edge <= 3000 else edge / 1000
    height = options.height or two_digits(200 * factor)
    thickness = options.thickness or two_digits(20 * factor)
    sheet = options.panel_thickness or two_digits(3 * factor)
    gap = two_digits(8 * factor)
    if factor != 1.0:
        say(
            f"plates for a mean edge of {edge:,.3g} mm: {height:g} x {thickness:g} mm, panels "
            f"{sheet:g} mm, gap {gap:g}"
        )
    return Job(options.mesh.resolve(), unit, height, thickness, sheet, gap), drawn


def load(path: Path) -> tuple[QuadMesh, str | None]:
    """Read a quad mesh and the unit that its file names."""
    data = read_obj(path)
    mesh, _ = quad_mesh(data.vertices, data.polygons)
    return mesh, data.unit


def likely_unit(mean_edge: float) -> str:
    """Guess a unit from a mean edge: the quads of a building are decimetres to metres wide."""
    if mean_edge >= 100:
        return "mm"
    return "cm" if mean_edge >= 10 else "m"


def two_digits(value: float) -> float:
    """Round to two significant digits."""
    return float(f"{value:.2g}")


def optimise(job: Job, folder: Path) -> dict[str, Any]:
    """Write principal.obj; a mesh that did not converge is used all the same, and said."""
    report = folder / "report.json"
    arguments = ["--net", "principal", "-o", str(folder / "principal.obj")]
    arguments += ["--report", str(report), "--unit", job.unit]
    code = command_line("optimise", str(job.mesh), *arguments, accept=(0, 1))
    result: dict[str, Any] = json.loads(report.read_text("utf-8"))
    if code == 1:
        say("going on with the best mesh found; see the twist of the beams")
    return result


def fabricate(job: Job, folder: Path) -> dict[str, Any]:
    """Write structure.step, flat.dxf and parts.csv."""
    arguments = ["--system", "beams+panels", "--height", f"{job.height:g}"]
    arguments += ["--thickness", f"{job.thickness:g}", "--gap", f"{job.gap:g}", "-o", str(folder)]
    arguments += ["--panel-thickness", f"{job.panel_thickness:g}"]
    command_line("fabricate", str(folder / "principal.obj"), *arguments)
    result: dict[str, Any] = json.loads((folder / "report.json").read_text("utf-8"))
    return result


def command_line(*arguments: str, accept: tuple[int, ...] = (0,)) -> int:
    """Run the project's own command line, which says on stderr what is wrong."""
    command = [sys.executable, "-m", "freecad_ortho", *arguments]
    # Its closing line on stdout names the passing folder in which the files are made.
    code = subprocess.run(command, stdout=subprocess.DEVNULL, check=False).returncode
    if code not in accept:
        raise DemoError(f"{arguments[0]} did not succeed (see the line above)", code=code or 1)
    return code


def build_model(job: Job, folder: Path) -> dict[str, Path]:
    """Write model.FCStd in FreeCAD and return the pictures it made, by what they show."""
    pictures = {name: folder / f"picture-{name}.png" for name in ("before", "after")}
    with tempfile.TemporaryDirectory(prefix="ortho-demo-") as home:
        result = Path(home) / "result.txt"
        order = {
            "paths": [str(ROOT), str(ROOT / "scripts"), *packages()],
            "drawn": str(job.mesh),
            "principal": str(folder / "principal.obj"),
            "unit": job.unit,
            "height": job.height,
            "thickness": job.thickness,
            "panel_thickness": job.panel_thickness,
            "gap": job.gap,
            "model": str(folder / "model.FCStd"),
            "decades": [demo_picture.LOWEST_DECADE, demo_picture.HIGHEST_DECADE],
            "pictures": {name: str(path) for name, path in pictures.items()},
            "result": str(result),
        }
        log = Path(home) / "log.txt"
        with log.open("w", encoding="utf-8") as stream:
            run_freecad(freecad_environment(home, order), stream)
        answer = result.read_text("utf-8") if result.exists() else ""
        if answer != "done":
            say(log.read_text("utf-8", errors="replace")[-2000:])
            raise DemoError(answer or "FreeCAD ended early; what it said stands above")
    return pictures


def run_freecad(environment: dict[str, str], log: IO[str]) -> None:
    """Run the document script; it, its screen and all they started end here."""
    try:
        process = subprocess.Popen(
            freecad_command(),
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
    except OSError as error:
        raise DemoError(f"FreeCAD cannot be started ({error.strerror})") from None
    try:
        process.wait(FREECAD_SECONDS)
    except subprocess.TimeoutExpired:
        raise DemoError(f"FreeCAD was not done in {FREECAD_SECONDS} s") from None
    finally:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGTERM)
            process.wait()


def freecad_command() -> list[str]:
    """FreeCAD with the document script, on a virtual screen where there is one."""
    command = [os.environ["ORTHO_FREECAD"], str(ROOT / "scripts" / "demo_freecad.py")]
    if sys.platform.startswith("linux"):
        screen = ["xvfb-run", "-a", "-s", "-screen 0 1680x1050x24"]
        command = screen + command
    return command


def packages() -> list[str]:
    """Folders of the virtual environment's packages."""
    return [path for path in sys.path if path.endswith("site-packages")]


def freecad_environment(home: str, order: dict[str, Any]) -> dict[str, str]:
    """The user's environment, with settings that touch nobody's own."""
    return {
        **os.environ,
        "FREECAD_USER_HOME": home,
        # FreeCAD's start page refuses to run as root otherwise.
        "QTWEBENGINE_DISABLE_SANDBOX": "1",
        "ORTHO_DEMO": json.dumps(order),
    }


def say(text: str) -> None:
    """Tell the user how far it is."""
    print(text, file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main())
