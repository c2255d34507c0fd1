"""FreeCAD's first door: runs at every start, with and without a window."""

import FreeCAD

import freecad_ortho
from freecad_ortho import packages

freecad_ortho.use_own_packages(
    packages.add_on_folder(
        FreeCAD.getUserAppDataDir(), tuple(int(part) for part in FreeCAD.Version()[:2])
    )
)
if freecad_ortho.shadowing_module():
    FreeCAD.Console.PrintError(freecad_ortho.shadowing_module() + "\n")
# Behind FreeCAD's own readers of these files, which stay the first choice; it asks which to take.
_FILES = "Quad mesh (*.obj *.ply *.off *.json)"
FreeCAD.addImportType(_FILES, "freecad_ortho.commands.open_file")
FreeCAD.addExportType(_FILES, "freecad_ortho.commands.open_file")
