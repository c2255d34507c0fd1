"""The panels that a double click in the tree asks for, and what the command Refresh does."""

from __future__ import annotations

from freecad_ortho import answers
from freecad_ortho.commands import flat_patterns, sources, structural_check, structures
from freecad_ortho.panels import edit_panel

answers.give("edit net", edit_panel.begin)
answers.give("edit source", sources.edit_source)
answers.give("edit structure", structures.edit_structure)
answers.give("edit flat patterns", flat_patterns.edit_flat_patterns)
answers.give("edit structural check", structural_check.edit_check)
answers.give("size check", structural_check.size_check)
answers.give("write check", structural_check.write_check)
answers.give("analyse check", structural_check.analyse_check)
answers.give("update waiting structures", structures.update_waiting)
