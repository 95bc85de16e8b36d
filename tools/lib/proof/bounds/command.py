"""Proves the ranges of noises and of their derivatives, and writes what quotes them and the errors that tools/make errors found.

    tools/make bounds            writes bounds.inc, which the suite includes, and the tables of docs/measured/accuracy.md
    tools/make bounds --check    compares these, and every bound that a comment or a page quotes, with the right one
    tools/make bounds --table    prints all that is derived

noises/ has the proofs for each noise.

Exit status: 0 all is as derived; 1 something is not, or has no proof or no error: prose, comments and proofs are for you to
write; 2 bad usage; 4 numpy and scipy are missing, and could not be installed (tools/lib/base/scientific-python).
"""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, replace
from pathlib import Path

import catalog.model
from base.tree import ROOT
from base.usage import Parser
from catalog.tables.functions import read_functions
from proof.bounds import claims, identity, noises
from proof.bounds.documents import (
    ACCURACY,
    Everything,
    Key,
    missing_quotes,
    name_of,
    of_sine,
    with_tables,
    wrong_comments,
)
from proof.bounds.features import METRICS
from proof.bounds.kept import kept
from proof.bounds.noises import ProvenBounds
from proof.bounds.table import HEAD, PATH, row, row_of, scientific
from proof.errors import record
from proof.errors.record import CELL, DERIVATIVE, FIXED, FLOATS, POSITION, VALUE
from proof.errors.record import Key as Recorded


def keys() -> list[Key]:
    return [(name, dims, gradient) for name in noises.names() for dims, gradient in noises.find(name).cases]


def family(key: Key) -> str:
    """The prefixes of the noises that share suprema: simplex_d_phase is a simplex."""
    return key[0].split("_")[0]


def derived_of(key: Key) -> ProvenBounds:
    return with_errors(key, noises.find(key[0]).derive(*key[1:]))


def with_errors(key: Key, bounds: ProvenBounds) -> ProvenBounds:
    slope = with_errors_of(key, DERIVATIVE, bounds.slope) if bounds.slope else None
    return replace(with_errors_of(key, VALUE, bounds), slope=slope)


def with_errors_of(key: Key, result: str, bounds: ProvenBounds) -> ProvenBounds:
    """With the published errors, and what is kept."""
    of = key[0], key[1], key[2].name if key[2] else "none", result
    cell, position, fixed = (record.entry_of(Recorded(*of, "", place, arithmetic))
                             for place, arithmetic in ((CELL, FLOATS), (POSITION, FLOATS), (CELL, FIXED)))
    limits = kept(*of).limits(key[0], bounds.range, bounds.promise, (position.proven_or_published, fixed.proven_or_published))
    return replace(bounds, lipschitz=below(kept(*of).lipschitz), cell_error=cell.published, error=position.published,
                   fixed_error=fixed.published, largest=below(limits[0]), fixed_largest=below(limits[1]))


def below(number: float) -> float:
    """So that rounding up returns the decimal that this was."""
    return math.nextafter(number, 0.0) if math.isfinite(number) else number


def derive_family(name: str) -> list[ProvenBounds]:
    return [derived_of(key) for key in keys() if family(key) == name]


def derive() -> Everything:
    """All of it, on all cores: each family in one process, which computes once the parts that its noises share."""
    families = {name: [key for key in keys() if family(key) == name] for name in map(family, keys())}
    with ProcessPoolExecutor() as pool:
        return {key: of_key for of_family, some in zip(families.values(), pool.map(derive_family, families))
                for key, of_key in zip(of_family, some)}


def rendered(derived: Everything) -> str:
    """The table that the suite includes."""
    rows = [row_of("NOISE_BOUNDS", of_noise.bounds(*key)) for key, of_noise in derived.items()]
    rows += [row_of("SLOPE_BOUNDS", of_noise.slope.bounds(*key)) for key, of_noise in derived.items() if of_noise.slope]
    error_of_floats = math.nextafter(of_sine(False), 1.0).hex().replace("1.0000000000000p", "1p")
    rows.append(row("SINE_BOUNDS", error_of_floats, scientific(of_sine(True))))
    rows.append(row("UNIFORM_BOUNDS", *(scientific(record.published("uniform", 0, "none", result, arithmetic=arithmetic))
                                        for arithmetic in (FLOATS, FIXED) for result in (VALUE, "slope", "reach", "coefficient"))))
    return HEAD + "".join(rows)


def files(derived: Everything, root: Path = ROOT) -> dict[Path, str]:
    """The written files with their right text."""
    page = root / ACCURACY
    return {root / PATH.relative_to(ROOT): rendered(derived),
            page: with_tables(page.read_text(encoding="utf-8"), derived)}


def without_proof() -> list[str]:
    """A message for each need of the catalog's functions that no proof and no record meets, and each claim on sums."""
    of_all = catalog.model.read()
    found = [f"tools/lib/proof/bounds/features.py has no proof of the metric {metric}"
             for metric in of_all.metrics if metric not in METRICS]
    for sum_ in of_all.sums:
        if sum_.name not in OF_THEIR_OWN:
            found += [f"catalog/sums.toml: {wrong}" for wrong in claims.wrong_sum(sum_)]
    recorded = {(key.name, key.arithmetic) for key in record.read()}
    for name, dims in {(function.bound, function.axes) for function in read_functions()}:
        if name in noises.names():
            if all(dims != of_case for of_case, _ in noises.find(name).cases):
                found.append(f"tools/lib/proof/bounds/noises has no proof of {name} in {dims}D")
        elif name not in ("exact", "perlin_worley"):
            found += [f"{record.PATH.name} has no error of {name}, {arithmetic}: run tools/make errors"
                      for arithmetic in (FLOATS, FIXED) if (name, arithmetic) not in recorded]
    return sorted(set(found))


OF_THEIR_OWN = ("gullies", "uniform", "perlin_worley")  # the last has its bound in conformance/expected/tolerance.cpp


def differences(derived: Everything, root: Path = ROOT) -> list[str]:
    old = [f"{path}: not up to date; run tools/make bounds" for path, content in files(derived, root).items()
           if not path.is_file() or path.read_text(encoding="utf-8") != content]
    of_all = catalog.model.read(root / "catalog")
    return [*old, *missing_quotes(derived, root), *wrong_comments(derived, root / "glsl"),
            *claims.wrong_noises(of_all, derived), *claims.wrong_comments(of_all, derived, root / "glsl")]


def everything_for_a_reader(derived: Everything) -> dict[str, dict[str, object]]:
    return {name_of(key): asdict(of_noise) for key, of_noise in derived.items()}


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
    derived = derive()
    if options.table:
        print_table(everything_for_a_reader(derived))
        return 0
    if not options.check:
        for path, content in files(derived).items():
            path.write_text(content, encoding="utf-8")
    messages = [*identity.wrong_texts(), *differences(derived)]
    print("\n".join(messages or [f"the bounds of {len(derived)} noises are as derived"]))
    return 1 if messages else 0


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make bounds", __doc__)
    mode = parser.add_mutually_exclusive_group()
    mode.add_argument("--check", action="store_true", help="write nothing, and compare all that quotes a bound")
    mode.add_argument("--table", action="store_true", help="write nothing, and print all that is derived")
    try:
        return run(parser.parse_args(arguments))
    except (KeyError, IndexError):
        raise  # these are look-ups too, but mistakes of the program
    except LookupError as error:
        print(error, file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
