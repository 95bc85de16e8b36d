"""Texts of pages on noises and sums: the tables of functions in the README, docs/reference/noises.md and
docs/reference/fractals.md."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

from base.tree import ROOT
from catalog.model import Catalog, Function, Noise, Sum
from catalog.shaders import sums_of_values
from catalog.tables.markdown import table, with_section

README, NOISES, SUMS = "README.md", "docs/reference/noises.md", "docs/reference/fractals.md"
USUAL_SUM = "fbm"
USUAL = "p, octaves, lacunarity, gain"


def grouped(functions: Iterable[Function], text: Callable[[Function], str]) -> list[tuple[list[Function], str]]:
    """Functions with equal text share a row, where the first of them stands."""
    groups: dict[str, list[Function]] = {}
    for function in functions:
        groups.setdefault(text(function), []).append(function)
    return [(group, said) for said, group in groups.items()]


def called(group: Sequence[Function], parameters: str) -> str:
    """The first with its parameters, which those after it have, too."""
    return ", ".join([f"`hn_{group[0].name}({parameters})`", *(f"`hn_{function.name}`" for function in group[1:])])


def settings(sum_: Sum) -> str:
    return ", ".join(["p", "octaves", "lacunarity", "gain", *([sum_.strength.name] if sum_.strength else [])])


def parameters(noise: Noise) -> str:
    """The parameters of the form with the fewest. A noise with a wave has no form without all others."""
    needed = [option for option in noise.options if option != "bandwidth"]
    return ", ".join(["p", *needed, "seed"] if "wave" in noise.options else ["p [, seed]"])


def parameters_of(sum_: Sum) -> str:
    return f"{settings(sum_)}, seed" if sum_.strength else f"{settings(sum_)} [, seed]"


def in_readme(catalog: Catalog) -> str:
    rows = []
    for group, brief in grouped(catalog.noises, lambda noise: noise.brief):
        rows.append((called(group, parameters(group[0]).replace(" [, seed]", ", seed")), brief))
    for group, brief in grouped(catalog.sums, lambda sum_: sum_.brief):
        arguments = parameters_of(group[0]).replace(" [, seed]", ", seed")
        rows.append((called(group, arguments if group[0].name == USUAL_SUM else arguments.replace(USUAL, "...")), brief))
    return table(("function", "value in 2D: a `float` in [-1, 1], or as stated"), rows)


def of_noises(catalog: Catalog) -> str:
    def cells(group: Sequence[Noise]) -> list[str]:
        return ["x" if any(noise.is_in(dimensions) for noise in group) else "" for dimensions in range(1, 5)]

    return table(("noise", "1D", "2D", "3D", "4D", "take it for"),
                 [(", ".join(f"`hn_{noise.name}`" for noise in group), *cells(group), use)
                  for group, use in grouped(catalog.noises, lambda noise: noise.use)])


def of_sums(sums: Sequence[Sum]) -> str:
    return table(("function", "value"), [(called(group, parameters_of(group[0])), use)
                                         for group, use in grouped(sums, lambda sum_: sum_.use)])


def of_steps(catalog: Catalog) -> str:
    """By public functions: hn_add bounds no noise, and hn_mean no mean."""
    means = {"": "hn_mean(o)", "bounded": "hn_mean(o)", "density": "hn_density(o)", "billows": "2.0 * hn_mean(o) - 1.0"}

    def row(sum_: Sum) -> tuple[str, ...]:
        strength = ", strength" if sum_.strength else ""
        return f"`hn_{sum_.name}`", f"`{sum_.step_of_loops}(o, n{strength})`", f"`{means[sum_.mean]}`"

    return table(("the library's sum", "adds an octave", "makes the value"), [*map(row, sums_of_values(catalog))])


def files(catalog: Catalog) -> dict[Path, str]:
    plain = sums_of_values(catalog)
    others = [sum_ for sum_ in catalog.sums if sum_ not in plain]
    made = {}
    for page, name, text in ((README, "functions", in_readme(catalog)), (NOISES, "noises", of_noises(catalog)),
                             (SUMS, "sums", of_sums(plain)), (SUMS, "sums in 2D and 3D", of_sums(others)),
                             (SUMS, "steps", of_steps(catalog))):
        path = ROOT / page
        old = made.get(path) or path.read_text(encoding="utf-8")
        made[path] = with_section(page, old, f"tools/make catalog: {name}", text)
    return made
