"""Shaders of OSL that call picked functions, which Blender's Cycles renders: a column of pixels for each point, with
the results from below."""

from __future__ import annotations

import json
import os
import re
import struct
import sys
from array import array
from collections.abc import Sequence
from pathlib import Path

from base.pypi import installed
from translate.pick.osl import Osl, without_shader
from translate.pick.runners import CRunner, ran

PACKAGE = "bpy==5.0.1"
RENDER = Path(__file__).resolve().with_name("osl_render.py")
LEAST = 4  # pixels along each side of a picture of Blender's
# A word is two halves, and a float its positive or its negative part. The third part of the color has the sign of 0,
# which atan2 knows.
WORDS = """
void put(output color shown, int row, output int to, int word) {
  if (to == row) shown = color(word & 0xFFFF, (word >> 16) & 0xFFFF, 0.0);
  to += 1;
}
void put_float(output color shown, int row, output int to, float x) {
  if (to == row) shown = color(max(x, 0.0), max(-x, 0.0), atan2(x, -1.0) < 0.0);
  to += 1;
}
"""
SHADER = """shader calls(output color shown = 0) {{
  int words[{size}] = {{{words}}};
  float floats[{size}] = {{{floats}}};
  int row = (int)floor(P[1]), to = 0, at = {taken} * (int)floor(P[0]);
{call}
}}
"""


class OslRunner(CRunner):
    syntax = Osl
    programs = ()
    packages = struct_of = ""
    arithmetics = ("fast", "fixed")
    read = {"float": "floats[at++]", "int": "words[at++]", "uint": "words[at++]", "bool": "words[at++] != 0"}
    write = {"float": "put_float(shown, row, to, {});", **dict.fromkeys(("int", "uint", "bool"),
                                                                       "put(shown, row, to, {});")}
    faults = {("int", ">>"): "(({}) / (1 << ({})))", ("uint", ">>"): "(({}) >> ({}))"}
    loop = "if (at < {points} * 1000) {{"  # each pixel is a point
    beyond = 1e38  # floats that are not below this are 0
    indent = "  "

    def check(self, lints: bool = False) -> None:
        self.packages = str(installed(PACKAGE))

    def build_and_run(self, texts: Sequence[str], calls: Sequence[str], folder: Path) -> None:
        inputs = memoryview((folder / "inputs").read_bytes()).cast("I")
        jobs, outputs = [], []
        for i, (text, call) in enumerate(zip(texts, calls)):
            points = int(re.search(r"at < (\d+) \*", call)[1])
            taken, given = call.count("[at++]"), re.findall(r"\b(put(?:_float)?)\(", call)
            words, inputs = inputs[:points * taken], inputs[points * taken:]
            functions = without_shader(text)
            signed, = struct.iter_unpack(f"{len(words)}i", words.tobytes())
            floats = (f"{x:.9g}" if abs(x) < self.beyond else "0" for x in array("f", words.tobytes()))
            (folder / f"m{i}.osl").write_text(functions + WORDS + SHADER.format(
                size=len(words), words=", ".join(map(str, signed)), floats=", ".join(floats), taken=taken, call=call),
                encoding="ascii")
            jobs.append({"shader": f"m{i}.osl", "width": points, "height": max(LEAST, len(given))})
            if functions != text:  # its own shader has to be one, too
                (folder / f"node{i}.osl").write_text(text, encoding="ascii")
                jobs[-1]["node"] = f"node{i}.osl"
            outputs.append(given)
        (folder / "jobs.json").write_text(json.dumps(jobs), encoding="utf-8")
        paths = os.pathsep.join(filter(None, (self.packages, os.environ.get("PYTHONPATH"))))
        ran(folder, "env", f"PYTHONPATH={paths}", sys.executable, "-B", RENDER, folder)
        written = b""
        for job, given in zip(jobs, outputs):
            pixels = memoryview((folder / job["shader"]).with_suffix(".pixels").read_bytes()).cast("f")
            for point in range(job["width"]):
                for row, kind in enumerate(given):
                    at = 4 * (row * job["width"] + point)
                    first, second, minus = pixels[at:at + 3]
                    number = -0.0 if minus and not second else first - second
                    written += (struct.pack("<f", number) if kind == "put_float" else
                                struct.pack("<I", int(first) | int(second) << 16))
        (folder / "outputs").write_bytes(written)

    def lint(self, texts: Sequence[str], folder: Path) -> None:
        """Each is compiled with its shader, and beside one that calls nothing of it."""
        call = f"  {self.loop.format(points=LEAST)}\n    put_float(shown, row, to, floats[at++]);\n  }}"
        (folder / "inputs").write_bytes(bytes(4 * LEAST * len(texts)))
        self.build_and_run(texts, [call] * len(texts), folder)

    def called(self, name: str, arguments: Sequence[str], results: Sequence) -> list[str]:
        return [line.replace("&", "") for line in super().called(name, arguments, results)]
