"""Random arguments and damaged files: a code of three, one line, and nothing half-done.

Arguments are drawn from the verbs' own tables, files from small ones by cutting and mixing; both
are seeded, so that what fails once fails again.
"""

from __future__ import annotations

import argparse
import importlib
import json
import os
import random
import signal
import subprocess
import sys
from contextlib import contextmanager, suppress
from pathlib import Path

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.__main__ import main
from freecad_ortho.cli import commands
from freecad_ortho.fabrication import SYSTEMS
from freecad_ortho.triangles import read_triangles
from solver import InputError
from solver.io.points import read_points
from solver.isolated import LibraryError
from solver.mesh import remesh
from solver.nets import NETS
from tests.conftest import wavy_grid

CALLS, FILES = 300, 600
# Verbs that need files or libraries that are not given here.
HELPLESS = {"faces", "quads", "fit-multinet"}
# No call may take longer, in seconds.
LONGEST = 30
NUMBERS = "0 -1 1e-300 1e300 1e400 inf -inf nan x 1_0".split() + [""]
COUNTS = "0 -1 99999999999999999999999 1.5 x".split() + [""]
HUGE = "99999999999999999999999"
WORDS = (
    "x 0 -1 0,1 0,1,2 1,2,3 0,0,0 nan,0,0 1e400,0,0 0;1 0,1.5;3,1 none corners boundary a,b,c 4x3 "
    "2x2 0x0 -1x2 99999999x2 u v both z plane:z=0 plane:z=nan boundary@0 curve:PATH surface:PATH "
    "surface: 0:0,0,1 0:nan,0,0 radius=3 radius=nan lines=principal PATH FOLDER wave s;1/s lambda "
    "mu ellipsoid cables membrane principal stress sphere catenoid beams panels nodes lamellas "
    "steel glass 1e400 60x15 9,5,2 plain parallel 1"
).split() + ["", HUGE, f"0,{HUGE}", "n" * 300]
TOKENS = [*NUMBERS, *COUNTS, "#", "\\", ",", ";", "\0", "\n", "\r", "f", "v", "OFF", "é", '"', "{"]
# Positional words and options that a verb needs to come as far as its work, most often.
SOUND = {
    "name": ["sphere", "catenoid", "rectangle", "enneper", "translational"],
    "sampling": ["4x3", "5x5"],
    "semi_axes": ["3,2.2,1.4"],
    "moving": ["lambda", "mu", "nu"],
    "t_range": ["2.5,4", "0.1,0.5"],
    "distance": ["10", "-0.1"],
    "faces": ["9", "30"],
    "every": ["1", "2x1", "3x2"],
    "rows": ["1,0,0,0", "0,1,0,1"],
    "supports": ["boundary", "corners", "0,3"],
    "net": ["principal", "orthogonal", "asymptotic", "stress", "cmc"],
    "origin": ["keep", "local", "1,2,3"],
    "centre": ["0,0,9", "1,2,-30"],
    "fix": ["none", "corners", "boundary", "0,3"],
    "handle": ["0:0,0,1"],
    "glide": ["boundary", "z=0@0"],
    # In which the small meshes are as large as parts need them.
    "unit": ["m", "m", "ft", "mm"],
    "system": ["beams", "panels", "beams+panels", "lamellas", "nodes", "louvres"],
}
# Options that a verb cannot do without, though its table does not say so.
NEEDED = {
    "multinet": ["--moving"],
    "quads": ["--faces"],
    "trim": ["--rows"],
    "coarsen": ["--every"],
    # Small meshes are too small for beams in most units, and the usual one is among them.
    "fabricate": ["--unit"],
}


def texts() -> dict[str, bytes]:
    """Small files of every format, sound ones."""
    mesh = wavy_grid(4, 3)
    rows = [" ".join(map(str, row)) for row in mesh.vertices.tolist()]
    quads = [" ".join(map(str, row)) for row in mesh.faces.tolist()]
    head = (
        f"ply\nformat {{}} 1.0\nelement vertex 12\nproperty double x\nproperty double y\n"
        f"property double z\nelement face {len(quads)}\n"
        "property list uchar int vertex_indices\nend_header\n"
    )
    row = np.dtype([("count", "u1"), ("corners", "<i4", 4)])
    packed = np.array([(4, tuple(face)) for face in mesh.faces.tolist()], dtype=row)
    points = {
        str(k): dict(zip("xyz", p, strict=True)) for k, p in enumerate(mesh.vertices.tolist())
    }
    compas = {"vertex": points, "face": dict(zip("abcdef", mesh.faces.tolist(), strict=True))}
    obj = [f"f {' '.join(str(corner + 1) for corner in face)}" for face in mesh.faces.tolist()]
    off = [f"4 {quad}" for quad in quads]
    found = {
        "mesh.obj": ["# unit: m", *(f"v {row}" for row in rows), *obj],
        "mesh.off": ["OFF", f"12 {len(quads)} 0", *rows, *off],
        "ascii.ply": [head.format("ascii").rstrip(), *rows, *off],
        "points.txt": rows,
        "mesh.json": [
            json.dumps({"vertices": mesh.vertices.tolist(), "faces": mesh.faces.tolist()})
        ],
        "compas.json": [json.dumps({"dtype": "compas.datastructures/Mesh", "data": compas})],
    }
    binary = head.format("binary_little_endian").encode() + mesh.vertices.astype("<f8").tobytes()
    return {
        **{name: "\n".join([*lines, ""]).encode() for name, lines in found.items()},
        "binary.ply": binary + packed.tobytes(),
    }


