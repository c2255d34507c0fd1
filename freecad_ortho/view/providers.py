"""The views that document objects ask for when they are made in FreeCAD's window."""

from __future__ import annotations

from freecad_ortho import answers
from freecad_ortho.view.check_view import CheckView
from freecad_ortho.view.flat_patterns_view import FlatPatternsView
from freecad_ortho.view.net_view import NetView
from freecad_ortho.view.progress import shown
from freecad_ortho.view.source_net_view import SourceNetView
from freecad_ortho.view.structure_view import StructureView

answers.give("show net", NetView)
answers.give("show net with a source", SourceNetView)
answers.give("show structure", StructureView)
answers.give("show flat patterns", FlatPatternsView)
answers.give("show structural check", CheckView)
answers.give("show progress", shown)
