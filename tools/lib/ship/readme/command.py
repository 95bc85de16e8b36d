"""Makes the pages' parts from the library: their pictures, the table of typical values, the tables of costs, which
file has which function, the size of all of them in one, and what packages for other programs have.

    tools/make readme            writes them
    tools/make readme --check    whether they are up to date, and the README states the costs

A picture is drawn from the code below it, which the C++ twin evaluates at each pixel of a tile; so are those of
docs/guide/gallery. The typical values are those of 2^16 points. The costs are those of
docs/measured/results/llvmpipe/bench.csv, which hn-conform bench writes, and of peers.csv beside it, which tools/measure
peers writes. Costs on GPUs by their compilers are of docs/measured/results/gpu, by tools/measure gpu, and compile.csv
is by tools/measure compile. How random hashes are is in docs/measured/results/quality.csv, directions.csv and
hashes.csv, by tools/measure hashes, how noises are in judged.csv beside them, by tools/measure noise, and how uniform
values are in uniform.csv, by tools/measure uniform.

Exit status: 0 all is as it should be, 1 something is not: prose is for you to mend; 2 bad usage, the code does not
compile, or a page cannot be read.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Sequence

from base.tree import ROOT
from base.usage import Parser
from catalog.tables.markdown import with_section
from measure import cpu, fills, neon, record, stamps
from measure.compile import command as of_compilers
from measure.gpu import pages as of_gpus
from measure.noise import record as of_noises
from measure.rust import TARGETS
from measure.uniform import command as of_uniform
from ship.blender import files as blender
from ship.isf import files as isf
from ship.materialx import files as materialx
from ship.readme import files, gallery, hashes, numbers, picture
from ship.unity import files as unity
from ship.unreal import files as unreal

README = "README.md"
KNOBS = "docs/reference/knobs.md"
MEASURING = "docs/measured/measuring.md"
DEFAULT_HASH = "docs/measured/default-hash.md"
NOISES = "docs/reference/noises.md"
SUMS = "docs/reference/fractals.md"
LANGUAGES = "docs/guide/languages.md"
ENGINES = "docs/guide/engines.md"
HASHES = "docs/measured/hashes.md"
QUALITY = "docs/measured/quality.md"
JUDGE = "docs/measured/judge.md"
UNIFORM = "docs/guide/uniform.md"
RECORDS = "docs/measured/results/README.md"
SIZE = re.compile(r"(--strip --out noise\.glsl`, )\d+ kB")  # of the whole library, in the README


def tables() -> list[tuple[str, str, str]]:
    """Made parts of pages: the page, the name of the marks, and the table."""
    typical, costs = numbers.typical(), numbers.costs(numbers.CPU)
    return [(NOISES, "tools/make readme: values", numbers.typical_table(typical, numbers.COMMON)),
            (SUMS, "tools/make readme: typical values of sums", numbers.typical_table(typical, numbers.SUMS)),
            (SUMS, "tools/make readme: typical values of sums in 1D and 4D",
             numbers.typical_table(typical, numbers.PLAIN_SUMS, (1, 4))),
            (SUMS, "tools/make readme: footprint", numbers.footprint_quote(numbers.footprint())),
            (LANGUAGES, "tools/make readme: picks", files.picks_table()),
            (LANGUAGES, "tools/make readme: picked in Rust", files.picked_text("hn_lattice2", "rust")),
            (LANGUAGES, "tools/make readme: files", files.files_table()),
            (MEASURING, "tools/make readme: peers",
             numbers.peer_table(numbers.peer_costs(numbers.CPU), numbers.peer_costs(numbers.GPU))
             + "".join(stamps.note(f"{machine}/peers.csv") for machine in (numbers.CPU, numbers.GPU))),
            *((page, f"tools/make readme: {name}", made + stamps.note(of)) for page, name, made, of in (
                (MEASURING, "costs", numbers.cost_table(costs, "spirv", "of SPIR-V"), "llvmpipe/bench.csv"),
                (MEASURING, "costs on a GPU",
                 numbers.cost_table(numbers.costs(numbers.GPU), "nvidia", "of NVIDIA's assembly"), "h100/bench.csv"),
                (MEASURING, "costs by compilers", of_gpus.chip_table(of_gpus.costs()), "gpu/costs.csv"),
                (KNOBS, "costs of arithmetics", of_gpus.arithmetics_quote(of_gpus.costs()), "gpu/costs.csv"),
                (DEFAULT_HASH, "costs of the hash", of_gpus.titled_table(of_gpus.costs(), of_gpus.HASHED),
                 "gpu/costs.csv"),
                (UNIFORM, "uniform", of_uniform.page_table(of_uniform.read()), "uniform.csv"),
                (MEASURING, "noises", numbers.form_table(costs), "llvmpipe/bench.csv"),
                (MEASURING, "compile times", of_compilers.page_table(of_compilers.record()), "llvmpipe/compile.csv"),
                (MEASURING, "packages for Python", numbers.package_table(numbers.package_costs("python")),
                 "cpu/python.csv"),
                *((MEASURING, f"crates on {target}",
                   numbers.package_table([row for row in numbers.package_costs("rust") if row["target"] == target]),
                   "cpu/rust.csv") for target in TARGETS),
                *((MEASURING, f"grids by {title}", cpu.page_table(record.read(fills.RESULTS / name).rows), f"cpu/{name}")
                  for title, name in (("GCC", "gcc.csv"), ("Clang", "clang.csv"))),
                (MEASURING, "NEON", neon.page_table(record.read(fills.RESULTS / "neon.csv").rows), "cpu/neon.csv"),
                (HASHES, "hashes", hashes.pasted_table(hashes.record("hashes.csv")), "hashes.csv"),
                *((QUALITY, name, make(hashes.record(of)), of) for name, make, of in (
                    ("hashes of the library", hashes.hash_table, "quality.csv"),
                    ("controls", hashes.control_table, "quality.csv"),
                    ("looks", hashes.look_table, "directions.csv"),
                    ("traces", hashes.trace_table, "directions.csv"))),
                (JUDGE, "judged", of_noises.judge_table(of_noises.read()), "judged.csv"))),
            (RECORDS, "tools/make readme: records", stamps.records_table()),
            (ENGINES, "tools/make readme: nodes", files.nodes_table()),
            ("packages/blender/README.md", "tools/make readme: nodes", blender.node_table()),
            ("packages/materialx/README.md", "tools/make readme: nodes", materialx.node_table()),
            ("packages/unity/README.md", "tools/make readme: nodes", unity.node_table()),
            ("packages/unreal/README.md", "tools/make readme: nodes", unreal.node_table()),
            ("packages/isf/README.md", "tools/make readme: looks", isf.look_table())]


def problems(check: bool) -> list[str]:
    """Faults, after the tables are written, or with check as they are."""
    found = []
    for path, name, table in tables():
        page = (ROOT / path).read_text(encoding="utf-8")
        right = with_section(path, page, name, table)
        if not check:
            (ROOT / path).write_text(right, encoding="utf-8")
        elif page != right:
            found.append(f"{path}: a table is not what it should be; run tools/make readme")
    readme = (ROOT / README).read_text(encoding="utf-8")
    right = SIZE.sub(rf"\g<1>{files.size('hashnoise.glsl')}", readme)
    if not check:
        (ROOT / README).write_text(right, encoding="utf-8")
    elif right != readme:
        found.append(f"{README}: the size of the single file is not what it should be; run tools/make readme")
    found += [f"{README}: it must state {quote!r}"
              for quote in (*numbers.cost_quotes(), of_compilers.quote(of_compilers.record()),
                            numbers.golden_quote())
              if quote not in readme]
    return found


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make readme", __doc__)
    parser.add_argument("--check", action="store_true", help="write nothing")
    options = parser.parse_args(arguments)
    try:
        found = problems(options.check)
        for problem in found:
            print(problem, file=sys.stderr)
        sheets = [*picture.of_pages(), *gallery.sheets()]
        return picture.draw(sheets, options.check, gallery.functions()) or bool(found)
    except (OSError, LookupError, ValueError) as error:
        parser.exit(2, f"tools/make readme: {error}\n")


if __name__ == "__main__":
    sys.exit(main())
