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
from measure.paper import plots
from measure.record import Record

PRINTED = record.read(CONFORMANCE / "paper" / "printed.csv").rows
SIZES = ("800x600", "1024x768")
SECTIONS = ("table", "values", "period", "bandwidth")
SHEETS = {"as intended": "As intended", "as published": "As published, on this driver",
          "ours": "Ours, with the same hashes"}
PICTURES = ("noise", "turbulence", "clouds")
# The sine gradient in space may go up to 3/2; bins of 1/32.
LOW, HIGH, BINS = -1.5, 1.5, 96
FEWEST = 20  # in a bin of two histograms together: chi-square is an approximation for many
HASHES = (("Perlin/FNV1", "Perlin/PartialFNV1"), ("Perlin/Jenkins", "Perlin/PartialJenkins"))
SOFTWARE = ("llvmpipe", "softpipe", "SwiftShader", "lavapipe")
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


def claims(rows: Sequence[Row]) -> list[str]:
    """The paper's conclusions from its table, beside what this run found."""
    def ratios(algorithm: str, form: str) -> str:
        return ", ".join(f"{row['dimensions']}D {float(row['ratio_800x600']):.2f} (paper "
                         f"{printed_ratio(algorithm, row['dimensions'], '800x600'):.2f})" for row in rows
                         if (row["algorithm"], row["form"]) == (algorithm, form) and row["ratio_800x600"] != "failed")

    def differences(dimensions: str) -> str:
        return ", ".join(
            f"{row['algorithm']} {int(row['spirv']) - int(printed(row['algorithm'], dimensions)['instructions']):+d}"
            for row in rows if (row["form"], row["dimensions"]) == ("as published", dimensions) and row["spirv"].isdigit())

    return [*(f"“only Perlin/PartialFNV1 and Perlin/PartialJenkins are close enough to Perlin/Float”: {partial} as "
              f"published takes, as a multiple of Perlin/Float at 800x600, {ratios(partial, 'as published')}; ours takes "
              f"{ratios(partial, 'ours')}." for _, partial in HASHES),
            f"Perlin/Integer, the slowest of all in the paper: {ratios('Perlin/Integer', 'tables in textures')}.",
            *(f"Instructions of the listings in {n}D, SPIR-V against the paper's column: {differences(n)}." for n in "23")]


def table(of: Record) -> dict[str, object]:
    heads = list(of.rows[0])
    sources = heads[4:heads.index("ms_800x600")]
    return {"cells": of.facts["cells"], "sources": sources, "claims": claims(of.rows),
            "tables": [(n, [(row["algorithm"], row["form"], cells(row, sources)) for row in of.rows
                            if row["dimensions"] == n]) for n in "23"]}


# --- The figure -------------------------------------------------------------------------------------------------------


def greys(values: np.ndarray, what: str) -> np.ndarray:
    """Noise from -1 black to 1 white; turbulence from 0 to 1/2, since most of it is below; clouds from 0 to 1. A value
    that is no number is black."""
    levels = {"noise": 0.5 + 0.5 * values, "turbulence": 2 * values, "clouds": values}[what]
    return np.rint(np.clip(np.nan_to_num(levels), 0.0, 1.0) * 255).astype(np.uint8)


def write_picture(path: Path, pixels: np.ndarray) -> None:
    path.write_bytes(png(pixels.shape[1], pixels.shape[0], np.repeat(pixels[..., None], 3, -1).tobytes()))


def figures(of: Record, out: Path) -> dict[str, object]:
    side = int(of.facts["side"])
    files = {(row["algorithm"], row["form"], row["what"]): out / row["file"] for row in of.rows if not row["problem"]}
    in_figure = dict.fromkeys(row["algorithm"] for row in of.rows if row["what"] in PICTURES)
    sheets = []
    for form, title in SHEETS.items():
        rows = []
        for algorithm in in_figure:
            whose = "tables in textures" if algorithm == "Perlin/Float" else form
            row = [greys(np.fromfile(files[algorithm, whose, what], "<f4").reshape(side, side), what)
                   if (algorithm, whose, what) in files else np.zeros((side, side), np.uint8) for what in PICTURES]
            rows.append(np.hstack(row))
        file = f"{form.replace(' ', '-')}.png"
        write_picture(out / file, np.vstack(rows))
        sheets.append({"title": title, "file": file, "width": side * len(PICTURES), "height": side * len(rows)})
    return {"facts": of.facts, "sheets": sheets, "rows": ", ".join(in_figure)}


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


