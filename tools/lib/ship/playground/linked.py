"""Links of the playground in a terminal: as a text, and as a call of tools/bake. The page's own modules write both.

    tools/pick '#sum=ridged&seed=42' --language rust [--out FILE]      the text that the page copies
    tools/pick LINK --language glsl --as shadertoy                     as the page's *Copy as*: shader, desktop, shadertoy
    tools/bake LINK -o land.exr [OPTION]...                            the file that the page's command makes

LINK is what the button *Link* copies, with the address of a page or without. Exit status: 0 done, 2 a link with something
that the page does not know, or that the command does not have; 4 there is no Node.js.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from base.tree import ROOT, TOOLS, version
from base.usage import Parser
from ship.playground import picks
from translate.library_file import write

FLOATS = ("exr", "f32", "ktx2-float")  # formats without a range


class Unfit(Exception):
    """A status of the program that writes texts, which has printed why."""


def text(link: str, language: str, kind: str = "function") -> str:
    pieces = picks.kept(lambda step: print(step, file=sys.stderr)) / "pieces" if language != "arguments" else ""
    command = [TOOLS / "lib" / "base" / "node", "node", ROOT / "playground" / "text.mjs", pieces, version(), language, kind,
               link[link.index("#"):]]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        raise Unfit(done.returncode)
    return done.stdout


def pick(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/pick LINK", __doc__)
    parser.add_argument("link", metavar="LINK")
    parser.add_argument("--language", default="glsl", help="as the page names it in its links: glsl (the default), rust, tsl ...")
    parser.add_argument("--as", dest="kind", default="function", metavar="KIND", help="function (the default), or a whole shader")
    parser.add_argument("--arithmetic", choices=("fast", "fixed"), help="in place of that of the link")
    parser.add_argument("--out", type=Path, metavar="FILE", help="the file to write (default: standard output)")
    given = parser.parse_args(arguments)
    page, link = given.link.split("#", 1)
    parts = [part for part in link.split("&") if part and not (given.arithmetic and part.startswith("arithmetic="))]
    if given.arithmetic:
        parts.append(f"arithmetic={given.arithmetic}")
    try:
        write(parser, text(f"{page}#{'&'.join(parts)}", given.language, given.kind), given.out)
    except Unfit as unfit:
        return unfit.args[0]
    return 0


def values_of(options: Sequence[str], *names: str) -> list[str]:
    return [word.partition("=")[2] or after for word, after in zip(options, [*options[1:], ""]) if word.partition("=")[0] in names]


def words_of_bake(link: str, options: Sequence[str]) -> tuple[list[str], str]:
    """The arguments of tools/bake, where later ones count, and its file of Python. Two numbers of --size become the
    link's size, so that the picture is the page's."""
    if match := re.fullmatch(r"(\d{1,4})x(\d{1,4})", "".join(values_of(options, "--size")[-1:])):
        kept = [part for part in link.split("#", 1)[1].split("&") if part and not part.startswith(("width=", "height="))]
        link = "#" + "&".join([*kept, f"width={match[1]}", f"height={match[2]}"])
    made = json.loads(text(link, "arguments"))
    command = made["commands"][0]
    named = values_of(options, "-o", "--out", "--format")
    has_range = any(word.partition("=")[0] in ("--range", "--normalize") for word in options)
    floats = any(name == form or name.endswith(f".{form}") for name in named for form in FLOATS)
    return [*command["words"], *[f"--range={command['range']}"] * (not has_range and not floats), *options], "\n".join(made["source"])


def bake(arguments: Sequence[str]) -> int:
    """Becomes tools/bake, which reads the file of Python from a pipe: there is room for it, since it is short."""
    try:
        words, source = words_of_bake(arguments[0], arguments[1:])
    except Unfit as unfit:
        return unfit.args[0]
    if source:
        reads, writes = os.pipe()
        os.write(writes, source.encode())
        os.close(writes)
        os.set_inheritable(reads, True)
        words[words.index("pattern.py")] = f"/dev/fd/{reads}"
    os.execv(TOOLS / "bake", ["bake", *words])
    return 0


if __name__ == "__main__":
    sys.exit(bake(sys.argv[1:]))
