"""Measures what noise costs on a driver by a clock, compares it with an earlier record, and makes a page of it.

clock.sh describes the options; all but these two are those of hn-conform bench."""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Sequence
from pathlib import Path

from base.tree import HN_CONFORM
from base.usage import Parser
from measure import conform, page, record
from measure.record import Change, Quantity, Record

KEY, VALUE = ("id",), ("ratio", "spread")
PIXELS = 1920 * 1080
# Of ids: noises and octave sums of positions with the default hash and floats, as people draw them.
DRAWN = re.compile(r"(noise[23]d|fbm(_d)?|curl|warp|\w+_vector)\.(?!\w*_(cell|offset|full|nearest)(_|\b))\w*\.(lattice|any)$")
OTHERS = re.compile(r"(table\.)?[^.]+$")  # tables in textures, and shaders of others
TABLES = re.compile(r"table\.(float|integer)[23]")
DEFAULT = re.compile(r"\.(lattice|any)$")


def read(path: Path) -> Record:
    try:
        return record.read(path, ("id", "ratio", "spread"), "tools/measure clock")
    except OSError as error:
        raise ValueError(f"cannot read {path}: {error.strerror}; --baseline wants a {conform.BENCH}") from None
    except (ValueError, UnicodeDecodeError) as error:
        raise ValueError(f"{path} is not a {conform.BENCH} of this program: {error}") from None


def changes(before: Record, now: Record) -> dict[str, Change]:
    found = record.compare(*(record.quantities(one.rows, KEY, *VALUE) for one in (before, now)))
    return {id: change for (id,), change in found.items()}


def print_comparison(before: Record, now: Record, compared: dict[str, Change]) -> bool:
    """Whether something became slower."""
    if before.facts.get("renderer", "") != now.facts["renderer"]:
        print("The baseline was measured on another renderer: "
              f"{before.facts.get('renderer', 'an unknown one')}, not {now.facts['renderer']}")
    known = len(record.quantities(before.rows, KEY, *VALUE))
    print(f"{len(compared)} subjects compared; {known - len(compared)} of the baseline were not measured now")
    slower = {id: change for id, change in compared.items() if change.is_more}
    for id, change in slower.items():
        print(f"SLOWER {id}: {change.now.value:.3f} +- {change.now.spread:.3f}, was {change.before.value:.3f} +- "
              f"{change.before.spread:.3f}")
    return bool(slower)


# --- The page ---------------------------------------------------------------------------------------------------------


def milliseconds(row: dict[str, str]) -> float | None:
    """Of a frame with an evaluation for each pixel."""
    rate = record.number(row["evaluations_per_second"])
    return 1e3 * PIXELS / rate if rate else None


def shown_milliseconds(row: dict[str, str]) -> str:
    time = milliseconds(row)
    return row["evaluations_per_second"] if time is None else record.three_digits(time)


def cost(row: dict[str, str]) -> float:
    """To sort by: what could not be measured comes last."""
    return float("inf") if row["ratio"] == "failed" else milliseconds(row) or 0.0


def frame(rows: Sequence[dict[str, str]], ratios: dict[tuple[str, ...], Quantity], axes: str) -> dict[str, object]:
    """The rows that people draw, beside hn_perlin; beside Perlin/Float where that was not measured."""
    drawn = sorted((row for row in rows if row["dimensions"] == axes and not row["id"].startswith("empty")
                    and row["ratio"] != "failed" and (DRAWN.match(row["id"]) or OTHERS.match(row["id"]))), key=cost)
    units = {"hn_perlin": f"noise{axes}d.perlin.lattice", "Perlin/Float": f"table.float{axes}"}
    named = next(((name, id) for name, id in units.items()
                  if (id,) in ratios and ratios[id,].value > ratios[id,].spread), ("hn_perlin", ""))

    def against(row: dict[str, str]) -> str:
        one, unit = ratios.get((row["id"],)), ratios.get((named[1],))
        if row["id"] == named[1]:
            return "1"
        if one is None or unit is None:
            return "cannot be told"
        quotient = one.value / unit.value
        return str(Quantity(quotient, (one.spread + abs(quotient) * unit.spread) / unit.value))

    def title(row: dict[str, str]) -> str:
        if table := TABLES.match(row["id"]):
            return f"Perlin/{table[1].title()}, tables in textures"
        return row["call"] if "." in row["id"] else row["id"]

    return {"axes": axes, "unit": named[0],
            "rows": [(title(row), shown_milliseconds(row), against(row)) for row in drawn]}


def everything(rows: Sequence[dict[str, str]]) -> list[dict[str, object]]:
    numbers = [number for row in rows if (number := record.number(row["ratio"])) is not None]
    longest = max([*numbers, 1e-9])
    return [{"id": row["id"], "default": bool(DEFAULT.search(row["id"])), "ratio": row["ratio"], "spread": row["spread"],
             "part": 100 * max(record.number(row["ratio"]) or 0.0, 0.0) / longest, "milliseconds": shown_milliseconds(row),
             "rest": list(row.values())[6:-1]} for row in sorted(rows, key=cost)]


def write_page(out: Path, of: Record, compared: dict[str, Change]) -> None:
    ratios = record.quantities(of.rows, KEY, *VALUE)
    frames = [found for axes in "23" if (found := frame(of.rows, ratios, axes))["rows"]]
    page.write(out, Path(__file__).with_name("costs.html"), record=of, frames=frames, rows=everything(of.rows),
               heads=list(of.rows[0])[6:-1], changes=[(id, *map(str, change), change.is_more)
                                                     for id, change in compared.items()],
               problems=[(row["id"], row["problem"]) for row in of.rows if row["problem"]])


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure clock", __doc__)
    parser.add_argument("--baseline", type=Path)
    parser.add_argument("--out", type=Path, default=Path("out"))
    parser.add_argument("--dump", action="store_true")
    options, others = argparse.ArgumentParser.parse_known_args(parser, arguments)
    try:
        # Before the run rather than after it; it may be the file that the run replaces.
        before = read(options.baseline) if options.baseline else None
    except ValueError as error:
        parser.error(str(error))
    status = conform.bench(str(HN_CONFORM), options.out, others, options.dump)
    if status not in (0, 1) or not (options.out / conform.BENCH).is_file():
        return status
    now = read(options.out / conform.BENCH)
    compared = changes(before, now) if before else {}
    if before and print_comparison(before, now, compared):
        status = 1
    write_page(options.out / "index.html", now, compared)
    print(options.out / "index.html")
    return status


if __name__ == "__main__":
    sys.exit(main())
