"""The text of the library that each row of docs/measured/results measured. A row names the digest of what it measured:
the definitions that its call reaches, without comments and blanks. Facts above the rows name the day, the version of
the library and what measured it.

    tools/make measured    prints the rows of another text than that here, and what measures them anew

Exit status: 0 all are of the text here, but for what needs hardware that is not here; 1 some are not; 2 a record does
not name its text, or there is no text that it could be of.
"""

from __future__ import annotations

import functools
import hashlib
import re
import subprocess
import sys
import time
from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from base.tree import GLSL, ROOT, included_from, version
from base.usage import Parser
from catalog.tables.configurations import read_configurations
from catalog.tables.functions import read_functions
from catalog.tables.glsl import files_of
from catalog.tables.markdown import table
from measure import record
from translate.parsing.preprocessor import Line, Macro, Preprocessor
from translate.parsing.tokens import Unknown
from translate.settings import settings_of

RESULTS = ROOT / "docs" / "measured" / "results"
SOURCES = ("glsl", "include", "src/grid")
TEXT = "text"  # the column
NONE = "none"  # in it: the row has nothing of the library
TEXTS = re.compile(rf"[0-9a-f]{{8}}|{NONE}|unknown")  # the last where nobody can find out what was measured
FACTS = ("date", "by", "hashnoise")
NEEDS = "needs"  # a fact: hardware that is not here
KEPT = (*FACTS, "note", "rounds", NEEDS)  # of the facts that a command knows
SHOWN = 4  # rows of a record by --check
WORDS = re.compile(r"\bhn_(?!bench)\w+|\bHN_\w+")
# Of C++ and CMake, and what each version has otherwise.
COMMENT = re.compile(r"//.*|(?s:/\*.*?\*/)|^ *# .*|^#define HN_(?:VERSION_|I_NAMESPACE).*", re.MULTILINE)
FOREIGN = re.compile(r"[^.]+|table\.\w+[23]")  # ids of subjects: other people's shaders, the empty one, tables
Row = Mapping[str, str]


# --- The text that a call reaches -------------------------------------------------------------------------------------

class Definition(NamedTuple):
    file: str
    text: str  # without comments and blanks
    words: tuple[str, ...]


class Definitions(Preprocessor):
    """Each function, struct and macro by its name, as the knobs leave them."""

    def __init__(self, library: Path, settings: dict[str, str]):
        self.texts: defaultdict[str, list[Definition]] = defaultdict(list)
        super().__init__(library, settings)
        self.read('#include "hashnoise.glsl"\n', "the library")

    def _define(self, text: str, path: str, line: int, comment: str) -> None:
        super()._define(text, path, line, comment)
        self._know(text.split("(")[0].split()[0], path, text)

    def _add(self, lines: list[Line], macros: Mapping[str, Macro]) -> None:
        code = " ".join(line.code for line in lines)
        self._know(re.split("[({]", code)[0].split()[-1], lines[0].path, code)

    def _know(self, name: str, path: str, code: str) -> None:
        self.texts[name].append(Definition(path, "".join(code.split()), tuple(WORDS.findall(code))))


@functools.lru_cache(maxsize=64)
def definitions(library: Path, configuration: str) -> Definitions:
    hash_, *more = configuration.split("+")
    arithmetic = next((word for word in more if word in ("precise", "fixed")), "fast")
    return Definitions(library, settings_of(arithmetic, hash_, "sine" if "sine" in more else "octahedral",
                                            "own_hash" if hash_ == "custom" else "").macros())


@functools.lru_cache(maxsize=None)
def included(library: Path, file: str) -> frozenset[str]:
    """A file and all that it includes, whatever the knobs."""
    names = re.findall(r'^\s*#include "(.*)"', (library / file).read_text(encoding="ascii"), re.MULTILINE)
    return frozenset({file}).union(*(included(library, included_from(file, name)) for name in names
                                     if name.endswith(".glsl")))


