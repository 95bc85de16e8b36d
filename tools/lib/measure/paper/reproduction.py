"""Makes a page of what hn-conform paper measures, beside the numbers that the paper prints.

paper.sh describes the options, which are those of hn-conform paper. With --dump the values that it writes are kept."""

from __future__ import annotations

import argparse
import shutil
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from scipy import stats

from base.png import png
from base.tree import CONFORMANCE, HN_CONFORM
from base.usage import Parser
from measure import conform, page, record, stamps
from measure.page import Section
from measure.record import Record

PRINTED = record.read(CONFORMANCE / "paper" / "printed.csv").rows
SIZES = ("800x600", "1024x768")
RECORDS = ("table", "values", "period", "bandwidth")
FORMS = ("as intended", "as published", "ours")
PICTURES = ("noise", "turbulence", "clouds")
# The sine gradient in space may go up to 3/2; bins of 1/32.
LOW, HIGH, BINS = -1.5, 1.5, 96
FEWEST = 20  # in a bin of two histograms together: chi-square is an approximation for many
HASHES = (("Perlin/FNV1", "Perlin/PartialFNV1"), ("Perlin/Jenkins", "Perlin/PartialJenkins"))
MISSING = "It could not be measured."
INTRODUCTION = """This page computes and measures again, on this driver, the results of "Implementing Noise with Hash
functions for Graphics Processing Units" (Valdenegro-Toro and Pincheira), beside the numbers that the paper prints. Each
hash has three forms. As published is the listing as printed: its arithmetic is of int, with shifts that extend the sign, it takes the sin
of whatever integer comes, which GLSL lets every driver evaluate as it likes, and the mask of the highest byte in its FNV1,
-2130706432, takes 2 of the 8 bits that -16777216 would. Around it is Perlin's noise of 2002 with the period of 2^20 cells
that the paper describes. As intended is the library with HN_GRADIENT_SINE and a period of 1048576 cells. Ours is the
library's own gradient with the same hash, spread and mixed."""
TABLE = """A triangle over the whole picture (the paper: a textured quad) is drawn with one evaluation of the noise for each
pixel, over {cells} x {cells} cells. Times are medians of interleaved rounds. A ratio is to Perlin/Float in the same rounds,
after the time of an empty shader is taken off both, with half the distance between its quartiles; the paper's ratios are
quotients of its times. Instructions are those of the whole fragment shader: SPIR-V after spirv-opt -O. The paper's were of
NVIDIA's Cg compiler, its times of a GeForce 8400M GS. The paper concludes that only Perlin/PartialFNV1 and
Perlin/PartialJenkins are close enough to Perlin/Float, and Perlin/Integer is its slowest."""
FIGURE = """Noise over {0} x {0} cells, from -1 (black) to 1 (white); turbulence and clouds of 6 octaves over {1} x {1}
cells, turbulence from 0 to 1/2, since most of it is below, and clouds from 0 to 1. The paper gives no formula for the latter
two: they are hn_turbulence and hn_clouds over the noise in question. The rows are {2}."""
STATISTICS = """The paper claims numbers in [-1, 1] with an average of 0, distributions that are Gaussian-like, and that
partial hashes have the same as full ones. Each row is of 2^20 values, no two from neighbouring cells. 2D: {2D}. 3D: {3D}.
The normality test is D'Agostino and Pearson's: p is the probability of so large a deviation in skewness and kurtosis if the
values were normal. Zeros is the share of values that are exactly 0, which should be none."""
PARTIAL = """Chi-square of two histograms: p is the probability of so large a difference between two samples of the same
distribution."""
PERIOD = """The paper limits the period to 2^20 cells. Differing: of {points} values, how many differ in a bit from the value
a period further on, along all axes together. Shortest repeats: of the values in all cells of a period along an axis, the
smallest distance after which all of them repeat. It should be the period."""
MEMORY = """Each pixel also fetches up to {most} texels from a texture of {texture}, none of them twice. Where the arithmetic
of a noise hides behind the fetches, its time is the same at first, and bends where the line through the last three points
meets the time without fetches. Left is how much of the time that the noise takes alone is left with {most} fetches. On a
software driver the same cores fetch and compute, so little hides."""
Row = Mapping[str, str]


# --- The table --------------------------------------------------------------------------------------------------------


def printed(algorithm: str, dimensions: str) -> Row | None:
    return next((row for row in PRINTED if (row["algorithm"], row["dimensions"]) == (algorithm, dimensions)), None)


def printed_ratio(algorithm: str, dimensions: str, size: str) -> float:
    return float(printed(algorithm, dimensions)[f"ms_{size}"]) / float(printed("Perlin/Float", dimensions)[f"ms_{size}"])


