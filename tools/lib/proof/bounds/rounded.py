"""The text of the library in 32-bit floats, with any rounding, in doubles, or in integers, for the tests of the bounds:
a function is named by its row in the suite's table, and by the columns of that.

The text in doubles stands for the exact noise, so that a test of a bound needs no noise of its own. Golden files
compare the text with the contract."""

from __future__ import annotations

import ctypes
import fcntl
import functools
import hashlib
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path

import numpy as np

from base.tree import GLSL, ROOT
from base.twin import compile_program
from catalog.tables.functions import Column, read_functions

SOURCE = Path(__file__).with_suffix(".cpp")
FOLDER = ROOT / "build" / "texts"
MODES = ("nearest", "down", "up", "random")
DOUBLES = "doubles"  # the mode in which nothing rounds
# Macros. With FIXED only inputs and outputs round.
FIXED, SINES = "HN_ARITHMETIC=HN_FIXED", "HN_GRADIENT=HN_GRADIENT_SINE"


def made(name: str, texts: Iterable[str], sources: Iterable[Path], make: Callable[[Path], None]) -> Path:
    """The file of that name in a folder of these texts and sources, and of the library. If it is not there, `make`
    makes it in the folder, as "new"; other processes that want the same wait for that."""
    digest = hashlib.sha256("\n".join(texts).encode())
    for path in sorted([*sources, *GLSL.rglob("*.glsl"), *(ROOT / "include").rglob("*.h*")]):
        digest.update(path.read_bytes())
    folder = FOLDER / digest.hexdigest()[:16]
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / "lock", "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # until it is closed
        if not (folder / name).exists():
            make(folder)
            (folder / "new").rename(folder / name)
    return folder / name


@dataclass(frozen=True)
class Rounding:
    """"random" chooses for each operation; a*b + c is rounded once in so many of all cases."""
    mode: str
    seed: int = 0
    fuse: float = 0.0


NEAREST, EXACT = Rounding("nearest"), Rounding(DOUBLES)


def roundings(seed: int) -> list[Rounding]:
    return [Rounding(mode, 16 * seed + i, fuse) for i, mode in enumerate(MODES) for fuse in (0.0, 0.5)]


@dataclass(frozen=True)
class Body:
    """The description of a function in a row of the table."""
    inputs: tuple[Column, ...]
    outputs: tuple[Column, ...]
    code: str

    @staticmethod
    def of(inputs: str, outputs: str, code: str) -> Body:
        """With columns as text: "x:f32 y:f32"."""
        return Body(Column.listed(inputs), Column.listed(outputs), code)


# C++ makes a float of 0.1f before a number of the text can take it; a Literal of rounded.cpp keeps the decimals.
LITERAL = re.compile(r"(?<![\w.])(\d+\.\d*(?:[eE][-+]?\d+)?)f\b")


def with_literals(text: str) -> str:
    return LITERAL.sub(r"\1_f", text)


# Decimals of the text, and the numbers that they stand for: 2 pi, 2 / sqrt(3), and the coefficients of the sine, which
# are the nearest floats (docs/reference/contract.md, section 8).
TRUE_NUMBERS = {"6.2831853f": "6.28318530717958647693f", "1.15470054f": "1.15470053837925152902f"} | {
    f"{x}f": f"{Decimal(float(np.float32(x)))}f" for x in ("1.57079090", "0.64589171", "0.07943160", "0.00433127")}


def with_true_numbers(text: str) -> str:
    """With another function in place of the polynomial of the sine, too."""
    for old, new in TRUE_NUMBERS.items():
        text = text.replace(old, new)
    return text.replace("hn_float hn_i_quarter_sine(", "hn_float hn_i_polynomial_sine(")


def write_literal_text(folder: Path, change: Callable[[str], str] = with_true_numbers) -> None:
    """The library with such literals, for who includes its files from there; `change` takes each file."""
    for path in GLSL.rglob("*.*"):
        to = folder / path.relative_to(GLSL)
        to.parent.mkdir(parents=True, exist_ok=True)
        to.write_text(with_literals(change(path.read_text(encoding="utf-8"))), encoding="utf-8")


