"""The compilers, and how each is called. They start cold: without a cache of shaders, in memory or on a disk."""

from __future__ import annotations

import html
import itertools
import json
import math
import os
import re
import shutil
import subprocess
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from base import chromium
from base.debian import Missing
from base.tree import hn_conform
from base.versions import version_of
from measure import record
from measure.compile.texts import Job, jobs
from measure.gpu import drivers
from measure.gpu.chips import chip_named
from measure.gpu.compiling import compile_all
from translate.tools import DXC, FXC

DESKTOP = "#version 450\n"
ES = "#version 300 es\nprecision highp float;\nprecision highp int;\n"
PAGE = Path(__file__).with_name("page.html")
# Of WebGL2 and WebGPU: what is before a GLSL, the vertex shader, and options of Chromium.
VERTEX = {
    "glsl": "#version 300 es\nout highp vec{axes} p;\nvoid main() {{ gl_Position = vec4(gl_VertexID / 2, "
            "gl_VertexID % 2, 0, 1); p = vec{axes}(gl_Position.x); }}\n",
    "wgsl": "struct Made {{ @builtin(position) at: vec4f, @location(0) p: vec{axes}f }}\n@vertex fn main(@builtin("
            "vertex_index) i: u32) -> Made {{ return Made(vec4f(f32(i / 2), f32(i % 2), 0, 1), vec{axes}f(f32(i))); }}\n"}
WEBGPU = ("--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader")


class Place(NamedTuple):
    folder: Path  # for files
    peers: Mapping[str, Path]
    drivers: Path


Files = dict[Job, Path]
Round = dict[Job, float]  # milliseconds; NaN of a shader that is refused
Rounds = Callable[[Place], Iterator[Round]]


class Failed(Exception):
    """A compiler did not do its work; the text is its own."""


def program(*names: str) -> str:
    if found := next(filter(None, map(shutil.which, names)), None):
        return found
    raise Missing(f"there is no {names[0]} here")


def run(folder: Path, *words: str | Path, **variables: str) -> float:
    """Milliseconds of the processor, for the command and all that it waits for. Its messages are in the log there."""
    log = folder / "log"
    with log.open("wb") as file, subprocess.Popen([str(word) for word in words], cwd=folder, stdout=file,
                                                  stderr=subprocess.STDOUT, env={**os.environ, **variables}) as process:
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise Failed(f"{Path(words[0]).name} ended with status {process.returncode}:\n"
                     f"{log.read_text('utf-8', 'replace')[-2000:]}")
    return 1e3 * (used.ru_utime + used.ru_stime)


def attempt(job: Job, place: Place, *words: str | Path, **variables: str) -> float:
    try:
        return run(place.folder, *words, **variables)
    except Failed as why:
        return refused(job, str(why))


def refused(job: Job, why: str) -> float:
    print(f"{job.noise}, {job.way}, is refused: {' '.join(why.split())[:300]}", flush=True)
    return math.nan


def written(place: Place, shaders: Sequence[Job], language: str) -> Files:
    files = {job: place.folder / f"{number}.{language}" for number, job in enumerate(shaders)}
    for job, file in files.items():
        file.write_text(job.shader(language.replace("frag", "glsl"), DESKTOP), encoding="utf-8")
    return files


def glsl(place: Place) -> Files:
    return written(place, jobs("glsl", place.peers), "frag")


def hlsl(place: Place) -> Files:
    return written(place, jobs("hlsl", place.peers), "hlsl")


def spirv(place: Place) -> Files:
    words, files = glslang(), glsl(place)
    return {job: made for job, file in files.items() if (made := file.with_suffix(".spv")) and not math.isnan(
        attempt(job, place, *words, file, "-o", made))}


def wgsl(place: Place) -> Files:
    """naga translates the peers', and leaves out what is not called."""
    theirs = {job: file for job, file in spirv(place).items() if job.is_foreign}
    return written(place, jobs("wgsl", place.peers), "wgsl") | {
        job: made for job, file in theirs.items() if (made := file.with_suffix(".peer.wgsl")) and not math.isnan(
            attempt(job, place, program("naga"), file, made))}


def glslang() -> list[str | Path]:
    return [program("glslangValidator"), "-V", "--auto-map-locations"]


def by_command(files: Callable[[Place], Files], words: Callable[[], Sequence[str | Path]], *after: str,
               variables: Callable[[], Mapping[str, str]] = dict) -> Rounds:
    """By the words, the file and what stands after it."""
    def rounds(place: Place) -> Iterator[Round]:
        command, found, environment = words(), files(place), variables()
        while True:
            yield {job: attempt(job, place, *command, file.name, *after, **environment) for job, file in found.items()}
    return rounds


