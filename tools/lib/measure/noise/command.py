"""The command line of tools/measure noise, which describes it."""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from base.renderer import NoRenderer, NotCompiled
from base.usage import Parser
from measure.noise import measures, page, record
from measure.noise.measures import Finding, Measured
from measure.noise.noise import Sampler, Subject, read, version
from translate.single_file.files import text

DESCRIPTION = """\
Judges anybody's noise: its range, jumps, repeats and more, with a page, a record and an exit status.

    tools/measure noise 'noise.glsl:snoise(p)'                       on the plane; p is a vec2
    tools/measure noise 'noise.glsl:snoise(p)' --dimensions 3 --range -1 1 --require range,jumps --out judged

It renders the GLSL by Mesa's software renderer (Debian's libegl1 and libgl1). docs/measured/judge.md explains each
measure.

Exit status: 0 done, 1 a measure of --require fails, 2 bad usage, or the GLSL does not compile, 4 there is no
renderer."""

JUDGED = ("values", "range", "jumps", "derivative", "repeats", "mirrors", "seeds", "cells", "directions", "far",
          "compilers")
WITH_SLOPE = """
float judge_ours(vec2 p, uint seed, out vec2 slope) { vec3 n = hn_perlin_d(p, seed); slope = n.yz; return n.x; }
float judge_ours(vec3 p, uint seed, out vec3 slope) { vec4 n = hn_perlin_d(p, seed); slope = n.yzw; return n.x; }
"""
# Softpipe reports an older OpenGL than the text requires; it has what the text uses.
SOFTPIPE = {"GALLIUM_DRIVER": "softpipe", "MESA_GL_VERSION_OVERRIDE": "4.5", "MESA_GLSL_VERSION_OVERRIDE": "450"}
ROUNDS, VALUES = 7, 24  # of a place: so that what a drawing costs beside them does not count


