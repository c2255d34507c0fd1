"""setup.sh: quick when nothing is to be done, plain words when something is wrong."""

import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
MINOR = "{}.{}".format(*sys.version_info)


def setup(root=ROOT, *options, **environment):
    # Paths that test.sh found are for the run that found them, not for this test.
    inherited = {name: value for name, value in os.environ.items() if name[:6] != "ORTHO_"}
    return subprocess.run(
        ["bash", str(root / "scripts" / "setup.sh"), *options],
        env=inherited | environment,
        capture_output=True,
        text=True,
        check=False,
    )


def lines(result):
    return result.stderr.strip().splitlines()


def test_quick_when_all_is_there():
    assert setup().returncode == 0
    started = time.monotonic()
    result = setup()
    seconds = time.monotonic() - started
    assert result.returncode == 0
    assert len(lines(result)) == 1
    assert lines(result)[0].startswith("ready: FreeCAD ")
    assert seconds < 2


@pytest.mark.parametrize(
    ("environment", "words"),
    [
        ({"ORTHO_FREECADCMD": "/nowhere/freecadcmd"}, ("ORTHO_FREECADCMD", "cannot be run")),
        ({"ORTHO_FREECAD": "/nowhere/freecad"}, ("ORTHO_FREECAD", "cannot be run")),
        ({"ORTHO_PYTHON": "/bin/true"}, ("ORTHO_PYTHON", "runs Python 3.")),
    ],
)
def test_wrong_place_is_said_in_one_line(environment, words):
    result = setup(**environment)
    assert result.returncode == 1
    assert len(lines(result)) == 1
    assert all(word in result.stderr for word in words)


def test_unknown_option():
    result = setup(ROOT, "--everything")
    assert result.returncode == 2
    assert lines(result) == ["setup.sh: unknown option '--everything'; see --help"]


def test_help_names_every_variable():
    result = setup(ROOT, "--help")
    assert result.returncode == 0
    for name in ("ORTHO_FREECADCMD", "ORTHO_FREECAD", "ORTHO_PYTHON", "--dev"):
        assert name in result.stdout


def program(path, text):
    path.write_text("#!/bin/sh\n" + text)
    path.chmod(0o755)


@pytest.fixture
def project(tmp_path):
    """A project that asks for no packages, beside a FreeCAD that only says its Python."""
    root = tmp_path / "project with a space"
    (root / "scripts").mkdir(parents=True)
    for name in ("common.sh", "setup.sh"):
        shutil.copy(ROOT / "scripts" / name, root / "scripts")
    for name in (
        "requirements.txt",
        "requirements-dev.txt",
        "requirements-exchange.txt",
        "requirements-fast.txt",
        "requirements-remesh.txt",
    ):
        (root / name).write_text("# none\n")
    program(tmp_path / "freecadcmd", f"echo ORTHO-PROBE {MINOR} 9.9.9\n")
    program(tmp_path / "freecad", "")
    return root


def setup_project(root, *options):
    return setup(root, *options, ORTHO_FREECADCMD=str(root.parent / "freecadcmd"))


def test_makes_an_environment_of_freecads_python(project):
    result = setup_project(project)
    assert result.returncode == 0, result.stderr
    assert lines(result)[-1].startswith("ready: FreeCAD 9.9.9 (")
    code = "import sys; print('%d.%d' % sys.version_info[:2], sys.prefix)"
    command = [project / ".venv" / "bin" / "python", "-c", code]
    assert subprocess.check_output(command, text=True).strip() == f"{MINOR} {project / '.venv'}"
    assert len(lines(setup_project(project))) == 1


def test_other_requirements_are_installed(project):
    assert setup_project(project).returncode == 0
    (project / "requirements.txt").write_text("# still none\n")
    assert "installing Python packages" in setup_project(project).stderr
    assert "installing" not in setup_project(project).stderr


def test_an_environment_of_another_python_is_made_anew(project):
    stale = project / ".venv" / "bin"
    stale.mkdir(parents=True)
    program(stale / "python", "echo 2.7\n")
    result = setup_project(project)
    assert result.returncode == 0, result.stderr
    assert "making .venv anew" in result.stderr


def test_development_packages_include_the_others(project):
    assert setup_project(project, "--dev").returncode == 0
    assert len(lines(setup_project(project))) == 1


def test_optional_packages_are_not_needed(project):
    (project / "requirements-fast.txt").write_text("./missing-0-py3-none-any.whl\n")
    result = setup_project(project)
    assert result.returncode == 0, result.stderr
    assert "something slower or simpler takes its place" in result.stderr


def test_remeshing_library_is_not_needed(project):
    (project / "requirements-remesh.txt").write_text("./missing-0-py3-none-any.whl\n")
    result = setup_project(project, "--dev")
    assert result.returncode == 0, result.stderr
    assert "quads of triangles" in result.stderr


def test_failing_packages_are_said_and_tried_again(project):
    (project / "requirements.txt").write_text("./missing-0-py3-none-any.whl\n")
    result = setup_project(project)
    assert result.returncode == 1
    assert lines(result)[-1].startswith("setup.sh: pip could not install")
    (project / "requirements.txt").write_text("# none\n")
    assert setup_project(project).returncode == 0


def test_freecad_that_does_not_start(project):
    program(project.parent / "freecadcmd", "exit 3\n")
    result = setup_project(project)
    assert result.returncode == 1
    assert "does not start" in lines(result)[-1]


def test_no_python_of_freecads_version(project):
    program(project.parent / "freecadcmd", "echo ORTHO-PROBE 3.99 9.9.9\n")
    result = setup_project(project)
    assert result.returncode == 1
    assert "no python3.99 was found" in lines(result)[-1]
    assert not (project / ".venv").exists()
