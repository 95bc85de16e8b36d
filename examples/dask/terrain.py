"""Writes a terrain of 200 km by 200 km as Zarr, a height for each metre, block by block: it needs the memory of a few
blocks, however large the terrain is.

    pip install . dask distributed xarray zarr                # in a copy of the repository
    python3 terrain.py                                        # 40,000,000,000 heights, into terrain.zarr
    python3 terrain.py --size 20000 --out small.zarr          # 20 km by 20 km
    python3 terrain.py --scheduler tcp://10.0.0.1:8786        # on a cluster, whose workers see the folder, too
    python3 terrain.py --measure ../../docs/guide/dask.md           # what a square kilometre costs here, into the page

    import xarray
    land = xarray.open_dataarray("terrain.zarr", engine="zarr", consolidated=False)
    land.sel(x=slice(5000, 5999), y=slice(0, 999)).values    # and reads a square kilometre of it

Exit status: 0 done, 1 not, 2 bad usage.
"""

from __future__ import annotations

import argparse
import contextlib
import datetime
import platform
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

import hashnoise.dask

WHOLE = 200_000  # metres
CELL = 4096  # metres: the largest hills
OCTAVES = 11  # the finest octave has cells of 4 m
BEGIN, END = "<!-- examples/dask/terrain.py: costs -->\n", "<!-- end -->"
# Measured terrains: the side in metres, and what differs from the terrain above.
MEASURED = ((4096, {}), (8192, {}), (16384, {}), (8192, {"dtype": "float32"}), (8192, {"arithmetic": "fast"}),
            (8192, {"octaves": 5}))


def terrain(size: int, **options):
    """A height for each metre of a square, as an xarray.DataArray of words. Nothing is computed yet."""
    chosen = {"octaves": OCTAVES, "seed": 7, "dtype": "uint16", **options}
    return hashnoise.dask.data_array("fbm", (size, size), step=1 / CELL, cell=(0, 0), cell_size=CELL, unit="m",
                                     **chosen)


def write(size: int, out: Path, **options) -> None:
    terrain(size, **options).to_zarr(out, mode="w", consolidated=False)


def measure(size: int, options: dict) -> dict[str, float]:
    """The cost of a square, in a process of its own, so that its memory is counted alone; without what Python and the
    libraries take."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([sys.executable, __file__, "--size", str(size), "--out", Path(folder, "terrain.zarr"),
                               "--report", *(f"--set={name}={value}" for name, value in options.items())],
                              check=True, capture_output=True, text=True)
        stored = sum(path.stat().st_size for path in Path(folder).rglob("*") if path.is_file())
    processor, memory = map(float, done.stdout.split())
    area = (size / 1000) ** 2
    return {"processor": processor / area, "stored": stored / area, "memory": memory}


def report(size: int, out: Path, options: dict) -> None:
    write(CELL // 16, out, **options)  # what is imported and started at first
    before = resource.getrusage(resource.RUSAGE_SELF)
    write(size, out, **options)
    after = resource.getrusage(resource.RUSAGE_SELF)
    print(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime,
          (after.ru_maxrss - before.ru_maxrss) * 1024)


def table(measured=MEASURED) -> str:
    lines = [f"{processor_name()}, {hashnoise.instruction_sets()[0]}, hashnoise {hashnoise.__version__}, Python "
             f"{platform.python_version()}, {datetime.date.today()}.", "",
             "| side | numbers | octaves | arithmetic | processor time per km² | on disk per km² | "
             "memory beyond that of the libraries |", "| --- | --- | --- | --- | --- | --- | --- |"]
    costs = [measure(size, options) for size, options in measured]
    for (size, options), cost in zip(measured, costs):
        lines.append(f"| {size:,} m | {options.get('dtype', 'uint16')} | {options.get('octaves', OCTAVES)} | "
                     f"{options.get('arithmetic', 'fixed')} | {1000 * cost['processor']:.0f} ms | "
                     f"{cost['stored'] / 1e6:.2f} MB | {cost['memory'] / 1e6:.0f} MB |")
    # The largest square with the terrain as it is.
    _, cost = max(((size, cost) for (size, options), cost in zip(measured, costs) if not options),
                  key=lambda one: one[0])
    area = (WHOLE / 1000) ** 2
    lines += ["", f"So the whole terrain, {area:,.0f} km², takes about {cost['processor'] * area / 3600:.1f} hours of "
              f"one core, shared by as many as there are, and {cost['stored'] * area / 1e9:.0f} GB."]
    return "\n".join(lines) + "\n"


def processor_name() -> str:
    with contextlib.suppress(OSError):
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()


def with_table(text: str, made: str) -> str:
    """A page with another table between its marks."""
    if text.count(BEGIN) != 1 or END not in text.partition(BEGIN)[2]:
        raise ValueError(f"the page must have the marks {BEGIN.strip()} and {END} around its table, once")
    before, _, rest = text.partition(BEGIN)
    return before + BEGIN + made + END + rest.partition(END)[2]


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--size", type=int, default=WHOLE, help="metres along each side")
    parser.add_argument("--out", type=Path, default=Path("terrain.zarr"))
    parser.add_argument("--scheduler", help="the address of a cluster of Dask; this machine if it is left out")
    parser.add_argument("--measure", type=Path, metavar="PAGE")
    parser.add_argument("--set", action="append", default=[], metavar="OPTION=VALUE", help=argparse.SUPPRESS)
    parser.add_argument("--report", action="store_true", help=argparse.SUPPRESS)
    chosen = parser.parse_args(arguments)
    if chosen.size < 1:
        parser.error(f"--size must be 1 or more, not {chosen.size}")
    options = {name: int(value) if value.isdecimal() else value
               for name, _, value in (text.partition("=") for text in chosen.set)}
    if chosen.measure:
        text = chosen.measure.read_text(encoding="utf-8")
        with_table(text, "")  # the marks are there, before minutes pass
        chosen.measure.write_text(with_table(text, table()), encoding="utf-8")
        return 0
    if chosen.report:
        report(chosen.size, chosen.out, options)
        return 0
    if chosen.scheduler:
        from distributed import Client
        running = Client(chosen.scheduler)
    else:
        from dask.diagnostics import ProgressBar
        running = ProgressBar()
    with running:
        write(chosen.size, chosen.out, **options)
    print(chosen.out)
    return 0


if __name__ == "__main__":
    sys.exit(main())
