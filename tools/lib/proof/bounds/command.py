"""Proves the numbers that the documentation quotes about noise and octave sums: range, Lipschitz constant, errors.

    tools/make bounds            writes bounds.inc, which the suite includes, and the tables of docs/measured/accuracy.md
    tools/make bounds --check    compares these, and every bound that a comment or a page quotes, with the derived one
    tools/make bounds --table    prints all that is derived
    tools/make bounds FILE.glsl  proves functions of a file of yours that take a position or a place: their ranges,
                                 slopes and errors beside the same text in exact arithmetic, or the step that cannot be
                                 seen through, with its line

noises/ has the proofs for each noise.

Exit status: 0 all is as derived, or proven; 1 something is not, or has no proof: prose, comments and proofs are for you to
write; 2 bad usage, or a file that cannot be read or does not compile; 4 numpy and scipy are missing, and could not be installed
(tools/lib/base/scientific-python).
"""

from __future__ import annotations

import argparse
import math
import re
import sys
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, astuple, replace
from pathlib import Path

import catalog.model
from base.tree import ROOT
from base.usage import Parser
from catalog.tables.functions import read_functions
from proof.bounds import claims, gullies, identity, jacobians, noises, own, sine, sums, text, uniform
from proof.bounds.documents import (
    ACCURACY,
    Everything,
    Key,
    missing_quotes,
    name_of,
    with_tables,
    wrong_comments,
)
from proof.bounds.features import METRICS
from proof.bounds.gradients import SINE
from proof.bounds.integers import fade_errors, overshoot
from proof.bounds.noises import ProvenBounds
from proof.bounds.prover import Proven
from proof.bounds.sums import Sum
from proof.bounds.table import HEAD, PATH, bounds_of, row, row_of, scientific, slope_bounds_of


def keys() -> list[Key]:
    return [(name, dims, gradient) for name in noises.names() for dims, gradient in noises.find(name).cases]


def family(key: Key) -> str:
    """The prefixes of the noises that share suprema: simplex_d_phase is a simplex."""
    return key[0].split("_")[0]


def derived_of(key: Key) -> ProvenBounds:
    noise = noises.find(key[0])
    largest = max(noise.largest_intermediates(*key[1:]).values(), default=0.0)
    return replace(noise.derive(*key[1:]), fixed_intermediate=largest)


def derive_family(name: str) -> list[ProvenBounds]:
    return [derived_of(key) for key in keys() if family(key) == name]


def derive(found: Sequence[tuple[text.Case, Proven]]) -> Everything:
    """All of it, on all cores: each family in one process, which computes once the parts that its noises share. With
    what their text proves."""
    families = {name: [key for key in keys() if family(key) == name] for name in map(family, keys())}
    with ProcessPoolExecutor() as pool:
        derived = {key: of_key for of_family, some in zip(families.values(), pool.map(derive_family, families))
                   for key, of_key in zip(of_family, some)}
    return {key: text.completed(key, derived[key], found) for key in keys()}


def rendered(derived: Everything) -> str:
    """The table that the suite includes."""
    rows = [row_of("NOISE_BOUNDS", of_noise.bounds(*key)) for key, of_noise in derived.items()]
    rows += [row_of("SLOPE_BOUNDS", of_noise.slope.bounds(*key)) for key, of_noise in derived.items() if of_noise.slope]
    error_of_floats = SINE.component_error.hex().replace("1.0000000000000p", "1p")
    rows.append(row("SINE_BOUNDS", error_of_floats, scientific(sine.fixed_sine_error())))
    rows.append(row("UNIFORM_BOUNDS", *(scientific(x) for fixed in (False, True) for x in astuple(uniform.errors(fixed)))))
    rows.append(row("GULLIES_BOUNDS", *map(scientific, astuple(gullies.bounds()))))
    return HEAD + "".join(rows)


def files(derived: Everything, root: Path = ROOT, *more: str) -> dict[Path, str]:
    """The written files with their right text; `more` may name the example of the page."""
    page = root / ACCURACY
    return {root / PATH.relative_to(ROOT): rendered(derived),
            page: with_tables(page.read_text(encoding="utf-8"), derived, *more)}


OF_THEIR_OWN = ("gullies", "uniform", "perlin_worley")  # the last has its proof in conformance/expected/tolerance.cpp
TOLERANCES = dict.fromkeys(sums.KINDS, (sums.octave_tolerance, sums.fixed_octave_tolerance)) | jacobians.TOLERANCES


def without_proof() -> list[str]:
    """A message for each need of the catalog's functions that no proof meets, and each claim on sums."""
    of_all = catalog.model.read()
    found = [f"tools/lib/proof/bounds/features.py has no proof of the metric {metric}"
             for metric in of_all.metrics if metric not in METRICS]
    for sum_ in of_all.sums:
        refused = [] if sum_.name in OF_THEIR_OWN else refusals(sum_.name)
        found += refused or [f"catalog/sums.toml: {wrong}" for wrong in claims.wrong_sum(sum_)]
    for name, dims in {(function.bound, function.axes) for function in read_functions()}:
        if name in noises.names():
            if all(dims != of_case for of_case, _ in noises.find(name).cases):
                found.append(f"tools/lib/proof/bounds/noises has no proof of {name} in {dims}D")
        elif name not in ("exact", "sine", *sums.CATALOG, *OF_THEIR_OWN):
            found.append(f"tools/lib/proof/bounds has no proof of {name}")
    return sorted(set(found))


