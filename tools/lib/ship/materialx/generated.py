"""Shaders that MaterialX makes of the library of nodes, compiled and run for tests."""

from __future__ import annotations

import functools
import importlib
import json
import math
import shutil
import sys
from array import array
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import ModuleType
from typing import NamedTuple

from base.debian import Missing
from base.pypi import installed
from base.renderer import Renderer
from base.tree import ROOT
from proof.vectors.files import vectors_folder
from ship.materialx import files
from translate.pick import slang
from translate.pick.osl_runner import OslRunner
from translate.pick.runners import ran
from translate.tools import SLANG

MATERIALX = "materialx==1.39.5"
# The generators that have shaders to compile, by the module and the class.
GENERATORS = {"glsl": ("GenGlsl", "Glsl"), "essl": ("GenGlsl", "Essl"), "vulkan": ("GenGlsl", "Vk"),
              "wgsl": ("GenGlsl", "Wgsl"), "metal": ("GenMsl", "Msl"), "slang": ("GenSlang", "Slang"),
              "osl": ("GenOsl", "Osl")}
PIXEL = "pixel"
SIDE = 64  # pixels; a row of them has as many as there are rows of vectors


def materialx(part: str = "") -> ModuleType:
    folder = str(installed(MATERIALX, "--no-deps"))
    if folder not in sys.path:
        sys.path.insert(0, folder)
    return importlib.import_module(f"MaterialX{part and f'.PyMaterialX{part}'}")


class Generated:
    """A graph that has every node of the library in a folder, and its shaders."""

    def __init__(self, folder: Path) -> None:
        self._mx = mx = materialx()
        self._search = mx.getDefaultDataSearchPath()
        self._search.append(mx.FilePath(str(folder)))
        self.library = mx.createDocument()
        mx.loadLibraries([*mx.getDefaultDataLibraryFolders(), files.LIBRARY], self._search, self.library)
        self.definitions = [one for one in self.library.getNodeDefs() if one.getNodeString().startswith("hn_")]
        self.nodes = [one.getNodeString() for one in self.definitions]
        self.graph = mx.createDocument()
        self.graph.importLibrary(self.library)
        self._last = None
        for one in self.definitions:
            self._add(self._number(self.graph.addNodeInstance(one)))

    def _number(self, node):
        """The first component, of a vector."""
        if node.getType() == "float":
            return node
        part = self.graph.addNode("extract", "", "float")
        part.addInput("in", node.getType()).setConnectedNode(node)
        return part

    def _add(self, node) -> None:
        if self._last:
            total = self.graph.addNode("add", "", "float")
            total.setConnectedNode("in1", self._last)
            total.setConnectedNode("in2", node)
            node = total
        self._last = node

    def faults(self) -> str:
        """MaterialX's messages on the library; nothing if it is right."""
        return self.graph.validate()[1]

    def targets(self) -> dict[str, set[str]]:
        """The targets whose implementation is made for each node."""
        return {one.getNodeString(): {target for target in files.TARGETS
                                      if (found := one.getImplementation(target)) and found.getTarget() == target}
                for one in self.definitions}

    @functools.cache
    def shaders(self, name: str) -> dict[str, str]:
        """The text of each stage."""
        return self._shaders(name, self._last)

    def shader_of(self, text: str, name: str) -> str:
        """A shader in GLSL of a node in a document."""
        graph = self._mx.createDocument()
        self._mx.readFromXmlString(graph, text)
        graph.importLibrary(self.library)
        if not (said := graph.validate())[0]:
            raise ValueError(said[1])
        return self._shaders("glsl", graph.getNode(name))[PIXEL]

    def _shaders(self, name: str, node) -> dict[str, str]:
        part, language = GENERATORS[name]
        made = getattr(materialx(part), f"{language}ShaderGenerator").create()
        context = materialx("GenShader").GenContext(made)
        context.registerSourceCodeSearchPath(self._search)
        shader = made.generate("shader", node, context)
        return {stage: shader.getSourceCode(stage) for stage in ("vertex", PIXEL) if shader.hasStage(stage)}