def digest(texts: Iterable[str]) -> str:
    return hashlib.sha256("\n".join(texts).encode()).hexdigest()[:8]


@functools.lru_cache(maxsize=None)
def reached(library: Path, configuration: str, files: tuple[str, ...], call: str) -> str:
    """The digest of what a call reaches in these files and in what they include. LookupError if it reaches nothing."""
    known = definitions(library, configuration)
    within = {"the options"}.union(*(included(library, one) for one in files))
    found: dict[str, list[Definition]] = {}
    names = calls = WORDS.findall(call)
    while names:
        new = {name: [one for one in known.texts.get(name, ()) if one.file in within] for name in {*names} - {*found}}
        found |= new
        names = [word for some in new.values() for one in some for word in one.words]
    for name in calls:
        if name.startswith("hn_") and not found[name]:
            raise LookupError(f"{', '.join(files)} has no {name}")
    if not found:
        raise LookupError(f"{call!r} calls nothing of the library")
    return digest(text for name in sorted(found) for text in sorted(one.text for one in found[name]))


def of_calls(calls: str, library: Path, configuration: str = "lattice", axes: int | str = "") -> str:
    """`hn_perlin2 hn_tile`: in the files that declare these functions for so many axes, or for any. The axes are passed
    where no name has the number. NONE if there is no name."""
    named = re.findall(r"\b(hn_\w+?)([1-4]?)\b", calls)
    axes = axes or "".join(number for _, number in named)[:1]
    files = {file for name, _ in named for file in files_of(name, library)
             if not re.search(r"[1-4]d\.glsl$", file) or file.endswith(f"{axes}d.glsl")}
    return reached(library, configuration, tuple(sorted(files)), " ".join(name for name, _ in named)) if named else NONE


def of_grid(_: Row, library: Path) -> str:
    """hashnoise::grid: each of its kernels includes all of the library."""
    return of_sources(library)


@functools.lru_cache(maxsize=None)
def of_sources(library: Path) -> str:
    files = [path for folder in SOURCES for path in sorted((library.parents[1] / folder).rglob("*.*"))
             if "tests" not in path.parts]
    return digest("".join(COMMENT.sub("", path.read_text(encoding="utf-8")).split()) for path in files)


# --- The text of a row ------------------------------------------------------------------------------------------------

@functools.cache
def subjects() -> dict[str, tuple[str, str]]:
    """The file and the call, by the name of a function of the suite."""
    own = {f"fbm.fbm{n}.own_noise": (f"fbm{n}d.glsl", "hn_octaves hn_add hn_position hn_next hn_mean") for n in (2, 3)}
    return own | {one.id: (one.includes, one.bench) for one in read_functions()}


@functools.cache
def configurations() -> dict[str, str]:
    """By the end of a subject's id."""
    return {"any": "lattice", "own_noise": "lattice"} | {one.name: one.name for one in read_configurations()}


def of_subject(row: Row, library: Path) -> str:
    """noise2d.perlin.lattice+fixed."""
    id_ = row["id"]
    if FOREIGN.fullmatch(id_):
        return NONE
    name, _, configuration = id_.rpartition(".")
    file, call = subjects()[id_ if configuration == "own_noise" else name]
    return reached(library, configurations()[configuration], (file,), call)


def of_paper(row: Row, library: Path) -> str:
    """Its algorithms with the noise of the library, as they are there and as the paper intends them."""
    hash_ = re.sub(r"Perlin/|, ours|\W|_", "", row.get("algorithm") or row["noise"]).lower()
    hashes = {one.hash.replace("_", ""): one.hash for one in read_configurations()} | {"hashnoisesdefault": "lattice"}
    if hash_ not in hashes or row.get("form") == "as published":
        return NONE
    return of_calls("hn_perlin hn_tile", library, hashes[hash_] + "+sine" * (row.get("form") == "as intended"),
                    row["dimensions"])


