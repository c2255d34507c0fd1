"""Makes pictures of every task panel and every command's result, and those of docs/tutorial.md.

Run with the project's Python:  python scripts/docs_screens.py FOLDER [--write]

All of them go to FOLDER; ``--write`` puts those of the tutorial into docs/pictures/tutorial too.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
PICTURES = ROOT / "docs" / "pictures" / "tutorial"
_COLOURS = 128
_WIDEST = 1000
# Ten times what it takes on a machine that does nothing else.
_SECONDS = 1800


def main() -> None:
    """Have FreeCAD make them, and shrink those that the tutorial shows."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--write", action="store_true", help="into docs/pictures/tutorial as well")
    options = parser.parse_args()
    folder = options.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    take(folder)
    if options.write:
        PICTURES.mkdir(parents=True, exist_ok=True)
        page = (ROOT / "docs" / "tutorial.md").read_text(encoding="utf-8")
        for name in re.findall(r"\(pictures/tutorial/([a-z-]+\.png)\)", page):
            shrink(folder / name, PICTURES / name)


def take(folder: Path) -> None:
    """Run FreeCAD as a new user, with this add-on."""
    sys.path.insert(0, str(ROOT / "tests" / "freecad"))
    from test_freecad_suites import fresh_home

    program = [os.environ.get("ORTHO_FREECAD") or shutil.which("freecad") or "FreeCAD"]
    if screen := shutil.which("xvfb-run"):
        program = [screen, "-a", "-s", "-screen 0 1400x1300x24", *program]
    environment = {
        **os.environ,
        "HOME": str(fresh_home(folder / "run")),
        "QTWEBENGINE_DISABLE_SANDBOX": "1",
        "ORTHO_SUITE_SCRATCH": str(folder),
        "ORTHO_SUITE_FOLDER": str(ROOT / "tests" / "freecad"),
    }
    script = str(ROOT / "scripts" / "docs_screens_freecad.py")
    process = subprocess.Popen(
        [*program, script],
        env=environment,
        text=True,
        errors="replace",
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        start_new_session=True,
    )
    try:
        said, _ = process.communicate(timeout=_SECONDS)
    except subprocess.TimeoutExpired:
        # The screen's program alone would leave FreeCAD running.
        os.killpg(process.pid, signal.SIGKILL)
        sys.exit(f"FreeCAD has not made all pictures in {_SECONDS} s; run this with less beside it")
    shutil.rmtree(folder / "run")
    if process.returncode or "Traceback" in said:
        sys.exit(said)


def shrink(source: Path, target: Path) -> None:
    """Save a picture with as few pixels and colours as the eye needs."""
    with Image.open(source) as picture:
        small = picture.convert("RGB")
    if small.width > _WIDEST:
        height = round(_WIDEST * small.height / small.width)
        small = small.resize((_WIDEST, height), Image.Resampling.LANCZOS)
    small.quantize(_COLOURS, dither=Image.Dither.NONE).save(target, optimize=True)


if __name__ == "__main__":
    main()