def damaged(content: bytes, dice: random.Random) -> bytes:
    """A file with some of its words changed, lines doubled or lost, its end cut off."""
    for _ in range(dice.randint(1, 4)):
        kind = dice.choice(["word", "word", "word", "line", "cut", "byte", "glue", "encoding"])
        words = content.split(b" ")
        lines = content.split(b"\n")
        place = dice.randrange(len(words))
        if kind == "word":
            words[place] = dice.choice(TOKENS).encode()
            content = b" ".join(words)
        elif kind == "line":
            line = dice.randrange(len(lines))
            lines[line : line + 1] = [lines[line]] * dice.choice([0, 2, 3])
            content = b"\n".join(lines)
        elif kind == "cut" and len(content) > 1:
            content = content[: dice.randrange(1, len(content))]
        elif kind == "byte" and content:
            spot = dice.randrange(len(content))
            content = content[:spot] + bytes([dice.randrange(256)]) + content[spot + 1 :]
        elif kind == "glue":
            content = b" ".join(words[:place]) + b"".join(words[place:])
        elif kind == "encoding" and dice.random() < 0.2:
            content = content.decode("latin-1").encode("utf-16")
    return content


@contextmanager
def time_limit(what: str):
    """Fail where the block takes too long."""
    if not hasattr(signal, "SIGALRM"):
        yield
        return

    def ring(*_: object) -> None:
        pytest.fail(f"took more than {LONGEST} s: {what}")

    before = signal.signal(signal.SIGALRM, ring)
    signal.alarm(LONGEST)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


def verbs() -> dict[str, list[argparse.Action]]:
    """The options of every verb, from its own table."""
    (found,) = [a for a in commands._parser()._actions if isinstance(a, argparse._SubParsersAction)]
    return {name: parser._actions for name, parser in found.choices.items()}


def value(action: argparse.Action, dice: random.Random, path: str, folder: str) -> str:
    """A word for an option: most often one that it may have."""
    # Declared options are read as texts: what stands for a value in the help tells numbers.
    kind = float if action.metavar in ("MM", "DEG", "L", "N", "W", "PERCENT") else action.type
    if dice.random() < 0.8:
        if action.dest in SOUND:
            return dice.choice(SOUND[action.dest])
        if action.choices:
            return str(dice.choice(list(action.choices)))
        if "|" in str(action.metavar):
            return dice.choice(str(action.metavar).split("|"))
        if kind in (int, float):
            return dice.choice(["1", "2", "3"] if kind is int else ["1", "2.5", "0.01"])
    if kind is int:
        return dice.choice(COUNTS)
    if kind is float:
        return dice.choice(NUMBERS)
    return dice.choice(WORDS).replace("PATH", path).replace("FOLDER", folder)


def arguments(verb: str, actions: list, dice: random.Random, path: str, folder: str) -> list[str]:
    """Arguments for a verb: all that it must have and some of what it may have."""
    words = [verb]
    for action in actions:
        flag = (action.option_strings or [""])[-1]
        if flag in ("--help", "--workers", "--verbose"):
            continue
        users = set((action.help or "").partition(": ")[0].split(", "))
        # What the usual systems and the usual net do not have is refused, most shall get further.
        special = users <= {*SYSTEMS, *NETS} and not users & {"beams", "panels", "principal"}
        if (special or action.dest in ("forces", "symmetry")) and dice.random() < 0.9:
            continue
        if flag == "--output":
            name = dice.choice(["out.obj"] * 9 + ["out.json", "o" * 300, ""])
            words += [flag, os.path.join(folder, name)]
        elif action.dest in ("input", "inputs"):
            words.append(path if dice.random() < 0.95 else dice.choice(WORDS))
        elif not flag:
            words.append(value(action, dice, path, folder))
        elif flag == "--max-steps":
            words += [flag, dice.choice(["1", "2", "3", "3", "3", "3", "0", "x"])]
        elif action.required or flag in NEEDED.get(verb, ()) or dice.random() < 1.5 / len(actions):
            words += [flag] if action.nargs == 0 else [flag, value(action, dice, path, folder)]
    return words


@pytest.fixture
def library_fails(monkeypatch):
    """Compiled code in another process has tests of its own; here it would take all the time."""

    def run(*_: object) -> None:
        raise LibraryError("a stand-in")

    monkeypatch.setattr(remesh, "_run", run)
    with suppress(ImportError):
        # Its loading must not count as the time of the call that is the first to need it.
        importlib.import_module("cadquery")


def listing(folder) -> list[tuple[str, int]]:
    return sorted((str(path), path.stat().st_size) for path in folder.rglob("*"))


