"""Reads a GLSL file of a user's: its tokens behind the preprocessor, with the files that it includes from beside it. The
library's files are left out, but for its macros."""

from __future__ import annotations

import re
import subprocess
import tempfile
from pathlib import Path
from typing import NamedTuple

from base.tree import GLSL
from translate.parsing.tokens import NUMBER, SIGN, WORD

TOKEN = re.compile(rf"(?P<blank>\s+)|(?P<number>{NUMBER})|(?P<word>{WORD})|(?P<sign>\^\^|{SIGN}|.)")
LEFT_OUT = re.compile(r"^([ \t]*#[ \t]*(?:version|extension|pragma)\b[^\n]*)", re.MULTILINE)
INCLUDE = re.compile(r"""^([ \t]*#[ \t]*include[ \t]*)[<"]([^">\n]+)[">]""", re.MULTILINE)
MARKER = re.compile(r'# (\d+) "(.*?)"')
KNOBS = {"HN_HASH": "8", "HN_GRADIENT": "1", "HN_ARITHMETIC": "1"}  # with their defaults
CUSTOM = "9"
END = "end_of_the_file"


class Bad(Exception):
    """A file that cannot be read, or a request that does not fit it."""


class Token(NamedTuple):
    kind: str  # number, word, sign
    text: str
    path: str
    line: int

    @property
    def place(self) -> str:
        return f"{self.path}:{self.line}"


class Source(NamedTuple):
    tokens: list[Token]
    macros: list[str]  # the knobs that the file sets, as macros


def read(path: Path) -> Source:
    with tempfile.TemporaryDirectory() as folder:
        main = Copies(Path(folder)).copy(path)
        with main.open("a", encoding="utf-8") as file:
            file.write(f"\n{END} {' '.join(KNOBS)}\n")
        done = subprocess.run(["g++", "-E", "-x", "c", "-undef", "-nostdinc", "-D__VERSION__=460", main.name],
                              cwd=folder, capture_output=True, text=True, check=False)
    if error := re.search(r"^(\S.*?:\d+):\d+: (?:fatal )?error: (.*)", done.stderr, re.MULTILINE):
        raise Bad(f"{error[1]}: {error[2]}")
    tokens = tokens_of(done.stdout)
    end = max(i for i, token in enumerate(tokens) if token.text == END)
    found = {name: token.text for name, token in zip(KNOBS, tokens[end + 1:]) if token.kind == "number"}
    if found.get("HN_HASH") == CUSTOM:
        raise Bad(f"{path}: HN_HASH_CUSTOM is not taken: choose a hash of the library")
    # HN_FIXED by the name that program.py looks for.
    macros = [f"{name}={'HN_FIXED' if (name, value) == ('HN_ARITHMETIC', '3') else value}" for name, value in found.items()
              if value != KNOBS[name]]
    return Source(tokens[:end], macros)


class Copies:
    """The file and those that it includes, without the lines that a preprocessor of C refuses."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.made: dict[Path, Path] = {}

    def copy(self, path: Path) -> Path:
        to = self.made[path.resolve()] = self.folder / f"{len(self.made)}.glsl"
        try:
            text = path.read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            raise Bad(f"{path}: {error.strerror if isinstance(error, OSError) else error}") from None
        text = INCLUDE.sub(lambda match: f'{match[1]}"{self.included(path, match[2])}"', LEFT_OUT.sub("", text))
        to.write_text(f'#line 1 "{path}"\n{text}', encoding="utf-8")
        return to

    def included(self, path: Path, name: str) -> Path | str:
        beside = path.parent / name
        of_library = GLSL / re.sub(r"^(?:.*/)?hashnoise/", "", name)
        if beside.is_file() and not beside.read_text(encoding="utf-8", errors="replace").startswith("// hashnoise"):
            return self.made.get(beside.resolve()) or self.copy(beside)
        return GLSL / "config.glsl" if beside.is_file() or of_library.is_file() else name


def tokens_of(text: str) -> list[Token]:
    found, path, line = [], "", 0
    for row in text.splitlines():
        if marker := MARKER.match(row):
            path, line = marker[2], int(marker[1])
            continue
        found += [Token(match.lastgroup or "", match[0], path, line) for match in TOKEN.finditer(row)
                  if match.lastgroup != "blank"]
        line += 1
    return found
