"""Compares what shaders of rows of the suite give with the golden files."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping

from base.golden_values import Golden
from catalog.tables.functions import read_functions
from translate.wgsl.device import Device
from translate.wgsl.evaluation import EPILOGUE, module_over


def shaders_over(rows: Collection[str], of: Callable[[list[str]], str]) -> dict[str, str]:
    """With HN_FIXED, a shader for each row, which has its body, and in front of that what `of` makes of the names of what it calls."""
    bodies = {function.id: function.body for function in read_functions() if function.id in rows}
    module, numbers = module_over("#define HN_ARITHMETIC HN_FIXED\n", bodies)
    found = {}
    for row, number in numbers.items():
        body = module.definition(number)
        found[row] = "\n".join([of(body.needs), *body.lines, EPILOGUE.replace("EVALUATE", number)])
    return found


def differing(device: Device, shaders: Mapping[str, str], golden: Mapping[str, str]) -> dict[str, str]:
    """Which rows, with the settings that are named, have other bits than their files, and where first."""
    found: dict[str, str] = {}
    for row, setting in golden.items():
        values = Golden(row, setting)
        results = device.evaluate(shaders[row], values.inputs)
        for inputs, expected, got in zip(values.inputs, values.expected, results, strict=True):
            if list(got[:len(expected)]) != expected:
                found.setdefault(row, f"{inputs}: got {got}, expected {expected}")
    return found
