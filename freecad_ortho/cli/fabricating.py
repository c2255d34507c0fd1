"""The command fabricate: a net becomes the parts of one or more systems, and their files."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Any

from freecad_ortho import api, fabrication
from freecad_ortho.cli import options as arguments
from freecad_ortho.cli import reporting, values
from freecad_ortho.cli.endings import EXIT_OK, kept_whole, past_stopping
from freecad_ortho.curve_files import read_curves
from freecad_ortho.fabrication.limits import Limits
from freecad_ortho.fabrication.material import BUILD_UPS, MATERIALS
from freecad_ortho.fabrication.packages import missing_package_named
from freecad_ortho.fabrication.report.way import StagesBefore
from freecad_ortho.fabrication.site import FAMILY_CHOICES
from freecad_ortho.fabrication.systems import SYSTEMS
from freecad_ortho.fabrication.workers import WORKERS
from freecad_ortho.fabrication.workshop import Workshop
from freecad_ortho.units import millimetres_per
from solver.errors import InputError
from solver.io.polygons import keeps_border
from solver.mesh.quadmesh import FloatArray
from solver.option import Option

# A workshop's own as well, so of use with every system.
_SHARED = {option.name for option in Workshop.options}


def add(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    add_settings(parser)
    add_workers(parser)
    parser.add_argument("-o", "--output", required=True, metavar="DIR", help="folder of the files")
    values.add_origin(parser, keep=False)
    parser.add_argument("-v", "--verbose", action="store_true", help="say what is being done")
    parser.set_defaults(run=run)


def add_workers(parser: argparse.ArgumentParser) -> None:
    """Add the option that says how many share the work; the files are the same."""
    arguments.add(parser, WORKERS)


def add_settings(parser: argparse.ArgumentParser) -> None:
    """Add the options that say what is built, those of every system and of the workshop."""
    parser.add_argument("--system", default="beams+panels", metavar="NAME[+NAME...]")
    parser.epilog = f"systems: {', '.join(SYSTEMS)}"
    group = parser.add_argument_group(
        "sizes", "each begins with the systems that have it; others refuse it"
    )
    for name, option in _options().items():
        if name not in _SHARED:
            users = _users(option)
            before = f"{', '.join(users)}: "
            arguments.add(group, option, before, _defaults(users), length="MM")
    trim = parser.add_mutually_exclusive_group()
    trim.add_argument(
        "--trim-along",
        action="append",
        metavar="FILE",
        help="points of a closed curve along which parts are trimmed, in the net's unit, a 3DM "
        "file of curves, or a .json net that has a border; may be repeated (default: the net's "
        "own)",
    )
    trim.add_argument(
        "--untrimmed", action="store_true", help="build all of a net that overhangs its border"
    )
    parser.add_argument("--family", default="both", metavar="|".join(FAMILY_CHOICES))
    parser.add_argument("--lines", metavar="I,J,...", help="these parameter lines only, from 0")
    parser.add_argument(
        "--material",
        default="steel",
        metavar="NAME[,SYSTEM=NAME...]",
        help="of everything, and of single systems, as steel,panels=glass (default: steel); there "
        f"are {', '.join(MATERIALS)}, and build-ups of glass such as {BUILD_UPS[3]}",
    )
    parser.add_argument(
        "--density",
        type=float,
        metavar="KG/M3",
        help="of what has no material named for it alone (default: the material's)",
    )
    parser.add_argument(
        "--check",
        metavar="FILE",
        help="check.json that the command stand wrote for this net, told in the reports",
    )
    held = parser.add_argument_group("limits", "a part that exceeds one is named in the reports")
    for option in Limits.options:
        arguments.add(held, option, length="MM")
    shop = parser.add_argument_group("workshop", "what parts are cut from and with")
    for option in Workshop.options:
        arguments.add(shop, option, length="MM")


def run(options: argparse.Namespace) -> int:
    """Build the structure and write its files."""
    words = fabricated(options, reporting.read_net(options, mixed=True), Path(options.input).stem)
    sys.stdout.write(f"{words}\n")
    return EXIT_OK


def refuse_unfit(options: argparse.Namespace) -> None:
    """Refuse, before any net is there, what can be used with none.

    Raises:
        InputError: no such system, material or size, or a value that cannot be used.
    """
    Workshop.of(arguments.given(Workshop.options, options))
    Limits.of(arguments.given(Limits.options, options))
    names = options.system.split("+")
    materials = fabrication.materials_of(options.material, names, options.density)
    fabrication.systems_of(options.system, _sizes(options), materials)
    fabrication.Selection(options.family, _lines(options))


def fabricated(
    options: argparse.Namespace, read: api.ReadMesh, project: str, way: StagesBefore | None = None
) -> str:
    """Build the structure and write its files; a line that says what was made.

    Args:
        options: of the command.
        read: the net.
        project: what the readable report is headed by.
        way: what the reports begin with.

    Raises:
        InputError: options that cannot be used.
        OutputError: the folder cannot be written.
    """
    workshop = arguments.given(Workshop.options, options)
    Workshop.of(workshop)
    shared = arguments.given((WORKERS,), options)
    WORKERS.check(shared.get(WORKERS.name))
    scale = millimetres_per(read.unit)
    structure = api.fabricate(
        read.mesh,
        options.system,
        family=options.family,
        lines=_lines(options),
        material=options.material,
        density=options.density,
        unit=read.unit,
        border=_border(options, read),
        limits=Limits.of(arguments.given(Limits.options, options)),
        **_sizes(options),
    )
    with kept_whole(), missing_package_named():
        import cadquery  # noqa: F401
        import ezdxf  # noqa: F401
    with reporting.Progress(options.verbose) as progress:

        def say(done: float, words: str) -> None:
            progress(done, words)
            if done >= 1.0:
                # Finished files are moved into place next: from here on the run is not stopped.
                past_stopping()

        api.write_fabrication(
            structure,
            options.output,
            say,
            **shared,
            project=project,
            way=way,
            check=options.check,
            origin=values.origin_of(options, read.origin).scaled(scale).shift.tolist(),
            **workshop,
        )
    return reporting.fabrication_line(structure, options.output)


def _lines(options: argparse.Namespace) -> tuple[int, ...] | None:
    return None if options.lines is None else values.whole_numbers("--lines", options.lines)


def _border(options: argparse.Namespace, read: api.ReadMesh) -> list[FloatArray]:
    """The closed curves along which parts are trimmed, in the unit of the net.

    Raises:
        InputError: a file without such curves.
    """
    if options.untrimmed:
        return []
    if options.trim_along is None:
        return list(read.border)
    lines: list[FloatArray] = []
    for path in options.trim_along:
        if not keeps_border(path):
            lines += read_curves(path, read.unit, options.up)
            continue
        other = api.read_mesh(path, options.unit, options.up)
        if not other.border:
            raise InputError(f"{path}: has no border; name another file, or build --untrimmed")
        scale = millimetres_per(other.unit) / millimetres_per(read.unit)
        lines += [scale * line for line in other.border]
    return lines


def _sizes(options: argparse.Namespace) -> dict[str, Any]:
    """The sizes that the user gave; those that a workshop has too only where a system has them."""
    chosen = options.system.split("+")
    return {
        name: value
        for name, value in arguments.given(_options().values(), options).items()
        if name not in _SHARED or set(chosen) & set(_users(_options()[name]))
    }


def _options() -> dict[str, Option]:
    """Every option of every system by name; systems share those of the same name."""
    return {option.name: option for system in SYSTEMS.values() for option in system.options}


def _users(option: Option) -> dict[str, Any]:
    """Systems that have an option, and their defaults."""
    return {
        name: each.default
        for name, system in SYSTEMS.items()
        for each in system.options
        if each.name == option.name
    }


def _defaults(users: dict[str, Any]) -> str:
    """The default in words; where systems differ, whose it is."""
    by_value: dict[Any, list[str]] = {}
    for name, default in users.items():
        by_value.setdefault(default, []).append(name)
    if len(by_value) == 1:
        return arguments.shown(next(iter(by_value)))
    return "; ".join(
        f"{arguments.shown(value)} for {', '.join(of)}" for value, of in by_value.items()
    )
