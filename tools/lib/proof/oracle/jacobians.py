"""Section 7 of docs/reference/contract.md, slopes, shifts and flows: sums with derivatives, eroded sums, warps, and sums
of velocities. They are exact here, and in fixed arithmetic (section 8).

The Jacobian of an octave is a matrix: what takes a small step of the position to the octave's, times its weight.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from proof.oracle import sums
from proof.oracle.gradients import Knobs, Real
from proof.oracle.hashes import signed as wrapped
from proof.oracle.integers import NOISE_UNIT, SLOPE_UNIT, word
from proof.oracle.noises import Noise, find
from proof.oracle.sums import FixedPlace, Options, Place, Terms, clamped, fixed_at, rotate

LARGEST_STRENGTH, LARGEST_AMPLITUDE = 16, 64
LARGEST_SUM = 8  # of the slopes that an eroded sum looks at


# --- Exact -------------------------------------------------------------------------------------------------------

Vector = list[Fraction]
Matrix = list[Vector]  # of rows


def times(matrix: Matrix, v: Sequence[Fraction]) -> Vector:
    return [sum((a * x for a, x in zip(row, v, strict=True)), Fraction(0)) for row in matrix]


def transposed(matrix: Matrix) -> Matrix:
    return [list(column) for column in zip(*matrix)]


def jacobians_of(n: int, options: Options, periods: Sequence[int] = ()) -> Iterator[Matrix]:
    """The Jacobians of all octaves, without end."""
    jacobian = [[Fraction(i == j) for j in range(n)] for i in range(n)]
    factor = Fraction(options.gain) * sums.growth_of(options, periods)
    while True:
        yield jacobian
        columns = [[factor * x for x in column] for column in zip(*jacobian)]
        if not periods:
            columns = [rotate(column, sums.thirty_second) for column in columns]
        jacobian = transposed(columns)


def slopes_of(noise: Noise, knobs: Knobs, place: Place, options: Options, seed: int,
              periods: Sequence[int]) -> tuple[list[Fraction], list[Vector]]:
    """The noise and its derivatives in each octave."""
    found = [noise.exact(knobs, q, s, p) for q, p, s in sums.octaves_of(place, options, seed, periods)]
    return [value for value, *_ in found], [g for _, *g in found]


def terms_of(noises: list[Fraction], options: Options) -> Terms[Fraction]:
    weights = sums.weights(options)
    return Terms(noises, weights, weights, Fraction(options.gain), Fraction(options.strength))


def fbm_d(noise: Noise, knobs: Knobs, place: Place, options: Options, seed: int,
          periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    noises, slopes = slopes_of(noise, knobs, place, options, seed, periods)
    terms = terms_of(noises, options)
    if not noises:
        return (Fraction(0),) * (1 + len(place))
    # A Jacobian has the weight in it already.
    parts = [times(transposed(jacobian), g) for g, jacobian in zip(slopes, jacobians_of(len(place), options, periods))]
    return (sums.fbm(terms), *(sum(along, Fraction(0)) / sum(terms.weights) for along in zip(*parts)))


def eroded(noise: Noise, knobs: Knobs, place: Place, options: Options, seed: int,
           periods: Sequence[int] = ()) -> tuple[Fraction]:
    noises, slopes = slopes_of(noise, knobs, place, options, seed, periods)
    strength = clamped(options.strength, 0, LARGEST_STRENGTH)
    terms, e, shares = terms_of(noises, options), [Fraction(0)] * len(place), []
    for weight, g in zip(terms.weights, slopes, strict=True):
        if not periods:
            e = rotate(e, sums.thirty_second)
        e = [clamped(a + b, -LARGEST_SUM, LARGEST_SUM) for a, b in zip(e, g)]
        shares.append(weight / (1 + strength * sum(x * x for x in e)))
    return (sums.fbm(replace(terms, shares=shares)),)


def vector(noise: Noise, knobs: Knobs, octave: sums.Octave) -> Vector:
    """v_i."""
    q, periods, seed = octave
    return [clamped(v, -1, 1) for v in noise.exact(knobs, q, seed, periods)]


def shift_of(vectors: list[Vector], options: Options, n: int) -> tuple[Fraction, ...]:
    """The mean of the octaves' vectors, times the amplitude."""
    if not vectors:
        return (Fraction(0),) * n
    amplitude = clamped(options.amplitude, 0, LARGEST_AMPLITUDE)
    return tuple(amplitude * sums.fbm(terms_of(list(along), options)) for along in zip(*vectors))


