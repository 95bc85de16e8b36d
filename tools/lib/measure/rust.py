"""Measures the Rust crate beside other crates that compute noise.

    tools/measure rust [--out DIR] [--rounds N]

Packs the crate (tools/pack rust), and builds it with the others, of crates.io, into build/measure-rust: once for any
x86-64, as cargo does by default, and once for processors with AVX2 (-C target-cpu=x86-64-v3). rust.csv goes into DIR:
the target, the noise, the crate and its version, nanoseconds per point (the least of the rounds), that time in ours, and
the spread of this quotient, half the distance between its quartiles. All use one thread, in turns. Nothing else should
run meanwhile. docs/measured/results/cpu/rust.csv is such a file; tools/make pages makes the tables of
docs/measured/measuring.md of it.

Exit status: 0 done, 1 a crate could not be built or run, 2 bad usage, 4 the crate could not be packed.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from base.tree import ROOT, TOOLS, version
from base.versions import version_of
from measure import packages, stamps

FOLDER = ROOT / "build" / "measure-rust"
CALLS = Path(__file__).with_name("calls.rs")
# calls.rs is written for these versions. bevy_math has the vectors of noiz.
OTHERS = {"fastnoise-lite": "1.1.1", "libnoise": "1.2.0", "noise": "0.9.0", "noiz": "0.6.0", "bevy_math": "0.20.0"}
MODULES = "place,hash,perlin,value,simplex,cellular,fbm"
TARGETS = ("x86-64", "x86-64-v3")


def manifest(crate: str) -> str:
    others = "".join(f'{name} = {{ version = "={number}", default-features = {str(name != "bevy_math").lower()} }}\n'
                     for name, number in OTHERS.items())
    return (f'[package]\nname = "calls"\nversion = "0.0.0"\nedition = "2021"\n\n[[bin]]\nname = "calls"\npath = "{CALLS}"\n\n'
            f'[dependencies]\n{packages.OURS} = {{ path = "{crate}" }}\n{others}')


def main(arguments: Sequence[str] | None = None) -> int:
    given = packages.parser_of("rust", __doc__, rounds=99).parse_args(arguments)
    crate = packages.printed(TOOLS / "pack", "rust", "--only", MODULES, FOLDER / "crate")
    if not crate:
        return 4
    FOLDER.mkdir(parents=True, exist_ok=True)
    (FOLDER / "Cargo.toml").write_text(manifest(",".join(crate[0])), encoding="utf-8")
    versions, rows = OTHERS | {packages.OURS: version()}, []
    for target in TARGETS:
        lines = packages.printed(
            "cargo", "run", "--quiet", "--release", "--manifest-path", FOLDER / "Cargo.toml", "--", given.rounds,
            env={**os.environ, "RUSTFLAGS": f"-C target-cpu={target}", "CARGO_TARGET_DIR": str(FOLDER / target)})
        if not lines:
            return 1
        rows += packages.rows_of(([noise, package, versions[package.split()[0]], *times]
                                  for noise, package, *times in lines), min, target=target)
    stamps.keep(given.out / "rust.csv", rows, version_of("rustc"))
    return 0