def cells(row: Row, sources: Sequence[str]) -> list[str]:
    """Each of ours with the paper's behind it."""
    paper = printed(row["algorithm"], row["dimensions"])
    found = [*(row[source] for source in sources), f"~{paper['instructions']}" if paper else "not in it"]
    for size in SIZES:
        time, ratio, spread = (record.number(row[f"{name}_{size}"]) for name in ("ms", "ratio", "spread"))
        found += ["failed" if time is None else record.three_digits(time),
                  f"{float(paper[f'ms_{size}']):.1f}" if paper else "not in it",
                  "failed" if time is None else "cannot be told" if ratio != ratio else str(record.Quantity(ratio, spread)),
                  f"{printed_ratio(row['algorithm'], row['dimensions'], size):.2f}" if paper else "not in it"]
    return found


def table(of: Record, out: Path) -> list[Section]:
    heads = list(of.rows[0])
    sources = heads[4:heads.index("ms_800x600")]
    shown = [f"{what}{size}" for size in SIZES for what in ("ms at ", "paper, ", "ratio at ", "paper, ")]
    return [Section(f"Instructions and render times in {n}D", TABLE.format(**of.facts),
                    ("algorithm", "form", *sources, "paper", *shown),
                    [(row["algorithm"], row["form"], *cells(row, sources)) for row in of.rows if row["dimensions"] == n],
                    "table dense") for n in "23"]


# --- The figure -------------------------------------------------------------------------------------------------------


def greys(values: np.ndarray, what: str) -> np.ndarray:
    """Noise from -1 black to 1 white; turbulence from 0 to 1/2, since most of it is below; clouds from 0 to 1. A value
    that is no number is black."""
    levels = {"noise": 0.5 + 0.5 * values, "turbulence": 2 * values, "clouds": values}[what]
    return np.rint(np.clip(np.nan_to_num(levels), 0.0, 1.0) * 255).astype(np.uint8)


def write_picture(path: Path, pixels: np.ndarray) -> None:
    path.write_bytes(png(pixels.shape[1], pixels.shape[0], np.repeat(pixels[..., None], 3, -1).tobytes()))


def figures(of: Record, out: Path) -> Section:
    side = int(of.facts["side"])
    files = {(row["algorithm"], row["form"], row["what"]): out / row["file"] for row in of.rows if not row["problem"]}
    in_figure = dict.fromkeys(row["algorithm"] for row in of.rows if row["what"] in PICTURES)
    sheets = []
    for form in FORMS:
        rows = []
        for algorithm in in_figure:
            whose = "tables in textures" if algorithm == "Perlin/Float" else form
            row = [greys(np.fromfile(files[algorithm, whose, what], "<f4").reshape(side, side), what)
                   if (algorithm, whose, what) in files else np.zeros((side, side), np.uint8) for what in PICTURES]
            rows.append(np.hstack(row))
        sheets.append((form, f"{form.replace(' ', '-')}.png"))
        write_picture(out / sheets[-1][1], np.vstack(rows))
    return Section("Noise, turbulence, clouds", FIGURE.format(of.facts["cells of noise"], of.facts["cells of sums"],
                                                              ", ".join(in_figure)), pictures=sheets)


# --- Statistics -------------------------------------------------------------------------------------------------------


class Sample(NamedTuple):
    algorithm: str
    form: str
    dimensions: str
    minimum: float
    maximum: float
    mean: float
    variance: float
    skewness: float
    excess_kurtosis: float
    normality_statistic: float
    normality_log10_p: float
    zeros: float  # the share of values that are exactly 0

    def title(self) -> str:
        return f"{self.algorithm}, {self.form}, {self.dimensions}D"

    def cells(self) -> list[str]:
        p = 10 ** self.normality_log10_p if self.normality_log10_p >= -6 else 0.0
        return [f"{self.minimum:.4f} to {self.maximum:.4f}",
                "yes" if self.minimum >= -1 and self.maximum <= 1 else "no", f"{self.mean:.1e}", f"{self.variance:.4f}",
                f"{self.skewness:.3f}", f"{self.excess_kurtosis:.3f}",
                f"{p:.2g}" if p else f"1e{self.normality_log10_p:.0f}", f"{100 * self.zeros:.1f} %"]


def sample(row: Row, values: np.ndarray) -> Sample:
    values = values.astype(float)
    test = stats.normaltest(values).statistic
    # With two degrees of freedom p is exp(-statistic / 2), which the other way rounds to 0.
    return Sample(row["algorithm"], row["form"], row["dimensions"], values.min(), values.max(), values.mean(), values.var(),
                  stats.skew(values), stats.kurtosis(values), test, -0.5 * test / np.log(10), np.mean(values == 0.0))


def chi_square(a: np.ndarray, b: np.ndarray) -> tuple[float, int, float]:
    """Of the hypothesis that two histograms of as many values are of the same distribution: the statistic, the degrees
    of freedom and the probability of so large a difference."""
    both = a + b >= FEWEST
    statistic = float((((a - b) ** 2)[both] / (a + b)[both]).sum())
    degrees = int(both.sum()) - 1
    return statistic, degrees, float(stats.chi2.sf(statistic, degrees))


