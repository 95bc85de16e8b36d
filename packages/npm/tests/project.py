"""A project of Vite with the package in it, as a user makes one: the folder `npm` of that of the JavaScript packages.

    project.py FOLDER      makes FOLDER/npm, in which tools/lib/base/javascript/environment.py then runs programs

The package is what tools/pack npm makes, installed by npm. The code blocks of docs/guide/javascript.md become modules
of the project: blocks/NAME.js as they are printed, and faulty/NAME.js with a mistake that a test has to notice. picked/
has what tools/pick writes, and the page of that document which needs no build step: page.html and wrong.html. Exit
status: 0 made, 1 it could not be made, 77 npm's packages or the compiler are not here.
"""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
PAGE = ROOT / "docs" / "guide" / "javascript.md"
SKIPPED = 77

# The code blocks of the page in their order, by names, and a mistake in each.
BLOCKS = {
    "heights.js": ("octaves: 6", "octaves: 5"),
    "world.js": ("1e9, -1e9], [0.5", "1e9, 1e9], [0.5"),
    "points.js": ("xy: [[0.5, 0.25]", "xy: [[0.5, 0.5]"),
    "land.js": ("position.xz * 0.0625, 6", "position.xz * 0.0625, 5"),
    "string.js": ("6, 2.0", "5, 2.0"),
    "chunks.js": ("6, 2.0", "5, 2.0"),
    "included.glsl": ("6, 2.0", "5, 2.0"),
    "nodes.js": ("6, 2", "5, 2"),
    "wgsl.js": ("6, 2.0", "5, 2.0"),
}


def blocks() -> dict[str, str]:
    page = PAGE.read_text(encoding="utf-8")
    found = re.findall(r"^```(js|glsl)\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    endings = [name.split(".")[1] for name in BLOCKS]
    if [language for language, _ in found] != endings:
        raise ValueError(f"docs/guide/javascript.md has other blocks than {list(BLOCKS)}")
    return {name: code for name, (_, code) in zip(BLOCKS, found)}


def block_of(name: str) -> str:
    """The code block of another page that is JavaScript."""
    page = (ROOT / "docs" / "guide" / name).read_text(encoding="utf-8")
    code, = re.findall(r"^```js\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    return code


def picked() -> dict[str, str]:
    """The page without a build step and another with a mistake, where three.js comes from this disk; and its modules."""
    page = PAGE.read_text(encoding="utf-8")
    html, = re.findall(r"^```html\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    command, = re.findall(r"^    hashnoise/(tools/pick .*) --out noise\.js$", page, re.MULTILINE)
    html, replaced = re.subn(r"https://cdn\.jsdelivr\.net/npm/three@[\d.]+/", "/node_modules/three/", html)
    if replaced != 2 or html.count("6, 2") != 1:
        raise ValueError(f"docs/guide/javascript.md takes three.js from {replaced} addresses, and a page from two")
    modules = {"noise.js": command, "fixed.js": "tools/pick hn_fbm2 hn_perlin2_place hn_tile2 --language tsl --arithmetic fixed"}
    return {"page.html": html, "wrong.html": html.replace("6, 2", "5, 2"),
            **{name: subprocess.run([ROOT / words.split()[0], *words.split()[1:]], capture_output=True, text=True,
                                    check=True).stdout for name, words in modules.items()}}


def missing(packages: Path) -> str:
    """A project needs something that is not here."""
    if not (packages / "made").exists():
        return f"the packages in {packages}: javascript.packages was skipped, or did not run"
    if not shutil.which("clang++"):
        return "clang++"
    if not (shutil.which("wasm-ld") or list(Path("/usr/bin").glob("wasm-ld-*"))):
        return "wasm-ld, of Debian's package lld"
    if not Path("/usr/include/wasm32-wasi").is_dir():
        return "Debian's packages libc++-dev-wasm32 and wasi-libc"
    return ""


def make(packages: Path) -> int:
    project = packages / "npm"
    shutil.rmtree(project, ignore_errors=True)
    if absent := missing(packages):
        print(f"there is no project, since this is missing: {absent}")
        return SKIPPED
    done = subprocess.run([ROOT / "tools" / "pack", "npm", packages], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        print(done.stdout + done.stderr)
        return 1
    packed = done.stdout.strip()
    shutil.copytree(HERE, project, ignore=shutil.ignore_patterns("*.py", "__pycache__"))
    shutil.copy(ROOT / "tools" / "lib" / "base" / "golden_values.mjs", project)
    shutil.copy(PAGE, project / "page.md")
    (project / "package.json").write_text(json.dumps({"name": "game", "private": True, "type": "module"}))
    for name, code in blocks().items():
        right, wrong = BLOCKS[name]
        if code.count(right) != 1:
            raise ValueError(f"{right} does not stand in the block {name} once")
        for folder, text in (("blocks", code), ("faulty", code.replace(right, wrong))):
            (project / folder).mkdir(exist_ok=True)
            (project / folder / name).write_text(text, encoding="utf-8")
    for name in ("moving", "random"):
        (project / "blocks" / f"{name}.js").write_text(block_of(f"{name}.md"), encoding="utf-8")
    for name, text in picked().items():
        (project / "picked" / name).write_text(text, encoding="utf-8")
    done = subprocess.run([ROOT / "tools" / "lib" / "base" / "node", "npm", "install", "--offline", "--no-audit", "--no-fund", packed],
                          cwd=project, capture_output=True, text=True, check=False)
    print(done.stdout + done.stderr)
    if done.returncode == 0:
        (project / "made").touch()
    return done.returncode and 1


if __name__ == "__main__":
    sys.exit(make(Path(sys.argv[1]).resolve()))
