"""Writes a terrain of 200 km by 200 km as Zarr, a height for each metre, block by block: it needs the memory of a few
blocks, however large the terrain is. At the end it prints what a square kilometre has cost.

    pip install . dask distributed xarray zarr                # in a copy of the repository
    python3 terrain.py                                        # 40,000,000,000 heights, into terrain.zarr
    python3 terrain.py --size 20000 --out small.zarr          # 20 km by 20 km
    python3 terrain.py --scheduler tcp://10.0.0.1:8786        # on a cluster, whose workers see the folder, too

    import xarray
    land = xarray.open_dataarray("terrain.zarr", engine="zarr", consolidated=False)
    land.sel(x=slice(5000, 5999), y=slice(0, 999)).values    # and reads a square kilometre of it

Exit status: 0 done, 1 not, 2 bad usage.
"""

from __future__ import annotations

import argparse
import resource
import sys
from pathlib import Path

import hashnoise.dask

WHOLE = 200_000  # metres
CELL = 4096  # metres: the largest hills
OCTAVES = 11  # the finest octave has cells of 4 m


def terrain(size: int):
    """A height for each metre of a square, as an xarray.DataArray of words. Nothing is computed yet."""
    return hashnoise.dask.data_array("fbm", (size, size), step=1 / CELL, cell=(0, 0), cell_size=CELL, unit="m",
                                     octaves=OCTAVES, seed=7, dtype="uint16")


def cost(size: int, out: Path) -> str:
    """The cost of a square that this process has written."""
    area = (size / 1000) ** 2
    stored = sum(path.stat().st_size for path in out.rglob("*") if path.is_file())
    used = resource.getrusage(resource.RUSAGE_SELF)
    return (f"each km²: {1000 * (used.ru_utime + used.ru_stime) / area:.0f} ms of processor time, "
            f"{stored / 1e6 / area:.2f} MB on disk; in all {used.ru_maxrss * 1024 / 1e6:.0f} MB of memory")


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--size", type=int, default=WHOLE, help="metres along each side")
    parser.add_argument("--out", type=Path, default=Path("terrain.zarr"))
    parser.add_argument("--scheduler", help="the address of a cluster of Dask; this machine if it is left out")
    chosen = parser.parse_args(arguments)
    if chosen.size < 1:
        parser.error(f"--size must be 1 or more, not {chosen.size}")
    if chosen.scheduler:
        from distributed import Client
        running = Client(chosen.scheduler)
    else:
        from dask.diagnostics import ProgressBar
        running = ProgressBar()
    with running:
        terrain(chosen.size).to_zarr(chosen.out, mode="w", consolidated=False)
    print(chosen.out)
    if not chosen.scheduler:
        print(cost(chosen.size, chosen.out))
    return 0


if __name__ == "__main__":
    sys.exit(main())
