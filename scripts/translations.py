"""The words of the workbench in other languages: collects them, checks them, compiles them.

usage: python scripts/translations.py            collect the strings into the .ts files, compile
       python scripts/translations.py --check    only say what is missing; exit code 1 if anything

A string is found where it is written: translate(CONTEXT, TEXT), QT_TRANSLATE_NOOP(CONTEXT, TEXT),
Sentence(TEXT, ...) of rooms without FreeCAD, the texts of .ui files, and the catalogues that
catalogue_words.py reads. A new one appears in the .ts files as unfinished; translate it there (or
with Qt Linguist) and run this again. Compiling needs Qt's lrelease, in Debian qttools5-dev-tools.
"""

from __future__ import annotations

import ast
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from pathlib import Path

import catalogue_words

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "freecad_ortho" / "resources" / "translations"
LANGUAGES = ("de", "fr")
_MARKERS = ("translate", "QT_TRANSLATE_NOOP")
# The context of what panels show.
_PANELS = "Ortho"

# (context, text as it is written in the source)
Key = tuple[str, str]


def sources() -> list[Path]:
    """List the files that hold strings for people."""
    package, solver = ROOT / "freecad_ortho", ROOT / "solver"
    code = [path for folder in (package, solver) for path in sorted(folder.rglob("*.py"))]
    return [ROOT / "InitGui.py", *code, *sorted(package.rglob("*.ui"))]


def collect() -> dict[Key, str]:
    """Find every string with the file it stands in, in the order of the files.

    Raises:
        ValueError: a marked string that is not written out, so nobody could translate it.
    """
    found: dict[Key, str] = {}
    for path in sources():
        strings = _of_form if path.suffix == ".ui" else _of_code
        for key in strings(path):
            found.setdefault(key, path.relative_to(ROOT).as_posix())
    for key in catalogue_words.words():
        found.setdefault(key, "scripts/catalogue_words.py")
    return found


def _of_code(path: Path) -> Iterator[Key]:
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"), str(path))):
        if isinstance(node, ast.Call) and _called(node) == "Sentence":
            yield _PANELS, _pattern(node, path)
        if not isinstance(node, ast.Call) or _called(node) not in _MARKERS or len(node.args) < 2:
            continue
        words = [item.value if isinstance(item, ast.Constant) else None for item in node.args[:2]]
        if all(isinstance(word, str) for word in words):
            yield words[0], words[1]
        elif _called(node) == "QT_TRANSLATE_NOOP":
            raise ValueError(f"{path.name}, line {node.lineno}: expected two texts in quotes")


def _pattern(node: ast.Call, path: Path) -> str:
    """The words of a sentence, which panels translate when they show it."""
    words = node.args[0].value if isinstance(node.args[0], ast.Constant) else None
    if not isinstance(words, str):
        raise ValueError(f"{path.name}, line {node.lineno}: expected a text in quotes")
    return words


def _called(node: ast.Call) -> str:
    return getattr(node.func, "attr", getattr(node.func, "id", ""))


def _of_form(path: Path) -> Iterator[Key]:
    """Texts of a form, in the context that Qt gives them: the form's class."""
    form = ElementTree.parse(path).getroot()
    context = form.findtext("class", "")
    for item in form.iter("string"):
        if item.text and item.get("notr") != "true":
            yield context, item.text


def read(language: str) -> dict[Key, str]:
    """Read a .ts file; an unfinished translation is the empty text."""
    path = FOLDER / f"Ortho_{language}.ts"
    if not path.exists():
        return {}
    words = {}
    for context in ElementTree.parse(path).getroot().iter("context"):
        name = context.findtext("name", "")
        for message in context.iter("message"):
            done = message.find("translation")
            text = "" if done is None or done.get("type") else done.text or ""
            words[name, message.findtext("source", "")] = text
    return words


def write(language: str, strings: dict[Key, str], words: dict[Key, str]) -> None:
    """Write a .ts file with exactly these strings and the translations there are for them."""
    document = ElementTree.Element("TS", version="2.1", language=language, sourcelanguage="en")
    contexts: dict[str, ElementTree.Element] = {}
    for (context, text), file in sorted(strings.items()):
        if context not in contexts:
            contexts[context] = ElementTree.SubElement(document, "context")
            ElementTree.SubElement(contexts[context], "name").text = context
        message = ElementTree.SubElement(contexts[context], "message")
        ElementTree.SubElement(message, "location", filename=f"../../../{file}")
        ElementTree.SubElement(message, "source").text = text
        done = ElementTree.SubElement(message, "translation")
        done.text = words.get((context, text)) or None
        if done.text is None:
            done.set("type", "unfinished")
    ElementTree.indent(document, " ")
    body = ElementTree.tostring(document, encoding="unicode")
    head = '<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n'
    (FOLDER / f"Ortho_{language}.ts").write_text(f"{head}{body}\n", encoding="utf-8")


def problems(strings: dict[Key, str]) -> list[str]:
    """Say what each language lacks, has too much, or has with other placeholders."""
    said = []
    for language in LANGUAGES:
        words = read(language)
        for (context, text), file in strings.items():
            done = words.get((context, text), "")
            if not done:
                said.append(f"{language}: '{text}' ({context}, {file}) is not translated")
            elif _placeholders(done) != _placeholders(text):
                said.append(f"{language}: '{done}' has other placeholders than '{text}'")
        gone = [key for key in words if key not in strings]
        said += [f"{language}: '{text}' ({context}) is no longer used" for context, text in gone]
    return said


def _placeholders(text: str) -> list[str]:
    return sorted(re.findall(r"\{[^{}]*\}", text))


def lrelease() -> str | None:
    """Find Qt's compiler of translations."""
    names = ("lrelease", "lrelease-qt5", "/usr/lib/qt5/bin/lrelease", "/usr/lib/qt6/bin/lrelease")
    return next((path for path in map(shutil.which, names) if path), None)


def main(arguments: list[str]) -> int:
    """Bring the translations up to date or check them; return the exit code."""
    strings = collect()
    if arguments != ["--check"]:
        program = lrelease()
        if program is None:
            print("translations: lrelease is missing; install qttools5-dev-tools", file=sys.stderr)
            return 1
        FOLDER.mkdir(exist_ok=True)
        for language in LANGUAGES:
            write(language, strings, read(language))
            ts = FOLDER / f"Ortho_{language}.ts"
            command = [program, "-silent", str(ts), "-qm", str(ts.with_suffix(".qm"))]
            subprocess.run(command, check=True)
    said = problems(strings)
    print("\n".join([*said, f"{len(strings)} strings, {len(said)} to do"]))
    return 1 if said else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
