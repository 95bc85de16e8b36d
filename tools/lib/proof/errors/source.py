"""A GLSL file of a user's behind the preprocessor, with the files that it includes, and the heads of its functions."""

from __future__ import annotations

import re
import subprocess
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from base.tree import GLSL

LEFT_OUT = re.compile(r"^([ \t]*#[ \t]*(?:version|extension|pragma)\b[^\n]*)", re.MULTILINE)
INCLUDE = re.compile(r"""^([ \t]*#[ \t]*include[ \t]*)[<"]([^">\n]+)[">]""", re.MULTILINE)
MARKER = re.compile(r'^# (\d+) "(.*?)".*$', re.MULTILINE)
HEAD = re.compile(r"(?P<type>\w+(?:\s*\[\s*\w*\s*\])*)\s+(?P<name>\w+)\s*\((?P<parameters>[^(){}]*)\)\s*$")
QUALIFIERS = {"const", "in", "out", "inout", "highp", "mediump", "lowp", "precise"}
KNOBS = {"HN_HASH": "8", "HN_GRADIENT": "1", "HN_ARITHMETIC": "1"}  # with their defaults
CUSTOM = "9"
END = "end_of_the_file"


class Bad(Exception):
    """A file that cannot be read, or a request that does not fit it."""


@dataclass
class Parameter:
    type: str
    name: str
    way: str  # "", "out" or "inout"


@dataclass
class Function:
    """A function that the file defines, or one that it includes."""
    name: str
    type: str
    parameters: list[Parameter]
    head: str
    place: str  # FILE:LINE
    span: tuple[int, int]  # in the text
    refused: str = ""  # FILE:LINE: why
    calls: set[str] = field(default_factory=set)  # names

    @property
    def id(self) -> str:
        """Macros may write several on one line."""
        return str(self.span[0])


@dataclass
class Source:
    text: str
    macros: list[str]  # the knobs that the file sets

    def place(self, at: int) -> str:
        """FILE:LINE of a character."""
        starts = [match.start() for match in LINE.finditer(self.text, 0, at)]
        marker = LINE.match(self.text, starts[-1])
        assert marker
        return f"{marker[2]}:{int(marker[1]) + self.text.count(chr(10), marker.end() + 1, at)}"

    def has(self, function: Function, place: str) -> bool:
        """Whether a place is in a function."""
        path, _, line = place.rpartition(":")
        first, last = (self.place(at).rpartition(":") for at in function.span)
        return path == first[0] and int(first[2]) <= int(line) <= int(last[2])

    def functions(self) -> Iterator[Function]:
        depth = start = brace = 0
        for match in re.finditer(r"[{};]|^#.*$", self.text, re.MULTILINE):
            if match[0][0] == "#":
                start = match.end() if depth == 0 else start
            elif match[0] == "{":
                depth, brace = depth + 1, match.start() if depth == 0 else brace
            elif match[0] == ";":
                start = match.end() if depth == 0 else start
            elif (depth := depth - 1) == 0 and (head := HEAD.search(self.text, start, brace)):
                place = self.place(head.start("name"))
                if not Path(place.rpartition(":")[0]).is_relative_to(GLSL):
                    yield Function(head["name"], re.sub(r"\s", "", head["type"]), list(parameters(head["parameters"])),
                                   " ".join(self.text[start:brace].split()), place, (start, match.end()))
                start = match.end()
        if depth > 0:
            raise Bad(f"{self.place(brace)}: a {{ has no }}")

    def without(self, functions: Iterator[Function]) -> str:
        """The text with blanks in their place."""
        text = self.text
        for one in functions:
            start, end = one.span
            text = text[:start] + re.sub(r"[^\n#]|(?<!\n)#", " ", text[start:end]) + text[end:]
        return text


LINE = re.compile(r'^#line (\d+) "(.*?)"$', re.MULTILINE)


def parameters(listed: str) -> Iterator[Parameter]:
    for number, one in enumerate(listed.split(",")):
        words = re.findall(r"\w+|\[[^]]*\]", one)
        left = [word for word in words if word not in QUALIFIERS]
        if left and left != ["void"]:
            sizes = "".join(word for word in left if word[0] == "[")
            names = [word for word in left if word[0] != "["]
            way = next((word for word in words if word in ("out", "inout")), "")
            yield Parameter(names[0] + sizes, names[1] if len(names) > 1 else f"unnamed_{number}", way)


def read(path: Path) -> Source:
    with tempfile.TemporaryDirectory() as folder:
        main = Copies(Path(folder)).copy(path)
        with main.open("a", encoding="utf-8") as file:
            file.write(f"\n{END} {' '.join(KNOBS)}\n")
        done = subprocess.run(["g++", "-E", "-x", "c", "-undef", "-nostdinc", "-D__VERSION__=460", main.name],
                              cwd=folder, capture_output=True, text=True, check=False)
    if error := re.search(r"^(\S.*?:\d+):\d+: (?:fatal )?error: (.*)", done.stderr, re.MULTILINE):
        raise Bad(f"{error[1]}: {error[2]}")
    text, _, end = done.stdout.rpartition(END)
    found = {name: value for name, value in zip(KNOBS, end.split()) if value.isdigit()}
    if found.get("HN_HASH") == CUSTOM:
        raise Bad(f"{path}: HN_HASH_CUSTOM is not taken: choose a hash of the library")
    # HN_FIXED by the name that program.py looks for.
    macros = [f"{name}={'HN_FIXED' if (name, value) == ('HN_ARITHMETIC', '3') else value}" for name, value in found.items()
              if value != KNOBS[name]]
    return Source(MARKER.sub(r'#line \1 "\2"', text), macros)


class Copies:
    """The file and those that it includes, without the lines that a preprocessor of C refuses."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.made: dict[Path, Path] = {}

    def copy(self, path: Path) -> Path:
        to = self.made[path.resolve()] = self.folder / f"{len(self.made)}.glsl"
        try:
            text = path.read_text(encoding="utf-8-sig")
        except OSError as error:
            raise Bad(f"{path}: {error.strerror}") from None
        except UnicodeDecodeError:
            raise Bad(f"{path}: the text is not UTF-8") from None
        text = INCLUDE.sub(lambda match: f'{match[1]}"{self.included(path, match[2])}"', LEFT_OUT.sub("", text))
        to.write_text(f'#line 1 "{path}"\n{text}', encoding="utf-8")
        return to

    def included(self, path: Path, name: str) -> Path | str:
        """A file of the user's, or the library's own text: a copy of the library beside the file is not read."""
        beside, of_library = path.parent / name, GLSL / re.sub(r"^(?:.*/)?hashnoise/", "", name)
        is_copy = of_library.is_file() and beside.is_file() and beside.read_text(
            encoding="utf-8", errors="replace").startswith("// hashnoise")
        if beside.is_file() and not is_copy:
            return self.made.get(beside.resolve()) or self.copy(beside)
        return of_library if of_library.is_file() else name
