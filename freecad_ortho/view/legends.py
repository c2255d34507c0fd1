"""One colour scale a view: of the nets in sight, the one that changed last has its own."""

from __future__ import annotations

from typing import Any

import FreeCAD

# Name of the document -> name of the net whose scale is shown.
_last: dict[str, str] = {}


def changed(net: FreeCAD.DocumentObject) -> None:
    """Show the scale of a net whose colours have changed, or of another where it has none."""
    document = net.Document
    explaining = {item.Name: view for item in document.Objects if (view := _explaining(item))}
    if net.Name in explaining:
        _last[document.Name] = net.Name
    chosen = _last.get(document.Name)
    if chosen not in explaining:
        chosen = next(iter(explaining), None)
    for item in document.Objects:
        view = _net_view(item)
        if view is not None:
            name = item.Label if len(explaining) > 1 else ""
            view.show_legend(item.Name == chosen, name)


def _explaining(feature: FreeCAD.DocumentObject) -> Any:
    """The view of a net that is seen in colours that need a scale; None for all else."""
    view = _net_view(feature)
    return view if view is not None and view.explains() else None


def _net_view(feature: FreeCAD.DocumentObject) -> Any:
    """The view of a net, as soon as it draws something."""
    view = getattr(feature.ViewObject, "Proxy", None)
    return view if hasattr(view, "explains") and hasattr(view, "_explanation") else None