def warp(noise: Noise, knobs: Knobs, place: Place, options: Options, seed: int,
         periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    octaves = sums.octaves_of(place, options, seed, periods)
    return shift_of([vector(noise, knobs, octave) for octave in octaves], options, len(place))


# The exact place of an octave would have 15 times as many digits as the one before it. This is finer than any
# double by far, even after all that octaves make of the difference.
FINEST = 2**256


def rounded(x: Fraction) -> Fraction:
    return Fraction(math.floor(x * FINEST), FINEST)


def progressive_octaves(noise: Noise, knobs: Knobs, place: Place, options: Options, seed: int,
                        periods: Sequence[int] = ()) -> Iterator[tuple[sums.Octave, Vector]]:
    """Each octave, at the place to which those before it have moved, and its vector."""
    octave, total = (place, periods, seed), sum(sums.weights(options))
    jacobians = jacobians_of(len(place), options, periods)
    for _ in range(sums.count_of(options)):
        v = vector(noise, knobs, octave)
        yield octave, v
        q, *rest = octave
        moves = times(next(jacobians), [clamped(options.amplitude, 0, LARGEST_AMPLITUDE) / total * x for x in v])
        moved = [rounded(x + move) for x, move in zip(q, moves)]
        octave = sums.following((moved, *rest), sums.growth_of(options, periods))


def warp_progressive(noise: Noise, knobs: Knobs, place: Place, options: Options, seed: int,
                     periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    octaves = progressive_octaves(noise, knobs, place, options, seed, periods)
    return shift_of([v for _, v in octaves], options, len(place))


def back(v: Sequence[Fraction]) -> Vector:
    """The velocity of an octave, rotated back by one octave."""
    x, y, *rest = v
    if rest:
        (z,) = rest
        x, y, rest = Fraction(1010, 1024) * x, (29 * y + 13 * z) / 32, [Fraction(1025, 1024) * (29 * z - 13 * y) / 32]
    return [(25 * x + 20 * y) / 32, (25 * y - 20 * x) / 32, *rest]


def curl_fbm(noise: Noise, knobs: Knobs, place: Place, options: Options, seed: int,
             periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    of, weights = flowing(noise, options), sums.weights(options)
    velocities = [of.exact(knobs, q, s, p) for q, p, s in sums.octaves_of(place, options, seed, periods)]
    # From the last octave to the first, as the sum of v_0 + back(v_1 + back(v_2 + ...)).
    total = [Fraction(0)] * len(place)
    for weight, velocity in zip(reversed(weights), reversed(velocities), strict=True):
        total = [weight * v + x for v, x in zip(velocity, total if periods else back(total), strict=True)]
    return tuple(x / sum(weights) if weights else x for x in total)


def flowing(noise: Noise, options: Options) -> Noise:
    """The noise of a sum of velocities, with the phase of the sum."""
    return noise if options.phase is None else find(f"{noise.name}_phase").rotated(options.phase)


# --- Fixed -------------------------------------------------------------------------------------------------------

# Numbers that may wrap outside of the contract's domain, and only there, go through `wrapped`.

LARGEST_SLOPE = 128 * SLOPE_UNIT
LARGEST_E = LARGEST_SUM * 2**12


def prod(a: int, b: int) -> int:
    return wrapped(a * b >> 18)


def coarse(v: int) -> int:
    """The range of a float."""
    return v if abs(v) < 2**24 else int(math.copysign(abs(v) // 128 * 128, v))


def clamped_to(v: int, end: int) -> int:
    return min(max(v, -end), end)


def thirty_second(x: int) -> int:
    return wrapped(x) >> 5


@dataclass(frozen=True)
class Plane:
    """A Jacobian in 2D: the rows (c, -s) and (s, c), in units of 2^-18."""
    c: int = 2**18
    s: int = 0

    def scaled(self, m: int) -> Plane:
        return Plane(prod(self.c, m), prod(self.s, m))

    def rotated(self) -> Plane:
        return Plane(*rotate([self.c, self.s], thirty_second))

    def times(self, v: Sequence[int]) -> list[int]:
        x, y = v
        return [wrapped(prod(self.c, x) - prod(self.s, y)), wrapped(prod(self.s, x) + prod(self.c, y))]

    def transposed_times(self, g: Sequence[int]) -> list[int]:
        x, y = g
        return [wrapped(prod(self.c, x) + prod(self.s, y)), wrapped(prod(self.c, y) - prod(self.s, x))]


Row = tuple[int, int, int]


@dataclass(frozen=True)
class Space:
    """A Jacobian in 3D: its rows, in units of 2^-18."""
    rows: tuple[Row, Row, Row] = ((2**18, 0, 0), (0, 2**18, 0), (0, 0, 2**18))

    def scaled(self, m: int) -> Space:
        return Space(tuple(tuple(prod(a, m) for a in row) for row in self.rows))

    def rotated(self) -> Space:
        columns = [rotate(column, thirty_second) for column in zip(*self.rows)]
        return Space(tuple(zip(*columns)))

    def times(self, v: Sequence[int]) -> list[int]:
        return [wrapped(sum(map(prod, row, v))) for row in self.rows]

    def transposed_times(self, g: Sequence[int]) -> list[int]:
        return [wrapped(sum(map(prod, column, g))) for column in zip(*self.rows)]


JACOBIANS = {2: Plane, 3: Space}


def fixed_jacobians_of(n: int, options: Options, periods: Sequence[int] = ()) -> Iterator[Plane | Space]:
    jacobian = JACOBIANS[n]()
    multiplier = math.trunc(sums.lacunarity_of(options, periods) * 2**23)
    m = sums.in_weights(options.gain) * multiplier >> 23
    while True:
        yield jacobian
        jacobian = jacobian.scaled(m)
        if not periods:
            jacobian = jacobian.rotated()


def fixed_slopes_of(noise: Noise, knobs: Knobs, place: FixedPlace, options: Options, seed: int,
                    periods: Sequence[int]) -> tuple[list[int], list[list[int]]]:
    found = [fixed_at(noise, knobs, octave) for octave in sums.fixed_octaves_of(place, options, seed, periods)]
    value_unit, *slope_units = noise.units
    return ([math.trunc(Fraction(value * NOISE_UNIT, value_unit)) for value, *_ in found],
            [[clamped_to(math.trunc(Fraction(x * SLOPE_UNIT, unit)), LARGEST_SLOPE) for x, unit in zip(g, slope_units)]
             for _, *g in found])


def fixed_terms_of(noises: list[int], options: Options) -> Terms[int]:
    weights = sums.fixed_weights(options)
    return Terms(noises, weights, weights, sums.in_weights(options.gain), 0)


def fixed_fbm_d(noise: Noise, knobs: Knobs, place: FixedPlace, options: Options, seed: int,
                periods: Sequence[int] = ()) -> tuple[int, ...]:
    """The value in units of 2^-21, the derivatives in units of 2^-19."""
    noises, slopes = fixed_slopes_of(noise, knobs, place, options, seed, periods)
    terms = fixed_terms_of(noises, options)
    if not noises:
        return (0,) * (1 + len(place))
    # In this order, since the Jacobian behind the last octave's may be beyond any range.
    jacobians = zip(slopes, fixed_jacobians_of(len(place), options, periods))
    parts = [jacobian.transposed_times(g) for g, jacobian in jacobians]
    totals = [wrapped(sum(along)) for along in zip(*parts)]
    return (sums.fixed_fbm(terms),
            *(coarse(math.trunc(Fraction(d * 2**18, sum(terms.weights)))) for d in totals))


def fixed_shares(weights: Sequence[int], slopes: Sequence[Sequence[int]], strength: Real, rotated: bool) -> list[int]:
    """The B_i of an eroded sum."""
    s, e, shares = sums.in_weights(strength, LARGEST_STRENGTH), [0] * len(slopes[0] if slopes else ()), []
    for weight, g in zip(weights, slopes, strict=True):
        if rotated:
            e = rotate(e, thirty_second)
        e = [clamped_to(a + (b >> 7), LARGEST_E) for a, b in zip(e, g)]
        steepness = word(sum(x * x for x in e))
        shares.append(sums.product(weight, 2**34 // word(2**16 + (steepness * s >> 26))))
    return shares


def fixed_eroded(noise: Noise, knobs: Knobs, place: FixedPlace, options: Options, seed: int,
                 periods: Sequence[int] = ()) -> tuple[int]:
    noises, slopes = fixed_slopes_of(noise, knobs, place, options, seed, periods)
    terms = fixed_terms_of(noises, options)
    shares = fixed_shares(terms.weights, slopes, options.strength, not periods)
    return (sums.fixed_fbm(replace(terms, shares=shares)),)


def fixed_vector(noise: Noise, knobs: Knobs, octave: sums.FixedOctave) -> list[int]:
    return [clamped_to(v, NOISE_UNIT) for v in fixed_at(noise, knobs, octave)]


def fixed_amplitude(options: Options) -> int:
    return sums.in_weights(options.amplitude, LARGEST_AMPLITUDE)


def fixed_shift_of(vectors: list[list[int]], options: Options, n: int) -> tuple[int, ...]:
    """In units of 2^-21."""
    if not vectors:
        return (0,) * n
    means = [sums.fixed_fbm(fixed_terms_of(list(along), options)) for along in zip(*vectors)]
    return tuple(coarse(prod(v, fixed_amplitude(options))) for v in means)


def fixed_warp(noise: Noise, knobs: Knobs, place: FixedPlace, options: Options, seed: int,
               periods: Sequence[int] = ()) -> tuple[int, ...]:
    octaves = sums.fixed_octaves_of(place, options, seed, periods)
    return fixed_shift_of([fixed_vector(noise, knobs, octave) for octave in octaves], options, len(place))


def fixed_moved(place: FixedPlace, u: Sequence[int], q: int) -> FixedPlace:
    positions = [cell * sums.POSITION_UNIT + r for cell, r in place]
    return [sums.cell_and_rest(sums.reduced(x + 8 * prod(move, q))) for x, move in zip(positions, u, strict=True)]


def fixed_warp_progressive(noise: Noise, knobs: Knobs, place: FixedPlace, options: Options, seed: int,
                           periods: Sequence[int] = ()) -> tuple[int, ...]:
    vectors, octave, total = [], (place, periods, seed), sum(sums.fixed_weights(options))
    for jacobian in itertools.islice(fixed_jacobians_of(len(place), options, periods), sums.count_of(options)):
        vectors.append(fixed_vector(noise, knobs, octave))
        at, *rest = octave
        moved = fixed_moved(at, jacobian.times(vectors[-1]), (fixed_amplitude(options) << 18) // total)
        octave = sums.fixed_following((moved, *rest), sums.lacunarity_of(options, periods))
    return fixed_shift_of(vectors, options, len(place))


# The rotations of the plane have determinants, 1025/1024 and 1010/1024. They are the stretches of the axes beside it.
OF_Z, OF_X = 262400, 258560


def stretched(jacobian: Plane | Space, axis: int, factor: int) -> Plane | Space:
    """In space, with the row of an axis times the factor."""
    if isinstance(jacobian, Plane):
        return jacobian
    return Space(tuple(tuple(prod(a, factor) for a in row) if i == axis else row
                       for i, row in enumerate(jacobian.rows)))


def fixed_backs_of(n: int, options: Options, periods: Sequence[int] = ()) -> Iterator[Plane | Space]:
    """The transposed matrices that rotate velocities back, times the weights of the octaves, without end."""
    matrix, gain = JACOBIANS[n](), sums.in_weights(options.gain)
    while True:
        yield matrix
        if periods:
            matrix = matrix.scaled(gain)
        else:
            matrix = stretched(stretched(matrix, 2, OF_Z).scaled(gain).rotated(), 0, OF_X)


def fixed_curl_fbm(noise: Noise, knobs: Knobs, place: FixedPlace, options: Options, seed: int,
                   periods: Sequence[int] = ()) -> tuple[int, ...]:
    """In units of 2^-19."""
    of, total = flowing(noise, options), sum(sums.fixed_weights(options))
    velocities = [[clamped_to(v, LARGEST_SLOPE) for v in fixed_at(of, knobs, octave)]
                  for octave in sums.fixed_octaves_of(place, options, seed, periods)]
    if not velocities:
        return (0,) * len(place)
    # In this order, as for derivatives.
    matrices = zip(velocities, fixed_backs_of(len(place), options, periods))
    parts = [matrix.transposed_times(v) for v, matrix in matrices]
    return tuple(coarse(math.trunc(Fraction(wrapped(sum(along)) * 2**18, total))) for along in zip(*parts))


# --- By name -----------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Sum:
    """A sum of this file, over the noise of its name unless the user names another."""
    noise: str
    exact: Callable[..., tuple[Fraction, ...]]
    fixed: Callable[..., tuple[int, ...]]
    units: tuple[int, ...] = (NOISE_UNIT,) * 3


SUMS = {"fbm_d": Sum("perlin_d", fbm_d, fixed_fbm_d, (NOISE_UNIT, *(SLOPE_UNIT,) * 3)),
        "eroded": Sum("perlin_d", eroded, fixed_eroded), "warp": Sum("value_vector", warp, fixed_warp),
        "warp_progressive": Sum("value_vector", warp_progressive, fixed_warp_progressive),
        "curl_fbm": Sum("curl", curl_fbm, fixed_curl_fbm, (SLOPE_UNIT,) * 3)}


def exact(name: str, noise: Noise, knobs: Knobs, place: Place, options: Options, seed: int = 0,
          periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    return SUMS[name].exact(noise, knobs, place, options, seed, periods)


def fixed(name: str, noise: Noise, knobs: Knobs, place: FixedPlace, options: Options, seed: int = 0,
          periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    found = SUMS[name].fixed(noise, knobs, place, options, seed, periods)
    return tuple(Fraction(number, unit) for number, unit in zip(found, SUMS[name].units))