def of_distribution(row: Row, library: Path) -> str:
    noise, sines = re.subn("^SINE", "PERLIN", row["noise"])
    return of_calls(f"hn_{noise.lower()} hn_uniform hn_distribution hn_distribution_fbm", library,
                    "lattice" + "+sine" * sines)


def of_names(row: Row, library: Path) -> str:
    """A function that the row names; and that beside which costs are."""
    names = f"{next(iter(row.values()))} {'hn_perlin' * (row.get('measure') == 'cost')}"
    return of_calls(re.sub(r"^pcg", "hn_hash_pcg", names), library, axes=row["dimensions"])


def of_hash(row: Row, library: Path) -> str:
    """Of a choice of HN_HASH what hashes a lattice point; the controls are hashes of numpy."""
    name = row["hash"].lower()
    return of_calls("hn_gradient hn_value_vector", library, name, row["dimensions"]) if name in configurations() else NONE


def of_package(row: Row, library: Path) -> str:
    return of_grid(row, library) if row["package"] == "hashnoise" else NONE


def of_crate(row: Row, library: Path) -> str:
    """Six octaves are those of hn_fbm."""
    crate, _, arithmetic = row["package"].partition(" ")
    noise, axes = re.fullmatch(r"(.*) (\d)D", row["noise"]).groups()
    call = "hn_fbm" if "octaves" in noise else f"hn_{noise.lower()}"
    return of_calls(call, library, "lattice" + f"+{arithmetic}" * bool(arithmetic), axes) if crate == "hashnoise" else NONE


class Kind(NamedTuple):
    command: str  # of tools/measure
    digest: Callable[[Row, Path], str] | None  # None: the library has no part in it, or its values alone, which are frozen


KINDS = {"bench.csv": Kind("clock", of_subject), "peers.csv": Kind("peers", of_subject),
         "costs.csv": Kind("gpu", of_subject), "operations.csv": Kind("gpu", None), "chips.csv": Kind("gpu", None),
         "stripes.csv": Kind("gpu", None),
         "uniform.csv": Kind("uniform", of_distribution),
         **{f"{name}.csv": Kind("paper", of_paper) for name in ("table", "statistics", "period", "bandwidth")},
         "judged.csv": Kind("noise", of_names), "hashes.csv": Kind("hashes", of_names),
         "quality.csv": Kind("hashes", of_hash), "directions.csv": Kind("hashes", of_names),
         "python.csv": Kind("python", of_package), "rust.csv": Kind("rust", of_crate),
         "translators.csv": Kind("translators", None),
         **{f"{name}.csv": Kind("cpu", of_grid) for name in ("gcc", "clang")}}


# --- Records ----------------------------------------------------------------------------------------------------------

def of_library() -> str:
    """The version, and the commit that wrote its text."""
    def git(*words: str) -> str:
        done = subprocess.run(["git", "-C", ROOT, *words, "--", *SOURCES], capture_output=True, text=True, check=False)
        return done.stdout.strip()

    commit = git("log", "-1", "--format=%h")
    return version() + f" at {commit}" * bool(commit) + ", with changes" * bool(git("status", "--porcelain"))


def stamp(path: Path, by: str = "", library: Path = GLSL, kind: str = "") -> None:
    """Adds the texts of rows that were measured just now, the day, the version and what measured them, and leaves out
    what is of this machine alone. The kind is the usual name of the file, if it has another."""
    found = record.read(path)
    by = by or ", ".join(filter(None, (found.facts.get(name, "") for name in ("renderer", "OpenGL"))))
    facts = {"date": time.strftime("%Y-%m-%d", time.gmtime()), "by": by,
             "hashnoise": of_library() if library == GLSL else f"the text in {library}"} | found.facts
    of_row = KINDS[kind or path.name].digest
    rows = [row if row.get(TEXT) or not of_row else {**row, TEXT: of_row(row, library)} for row in found.rows]
    record.write(path, rows, facts={name: facts[name] for name in KEPT if facts.get(name)})