def by_driver(name: str) -> Rounds:
    def rounds(place: Place) -> Iterator[Round]:
        chip, found = chip_named(name), drivers.find(place.drivers)
        command = found.compiler(chip, [hn_conform() or program("hn-conform"), "shader-statistics"])
        files = spirv(place)
        while True:
            _, results = compile_all(command, found.environment(chip), list(files.values()))
            yield {job: refused(job, one.problem) if one.problem else 1e3 * one.seconds
                   for job, one in zip(files, results, strict=True)}
    return rounds


def by_llvmpipe(place: Place) -> Iterator[Round]:
    # bench measures a function of ours, too: the cheapest.
    command: list[str | Path] = [hn_conform() or program("hn-conform"), "bench", "--driver", "osmesa", "--rounds", "3",
                                 "--filter", "hash.unorm*", "--out", "bench"]
    ids = {}
    for number, job in enumerate(jobs("glsl", place.peers)):
        (place.folder / f"{number}.glsl").write_text(job.library, encoding="utf-8")
        ids[job] = f"job{number}-{job.axes}"
        command += ["--against", f"job{number}-@420={number}.glsl:{job.call}"]
    while True:
        run(place.folder, *command, MESA_SHADER_CACHE_DISABLE="true")
        times = {row["id"]: float(row["compile_ms"]) for row in record.read(place.folder / "bench" / "bench.csv").rows}
        yield {job: times[id] for job, id in ids.items()}


def by_chromium(language: str, texts: Callable[[Place], dict[Job, str]], *options: str) -> Rounds:
    def rounds(place: Place) -> Iterator[Round]:
        found, page, shaders = program(*chromium.PROGRAMS), place.folder / "page.html", texts(place)
        for number in itertools.count():
            # A text that no cache has seen: each round has another comment.
            values = {"vertex": {axes: VERTEX[language].format(axes=axes) for axes in (2, 3)},
                      "shaders": [(f"{text}// {number}\n", job.axes) for job, text in shaders.items()]}
            page.write_text(PAGE.read_text("utf-8").replace("VALUES", json.dumps(values).replace("</", "<\\/")), "utf-8")
            run(place.folder, *chromium.command(found, place.folder / f"profile{number}", "--dump-dom",
                                                "--timeout=600000", *options), f"{page.as_uri()}#{language}")
            printed = re.search(r'<pre id="times">(.*?)</pre>', (place.folder / "log").read_text("utf-8"), re.DOTALL)
            if not printed or not printed[1].startswith("["):
                raise Failed(f"the page in Chromium {html.unescape(printed[1]) if printed else 'left no report'}")
            yield {job: refused(job, one) if isinstance(one, str) else one
                   for job, one in zip(shaders, json.loads(html.unescape(printed[1])), strict=True)}
    return rounds


class Compiler(NamedTuple):
    title: str
    rounds: Rounds
    version: Callable[[Place], str]


def of_program(*names: str) -> Callable[[Place], str]:
    return lambda place: version_of(program(*names))


def of_drivers(place: Place) -> str:
    return drivers.find(place.drivers).versions()


COMPILERS = {
    "glslang": Compiler("glslang, to SPIR-V", by_command(glsl, lambda: [*glslang(), "-o", "made.spv"]),
        of_program("glslangValidator")),
    "spirv-opt": Compiler("`spirv-opt -O`", by_command(spirv, lambda: [program("spirv-opt"), "-O", "-o", "made"]),
        of_program("spirv-opt")),
    "naga": Compiler("naga, WGSL to SPIR-V", by_command(wgsl, lambda: [program("naga")], "made.spv"),
        of_program("naga")),
    "dxc": Compiler("DXC", by_command(hlsl, lambda: [DXC.path(), "-T", "ps_6_0", "-E", "main", "-Fo", "made"]),
        lambda place: DXC.package),
    "fxc": Compiler("FXC", by_command(hlsl, lambda: [FXC.path(), "-T", "ps_5_0", "-E", "main", "-Fo", "made"]),
        lambda place: FXC.package),
    "radv": Compiler("RADV, AMD Navi 31", by_driver("navi31"),
        of_drivers),
    "turnip": Compiler("Turnip, Adreno 740", by_driver("adreno740"),
        of_drivers),
    "nvk": Compiler("NVK, NVIDIA GA104", by_driver("ampere"),
        of_drivers),
    "llvmpipe": Compiler("llvmpipe", by_llvmpipe,
        lambda place: "llvmpipe of OSMesa"),
    "angle": Compiler("ANGLE on SwiftShader", by_chromium(
        "glsl", lambda place: {job: job.shader("glsl", ES) for job in jobs("glsl", place.peers)}),
        of_program(*chromium.PROGRAMS)),
    "tint": Compiler("Tint on SwiftShader", by_chromium(
        "wgsl", lambda place: {job: file.read_text("utf-8") for job, file in wgsl(place).items()}, *WEBGPU),
        of_program(*chromium.PROGRAMS)),
}
