"""Makes the vectors: rows of the golden files, as JSON."""

from __future__ import annotations

import json
import struct
import subprocess
import tempfile
from collections.abc import Iterable, Sequence
from dataclasses import asdict
from fractions import Fraction
from functools import cached_property
from pathlib import Path

from base import modules
from base.cache import cached
from base.golden_values import Golden
from base.tree import CONFORMANCE, GOLDEN, ROOT, VECTORS, glsl_files
from base.twin import NotBuilt, compile_program
from catalog import suite
from catalog.tables.configurations import Configuration, read_configurations
from catalog.tables.functions import Function, read_functions
from proof.golden.files import Values
from proof.vectors.choice import chosen, features
from translate.pick.program import name_of, names

FORMAT = 1
INDEX = "index.json"
LARGEST_BOUND = 2.0**-6  # of a row. Octave sums of floats far out have larger ones, which mean little
DEFAULTS = {"lattice", "lattice+sine"}  # the settings of noise that are written out, without their arithmetic
PROGRAM = Path(__file__).with_name("tolerances.cpp")
SUMS = {"of_octahedral": (), "of_sine": ("HN_GRADIENT=HN_GRADIENT_SINE",)}  # as conformance/roundings/CMakeLists.txt
OPTIONS = ("-O0", "-Dalways_inline=unused", "-w", f"-I{CONFORMANCE}", f"-I{ROOT / 'include'}", f"-I{ROOT / 'src'}")
KINDS = {name: struct.Struct(form) for name, form in (("u32", ">I"), ("i32", ">i"), ("f32", ">f"), ("f64", ">d"))}

Words = Sequence[int]


class NoVectors(NotBuilt):
    """The program that computes bounds does not compile, or it fails."""


def meaning(kind: str, word: int) -> int | float:
    """The number that a word of a golden file stands for."""
    value, = KINDS[kind].unpack(word.to_bytes(KINDS[kind].size, "big"))
    return value


def unit_of(values: Iterable[float]) -> int:
    """The exponent of the largest power of two that divides all; 0 if they are whole."""
    return -max((Fraction(value).denominator.bit_length() - 1 for value in values), default=0)


class Group(Values):
    """A function with a setting."""

    @cached_property
    def golden(self) -> Golden:
        return Golden(self.function.id, self.name)

    @property
    def results(self) -> list[list[int | float]]:
        return [[meaning(kind, word) for (_, kind), word in zip(self.golden.head.results, words)]
                for words in self.golden.values]

    def questions(self) -> list[str]:
        """A line for each row, for the program that prints bounds."""
        if self.arithmetic in ("exact", "fixed"):
            return []
        return [f"{self.configuration.name} {self.function.id} {hexadecimal(words)}" for words in self.golden.inputs]

    def said(self, bounds: Sequence[Sequence[float]], known: dict[str, tuple[list, set]]) -> str:
        """Its part of the file. `bounds` are for all rows, or none if every bit counts; `known` keeps numbers
        and features of rows by their words, since settings have most of them alike."""
        golden, results = self.golden, self.results
        words = [hexadecimal(row) for row in golden.inputs]
        allowed = [i for i in range(len(words)) if not bounds or max(bounds[i]) <= LARGEST_BOUND]
        for i in allowed:
            if words[i] not in known:
                row = {name: meaning(kind, word) for (name, kind), word in zip(golden.head.columns, golden.inputs[i])}
                known[words[i]] = list(row.values()), features(row)
        numbers = [allowed[i] for i in chosen([known[words[i]][1] for i in allowed], [results[i] for i in allowed])]
        head: dict = {"name": self.name, "arithmetic": self.arithmetic}
        if self.function.family != "independent":
            head |= {"hash": self.configuration.hash, "gradient": self.configuration.gradient}
        rows: list[dict] = [{"in": known[words[i]][0], "words": words[i], "out": results[i]} for i in numbers]
        if bounds:
            rows = [{**row, "bound": bounds[i]} for i, row in zip(numbers, rows)]
        elif self.arithmetic == "fixed" and all(kind == "f64" for _, kind in golden.head.results):
            head["units"] = [unit_of(values) for values in zip(*results)]
            rows = [{**row, "units": [int(value * 2.0**-unit) for value, unit in zip(row["out"], head["units"])]}
                    for row in rows]
        return written(head, "rows", map(compact, rows), " ")


