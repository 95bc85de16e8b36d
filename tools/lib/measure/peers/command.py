"""The command line of tools/measure peers, which describes it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from base.tree import GLSL, hn_conform
from base.usage import Parser
from measure import conform
from measure.peers.copies import add_options, some_given
from measure.peers.table import CALLS, PEERS, against

DESCRIPTION = """\
Measures what other libraries' noises, sums and warps cost, beside ours and in the same rounds.

    tools/measure peers [--fastnoiselite FILE] [--wombat DIR] [--materialx DIR] [--webgl-noise DIR] [--psrdnoise DIR]
                        [--driver NAME] [--out DIR]

Each option is the path of a copy of yours; its help names which file or folder of it. Peers without an option are left
out.

It calls hn-conform bench --against, which must be on the PATH or built (tools/measure clock builds it), and leaves
bench.csv in DIR, with AMD's instructions. docs/measured/results/llvmpipe/peers.csv is such a file; tools/make readme
makes the table of docs/measured/measuring.md of it.

Exit status: that of hn-conform bench; 2 bad usage."""


def options_of(paths: dict[str, Path], driver: str) -> list[str]:
    """The functions that hn-conform bench measures for the peers at these paths."""
    calls = [call for call in CALLS if call.peer in paths]
    words = ["--driver", driver, "--glsl", str(GLSL)]  # the program may be older than the text here
    for ours in dict.fromkeys(call.ours for call in calls):
        words += ["--filter", f"{ours}.lattice"]
    for one in against(paths):
        words += ["--against", one]
    return words


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure peers", DESCRIPTION)
    add_options(parser, PEERS)
    parser.add_argument("--driver", default="osmesa", metavar="NAME", help="of hn-conform (default: %(default)s)")
    parser.add_argument("--out", type=Path, default=Path("out"), metavar="DIR", help="(default: %(default)s)")
    options = parser.parse_args(arguments)
    paths = some_given(parser, options, PEERS)
    program = hn_conform()
    if not program:
        parser.error("there is no hn-conform: build it by tools/measure clock, or put it on the PATH")
    return conform.bench(program, options.out, options_of(paths, options.driver))