def parse(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = Parser("tools/measure noise", DESCRIPTION)
    parser.add_argument("noise", metavar="FILE:EXPRESSION", help="a file of GLSL, and a float of `p`, which is a vec2 "
                        "or a vec3, as in noise.glsl:snoise(p). It may use `seed`, a uint, and set `slope` to its "
                        "derivatives, as in psrdnoise2.glsl:psrdnoise(p, vec2(0.0), 0.0, slope)")
    parser.add_argument("--dimensions", type=int, choices=(2, 3), default=2, help="of p (default: %(default)s)")
    parser.add_argument("--name", help="of the noise, for the page (default: EXPRESSION)")
    parser.add_argument("--range", type=float, nargs=2, metavar=("LOW", "HIGH"),
                        help="the documented range of its values")
    parser.add_argument("--require", metavar="NAME,...", help="status 1 if one of these fails: " + ", ".join(JUDGED))
    parser.add_argument("--out", type=Path, metavar="DIR", help="where judged.csv and index.html go; without it only "
                        "the terminal gets")
    parser.add_argument("--record", type=Path, metavar="FILE", help="a CSV that gets the numbers, in place of what it "
                        "had of this name and these dimensions")
    options = parser.parse_args(arguments)
    file, colon, expression = options.noise.partition(":")
    if not colon or not expression.strip():
        parser.error(f"{options.noise} is not FILE:EXPRESSION, as in noise.glsl:snoise(p)")
    options.required = options.require.split(",") if options.require else []
    for name in options.required:
        if name not in JUDGED:
            parser.error(f"--require {name}: there is no such measure. There are {', '.join(JUDGED)}")
    try:
        glsl = read(Path(file))
    except (OSError, UnicodeDecodeError) as error:
        parser.error(f"cannot read {file}: {error}")
    if options.range and options.range[0] >= options.range[1]:
        parser.error(f"--range {options.range[0]:g} {options.range[1]:g}: the first is to be below the second")
    options.subject = Subject(options.name or expression.strip(), glsl, expression.strip(), options.dimensions,
                              tuple(options.range) if options.range else None)
    for name, has, wanted in (("seeds", options.subject.has_seed, "uses no `seed`"),
                              ("derivative", options.subject.has_slope, "sets no `slope`"),
                              ("range", options.range is not None, "comes without --range")):
        if name in options.required and not has:
            parser.error(f"--require {name}: {expression.strip()} {wanted}")
    options.parser = parser
    return options


def ours(dimensions: int) -> Subject:
    """Perlin noise of the library, with its derivatives."""
    library = text([f"perlin_d{dimensions}d.glsl", f"perlin{dimensions}d.glsl"], "glsl", strip=True)
    slope = "".join(line for line in WITH_SLOPE.splitlines(True) if f"vec{dimensions} p" in line)
    return Subject("hn_perlin", library + slope, "judge_ours(p, seed, slope)", dimensions, (-1.0, 1.0))


def by_softpipe(subject: Subject) -> np.ndarray | None:
    """The values that measures.compilers compares, by the other driver, which a process of its own loads."""
    with tempfile.TemporaryDirectory() as folder:
        shader, values = Path(folder) / "shader", Path(folder) / "values"
        shader.write_text(json.dumps(vars(subject)), encoding="utf-8")
        done = subprocess.run([sys.executable, "-B", "-m", "measure.noise.command", "--draw", str(shader), str(values)],
                              env={**os.environ, **SOFTPIPE}, capture_output=True, check=False)
        return np.fromfile(values, np.float32) if done.returncode == 0 else None


def draw(shader: str, values: str) -> int:
    sampler = Sampler(Subject(**json.loads(Path(shader).read_text(encoding="utf-8"))))
    sampler.random(-measures.ANYWHERE / 10, measures.ANYWHERE / 10, 800)[0].astype(np.float32).tofile(values)
    return 0


def cost(subject: Subject, other: Subject) -> Finding:
    """The cost of a value beside one of another noise, by turns in one process."""
    samplers = [Sampler(each, times=VALUES) for each in (subject, other)]
    times: list[list[float]] = [[], []]
    for _ in range(ROUNDS):
        for sampler, seconds in zip(samplers, times):
            started = time.perf_counter()
            sampler.random(-50, 50, 1)
            seconds.append(time.perf_counter() - started)
    ratio = min(times[0]) / min(times[1])
    return Finding("cost", None, ratio, f"On llvmpipe a value costs {ratio:.2g} times as much as one of hn_perlin.")


def judged(sampler: Sampler) -> dict[str, Finding]:
    measured = Measured(sampler)
    found = [measures.spread(measured), measures.extremes(measured), measures.jumps(measured),
             measures.slopes(measured), measures.repeats(measured), measures.mirrors(measured),
             measures.seeds(measured), measures.cells(measured), measures.directions(measured), measures.far(measured),
             measures.compilers(measured, lambda: by_softpipe(sampler.subject))]
    return {finding.measure: finding for finding in found if finding}


def main(arguments: Sequence[str] | None = None) -> int:
    options = parse(arguments)
    try:
        started = time.perf_counter()
        sampler = Sampler(options.subject)
        compiled = time.perf_counter() - started
        library = Sampler(ours(options.dimensions))
    except NotCompiled as error:
        options.parser.error(f"{options.noise} does not compile as a float of p, a vec{options.dimensions}: {error}")
    except NoRenderer as error:
        options.parser.exit(4, f"{options.parser.prog}: {error}\n")
    theirs = judged(sampler)
    theirs["cost"] = cost(options.subject, replace(library.subject, expression="hn_perlin(p, seed)"))
    for name, finding in theirs.items():
        verdict = {None: "    ", True: "FAIL", False: "pass"}[finding.fails]
        print(f"{verdict} {name:10} {finding.sentence}")
    if options.record:
        record.put(options.record, options.subject, theirs.values(), sampler.renderer.version)
    if options.out:
        page.write(options.out, sampler, library, theirs, judged(library), compiled,
                   version(Path(options.noise.partition(":")[0])))
        print(options.out / "index.html")
    if "compilers" in options.required and "compilers" not in theirs:
        options.parser.exit(4, f"{options.parser.prog}: --require compilers: Mesa has no softpipe here, which is the other "
                               "one\n")
    return 1 if any(theirs[name].fails for name in options.required) else 0


if __name__ == "__main__":
    sys.exit(draw(*sys.argv[2:]) if sys.argv[1:2] == ["--draw"] else main())