class Text:
    """Some functions of the library, by their rows or with bodies of their own, compiled with these macros; optimized,
    if they are called so often that this saves more time than it takes. Rows of the table are compiled together, once
    for all that have the same macros: but for the sine gradient, which few have."""

    def __init__(self, wanted: Iterable[str], *macros: str, optimized: bool = False,
                 change: Callable[[str], str] = with_true_numbers, **others: Body):
        whole = not others and change is with_true_numbers and SINES not in macros
        self.bodies = dict(table()) if whole else {id: table()[id] for id in wanted} | others
        bodies = "".join(f"FUNCTION({body.code})\n" for body in self.bodies.values())
        # As the suite's twin: the functions need not be inlined, which takes long. Each text has its own variables.
        options = ("-O1" if optimized or whole else "-O0", "-w", "-shared", "-fPIC", "-fno-gnu-unique")

        def make(folder: Path) -> None:
            (folder / "rounded.inc").write_text(bodies, encoding="utf-8")
            write_literal_text(folder, change)
            compile_program("the text over floats that round", SOURCE, folder / "new", *options, f"-I{folder}",
                            macros=("always_inline=unused", *macros))

        changed = (change(path.read_text(encoding="utf-8")) for path in sorted(GLSL.rglob("*.glsl")))
        self.library = ctypes.CDLL(str(made("rounded.so", [*options, *macros, bodies, *changed], [
            SOURCE, Path(__file__)], make)))

    def __call__(self, id: str, rounding: Rounding, **columns: np.ndarray | float) -> list[np.ndarray]:
        """The results of a function: the floats of each output, at each point."""
        found = self.words(id, rounding, **columns)
        return found if rounding == EXACT else [words.view(np.float32).astype(float) for words in found]

    def words(self, id: str, rounding: Rounding, **columns: np.ndarray | float) -> list[np.ndarray]:
        """Where nothing rounds, not even the columns, a double for each float."""
        function = self.bodies[id]
        words, doubles = packed(id, function.inputs, columns, rounding == EXACT)
        out, exactly = np.zeros((len(words), 4), np.uint32), np.zeros((len(words), 4))
        self.library.evaluate(list(self.bodies).index(id), (*MODES, DOUBLES).index(rounding.mode),
                              ctypes.c_uint32(rounding.seed), ctypes.c_double(rounding.fuse), len(words),
                              *(array.ctypes.data_as(ctypes.c_void_p) for array in (words, doubles, out, exactly)))
        return [np.ascontiguousarray((exactly if rounding == EXACT and of.type[0] == "f" else out)[:, i])
                for i, of in enumerate(function.outputs)]


@functools.cache
def table() -> dict[str, Body]:
    return {function.id: Body(function.inputs, function.outputs, function.body)
            for function in read_functions()}


def along_axes(prefix: str, columns: Iterable[np.ndarray]) -> dict[str, np.ndarray]:
    """The inputs of a position ("") or a cell ("c") and so on, by their names."""
    return {f"{prefix}{axis}": column for axis, column in zip("xyzw", columns)}


def packed(id: str, inputs: tuple[Column, ...], columns: dict[str, np.ndarray | float],
           exactly: bool) -> tuple[np.ndarray, np.ndarray]:
    """The 16 words of each point; and as many doubles. The word of a float is then the index of its double."""
    count = max(np.size(column) for column in columns.values())
    words, doubles = np.zeros((count, 16), np.uint32), np.zeros((count, 16) if exactly else 0)
    if {of.name for of in inputs} != columns.keys():
        raise ValueError(f"{id} takes {' '.join(map(str, inputs))}, and not {', '.join(columns)}")
    for number, of in enumerate(inputs):
        column = np.broadcast_to(columns[of.name], count)
        if of.type != "f32":
            words[:, number] = (column.astype(np.int64) & 0xFFFFFFFF).astype(np.uint32)
        elif exactly:
            words[:, number], doubles[:, number] = number, column
        else:
            words[:, number] = column.astype(np.float32).view(np.uint32)
    return words, doubles