def statistics(of: Record, out: Path) -> dict[str, object]:
    samples, histograms = [], {}
    for row in of.rows:
        if row["what"] == "statistics" and not row["problem"]:
            values = np.fromfile(out / row["file"], "<f4")
            samples.append(sample(row, values))
            histograms[samples[-1][:3]] = np.histogram(values, BINS, (LOW, HIGH))[0]
    record.write(out / "statistics.csv", [one._asdict() for one in samples], Sample._fields, of.facts)
    plots.histograms(out / "histograms.svg", samples, histograms, LOW, HIGH)
    by_key = {one[:3]: one for one in samples}
    partials = []
    for full, partial in HASHES:
        for form in ("as published", "as intended", "ours"):
            for n in "23":
                pair = [(name, form, n) for name in (full, partial)]
                if all(key in by_key for key in pair):
                    statistic, degrees, p = chi_square(*(histograms[key] for key in pair))
                    deviations = " and ".join(f"{by_key[key].variance ** 0.5:.4f}" for key in pair)
                    partials.append((*(by_key[key].title() for key in pair), deviations, f"{statistic:.0f}", degrees,
                                     f"{p:.2g}" if p else "below 1e-300"))
    return {"facts": of.facts, "samples": samples, "partials": partials}


# --- The rest ---------------------------------------------------------------------------------------------------------


def bend(fetches: Sequence[int], times: Sequence[float]) -> tuple[float, float]:
    """Of a line through the last three points: milliseconds a fetch, and where it meets the time without fetches."""
    each = (times[-1] - times[-3]) / (fetches[-1] - fetches[-3])
    return each, max((times[0] - (times[-1] - each * fetches[-1])) / each, 0.0) if each > 0 else 0.0


def bandwidth(of: Record, out: Path) -> dict[str, object]:
    sweeps = []
    for n in "23":
        curves: dict[str, tuple[list[int], list[float]]] = {}
        for row in of.rows:
            if row["dimensions"] == n:
                fetches, times = curves.setdefault(row["noise"], ([], []))
                fetches.append(int(row["fetches"]))
                times.append(float(row["milliseconds"]))
        if not curves:
            continue
        alone = next(iter(curves.values()))[1]
        rows = []
        for name, (fetches, times) in curves.items():
            each, at = bend(fetches, times)
            own = times[0] - alone[0]
            left = f"{100 * (times[-1] - alone[-1]) / own:.0f} %" if own > 0 else "no noise"
            rows.append((name, record.three_digits(times[0]), record.three_digits(each), f"{at:.1f}", left))
        plots.sweep(out / f"bandwidth-{n}d.svg", curves, n, of.facts["texture"])
        sweeps.append((n, rows))
    return {"facts": of.facts, "sweeps": sweeps, "software": any(name in of.facts["renderer"] for name in SOFTWARE),
            "most": max((int(row["fetches"]) for row in of.rows), default=0)}


def write_page(out: Path) -> None:
    records = {name: record.read(out / f"{name}.csv") for name in SECTIONS if (out / f"{name}.csv").is_file()}
    made = {"table": table, "period": lambda of: {"facts": of.facts, "rows": of.rows}, "values": lambda of: {
        "figures": figures(of, out), "statistics": statistics(of, out)}, "bandwidth": lambda of: bandwidth(of, out)}
    shown = {name: made[name](records[name]) if name in records else None for name in SECTIONS}
    problems = [(row.get("id") or f"{row['algorithm']}, {row['form']}, {row['dimensions']}D", row["problem"])
                for of in records.values() for row in of.rows if row.get("problem")]
    facts = next(iter(records.values())).facts
    page.write(out / "index.html", Path(__file__).with_name("paper.html"), **shown, problems=problems,
               facts={name: facts[name] for name in ("driver", "renderer", "OpenGL", "GLSL", "date", "command", "library",
                                                     "clock", "rounds")})


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure paper", __doc__)
    parser.add_argument("--out", type=Path, default=Path("out"))
    parser.add_argument("--dump", action="store_true")
    options, others = argparse.ArgumentParser.parse_known_args(parser, arguments)
    out = options.out
    status = conform.run([str(HN_CONFORM), "paper", "--out", str(out), "--dump", *others])
    if status not in (0, 1) or not any((out / f"{name}.csv").is_file() for name in SECTIONS):
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
