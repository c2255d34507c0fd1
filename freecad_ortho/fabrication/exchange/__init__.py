"""What writes the files for other programs, by the names of ``formats.FORMATS``."""

from collections.abc import Callable
from pathlib import Path

from freecad_ortho.fabrication.exchange.assembly import write_assembly
from freecad_ortho.fabrication.exchange.btlx import write_btlx
from freecad_ortho.fabrication.exchange.drawings import write_drawings
from freecad_ortho.fabrication.exchange.ifc import write_ifc
from freecad_ortho.fabrication.exchange.labels import write_labels
from freecad_ortho.fabrication.exchange.nc1 import write_nc1
from freecad_ortho.fabrication.exchange.rhino import write_3dm
from freecad_ortho.fabrication.exchange.saw_list import write_saw_list
from freecad_ortho.fabrication.exchange.spreadsheet import write_xlsx
from freecad_ortho.fabrication.exchange.viewer import write_glb
from freecad_ortho.fabrication.production import Production

# Takes the path of its file or folder, the production, the project's name, and what is called with
# the fraction done.
Writer = Callable[[Path, Production, str, Callable[[float], None]], None]

WRITERS: dict[str, Writer] = {
    "ifc": write_ifc,
    "glb": write_glb,
    "xlsx": write_xlsx,
    "labels": write_labels,
    "saw": write_saw_list,
    "nc1": write_nc1,
    "btlx": write_btlx,
    "3dm": write_3dm,
    "assembly": write_assembly,
    "drawings": write_drawings,
}

__all__ = ["WRITERS", "Writer"]
