"""Letters of single strokes, for tools that follow lines and know no fonts.

On a grid of four by six units each letter is a few lines through points named by two digits, x and
y; small letters are drawn as capitals. What has no strokes, such as letters with accents, is an
empty box.
"""

from __future__ import annotations

import math

import numpy as np

from solver.mesh.quadmesh import FloatArray

# From one letter to the next, and the height of capitals, in units of the grid.
_ADVANCE, _WIDTH, _HEIGHT = 5, 4, 6
_BOX = "00 40 46 06 00"
_GLYPHS = {
    " ": "",
    "A": "00 26 40|12 32",
    "B": "00 06 36 45 44 33 03|33 42 41 30 00",
    "C": "45 36 16 05 01 10 30 41",
    "D": "00 06 26 44 42 20 00",
    "E": "46 06 00 40|03 33",
    "F": "46 06 00|03 33",
    "G": "45 36 16 05 01 10 30 41 43 23",
    "H": "00 06|40 46|03 43",
    "I": "10 30|20 26|16 36",
    "J": "46 41 30 10 01",
    "K": "00 06|46 02|14 40",
    "L": "06 00 40",
    "M": "00 06 23 46 40",
    "N": "00 06 40 46",
    "O": "10 01 05 16 36 45 41 30 10",
    "P": "00 06 36 45 44 33 03",
    "Q": "10 01 05 16 36 45 41 30 10|22 40",
    "R": "00 06 36 45 44 33 03|23 40",
    "S": "45 36 16 05 04 13 33 42 41 30 10 01",
    "T": "06 46|26 20",
    "U": "06 01 10 30 41 46",
    "V": "06 20 46",
    "W": "06 10 23 30 46",
    "X": "00 46|06 40",
    "Y": "06 23 46|23 20",
    "Z": "06 46 00 40",
    "0": "10 01 05 16 36 45 41 30 10|01 45",
    "1": "04 26 20|00 40",
    "2": "05 16 36 45 44 00 40",
    "3": "05 16 36 45 44 33 42 41 30 10 01|13 33",
    "4": "40 46 02 42",
    "5": "46 06 03 33 42 41 30 00",
    "6": "45 36 16 05 01 10 30 41 42 33 03",
    "7": "06 46 10",
    "8": "13 04 05 16 36 45 44 33 13 02 01 10 30 41 42 33",
    "9": "01 10 30 41 45 36 16 05 04 13 43",
    "-": "03 43",
    "+": "03 43|21 25",
    ".": "10 20 21 11 10",
    ",": "21 10",
    ":": "21 22|24 25",
    "/": "00 46",
    "\\": "06 40",
    "_": "00 40",
    "(": "36 25 21 30",
    ")": "16 25 21 10",
    "=": "02 42|04 44",
    "<": "45 03 41",
    ">": "05 43 01",
    "#": "11 15|31 35|02 42|04 44",
    "%": "00 46|04 05 15 14 04|31 32 42 41 31",
    "'": "24 26",
    "*": "11 35|15 31|03 43",
    "°": "14 15 25 24 14",
    "±": "04 44|22 26|00 40",
}


def text_strokes(words: str, middle: FloatArray, size: float, angle: float) -> list[FloatArray]:
    """Lines of a text about its middle.

    Args:
        words: one line of text.
        middle: (2,) of the text, mm.
        size: height of capitals, mm.
        angle: direction of the text, degrees.

    Returns:
        Polylines (K, 2), mm; a letter is no wider than its height.
    """
    unit, turn = size / _HEIGHT, math.radians(angle)
    axes = unit * np.array([[math.cos(turn), math.sin(turn)], [-math.sin(turn), math.cos(turn)]])
    half = np.array([(len(words) * _ADVANCE - (_ADVANCE - _WIDTH)) / 2, _HEIGHT / 2])
    lines = []
    for number, letter in enumerate(words.upper()):
        for line in filter(None, _GLYPHS.get(letter, _BOX).split("|")):
            points = np.array([[int(digit) for digit in pair] for pair in line.split()], np.float64)
            lines.append((points + [number * _ADVANCE, 0] - half) @ axes + middle)
    return lines
