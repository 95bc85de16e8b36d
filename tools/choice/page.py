"""docs/default-hash.md, from what was measured."""

from __future__ import annotations

from math import log2
from pathlib import Path

from measure import Cost, Result  # the first: it knows where the others lie
from judgement import ALPHA
from report import number, table

HASHES = """# The default hash and gradient, and why

Written by `tools/default-hash`. Each candidate is the library with the named functions replaced (`tools/choice/candidates.py`) and nothing else changed, so that costs are those of the whole `hn_perlin`.

- **Time** is the ratio to Perlin/Float in the same run of `hn-conform bench`, on Mesa's llvmpipe: smaller is faster.
- **SPIR-V** counts instructions after `spirv-opt -O`, **NAVI21** is AMD's cost by Mesa's RADV (inverse throughput: cycles of a compute unit for a wave of 64, so that a plain instruction counts 2 and
  a multiplication of 32 bits 8) and, in brackets, its instructions; the empty shader is subtracted from each.
- **Randomness** is the verdict of the gate's tests ([quality.md](quality.md)) on the bits that gradients take, in small windows (`LEAST` in `tools/randomness/gate.py`; the library's own hashes are judged at full size by
  `tools/quality`): the test with the most improbable result, as p, and how many tests fail. A random lattice fails a test with p below {alpha}.

## Hashes

On the front (they pass, and nothing that passes is cheaper in every respect): {front}.

{hashes}
The default is `product`. Two joins of the coordinates have 64 bits of state together. A single word of 32 bits makes some line of the lattice a copy of another in one window or another, whatever is made of
it afterwards; so the candidates that mix such a word fail by copied lines. And the product needs one operation where rounds of shifts and multiplications need four to eight.

"""

GRADIENTS = """## Gradients

The same hash with each. *Contrast* is the standard deviation of a noise whose largest possible value is 1; *reached* the largest value among a million.

{gradients}
The default is `octahedral`. All of these have components without correlation and of equal variance, so that the spectra of their noises are alike ([quality.md](quality.md)): what sets them apart is contrast and cost.

## What peers cost

Pass one in by its path, and it is timed in turns with the library: `hn-conform bench --against 'simplex=other.glsl:snoise(p)'`. No shader of others is in this repository.
"""


def line(result: Result) -> str:
    """For the terminal."""
    costs = "  ".join(f"{n}D {c.ratio:.3f} ± {c.spread:.3f}, SPIR-V {c.spirv}, NAVI21 {c.navi21}"
                      for n, c in result.costs.items())
    if not result.worst:
        return f"{result.candidate.name}: {costs}"
    return f"{result.candidate.name}: {costs}; " + "; ".join(
        f"{n}D p = {f.p:.1g} ({f.test}), {len(result.failed[n])} fail" for n, f in result.worst.items())


def time(cost: Cost) -> str:
    return f"{cost.ratio:.2f} ± {cost.spread:.2f}"


def amd(cost: Cost) -> str:
    return "not here" if cost.navi21 is None else f"{cost.navi21} ({cost.instructions})"


def judgement(result: Result, n: int) -> str:
    if result.worst is None:
        return "[quality.md](quality.md)"
    found = result.worst[n]
    failed = result.failed[n]
    return f"p = {number(found.p)}" if not failed else f"**fails {len(failed)}**: {found.test}, p = {number(found.p)}"


def costs(result: Result) -> list[str]:
    return [form(result.costs[n]) for form in (time, lambda c: str(c.spirv), amd) for n in (2, 3)]


COST_HEAD = ["time, 2D", "3D", "SPIR-V, 2D", "3D", "NAVI21, 2D", "3D"]


def passes(result: Result) -> bool:
    return result.failed is not None and not any(result.failed.values())


def dominated(result: Result, others: list[Result]) -> bool:
    """Whether another that passes is cheaper in every respect: by time and by AMD's count, in 2D and in 3D."""
    def price(r: Result) -> list[float]:
        return [r.costs[n].ratio for n in (2, 3)] + [float(r.costs[n].navi21 or 0) for n in (2, 3)]

    return any(all(a <= b for a, b in zip(price(other), price(result))) and price(other) != price(result)
               for other in others if passes(other))


def write(folder: Path, hashes: list[Result], gradients: list[Result]) -> None:
    """The sections that were measured; the other stays as it is."""
    path = folder / "default-hash.md"
    old = path.read_text(encoding="utf-8") if path.exists() else ""
    first, mark, rest = old.partition("## Gradients\n")
    if hashes:
        front = [f"`{r.candidate.name}`" for r in hashes if passes(r) and not dominated(r, hashes)]
        rows = [[f"`{r.candidate.name}`", r.candidate.what, *costs(r), judgement(r, 2), judgement(r, 3)] for r in hashes]
        first = HASHES.format(alpha=f"2^{round(log2(ALPHA))}", front=", ".join(front),
                              hashes=table(["hash", "how", *COST_HEAD, "randomness, 2D", "3D"], rows))
    second = mark + rest
    if gradients:
        rows = [[f"`{r.candidate.name}`", r.candidate.what, *costs(r), *contrast(r)] for r in gradients]
        second = GRADIENTS.format(gradients=table(
            ["gradient", "what", *COST_HEAD, "contrast, 2D", "3D", "reached, 2D", "3D"], rows))
    path.write_text((first + second).replace("\n\n\n", "\n\n"), encoding="utf-8")


def contrast(result: Result) -> list[str]:
    return [*(f"{result.noise[n]['variance'][0] ** 0.5:.3f}" for n in (2, 3)),
            *(f"{max(-result.noise[n]['lowest value'][0], result.noise[n]['highest value'][0]):.2f}" for n in (2, 3))]
