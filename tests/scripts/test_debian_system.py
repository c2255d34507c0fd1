"""The systems for other FreeCAD versions: what is said where they cannot be had."""

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SYSTEM = ROOT / "scripts" / "debian_system.sh"
MATRIX = ROOT / "scripts" / "test_matrix.sh"
UNAVAILABLE = 75

as_root = pytest.mark.skipif(os.geteuid() != 0, reason="needs root")
can_mount = pytest.mark.skipif(
    shutil.which("unshare") is None
    or shutil.which("debootstrap") is None
    or subprocess.run(["unshare", "--mount", "true"], capture_output=True).returncode != 0,
    reason="needs the right to mount, and debootstrap",
)


def run(*command, **environment):
    return subprocess.run(
        [*map(str, command)],
        capture_output=True,
        text=True,
        env={**os.environ, **environment},
        check=False,
    )


def test_options_are_explained_and_checked():
    assert "--required" in run("bash", MATRIX, "--help").stdout
    wrong = run("bash", MATRIX, "--only", "woody")
    assert wrong.returncode == 2
    assert "expected here, bookworm trixie forky" in wrong.stderr
    assert run("bash", SYSTEM, "trixie").returncode == 2


@as_root
@pytest.mark.skipif(shutil.which("setpriv") is None, reason="needs setpriv")
def test_without_root_one_line_says_so():
    # pytest's own folders are closed to others.
    with tempfile.TemporaryDirectory() as folder:
        scripts = shutil.copytree(ROOT / "scripts", Path(folder) / "scripts")
        Path(folder).chmod(0o755)
        nobody = ("setpriv", "--reuid", "65534", "--clear-groups", "bash", scripts / SYSTEM.name)
        result = run(*nobody, "trixie", "true")
    assert result.returncode == UNAVAILABLE
    assert result.stderr.splitlines() == [
        "debian_system.sh: trixie: only root can build and enter a system"
    ]


@as_root
@can_mount
def test_what_cannot_be_built_leaves_no_half_system_and_no_mounts(tmp_path):
    mounts = Path("/proc/mounts").read_text(encoding="utf-8")
    settings = {
        "ORTHO_MATRIX_CACHE": str(tmp_path),
        "ORTHO_MATRIX_MIRROR": f"file://{tmp_path}/no-mirror",
    }
    result = run("bash", SYSTEM, "trixie", "true", **settings)
    assert result.returncode == UNAVAILABLE
    assert "trixie: could not be built" in result.stderr.splitlines()[-1]
    assert not (tmp_path / "trixie" / "system").exists()
    left_out = run("bash", MATRIX, "--only", "trixie", **settings)
    assert left_out.returncode == 0
    assert "not tested: trixie" in left_out.stderr
    required = run("bash", MATRIX, "--required", "--only", "trixie", **settings)
    assert required.returncode == 1
    assert Path("/proc/mounts").read_text(encoding="utf-8") == mounts
