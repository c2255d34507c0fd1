"""The steps behind demo.sh: net and parts, FreeCAD model, picture, closing table.

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
SURFACE = ROOT / "examples" / "data" / "demo_roof.step"
FILES = (*FABRICATION_FILES, "model.FCStd", "preview.png", "net.obj")
# What a design surface leads to besides.
BUILT = (*FILES, "edge-beam.csv", "net.json", "aligned.json", "aligned.obj")
# A net on the demo's own roof, and the unit of that.
EDGE, UNIT = "1.2", "m"


class DemoError(Exception):
    """One line for the user, and the exit code."""

    def __init__(self, message: str, code: int = 1) -> None:
        super().__init__(message)
        self.code = code


@dataclass(frozen=True)
class Job:
    """What the user wants built, lengths in mm.

    Attributes:
        source: file of a quad mesh, or of a design surface.
        is_surface: whether it is the latter.
        unit: of its coordinates; of a surface None for what its file says.
        edge: what ``--edge`` of the net on a surface is.
    """

    source: Path
    is_surface: bool
    unit: str | None
    edge: str
    height: float
    thickness: float
    panel_thickness: float
    gap: float


def main() -> int:
    """Run every step; the files appear in the folder together at the end."""
    started = time.monotonic()
    options = read_options()
    try:
        job = plan_surface(options) if options.mesh is None else plan_mesh(options)
        names = BUILT if job.is_surface else FILES
        with staged_folder(options.out) as folder:
            optimised = (build if job.is_surface else optimise_and_fabricate)(job, folder)
            start = folder / "aligned.obj" if job.is_surface else job.source
            net, unit = load(folder / "net.obj")
            millimetre = MILLIMETRES[unit or "mm"]
            drawn, net = load(start)[0].scaled(millimetre), net.scaled(millimetre)
            say("FreeCAD model and picture ...")
            pictures = build_model(job, folder, unit or "mm")
            off = optimised["off_surface"]["max"] * millimetre
            begin = demo_picture.Begin(drawn, off if job.is_surface else None)
            exact = optimised["status"] == "converged"
            with (folder / "parts.csv").open(encoding="utf-8", newline="") as stream:
                parts = list(csv.DictReader(stream))
            panels = sum(row["kind"] == "panel" for row in parts)
            title = f"{panels} flat panels on torsion-free beams"
            title = title if exact else f"{panels} panels on beams"
            demo_picture.compose(folder / "preview.png", pictures, title, begin, net)
            for path in pictures.values():
                path.unlink()
            missing = [name for name in names if not (folder / name).exists()]
            if missing:
                raise DemoError(f"not written: {', '.join(missing)}; please report this")
    except (DemoError, OrthoError) as error:
        say(f"demo.sh: {error}")
        return getattr(error, "code", 2)
    except KeyboardInterrupt:
        say("demo.sh: stopped; nothing was written")
        return 130
    seconds = time.monotonic() - started
    print(demo_table.table(begin, net, optimised, parts, f"{options.out}", names, seconds))
    return 0


def read_options() -> argparse.Namespace:
    """Read what demo.sh hands over."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=Path)
    parser.add_argument("--surface", type=Path)
    parser.add_argument("--mesh", type=Path)
    parser.add_argument("--edge")
    parser.add_argument("--unit", choices=MILLIMETRES)
    parser.add_argument("--height", type=float)
    parser.add_argument("--thickness", type=float)
    parser.add_argument("--panel-thickness", type=float)
    return parser.parse_args()


def plan_surface(options: argparse.Namespace) -> Job:
    """Settle a design surface, unit and dimensions."""
    own = options.surface is not None
    unit = options.unit or (None if own else UNIT)
    source = options.surface.resolve() if own else SURFACE
    edge = options.edge or ("" if own else EDGE)
    return job_of(options, source, True, unit, edge, 1.0)


