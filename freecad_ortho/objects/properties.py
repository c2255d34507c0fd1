"""Tables of properties, added where they are missing: on new objects and on old documents."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Any

import FreeCAD

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

READ_ONLY = 1
HIDDEN = 4
# Does not make the object (and what follows from it) stale: how a net is shown, what was reported.
OUTPUT = 8


@dataclass(frozen=True)
class Property:
    """One dynamic property of a document object or view provider.

    Attributes:
        kind: FreeCAD's type name.
        name: the property's name.
        group: heading in the property editor.
        tooltip: one sentence, in English; FreeCAD translates it in the context "App::Property".
        default: first value, or None to keep FreeCAD's own.
        choices: the values of an enumeration.
        flags: HIDDEN, OUTPUT, READ_ONLY or a sum of them.
    """

    kind: str
    name: str
    group: str
    tooltip: str
    default: Any = None
    choices: Collection[str] = ()
    flags: int = 0


def version_of(group: str, version: int) -> Property:
    """The property that says how an object was made, for later versions to bring it up to date."""
    tooltip = QT_TRANSLATE_NOOP("App::Property", "Version of this object's properties")
    flags = OUTPUT | HIDDEN
    return Property("App::PropertyInteger", "Version", group, tooltip, version, flags=flags)


def ensure(owner: Any, properties: Sequence[Property]) -> None:
    """Add those properties that the object does not have yet; touch the value of no other."""
    for item in properties:
        if item.name in owner.PropertiesList:
            _add_choices(owner, item)
            continue
        owner.addProperty(item.kind, item.name, item.group, item.tooltip, item.flags)
        if item.choices:
            setattr(owner, item.name, list(item.choices))
        if item.default is not None:
            setattr(owner, item.name, item.default)


def _add_choices(owner: Any, item: Property) -> None:
    """Give an enumeration of an older document the choices that came later; keep what is chosen."""
    if item.choices and owner.getEnumerationsOfProperty(item.name) != list(item.choices):
        choose(owner, item, getattr(owner, item.name))


def choose(owner: Any, item: Property, word: str) -> None:
    """Set an enumeration to a word, also to one that is not among its usual choices."""
    own = () if word in item.choices else (word,)
    setattr(owner, item.name, [*item.choices, *own])
    setattr(owner, item.name, word)


class Stateless:
    """Base of proxies that keep nothing themselves, so there is nothing to save."""

    def dumps(self) -> None:
        """Save nothing: all state lives in properties."""
        return None

    def loads(self, state: object) -> None:
        """Restore nothing."""
        return None

    # FreeCAD 0.20 asks for the old names.
    __getstate__ = dumps
    __setstate__ = loads


class Persistent(Stateless):
    """Base of the proxies of document objects: a table of properties with a version.

    Attributes:
        properties: all there are in this version; ``Version`` is one of them.
        version: its number.
    """

    properties: Sequence[Property]
    version: int

    def __init__(self, feature: Any) -> None:
        ensure(feature, self.properties)
        feature.Proxy = self

    def onDocumentRestored(self, feature: Any) -> None:
        """Give an object from an older document the properties that came later."""
        ensure(feature, self.properties)
        if feature.Version != self.version:
            feature.Version = self.version
