"""The pieces that can be deleted, each alone and all together: the rest configures, builds and passes its tests.

    python3 -B -m base.pieces     lists the pieces, their sizes and paths, and the size of the rest without them

check.commands.pieces_test tests it. A piece registers its tests in a tests.cmake of its own and is otherwise found by its files; so
this table is all that names it. Pages that stay may link to its pages.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from base.tree import ROOT, files

CODE = re.compile(r"\.([ch]pp|[ch]|glsl|hlsl|metal|wgsl|m?js|ts|py|rs|cs|gd|sh|cmake|toml|html|css)$|/tools/[a-z]+$")
TEST = re.compile(r"(^|/)tests?/|/testing/|_test\.|^conformance/run/expect")
MEASURED = [f"docs/measured/{page}.md" for page in (
    "default-hash", "gpu-operations", "hashes", "judge", "measuring", "quality", "silicon")]
# Each with its files and folders. Two pieces may share one.
PIECES: dict[str, tuple[str, ...]] = {
    "measuring": ("tools/measure", "tools/lib/measure", "tools/lib/check/commands/measure_test.py",
                  "docs/measured/results", *MEASURED),
    "paper": ("conformance/paper", "conformance/cli/paper_command.cpp", "conformance/cli/paper_cli_test.py",
              "tools/lib/measure/paper", "tools/lib/measure/paper.sh"),
    "playground": ("playground", "tools/playground", "tools/lib/ship/playground", "docs/guide/playground.md"),
    "baker": ("tools/bake", *(f"packages/python/{name}" for name in (
        "bake.cmake", "hashnoise/__main__.py",
        *(f"hashnoise/_bake{part}.py" for part in ("", "_files", "_mask", "_values")),
        *(f"tests/{name}" for name in ("bake.txt", "bake_readers.mjs", "bake_test.py", "bluenoise_test.py", "dither.py")))),
        "docs/guide/bake.md"),
    "python": ("packages/python", "pyproject.toml", "tools/bake", "tools/lib/ship/python",
               *(f"docs/guide/{page}.md" for page in ("bake", "dask", "notebook", "python"))),
    "npm": ("packages/npm", "tools/lib/ship/npm", "docs/guide/javascript.md"),
    "godot": ("packages/godot", "tools/lib/ship/godot", "docs/guide/godot.md", "docs/images/godot.jpg"),
    "blender": ("packages/blender", "tools/lib/ship/blender"),
    "unity": ("packages/unity", "tools/lib/ship/unity"),
    **{name: (f"packages/{name}", f"tools/lib/ship/{name}") for name in ("isf", "materialx", "rust", "unreal", "wesl")},
    **{name: (f"packages/{name}",) for name in ("build-systems", "conan", "vcpkg")},
    **{name: (f"examples/{name}",) for name in ("bevy", "cuda", "dask", "raylib", "vulkan", "webgl")},
    "three": ("examples/three", "packages/npm/tests/three.mjs"),
    # Languages of tools/pick, the two last with the packages that are made of them.
    **{f"pick-{name}": (f"tools/lib/translate/pick/{name}.py",) for name in ("go", "java")},
    "pick-csharp": ("tools/lib/translate/pick/csharp.py", "packages/unity", "tools/lib/ship/unity"),
    "pick-rust": ("tools/lib/translate/pick/rust.py", "packages/rust", "tools/lib/ship/rust"),
    "pick-verilog": ("examples/silicon", "docs/measured/silicon.md",
                     *(f"tools/lib/translate/pick/{name}" for name in (
                         "circuit.py", "verilog.py", "verilog.cmake", "verilog_bench.py", "verilog_test.py"))),
}


def files_of(name: str, among: Iterable[str]) -> list[str]:
    return [file for file in among if any(file == path or file.startswith(f"{path}/") for path in PIECES[name])]


def is_deleted(name: str) -> bool:
    return not any((ROOT / path).exists() for path in PIECES[name])


def was_deleted(path: str) -> bool:
    """Whether it is gone with a piece. Links may lead there."""
    return not (ROOT / path).exists() and any(files_of(name, [path]) and is_deleted(name) for name in PIECES)


def rest() -> list[str]:
    """The files that are left without all pieces."""
    found = files()
    gone = {file for name in PIECES for file in files_of(name, found)}
    return [file for file in found if file not in gone]


def lines_of(names: Iterable[str]) -> str:
    """How many lines code has and tests have, in words."""
    counts = [0, 0]
    for name in names:
        if CODE.search(f"/{name}"):
            counts[bool(TEST.search(name))] += (ROOT / name).read_bytes().count(b"\n")
    return f"{counts[0]:,} lines of code, {counts[1]:,} of tests"


def main() -> None:
    for name in PIECES:
        print(f"{name}: {lines_of(files_of(name, files()))}\n    {' '.join(PIECES[name])}")
    print(f"without them all: {lines_of(rest())}")


if __name__ == "__main__":
    main()
