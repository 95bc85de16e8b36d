"""The command line of tools/measure compile, which describes it."""

from __future__ import annotations

import html
import json
import os
import re
import shutil
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from base import chromium
from base.tree import HN_CONFORM, ROOT
from base.usage import Parser
from base.versions import version_of
from catalog.tables.markdown import table
from measure import record as records
from measure import stamps
from measure.compile.texts import SUBJECTS, WAYS, Subject, fragment, shaders

DESCRIPTION = """\
Times how long shaders take to compile: a function with the whole library before it, with the files that it needs, or
as tools/pick prints it.

    tools/measure compile [--compiler NAME]... [--rounds N] [--out FILE]

Compilers are glslang (the program, less an empty shader), mesa (llvmpipe, by hn-conform bench, with its first draw and
without its cache) and angle (Chromium's WebGL2 on SwiftShader, with its first draw). Each time is the median of the
rounds, in milliseconds. docs/measured/results/llvmpipe/compile.csv is such a file; tools/make readme makes of it the
table of docs/measured/measuring.md.

Exit status: 0 done, 1 a compiler refused a shader, 2 bad usage or no such compiler here."""

RECORD = ROOT / "docs" / "measured" / "results" / "llvmpipe" / "compile.csv"
Times = dict[tuple[str, str], list[float]]  # milliseconds by function and way


class Failed(Exception):
    """A compiler did not do its work; the text is its own."""


