"""The tables of pages that are made from records of measurements, and the README's sentences on costs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from catalog.tables.markdown import table
from measure import cpu, fills, record, stamps
from measure.gpu import pages as of_gpus
from measure.hashes import tables as hashes
from measure.noise import record as of_noises
from measure.peers import CALLS, PEERS, dimensions, subject
from measure.rust import TARGETS
from measure.stamps import RESULTS
from measure.uniform import command as of_uniform

CPU, GPU = "llvmpipe", "h100"  # the renderers in RESULTS that pages name
Costs = Mapping[str, Mapping[str, str]]  # the rows of bench.csv, by id
KNOBS = "docs/reference/knobs.md"
MEASURING = "docs/measured/measuring.md"
DEFAULT_HASH = "docs/measured/default-hash.md"
HASHES = "docs/measured/hashes.md"
QUALITY = "docs/measured/quality.md"
JUDGE = "docs/measured/judge.md"
UNIFORM = "docs/guide/uniform.md"
RECORDS = "docs/measured/results/README.md"

NOISES = {  # in the table, by the end of its ids
    "table.float": "Perlin/Float (`table.float`)",
    "table.integer": "Perlin/Integer (`table.integer`)",
    "lattice": "`lattice`, the default",
    "fnv1+sine": "`fnv1+sine`, the paper's",
}
ROWS = ("table.float", "table.integer", "lattice", "lattice+precise", "lattice+fixed", "partial_fnv1", "murmur",
        "partial_jenkins", "fnv1", "jenkins", "fnv1+sine")
FORMS = ("perlin", "perlin_cell", "perlin_period", "perlin_d", "perlin_phase", "value", "value_d", "value_cubic", "simplex",
         "simplex_d", "simplex_phase", "simplex_d_phase", "simplex_smooth", "cellular", "cellular_nearest",
         "cellular_three", "cellular_d", "cellular_smooth", "cell_border")


def costs(renderer: str, file: str = "bench.csv") -> Costs:
    return {row["id"]: row for row in record.read(RESULTS / renderer / file).rows}


def peer_costs(renderer: str) -> Costs:
    return costs(renderer, "peers.csv")


def ids(noise: str) -> list[str]:
    """In 2D and in 3D."""
    return [f"{noise}{n}" if noise.startswith("table.") else f"noise{n}d.perlin.{noise}" for n in (2, 3)]


def cost_table(rows: Costs, *counts: str) -> str:
    """The ratios, and the columns of bench.csv that are named."""
    lines = [[NOISES.get(noise, f"`{noise}`"), *(f"{float(rows[id]['ratio']):.2f}" for id in ids(noise)),
              *(rows[id][count] for count in counts for id in ids(noise))] for noise in ROWS]
    return table(("noise", "2D", "3D", *["instructions of SPIR-V, 2D", "3D"] * len(counts)), lines)


def form_table(rows: Costs) -> str:
    """The cost of each noise, by its dimensions: with floats / fixed."""
    def cell(form: str, axes: int) -> str:
        ids = [f"noise{axes}d.{form}.lattice{arithmetic}" for arithmetic in ("", "+fixed")]
        return " / ".join(_cost(rows[id]) for id in ids if id in rows)

    return table(("noise", "1D", "2D", "3D", "4D"),
                 [[f"`hn_{form}`", *(cell(form, axes) for axes in range(1, 5))] for form in FORMS])


def peer_table(*machines: Costs) -> str:
    """Ours beside other libraries', from the peers.csv of each machine."""
    def cell(id: str) -> str:
        return ", ".join(_cost(rows[id]) for rows in machines)

    lines = []
    for noise in dict.fromkeys(call.noise for call in CALLS):
        calls = {call.peer: call for call in CALLS if call.noise == noise}
        ours = next(iter(calls.values())).ours
        lines.append([noise, cell(f"{ours}.lattice"),
                      *(cell(f"{subject(calls[peer.option])}{dimensions(calls[peer.option])}")
                        if peer.option in calls else "" for peer in PEERS)])
    return table(("noise", "hashnoise", *(peer.title for peer in PEERS)), lines)


def _cost(row: Mapping[str, str]) -> str:
    return f"{float(row['ratio']):.2f}"


