"""FreeCAD's first door: runs at every start, with and without a window."""

import FreeCAD

import freecad_ortho

freecad_ortho.use_own_packages()
if freecad_ortho.shadowing_module():
    FreeCAD.Console.PrintError(freecad_ortho.shadowing_module() + "\n")
FreeCAD.addImportType("Quad mesh (*.obj)", "freecad_ortho.commands.open_file")
