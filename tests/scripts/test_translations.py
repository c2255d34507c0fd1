"""Every string of the workbench is translated, and the tool that says so finds them all."""

import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def tool(monkeypatch):
    monkeypatch.syspath_prepend(str(ROOT / "scripts"))
    import translations

    yield translations
    sys.modules.pop("translations")


def test_every_string_is_translated(tool):
    missing = tool.problems(tool.collect())
    assert not missing, "translate these, then run scripts/translations.py:\n" + "\n".join(missing)


def test_strings_are_found_where_they_are_written(tool):
    found = tool.collect()
    assert found["Workbench", "&Ortho"] == "InitGui.py"
    assert ("Ortho_Beams", "Beams") in found
    assert ("OrthoPreferences", "Height of beams") in found
    assert ("OrthoPreferences", "scipy") not in found  # marked as not for translation
    assert ("Ortho", "Gauss curvature") in found
    assert found["App::Property", "Positions of the vertices, in mm"].endswith("net.py")


def test_a_marked_string_that_is_not_written_out_is_named(tool, tmp_path):
    path = tmp_path / "bad.py"
    path.write_text("text = QT_TRANSLATE_NOOP('Ortho', name)\n", encoding="utf-8")
    with pytest.raises(ValueError, match=r"bad\.py, line 1"):
        list(tool._of_code(path))


def test_a_file_keeps_what_is_done_and_marks_what_is_not(tool, tmp_path, monkeypatch):
    monkeypatch.setattr(tool, "FOLDER", tmp_path)
    monkeypatch.setattr(tool, "LANGUAGES", ("de",))
    strings = {("Ortho", "Start"): "a.py", ("Ortho", "{} <points>"): "a.py"}
    tool.write("de", strings, {("Ortho", "Start"): "Anfang", ("Ortho", "Gone"): "Weg"})
    assert tool.read("de") == {("Ortho", "Start"): "Anfang", ("Ortho", "{} <points>"): ""}
    assert tool.problems(strings) == ["de: '{} <points>' (Ortho, a.py) is not translated"]
    tool.write("de", strings, {("Ortho", "Start"): "Anfang", ("Ortho", "{} <points>"): "Punkte"})
    assert tool.problems(strings) == ["de: 'Punkte' has other placeholders than '{} <points>'"]
    strings = {("Ortho", "{count} points"): "a.py"}
    tool.write("de", strings, {("Ortho", "{count} points"): "{zahl} Punkte"})
    assert tool.problems(strings) == [
        "de: '{zahl} Punkte' has other placeholders than '{count} points'"
    ]


def test_words_that_nothing_uses_are_named(tool, tmp_path, monkeypatch):
    monkeypatch.setattr(tool, "FOLDER", tmp_path)
    monkeypatch.setattr(tool, "LANGUAGES", ("de",))
    words = {("Ortho", "Start"): "Anfang", ("Ortho", "{} <points>"): "Punkte"}
    tool.write("de", dict.fromkeys(words, "a.py"), words)
    assert tool.problems({}) == [
        "de: 'Start' (Ortho) is no longer used",
        "de: '{} <points>' (Ortho) is no longer used",
    ]
