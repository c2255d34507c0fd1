"""What the commands work on, and the lines that they record."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from freecad_ortho.objects.flat_patterns import is_flat_patterns
from freecad_ortho.objects.net import is_net
from freecad_ortho.objects.places import is_link
from freecad_ortho.objects.structural_check import is_check
from freecad_ortho.objects.structure import is_structure


def nothing_open() -> bool:
    """Tell whether no task panel is open."""
    return not FreeCADGui.Control.activeDialog()


def _link_selected() -> bool:
    """Tell whether a link is selected: then what it shows is not meant, nor anything else."""
    return any(map(is_link, FreeCADGui.Selection.getSelection()))


def current_net() -> FreeCAD.DocumentObject | None:
    """Give the net that is meant: the selected one, the selected structure's, or the only one."""
    if FreeCAD.ActiveDocument is None or _link_selected():
        return None
    selected = FreeCADGui.Selection.getSelection()
    nets = {item.Name: item for item in map(_net_of, selected) if item is not None}
    if not nets:
        nets = {item.Name: item for item in FreeCAD.ActiveDocument.Objects if is_net(item)}
    return next(iter(nets.values())) if len(nets) == 1 else None


def current_structures() -> list[FreeCAD.DocumentObject]:
    """Give the structures that are meant: the selected ones, or all of the active document."""
    if FreeCAD.ActiveDocument is None or _link_selected():
        return []
    selected = [item for item in FreeCADGui.Selection.getSelection() if is_structure(item)]
    return selected or all_structures()


def all_structures() -> list[FreeCAD.DocumentObject]:
    """Give all structures of the active document."""
    if FreeCAD.ActiveDocument is None:
        return []
    return [item for item in FreeCAD.ActiveDocument.Objects if is_structure(item)]


def current_flat_patterns() -> FreeCAD.DocumentObject | None:
    """Give the flat patterns that are meant: the selected ones, or the only ones."""
    if FreeCAD.ActiveDocument is None or _link_selected():
        return None
    for items in (FreeCADGui.Selection.getSelection(), FreeCAD.ActiveDocument.Objects):
        found = [item for item in items if is_flat_patterns(item)]
        if found:
            return found[0] if len(found) == 1 else None
    return None


def selected_nets_and_structures() -> list[FreeCAD.DocumentObject]:
    """Give the nets and structures that are selected."""
    return [
        item for item in FreeCADGui.Selection.getSelection() if is_net(item) or is_structure(item)
    ]


# Any keyword: which of them there are, and of what type, the function itself says and checks.
def run(function: str, *arguments: object, **settings: object) -> None:
    """Run a function of freecad_ortho.api so that macros record it, with all that it needs.

    Args:
        function: its name.
        arguments: positional arguments: document objects, plain values, or lists, tuples and
            dictionaries of them.
        settings: keyword arguments of the same kinds.
    """
    words = [_source(value) for value in arguments]
    words += [f"{name}={_source(value)}" for name, value in settings.items()]
    # FreeCAD's addModule records an import once a session: a macro begun later would lack it.
    line = f"freecad_ortho.api.{function}({', '.join(words)})"
    FreeCADGui.doCommand(f"import freecad_ortho.api\n{line}")


def _net_of(feature: Any) -> FreeCAD.DocumentObject | None:
    if is_net(feature):
        return feature
    return feature.Net if is_structure(feature) or is_check(feature) else None


def _source(value: object) -> str:
    """Write a value as Python source."""
    if isinstance(value, list):
        return "[" + ", ".join(map(_source, value)) + "]"
    if isinstance(value, tuple):
        return "(" + "".join(_source(item) + ", " for item in value).rstrip(" ") + ")"
    if isinstance(value, dict):
        pairs = (f"{_source(key)}: {_source(item)}" for key, item in value.items())
        return "{" + ", ".join(pairs) + "}"
    if isinstance(value, FreeCAD.DocumentObject):
        return f"FreeCAD.getDocument({value.Document.Name!r}).getObject({value.Name!r})"
    return repr(value)
