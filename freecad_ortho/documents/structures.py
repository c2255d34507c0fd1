"""Structures in documents: adding them to nets and writing what a workshop needs."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import FreeCAD

from freecad_ortho import convert
from freecad_ortho.documents.common import (
    open_document,
    progress,
    removed_on_failure,
    require_net,
    transaction,
    unmarked_on_failure,
)
from freecad_ortho.fabricating import write_fabrication
from freecad_ortho.fabrication import SYSTEMS, Selection, Workshop, system_of
from freecad_ortho.fabrication import material as known_material
from freecad_ortho.fabrication.packages import missing_package_named
from freecad_ortho.objects import build, outdated, places
from freecad_ortho.objects import structure as structure_object
from freecad_ortho.objects.option_properties import stored, with_capital
from freecad_ortho.objects.structural_check import is_check
from freecad_ortho.objects.system_properties import PANEL_THICKNESS, options_of, values
from solver.errors import InputError
from solver.option import one_of

if TYPE_CHECKING:
    # Of the standard library from Python 3.11 on.
    from typing_extensions import Unpack

    from freecad_ortho.keywords import Sizes, StructureSettings, WorkshopSettings
    from freecad_ortho.option_keywords import (
        FamilyWord,
    )

    Length = float | str | FreeCAD.Units.Quantity
    Progress = Callable[[float, str], None]

# Settings that every system has -> the property and its value for one.
_COMMON: dict[str, tuple[str, Callable[[Any], Any]]] = {
    "beams": ("OnBeams", lambda beams: beams),
    "family": ("Family", str.capitalize),
    "lines": ("Lines", list),
    "trimmed": ("Trimmed", bool),
    "material": ("Material", with_capital),
    "density": ("Density", float),
}


def add_structure(
    net: FreeCAD.DocumentObject,
    system: str,
    *,
    beams: FreeCAD.DocumentObject | None = None,
    family: FamilyWord = "both",
    lines: Sequence[int] = (),
    trimmed: bool = True,
    material: str = "steel",
    density: float = 0.0,
    **sizes: Unpack[Sizes],
) -> FreeCAD.DocumentObject:
    """Add a Structure of one system on a Net.

    Args:
        net: the Net.
        system: name of the system, as on the command line: ``"beams"``, ``"panels"`` ...
        beams: a Structure of beams on the same Net that panels lie on and nodes join; mitred ones
            end before hubs from then on.
        family: parameter lines that are built on: ``"u"``, ``"v"`` or ``"both"``.
        lines: numbers of these lines; empty for all.
        trimmed: whether parts are cut along the border of the surface, where the net has one.
        material: of all parts, as on the command line; parts of a build-up, such as
            ``"glass:8+1.52+8"`` or ``"glass:6/16/44.2"``, have its thickness.
        density: kg/m3, 0 for the material's own.
        sizes: settings of the system by name (``height="0.2 m"``), see
            :class:`freecad_ortho.keywords.Sizes`; lengths as numbers of mm,
            quantities or texts; those that are not given take their defaults.

    Raises:
        InputError: an unknown system or setting, or sizes that do not fit the mesh; the document is
            unchanged.
    """
    require_net(net)
    one_of("system", system, SYSTEMS)
    common = {"beams": beams, "family": family, "lines": lines, "material": material}
    common |= {"trimmed": trimmed, "density": density}
    properties = _properties(system, {**common, **sizes})
    title = next(title for title, name in structure_object.TITLES.items() if name == system)
    document = net.Document
    with transaction(document, FreeCAD.Qt.translate("Ortho", title)):
        feature = structure_object.create(document, title, Net=net, **properties)
        places.join_container(feature, net)
        with (
            _ends_kept_on_failure(beams),
            removed_on_failure(feature),
            progress(FreeCAD.Qt.translate("Ortho", title)) as say,
        ):
            told = structure_object.acquaint(feature)
            structure_object.rebuild(feature, say)
        feature.purgeTouched()
        if told:
            document.recompute()
        # As Part does with what a shape is made of: otherwise both are drawn into each other.
        net.Visibility = False
    return feature


@contextmanager
def _ends_kept_on_failure(beams: Any) -> Iterator[None]:
    """Give beams their ends back where what would have ended them before hubs fails."""
    ends = getattr(beams, "Ends", None)
    try:
        yield
    except BaseException:
        if ends is not None and beams.Ends != ends:
            beams.Ends = ends
            beams.purgeTouched()
        raise


def change_structure(
    target: FreeCAD.DocumentObject, /, **settings: Unpack[StructureSettings]
) -> None:
    """Give a Structure other settings and build it anew; what stands on it follows.

    Args:
        target: the Structure.
        settings: as for :func:`add_structure`; what is not given stays, and None stands for what
            a setting is without being given.

    Raises:
        InputError: not a structure, an unknown setting, or sizes that do not fit the mesh; the
            structure is unchanged.
        OrthoError: Esc was pressed; the structure is unchanged.
    """
    document = _document_of(target)
    with unmarked_on_failure(target), transaction(document, _change_title(target)):
        _change(target, settings)


def try_structure(target: FreeCAD.DocumentObject, /, **settings: Unpack[StructureSettings]) -> None:
    """Do as :func:`change_structure` in an undo step that stays open: to be committed or aborted.

    Raises:
        OrthoError: as there; a step that was not open before is not open after it.
    """
    document = _document_of(target)
    before = document.HasPendingTransaction
    if not before:
        document.openTransaction(_change_title(target))
    with unmarked_on_failure(target):
        try:
            _change(target, settings)
        except BaseException:
            if not before:
                document.abortTransaction()
            raise


def _document_of(target: FreeCAD.DocumentObject) -> FreeCAD.Document:
    places.refuse_link(target)
    if not structure_object.is_structure(target):
        label = getattr(target, "Label", target)
        raise InputError(f"structure: {label} is none; add beams or panels to a net, for one")
    return target.Document


def _change_title(target: FreeCAD.DocumentObject) -> str:
    return FreeCAD.Qt.translate("Ortho", "Change {}").format(target.Label)


def _change(target: FreeCAD.DocumentObject, settings: dict[str, Any]) -> None:
    system = structure_object.TITLES[target.System]
    properties = _properties(system, settings, values(target, system))
    before = {name: getattr(target, name) for name in properties}
    try:
        structure_object.set_properties(target, properties)
        if target.BuiltFrom != build.fingerprint([target]):
            with progress(_change_title(target)) as say:
                structure_object.rebuild(target, say)
    except BaseException:
        structure_object.set_properties(target, before)
        raise
    # It is built; what stands on it is still to follow.
    target.purgeTouched()
    for item in target.InList:
        item.touch()
    target.Document.recompute()


def update_structures(document: FreeCAD.Document | None = None) -> list[FreeCAD.DocumentObject]:
    """Build those structures, flat patterns and checks anew that wait to be asked.

    They wait because they take long, because they do not follow automatically, or because what they
    stand on waits.

    Returns:
        What was built.

    Raises:
        InputError: no document is open, or sizes that no longer fit; the document is unchanged.
        OrthoError: Esc was pressed; the document is unchanged.
    """
    target = open_document(document)
    chosen = outdated.waiting(target)
    title = FreeCAD.Qt.translate("Ortho", "Update structures")
    with transaction(target, title), progress(title) as say:
        for number, feature in enumerate(chosen):
            feature.Proxy.rebuild(feature, _share(say, number, len(chosen)))
            feature.purgeTouched()
    return chosen


def _share(say: Progress | None, number: int, count: int) -> Progress | None:
    """The progress of one piece of work out of several."""
    if say is None:
        return None
    return lambda fraction, words: say((number + fraction) / count, words)


def export_fabrication(
    structures: FreeCAD.DocumentObject | Sequence[FreeCAD.DocumentObject],
    folder: str | os.PathLike[str],
    *,
    workers: int | None = None,
    origin: str | Sequence[float] = "local",
    **workshop: Unpack[WorkshopSettings],
) -> list[Path]:
    """Write solids, flat patterns, lists and reports of structures on one net.

    Parts are written where they are seen in the document. A structural check of the net that is up
    to date is told in the reports.

    Args:
        structures: a Structure, or several of different systems on the same Net.
        folder: made if it is not there.
        workers: processes that share the work; for large structures.
        origin: what coordinates are measured from: ``local`` for the document's origin, or a round
            point near a net that is far from it; ``keep`` for the origin of the net's file; or a
            point in the coordinates of that file, mm.
        workshop: what parts are cut from and with, and how drawings are written, as on the command
            line: ``sheet="3000x1500"``, ``kerf``, ``dxf="parts"`` ...; lengths in mm or with their
            unit. Lamellas are spliced where ``stock`` says so, in the document too; without it the
            stock is theirs, and 0 stands for as long as it takes.

    Returns:
        The files written.

    Raises:
        InputError: nothing to export, structures that do not go together, a part that does not
            fit the sheet or the stock.
        OutputError: the folder cannot be written; nothing half-written is left behind.
        OrthoError: Esc was pressed; the folder is as it was.
    """
    chosen = list(structures) if isinstance(structures, (list, tuple)) else [structures]
    lengths = [option.name for option in Workshop.options if option.kind == "length"]
    sizes = {
        name: convert.millimetres(workshop[name], name)
        for name in lengths
        if workshop.get(name) is not None
    }
    with _one_stock(chosen, sizes.get("stock")) as stock:
        structure = build.structure(chosen, placed=True)
        with (
            missing_package_named(),
            progress(FreeCAD.Qt.translate("Ortho", "Writing fabrication files")) as say,
        ):
            settings = lost_on_bars(chosen) | workshop | sizes | {"stock": stock}
            project = chosen[0].Document.Label
            return write_fabrication(
                structure,
                folder,
                say,
                workers=workers,
                project=project,
                origin=origin,
                check=_check_of(chosen[0].Net),
                **settings,
            )


def _check_of(net: FreeCAD.DocumentObject) -> dict[str, Any] | None:
    """Numbers of the structural check of a net, if there is one that is up to date."""
    found = [item for item in net.InList if is_check(item) and item.Report and not item.Outdated]
    return json.loads(found[0].Report) if found else None


def lost_on_bars(features: Sequence[Any]) -> dict[str, float]:
    """What trimmed ends and saw cuts take from the bars that lamellas were cut for, mm."""
    lamellas = [item for item in features if "Trim" in item.PropertiesList]
    if not lamellas:
        return {}
    return {
        "trim": max(item.Trim.Value for item in lamellas),
        "saw": max(item.Saw.Value for item in lamellas),
    }


@contextmanager
def _one_stock(features: Sequence[Any], wanted: float | None) -> Iterator[float | None]:
    """Let lamellas and the list of stock know the same length, mm; None for as long as it takes.

    A length that is asked for becomes the lamellas' own, in one undo step, unless what happens
    inside fails; without one theirs counts.
    """
    lamellas = [
        item
        for item in features
        if structure_object.is_structure(item) and "Stock" in item.PropertiesList
    ]
    lengths = [item.Stock.Value for item in lamellas]
    if wanted is None:
        wanted = max(lengths, default=0.0)
    if all(length == wanted for length in lengths):
        yield wanted or None
        return
    document = lamellas[0].Document
    with transaction(document, FreeCAD.Qt.translate("Ortho", "Stock length")):
        try:
            for item in lamellas:
                item.Stock = wanted
            yield wanted or None
        except BaseException:
            for item, length in zip(lamellas, lengths, strict=True):
                item.Stock = length
                item.purgeTouched()
            raise
        document.recompute()


def _properties(
    system: str, settings: Mapping[str, Any], present: Mapping[str, Any] | None = None
) -> dict[str, Any]:
    """Values of a structure's properties, checked as far as the net does not matter.

    Args:
        system: its system.
        settings: what is given, by the words of :func:`add_structure`.
        present: values of the system's options that those not given have; without it the defaults.
    """
    sizes = {word: value for word, value in settings.items() if word not in _COMMON}
    if PANEL_THICKNESS in sizes and _has(system, PANEL_THICKNESS):
        # Beside beams it is said so, whose thickness is another; here it is the only one.
        own = sizes.pop(PANEL_THICKNESS)
        sizes |= {} if own is None else {"thickness": own}
    if "lines" in settings or "family" in settings:
        Selection(settings.get("family", "both"), tuple(settings.get("lines", ())) or None)
    if "material" in settings or "density" in settings:
        chosen = known_material(settings.get("material", "steel"), settings.get("density") or None)
        if "material" in settings and chosen.thickness is not None:
            sizes = {"thickness": chosen.thickness, **sizes}
    properties = _option_properties(system, sizes, present or {})
    for word, (name, write) in _COMMON.items():
        if word in settings:
            properties[name] = write(settings[word])
    return properties


def _has(system: str, name: str) -> bool:
    return any(option.name == name for option in SYSTEMS[system].options)


def _option_properties(
    system: str, sizes: Mapping[str, Any], present: Mapping[str, Any]
) -> dict[str, Any]:
    options = {option.name: option for option in options_of(system)}
    for name in sizes:
        if name not in options:
            raise InputError(
                f"{name}: {system} have no such setting; there are {', '.join(options)}"
            )
    given = {name: convert.option_value(options[name], value) for name, value in sizes.items()}
    defaults = {option.name: option.default for option in SYSTEMS[system].options}
    system_of(system, {**defaults, **present, **given}, known_material())
    return {
        part: value
        for name, each in given.items()
        for part, value in stored(options[name], each, titled=True).items()
    }
