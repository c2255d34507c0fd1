"""The command ``optimise``: run, show progress, write mesh and report together."""

from __future__ import annotations

import argparse
import json
import math
import sys
from collections.abc import Callable
from typing import Any

from freecad_ortho import api
from freecad_ortho.cli import net_options, reporting, values
from freecad_ortho.units import millimetres_per
from solver import Outcome, StepRecord
from solver.analysis.kinds import NODES
from solver.analysis.upright import side_remark
from solver.io.atomic import write_text
from solver.nets import nets_with
from solver.report import CONVERGED, Repeated, Report


def run(options: argparse.Namespace) -> bool:
    """Optimise as the options say; return whether the net was reached, as near as was asked."""
    read = reporting.read_net(options, mixed=True)
    settings = net_options.settings(options, read)
    values.refuse_unwritable(options.output, options.report)
    outcome = optimised(options, read, settings)
    wanted = values.write_mesh(options, outcome.mesh, read.unit, read.origin, read.near_border)
    if options.report:
        places = {"origin": read.origin.shift.tolist(), "file_origin": wanted.shift.tolist()}
        numbers = outcome.report.as_dict() | places
        write_text(options.report, json.dumps(numbers, indent=2) + "\n")
    tell(outcome, options.output, read)
    if wanted.far:
        sys.stdout.write(f"{values.about(wanted, read.unit)}\n")
    report = outcome.report
    return report.status == CONVERGED and report.is_within and report.is_repeated


def optimised(options: argparse.Namespace, read: api.ReadMesh, settings: dict[str, Any]) -> Outcome:
    """Optimise a mesh and show how far it is.

    Args:
        options: with ``net`` and ``verbose``.
        read: the mesh.
        settings: from :func:`net_options.settings`.

    Returns:
        the outcome, about the local origin of the mesh.
    """
    optimisation = api.start_optimisation(read.near, options.net, **settings)
    # Before the first step: whoever reads it need not wait for the end.
    side = side_remark(read.near, *settings["options"].load_vectors)
    for remark in [*optimisation.remarks, *([] if side is None else [side])]:
        sys.stderr.write(f"note: {remark}\n")
    with reporting.Progress(options.verbose) as progress:
        return optimisation.run(_follower(progress, settings["tolerance"]))


def _follower(progress: reporting.Progress, tolerance: float) -> Callable[[StepRecord], None]:
    """Turn step records into a bar that fills as the residual falls on a log scale."""
    whole = 0.0

    def follow(record: StepRecord) -> None:
        nonlocal whole
        left = math.log10(max(record.worst, tolerance) / tolerance)
        whole = whole or max(left, 1.0)
        done = 1.0 - left / whole
        residuals = ", ".join(f"{name} {value:.1e}" for name, value in record.residuals.items())
        progress(min(max(done, 0.0), 1.0), f"step {record.step}: {residuals}")

    return follow


def tell(outcome: Outcome, path: str, read: api.ReadMesh) -> None:
    """Say what was reached; on stderr where that is not what was asked for."""
    report, unit = outcome.report, read.unit
    moved, edge = report.moved, report.mean_edge
    most = f"{_digits(moved.max * edge)} {unit}"
    stream = sys.stdout if report.status == CONVERGED else sys.stderr
    stream.write(
        f"{report.status}: {report.message}; moved {moved.mean:.3g} mean edges on average, "
        f"{moved.max:.3g} at most ({most}); {report.seconds:.2f} s; {path}\n"
    )
    stream.write(_form(report, unit))
    if not report.is_within:
        sys.stderr.write(_beyond(report, unit))
    if report.repetition is not None:
        (stream if report.is_repeated else sys.stderr).write(
            _kinds(report, report.repetition, unit)
        )
    if report.far:
        sizes = (report.size_start, report.size)
        before, after = (" x ".join(map(_digits, size)) for size in sizes)
        stream.write(
            f"note: the shape moved by up to {most} ({moved.max:.1f} mean edges); its size was "
            f"{before} {unit} and is {after} {unit}\n"
        )
    for remark in report.remarks:
        if remark not in read.remarks:
            stream.write(f"note: {remark}\n")


def _form(report: Report, unit: str) -> str:
    """What is left of what was drawn."""
    form = report.form
    off, millimetre = form.off_surface, millimetres_per(unit)
    far, mean, border = (
        f"{_digits(length * millimetre)} mm" for length in (off.max, off.mean, form.border)
    )
    return (
        f"off the surface by {far} at most ({off.percent:.2g} % of the size), {mean} on average, "
        f"off the border by {border}; area x {form.area_ratio:.3f}, height x "
        f"{form.height_ratio:.3f}, evenness of lines {form.zigzag:.2f} (was "
        f"{form.zigzag_start:.2f}){_gap(report, millimetre)}\n"
    )


def _gap(report: Report, millimetre: float) -> str:
    """How far from flat the worst face is, where flat faces were asked for."""
    if not report.flat:
        return ""
    form = report.form
    return f"; largest gap {_digits(form.gap * millimetre)} mm, of face {form.gap_face}"


def _beyond(report: Report, unit: str) -> str:
    """Where a result is farther from the surface than it may be, and what to do."""
    off, allowed = report.form.off_surface, (report.within or 0.0) * millimetres_per(unit)
    far = _digits(off.max * millimetres_per(unit))
    return (
        f"within: {far} mm off the surface at face {off.face}, where {_digits(allowed)} mm are "
        "allowed; try: a start whose lines follow the curvature of the surface, a finer mesh, or "
        f"{_other_wishes(report)}\n"
    )


def _kinds(report: Report, repeated: Repeated, unit: str) -> str:
    """How many kinds of parts there are, and what to do where these are too many."""
    degrees = repeated.of == NODES
    factor, of = (1.0, "degrees") if degrees else (millimetres_per(unit), "mm")
    alike, miss = (
        f"{_digits(value * factor)} {of}" for value in (repeated.alike, repeated.largest_miss)
    )
    most = ", ".join(map(str, repeated.counts[:8])) + (", ..." if repeated.kinds > 8 else "")
    words = (
        f"{repeated.of}: {repeated.kinds} kinds within {alike}, "
        f"{repeated.kinds_before} before; of each {most}; the largest miss is "
        f"{miss}\n"
    )
    if repeated.is_reached:
        return words
    flag = "--alike-angle" if degrees else "--alike"
    remedies = [f"a larger {flag}", "more kinds", "a larger --within"]
    if report.net != "planar":
        remedies.append("--net planar, which has more freedom")
    return (
        f"{words}kinds: {repeated.kinds} were the fewest that were found where {repeated.asked} "
        f"are allowed; try: {', '.join(remedies[:-1])}, or {remedies[-1]}\n"
    )


def _other_wishes(report: Report) -> str:
    """What else could be asked for, where a net is too far from its surface."""
    if report.net in nets_with("flatness"):
        return "a larger distance or --flatness"
    return "a larger distance"


def _digits(length: float) -> str:
    """Four digits that count, without an exponent."""
    return f"{float(f'{length:.4g}'):.12g}"
