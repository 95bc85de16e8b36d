"""Writes docs/reference/snippets: the functions in most use, in GLSL, HLSL and WGSL, to paste. The site and a release
have these pages in each language.

    tools/make snippets [--check] [--out DIR]

Exit status: 0 done, or the pages are up to date; 1 (--check) one is not, or a text cannot be picked; 2 bad
usage, or a folder that cannot be written.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from base import modules
from base.cache import cached
from base.tree import GLSL, ROOT, glsl_files
from base.usage import Parser
from catalog import popular
from catalog.tables.markdown import table
from translate.parsing.tokens import Unknown
from translate.pick.command import SYNTAXES, Choice, picker

FOLDER = ROOT / "docs" / "reference" / "snippets"

FUNCTIONS = popular.snippets()
# The heading, the language of tools/pick, its arithmetic, and the word that Markdown has for the language.
LANGUAGES = (("GLSL", "glsl", "fast", "glsl"), ("HLSL", "hlsl", "fast", "hlsl"), ("WGSL", "wgsl", "fast", "wgsl"),
             ("Slang", "slang", "fast", "slang"), ("Metal", "metal", "fast", "cpp"), ("Godot", "godot", "fast", "glsl"),
             ("GLSL, with the same bits everywhere", "glsl", "fixed", "glsl"), ("Rust", "rust", "fixed", "rust"),
             ("C#", "csharp", "fixed", "csharp"), ("C", "c", "fixed", "c"), ("TypeScript", "typescript", "fixed", "ts"),
             ("JavaScript", "javascript", "fixed", "js"), ("Java", "java", "fixed", "java"),
             ("Go", "go", "fixed", "go"))
LANGUAGES = tuple(one for one in LANGUAGES if one[2] == "fast" or one[1] in ("glsl", *SYNTAXES))  # else it was deleted
OF_TREE = tuple(one for one in LANGUAGES if one[0] in ("GLSL", "HLSL", "WGSL"))
NAMES = "GLSL, HLSL, WGSL, Slang, Metal, Godot, Rust, C#, C, TypeScript, JavaScript, Java and Go"
Languages = Sequence[tuple[str, str, str, str]]
Picked = Callable[[str, str, str], str]  # the text of a function in a language, with an arithmetic


def page(name: str, picked: Picked, languages: Languages = OF_TREE) -> str:
    sections = [f"## {title}\n\n```{word}\n{picked(name, language, arithmetic)}```\n"
                for title, language, arithmetic, word in languages]
    floats = ("They compute with floats (`HN_FAST`). " if languages == OF_TREE else
              "Texts in the first six languages compute with floats (`HN_FAST`). All others compute the same bits as each "
              "other (`HN_FIXED`), for a server and its clients. ")
    return (f"# {name}: {FUNCTIONS[name]}\n\n"
            "Paste what you need; each text stands alone. The GLSL is for OpenGL, from 3.30 on, and for WebGL2 and "
            f"GLSL ES, whatever your own precision is. {floats}"
            "[More](../../guide/languages.md#one-function) about `tools/pick`, which wrote them, and about other "
            "arithmetics and hashes.\n\n" + "\n".join(sections))


def index(languages: Languages = OF_TREE) -> str:
    """The page that lists the others."""
    which = (f"GLSL, HLSL and WGSL. `tools/pick hn_perlin2 --language rust` writes one in another language; a release and "
             f"the site that `tools/make site` makes have these pages in {NAMES}. "
             if languages == OF_TREE else f"{NAMES}. ")
    return (f"# Functions to paste\n\nEach page has one function in {which}`tools/pick --list` names all other functions.\n\n"
            + table(("", "what it is"), [[f"[{name}]({name}.md)", what] for name, what in FUNCTIONS.items()]))


def for_pages(library: Path = GLSL) -> Picked:
    """The texts of docs/reference/snippets."""
    pick = picker(library)
    return lambda name, language, arithmetic: pick([name], Choice(language, arithmetic))


def files(picked: Picked, languages: Languages = OF_TREE) -> dict[str, str]:
    """The pages by their names."""
    return {"README.md": index(languages), **{f"{name}.md": page(name, picked, languages) for name in FUNCTIONS}}


def whole() -> Path:
    """The folder with the pages in each language. They take a minute, and are kept until something changes that they
    are made of."""
    sources = [*glsl_files().values(), *(ROOT / "catalog").glob("*.toml"), *modules.files_of([Path(__file__)])]
    return cached(ROOT / "build" / "snippets", sources, lambda: files(for_pages(), LANGUAGES))


def wrong(folder: Path, made: dict[str, str]) -> list[str]:
    """The pages in a folder that are not these, or should not be there."""
    found = {path.name: path.read_text(encoding="utf-8") for path in folder.glob("*.md")}
    return sorted(name for name in {*found, *made} if found.get(name) != made.get(name))


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make snippets", __doc__)
    parser.add_argument("--check", action="store_true", help="write nothing")
    parser.add_argument("--out", type=Path, default=FOLDER, metavar="DIR", help="default: docs/reference/snippets")
    given = parser.parse_args(arguments)
    try:
        made = files(for_pages())
        given.out.mkdir(parents=True, exist_ok=True)
        other = wrong(given.out, made)
        for name in () if given.check else other:
            if name in made:
                (given.out / name).write_text(made[name], encoding="utf-8")
            else:
                (given.out / name).unlink()
    except Unknown as error:
        parser.exit(1, f"tools/make snippets: {error}\n")
    except OSError as error:
        parser.exit(2, f"tools/make snippets: cannot write {error.filename}: {error.strerror}\n")
    for name in other if given.check else ():
        print(f"{name}: it is not what tools/make snippets writes", file=sys.stderr)
    return 1 if given.check and other else 0


if __name__ == "__main__":
    sys.exit(main())
