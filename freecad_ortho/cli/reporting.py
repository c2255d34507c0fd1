"""What the command line says: remarks and progress on stderr, results on stdout."""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING, Any

from freecad_ortho import api
from freecad_ortho.cli.values import about
from freecad_ortho.units import millimetres_per
from freecad_ortho.words import counted

if TYPE_CHECKING:
    from freecad_ortho.fabrication import Structure

_BAR = 30


def read_net(options: argparse.Namespace, mixed: bool = False) -> api.ReadMesh:
    """Read the input mesh and say on stderr what was mended.

    Its faces have four corners each, or any number where ``mixed`` ones are asked for.
    """
    read = api.read_mesh(options.input, options.unit, options.up, mixed)
    for remark in read.remarks:
        sys.stderr.write(f"note: {remark}\n")
    if read.origin.far:
        words = about(read.origin, read.unit).replace("coordinates", "all work is done", 1)
        sys.stderr.write(f"note: the mesh is far from the origin: {words}\n")
    return read


class Progress:
    """A bar on a terminal, with ``verbose`` a line for each new message, silence otherwise."""

    def __init__(self, verbose: bool) -> None:
        self._verbose, self._said = verbose, ""
        self._bar = sys.stderr.isatty() and not verbose

    def __enter__(self) -> Progress:
        """Begin."""
        return self

    def __exit__(self, *_: object) -> None:
        """Leave the terminal's line clean."""
        if self._bar:
            sys.stderr.write("\r\033[K")
            sys.stderr.flush()

    def __call__(self, fraction: float, words: str) -> None:
        """Show that ``fraction`` (0 to 1) of the work is done."""
        if self._bar:
            full = round(_BAR * min(max(fraction, 0.0), 1.0))
            sys.stderr.write(f"\r\033[K[{'#' * full}{'.' * (_BAR - full)}] {words}")
            sys.stderr.flush()
        elif self._verbose and words != self._said:
            self._said = words
            sys.stderr.write(f"{100 * fraction:3.0f} % {words}\n")


def fabrication_line(structure: Structure, folder: str) -> str:
    """One line that says what was made and where it is; what is out of the ordinary on stderr."""
    report = json.loads((Path(folder) / "report.json").read_text(encoding="utf-8"))
    for message in report["messages"]:
        sys.stderr.write(f"note: {message}\n")
    numbers = Counter(part.kind for part in structure.parts)
    counts = [counted(number, kind) for kind, number in numbers.items()]
    failed = len(report["verdict"]["failed"])
    words = f", {failed} beyond the limits" if failed else ""
    return f"{', '.join(counts)}, {report['mass_kg']:.1f} kg{words}; files are in {folder}"


def _multi_net_line(found: dict[str, Any] | None) -> str:
    """Whether a mesh is orthogonal in every rectangle of its parameter lines."""
    if found is None:
        return f"{'multi-net':<16}{'-':>12}{'-':>12}   not one grid of parameter lines"
    verdict = "yes" if found["is_multi_net"] else "no"
    more = ", or worse" if found["at_least"] else ""
    place = "rectangle from vertex {} to {}".format(*found["corners"])
    return f"{'multi-net':<16}{found['worst']:>12.3e}{'-':>12}   {place}: {verdict}{more}"


def _build_lines(score: dict[str, Any]) -> str:
    """The measures of buildability, the benchmark's own first."""
    short, long = score["length_range"]
    small, large = score["area_range"]
    rows = (
        (
            "planarity of faces",
            f"{score['planarity']:.4f}",
            "1 + mean miss / half the circumference; 1 where all are flat",
        ),
        ("joints", f"{score['joints']}", ""),
        (
            "kinds of joints",
            f"{score['joint_kinds']}",
            "directions of edges alike within 0.01, some 0.6 degrees",
        ),
        (
            "lengths of beams",
            f"{score['lengths']:.4f}",
            "1 + standard deviation / mean; 1 where all are equal",
        ),
        ("cross sections", f"{score['sections']}", "as given by --sections"),
        (
            "kinds of lengths",
            f"{score['length_kinds']}",
            f"alike within 2.5 mm; {short:.0f} to {long:.0f} mm long",
        ),
        (
            "kinds of panels",
            f"{score['panel_kinds']}",
            f"corners alike within 2.5 mm; {small:.2f} to {large:.2f} m2",
        ),
    )
    return "\n".join(
        [
            "buildability, less is better",
            *(f"{name:<20}{value:>10}   {words}".rstrip() for name, value, words in rows),
        ]
    )


def _faces(counts: dict[str, int]) -> list[str]:
    """How many faces have how many corners, in words."""
    names = {"3": "triangle", "4": "quad", "5": "pentagon", "6": "hexagon"}
    return [counted(count, names.get(n, f"{n}-gon")) for n, count in counts.items()]


def check_table(result: dict[str, Any]) -> str:
    """Measures of a mesh as a table for people."""
    size = " x ".join(f"{length:.6g}" for length in result["size"])
    lines = [
        f"{result['file']}: "
        + ", ".join(
            (
                counted(result["vertices"], "vertex", "vertices"),
                *_faces(result["corners_of_faces"]),
                counted(result["components"], "component"),
                counted(result["irregular_vertices"], "irregular vertex", "irregular vertices"),
            )
        ),
        f"size {size} {result['unit']}, mean edge {result['mean_edge']:.6g} {result['unit']}",
        f"{'measure':<16}{'worst':>12}{'mean':>12}   worst at",
    ]
    for name, entry in result["measures"].items():
        place = "-" if entry["worst"] is None else f"{entry['where']} {entry['worst']}"
        if name == "planarity":
            gap = result["planarity_gap"] * millimetres_per(result["unit"])
            place += f"; the largest gap is {gap:.2g} mm"
        if entry["exempt"]:
            place += f"; without {entry['exempt']} at irregular vertices"
        lines.append(f"{name:<16}{entry['max']:>12.3e}{entry['mean']:>12.3e}   {place}")
    lines.append(f"{'edge ratio':<16}{result['edge_ratio']:>12.3f}")
    lines.append(f"{'folded faces':<16}{result['flipped_faces']:>12d}")
    lines.append(_multi_net_line(result["multi_net"]))
    nets = result["advice"]["nets"]
    titles = [advice["net"] + (" --diagonal" if advice["diagonal"] else "") for advice in nets]
    wide = max(map(len, ("net", *titles)))
    lines.append(f"{'net':<{wide}}{'beyond right angles':>22}   can it be near?")
    for title, advice in zip(titles, nets, strict=True):
        verdict = "yes" if advice["possible"] else "no"
        reason = f": {advice['reason']}" if advice["reason"] else ""
        lines.append(f"{title:<{wide}}{advice['beyond']:>22.1e}   {verdict}{reason}")
    lines.append(result["advice"]["recommendation"])
    if "build" in result:
        lines.append(_build_lines(result["build"]))
    return "\n".join(lines)
