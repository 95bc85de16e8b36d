"""The numbers that pages state of the library: typical values, and costs."""

from __future__ import annotations

import functools
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import catalog.model
from base.tree import GOLDEN
from base.twin import SOON, compile_program
from catalog.tables.markdown import table
from measure import record, stamps
from measure.peers import CALLS, PEERS, dimensions, subject
from measure.stamps import RESULTS

CPU, GPU = "llvmpipe", "h100"  # the renderers in RESULTS that pages name
Costs = Mapping[str, Mapping[str, str]]  # the rows of bench.csv, by id

# --- Typical values ---------------------------------------------------------------------------------------------------

CATALOG = catalog.model.read()
SUMS = tuple(f"hn_{sum_.name}" for sum_ in CATALOG.sums if sum_.shape != "slopes" and sum_.is_in(2))
PLAIN_SUMS = tuple(f"hn_{sum_.name}" for sum_ in CATALOG.sums if sum_.is_of_values)
COMMON = ("hn_perlin", "hn_value", "hn_value_cubic", "hn_simplex", "hn_simplex_smooth", "hn_fbm")


def lines_of(source: str) -> list[list[str]]:
    """The words of each line that a program beside this file prints."""
    with TemporaryDirectory() as folder:
        program = Path(folder) / "program"
        compile_program(source, Path(__file__).with_name(source), program, SOON)
        output = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    return [line.split() for line in output.splitlines()]


@functools.cache
def typical() -> dict[tuple[str, int], list[float]]:
    """Mean, deviation, 1st and 99th percentile, by function and number of axes."""
    return {(name, int(axes)): [float(value) for value in values] for name, axes, *values in lines_of("typical.cpp")}


def typical_table(values: Mapping[tuple[str, int], list[float]], names: Sequence[str],
                  dimensions: Sequence[int] = (2, 3)) -> str:
    def cells(mean: float, deviation: float, low: float, high: float) -> list[str]:
        return [f"{_number(mean)} ± {_number(deviation)}", f"{_number(low)} to {_number(high)}"]

    rows = [[f"`{name}`", *(cell for axes in dimensions for cell in cells(*values[name, axes]))] for name in names]
    heads = (head for axes in dimensions for head in (f"{axes}D: mean ± deviation", "98 of 100 values"))
    return table(("", *heads), rows)


def _number(value: float) -> str:
    """With two digits after the point, and no more than it has."""
    return f"{round(value, 2) + 0.0:g}"


# --- The gain of a footprint ------------------------------------------------------------------------------------------


@functools.cache
def footprint() -> dict[str, float]:
    """How far pixels of a receding plane are from the mean of many places in them, by the way they are computed."""
    return {name: float(value) for name, value in lines_of("footprint.cpp")}


def footprint_quote(errors: Mapping[str, float]) -> str:
    return ("Against the mean of 16 by 16 places in each pixel of the picture's far half, the error (root mean square) is "
            f"{errors['with']:.3f} with the footprint and {errors['without']:.3f} without; the deviation of the noise is "
            f"{errors['deviation']:.2f}.\n")


# --- Costs ------------------------------------------------------------------------------------------------------------

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


def cost_table(rows: Costs, count: str, whose: str) -> str:
    """The ratios, and the instructions of a column of bench.csv."""
    lines = [[NOISES.get(noise, f"`{noise}`"), *(f"{float(rows[id]['ratio']):.2f}" for id in ids(noise)),
              *(rows[id][count] for id in ids(noise))] for noise in ROWS]
    return table(("noise", "2D", "3D", f"instructions {whose}, 2D", "3D"), lines)


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


def cost_quotes() -> list[str]:
    """The README's sentences on costs by a clock: on the GPU, all by one table, and of packages for Python."""
    rows = peer_costs(GPU)
    one, six = ([_of_theirs(rows, noise.format(axes)) for axes in (2, 3)] for noise in ("Perlin {}D", "fBm {}D, 6 octaves"))
    of = (stamps.read(RESULTS / name).facts["hashnoise"].split()[0] for name in (f"{GPU}/peers.csv", "cpu/python.csv"))
    others = [float(row["ratio"]) for row in package_costs("python")
              if row["noise"].startswith("six octaves") and row["package"] != "hashnoise"]
    return [f"as much as FastNoiseLite's ({one[0]:.2f} times in 2D, {one[1]:.2f} in 3D), and six octaves a quarter "
            f"({six[0]:.2f} and {six[1]:.2f})",
            f"take {min(others):.0f} to {max(others):.0f} times as long",
            f"measured with {' and '.join(dict.fromkeys(of))}"]


def golden_quote() -> str:
    """The README's number of golden values, rounded down to ten thousands."""
    found = sum(len(group.split()) for path in GOLDEN.glob("*.golden") for row in path.read_text(encoding="ascii").splitlines()
                for group in row.split(" = ")[1:] if group != "-" and not row.startswith("columns "))
    return f"computes {found // 10_000 * 10_000:,} golden values"


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
