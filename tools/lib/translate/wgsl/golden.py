"""Compares what shaders of rows of the suite give with the golden files. The page that hn-conform writes for browsers
states how much floats may differ."""

from __future__ import annotations

import base64
import gzip
import json
import re
import struct
import subprocess
import tempfile
from collections.abc import Callable, Collection, Mapping
from pathlib import Path

from base.golden_values import Golden
from catalog.tables.functions import read_functions
from translate.wgsl.device import Device
from translate.wgsl.evaluation import EPILOGUE, module_over


def shaders_over(rows: Collection[str], arithmetic: str, of: Callable[[list[str]], str]) -> dict[str, str]:
    """A shader for each row, which has its body, and in front of that what `of` makes of the names of what it calls."""
    bodies = {function.id: function.body for function in read_functions() if function.id in rows}
    module, numbers = module_over(f"#define HN_ARITHMETIC {arithmetic}\n", bodies)
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


class Page:
    """The suite of a page: what hn-conform has browsers run (docs/reference/formats.md)."""

    def __init__(self, program: str, glob: str):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([program, "web", "--thorough", "--filter", glob, "--out", folder], check=True,
                           stdout=subprocess.DEVNULL)
            page = (Path(folder) / "index.html").read_text(encoding="utf-8")
        packed = re.search(r'id="suite">([^<]*)<', page)[1]
        self.json = json.loads(gzip.decompress(base64.b64decode(packed)))
        self.cases = self.json["cases"]

    def shader(self, case: dict) -> str:
        program = self.json["programs"][case["program"]]
        return "".join(self.json["texts"][piece] for piece in self.json["shaders"][program["wgsl"]]["pieces"])

    def data(self, number: int, kind: str) -> list:
        return memoryview(base64.b64decode(self.json["data"][number])).cast(kind).tolist()

    def wrong(self, device: Device, case: dict, shader: str = "") -> str:
        """Where a value of a case, or of another shader for it, is off by more than is allowed; nothing if none is."""
        inputs, outputs = ([column.split(":")[1] for column in columns.split()]
                           for columns in case["columns"].split(" = "))
        words = self.data(case["inputs"], "I")
        points = [words[i:i + len(inputs)] for i in range(0, len(words), len(inputs))]
        results = device.evaluate(shader or self.shader(case), points)
        got = [word for result in results for word in result[:len(outputs)]]
        expected = self.data(case["expected"], "I" if case["exact"] else "d")
        allowed = case["allowed"]
        allowed = self.data(allowed["data"], "d") if isinstance(allowed, dict) else [allowed] * len(expected)
        for i, (one, right, within) in enumerate(zip(got, expected, allowed, strict=True)):
            whole = case["exact"] or outputs[i % len(outputs)] in ("i32", "u32")
            value = struct.unpack("<f", struct.pack("<I", one))[0]
            if (one != int(right) & 0xFFFFFFFF) if whole else not abs(value - right) <= within:
                return f"{points[i // len(outputs)]}: got {value} ({one:08x}), expected {right} within {within}"
        return ""
