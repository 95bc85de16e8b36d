"""How the oracle evaluates a function of the library, found by its row: the family, what it takes, and its name."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from oracle import gradients, integers, noises, words
from oracle.gradients import Knobs, Real
from oracle.sums import SUMS
from tables.configurations import Configuration
from tables.functions import NOISES, Function

Evaluate = Callable[[Knobs, Sequence[Real]], tuple[Real, ...]]

# Whatever the knobs: of a word.
OF_A_WORD: dict[str, Callable[[int], tuple[float, ...]]] = {
    "unorm": lambda h: (gradients.unorm(h),), "snorm": lambda h: (gradients.snorm(h),),
    "gradient2": gradients.gradient2, "gradient3": gradients.gradient3}

NOISE_OF_SUMS = "perlin"  # unless the user names another


def knobs_of(configuration: Configuration) -> Knobs:
    return Knobs(configuration.hash, configuration.gradient == "sine", configuration.period)


def evaluator(function: Function, fixed: bool) -> Evaluate:
    """The function in fixed arithmetic, or exactly: of the knobs and a row of inputs."""
    n, family = function.axes, function.family
    if family == "independent" and function.name in OF_A_WORD:
        return lambda _, row: OF_A_WORD[function.name](*row)
    if family == "hash" and function.form == "words":
        return lambda knobs, row: (words.hash_words(knobs.hash, row),)
    if family == "hash" and function.form == "point":
        return lambda knobs, row: (words.lattice(knobs.hash, row[:n], row[n]),)
    if family in ("gradient", "sine_gradient") and function.form == "point":
        gradient = integers.gradient if fixed else gradients.gradient
        return lambda knobs, row: gradient(knobs, row[:n], row[n])
    if family in NOISES and function.form in ("position", "cell"):
        return _noise_evaluator(function, fixed)
    if family == "octave_sum" and function.bound in SUMS:
        octave_sum, noise = SUMS[function.bound][fixed], noises.find(NOISE_OF_SUMS)
        return lambda knobs, row: (octave_sum(noise, knobs, row[:n], *row[n:]),)
    raise function.row.error(f"the oracle has no {function.id}: tools/lib/oracle/functions.py finds what it evaluates")


def _noise_evaluator(function: Function, fixed: bool) -> Evaluate:
    n = function.axes
    try:
        noise = noises.find(function.noise)
    except LookupError as error:
        raise function.row.error(str(error)) from error
    if function.form == "cell":
        in_cell = noise.fixed_cell if fixed else noise.exact_cell
        return lambda knobs, row: (in_cell(knobs, row[:n], row[n:2 * n], row[2 * n]),)
    at_position = noise.fixed if fixed else noise.exact
    return lambda knobs, row: (at_position(knobs, row[:n], row[n]),)
