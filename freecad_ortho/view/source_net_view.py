"""View provider of a net that follows a source: a double click opens its options again."""

from __future__ import annotations

from typing import Any

import FreeCAD

from freecad_ortho import answers
from freecad_ortho.resources import icon
from freecad_ortho.view import context_menu
from freecad_ortho.view.net_view import NetView

_ICONS = {
    "multi-net": "multi_net",
    "elliptic multi-net": "elliptic_net",
    "faces": "face_net",
    "along curvature": "aligned_net",
}


class SourceNetView(NetView):
    """Proxy of the view provider of a net that follows a source."""

    def getIcon(self) -> str:
        """Icon in the tree: that of the command that made it."""
        made_by = getattr(getattr(self, "Object", None), "MadeBy", "")
        return icon(_ICONS.get(made_by, "net"))

    def claimChildren(self) -> list[Any]:
        """What the net is made of stands below it in the tree."""
        return list(getattr(self.Object, "Nets", []))

    def doubleClicked(self, view_object: Any) -> bool:
        """Open the options of the source; a net that left it is dragged, as any other."""
        if not view_object.Object.FollowSource:
            return super().doubleClicked(view_object)
        return self._edit_source(view_object)

    def setupContextMenu(self, view_object: Any, menu: Any) -> None:
        """Offer the options of the source in the tree."""
        words = FreeCAD.Qt.translate("Ortho", "Edit source")
        context_menu.offer(menu, words, lambda: self._edit_source(view_object))

    def _edit_source(self, view_object: Any) -> bool:
        answers.ask("edit source", view_object.Object)
        return True
