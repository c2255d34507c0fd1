"""STEP: an assembly with a named component for each part, in mm; equal parts share a product.

Products have the colours of their materials and lie on layers that are called as their kinds.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from io import BytesIO
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from freecad_ortho.fabrication.colours import colour_of
from freecad_ortho.fabrication.equal import copies
from freecad_ortho.fabrication.fasteners import named
from freecad_ortho.fabrication.hardware import NO_HARDWARE, Hardware, bolt_frames, bolt_shape
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.place import Place
from freecad_ortho.fabrication.solids import location
from freecad_ortho.fabrication.step_text import compacted
from solver.errors import InputError, OrthoError

if TYPE_CHECKING:
    import cadquery

ASSEMBLY_NAME = "structure"
# Of the assembly that puts the structure elsewhere than its own coordinates say.
SITE_NAME = "site"
# The layer of what is bought; colours of bolts, and of gaskets and blocks.
HARDWARE, _GREY, _BLACK = "hardware", (90, 94, 100), (40, 40, 42)
# Gaskets and blocks agree that much, mm, or are products of their own.
_ALIKE = 1e-6
# Distance from the origin, mm, at which numbers have a hundredth of the kernel's tolerance left.
_FAR = 1e7
# The same structure gives the same file: no clock, no user name.
_OCCURRENCE = re.compile(rb"(NEXT_ASSEMBLY_USAGE_OCCURRENCE\(')\d+")
_TIME_STAMP = "2000-01-01T00:00:00"


def write_step(
    path: Path,
    parts: Sequence[Part],
    place: Place | None = None,
    shared_within: float = 0.0,
    words: str = "",
    in_place: bool = False,
    hardware: Hardware = NO_HARDWARE,
) -> None:
    """Write the parts as components of one assembly, in their order.

    Each product lies flat in its own coordinates, the component puts it in its place. A structure
    that stands elsewhere is itself the one component of an assembly, so that no coordinate of its
    parts has to reach that far.

    Args:
        path: file to write.
        parts: each becomes a component with its name, of a product with the name of the first of
            the parts whose solids agree with it.
        place: where the structure stands.
        shared_within: distance within which they do, mm; 0 gives each part a product of its own.
        words: description in the file's head.
        in_place: without an assembly: each part is a product whose coordinates are those of the
            structure. Programs that look for each component among all products open it sooner.
        hardware: drawn besides; each size of bolts is one product with its washers and nut.

    Raises:
        InputError: parts in place farther from the origin than the kernel can tell them apart.
        OrthoError: the kernel could not translate the solids.
        OSError: the file cannot be written.
    """
    document = _document()
    if in_place:
        _fill_in_place(document, parts, place or Place(), hardware)
    else:
        _fill(document, parts, place or Place(), shared_within, hardware)
    path.write_bytes(_step_bytes(document, words))


def read_step(path: Path) -> list[tuple[str, cadquery.Shape]]:
    """Return name and shape of each component of the assembly in a STEP file, or product, mm.

    Raises:
        OrthoError: the file cannot be read back.
    """
    import cadquery
    from OCP.IFSelect import IFSelect_ReturnStatus
    from OCP.STEPCAFControl import STEPCAFControl_Reader
    from OCP.TDF import TDF_LabelSequence
    from OCP.TopLoc import TopLoc_Location
    from OCP.XCAFDoc import XCAFDoc_DocumentTool, XCAFDoc_ShapeTool

    document = _document()
    reader = STEPCAFControl_Reader()
    reader.SetNameMode(True)
    with _quiet_kernel():
        good = reader.ReadFile(str(path)) == IFSelect_ReturnStatus.IFSelect_RetDone
        good = good and reader.Transfer(document)
    if not good:
        raise OrthoError(f"{path}: cannot be read back as STEP; write it again")
    roots = TDF_LabelSequence()
    XCAFDoc_DocumentTool.ShapeTool_s(document.Main()).GetFreeShapes(roots)
    result = []
    for index in range(1, roots.Length() + 1):
        root = roots.Value(index)
        if XCAFDoc_ShapeTool.IsAssembly_s(root):
            result += _components(root, TopLoc_Location())
        else:
            result.append((_name_of(root), XCAFDoc_ShapeTool.GetShape_s(root)))
    return [(name, cadquery.Shape.cast(shape)) for name, shape in result]


def _components(assembly: Any, place: Any) -> list[tuple[str, Any]]:
    """Names and shapes of all parts of an assembly that stands at a location."""
    from OCP.TDF import TDF_Label, TDF_LabelSequence
    from OCP.XCAFDoc import XCAFDoc_ShapeTool

    found = TDF_LabelSequence()
    XCAFDoc_ShapeTool.GetComponents_s(assembly, found, False)
    result = []
    for index in range(1, found.Length() + 1):
        component, product = found.Value(index), TDF_Label()
        XCAFDoc_ShapeTool.GetReferredShape_s(component, product)
        shape = XCAFDoc_ShapeTool.GetShape_s(component)
        if XCAFDoc_ShapeTool.IsAssembly_s(product):
            result += _components(product, place.Multiplied(shape.Location()))
        else:
            result.append((_name_of(component), shape.Moved(place, False)))
    return result


def _document() -> Any:
    from OCP.TCollection import TCollection_ExtendedString
    from OCP.TDocStd import TDocStd_Document
    from OCP.XCAFDoc import XCAFDoc_DocumentTool

    document = TDocStd_Document(TCollection_ExtendedString("BinXCAF"))
    XCAFDoc_DocumentTool.SetLengthUnit_s(document, 1e-3)  # in metres: the shapes are in mm
    return document


def _fill(
    document: Any,
    parts: Sequence[Part],
    place: Place,
    shared_within: float,
    hardware: Hardware,
) -> None:
    from OCP.TCollection import TCollection_ExtendedString
    from OCP.TDataStd import TDataStd_Name
    from OCP.TopLoc import TopLoc_Location
    from OCP.XCAFDoc import XCAFDoc_DocumentTool

    shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    shapes.SetAutoNaming_s(False)
    assembly = shapes.NewShape()
    TDataStd_Name.Set_s(assembly, TCollection_ExtendedString(ASSEMBLY_NAME))
    loose = hardware.loose
    for some, within in ((parts, shared_within), (loose, max(shared_within, _ALIKE))):
        products: dict[int, Any] = {}
        for number, (part, copy) in enumerate(zip(some, copies(some, within), strict=True)):
            name = TCollection_ExtendedString(part.name)
            if copy.first == number:
                solid = part.solid().wrapped.Located(TopLoc_Location())
                products[number] = shapes.AddShape(solid, False)
                TDataStd_Name.Set_s(products[number], name)
                _paint(document, products[number], *_look(part, some is loose))
            stands = location(part.origin + copy.shift @ part.frame, copy.turn @ part.frame)
            component = shapes.AddComponent(assembly, products[copy.first], stands)
            TDataStd_Name.Set_s(component, name)
    for bolts, names in named(hardware.fasteners):
        product = shapes.AddShape(bolt_shape(bolts).wrapped, False)
        TDataStd_Name.Set_s(product, TCollection_ExtendedString(bolts.name))
        _paint(document, product, _GREY, HARDWARE)
        for name, point, frame in zip(names, bolts.places, bolt_frames(bolts), strict=True):
            component = shapes.AddComponent(assembly, product, location(point, frame))
            TDataStd_Name.Set_s(component, TCollection_ExtendedString(name))
    if not place.is_here:
        site = shapes.NewShape()
        TDataStd_Name.Set_s(site, TCollection_ExtendedString(SITE_NAME))
        component = shapes.AddComponent(site, assembly, location(place.origin, place.rotation.T))
        TDataStd_Name.Set_s(component, TCollection_ExtendedString(ASSEMBLY_NAME))
    shapes.UpdateAssemblies()


def _fill_in_place(document: Any, parts: Sequence[Part], place: Place, hardware: Hardware) -> None:
    from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
    from OCP.TCollection import TCollection_ExtendedString
    from OCP.TDataStd import TDataStd_Name
    from OCP.TopLoc import TopLoc_Location
    from OCP.XCAFDoc import XCAFDoc_DocumentTool

    if (away := float(np.abs(place.origin).max())) > _FAR:
        raise InputError(
            f"step: in-place solids would stand {away / 1e6:,.0f} km from the origin, where the "
            "CAD kernel cannot tell their corners apart; take step one, or a local origin"
        )
    shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    shapes.SetAutoNaming_s(False)
    structure = location(place.origin, place.rotation.T)
    for number, part in enumerate((*parts, *hardware.loose)):
        stands = structure.Multiplied(location(part.origin, part.frame)).Transformation()
        solid = part.solid().wrapped.Located(TopLoc_Location())
        product = shapes.AddShape(BRepBuilderAPI_Transform(solid, stands, True).Shape(), False)
        TDataStd_Name.Set_s(product, TCollection_ExtendedString(part.name))
        _paint(document, product, *_look(part, number >= len(parts)))
    for bolts, names in named(hardware.fasteners):
        shape = bolt_shape(bolts).wrapped
        for name, point, frame in zip(names, bolts.places, bolt_frames(bolts), strict=True):
            stands = structure.Multiplied(location(point, frame)).Transformation()
            product = shapes.AddShape(BRepBuilderAPI_Transform(shape, stands, True).Shape(), False)
            TDataStd_Name.Set_s(product, TCollection_ExtendedString(name))
            _paint(document, product, _GREY, HARDWARE)
    shapes.UpdateAssemblies()


def _look(part: Part, loose: bool) -> tuple[Sequence[int], str]:
    """Colour and layer of a part, or of what is bought."""
    return (_BLACK, HARDWARE) if loose else (colour_of(part.material), part.kind)


def _paint(document: Any, product: Any, rgb: Sequence[int], layer: str) -> None:
    """Give a product a colour and a layer."""
    from OCP.Quantity import Quantity_Color, Quantity_TypeOfColor
    from OCP.TCollection import TCollection_ExtendedString
    from OCP.XCAFDoc import XCAFDoc_ColorType, XCAFDoc_DocumentTool

    shares = [value / 255 for value in rgb[:3]]
    colour = Quantity_Color(*shares, Quantity_TypeOfColor.Quantity_TOC_sRGB)
    colours = XCAFDoc_DocumentTool.ColorTool_s(document.Main())
    colours.SetColor(product, colour, XCAFDoc_ColorType.XCAFDoc_ColorGen)
    layers = XCAFDoc_DocumentTool.LayerTool_s(document.Main())
    layers.SetLayer(product, TCollection_ExtendedString(layer), False)


def _step_bytes(document: Any, words: str) -> bytes:
    from OCP.APIHeaderSection import APIHeaderSection_MakeHeader
    from OCP.IFSelect import IFSelect_ReturnStatus
    from OCP.Interface import Interface_Static
    from OCP.STEPCAFControl import STEPCAFControl_Writer
    from OCP.STEPControl import STEPControl_StepModelType
    from OCP.TCollection import TCollection_HAsciiString

    with _quiet_kernel():
        writer = STEPCAFControl_Writer()
        Interface_Static.SetCVal_s("write.step.unit", "MM")
        # Curves in the parameters of their surfaces follow from those in space.
        Interface_Static.SetIVal_s("write.surfacecurve.mode", 0)
        writer.SetNameMode(True)
        writer.SetColorMode(True)
        writer.SetLayerMode(True)
        done = writer.Transfer(document, STEPControl_StepModelType.STEPControl_AsIs)
        if done:
            header = APIHeaderSection_MakeHeader(writer.ChangeWriter().Model())
            header.SetName(TCollection_HAsciiString(ASSEMBLY_NAME))
            header.SetTimeStamp(TCollection_HAsciiString(_TIME_STAMP))
            header.SetAuthorValue(1, TCollection_HAsciiString(""))
            header.SetOrganizationValue(1, TCollection_HAsciiString(""))
            if words:
                header.SetDescriptionValue(1, TCollection_HAsciiString(words))
            header.SetOriginatingSystem(TCollection_HAsciiString("freecad_ortho"))
            stream = BytesIO()
            done = writer.WriteStream(stream) == IFSelect_ReturnStatus.IFSelect_RetDone
    if not done:
        raise OrthoError("STEP: the CAD kernel could not translate the solids; check the mesh")
    # The kernel numbers occurrences through all files that a process writes.
    number = count(1)
    data = _OCCURRENCE.sub(lambda found: found[1] + b"%d" % next(number), stream.getvalue())
    return compacted(data)


def _name_of(label: Any) -> str:
    from OCP.TDataStd import TDataStd_Name

    name = TDataStd_Name()
    return str(name.Get().ToExtString()) if label.FindAttribute(name.GetID_s(), name) else ""


@contextmanager
def _quiet_kernel() -> Iterator[None]:
    """Keep the kernel's translation statistics off the standard output."""
    from OCP.Message import Message, Message_PrinterOStream

    messenger = Message.DefaultMessenger_s()
    printers = list(messenger.Printers())
    messenger.RemovePrinters(Message_PrinterOStream.get_type_descriptor_s())
    try:
        yield
    finally:
        for printer in printers:
            messenger.AddPrinter(printer)
