"""docs/snippets: the functions that are asked for most, in each language, to paste. `tools/pick --pages DIR` writes
them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from catalog import asked
from tables.markdown import table

FUNCTIONS = asked.snippets()
# The heading, the language of tools/pick, its arithmetic, and the word that Markdown has for the language.
LANGUAGES = (("GLSL", "glsl", "fast", "glsl"), ("HLSL", "hlsl", "fast", "hlsl"), ("WGSL", "wgsl", "fast", "wgsl"),
             ("Slang", "slang", "fast", "slang"), ("Metal", "metal", "fast", "cpp"), ("Godot", "godot", "fast", "glsl"),
             ("GLSL, with the same bits everywhere", "glsl", "fixed", "glsl"), ("Rust", "rust", "fixed", "rust"),
             ("C#", "csharp", "fixed", "csharp"), ("C", "c", "fixed", "c"), ("TypeScript", "typescript", "fixed", "ts"),
             ("JavaScript", "javascript", "fixed", "js"), ("Java", "java", "fixed", "java"),
             ("Go", "go", "fixed", "go"))
Picked = Callable[[str, str, str], str]  # the text of a function in a language, with an arithmetic


def page(name: str, picked: Picked) -> str:
    """Of a function."""
    sections = [f"## {title}\n\n```{word}\n{picked(name, language, arithmetic)}```\n"
                for title, language, arithmetic, word in LANGUAGES]
    return (f"# {name}: {FUNCTIONS[name]}\n\n"
            "Paste what you need; each text stands alone. The GLSL is for OpenGL, from 3.30 on, and for WebGL2 and "
            "GLSL ES, whatever your own precision is. Those of the first six languages compute with floats "
            "(`HN_FAST`). All others compute the same bits as each other (`HN_FIXED`), for a server and its clients. "
            "[More](../languages.md#one-function) about `tools/pick`, which wrote them, and about other "
            "arithmetics and hashes.\n\n" + "\n".join(sections))


def index() -> str:
    """The page that lists the others."""
    return ("# Functions to paste\n\nEach page has one function in GLSL, HLSL, WGSL, Slang, Metal, Godot, Rust, C#, C, "
            "TypeScript, JavaScript, Java and Go. `tools/pick --pages docs/snippets` writes them; "
            "`tools/pick --list` names all other functions.\n\n"
            + table(("", "what it is"), [[f"[{name}]({name}.md)", what] for name, what in FUNCTIONS.items()]))


def write(folder: Path, picked: Picked) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "README.md").write_text(index(), encoding="utf-8")
    for name in FUNCTIONS:
        (folder / f"{name}.md").write_text(page(name, picked), encoding="utf-8")