class Row(NamedTuple):
    """Words that go in, and numbers that come out of a vector."""
    words: list[int]
    out: list[float]


class Vectors(NamedTuple):
    kinds: list[str]
    rows: list[Row]


@functools.cache
def vectors(form: str) -> Vectors:
    folder = vectors_folder()
    for one in json.loads((folder / "index.json").read_text(encoding="ascii"))["files"]:
        if one["name"] == form:
            found = json.loads((folder / one["file"]).read_text(encoding="ascii"))
            kinds = [column["type"] for column in found["inputs"]]
            if found["inputs"][0]["name"] == "x":  # and not a cell
                rows = next(group for group in found["settings"] if group["name"] == "lattice+fixed")["rows"]
                periods = [column["name"] in ("px", "py") for column in found["inputs"]]
                # A period comes as a float, and so may have 24 bits.
                return Vectors(kinds, [Row([int(word, 16) for word in row["words"].split()], row["out"]) for row in rows
                                       if all(abs(value) <= 1 << 24 for value, is_period in zip(row["in"], periods)
                                              if is_period)])
    raise ValueError(f"{form} has no vectors")


def call(form: str, read: Mapping[str, str], vec: str = "vec{}") -> str:
    """A call of the node's function with the words of a row. `read` makes a number of a word, by its kind."""
    kinds = list(enumerate(vectors(form).kinds))
    arguments = []
    for one in files.inputs(form):
        if one in (files.AMPLITUDE, files.PIVOT):
            arguments.append("1.0" if one is files.AMPLITUDE else "0.0")
            continue
        count = int(one.type[-1]) if one.type.startswith("vec") else 1
        parts = []
        for _ in range(count):
            word, kind = kinds.pop(0)
            part = read[kind].format(word)
            parts.append(f"float({part})" if count > 1 and kind == "i32" else part)
        arguments.append(parts[0] if count == 1 else f"{vec.format(count)}({', '.join(parts)})")
    return f"{files.node(form)}({', '.join([*arguments, 'result'])});"


def size_of(form: str) -> int:
    return len(vectors(form).rows[0].out)


class Job(NamedTuple):
    text: str  # of functions
    form: str


class Language:
    """A generator's shaders: what compiles them, and of some what runs the functions that are in one."""
    name: str
    ends = "void main()"  # the text behind the functions

    def compile(self, made: Generated, folder: Path) -> None:
        raise NotImplementedError

    def functions(self, made: Generated) -> str:
        text = made.shaders(self.name)[PIXEL]
        return text[text.index("// hn_"):text.index(self.ends)]

    def run(self, jobs: Sequence[Job], folder: Path) -> list[list[list[float]]]:
        """The results of each row of each job."""
        raise NotImplementedError


class Glsl(Language):
    name = "glsl"
    READ = {"f32": "uintBitsToFloat(w[at + {}])", "i32": "int(w[at + {}])", "u32": "int(w[at + {}])"}

    def compile(self, made: Generated, folder: Path) -> None:
        for name, options in (("glsl", ()), ("essl", ()), ("vulkan", ("-V", "-o", "/dev/null")),
                              ("wgsl", ("-V", "-o", "/dev/null"))):
            for stage, text in made.shaders(name).items():
                path = folder / f"{name}.{'frag' if stage == PIXEL else 'vert'}"
                path.write_text(text, encoding="utf-8")
                ran(folder, "glslangValidator", *options, path)

    def run(self, jobs: Sequence[Job], folder: Path) -> list[list[list[float]]]:
        renderer, found = Renderer(SIDE), []
        for text, form in jobs:
            rows, n = vectors(form).rows, size_of(form)
            words = [word for row in rows for word in row.words]
            pixels = renderer.draw(renderer.program(f"""#version 450
out vec4 color;
{text}
const uint w[{len(words)}] = uint[]({', '.join(f'{word}u' for word in words)});
void main() {{
  int at = min(int(gl_FragCoord.x), {len(rows) - 1}) * {len(rows[0].words)};
  {'float' if n == 1 else f'vec{n}'} result;
  {call(form, self.READ)}
  color = vec4(result{', 0.0' * (4 - n)});
}}
"""))
            found.append([pixels[4 * i:4 * i + n].tolist() for i in range(len(rows))])
        return found


