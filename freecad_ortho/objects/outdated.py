"""Keeps the mark on objects that wait to be asked before they are built anew.

FreeCAD takes the mark off everything that it has recomputed. So an object that chose to wait says
so in a property, and gets its mark back when the recompute of its document is over.
"""

from __future__ import annotations

import FreeCAD


class _Observer:
    """Called by FreeCAD after each recompute of a document."""

    def slotRecomputedDocument(self, document: FreeCAD.Document) -> None:
        """Mark what waits."""
        for feature in document.Objects:
            if getattr(feature, "Outdated", False):
                feature.touch()


_observers: list[_Observer] = []


def watch() -> None:
    """Begin to keep marks; doing it again changes nothing."""
    if not _observers:
        _observers.append(_Observer())
        FreeCAD.addDocumentObserver(_observers[0])
