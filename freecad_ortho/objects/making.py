"""Nets of sources ready to be made: in any thread, and not twice where it takes long."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from hashlib import sha256
from typing import Any

import FreeCAD
import numpy as np

from freecad_ortho import convert
from freecad_ortho.objects import cad_faces, places, strokes
from freecad_ortho.sources import Made, Source
from solver.errors import InputError

Piece = tuple[FreeCAD.DocumentObject, str]
# What was made last by sources that take long, by words that stand for all that it was made from: a
# panel, the macro line that it writes and the recompute after that all ask for the same.
_KEPT = 6
_made: dict[str, Made] = {}


@dataclass(frozen=True)
class Inputs:
    """What a net is made of, in a document.

    Attributes:
        nets: that it is changed or joined from.
        faces: of shapes, that it is sampled from.
        strokes: edges, wires and sketches that its lines run along.
    """

    nets: Sequence[FreeCAD.DocumentObject] = ()
    faces: Sequence[Piece] = ()
    strokes: Sequence[Piece] = ()

    @property
    def owners(self) -> list[FreeCAD.DocumentObject]:
        """All objects of the document that it is made of, each once."""
        parts = [part[0] for part in (*self.faces, *self.strokes)]
        return list({item.Name: item for item in (*self.nets, *parts)}.values())

    def require(self, entry: Source) -> None:
        """Raise InputError unless a source is given what it needs."""
        wanted = 1 if entry.needs in ("net", "nets") else 0
        if len(self.nets) < wanted or (entry.needs != "nets" and len(self.nets) > wanted):
            raise InputError(
                f"{entry.name}: expected {wanted or 'no'} net{'s' * (wanted != 1)}"
                f"{' or more' * (entry.needs == 'nets')}, got {len(self.nets)}; select them"
            )
        if (entry.needs == "faces") != bool(self.faces):
            words = "at least one CAD face" if entry.needs == "faces" else "no CAD faces"
            raise InputError(f"{entry.name}: expected {words}, got {len(self.faces)}; select them")
        if self.strokes and not entry.strokes:
            raise InputError(f"{entry.name}: its lines follow no strokes; leave them out")

    def geometry(self, beside: FreeCAD.DocumentObject | None = None) -> dict[str, Any]:
        """What a source takes besides its options: plain arrays and functions.

        Args:
            beside: an object in whose coordinates the meshes of the nets are given, by default the
                first net.

        Raises:
            InputError: a face or an edge that has gone.
        """
        result: dict[str, Any] = {}
        if self.nets:
            target = self.nets[0] if beside is None else beside
            result["meshes"] = [
                places.moved_mesh(convert.quad_mesh(net), places.between(target, net))
                for net in self.nets
            ]
        if self.faces:
            result["surfaces"] = [cad_faces.parametric_surface(*face) for face in self.faces]
        if self.strokes:
            result["strokes"] = strokes.curves(list(self.strokes))
        return result


@dataclass(frozen=True, eq=False)
class Making:
    """A net that is ready to be made, in any thread.

    Attributes:
        entry: its source.
        values: options by name.
        geometry: what it is made of.
        word: stands for all of these where the source takes long, else empty.
    """

    entry: Source
    values: Mapping[str, Any]
    geometry: dict[str, Any]
    word: str

    @classmethod
    def of(
        cls,
        entry: Source,
        values: Mapping[str, Any],
        inputs: Inputs,
        beside: FreeCAD.DocumentObject | None = None,
    ) -> Making:
        """Take from the document what is needed.

        Raises:
            InputError: an unknown option, or a face or an edge that has gone.
        """
        geometry = inputs.geometry(beside)
        word = _word(entry, values, inputs, geometry) if entry.stages else ""
        return cls(entry, values, geometry, word)

    @property
    def at_hand(self) -> bool:
        """Tell whether nothing is left to be done."""
        return self.word in _made

    def made(self, waiting: Callable[[str], object] = lambda stage: None) -> Made:
        """Make it, or give what was made from the same before.

        Args:
            waiting: called with the name of each stage of its source; what it raises is passed
                on.

        Raises:
            OrthoError: values that make no net.
        """
        if self.at_hand:
            return _made[self.word]
        found = self.entry.make(self.values, waiting=waiting, **self.geometry)
        if self.word:
            _made[self.word] = found
            for old in list(_made)[:-_KEPT]:
                del _made[old]
        return found


def _word(
    entry: Source, values: Mapping[str, Any], inputs: Inputs, geometry: dict[str, Any]
) -> str:
    chosen = {name: _number(x) for name, x in (entry.defaults | entry.current(values)).items()}
    lines = [line.tolist() for line in geometry.get("strokes", ())]
    faces = [cad_faces.face_word(*face) for face in inputs.faces]
    text = json.dumps([entry.name, chosen, lines, faces], default=_plain)
    return sha256(text.encode()).hexdigest()


def _number(value: Any) -> Any:
    return float(value) if isinstance(value, (int, float)) else value


def _plain(value: Any) -> Any:
    return value.tolist() if isinstance(value, (np.ndarray, np.generic)) else str(value)
