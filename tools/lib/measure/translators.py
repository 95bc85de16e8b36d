"""Finds published bugs in released translators of shaders, by the cases of the suite.

    tools/measure translators [--tool GLOB]... [--program FILE] [--out DIR]

Each translator of tools/lib/translate/tools.py, in each version, takes the cases `bugs.*`, and drivers of this machine run
its output. translators.csv goes into DIR: the number of the bug upstream, the translator, its version, the way, the case,
and what came out: `found`, `right`, or `unsupported`. A version that is known to be right must be, and a bug that nobody
knows has the number `new`. docs/measured/results/translators.csv is such a file.

GLOB is of names as in `naga-22.0.0`. Translators that are missing are fetched: 600 MB in build/. All take half an hour.

Exit status: 0 all is as published, 1 it is not, 2 bad usage, 4 a translator or hn-conform is missing.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from fnmatch import fnmatch
from pathlib import Path
from typing import NamedTuple

from base.debian import Missing
from base.tree import hn_conform
from base.usage import Parser
from measure import stamps
from translate.tools import ALL, BY_NAME, SWIFTSHADER, Tool

COLUMNS = ("bug", "tool", "version", "way", "case", "outcome")
FAULTS = ("fail", "crash", "timeout")
# Mesa's driver for processors.
DRIVERS = Path("/usr/share/vulkan/icd.d")
# The drivers that translators are, by their variables; the others' ways end in drivers.
VARIABLES = {"wgpu": "HN_WGPU", "dawn": "HN_DAWN"}
VKD3D = "vkd3d={vkd3d}"
# By the form that a translator is to give, or both forms: the driver, and what follows on the translator.
WAYS: Mapping[str, Mapping[str, tuple[str, ...]]] = {
    "spirv-opt": {"spirv": ("vulkan:0",)},
    "naga": {"wgsl:spirv": ("vulkan:0",), "glsl:spirv": ("vulkan:0",), "wgsl:glsl-es": ("egl-gles",)},
    "dxc": {"spirv": ("vulkan:0",), "dxil": ("vulkan:0", VKD3D)},
    "fxc": {"dxbc": ("vulkan:0", VKD3D)},
    "slang": {"slang:spirv": ("vulkan:0",)},
    "wgpu": {"": ("wgpu",)},
    "dawn": {"": ("dawn",)},
}
# Its DXIL is not signed; it writes no SPIR-V; it does not know the ending .comp.glsl.
WITHOUT = {("dxc-1.7", "dxil"), ("dxc-1.10", "spirv"), ("naga-0.9.0", "glsl:spirv")}


class Bug(NamedTuple):
    number: str  # upstream's, or HERE
    case: str  # a row of conformance/cases/bugs
    versions: Mapping[str, str]  # the first and the last that have it, by the translator and its way


HERE = "found here"  # docs/measured/faults.md, or a refusal of valid text in old versions
WGSL, ES, GLSL = "naga:wgsl:spirv", "naga:wgsl:glsl-es", "naga:glsl:spirv"
BUGS = (
    Bug("KhronosGroup/SPIRV-Tools 5499", "remainder_of_constant", {"spirv-opt:spirv": "2023.1 2023.5"}),
    Bug("KhronosGroup/SPIRV-Tools 5822", "negated_quotient", {"spirv-opt:spirv": "2023.1 2023.5", "dxc:spirv": "1.7"}),
    Bug("KhronosGroup/SPIRV-Tools 3445", "switch_of_constant", {"fxc:dxbc": "6.3 10.0"}),
    Bug("gfx-rs/wgpu 4982", "do_while", {"wgpu": "0.13.2", WGSL: "0.14.0", ES: "0.14.0"}),
    Bug("gfx-rs/wgpu 9489", "zeroed_in_loop", {"wgpu": "0.9.5 0.32.0", WGSL: "0.9.0 22.0.0", ES: "0.9.0 22.0.0",
                                               "dawn": "0.4.0 0.6.2"}),
    Bug("gfx-rs/wgpu 9181", "call_changes_operand", {"wgpu": "0.13.2 0.29.0", WGSL: "0.14.0 22.0.0", ES: "0.14.0 22.0.0"}),
    Bug("gfx-rs/wgpu 6057", "float_to_int_saturates", {"wgpu": "0.9.5 0.22.2", WGSL: "0.9.0 22.0.0"}),
    Bug("gfx-rs/wgpu 4385", "division_by_zero", {"wgpu": "0.9.5 0.22.2", WGSL: "0.9.0 22.0.0"}),
    Bug("gfx-rs/naga 2181", "switch_default_in_middle", {"wgpu": "0.9.5", WGSL: "0.9.0"}),
    Bug("gpuweb/gpuweb 288", "bits_out_of_range", {"wgpu": "0.9.5 0.17.3", WGSL: "0.9.0 0.14.0", ES: "0.9.0 0.14.0"}),
    Bug("gfx-rs/wgpu 9687", "remainder_of_negative", {ES: "0.9.0 30.0.1"}),
    Bug("gfx-rs/wgpu 7312", "literals_converted", {"wgpu": "0.15.3 0.22.2", WGSL: "22.0.0", ES: "22.0.0"}),
    Bug("gfx-rs/wgpu 5246", "three_nested_loops", {GLSL: "0.14.0"}),
    Bug("microsoft/DirectXShaderCompiler 3396", "int_of_uint_vector", {"dxc:spirv": "1.7"}),
    Bug("microsoft/DirectXShaderCompiler 6975", "int_of_uint_vector", {"dxc:spirv": "1.7"}),
    Bug("microsoft/DirectXShaderCompiler 6884", "enum_constant", {"dxc:spirv": "1.7"}),
    Bug("microsoft/DirectXShaderCompiler 5665", "highest_bit", {"dxc:spirv": "1.7"}),
    Bug("microsoft/DirectXShaderCompiler 8094", "division_by_large_negative", {"dxc:dxil": "1.10"}),
    Bug("shader-slang/slang 7035", "int_of_byte", {"slang:slang:spirv": "2024.1.6 2024.17"}),
    Bug(HERE, "division_by_zero", {ES: "0.9.0 30.0.1"}),
    Bug(HERE, "float_to_int_saturates", {ES: "0.9.0 30.0.1"}),
    Bug(HERE, "negated_quotient", {GLSL: "0.14.0 30.0.1"}),
    Bug(HERE, "words_wrap_at_32_bits", {GLSL: "0.14.0 30.0.1"}),
    Bug(HERE, "shift_by_constant_32", {"wgpu": "0.32.0", WGSL: "30.0.1", ES: "30.0.1"}),
    Bug(HERE, "products_of_literals", {"wgpu": "0.19.3 0.29.0", WGSL: "22.0.0", ES: "22.0.0", GLSL: "22.0.0",
                                       "fxc:dxbc": "6.3"}),
    Bug(HERE, "folded_words", {GLSL: "22.0.0 30.0.1", "fxc:dxbc": "6.3 10.0"}),
    Bug(HERE, "ints_overflow", {"dxc:dxil": "1.10"}),
    *(Bug(HERE, case, {"slang:slang:spirv": "2024.1.6 2026.14.1"})
      for case in ("enum_constant", "switch_of_constant")),
    Bug(HERE, "contracted_despite_precise", {"slang:slang:spirv": "2024.1.6 2026.14.1", GLSL: "0.14.0 30.0.1"}),
    Bug(HERE, "vector_plus_scalar_in_loop", {WGSL: "0.9.0", ES: "0.9.0"}),
)
# Cases that Mesa 22.3 gets wrong with some valid SPIR-V: a value is computed once more behind its loop.
MESA = {"vector_behind_loop", "do_while", "loop_condition", "loop_initializer", "nested_selections", "three_nested_loops",
        "unary_minus_in_loop", "vector_plus_scalar_in_loop"}


def has(bug: Bug, tool: Tool, form: str) -> bool | None:
    """Whether this version has the bug; None if its way does not show it."""
    if not (ends := bug.versions.get(f"{tool.name}:{form}".rstrip(":"), "").split()):
        return None
    versions = [one.version for one in ALL if one.name == tool.name]
    return versions.index(ends[0]) <= versions.index(tool.version) <= versions.index(ends[-1])


def outcomes(program: str, tool: Tool, form: str, out: Path, *filters: str) -> dict[str, str]:
    """The outcome of each case, by its id; raises Missing if the driver cannot be used."""
    driver, *behind = WAYS[tool.name][form]
    path, environment = tool.path(), dict(os.environ)
    words = [program, "run", "--thorough", "--driver", driver, "--out", str(out)]
    for glob in filters or ("bugs.*",):
        words += ["--filter", glob]
    if tool.name in VARIABLES:
        environment[VARIABLES[tool.name]] = str(path)
    else:
        words += ["--through", f"{tool.name}:{form}={path}"]
    if VKD3D in behind:
        words += ["--through", f"vkd3d={BY_NAME['vkd3d-sid'].path()}"]
    # Dawn finds no device on lavapipe of Debian 12.
    icd = SWIFTSHADER.path() if tool.name == "dawn" else next(DRIVERS.glob("lvp_icd*.json"), "")
    environment["VK_DRIVER_FILES"] = str(icd)
    done = subprocess.run(words, env=environment, capture_output=True, text=True, check=False)
    results = out / "results.json"
    run = json.loads(results.read_text(encoding="utf-8"))["runs"][0] if results.exists() else {"absent": done.stderr}
    if "absent" in run:
        raise Missing(f"{' '.join(words)}: {run['absent']}")
    # A case that fails without a faulty step has found a fault of the driver behind the translator.
    of_translator = {True: "found", False: "driver"}
    return {case["id"]: of_translator["step" in case or tool.name in VARIABLES] if case["status"] in FAULTS else
            "unsupported" if case["status"] == "unsupported" else "right" for case in run["cases"]}


def rows(tool: Tool, form: str, found: Mapping[str, str]) -> Iterator[dict[str, str]]:
    """A row for each bug that the version has or had, and for each that nobody knows."""
    def row(number: str, case: str, outcome: str) -> dict[str, str]:
        way = form.replace(":", " to ") or "its driver"
        return dict(zip(COLUMNS, (number, tool.name, tool.version, way, case, outcome)))

    bugs = [(bug.number, bug.case) for bug in BUGS if has(bug, tool, form) is not None]
    names = {id_.split(".")[1] for id_, outcome in found.items() if outcome == "found"} - MESA
    for number, name in bugs + [("new", name) for name in sorted(names - {case for _, case in bugs})]:
        ids = {outcome: id_ for id_, outcome in found.items() if id_.split(".")[1] == name}
        worst = next((outcome for outcome in ("found", "right", "unsupported") if outcome in ids), "no case")
        yield row(number, ids.get(worst, f"bugs.{name}"), worst)


def is_expected(row: Mapping[str, str], tool: Tool, form: str) -> bool:
    bug = next((one for one in BUGS if (one.number, one.case) == (row["bug"], row["case"].split(".")[1])), None)
    return bug is not None and row["outcome"] == ("found" if has(bug, tool, form) else "right")


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure translators", __doc__)
    parser.add_argument("--tool", action="append", metavar="GLOB", help="of names of translators (all)")
    parser.add_argument("--program", default=hn_conform(), metavar="FILE", help="hn-conform (that on the PATH, or built here)")
    parser.add_argument("--out", type=Path, default=Path("out"), metavar="DIR", help="for translators.csv (out)")
    given = parser.parse_args(arguments)
    tools = [tool for tool in ALL if tool.name in WAYS and any(fnmatch(str(tool), glob) for glob in given.tool or ("*",))]
    if not tools:
        parser.error(f"there is no {given.tool}; there are {', '.join(map(str, ALL))}")
    found, wrong = [], 0
    try:
        for tool in tools:
            for form in WAYS[tool.name]:
                if (str(tool), form) not in WITHOUT:
                    of = outcomes(given.program, tool, form, given.out / f"{tool}-{form.replace(':', '-')}")
                    for row in sorted(rows(tool, form, of), key=lambda row: row["case"]):
                        expected = is_expected(row, tool, form)
                        wrong += not expected
                        print(*row.values(), "" if expected else "(not as published)", flush=True)
                        found.append(row)
    except (Missing, OSError) as why:
        print(f"{parser.prog}: {why}", file=sys.stderr)
        return 4
    stamps.keep(given.out / "translators.csv", found, "lavapipe and llvmpipe of Mesa")
    return 1 if wrong else 0