def finished_stages(words) -> list[Path]:
    """A build goes on from the stages that ended, so these stay, whole, with their report."""
    folder = Path(words[words.index("--output") + 1])
    report = folder / "report.json"
    # Not a method of the path, which fails where a name is too long.
    if not os.path.isfile(report):
        return []
    stages = json.loads(report.read_text())["build"]["stages"].values()
    return [folder, report, *(folder / name for stage in stages for name in stage["files"])]


def called(known, done):
    """Each verb in turn, then those again that did not yet do what they are for."""
    yield from (known[call % len(known)] for call in range(CALLS))
    for _ in range(CALLS // 3):
        yield from [verb for verb in known if verb not in done | HELPLESS][:1]


def test_every_verb_ends_in_a_code_and_one_line(tmp_path, capsys, monkeypatch, library_fails):
    # A word out of the lists may name a file to write.
    monkeypatch.chdir(tmp_path)
    dice, known, sound = random.Random(11), verbs(), texts()
    done = set()
    for call, verb in enumerate(called(list(known), done)):
        folder = tmp_path / str(call)
        folder.mkdir()
        name = dice.choice(list(sound))
        path = folder / name
        path.write_bytes(sound[name] if dice.random() < 0.7 else damaged(sound[name], dice))
        words = arguments(verb, known[verb], dice, str(path), str(folder))
        before = listing(folder)
        with time_limit(str(words)):
            try:
                code = main(words)
            except SystemExit as end:
                code = end.code
        said = capsys.readouterr().err
        told = f"{words}\n{said}"
        assert code in (0, 1, 2), told
        assert "Traceback" not in said, told
        done |= {verb} if code < 2 else set()
        if code == 2:
            assert said.count("error: ") == 1 and said.splitlines()[-1].startswith("error: "), told
            rest = [line for line in said.splitlines()[:-1] if not line.startswith("note: ")]
            assert rest == [], told
            kept = finished_stages(words) if verb == "build" else []
            left = [entry for entry in listing(folder) if Path(entry[0]) not in kept]
            assert left == before, told
    assert set(known) - done <= HELPLESS


def test_every_reader_reads_or_refuses_in_one_line(tmp_path):
    dice, sound = random.Random(5), texts()
    read = refused = 0
    for _ in range(FILES):
        name = dice.choice(list(sound))
        path = tmp_path / name
        content = damaged(sound[name], dice)
        path.write_bytes(content)
        reader = dice.choice([api.read_mesh, read_triangles])
        with time_limit(f"{name}: {content!r}"):
            try:
                (read_points if name.endswith("txt") else reader)(path)
                read += 1
            except InputError as error:
                refused += 1
                assert "\n" not in str(error), content
            except Exception as error:
                pytest.fail(f"{type(error).__name__}: {error}\n{name}: {content!r}")
    assert read > 50 and refused > 200


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["check", "n" * 300 + ".obj"], "cannot be read (File name too long)"),
        (["quads", "n" * 300 + ".stl", "--faces", "9", "-o", "out.obj"], "File name too long"),
        (["convert", "MESH", "-o", "n" * 300 + ".obj"], "(File name too long); choose a shorter"),
        (["fabricate", "MESH", "-o", "n" * 300], "(File name too long); choose a shorter name"),
        (["quads", "MESH", "--faces", "9", "--time-limit", "inf", "-o", "o.obj"], "finite number"),
        (["quads", "MESH", "--faces", "9", "--time-limit", "3601", "-o", "o.obj"], "3,600 at most"),
        (["optimise", "MESH", "--fix", HUGE, "-o", "o.obj"], f"vertex {HUGE} does not exist"),
        (["optimise", "MESH", "--fix", f"0,-{HUGE}", "-o", "o.obj"], f"vertex -{HUGE} does not"),
        (["fabricate", "MESH", "--sheet", "1e23x9" + "0" * 22, "-o", "o"], "expected WxH"),
        (["fabricate", "MESH", "--sheet", f"{HUGE}x{HUGE}", "-o", "o"], "take 1 km at most"),
    ],
)
@pytest.mark.skipif(sys.platform == "win32", reason="the system says it in other words")
def test_what_the_system_says_is_repeated(tmp_path, capsys, monkeypatch, arguments, words):
    monkeypatch.chdir(tmp_path)
    api.write_mesh(tmp_path / "mesh.obj", wavy_grid(3, 3), "m")
    assert main([word.replace("MESH", "mesh.obj") for word in arguments]) == 2
    said = capsys.readouterr().err
    assert words in said and said.count("\n") == 1
    assert [path.name for path in tmp_path.iterdir()] == ["mesh.obj"]


@pytest.mark.skipif(sys.platform == "win32", reason="the system says it in other words")
def test_both_processes_of_a_command_bear_names_of_any_length(tmp_path):
    """The one that waits for the other looks at all words, whether they are files or not."""
    command = [sys.executable, "-m", "freecad_ortho", "check", "n" * 300 + ".obj"]
    root = Path(__file__).resolve().parents[1]
    done = subprocess.run(command, cwd=root, capture_output=True, text=True, timeout=300)
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1 and "(File name too long)" in done.stderr
