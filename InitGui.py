"""FreeCAD's second door: registers the workbench; everything is loaded when it is first used."""

import FreeCADGui


class OrthoWorkbench(FreeCADGui.Workbench):
    """From a freeform quad mesh to a building: optimise, beams, panels, fabrication files."""

    def __init__(self):
        from FreeCAD import Qt

        from freecad_ortho import answers, resources

        # A double click in the tree wants panels, whichever workbench is chosen.
        answers.promise("freecad_ortho.commands.answers")
        FreeCADGui.addLanguagePath(resources.TRANSLATIONS)
        FreeCADGui.updateLocale()
        # FreeCAD looks there for the picture of the page, preferences-ortho.
        FreeCADGui.addIconPath(resources.ICONS)
        FreeCADGui.addPreferencePage(resources.form("preferences"), "Ortho")
        self.__class__.Icon = resources.icon("workbench")
        self.__class__.MenuText = Qt.translate("Workbench", "Ortho")
        self.__class__.ToolTip = Qt.translate(
            "Workbench", "Turn freeform quad meshes into buildings of flat beams and panels"
        )

    def Initialize(self):
        """Register the commands and lay them out; FreeCAD calls this at the first activation."""
        from FreeCAD import Qt

        from freecad_ortho import commands
        from freecad_ortho.commands import requirements

        menu = Qt.translate("Workbench", "&Ortho")
        try:
            commands.register()
        except ImportError as error:
            requirements.say_unusable(error)
            self.appendMenu(menu, commands.HELP)
            return
        titles = {
            "Design": (
                Qt.translate("Workbench", "Ortho Design"),
                Qt.translate("Workbench", "&Design"),
            ),
            "Optimise": (
                Qt.translate("Workbench", "Ortho Optimise"),
                Qt.translate("Workbench", "&Optimise"),
            ),
            "Analyse": (
                Qt.translate("Workbench", "Ortho Analyse"),
                Qt.translate("Workbench", "&Analyse"),
            ),
            "Fabricate": (
                Qt.translate("Workbench", "Ortho Fabricate"),
                Qt.translate("Workbench", "&Fabricate"),
            ),
        }
        for toolbar, (title, submenu) in titles.items():
            names = commands.names(toolbar)
            self.appendToolbar(title, names)
            self.appendMenu([menu, submenu], names)
        self.appendMenu([menu, Qt.translate("Workbench", "&Examples")], commands.examples())
        self.appendMenu(menu, commands.HELP)

    def Activated(self):
        """Offer at once to install what a part of the commands needs and is missing."""
        from freecad_ortho.commands import requirements

        requirements.offer_missing()

    def ContextMenu(self, recipient):
        """Offer what can be done with the selected net or structure."""
        from freecad_ortho import commands

        names = commands.for_selection()
        if names:
            self.appendContextMenu("", names)

    def GetClassName(self):
        """Name the C++ class that carries a workbench written in Python."""
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(OrthoWorkbench())
