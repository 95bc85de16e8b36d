"""Measures what noise costs on a driver by a clock, compares it with an earlier record, and makes a page of it.

clock.sh describes the options; all but --baseline are those of hn-conform bench."""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Sequence
from pathlib import Path

from base.tree import HN_CONFORM
from base.usage import Parser
from measure import conform, page, record
from measure.page import Section
from measure.record import Change, Record

KEY, VALUE = ("id",), ("ratio", "spread")
PIXELS = 1920 * 1080
# Ids of noises and octave sums of positions with the default hash and floats, as people draw them.
DRAWN = re.compile(r"(noise[23]d|fbm(_d)?|curl|warp|\w+_vector)\.(?!\w*_(cell|offset|full|nearest)(_|\b))\w*\.(lattice|any)$")
OTHERS = re.compile(r"(table\.)?(?!empty)[^.]+$")  # tables in textures, and shaders of others
FRAME = """A frame of 1920 x 1080 pixels with one evaluation for each pixel, at the default settings. The milliseconds are
those of this machine and this run, without the time of an empty shader. The last column is the time over that of
Perlin/Float, the noise whose tables are textures (table.float), in the same rounds: what slowed the machine down slowed
both. Another renderer has other numbers."""
ALL = """A ratio is that to Perlin/Float of as many dimensions: the median over the rounds, after the time of an empty
shader is taken off both. The spread is half the distance between the quartiles. Instructions are those of a whole fragment
shader that evaluates the function once per pixel and writes it as grey; empty2 and empty3 are the shader without it.
SPIR-V after spirv-opt -O."""


def read(path: Path) -> Record:
    try:
        return record.read(path, ("id", "ratio", "spread"), "tools/measure clock")
    except OSError as error:
        raise ValueError(f"cannot read {path}: {error.strerror}; --baseline wants a {conform.BENCH}") from None
    except (ValueError, UnicodeDecodeError) as error:
        raise ValueError(f"{path} is not a {conform.BENCH} of this program: {error}") from None


def print_comparison(before: Record, now: Record) -> dict[str, Change]:
    """The changes, by subject."""
    known, found = (record.quantities(one.rows, KEY, *VALUE) for one in (before, now))
    compared = {id: change for (id,), change in record.compare(known, found).items()}
    if before.facts.get("by") != now.facts["by"]:
        print(f"The baseline was measured by another renderer: {before.facts.get('by')}, not {now.facts['by']}")
    print(f"{len(compared)} subjects compared; {len(known) - len(compared)} of the baseline were not measured now")
    for id, change in compared.items():
        if change.is_more:
            print(f"SLOWER {id}: {change.now.value:.3f} +- {change.now.spread:.3f}, was {change.before.value:.3f} +- "
                  f"{change.before.spread:.3f}")
    return compared


def milliseconds(row: dict[str, str]) -> str:
    """The time of a frame with an evaluation for each pixel; or the word in place of a number."""
    rate = record.number(row["evaluations_per_second"])
    return record.three_digits(1e3 * PIXELS / rate) if rate else row["evaluations_per_second"]


def cost(row: dict[str, str]) -> float:
    """To sort by: what could not be measured comes last."""
    return float("inf") if row["ratio"] == "failed" else record.number(milliseconds(row)) or 0.0


def sections(of: Record, compared: dict[str, Change]) -> list[Section]:
    rows = sorted(of.rows, key=cost)
    ratios = record.quantities(rows, KEY, *VALUE)
    found = []
    for axes in "23":
        drawn = [(row["id"] if OTHERS.match(row["id"]) else row["call"], milliseconds(row),
                  ratios.get((row["id"],), row["ratio"]))
                 for row in rows if row["dimensions"] == axes and row["ratio"] != "failed" and
                 (DRAWN.match(row["id"]) or OTHERS.match(row["id"]))]
        if drawn:
            found.append(Section(f"{axes}D: p is a vec{axes}", FRAME, ("evaluated", "ms a frame", "times Perlin/Float"), drawn))
    if compared:
        found.append(Section("Against the baseline", "", ("subject", "before", "now", ""), [
            (id, change.before, change.now, "slower" * change.is_more) for id, change in compared.items()]))
    heads = ("ratio", "spread", *list(of.rows[0])[6:-1])
    found.append(Section("By settings, and by function", ALL, ("subject, cheapest first", "ms a frame", *heads), [
        (row["id"], milliseconds(row), *(row[head] for head in heads)) for row in rows], "table dense"))
    return found


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure clock", __doc__)
    parser.add_argument("--baseline", type=Path)
    parser.add_argument("--out", type=Path, default=Path("out"))
    options, others = argparse.ArgumentParser.parse_known_args(parser, arguments)
    try:
        # Before the run rather than after it; it may be the file that the run replaces.
        before = read(options.baseline) if options.baseline else None
    except ValueError as error:
        parser.error(str(error))
    status, facts = conform.bench(str(HN_CONFORM), options.out, others)
    if not facts:
        return status
    now = read(options.out / conform.BENCH)
    compared = print_comparison(before, now) if before else {}
    page.write(options.out / "index.html", Path(__file__).with_name("tables.html"), facts=facts,
               title=f"Costs of hashnoise on {facts['renderer']}", sections=sections(now, compared),
               problems=[(row["id"], row["problem"]) for row in now.rows if row["problem"]])
    print(options.out / "index.html")
    return 1 if any(change.is_more for change in compared.values()) else status


if __name__ == "__main__":
    sys.exit(main())