def refusals(name: str) -> list[str]:
    """The refusals of the proofs in floats and in integers for a sum, for an octave on the plane."""
    try:
        s, noise = Sum(name, 1.0, 1, 2.0, 0.5), "curl" if name in sums.FLOWS else sums.CATALOG[name].noise
    except LookupError as error:
        return [str(error)]
    of = [bounds_of(noise, 2, "octahedral")]
    if name not in sums.KINDS + sums.FLOWS:
        of.append(slope_bounds_of(f"{noise.removesuffix('_d').removesuffix('_vector')}_d", 2))
    found = []
    for tolerance in TOLERANCES[name]:
        try:
            tolerance(s, *of)
        except LookupError as error:
            found.append(str(error))
    return found


def differences(derived: Everything, root: Path = ROOT) -> list[str]:
    old = [f"{path}: not up to date; run tools/make bounds" for path, content in files(derived, root).items()
           if not path.is_file() or path.read_text(encoding="utf-8") != content]
    of_all = catalog.model.read(root / "catalog")
    return [*old, *missing_quotes(derived, root), *wrong_comments(derived, root / "glsl"),
            *claims.wrong_noises(of_all, derived), *claims.wrong_comments(of_all, derived, root / "glsl")]


def everything_for_a_reader(derived: Everything) -> dict[str, dict[str, object]]:
    numbers = {name_of(key): asdict(of_noise) | {
        f"fixed_{name}_over_2^31": value / 2**31 for name, value in noises.find(key[0]).largest_intermediates(*key[1:]).items()}
        for key, of_noise in derived.items()}
    return numbers | {
        "the sine of the sine gradient": {
            "polynomial_error": sine.sine_truncation_bound(),
            "argument_error": math.pi / 2 * sine.SINE_ARGUMENT_ERROR,
            "error": sine.sine_bound(),
            "error_promised": SINE.component_error,
            "below_1": 1 - sine.sine_largest(),
            "fixed_error": sine.fixed_sine_error(),
            "fixed_largest": float(sine.fixed_sine_largest())},
        "uniform values, slopes times a reach, and distributions of sums: in floats": asdict(uniform.errors(False)),
        "the same fixed": asdict(uniform.errors(True)),
        "the fixed fade": {"error_from": float(fade_errors().min()), "error_to": float(fade_errors().max()),
                           "overshoot": overshoot()}}


def print_table(numbers: dict[str, dict[str, object]]) -> None:
    for title, group in numbers.items():
        print(title)
        for name, value in group.items():
            shown = f"{value:.9g}" if isinstance(value, float) else value
            print(f"  {name.replace('_', ' '):40} {shown}")


def run(options: argparse.Namespace) -> int:
    if unproven := without_proof():
        print("\n".join(unproven))
        return 1
    lines = text.usual_lines() if options.check else text.lines()
    found = text.prove(lines)
    if unproven := text.unseen(found):
        print("\n".join(unproven))
        return 1
    derived = derive(found)
    if options.table:
        print_table(everything_for_a_reader(derived))
    else:
        if not options.check:
            for path, content in files(derived, ROOT, "example").items():
                path.write_text(content, encoding="utf-8")
        messages = [*identity.wrong_texts(), *identity.wrong_forms(lines, identity.golden_files()),
                    *text.wrong(found, derived), *gullies.wrong_errors(), *differences(derived)]
        print("\n".join(messages or [f"the bounds of {len(derived)} noises are as derived"]))
        return 1 if messages else 0
    return 0


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make bounds", __doc__)
    mode = parser.add_mutually_exclusive_group()
    mode.add_argument("--check", action="store_true", help="write nothing, and compare all that quotes a bound")
    mode.add_argument("--table", action="store_true", help="write nothing, and print all that is derived")
    parser.add_argument("file", nargs="?", type=Path, metavar="FILE.glsl", help="a file of yours")
    parser.add_argument("--function", action="append", default=[], metavar="NAME",
                        help="in place of those that no other function of the file calls; may be repeated")
    parser.add_argument("--within", action="append", default=[], metavar="NAME=LO:HI",
                        help="the range of an argument, or its value; else a position is in [-64, 64], another float in "
                             "[0, 1], and an integer any; may be repeated")
    options = parser.parse_args(arguments)
    if not options.file and (options.function or options.within) or options.file and (options.check or options.table):
        parser.error("--function and --within are for a file of yours, and it takes no other option")
    given = [(one, re.fullmatch(r"(\w+)=(-?[\d.]+(?::-?[\d.]+)?)", one)) for one in options.within]
    for one, match in given:
        if not match:
            parser.error(f"--within {one}: write NAME=LO:HI")
    within = dict(match.groups() for _, match in given)
    try:
        return own.report(options.file, options.function, within) if options.file else run(options)
    except own.Bad as error:
        print(error, file=sys.stderr)
        return 2
    except (KeyError, IndexError):
        raise  # these are look-ups too, but mistakes of the program
    except LookupError as error:
        print(error, file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