def keep(path: Path, rows: Iterable[Mapping[str, object]], by: str, facts: Mapping[str, object] | None = None,
         columns: Sequence[str] = (), kind: str = "") -> None:
    """Writes a record of what was measured just now, and prints where it is."""
    record.write(path, rows, columns, facts)
    stamp(path, by, kind=kind)
    print(path)


def read(path: Path) -> record.Record:
    """ValueError if something does not name its text."""
    of = record.read(path)
    for name in FACTS:
        if not of.facts.get(name):
            raise ValueError(f"{path}: nothing above the rows names the {name}")
    for number, row in enumerate(of.rows, 1):
        if KINDS[path.name].digest and not TEXTS.fullmatch(row.get(TEXT) or ""):
            raise ValueError(f"{path}: row {number} does not name its text")
    return of


def stale(path: Path, library: Path = GLSL) -> list[Row]:
    """The rows of another text. LookupError if there is no text that the row could be of."""
    of_row = KINDS[path.name].digest
    return [row for row in read(path).rows if of_row and row[TEXT] != of_row(row, library)]


def paths(folder: Path = RESULTS) -> list[Path]:
    """All records. ValueError for a file that is none."""
    found = sorted(path for path in folder.rglob("*.*") if path.name != "README.md")
    for path in found:
        if path.name not in KINDS:
            raise ValueError(f"{path}: no command writes a record of this name (tools/lib/measure/stamps.py)")
    return found


def changed(path: Path) -> str:
    """How many rows are of another text, in words; "" for none."""
    rows, others = len(read(path).rows), len(stale(path))
    return "all rows" if others == rows else f"{others:,} of {rows:,} rows" if others else ""


def needed(facts: Mapping[str, str]) -> str:
    return f"; it needs {facts[NEEDS]}, which is not here" if NEEDS in facts else ""


def note(name: str) -> str:
    """The sentences below the table that a page has of a record."""
    path = RESULTS / name
    facts, others = read(path).facts, changed(path)
    since = f" The text of {others} has changed since." if others else ""
    return (f"\nThis is of hashnoise {facts['hashnoise']}, on {facts['date'][:10]}, by {facts['by']}{needed(facts)}."
            f"{since}\n")


def records_table() -> str:
    def line(path: Path) -> list[str]:
        facts, name = read(path).facts, path.relative_to(RESULTS).as_posix()
        return [f"[{name}]({name})", f"`tools/measure {KINDS[path.name].command}`", facts["date"][:10],
                facts["hashnoise"], changed(path)]

    return table(("record", "command", "day", "hashnoise", "text changed since"), map(line, paths()))


def refusals() -> list[str]:
    """Records that keep a tree from being a release: rows are of another text, and the hardware is here."""
    found = {path: changed(path) for path in paths() if NEEDS not in read(path).facts}
    return [f"{path.parent.name}/{path.name}: {rows} are of another text; tools/measure {KINDS[path.name].command} "
            "measures them" for path, rows in found.items() if rows]


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make measured", __doc__)
    parser.add_argument("--check", action="store_true",
                        help=f"print {SHOWN} rows of a record, and the number of the others")
    options = parser.parse_args(arguments)
    try:
        for path in paths():
            rows = [" ".join(list(row.values())[:2]) for row in stale(path)]
            shown = rows[:SHOWN] if options.check else rows
            more = f" and {len(rows) - len(shown):,} more" * (len(shown) < len(rows))
            if rows:
                print(f"{path.parent.name}/{path.name}: {'; '.join(shown)}{more} changed")
        found = refusals()
    except (LookupError, Unknown, ValueError) as error:
        parser.exit(2, f"{parser.prog}: {error}\n")
    print(*found, sep="\n")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
