"""docs/default-hash.md and its picture, from what was measured."""

from __future__ import annotations

from math import log2
from pathlib import Path

from measure import Cost, Result  # the first: it knows where the others lie
from judgement import ALPHA
from report import number, table

HEAD = """# The default hash and gradient, and why

Written by `tools/default-hash`. Each candidate is the library with the named functions replaced (`tools/choice/candidates.py`) and nothing else changed, so that costs are those of the whole `hn_perlin`.

- **Time** is the ratio to Perlin/Float in the same run of `hn-conform bench`, on Mesa's llvmpipe: smaller is faster.
- **SPIR-V** counts instructions after `spirv-opt -O`, **NAVI21** is AMD's cost by Mesa's RADV (inverse throughput: cycles of a compute unit for a wave of 64, so that a plain instruction counts 2 and
  a multiplication of 32 bits 8) and, in brackets, its instructions; the empty shader is subtracted from each.
- **Randomness** is the verdict of the gate (`tools/quality`, [quality.md](quality.md)) on the bits that gradients take: the test with the most improbable result, as p, and how many tests
  fail. A random lattice fails a test with p below {alpha}.

## Hashes

![Time in space against the most improbable result of the gate](images/default-hash.png)

{front}

{hashes}
The default is **`product`**: {verdict} Two joins of the coordinates have 64 bits of state together, so no line of the lattice copies another, as it does in one window or another with every single word of 32 bits;
and the product needs one operation where rounds of shifts and multiplications need four to eight.

The other hashes of the library, at the end of the table, cost what they cost on top of it: the product joins them to the lattice as well, and the gate passes each of them.

## Gradients

The same hash with each. *Contrast* is the standard deviation of a noise whose largest possible value is 1; *reached* the largest value among a million.

{gradients}
The default is **`octahedral`**: it has nearly twice the contrast of a box at about its cost. All of these have components without correlation and of equal variance, so that the spectra of their noises are alike
([quality.md](quality.md)): what sets them apart is contrast and cost.

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
    """Whether another that passes is cheaper in both, by time and by AMD's count."""
    def price(r: Result) -> list[float]:
        return [r.costs[n].ratio for n in (2, 3)] + [float(r.costs[n].navi21 or 0) for n in (2, 3)]

    return any(all(a <= b for a, b in zip(price(other), price(result))) and price(other) != price(result)
               for other in others if passes(other))


def write(folder: Path, hashes: list[Result], gradients: list[Result]) -> None:
    front = [r for r in hashes if passes(r) and not dominated(r, hashes)]
    rows = [[f"`{r.candidate.name}`", r.candidate.what, *costs(r), judgement(r, 2), judgement(r, 3)] for r in hashes]
    default = next(r for r in hashes if r.candidate.name == "product")
    verdict = "it passes, and no candidate that passes is cheaper." if [r for r in front] == [default] else (
        "it passes." if passes(default) else "**it does not pass.**")
    shape = [[f"`{r.candidate.name}`", r.candidate.what, *costs(r),
              *(f"{r.noise[n]['variance'][0] ** 0.5:.3f}" for n in (2, 3)),
              *(f"{max(-r.noise[n]['lowest value'][0], r.noise[n]['highest value'][0]):.2f}" for n in (2, 3))]
             for r in gradients]
    text = HEAD.format(
        alpha=f"2^{round(log2(ALPHA))}", verdict=verdict,
        front="On the front (they pass, and nothing that passes is cheaper in every respect): "
              + ", ".join(f"`{r.candidate.name}`" for r in front) + ".",
        hashes=table(["hash", "how", *COST_HEAD, "randomness, 2D", "3D"], rows),
        gradients=table(["gradient", "what", *COST_HEAD, "contrast, 2D", "3D", "reached, 2D", "3D"], shape))
    (folder / "default-hash.md").write_text(text.replace("\n\n\n", "\n\n"), encoding="utf-8")
    (folder / "images").mkdir(exist_ok=True)
    plot(folder / "images" / "default-hash.png", hashes)


def plot(path: Path, hashes: list[Result]) -> None:
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    least = 2.0 ** -64  # below, it is far off, and no longer matters how far
    figure, axes = pyplot.subplots(figsize=(8, 4.5), dpi=110)
    for result in (r for r in hashes if r.worst):
        p = max(min(f.p for f in result.worst.values()), least)
        axes.plot(result.costs[3].ratio, -log2(p), "o" if passes(result) else "x", color="C0" if passes(result) else "C3")
        axes.annotate(result.candidate.name, (result.costs[3].ratio, -log2(p)), textcoords="offset points",
                      xytext=(4, 4), fontsize=7)
    axes.axhline(-log2(ALPHA), color="0.5", linewidth=0.8)
    axes.text(axes.get_xlim()[1], -log2(ALPHA), "the gate ", ha="right", va="bottom", fontsize=8)
    axes.set_xlabel("time of hn_perlin(vec3), ratio to Perlin/Float (llvmpipe)")
    axes.set_ylabel("most improbable result, -log2 p (64: or less)")
    figure.tight_layout()
    figure.savefig(path)
