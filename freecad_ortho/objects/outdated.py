"""Shapes that follow a net: quick ones at once, long ones marked until they are asked for.

FreeCAD takes the mark off everything that it has recomputed. So an object that chose to wait says
so in a property, and gets its mark back when the recompute of its document is over.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

import FreeCAD

from freecad_ortho import preferences
from freecad_ortho.objects.properties import HIDDEN, OUTPUT, READ_ONLY, Persistent, Property
from solver.errors import OrthoError

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

Progress = Callable[[float, str], None]

# What building takes about, for shapes that have not been built in this session.
_SECONDS_AN_EDGE = 1.5e-4


def updating(group: str) -> tuple[Property, ...]:
    """Properties that say whether a shape follows, under a heading of the property editor."""
    return (
        Property(
            "App::PropertyBool",
            "AutomaticUpdate",
            group,
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Follow each change at once, if that does not take long; else only when asked to",
            ),
            default=True,
            flags=OUTPUT,
        ),
        Property(
            "App::PropertyBool",
            "Outdated",
            "Result",
            QT_TRANSLATE_NOOP("App::Property", "The shape waits to be built anew"),
            default=False,
            flags=OUTPUT | READ_ONLY,
        ),
        Property(
            "App::PropertyString",
            "BuiltFrom",
            "Result",
            QT_TRANSLATE_NOOP("App::Property", "Stands for all that the shape was built from"),
            flags=OUTPUT | READ_ONLY | HIDDEN,
        ),
        Property(
            "App::PropertyString",
            "Notice",
            "Result",
            QT_TRANSLATE_NOOP("App::Property", "What is to be known before the shape is used"),
            flags=OUTPUT | READ_ONLY,
        ),
    )


class Following(Persistent):
    """Base of the proxies of such shapes, with the properties of :func:`updating` among theirs.

    Attributes:
        seconds: that building took last, on this machine in this session.
    """

    seconds: float | None = None

    def onDocumentRestored(self, feature: FreeCAD.DocumentObject) -> None:
        """Give an object from an older document the properties that came later."""
        super().onDocumentRestored(feature)
        watch()
        if feature.Outdated or feature.Notice:
            feature.touch()

    def execute(self, feature: FreeCAD.DocumentObject) -> None:
        """Build the shape anew or let it wait; on an error the last good shape stays.

        Raises:
            OrthoError: what is wrong and what to do; FreeCAD shows it and marks the object.
        """
        try:
            known = feature.Notice
            feature.Notice = notice(feature)
            if self._waits(feature):
                self._mark(feature)
            elif not (known and self._is_as_before(feature, known)):
                self.rebuild(feature)
        except OrthoError as error:
            # The report view shows where an exception came from; the inner frames help nobody.
            raise type(error)(str(error)) from None

    def rebuild(self, feature: FreeCAD.DocumentObject, progress: Progress | None = None) -> None:
        """Build the shape.

        Args:
            feature: the object.
            progress: called with a fraction and words; may raise to stop.
        """
        raise NotImplementedError

    def is_built(self, feature: FreeCAD.DocumentObject) -> bool:
        """Tell whether there is something to go on with while it waits."""
        return not feature.Shape.isNull()

    def seconds_about(self, feature: FreeCAD.DocumentObject) -> float:
        """What building takes about, where it has not been built in this session."""
        return _SECONDS_AN_EDGE * len(feature.Shape.Edges)

    def fingerprint(self, feature: FreeCAD.DocumentObject) -> str:
        """A word that stands for all that the shape is built from."""
        raise NotImplementedError

    def stands_on(self, feature: FreeCAD.DocumentObject) -> Sequence[FreeCAD.DocumentObject]:
        """Other such shapes that this one would not fit while they wait."""
        raise NotImplementedError

    def _is_as_before(self, feature: FreeCAD.DocumentObject, known: str) -> bool:
        """Tell whether it is touched only to bear the mark of what it stands on."""
        return bool(feature.Notice == known and feature.BuiltFrom == self.fingerprint(feature))

    def _waits(self, feature: FreeCAD.DocumentObject) -> bool:
        if not self.is_built(feature):
            return False
        if not feature.AutomaticUpdate:
            return True
        if any(item.Outdated for item in self.stands_on(feature)):
            return True
        if self.seconds is None:
            self.seconds = self.seconds_about(feature)
        return self.seconds > preferences.at_once()

    def _mark(self, feature: FreeCAD.DocumentObject) -> None:
        """Say that it waits, unless it is touched only and nothing has changed."""
        before = feature.Outdated
        feature.Outdated = feature.BuiltFrom != self.fingerprint(feature)
        if feature.Outdated and not before:
            FreeCAD.Console.PrintMessage(
                FreeCAD.Qt.translate(
                    "Ortho", "{} waits to be built anew: Refresh or Update structures does it"
                ).format(feature.Label)
                + "\n"
            )


@contextmanager
def timed(feature: FreeCAD.DocumentObject) -> Iterator[None]:
    """Remember how long building a shape takes."""
    # Loading the CAD kernel, once in a session, counts for no shape.
    loaded = "cadquery" in sys.modules
    start = time.perf_counter()
    yield
    feature.Proxy.seconds = time.perf_counter() - start if loaded else None


def waiting(document: FreeCAD.Document) -> list[FreeCAD.DocumentObject]:
    """Give the shapes that wait in a document to be built anew."""
    return [item for item in document.Objects if _is_outdated(item) and _follows(item)]


def notice(feature: FreeCAD.DocumentObject) -> str:
    """What is to be known of an object that stands on nets whose sources have moved on."""
    nets = [item for item in feature.OutListRecursive if _is_outdated(item) and not _follows(item)]
    words = FreeCAD.Qt.translate(
        "Ortho", "{} is outdated: its source has changed since it was optimised or dragged"
    )
    return words.format(", ".join(sorted(item.Label for item in nets))) if nets else ""


def _is_outdated(feature: FreeCAD.DocumentObject) -> bool:
    return bool(getattr(feature, "Outdated", False))


def _follows(feature: FreeCAD.DocumentObject) -> bool:
    return isinstance(feature.Proxy, Following)


def _marked(document: FreeCAD.Document) -> list[FreeCAD.DocumentObject]:
    """What is outdated, and what stands on an outdated net."""
    outdated = [item for item in document.Objects if _is_outdated(item)]
    above = [other for item in outdated if not _follows(item) for other in item.InListRecursive]
    return outdated + [item for item in above if hasattr(item, "Proxy")]


class _Observer:
    """Called by FreeCAD after each recompute of a document."""

    def slotRecomputedDocument(self, document: FreeCAD.Document) -> None:
        """Mark what waits, and what stands on something outdated."""
        for feature in _marked(document):
            feature.touch()


_observers: list[Any] = []


def watch() -> None:
    """Begin to keep marks, and to build what waits at Refresh; doing it again changes nothing."""
    if _observers:
        return
    _observers.append(_Observer())
    FreeCAD.addDocumentObserver(_observers[0])
