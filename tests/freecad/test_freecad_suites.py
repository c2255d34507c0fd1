"""Starts FreeCAD, with and without a window, on the suites in this folder.

A suite is a file ``ortho_<name>_suite.py`` here; it is found by its name, there is no list to keep.
``ortho_<name>_window_suite.py`` (and ``ortho_window_suite.py``) runs in FreeCAD's window.
One suite alone: ``pytest tests/freecad -k <name>_suite``.
"""

import os
import re
import shutil
import signal
import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path

import pytest

FOLDER = Path(__file__).resolve().parent
ROOT = FOLDER.parents[1]
CONSOLE = os.environ.get("ORTHO_FREECADCMD") or shutil.which("freecadcmd")
WINDOW = os.environ.get("ORTHO_FREECAD") or shutil.which("freecad")
SCREEN = shutil.which("xvfb-run")
SECONDS = 450
# The first saves a document that the second opens, once with and once without the add-on.
SAVING, MISSING = "ortho_headless_suite", "ortho_missing_suite"
# These take a minute and more each, and what differs between versions of FreeCAD is met in the
# others too: on several versions they run on one.
LONG = {
    "ortho_first_steps_window_suite",
    "ortho_random_suite",
    "ortho_story_window_suite",
}
SUITES = sorted(path.stem for path in FOLDER.glob("ortho_*_suite.py") if path.stem != MISSING)
WINDOWED = [name for name in SUITES if name.endswith("_window_suite")]
HEADLESS = [name for name in SUITES if name not in WINDOWED]


def marked(suites):
    """Suites as parameters, marked with what a run of them has to know.

    Long ones come first: what is begun last should not keep one worker busy while others rest.
    """
    marks = {name: [pytest.mark.long_suite] for name in LONG}
    ordered = sorted(suites, key=lambda name: name not in LONG)
    return [pytest.param(name, marks=marks.get(name, [])) for name in ordered]


needs_console = pytest.mark.skipif(
    not CONSOLE, reason="FreeCAD is not installed: no freecadcmd, ORTHO_FREECADCMD not set"
)
needs_window = pytest.mark.skipif(
    not (WINDOW and SCREEN), reason="needs FreeCAD with a window and xvfb-run, one is missing"
)


# FreeCAD 1.1 greets a new user with a page that waits for an answer, unless it has been seen.
# Documents are saved for recovery every minute, as ortho_recovery_window_suite expects. On a busy
# machine too every shape follows at once, unless a test says otherwise.
PREFERENCES = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp">
<FCParamGroup Name="Preferences">
<FCParamGroup Name="Document"><FCInt Name="AutoSaveTimeout" Value="1"/></FCParamGroup>
<FCParamGroup Name="Mod"><FCParamGroup Name="Start">
<FCBool Name="FirstStart2024" Value="0"/>
</FCParamGroup><FCParamGroup Name="Ortho">
<FCFloat Name="AtOnceSeconds" Value="1000"/>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""


def fresh_home(folder, with_add_on=True):
    """A home folder of a new user, with the add-on where FreeCAD 0.20, 1.0 and 1.1 look for it."""
    home = folder / "home"
    for data in ("FreeCAD", "FreeCAD/v1-1"):
        settings = home / ".config" / data
        settings.mkdir(parents=True, exist_ok=True)
        (settings / "user.cfg").write_text(PREFERENCES, encoding="utf-8")
        mods = home / ".local" / "share" / data / "Mod"
        mods.mkdir(parents=True, exist_ok=True)
        if with_add_on and not (mods / "Ortho").exists():
            (mods / "Ortho").symlink_to(ROOT, target_is_directory=True)
    return home


def run_suite(program, suite, folder, scratch, with_add_on=True):
    """Run one suite in FreeCAD; give the suite's result and everything that FreeCAD said."""
    result = folder / "result.txt"
    home = fresh_home(folder, with_add_on)
    kept = {k: v for k, v in os.environ.items() if not k.startswith(("XDG_", "FREECAD", "PYTHON"))}
    environment = kept | {
        "HOME": str(home),
        "QTWEBENGINE_DISABLE_SANDBOX": "1",
        "ORTHO_SUITE": suite,
        "ORTHO_SUITE_FOLDER": str(FOLDER),
        "ORTHO_SUITE_RESULT": str(result),
        "ORTHO_SUITE_SECONDS": str(SECONDS - 15),
        "ORTHO_SUITE_SCRATCH": str(scratch),
    }
    if with_add_on and not (ROOT / ".venv").exists():
        environment["PYTHONPATH"] = sysconfig.get_paths()["purelib"]
    process = subprocess.Popen(
        [*program, str(FOLDER / "ortho_suite_runner.py")],
        env=environment,
        cwd=folder,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
        start_new_session=True,
    )
    try:
        said, _ = process.communicate(timeout=SECONDS)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        said, _ = process.communicate()
        said += f"\nno end after {SECONDS} s"
    return result.read_text(encoding="utf-8") if result.exists() else "no result", said


@pytest.fixture
def run(tmp_path, scratch, record_property):
    """Run a suite, show what came of it, and note the versions for scripts/matrix_table.py."""

    def run_and_show(program, suite, **options):
        folder = Path(tempfile.mkdtemp(dir=tmp_path))
        result, said = run_suite(program, suite, folder, scratch, **options)
        sys.stdout.write(f"{result}\n--- FreeCAD said ---\n{said}\n")
        record_property("freecad", result.partition("\n")[0])
        assert "SUITE PASSED" in result
        return result, said

    return run_and_show


@pytest.fixture(scope="module")
def scratch(tmp_path_factory):
    return tmp_path_factory.mktemp("scratch")


@needs_window
@pytest.mark.slow
@pytest.mark.parametrize("suite", marked(WINDOWED))
def test_with_a_window(run, suite):
    _, said = run([SCREEN, "-a", "-s", "-screen 0 1400x900x24", WINDOW], suite)
    for word in ("Traceback", "Exception", "Error in"):
        assert word not in said


@needs_console
@pytest.mark.parametrize("suite", marked(HEADLESS))
def test_headless(run, suite):
    _, said = run([CONSOLE], suite)
    # FreeCAD reports each error state with a traceback; there must be no other.
    asked_for = len(re.findall(r"^<class 'solver\.errors\.InputError'>: ", said, re.MULTILINE))
    assert said.count("Traceback") == asked_for
    assert "Exception while processing" not in said
    if suite == SAVING:
        for with_add_on in (True, False):
            result, _ = run([CONSOLE], MISSING, with_add_on=with_add_on)
            assert "skipped=1" in result
