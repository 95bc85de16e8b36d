"""The ranges and errors that catalog/ claims, against what is derived; and that its texts and the comments of the
library have no other ranges."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from pathlib import Path

from catalog.model import Catalog, Function, Noise, Sum
from catalog.tables import glsl
from proof.bounds import noises, sums
from proof.bounds.documents import Everything
from proof.bounds.gradients import GRADIENTS, SINE
from proof.bounds.table import bounds_of, shortest
from proof.errors import record
from proof.errors.record import FIXED, FLOATS
from proof.oracle.sums import SUMS, Terms

Range = tuple[float, float] | str

# --- Texts ------------------------------------------------------------------------------------------------------------

END = r"-?(?:\d[\d./]*|amplitude)"
PAIR = re.compile(rf"\[({END}), ({END})[\])]")


def wrong_pairs(text: str, ranges: set[Range]) -> list[str]:
    """The ranges in a text that are not among these."""
    def value(pair: re.Match[str]) -> Range:
        return pair[2] if pair[2] == "amplitude" else (float(Fraction(pair[1])), float(Fraction(pair[2])))

    return [pair[0] for pair in PAIR.finditer(text) if value(pair) not in ranges]


def wrong_texts(function: Function, ranges: set[Range]) -> Iterator[str]:
    for key, text in (("returns", function.returns), ("brief", function.brief), ("use", function.use)):
        for pair in wrong_pairs(text, ranges):
            yield f"{function.name}: {key} has {pair}, which is not its range"


def ranges_of(function: Function) -> set[Range]:
    if isinstance(function, Noise):
        return {pair for pairs in function.all_ranges.values() for pair in pairs if pair}
    return {(-1, 1) if function.range == "noise" else function.range}


def wrong_comments(of_all: Catalog, derived: Everything, library: Path) -> list[str]:
    """In the line `returns` of a noise or a sum. documents.py compares those with decimals."""
    ranges = {f"hn_{one.name}": ranges_of(one) for one in (*of_all.noises, *of_all.sums)}
    sine = derived["perlin", 3, SINE].promise  # times which ranges are larger with that gradient in space
    messages = {}  # overloads share a comment
    for function in glsl.declarations(library):
        text = " ".join(function.comment.lines) if function.comment and function.name in ranges else ""
        for returns in re.findall(r"   ?returns  (.*?)(?=   ?[a-z]+  |$)", text):
            of = ranges[function.name]
            larger = {(least * sine, most * sine) for least, most in of} if "HN_GRADIENT_SINE" in returns else set()
            place = f"{function.path}:{function.comment.line}"
            messages |= {f"{place}: {pair} is not the range of {function.name} in catalog/": None
                         for pair in wrong_pairs(returns, of | larger) if "." not in pair}
    return list(messages)


# --- Sums -------------------------------------------------------------------------------------------------------------

# Of sums that are no means of steps: means with weights of at most 1 of noises in [-1, 1], those times the amplitude,
# and 1 - (1 - fbm) (1 - balls) / 4 of two such means (docs/reference/contract.md, section 25).
OTHER_SUMS: dict[str, Range] = {"fbm_d": (-1, 1), "eroded": (-1, 1), "warp": "amplitude",
                                "warp_progressive": "amplitude", "perlin_worley": (0, 1)}


def range_of_flows() -> Range:
    """A component is no more than the length of the longest velocity, in space and with a phase."""
    most = float(shortest(math.sqrt(3) * bounds_of("curl_phase", 3, "none").fixed_limit, 3))
    return -most, most


ERROR = re.compile(r"(?:(?P<factor>twice the strength times |twice |\d times )?`(?P<other>\w+)`'s"
                   r"(?P<more>, and a little more)?(?:, plus (?P<floats>\d\.\de-\d) \(HN_FIXED (?P<fixed>\d\.\de-\d)\))?"
                   r"(?:; docs/measured/accuracy\.md)?|"
                   r"(?:grows with the octaves, since each is multiplied by the one before: )?"
                   r"docs/measured/accuracy\.md|)")
FORMS = ('"`SUM`\'s" of another sum of values, "twice `SUM`\'s", "3 times `SUM`\'s", "twice the strength times `SUM`\'s", '
         'each with ", and a little more" or ", plus 1.2e-3 (HN_FIXED 1.2e-3)" if need be; "docs/measured/accuracy.md"; '
         'or nothing')
MORE = 1.25  # a little more, and no more
MEASURED = 1.25  # two searches may find errors that far apart
SETTINGS_OF_WORDS = ("", "strength 1", "strength 2")


def exact_sum(oracle: Callable[[Terms[Fraction]], Fraction], noises: Sequence[Fraction], strength: Fraction) -> Fraction:
    """The oracle's sum of these noises, with equal weights."""
    ones = [Fraction(1)] * len(noises)
    return oracle(Terms(list(noises), ones, ones, Fraction(1), strength))


