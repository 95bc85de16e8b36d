"""Checks of what hn-conform paper writes: each returns a list of faults, empty if there are none."""

import array
import csv
import itertools
import math
import pathlib
import sys

FORMS = ("as published", "as intended", "ours")


def read(path):
    """The facts of a record, and its rows."""
    lines = path.read_text(encoding="utf-8").splitlines(keepends=True)
    facts = dict(line[2:].rstrip("\n").split(": ", 1) for line in itertools.takewhile(lambda x: x.startswith("# "), lines))
    return facts, list(csv.DictReader(lines[len(facts):]))


ROOT = pathlib.Path(__file__).resolve().parents[2]
# The instructions of the paper's table.
PRINTED = {(row["algorithm"], row["dimensions"]): int(row["instructions"])
           for row in read(ROOT / "conformance/paper/printed.csv")[1]}


# --- Instructions ---

def order_faults(rows):
    """The algorithms have as many instructions, one after the other, as in the paper; in the listings by as much."""
    faults = []
    for dimensions, form in itertools.product("23", FORMS):
        found = [row for row in rows if row["dimensions"] == dimensions and row["form"] in (form, "tables in textures")
                 and (row["algorithm"], dimensions) in PRINTED]
        in_paper = sorted(found, key=lambda row: PRINTED[row["algorithm"], dimensions])
        if len(found) != 7:
            faults.append(f"{form}, {dimensions}D: {len(found)} algorithms instead of 7")
        counts = [int(row["spirv"]) for row in in_paper]
        if counts != sorted(counts):
            faults.append(f"{form}, {dimensions}D: {counts} is not the paper's order")
        # An evaluation of a listing is an instruction for each of its operations, here as in the paper: none is saved.
        # The rest of the shader differs, by the same number for all of them.
        apart = {int(row["spirv"]) - PRINTED[row["algorithm"], dimensions] for row in found if row["form"] == form}
        if form == "as published" and len(apart) != 1:
            faults.append(f"{form}, {dimensions}D: further apart from the paper than each other by {sorted(apart)}")
    return faults


# --- The noise of tables, from the formulas: golden files have the noise of each hash ---

def permutation():
    """SplitMix64 from a state made of the word "permutation"; Fisher and Yates."""
    state = 0
    for character in b"permutation":
        state = (state ^ character) * 0x100000001B3 % (1 << 64)
    numbers = list(range(256))
    for i in range(255, 0, -1):
        state = (state + 0x9E3779B97F4A7C15) % (1 << 64)
        z = state
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9 % (1 << 64)
        z = (z ^ z >> 27) * 0x94D049BB133111EB % (1 << 64)
        j = (z ^ z >> 31) >> 32
        j = j * (i + 1) >> 32
        numbers[i], numbers[j] = numbers[j], numbers[i]
    return numbers


PERMUTATION = permutation()
TABLE_2D = [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, 1), (1, -1), (-1, -1)]
TABLE_3D = [(1, 1, 0), (-1, 1, 0), (1, -1, 0), (-1, -1, 0), (1, 0, 1), (-1, 0, 1), (1, 0, -1), (-1, 0, -1),
            (0, 1, 1), (0, -1, 1), (0, 1, -1), (0, -1, -1), (1, 1, 0), (-1, 1, 0), (0, -1, 1), (0, -1, -1)]


def table_gradient(cell):
    index = 0
    for coordinate in cell:
        index = PERMUTATION[index + coordinate & 255]
    return TABLE_2D[index & 7] if len(cell) == 2 else TABLE_3D[index & 15]


def perlin(position):
    value = 0.0
    cell = [math.floor(x) for x in position]
    fraction = [x - c for x, c in zip(position, cell)]
    weight = [6 * t ** 5 - 15 * t ** 4 + 10 * t ** 3 for t in fraction]
    for corner in itertools.product((0, 1), repeat=len(position)):
        ramp = sum(g * (f - o) for g, f, o in
                   zip(table_gradient([c + o for c, o in zip(cell, corner)]), fraction, corner))
        value += ramp * math.prod(w if o else 1 - w for w, o in zip(weight, corner))
    return value


def position_of(index, dimensions):
    """Where the values are, by the facts of values.csv."""
    if dimensions == 2:
        j, i = divmod(index, 1024)
        return [n * (2 + 341 / 1024) + 1 / 2048 for n in (i, j)]
    rest, i = divmod(index, 128)
    k, j = divmod(rest, 128)
    return [i * (2 + 41 / 128) + 1 / 256, j * (2 + 41 / 128) + 1 / 256, k * (2 + 41 / 64) + 1 / 128]


def noise_differences(file, data, points=400):
    """How far the values of some points are from those calculated here."""
    dimensions = int(file.split("/")[-1].split(".")[2][0])
    values = array.array("f", data)
    if sys.byteorder == "big":
        values.byteswap()
    indices = [number * 611953 % (1 << 20) for number in range(points)]
    return [abs(values[i] - perlin(position_of(i, dimensions))) for i in indices]
