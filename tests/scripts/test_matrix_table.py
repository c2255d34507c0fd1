"""The table of the FreeCAD versions says what each run said."""

import subprocess
import sys
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "matrix_table.py"

RUN = """<testsuites><testsuite>
<properties>
<property name="freecad" value="FreeCAD {version} (Python 3.13.5, Qt 5.15)"/>
</properties>
<testcase name="test_headless[ortho_headless_suite]" time="8.5"/>
<testcase name="test_with_a_window[ortho_window_suite]" time="60.0">{verdict}</testcase>
<testcase name="test_package_metadata" time="0.001"/>
</testsuite></testsuites>"""


def test_a_column_a_version_and_failures_by_name(tmp_path):
    runs = {"here": ("0.20.2", ""), "trixie": ("1.0.0", "<failure/>")}
    paths = []
    for name, (version, verdict) in runs.items():
        paths.append(tmp_path / f"{name}.xml")
        paths[-1].write_text(RUN.format(version=version, verdict=verdict), encoding="utf-8")
    output = subprocess.run(
        [sys.executable, SCRIPT, *paths], capture_output=True, text=True, check=True
    ).stdout
    rows = [line.split() for line in output.splitlines()]
    assert rows[0] == "here: FreeCAD 0.20.2 (Python 3.13.5, Qt 5.15)".split()
    assert rows[2] == ["seconds", "0.20.2", "(here)", "1.0.0", "(trixie)"]
    assert rows[3] == ["ortho_headless_suite", "8.5", "8.5"]
    assert rows[4] == ["ortho_window_suite", "60.0", "FAILED"]
    assert rows[5] == ["in", "all", "68.5", "8.5"]
    assert len(rows) == 6
