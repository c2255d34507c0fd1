"""Watching one net: it may be deleted, or changed by undo, while a panel works on it."""

from __future__ import annotations

from collections.abc import Callable

import FreeCAD

from freecad_ortho.objects.structure import is_structure


class NetWatch:
    """A document observer that speaks of one net only.

    Args:
        net: the Net.
        gone: called when the net or its document is deleted; the net is still there then.
        changed: called with the name of a property of the net that something else has changed.
    """

    def __init__(
        self,
        net: FreeCAD.DocumentObject,
        gone: Callable[[], None],
        changed: Callable[[str], None],
    ) -> None:
        self.document, self.name = net.Document.Name, net.Name
        self._gone, self._changed = gone, changed
        self._watching = True
        FreeCAD.addDocumentObserver(self)

    @property
    def net(self) -> FreeCAD.DocumentObject | None:
        """The net, None when it or its document has gone meanwhile."""
        if self.document not in FreeCAD.listDocuments():
            return None
        return FreeCAD.getDocument(self.document).getObject(self.name)

    @property
    def watching(self) -> bool:
        """Tell whether it has not ended yet."""
        return self._watching

    def end(self) -> None:
        """Watch no more; doing it again changes nothing."""
        if self._watching:
            self._watching = False
            FreeCAD.removeDocumentObserver(self)

    def slotDeletedDocument(self, document: FreeCAD.Document) -> None:
        """Tell when the net's document is closed."""
        if document.Name == self.document:
            self._gone()

    def slotDeletedObject(self, feature: FreeCAD.DocumentObject) -> None:
        """Tell when the net is deleted."""
        if feature.Name == self.name and feature.Document.Name == self.document:
            self._gone()

    def slotChangedObject(self, feature: FreeCAD.DocumentObject, name: str) -> None:
        """Tell when a property of the net changes."""
        if feature.Name == self.name and feature.Document.Name == self.document:
            self._changed(name)


def uncover(net: FreeCAD.DocumentObject) -> dict[str, bool]:
    """Show a net and hide what stands on it; give what was visible before, by name."""
    structures = [item for item in net.InList if is_structure(item)]
    before = {item.Name: item.ViewObject.Visibility for item in (net, *structures)}
    for item in structures:
        item.ViewObject.Visibility = False
    net.ViewObject.Visibility = True
    return before


def cover(document: str, before: dict[str, bool]) -> None:
    """Show what was visible before, as far as it is still there."""
    if document not in FreeCAD.listDocuments():
        return
    for name, visible in before.items():
        feature = FreeCAD.getDocument(document).getObject(name)
        if feature is not None:
            feature.ViewObject.Visibility = visible
