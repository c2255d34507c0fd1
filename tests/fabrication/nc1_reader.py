"""A reader of NC1 files, written from the standard alone: DSTV (1998), 7th edition."""

import re
from dataclasses import dataclass, field

import numpy as np

BLOCKS = {"ST", "EN", "BO", "SI", "AK", "IK", "PU", "KO", "SC", "TO", "UE", "PR", "KA"}
_NUMBER = r"[-+]?\d+(?:\.\d+)?"


@dataclass
class Piece:
    """What one file says."""

    words: list
    length: float
    height: float
    width: float
    flange: float
    web: float
    radius: float
    mass: float
    paint: float
    cuts: tuple
    texts: list
    contours: list = field(default_factory=list)
    holes: list = field(default_factory=list)
    marks: list = field(default_factory=list)

    @property
    def code(self):
        return self.words[7]

    def faces(self, letter, block="AK"):
        return [rows for kind, face, rows in self.contours if (kind, face) == (block, letter)]


def read_nc1(path):
    """Read a file, refusing what the standard does not allow."""
    text = path.read_bytes().decode("ascii")
    lines = [line for line in text.splitlines() if not line.startswith("**")]
    assert lines[0] == "ST"
    assert lines[-1] == "EN"
    head, rest = lines[1:25], lines[25:-1]
    assert all(line.startswith("  ") for line in head)
    fields = [line[2:].strip() for line in head]
    sizes = [float(text) for text in fields[8:20]]
    piece = Piece(fields[:8], *sizes[:8], tuple(sizes[8:]), fields[20:])
    assert int(fields[5]) >= 1
    block = None
    for line in rest:
        if line[:2].strip():
            block = line.strip()
            assert block in BLOCKS
            if block in ("AK", "IK"):
                piece.contours.append((block, None, []))
            continue
        _READ[block](piece, line[2:])
    for _, _, rows in piece.contours:
        # Closed, and every other point once.
        assert np.allclose(rows[0][:2], rows[-1][:2])
        assert len({tuple(row[:2]) for row in rows[:-1]}) == len(rows) - 1
    return piece


def _contour(piece, line):
    kind, face, rows = piece.contours[-1]
    if line[0] in "vouh":
        face, line = line[0], line[1:]
    numbers = [float(word) for word in re.findall(_NUMBER, line)]
    assert len(numbers) == 7
    piece.contours[-1] = (kind, face, [*rows, numbers])


def _hole(piece, line):
    found = re.fullmatch(
        rf"([vouh])\s*({_NUMBER})([ous]?)\s*({_NUMBER})\s+({_NUMBER})\s+0\.00", line
    )
    piece.holes.append((found[1], float(found[2]), float(found[4]), float(found[5])))


def _mark(piece, line):
    found = re.fullmatch(
        rf"([vouh])\s*({_NUMBER})([ous]?)\s*({_NUMBER})\s+({_NUMBER})\s+(\d+)([rz ])(.{{1,40}})",
        line,
    )
    piece.marks.append((float(found[2]), float(found[4]), found[8]))


_READ = {"AK": _contour, "IK": _contour, "BO": _hole, "SI": _mark}
