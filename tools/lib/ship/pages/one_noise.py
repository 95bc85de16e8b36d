"""Makes what docs/develop/one-noise.md quotes of the files that Perlin noise on the plane passes through.

    tools/make one-noise            writes the quotes
    tools/make one-noise --check    writes nothing

Exit status: 0 the page has the quotes, 1 it has others, 2 bad usage, or a file has nothing to quote.
"""

from __future__ import annotations

import inspect
import re
import struct
import sys
from collections.abc import Sequence

from base.golden_values import Golden
from base.pieces import is_deleted
from base.tree import GLSL, ROOT
from base.usage import Parser
from catalog.tables.markdown import table, with_section
from proof.oracle.cells import weighted_sum
from proof.oracle.noises import perlin

NAME = "docs/develop/one-noise.md"
ID = "noise2d.perlin"
SETTINGS = {"lattice": "`HN_FAST`", "lattice+fixed": "`HN_FIXED`"}


def contract() -> str:
    """The steps of the noise."""
    text = (ROOT / "docs/reference/contract.md").read_text(encoding="utf-8")
    return re.search(r"^### Perlin noise\n.*?^(1\..*?\n)\n", text, re.DOTALL | re.MULTILINE)[1]


def text() -> str:
    """The noise in the library, without the comment of the public function."""
    whole = (GLSL / "perlin2d.glsl").read_text(encoding="ascii")
    inner = re.search(r"^HN_FN hn_i_num hn_i_perlin\(.*?^}\n", whole, re.DOTALL | re.MULTILINE)[0]
    outer = re.search(r"^HN_FN hn_float hn_perlin\(hn_place2.*?^}\n", whole, re.DOTALL | re.MULTILINE)[0]
    return f"```glsl\n{inner}{outer}```\n"


def oracle() -> str:
    functions = (weighted_sum, perlin.ramp, perlin.exact)
    return "```python\n" + "\n\n".join(inspect.getsource(function) for function in functions) + "```\n"


def bounds() -> str:
    """The row of the noise among the bounds, with the head of the table."""
    lines = (ROOT / "docs/measured/accuracy.md").read_text(encoding="utf-8").splitlines(keepends=True)
    at = next(i for i, line in enumerate(lines) if line.startswith("| `hn_perlin(vec2)`, octahedral"))
    head = max(i for i in range(at) if lines[i].startswith("| ---"))
    return lines[head - 1] + lines[head] + lines[at]


def golden() -> str:
    """The first row whose value is not 0, as it is in the file and as numbers."""
    given = {setting: Golden(ID, setting) for setting in SETTINGS}
    rows = {setting: dict(zip(map(tuple, golden.inputs), golden.values)) for setting, golden in given.items()}
    inputs = next(key for key, (value,) in rows["lattice"].items() if value and key in rows["lattice+fixed"])
    (x, y), seed = struct.unpack("<2f", struct.pack("<2I", *inputs[:2])), inputs[2]
    lines = []
    for setting, name in SETTINGS.items():
        word, = rows[setting][inputs]
        value, = struct.unpack("<d", struct.pack("<Q", word))
        lines.append((f"({x:g}, {y:g})", str(seed), name, repr(value), f"`{word:016x}`"))
    return table(("position", "seed", "arithmetic", "value", "as the file has it, a double"), lines)


def price() -> str:
    from measure.gpu import pages as of_gpus
    return of_gpus.titled_table(of_gpus.costs(), {f"{ID}.{setting}": name for setting, name in SETTINGS.items()})


def with_quotes(page: str) -> str:
    for part in (contract, text, oracle, bounds, golden, *[price] * (not is_deleted("measuring"))):
        page = with_section(NAME, page, f"tools/make one-noise: {part.__name__}", part())
    return page


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make one-noise", __doc__)
    parser.add_argument("--check", action="store_true", help="write nothing")
    options = parser.parse_args(arguments)
    path = ROOT / NAME
    page = path.read_text(encoding="utf-8")
    try:
        right = with_quotes(page)
    except (LookupError, StopIteration, TypeError) as error:
        parser.exit(2, f"tools/make one-noise: {error!r}\n")
    if options.check and page != right:
        print(f"{NAME} quotes what is not so any more; run tools/make one-noise", file=sys.stderr)
        return 1
    path.write_text(right, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
