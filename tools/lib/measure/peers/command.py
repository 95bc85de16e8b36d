#!/usr/bin/env python3
"""Measures other libraries' noise beside ours: what it costs, or what it looks like.

    tools/peers [--fastnoiselite FILE] [--wombat DIR] [--materialx DIR] [--webgl-noise DIR] [--psrdnoise DIR]
                [--driver NAME] [--out DIR]
    tools/peers --likeness [--fastnoiselite FILE] [--materialx DIR] [--webgl-noise DIR] [--psrdnoise DIR] [--lygia DIR]
                [--pictures DIR] [--out DIR | --check]

Each option is the path of a copy of yours; which file or folder of it, the help says. What is not given is left out.

The first form measures noises, sums and warps in the same rounds. It calls hn-conform bench --against, which must be on
the PATH or built (tools/bench builds it), and leaves bench.csv in DIR. docs/results/llvmpipe/peers.csv is such a file;
tools/readme makes the table of docs/measuring.md of it.

With --likeness it finds the scale and the factor with which a call of ours looks like one of theirs, and leaves
likeness.csv in DIR. docs/results/llvmpipe/likeness.csv is such a file; tools/readme makes the tables of docs/moving.md
of it. It needs libOSMesa.

Exit status: that of hn-conform bench; with --likeness 1 if ours does not look alike even so, or with --check if the
numbers are not those of docs; 2 bad usage.
"""

import argparse
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

sys.dont_write_bytecode = True  # the tree stays clean: no __pycache__ beside the sources
sys.path.insert(0, str(Path(__file__).resolve().parent / "lib"))

import needs  # noqa: E402

needs.python(3, 11)

from likeness import command as likeness  # noqa: E402
from likeness.table import ROWS  # noqa: E402
from tables.peers import CALLS, OTHERS, PEERS, against  # noqa: E402
from tree import hn_conform  # noqa: E402


def command(program: str, paths: dict[str, Path], driver: str, out: str) -> list[str]:
    """What measures the peers at these paths."""
    calls = [call for call in CALLS if call.peer in paths]
    words = [program, "bench", "--driver", driver, "--out", out]
    for ours in dict.fromkeys(call.ours for call in calls):
        words += ["--filter", f"{ours}.lattice"]
    for one in against(paths):
        words += ["--against", one]
    return words


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="tools/peers", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    for peer in (*PEERS, *OTHERS):
        parser.add_argument(f"--{peer.option}", type=Path, metavar="PATH", help=peer.what)
    parser.add_argument("--driver", default="osmesa", help="of the costs")
    parser.add_argument("--out", default="out")
    parser.add_argument("--likeness", action="store_true", help="what they look like, in place of what they cost")
    parser.add_argument("--pictures", type=Path, metavar="DIR",
                        help="draw theirs, ours as it is, ours as ported, and a board of the first and the last")
    parser.add_argument("--check", action="store_true", help="compare with the numbers of docs, and write no record")
    options = parser.parse_args(arguments)
    given = {peer.option: getattr(options, peer.option.replace("-", "_")) for peer in (*PEERS, *OTHERS)}
    paths = {option: path for option, path in given.items() if path is not None}
    if not paths:
        parser.error("name at least one peer, for example --webgl-noise DIR")
    for option, path in paths.items():
        if not path.exists():
            parser.error(f"--{option}: there is no {path}")
    if options.likeness:
        if not any(row.peer in paths for row in ROWS):
            parser.error(f"there is no likeness to {' and '.join(paths)}")
        return likeness.run(paths, Path(options.out), options.pictures, options.check)
    if options.check or options.pictures:
        parser.error("--check and --pictures go with --likeness")
    if not set(paths) - {peer.option for peer in OTHERS}:
        parser.error("only its likeness is measured: add --likeness")
    program = hn_conform()
    if not program:
        parser.error("there is no hn-conform: build it by tools/bench, or put it on the PATH")
    return subprocess.run(command(program, paths, options.driver, options.out), check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
