"""Measures the Rust crate beside other crates that compute noise.

    tools/measure rust [--out DIR] [--rounds N]

Packs the crate (tools/pack rust), and builds it with the others, of crates.io, into build/measure-rust: once for any
x86-64, as cargo does by default, and once for processors with AVX2 (-C target-cpu=x86-64-v3). rust.csv goes into DIR:
the target, the noise, the crate and its version, nanoseconds per point (the least of the rounds), that time in ours, and
the spread of this quotient, half the distance between its quartiles. All use one thread, in turns. Nothing else should
run meanwhile. docs/measured/results/cpu/rust.csv is such a file; tools/make readme makes the tables of
docs/measured/measuring.md of it.

Exit status: 0 done, 1 a crate could not be built or run, 2 bad usage, 4 the crate could not be packed.
"""

from __future__ import annotations

import os
import statistics
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path

from base.tree import ROOT, TOOLS, version
from base.usage import Parser, whole
from base.versions import version_of
from measure import record, stamps

OURS = "hashnoise"
FOLDER = ROOT / "build" / "measure-rust"
CALLS = Path(__file__).with_name("calls.rs")
# calls.rs is written for these versions. bevy_math has the vectors of noiz.
OTHERS = {"fastnoise-lite": "1.1.1", "libnoise": "1.2.0", "noise": "0.9.0", "noiz": "0.6.0", "bevy_math": "0.20.0"}
MODULES = "place,hash,perlin,value,simplex,cellular,fbm"
TARGETS = ("x86-64", "x86-64-v3")
COLUMNS = ("target", "noise", "package", "version", "nanoseconds", "ratio", "spread")


def manifest(crate: Path) -> str:
    others = "".join(f'{name} = {{ version = "={number}", default-features = {str(name != "bevy_math").lower()} }}\n'
                     for name, number in OTHERS.items())
    return (f'[package]\nname = "calls"\nversion = "0.0.0"\nedition = "2021"\n\n[[bin]]\nname = "calls"\npath = "{CALLS}"\n\n'
            f'[dependencies]\n{OURS} = {{ path = "{crate}" }}\n{others}')


def measured(crate: Path, target: str, rounds: int) -> str | None:
    """The lines of calls.rs; nothing if it could not be built or run."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    (FOLDER / "Cargo.toml").write_text(manifest(crate), encoding="utf-8")
    environment = {**os.environ, "RUSTFLAGS": f"-C target-cpu={target}", "CARGO_TARGET_DIR": str(FOLDER / target)}
    done = subprocess.run(["cargo", "run", "--quiet", "--release", "--manifest-path", FOLDER / "Cargo.toml", "--", str(rounds)],
                          env=environment, stdout=subprocess.PIPE, text=True, check=False)
    return done.stdout if done.returncode == 0 else None


def rows(target: str, lines: str) -> Iterator[Mapping[str, str]]:
    found = {(noise, package): [float(one) for one in times]
             for noise, package, *times in (line.split(",") for line in lines.splitlines())}
    for (noise, package), times in found.items():
        low, middle, high = statistics.quantiles(theirs / ours for theirs, ours in zip(times, found[noise, OURS], strict=True))
        crate = package.split()[0]
        values = (target, noise, package, version() if crate == OURS else OTHERS[crate], f"{min(times):.3g}",
                  f"{middle:.3g}", f"{(high - low) / 2:.2g}")
        yield dict(zip(COLUMNS, values, strict=True))


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure rust", __doc__)
    parser.add_argument("--out", type=Path, default=Path("out"), metavar="DIR", help="for rust.csv (out)")
    parser.add_argument("--rounds", type=partial(whole, least=3), default=99, metavar="N", help="samples of each time (99)")
    given = parser.parse_args(arguments)
    packed = subprocess.run([TOOLS / "pack", "rust", "--only", MODULES, FOLDER / "crate"], stdout=subprocess.PIPE, text=True, check=False)
    if packed.returncode:
        return 4
    found: list[Mapping[str, str]] = []
    for target in TARGETS:
        lines = measured(Path(packed.stdout.strip()), target, given.rounds)
        if lines is None:
            return 1
        found += rows(target, lines)
    record.write(given.out / "rust.csv", found, COLUMNS)
    stamps.stamp(given.out / "rust.csv", version_of("rustc"))
    print(given.out / "rust.csv")
    return 0
