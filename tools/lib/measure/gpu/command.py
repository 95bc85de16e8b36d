"""Measures what noise costs on GPUs that are not here, by their own compilers.

    tools/measure gpu --get-drivers [--drivers DIR]      downloads them, some 410 MB of Debian's and PyPI's, into DIR
    tools/measure gpu [--chip NAME]... [--filter GLOB]... [--against NAME=FILE:EXPRESSION]... [--out DIR]
    tools/measure gpu --wombat Wombat/ --filter '*.perlin.*' --baseline docs/measured/results/gpu/costs.csv
    tools/measure gpu --list-chips

Mesa's drivers for NVIDIA, AMD, Adreno and Apple compile shaders without a GPU, for a stand-in of the kernel. NVIDIA's
nvcc and Intel's IGC need none; they get the same shaders by way of SPIRV-Cross. Of each shader, which is one call in a
fragment shader, less the empty shader, the record has cycles or instructions, registers and spills. The default is every
function with each arithmetic, on every chip. It needs hn-conform on the PATH or built (tools/measure clock builds it),
clang and spirv-cross. DIR gets costs.csv and chips.csv; docs/measured/results/gpu has
such files, and tools/make pages makes tables of them. docs/measured/measuring.md explains them.

Exit status: 0 done, 1 something costs more than in the baseline, 2 bad usage, 3 there are no drivers for a chip, and
why; 4 the drivers could not be had; 130 it was interrupted.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from base import debian
from base.debian import Missing
from base.tree import GLSL, ROOT, hn_conform
from base.usage import Parser
from measure import record as records
from measure import stamps
from measure.gpu import drivers, record
from measure.gpu.chips import CHIPS, Chip
from measure.gpu.compiling import Compiled, Device, compile_all
from measure.gpu.drivers import Drivers
from measure.gpu.kernels import compile_all as compile_kernels
from measure.gpu.kernels import translated
from measure.peers import add_options, against, given

ARITHMETICS = ("*.lattice", "*.lattice+precise", "*.lattice+fixed", "*.any")
DRIVERS = ROOT / "build" / "gpu-drivers"


class BadUsage(Exception):
    pass


class Progress:
    """A line for each hundred shaders."""

    def __init__(self, total: int):
        self.total, self.done, self.lock, self.stopped = total, 0, threading.Lock(), False

    def step(self) -> None:
        if self.stopped:
            raise KeyboardInterrupt  # in the thread that waits for a compiler, which then ends that
        with self.lock:
            self.done += 1
            if self.done % 100 == 0:
                self.say(f"{self.done} of {self.total} shaders")

    def say(self, text: str) -> None:
        print(text, file=sys.stderr, flush=True)


def program() -> str:
    found = hn_conform()
    if not found:
        raise BadUsage("there is no hn-conform: build it by tools/measure clock, or put it on the PATH")
    return found


def compile_spirv(hn_conform: str, folder: Path, arguments: Sequence[str]) -> dict[str, int]:
    """The dimensions of the position by the id, which is also the name of the file in folder/spirv."""
    done = subprocess.run([hn_conform, "spirv", "--out", str(folder), *arguments], stdout=subprocess.PIPE, text=True,
                          check=False)
    if done.returncode:
        raise BadUsage("the shaders do not compile" if done.returncode == 1 else "see the line above")
    return {id: int(dimensions) for id, dimensions in map(str.split, done.stdout.splitlines())}


def measure(chips: Sequence[Chip], found: Drivers, hn_conform: str, files: dict[str, Path]
            ) -> tuple[dict[str, Device], dict[str, dict[str, Compiled]], list[str]]:
    """The device and the shaders of each chip, and why others have none."""
    devices, shaders, skipped = {}, {}, []
    progress = Progress(len(chips) * len(files))
    texts = translated(files) if any(not chip.vendor.is_driver for chip in chips) else {}

    def one(chip: Chip) -> None:
        started = time.monotonic()
        try:
            if chip.vendor.is_driver:
                device, results = compile_all(found.compiler(chip, [hn_conform, "shader-statistics"]),
                                              found.environment(chip), list(files.values()), progress.step)
            else:
                device, results = compile_kernels(found, chip, texts, progress.step)
        except Missing as why:
            skipped.append(f"{chip.name} is skipped: {why}")
            return
        devices[chip.name], shaders[chip.name] = device, dict(zip(files, results))
        failed = sum(bool(result.problem) for result in results)
        progress.say(f"{chip.name}: {len(results)} shaders{f', {failed} failed' * bool(failed)}, "
                     f"{time.monotonic() - started:.0f} s")

    with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        try:
            list(pool.map(one, chips))
        except KeyboardInterrupt:
            progress.stopped = True
            pool.shutdown(cancel_futures=True)
            raise
    return devices, shaders, skipped


def run(options: argparse.Namespace) -> int:
    chips = [chip for chip in CHIPS if not options.chip or chip.name in options.chip]
    before = record.read_costs(options.baseline) if options.baseline else {}
    found = drivers.find(options.drivers)
    hn_conform = program()
    options.out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        arguments = [word for glob in options.filter or ARITHMETICS for word in ("--filter", glob)]
        for one in (*options.against, *against(given(options))):
            arguments += ["--against", one]
        arguments += ["--glsl", str(options.glsl)]  # the program may be older than the text here
        dimensions = compile_spirv(hn_conform, Path(scratch), arguments)
        files = {id: Path(scratch) / "spirv" / f"{id}.spv" for id in dimensions}
        devices, shaders, skipped = measure(chips, found, hn_conform, files)
    chips = [chip for chip in chips if chip.name in devices]
    rows = [record.row(id, chip, shaders[chip.name][id], shaders[chip.name][f"empty{axes}"])
            for id, axes in dimensions.items() if not id.startswith("empty") for chip in chips]
    for name, content in ((record.COSTS, records.beside([found._asdict() for found in rows], ("id",), record.CHIP)),
                          (record.DEVICES, [{"chip": chip.name, "title": chip.title, "device": devices[chip.name].name,
                                             "driver": devices[chip.name].driver, "cost": chip.vendor.cost}
                                            for chip in chips])):
        if content:
            records.write(options.out / name, content)
            stamps.stamp(options.out / name, "; ".join(dict.fromkeys(device.driver for device in devices.values())),
                         options.glsl)
    for line in (*skipped, *(f"FAILED {row.id} on {row.chip}: {row.problem}" for row in rows if row.problem)):
        print(line)
    print(f"{len(rows)} costs of {len(chips)} chips: {options.out}/{record.COSTS}")
    if not options.baseline:
        return 3 if skipped else 0
    compared = sum((row.id, row.chip) in before for row in rows)
    lines = record.dearer(before, rows)
    print(*lines, f"{compared} costs compared, {len(lines)} cost more or fail; {len(before) - compared} of the "
          "baseline were not measured now", sep="\n")
    return 1 if lines else 3 if skipped else 0


def list_chips(folder: Path) -> int:
    for chip in CHIPS:
        print(f"{chip.name:11} {chip.title}")
    try:
        drivers.find(folder)
    except Missing as why:
        print(f"None can be measured yet: {why}")
    return 0


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure gpu", __doc__)
    parser.add_argument("--chip", action="append", metavar="NAME", choices=[chip.name for chip in CHIPS], default=[],
                        help="only this one; may be repeated")
    parser.add_argument("--filter", action="append", metavar="GLOB", default=[],
                        help="only the subjects whose id matches, as of bench; may be repeated")
    parser.add_argument("--glsl", type=Path, metavar="DIR", default=GLSL,
                        help="another copy of the library: of glsl/hashnoise/")
    parser.add_argument("--against", action="append", metavar="NAME=FILE:EXPRESSION", default=[],
                        help="also another shader file, as of bench; may be repeated")
    add_options(parser)
    parser.add_argument("--out", type=Path, metavar="DIR", default=Path("out"))
    parser.add_argument("--baseline", type=Path, metavar="FILE", help="an earlier costs.csv, to compare with")
    parser.add_argument("--drivers", type=Path, metavar="DIR", default=DRIVERS,
                        help="where they are (build/gpu-drivers)")
    parser.add_argument("--get-drivers", action="store_true", help="download them, and do nothing else")
    parser.add_argument("--suite", default=debian.SUITE, help="Debian's, from which they come (sid)")
    parser.add_argument("--mirror", default=debian.MIRROR, help="of Debian")
    parser.add_argument("--list-chips", action="store_true", help="print the names for --chip")
    options = parser.parse_args(arguments)
    try:
        if options.list_chips:
            return list_chips(options.drivers)
        if options.get_drivers:
            drivers.get(options.drivers.absolute(), options.mirror, options.suite)
            print(f"{options.drivers} has {drivers.find(options.drivers).versions()}")
            return 0
        return run(options)
    except Missing as why:
        print(f"{parser.prog}: {'' if options.get_drivers else 'skipped: '}{why}", file=sys.stderr)
        return 4 if options.get_drivers else 3
    except KeyboardInterrupt:
        print(f"{parser.prog}: interrupted, and nothing is written", file=sys.stderr)
        return 130
    except (BadUsage, OSError, ValueError) as error:
        parser.error(str(error))
