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
_WRITTEN = "*.obj *.ply *.off *.json"
_READ = f"{_WRITTEN} *.vtk *.vtp *.vtu *.vts *.3dm"
FreeCAD.addImportType(f"Quad mesh ({_READ})", "freecad_ortho.commands.open_file")
FreeCAD.addExportType(f"Quad mesh ({_WRITTEN})", "freecad_ortho.commands.open_file")