def values(of: Record, out: Path) -> list[Section]:
    samples, histograms = [], {}
    for row in of.rows:
        if row["what"] == "statistics" and not row["problem"]:
            found = np.fromfile(out / row["file"], "<f4")
            samples.append(sample(row, found))
            histograms[samples[-1][:3]] = np.histogram(found, BINS, (LOW, HIGH))[0]
    record.write(out / "statistics.csv", [one._asdict() for one in samples], Sample._fields, of.facts)
    by_key = {one[:3]: one for one in samples}
    partials = []
    for full, partial in HASHES:
        for form in FORMS:
            for n in "23":
                pair = [(name, form, n) for name in (full, partial)]
                if all(key in by_key for key in pair):
                    statistic, degrees, p = chi_square(*(histograms[key] for key in pair))
                    deviations = " and ".join(f"{by_key[key].variance ** 0.5:.4f}" for key in pair)
                    partials.append((*(by_key[key].title() for key in pair), deviations, f"{statistic:.0f}", degrees,
                                     f"{p:.2g}" if p else "below 1e-300"))
    return [figures(of, out),
            Section("Statistics", STATISTICS.format(**of.facts),
                    ("sample", "range", "within [-1, 1]", "mean", "variance", "skewness", "excess kurtosis", "normality p",
                     "zeros"), [(one.title(), *one.cells()) for one in samples], "table dense"),
            Section("Partial against full", PARTIAL,
                    ("full", "partial", "standard deviations", "chi-square", "degrees", "p"), partials)]


# --- The rest ---------------------------------------------------------------------------------------------------------


def bend(fetches: Sequence[int], times: Sequence[float]) -> tuple[float, float]:
    """Of a line through the last three points: milliseconds a fetch, and where it meets the time without fetches."""
    each = (times[-1] - times[-3]) / (fetches[-1] - fetches[-3])
    return each, max((times[0] - (times[-1] - each * fetches[-1])) / each, 0.0) if each > 0 else 0.0


def bandwidth(of: Record, out: Path) -> list[Section]:
    most = max((int(row["fetches"]) for row in of.rows), default=0)
    text = MEMORY.format(most=most, texture=of.facts["texture"])
    text += f" Not measured: {of.facts['not measured']}" if "not measured" in of.facts else ""
    sweeps = []
    for n in "23":
        curves: dict[str, tuple[list[int], list[float]]] = {}
        for row in of.rows:
            if row["dimensions"] == n:
                fetches, times = curves.setdefault(row["noise"], ([], []))
                fetches.append(int(row["fetches"]))
                times.append(float(row["milliseconds"]))
        alone, rows = next(iter(curves.values()), ([], [0.0]))[1], []
        for name, (fetches, times) in curves.items():
            each, at = bend(fetches, times)
            own = times[0] - alone[0]
            left = f"{100 * (times[-1] - alone[-1]) / own:.0f} %" if own > 0 else "no noise"
            rows.append((name, record.three_digits(times[0]), record.three_digits(each), f"{at:.1f}", left))
        sweeps.append(Section(f"Limited by memory, {n}D", text,
                              ("noise", "ms without fetches", "ms per fetch", "bends at", "left"), rows))
    return sweeps


def period(of: Record, out: Path) -> list[Section]:
    heads = ("algorithm", "form", "dimensions", "period", "differing_values", *(f"shortest_repeat_{axis}" for axis in "xyz"),
             "verdict")
    return [Section("Period", PERIOD.format(**of.facts), [head.replace("_", " ") for head in heads],
                    [[row[head] for head in heads] for row in of.rows])]


def write_page(out: Path) -> None:
    records = {name: record.read(out / f"{name}.csv") for name in RECORDS if (out / f"{name}.csv").is_file()}
    sections = [Section("The paper", INTRODUCTION)]
    for name, make in (("table", table), ("values", values), ("period", period), ("bandwidth", bandwidth)):
        sections += make(records[name], out) if name in records else [Section(name.capitalize(), MISSING)]
    problems = [(row.get("id") or f"{row['algorithm']}, {row['form']}, {row['dimensions']}D", row["problem"])
                for of in records.values() for row in of.rows if row.get("problem")]
    facts = next(iter(records.values())).facts
    page.write(out / "index.html", Path(page.__file__).with_name("tables.html"), sections=sections, problems=problems,
               title="Noise from hash functions, reproduced",
               facts={name: facts[name] for name in ("driver", "renderer", "OpenGL", "GLSL", "date", "command", "library",
                                                     "clock", "rounds")})


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure paper", __doc__)
    parser.add_argument("--out", type=Path, default=Path("out"))
    parser.add_argument("--dump", action="store_true")
    options, others = argparse.ArgumentParser.parse_known_args(parser, arguments)
    out = options.out
    status = conform.run([str(HN_CONFORM), "paper", "--out", str(out), "--dump", *others])
    if status not in (0, 1) or not any((out / f"{name}.csv").is_file() for name in RECORDS):
        return status
    write_page(out)
    for name in ("table", "statistics", "period", "bandwidth"):
        if (out / f"{name}.csv").is_file():
            stamps.stamp(out / f"{name}.csv", library=conform.library(others))
    if not options.dump:
        for folder in ("values", "spirv"):
            shutil.rmtree(out / folder, ignore_errors=True)
    print(out / "index.html")
    return status


if __name__ == "__main__":
    sys.exit(main())
