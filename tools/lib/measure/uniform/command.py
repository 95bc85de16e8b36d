"""The command line of tools/measure uniform, which describes it, and the table of docs/guide/uniform.md."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from base.tree import GLSL, ROOT
from base.twin import COMPILER, NotBuilt
from base.usage import Parser
from base.versions import version_of
from catalog.tables.markdown import table, with_section
from catalog.tables.marks import between
from measure import record, stamps

DESCRIPTION = """\
Measures how uniform the results of hn_uniform are, for every noise and for sums of octaves, or fits its constants.

    tools/measure uniform [--points N] [--out FILE]    measures; docs/measured/results/uniform.csv is such a file, of 10^7 points
                                                       a row, and tools/make pages makes of it the table of
                                                       docs/guide/uniform.md
    tools/measure uniform --fit [--points N]           fits the distribution of each noise, and writes them into uniform.glsl
                                                       and the contract. The bell that sums come near to stays

Each point is at a random cell and fraction, with a random seed. The error of a noise is the largest difference between
the share of results below u and u itself, over all u (Kolmogorov's distance). Chance alone adds about 0.9 / sqrt(N).

Exit status: 0 done, 1 an error is above the bound that docs/guide/uniform.md states, 2 bad usage, 4 it could not be built."""

RECORD = ROOT / "docs" / "measured" / "results" / "uniform.csv"
CONTRACT = ROOT / "docs" / "reference" / "contract.md"
GAIN = 0.5
SUMS = (*((octaves, GAIN) for octaves in range(1, 9)),
        (2.0, 0.7), (5.0, 0.7), (2.0, 1.0), (3.0, 0.3), (3.5, GAIN), (8.0, 0.8))
# The aim; and what the line reaches. There nothing turns, so that the octaves of a sum depend on each other: near
# lattice points of the first all others have the same fractions. And the density of Perlin noise is infinite at 0.
BOUND = 0.005
LINE_BOUNDS = {"PERLIN1": 0.015}


class Row(NamedTuple):
    noise: str
    octaves: float
    gain: float
    points: int
    error: float


def bound_of(row: Row) -> float:
    return LINE_BOUNDS.get(row.noise, BOUND)


def too_large(rows: Sequence[Row]) -> list[str]:
    return [f"{row.noise}, {row.octaves:g} octaves with a gain of {row.gain:g}: the error is {row.error:.4f}, and the "
            f"bound {bound_of(row)}" for row in rows if row.error > bound_of(row)]


def read(path: Path = RECORD) -> list[Row]:
    found = []
    for number, row in enumerate(record.read(path, Row._fields, "tools/measure uniform").rows, 2):
        try:
            found.append(Row(row["noise"], float(row["octaves"]), float(row["gain"]), int(row["points"]),
                             float(row["error"])))
        except (TypeError, ValueError) as problem:
            raise ValueError(f"{path}:{number}: {problem}; a row has {', '.join(Row._fields)}") from problem
    return found


def write(path: Path, rows: Sequence[Row]) -> None:
    record.write(path, ({**row._asdict(), "octaves": f"{row.octaves:g}", "gain": f"{row.gain:g}",
                         "error": f"{row.error:.5f}"} for row in rows))


def page_table(rows: Sequence[Row]) -> str:
    """The largest errors of each noise, in percent."""
    def percent(*errors: float) -> str:
        return f"{100 * max(errors):.2f}%"

    lines = []
    for noise in dict.fromkeys(row.noise for row in rows):
        own = [row for row in rows if row.noise == noise]
        single = [row.error for row in own if row.octaves == 1]
        usual = [row.error for row in own if row.octaves > 1 and row.gain == GAIN]
        other = [row.error for row in own if row.octaves > 1 and row.gain != GAIN]
        lines.append((f"`HN_DISTRIBUTION_{noise}`", percent(*single), percent(*usual), percent(*other)))
    return table(("noise", "one octave", "2 to 8 octaves, gain 0.5", "gains of 0.3 to 1"), lines)


def with_spreads(text: str, spreads: dict[str, tuple[int, ...]]) -> str:
    """uniform.glsl with other spreads, in units of 1/4096."""
    from measure.uniform.model import SUBJECTS

    others = [subject.name for subject in SUBJECTS if subject.name != "PERLIN2"]

    def made(name: str) -> str:
        return f"return hn_i_distribution({', '.join(map(str, spreads[name]))});\n"

    end = "// tools/measure uniform: end"
    numbers = "".join(f"#define HN_DISTRIBUTION_{subject.name} {subject.number}\n" for subject in SUBJECTS)
    rows = [f"  if (kind == HN_DISTRIBUTION_{name}) {made(name)}" for name in others] + [f"  {made('PERLIN2')}"]
    text = between("uniform.glsl", text, "// tools/measure uniform: numbers", end, numbers)
    return between("uniform.glsl", text, "// tools/measure uniform: distributions", end, "".join(rows))


def contract_table(spreads: dict[str, tuple[int, ...]]) -> str:
    from measure.uniform.model import SUBJECTS

    return table(("noise", "number", "name", "reach", "a", "b", "c"),
                 [(subject.title, str(subject.number), f"`HN_DISTRIBUTION_{subject.name}`", *map(str, spreads[subject.name]))
                  for subject in SUBJECTS])


def in_units(text: str) -> dict[str, tuple[int, ...]]:
    from measure.uniform.model import UNITS, spreads_of

    found = spreads_of(text)
    return {name: tuple(round(number * UNITS) for number in spread) for name, spread in found.items()}


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure uniform", DESCRIPTION)
    parser.add_argument("--points", type=int, default=10**7, metavar="N", help="of each noise and sum (10^7)")
    parser.add_argument("--out", type=Path, default=RECORD, metavar="FILE", help="where the measurement goes")
    parser.add_argument("--fit", action="store_true", help="fit the distributions, and write them")
    options = parser.parse_args(arguments)
    if options.points < 1000:
        parser.error(f"--points {options.points}: a distribution takes 1000 points at least")
    if not options.out.parent.is_dir():
        parser.error(f"--out {options.out}: there is no folder {options.out.parent}")

    # The rest needs numpy, and tools/make pages, which makes the table, does without.
    from measure.uniform import model

    text = model.library_text()
    try:
        bell = model.Bell.of(text)
        with TemporaryDirectory() as folder:
            sampler = model.Sampler(Path(folder))
            if not options.fit:
                errors = sampler.errors(options.points, model.spreads_of(text), SUMS)
                by_name = [subject.name for subject in model.SUBJECTS]
                rows = sorted((Row(*key, options.points, error) for key, error in errors.items()),
                              key=lambda row: (by_name.index(row.noise), row.octaves, row.gain))
                write(options.out, rows)
                stamps.stamp(options.out, version_of(COMPILER[0]), kind=RECORD.name)
                problems = too_large(rows)
                print("\n".join(problems) if problems else page_table(rows), end="\n" if problems else "")
                return bool(problems)
            densities = sampler.densities(options.points)
    except NotBuilt as error:
        parser.exit(4, f"{parser.prog}: {error}\n")
    except ValueError as error:
        parser.error(str(error))

    from measure.uniform import fit

    spreads = {name: tuple(round(number * model.UNITS) for number in spread)
               for name, spread in fit.spreads(densities, bell).items()}
    (GLSL / "uniform.glsl").write_text(with_spreads(text, spreads), encoding="utf-8")
    page = CONTRACT.read_text(encoding="utf-8")
    section = with_section("docs/reference/contract.md", page, "tools/measure uniform: contract", contract_table(spreads))
    CONTRACT.write_text(section, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