def run(command: Sequence[str | Path], environment: Mapping[str, str] | None = None) -> str:
    done = subprocess.run(command, capture_output=True, text=True, check=False, env={**os.environ, **(environment or {})})
    if done.returncode:
        raise Failed(f"{Path(command[0]).name} ended with status {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def by_glslang(program: str, folder: Path, rounds: int) -> Times:
    def seconds(shader: str) -> float:
        path = folder / "shader.frag"
        path.write_text(shader, encoding="utf-8")
        begin = time.perf_counter()
        run([program, "-l", path])
        return time.perf_counter() - begin

    version = "#version 330"
    times: Times = {}
    for _ in range(rounds):
        empty = seconds(f"{version}\nout vec4 color;\nvoid main() {{ color = vec4(1.0); }}\n")
        for subject, way, library in shaders():
            times.setdefault((subject.picked, way), []).append(
                1e3 * max(seconds(fragment(version, subject, library)) - empty, 0.0))
    return times


def by_mesa(program: str, folder: Path, rounds: int) -> Times:
    # bench measures a function of ours, too: the cheapest.
    command = [program, "bench", "--driver", "osmesa", "--rounds", "3", "--filter", "hash.unorm*", "--out",
               str(folder / "out")]
    for subject, way, library in shaders():
        path = folder / f"{subject.picked}-{way}.glsl"
        path.write_text(library, encoding="utf-8")
        command += ["--against", f"{path.stem}={path}:{subject.call}"]
    times: Times = {}
    for _ in range(rounds):
        run(command, {"MESA_SHADER_CACHE_DISABLE": "true"})
        found = {row["id"]: float(row["compile_ms"]) for row in records.read(folder / "out" / "bench.csv").rows}
        for subject, way, _ in shaders():
            times.setdefault((subject.picked, way), []).append(found[f"{subject.picked}-{way}{subject.axes}"])
    return times


PAGE = """\
<!doctype html><meta charset="utf-8"><pre id="times">not run</pre><script>
const shaders = %s;
const gl = document.createElement("canvas").getContext("webgl2");
const stage = (type, text) => {
  const shader = gl.createShader(type);
  gl.shaderSource(shader, text);
  gl.compileShader(shader);
  return shader;
};
function once(shader) {
  const begin = performance.now();
  const program = gl.createProgram();
  gl.attachShader(program, stage(gl.VERTEX_SHADER, shader.vertex));
  gl.attachShader(program, stage(gl.FRAGMENT_SHADER, shader.fragment));
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  gl.useProgram(program);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  return performance.now() - begin;
}
try {
  if (!gl) throw new Error("there is no WebGL2");
  once(shaders[0]);  // what the first of all pays
  document.getElementById("times").textContent = JSON.stringify(shaders.map(once));
} catch (error) {
  document.getElementById("times").textContent = "failed: " + error.message;
}
</script>
"""


def by_angle(program: str, folder: Path, rounds: int) -> Times:
    vertex = ("#version 300 es\nout highp vec{axes} p;\nvoid main() {{ gl_Position = vec4(gl_VertexID / 2, "
              "gl_VertexID % 2, 0, 1); p = vec{axes}(gl_Position.x); }}\n")
    version = "#version 300 es\nprecision highp float;\nprecision highp int;"
    jobs = [(subject, way, fragment(version, subject, library)) for subject, way, library in shaders()]
    page = folder / "page.html"
    times: Times = {}
    for number in range(rounds):
        # A text that no cache has seen: each round is a comment more.
        listed = [{"vertex": vertex.format(axes=subject.axes), "fragment": f"{text}// {number}\n"}
                  for subject, _, text in jobs]
        page.write_text(PAGE % json.dumps(listed).replace("</", "<\\/"), encoding="utf-8")
        dom = run([*chromium.command(program, folder / f"profile{number}", "--dump-dom", "--timeout=60000"),
                   page.as_uri()])
        printed = re.search(r'<pre id="times">(.*?)</pre>', dom, re.DOTALL)
        if not printed or not printed[1].startswith("["):
            raise Failed(f"the page in Chromium {html.unescape(printed[1]) if printed else 'left no report'}")
        for (subject, way, _), milliseconds in zip(jobs, json.loads(printed[1]), strict=True):
            times.setdefault((subject.picked, way), []).append(milliseconds)
    return times


COMPILERS: dict[str, tuple[tuple[str, ...], Callable[[str, Path, int], Times]]] = {
    "glslang": (("glslangValidator",), by_glslang),
    "mesa": (("hn-conform", str(HN_CONFORM)), by_mesa),
    "angle": (chromium.PROGRAMS, by_angle),
}


def lines_of(compiler: str, times: Times) -> list[dict[str, str]]:
    sizes = {(subject.picked, way): str(len(library.encode())) for subject, way, library in shaders()}
    return [{"function": function, "way": way, "compiler": compiler, "bytes": sizes[function, way],
             "ms": f"{statistics.median(found):.1f}"} for (function, way), found in times.items()]


def page_table(rows: Sequence[Mapping[str, str]]) -> str:
    """Of a record: milliseconds whole, part and picked, by function and compiler."""
    cells = {(row["function"], row["way"], row["compiler"]): row for row in rows}

    def shown(subject: Subject, compiler: str) -> str:
        return " / ".join(f"{float(cells[subject.picked, way, compiler]['ms']):.0f}" for way in WAYS)

    def size(subject: Subject) -> str:
        return " / ".join(f"{int(cells[subject.picked, way, 'glslang']['bytes']) / 1000:.1f}" for way in WAYS)

    return table(("", "kB", "glslang, ms", "Mesa's llvmpipe, ms", "ANGLE on SwiftShader, ms"),
                 [[f"`{subject.picked}`", size(subject), *(shown(subject, compiler) for compiler in COMPILERS)]
                  for subject in SUBJECTS])


def record() -> list[dict[str, str]]:
    return records.read(RECORD).rows


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure compile", DESCRIPTION)
    parser.add_argument("--compiler", action="append", choices=tuple(COMPILERS), metavar="NAME",
                        help=f"only this one: {', '.join(COMPILERS)}; may be repeated")
    parser.add_argument("--rounds", type=int, default=5, metavar="N", help="from 1 to 100 (default: %(default)s)")
    parser.add_argument("--out", type=Path, default=Path("compile.csv"), metavar="FILE",
                        help="the record (default: %(default)s)")
    options = parser.parse_args(arguments)
    if not 1 <= options.rounds <= 100:
        parser.error(f"--rounds: {options.rounds} is not from 1 to 100")
    lines, used = [], []
    for name in options.compiler or COMPILERS:
        programs, measure = COMPILERS[name]
        program = next(filter(None, map(shutil.which, programs)), None)
        if program is None:
            parser.error(f"--compiler {name}: there is no {programs[0]} (tools/measure clock installs and builds what is "
                         "needed)")
        used.append(version_of(program))
        print(f"{name}: {options.rounds} rounds", file=sys.stderr, flush=True)
        with TemporaryDirectory() as folder:
            try:
                lines += lines_of(name, measure(program, Path(folder), options.rounds))
            except Failed as error:
                print(f"{parser.prog}: {name}: {error}", file=sys.stderr)
                return 1
    try:
        records.write(options.out, lines)
        stamps.stamp(options.out, "; ".join(used), kind=RECORD.name)
    except OSError as error:
        parser.error(f"--out: {error}")
    return 0