class Metal(Language):
    """The functions alone: what MaterialX writes around them needs more of Metal than the suite's stand-in has."""
    name, ends = "metal", "PixelOutputs FragmentMain()"

    def compile(self, made: Generated, folder: Path) -> None:
        shutil.copy(ROOT / "conformance" / "gpu" / "metal" / "metal_stdlib.hpp", folder / "metal_stdlib")
        (folder / "metal.cpp").write_text(f"#include <metal_stdlib>\nusing namespace metal;\nstruct Context {{\n"
                                          f"{self.functions(made)}}};\n", encoding="utf-8")
        ran(folder, "clang++", "-std=c++14", "-I.", "-fsyntax-only", "metal.cpp")


class SlangLanguage(Language):
    name = "slang"

    def compile(self, made: Generated, folder: Path) -> None:
        """Both stages, though they are called fragmentMain and vertexMain."""
        for stage, text in made.shaders(self.name).items():
            slang.compiled(text, "spirv", entry=f"{'fragment' if stage == PIXEL else 'vertex'}Main",
                           stage="fragment" if stage == PIXEL else "vertex")


class Osl(Language):
    name, ends = "osl", "\nshader shader"
    READ = {"f32": "float w{} = floats[at++];", "i32": "int w{} = words[at++];", "u32": "int w{} = words[at++];"}

    def _runner(self, folder: Path) -> OslRunner:
        headers = installed(MATERIALX, "--no-deps") / "MaterialX/libraries/stdlib/genosl/include"
        for path in headers.glob("*.h"):
            shutil.copy(path, folder)
        runner = OslRunner()
        runner.beyond = math.inf
        runner.check()
        return runner

    def compile(self, made: Generated, folder: Path) -> None:
        self._runner(folder).lint([made.shaders(self.name)[PIXEL]], folder)

    def run(self, jobs: Sequence[Job], folder: Path) -> list[list[list[float]]]:
        runner, calls = self._runner(folder), []
        for _, form in jobs:
            n, (kinds, rows) = size_of(form), vectors(form)
            words = " ".join(self.READ[kind].format(i) for i, kind in enumerate(kinds))
            made = call(form, dict.fromkeys(self.READ, "w{}"), "vector{}").replace("vector3(", "vector(")
            made = made.replace("float(", "(float)(")
            parts = {1: ["result"], 2: ["result.x", "result.y"], 3: [f"result[{axis}]" for axis in range(3)]}[n]
            calls.append(f"  {runner.loop.format(points=len(rows))} {words}\n"
                         f"  {('float', 'vector2', 'vector')[n - 1]} result;\n  {made}"
                         + "".join(f"\n  put_float(shown, row, to, {part});" for part in parts) + "\n  }")
        (folder / "inputs").write_bytes(b"".join(
            array("I", row.words).tobytes() for _, form in jobs for row in vectors(form).rows))
        runner.build_and_run([f'#include "mx_funcs.h"\n{text}' for text, _ in jobs], calls, folder)
        numbers = iter(array("f", (folder / "outputs").read_bytes()))
        return [[[next(numbers) for _ in range(size_of(form))] for _ in vectors(form).rows] for _, form in jobs]


LANGUAGES: tuple[type[Language], ...] = (Glsl, Metal, SlangLanguage, Osl)
# Metal and Slang have the wrappers and the functions that GLSL has, by their names.
RUN: tuple[type[Language], ...] = (Glsl, Osl)


def needed() -> None:
    """Raises Missing or NoRenderer if something is not here."""
    for program, package in (("glslangValidator", "glslang-tools"), ("clang++", "clang")):
        if not shutil.which(program):
            raise Missing(f"there is no {program}: apt-get install {package}")
    materialx()
    OslRunner().check()
    Renderer(SIDE)
    SLANG.path()