def range_of_sum(sum_: Sum) -> Range | None:
    """The range of one octave of any noise, and of two, if it is a sum of values."""
    if sum_.name not in SUMS:
        return range_of_flows() if sum_.name in sums.FLOWS else OTHER_SUMS.get(sum_.name)
    strength = Fraction(sum_.strength.most if sum_.strength else 0)
    noises = [[Fraction(n, parts) for n in range(-parts, parts + 1)] for parts in (128, 8)]
    values = [exact_sum(SUMS[sum_.name][0], of, strength)
              for count, some in enumerate(noises, 1) for of in itertools.product(some, repeat=count)]
    return float(min(values)), float(max(values))


def wrong_error(sum_: Sum) -> str:
    """The fault of the words, or none: beside the largest errors that were found on the plane."""
    stated = ERROR.fullmatch(sum_.error)
    if not stated or (stated["other"] or "fbm") not in sums.KINDS:
        return f"the error {sum_.error} has to be one of {FORMS}"
    factor, more = int((stated["factor"] or "1")[0].replace("t", "2")), MORE if stated["more"] else 1.0
    for arithmetic, plus in ((FLOATS, stated["floats"]), (FIXED, stated["fixed"])) if stated["other"] else ():
        of, other = (max((entry.most for key, entry in record.read().items() if (key.name, key.gradient, key.arithmetic) == (
            name, GRADIENTS[0].name, arithmetic) and key.dims == 2 and key.setting in SETTINGS_OF_WORDS), default=None)
            for name in (sum_.name, stated["other"]))
        strength = 2 if "strength" in (stated["factor"] or "") else 1
        if of is not None and other is not None and of > strength * factor * more * other * MEASURED + float(plus or 0):
            return f"the error {sum_.error} is too small: {of / other:.3g} times that was found ({arithmetic})"
    return ""


def wrong_sum(sum_: Sum) -> Iterator[str]:
    """Of a sum that has its proofs."""
    range_ = range_of_sum(sum_)
    if range_ is None:
        yield f"{sum_.name}: nothing derives its range: add it to SUMS in tools/lib/proof/oracle/sums.py"
    elif {range_} != ranges_of(sum_):
        yield f"{sum_.name}: range is {sum_.range}, and {range_} is derived"
    if wrong := wrong_error(sum_):
        yield f"{sum_.name}: {wrong}"
    yield from wrong_texts(sum_, ranges_of(sum_) | ({(0, sum_.strength.most)} if sum_.strength else set()))


# --- Noises -----------------------------------------------------------------------------------------------------------


def ends_of(noise: Noise, component: str, dims: int, derived: Everything) -> tuple[list[float], list[float]]:
    """The least value and the greatest: as promised, of the exact noise, and as computed. None if nothing is."""
    base, _, phase = component.partition("_")
    name = f"{noise.name}_{phase}" if phase else noise.name
    if re.fullmatch(r"f\d", base):
        proofs = ["cellular_phase"] if phase else ["cellular", "cellular_three"]
        return [0.0], [[end for proof in proofs for end in noises.find(proof).ends(dims)][int(base[1]) - 1]]
    of = derived.get((name, dims, GRADIENTS[0])) or derived.get((name, dims, None))
    if not of:
        return [], []
    of, least = (base == "d" and of.slope) or of, noises.find(name).least
    greatest = [of.promise, of.range, max(of.largest, of.fixed_largest)]
    return [least(dims)] if least else [-end for end in greatest], greatest


def is_derived(end: float, derived: list[float]) -> bool:
    """Whether it is one of them, rounded to its digits away from 0."""
    digits = len(f"{abs(end):g}".replace(".", "").lstrip("0")) or 1
    return f"{end:g}" in ["-" * (value < 0) + shortest(abs(value), digits) for value in derived]


def wrong_noise(noise: Noise, derived: Everything) -> Iterator[str]:
    for component, pairs in noise.all_ranges.items():
        for dims, pair in enumerate(pairs, noise.first):
            ends = ends_of(noise, component, dims, derived)
            if pair and not all(map(is_derived, pair, ends)):
                yield (f"{noise.name}: the range of {component} in {dims}D is {list(pair)}; "
                       + (f"derived are {ends[0]} and {ends[1]}" if ends[0] else "nothing derives it"))
    yield from wrong_texts(noise, ranges_of(noise))


def wrong_noises(of_all: Catalog, derived: Everything) -> list[str]:
    return [f"catalog/noises.toml: {wrong}" for noise in of_all.noises if noise.name in noises.names()
            for wrong in wrong_noise(noise, derived)]
