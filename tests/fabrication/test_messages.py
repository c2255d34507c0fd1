"""Messages that reach FreeCAD's panels too do not speak of options of the command line."""

from __future__ import annotations

import ast
import re

from tests.conftest import ROOT

_OPTION = re.compile(r"(?<![\w-])--[a-z]")


def test_no_message_of_a_system_names_an_option_of_the_command_line():
    files = [*(ROOT / "freecad_ortho" / "fabrication").rglob("*.py")]
    files += (ROOT / "solver" / "unroll").glob("*.py")
    assert len(files) > 50
    found = [
        f"{path.name}:{node.lineno}: {node.value}"
        for path in files
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Constant)
        and isinstance(node.value, str)
        and _OPTION.search(node.value)
    ]
    assert found == []
