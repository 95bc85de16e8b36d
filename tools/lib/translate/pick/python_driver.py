"""Calls functions of texts in Python with arrays of words: the program of runners.PythonRunner.

    python_driver.py NAMESPACE FOLDER      NAMESPACE is numpy, jax, jax.jit, torch or torch.compile

It reads cases.json and inputs in the folder, and writes outputs.
"""

from __future__ import annotations

import importlib.util
import json
import sys
from pathlib import Path

import numpy

TYPES = {"float": numpy.float32, "int": numpy.int32, "uint": numpy.int32}


class Space:
    """A namespace of arrays, and how functions are called in it."""

    def __init__(self, name: str):
        self.name, _, self.way = name.partition(".")
        self.module = importlib.import_module({"jax": "jax.numpy"}.get(self.name, self.name))
        self.whole = importlib.import_module(self.name)

    def array(self, words: numpy.ndarray):
        return self.module.asarray(words)

    def call(self, function, values: list, static: list[int]):
        if not self.way:
            return function(*values)
        arrays = [one for i, one in enumerate(values) if i not in static]

        def called(*given):
            left = iter(given)
            return function(*(one if i in static else next(left) for i, one in enumerate(values)))
        return getattr(self.whole, self.way)(called)(*arrays)


def leaves(value) -> list:
    return [leaf for one in value for leaf in leaves(one)] if isinstance(value, tuple) else [value]


def mapped(function, value):
    if not isinstance(value, tuple):
        return function(value)
    parts = [mapped(function, one) for one in value]
    return type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)


def results(space: Space, module, case: dict, words: numpy.ndarray) -> numpy.ndarray:
    """The words that a function returns: a row for each point."""
    columns = iter(words.T)

    def made(of):
        if isinstance(of, str):
            column = next(columns)
            return column != 0 if of == "bool" else numpy.ascontiguousarray(column).view(TYPES[of])
        return getattr(module, of[0])(*map(made, of[1]))

    values = [made(of) for of in case["takes"]]
    static = case["static"]
    function = getattr(module, case["name"])
    # Each combination of Python's own numbers is a call. All have arrays of one shape: JAX compiles for a shape.
    keys, which = numpy.unique([values[i] for i in static], axis=1, return_inverse=True) if static else (
        numpy.zeros((0, 1), int), numpy.zeros(len(words), int))
    arrays = [one if i in static else mapped(space.array, one) for i, one in enumerate(values)]
    back = numpy.zeros((len(words), case["gives"]), numpy.int32)
    for number, key in enumerate(keys.T):
        for i, value in zip(static, key):
            arrays[i] = int(value)
        found = leaves(space.call(function, arrays, static))
        if len(found) != case["gives"]:
            raise ValueError(f"{case['name']} gives {len(found)} values in place of {case['gives']}")
        rows = which.reshape(-1) == number
        for at, one in enumerate(found):
            if isinstance(one, (bool, int, float)):
                one = numpy.asarray(one, numpy.float32 if isinstance(one, float) else numpy.int32)
            one = numpy.asarray(one)
            one = one.astype(numpy.int32) if one.dtype == bool else one
            if one.dtype not in TYPES.values():
                raise TypeError(f"{case['name']} gives {one.dtype}")
            back[rows, at] = numpy.broadcast_to(one.view(numpy.int32), len(words))[rows]
    return back


def main(name: str, folder: Path) -> None:
    space, cases = Space(name), json.loads((folder / "cases.json").read_text(encoding="ascii"))
    modules = {}
    for file in {case["file"] for case in cases}:
        spec = importlib.util.spec_from_file_location(Path(file).stem, folder / file)
        modules[file] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(modules[file])
    inputs, at = numpy.fromfile(folder / "inputs", numpy.int32), 0
    with open(folder / "outputs", "wb") as outputs:
        for case in cases:
            end = at + case["points"] * case["words"]
            words = inputs[at:end].reshape(case["points"], case["words"])
            outputs.write(results(space, modules[case["file"]], case, words).tobytes())
            at = end


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