def plan_mesh(options: argparse.Namespace) -> Job:
    """Settle a quad mesh, unit and dimensions."""
    mesh, named = load(options.mesh)
    unit = options.unit or named
    if unit not in MILLIMETRES:
        unit = likely_unit(mesh.mean_edge)
        say(
            f"unit: taken as {unit}, which makes the mean edge "
            f"{mesh.mean_edge * MILLIMETRES[unit]:,.0f} mm; give --unit for another"
        )
    # Ordinary building quads get the usual plates; small or huge ones plates in proportion.
    edge = mesh.mean_edge * MILLIMETRES[unit]
    factor = 1.0 if 500 <= edge <= 3000 else edge / 1000
    job = job_of(options, options.mesh.resolve(), False, unit, "", factor)
    if factor != 1.0:
        say(
            f"plates for a mean edge of {edge:,.3g} mm: {job.height:g} x {job.thickness:g} mm, "
            f"panels {job.panel_thickness:g} mm, gap {job.gap:g}"
        )
    return job


def job_of(
    options: argparse.Namespace,
    source: Path,
    is_surface: bool,
    unit: str | None,
    edge: str,
    factor: float,
) -> Job:
    """The job, with plates that are ``factor`` times the usual ones where nothing is said."""
    height = options.height or two_digits(200 * factor)
    thickness = options.thickness or two_digits(20 * factor)
    sheet = options.panel_thickness or two_digits(3 * factor)
    gap = two_digits(8 * factor)
    return Job(source, is_surface, unit, edge, height, thickness, sheet, gap)


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


def build(job: Job, folder: Path) -> dict[str, Any]:
    """Go the whole way from a design surface; the numbers of the exact net on it."""
    edge = ["--edge", job.edge] if job.edge else []
    unit = ["--unit", job.unit] if job.unit else []
    arguments = [*unit, *edge, "--net", "principal", *parts_of(job)]
    say("net on the surface, exact net, edge beam, beams and panels ...")
    command_line("build", str(job.source), *arguments, "-o", str(folder))
    report = json.loads((folder / "report.json").read_text("utf-8"))
    numbers: dict[str, Any] = report["build"]["stages"]["optimise"]["numbers"]
    return numbers


def optimise_and_fabricate(job: Job, folder: Path) -> dict[str, Any]:
    """Make a quad mesh exact, and parts of it; the numbers of the net.

    A mesh that did not converge is used all the same, and said.
    """
    say("principal mesh ...")
    report, net = folder / "report.json", str(folder / "net.obj")
    arguments = ["--net", "principal", "-o", net, "--report", str(report), "--unit", str(job.unit)]
    code = command_line("optimise", str(job.source), *arguments, accept=(0, 1))
    optimised: dict[str, Any] = json.loads(report.read_text("utf-8"))
    if code == 1:
        say("going on with the best mesh found; see the twist of the beams")
    say("beams and panels ...")
    command_line("fabricate", net, *parts_of(job), "-o", str(folder))
    both = {"optimise": optimised, "fabricate": json.loads(report.read_text("utf-8"))}
    report.write_text(json.dumps(both, indent=2) + "\n", "utf-8")
    return optimised


def parts_of(job: Job) -> list[str]:
    """Arguments that say what is built."""
    sizes = {
        "height": job.height,
        "thickness": job.thickness,
        "gap": job.gap,
        "panel-thickness": job.panel_thickness,
    }
    said = [word for name, size in sizes.items() for word in (f"--{name}", f"{size:g}")]
    return ["--system", "edge-beam+beams+panels" if job.is_surface else "beams+panels", *said]


def command_line(*arguments: str, accept: tuple[int, ...] = (0,)) -> int:
    """Run the project's own command line, which says on stderr what is wrong."""
    command = [sys.executable, "-m", "freecad_ortho", *arguments]
    # Its closing line on stdout names the passing folder in which the files are made.
    code = subprocess.run(command, stdout=subprocess.DEVNULL, check=False).returncode
    if code not in accept:
        raise DemoError(f"{arguments[0]} did not succeed (see the line above)", code=code or 1)
    return code


def build_model(job: Job, folder: Path, unit: str) -> dict[str, Path]:
    """Write model.FCStd in FreeCAD and return the pictures it made, by what they show."""
    pictures = {name: folder / f"picture-{name}.png" for name in ("before", "after")}
    with tempfile.TemporaryDirectory(prefix="ortho-demo-") as home:
        result = Path(home) / "result.txt"
        order = {
            "paths": [str(ROOT), str(ROOT / "scripts"), *packages()],
            "source": str(job.source),
            "is_surface": job.is_surface,
            # Only a .json file keeps the border that parts are trimmed along.
            "net": str(folder / ("net.json" if job.is_surface else "net.obj")),
            "unit": unit,
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
