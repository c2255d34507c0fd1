"""What the document functions share: one undo step each, the right object, how far work is."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any

import FreeCAD

from freecad_ortho.objects import net as net_object
from freecad_ortho.objects import places
from solver.errors import InputError


@contextmanager
def transaction(document: FreeCAD.Document, title: str) -> Iterator[None]:
    """Make what happens inside one undo step, and nothing at all if it fails.

    Inside a transaction that is already open it becomes part of that one.
    """
    if document.HasPendingTransaction:
        yield
        return
    document.openTransaction(title)
    try:
        yield
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()


@contextmanager
def removed_on_failure(feature: FreeCAD.DocumentObject) -> Iterator[None]:
    """Take a new object away again where what happens inside fails.

    Aborting its transaction does so too, but only where the document records undo steps.
    """
    try:
        yield
    except BaseException:
        feature.Document.removeObject(feature.Name)
        raise


@contextmanager
def unmarked_on_failure(target: FreeCAD.DocumentObject) -> Iterator[None]:
    """Putting properties back marks an object as changed; that is no more than it was before."""
    marked = target.State != ["Up-to-date"]
    try:
        yield
    except BaseException:
        if not marked:
            target.purgeTouched()
        raise


@contextmanager
def changing(target: FreeCAD.DocumentObject, properties: Mapping[str, Any]) -> Iterator[None]:
    """Set properties of an object, as one undo step with what happens inside; none if that fails.

    Args:
        target: the object.
        properties: values by name.
    """
    before = {name: getattr(target, name) for name in properties}
    title = FreeCAD.Qt.translate("Ortho", "Change {}").format(target.Label)
    with unmarked_on_failure(target), transaction(target.Document, title):
        try:
            _set(target, properties)
            yield
        except BaseException:
            _set(target, before)
            raise
        target.purgeTouched()


def _set(target: FreeCAD.DocumentObject, properties: Mapping[str, Any]) -> None:
    for name, value in properties.items():
        setattr(target, name, value)


def require_net(feature: Any) -> None:
    """Raise InputError unless a document object is a Net."""
    places.refuse_link(feature)
    if not net_object.is_net(feature):
        name = getattr(feature, "Label", feature)
        raise InputError(f"net: expected a Net, got {name}; import a quad mesh first")


def document_or_new(document: FreeCAD.Document | str | None, label: str) -> FreeCAD.Document:
    """Return a document given as itself or by name; without one the active or a new one."""
    if isinstance(document, str):
        return FreeCAD.getDocument(document)
    return document or FreeCAD.ActiveDocument or FreeCAD.newDocument(label)


def open_document(document: FreeCAD.Document | None) -> FreeCAD.Document:
    """Return a document, without one the active one; InputError where none is open."""
    chosen = document or FreeCAD.ActiveDocument
    if chosen is None:
        raise InputError("document: none is open; open or create one first")
    return chosen


@contextmanager
def progress(title: str) -> Iterator[Callable[[float, str], None] | None]:
    """Show how far long work is where there is a window."""
    if not FreeCAD.GuiUp:
        yield None
        return
    from freecad_ortho.view.progress import shown

    with shown(title) as move:
        yield move