def hexadecimal(words: Words) -> str:
    return " ".join(f"{word:08x}" for word in words)


def groups_of(function: Function, settings: Sequence[Configuration]) -> list[Group]:
    """Words and gradients have values of every hash, noise has only the default's: above the words it is the same."""
    with_values = [one for one in settings if one.has_golden_values and one.covers(function) and one.hash != "custom"]
    if function.family in ("hash", "gradient"):
        return [Group(function, one) for one in with_values]
    return [Group(function, one) for one in with_values if one.name.removesuffix("+fixed") in DEFAULTS]


def asked(questions: Sequence[str]) -> list[list[float]]:
    """The bounds of rows, which the suite's own code computes."""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / PROGRAM.stem
        suite.write(Path(folder))  # the functions and the settings
        sums = [f"{folder}/{name}.o" for name in SUMS]
        try:
            for object_, (name, macros) in zip(sums, SUMS.items()):
                compile_program("the roundings of sums", CONFORMANCE / "roundings/sums.cpp", Path(object_), "-c", *OPTIONS,
                                "-frounding-math", include=Path(folder), macros=(f"HN_ROUNDINGS={name}", *macros))
            compile_program("the program that computes bounds", PROGRAM, program, *sums, *OPTIONS, "-lfmt",
                            include=Path(folder))
        except NotBuilt as error:
            raise NoVectors(f"{error}\nIt wants g++ and the library fmt: apt-get install g++ libfmt-dev") from error
        done = subprocess.run([program], input="".join(f"{line}\n" for line in questions), capture_output=True,
                              text=True, check=False)
    answers = [[float(bound) for bound in line.split()] for line in done.stdout.splitlines()]
    if done.returncode or len(answers) != len(questions):
        raise NoVectors(f"{PROGRAM.name} ended with status {done.returncode}, and answered {len(answers)} of "
                        f"{len(questions)} questions: {done.stderr}")
    return answers


def vectors() -> dict[str, str]:
    """All files, by their names."""
    settings, known = read_configurations(), names()
    of_functions = {function: groups_of(function, settings) for function in read_functions()}
    questions = {id(group): group.questions() for groups in of_functions.values() for group in groups}
    answers = iter(asked([line for lines in questions.values() for line in lines]))
    bounds = {number: [next(answers) for _ in lines] for number, lines in questions.items()}
    files, listed, bits = {}, [], ""
    for function, groups in of_functions.items():
        name, bits = name_of(function, known), groups[0].golden.head.bits
        listed.append({"file": f"{function.id}.json", "calls": function.calls, "name": name,
                       "settings": [group.name for group in groups]})
        head = {"format": FORMAT, "function": function.id, "calls": function.calls, "name": name, "bits": bits,
                "inputs": [*map(asdict, function.inputs)], "outputs": [*map(asdict, function.outputs)]}
        of_words: dict[str, tuple[list, set]] = {}
        said = [group.said(bounds[id(group)], of_words) for group in groups]
        files[f"{function.id}.json"] = written(head, "settings", said) + "\n"
    files[INDEX] = written({"format": FORMAT, "bits": bits}, "files", map(compact, listed)) + "\n"
    return files


def sources() -> list[Path]:
    """All that the files are made of: golden files, the suite's bounds, the names of functions, and this code."""
    units = [path for room in ("library", "expected", "sums") for path in (CONFORMANCE / room).glob("*.*")
             if "_test." not in path.name]
    return [PROGRAM, *GOLDEN.glob("*.golden"), *units, *(ROOT / "catalog").glob("*.toml"), *glsl_files().values(),
            *modules.files_of([Path(__file__)])]


def vectors_folder() -> Path:
    """The folder with the files, which are made if they are not there, or if their sources have changed. The
    source of a release has them at its top."""
    there = ROOT / "vectors"
    return there if there.is_dir() else cached(VECTORS, sources(), vectors)


def compact(part: object) -> str:
    return json.dumps(part, ensure_ascii=True, allow_nan=False, separators=(",", ":"))


def written(head: dict, name: str, items: Iterable[str], indent: str = "") -> str:
    """JSON that a person can read and that a change shows up in line by line: the head, then a list of that name with an
    item on each line."""
    lines = ",\n".join(f"{indent} {item}" for item in items)
    return f"{compact(head)[:-1]},{compact(name)}:[\n{lines}\n{indent}]}}"
