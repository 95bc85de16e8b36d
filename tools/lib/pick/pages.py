"""docs/snippets: the functions that are asked for most, in each language, to paste. `tools/pick --pages DIR` writes
them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from tables.markdown import table

# What is asked for, and for what.
FUNCTIONS = {
    "hn_perlin2": "gradient noise on the plane", "hn_perlin3": "gradient noise in space",
    "hn_perlin_d2": "the same on the plane, with its slopes", "hn_perlin_d3": "in space, with its slopes",
    "hn_value2": "value noise on the plane: cheaper and coarser", "hn_value3": "value noise in space",
    "hn_simplex2": "gradient noise without squares, on the plane", "hn_simplex3": "the same in space",
    "hn_simplex_d2": "simplex noise on the plane, with its slopes", "hn_simplex_d3": "in space, with its slopes",
    "hn_cellular2": "distances to scattered points (Worley noise), on the plane", "hn_cellular3": "the same in space",
    "hn_cell_border2": "the distance to the border of a Voronoi cell",
    "hn_fbm2": "octaves of hn_perlin on the plane: clouds, heights", "hn_fbm3": "the same in space",
    "hn_turbulence2": "octaves of its size: marble, fire", "hn_ridged2": "octaves with ridges: mountains",
    "hn_warp2": "shifts that bend other noise", "hn_curl2": "velocities of a flow on the plane",
    "hn_random2": "a random number for each cell",
}
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