def quotes() -> list[str]:
    """The README's sentences on costs by a clock: on the GPU, all by one table, and of packages for Python."""
    rows = peer_costs(GPU)
    one, six = (_of_theirs(rows, noise) for noise in ("Perlin 2D", "fBm 2D, 6 octaves"))
    of = (stamps.read(RESULTS / name).facts["hashnoise"].split()[0] for name in (f"{GPU}/peers.csv", "cpu/python.csv"))
    others = [float(row["ratio"]) for row in package_costs("python")
              if row["noise"] == "six octaves of Perlin 2D" and not row["package"].startswith(("hashnoise", "gathered"))]
    return [f"in 2D takes {one:.2f} times as long as FastNoiseLite's, and fBm of six octaves {six:.2f} times",
            f"take {min(others):.0f} to {max(others):.0f} times as long as ours",
            f"measured with {' and '.join(dict.fromkeys(of))}"]


def package_costs(language: str) -> list[dict[str, str]]:
    """The rows of python.csv or rust.csv."""
    return record.read(RESULTS / "cpu" / f"{language}.csv").rows


def package_table(rows: Sequence[Mapping[str, str]]) -> str:
    """A row for each package, a column for each noise: nanoseconds, and the time in ours."""
    noises = dict.fromkeys(row["noise"] for row in rows)
    found = {(row["package"], row["noise"]): f"{row['nanoseconds']} · {_two_digits(float(row['ratio']))}" for row in rows}
    packages = dict.fromkeys((row["package"], row["version"]) for row in rows)
    return table(("package", *noises), [[f"{package} {version}", *(found.get((package, noise), "") for noise in noises)]
                                        for package, version in packages])


def _two_digits(ratio: float) -> str:
    return f"{ratio:.0f}" if ratio >= 10 else f"{ratio:.2g}"


def _of_theirs(rows: Costs, noise: str) -> float:
    """The cost of our noise, in FastNoiseLite's."""
    [call] = [call for call in CALLS if (call.noise, call.peer) == (noise, "fastnoiselite")]
    return float(rows[f"{call.ours}.lattice"]["ratio"]) / float(rows[f"{subject(call)}{dimensions(call)}"]["ratio"])


# --- Pages ------------------------------------------------------------------------------------------------------------


def tables() -> Iterator[tuple[str, str, str]]:
    """Made parts of pages: the page, the name of the marks, and the table."""
    rows = costs(CPU)
    yield from ((page, f"tools/make pages: {name}", made + stamps.note(of)) for page, name, made, of in (
        (MEASURING, "costs", cost_table(rows, "spirv"), "llvmpipe/bench.csv"),
        (MEASURING, "costs on a GPU", cost_table(costs(GPU)), "h100/bench.csv"),
        (MEASURING, "costs by compilers", of_gpus.chip_table(of_gpus.costs()), "gpu/costs.csv"),
        (KNOBS, "costs of arithmetics", of_gpus.arithmetics_quote(of_gpus.costs()), "gpu/costs.csv"),
        (DEFAULT_HASH, "costs of the hash", of_gpus.titled_table(of_gpus.costs(), of_gpus.HASHED),
         "gpu/costs.csv"),
        (UNIFORM, "uniform", of_uniform.page_table(of_uniform.read()), "uniform.csv"),
        (MEASURING, "noises", form_table(rows), "llvmpipe/bench.csv"),
        (MEASURING, "packages for Python", package_table(package_costs("python")),
         "cpu/python.csv"),
        *((MEASURING, f"crates on {target}",
           package_table([row for row in package_costs("rust") if row["target"] == target]),
           "cpu/rust.csv") for target in TARGETS),
        *((MEASURING, f"grids by {title}", cpu.page_table(record.read(fills.RESULTS / name).rows), f"cpu/{name}")
          for title, name in (("GCC", "gcc.csv"), ("Clang", "clang.csv"))),
        (HASHES, "hashes", hashes.pasted_table(hashes.record("hashes.csv")), "hashes.csv"),
        *((QUALITY, name, make(hashes.record(of)), of) for name, make, of in (
            ("hashes of the library", hashes.hash_table, "quality.csv"),
            ("controls", hashes.control_table, "quality.csv"),
            ("looks", hashes.look_table, "directions.csv"),
            ("traces", hashes.trace_table, "directions.csv"))),
        (JUDGE, "judged", of_noises.judge_table(of_noises.read()), "judged.csv")))
    notes = "".join(stamps.note(f"{machine}/peers.csv") for machine in (CPU, GPU))
    yield MEASURING, "tools/make pages: peers", peer_table(peer_costs(CPU), peer_costs(GPU)) + notes
    yield RECORDS, "tools/make pages: records", stamps.records_table()
