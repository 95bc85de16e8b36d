"""Section 18 of docs/reference/contract.md: numbers, directions and points from a word. (hashes.py has its published
hashes.)

All values are exact: words, and floats that are integers divided by a power of two.
"""

from __future__ import annotations

from collections.abc import Sequence

from proof.oracle import integers
from proof.oracle.feature_points import fixed_root
from proof.oracle.gradients import unorm
from proof.oracle.hashes import MASK, SEED_STEP, mix
from proof.oracle.integers import signed

POINT_UNIT = 2**16  # of directions and points
NORMAL_UNIT = 2**13


def rehash(h: int, k: int) -> int:
    """hn_rehash: r_k, a further word of h."""
    return mix(h + k * SEED_STEP & MASK)


# --- Numbers -----------------------------------------------------------------------------------------------------


def unorms(h: int, count: int) -> tuple[float, ...]:
    """hn_unorm_two, hn_unorm_three, hn_unorm_four: the first of them is of h itself."""
    return (unorm(h), *(unorm(rehash(h, k)) for k in range(1, count)))


def gaussian_of(coins: int, total: int) -> int:
    """N of so many coins, 0 to 63, and the sum of three numbers of ten bits."""
    return 2048 * coins + 2 * total - 67581


def gaussian(h: int) -> float:
    coins = rehash(h, 1).bit_count() + (rehash(h, 2) >> 1).bit_count()
    total = sum(h >> shift & 1023 for shift in (0, 10, 20))
    return gaussian_of(coins, total) / NORMAL_UNIT


# --- Directions and points ---------------------------------------------------------------------------------------


def circle_units(h: int) -> tuple[int, int]:
    """C and S."""
    return integers.cosine_and_sine(h)


def radius(z: int) -> int:
    """R: of the circle of the sphere at the height Z, in units of 2^-15."""
    return fixed_root(2**32 - z * z >> 4) >> 3


def sphere_of(h: int, height: int) -> tuple[int, int, int]:
    """X, Y and Z, with a word for the height: r_1, unless the caller has another."""
    c, s = circle_units(h)
    z = 2 * (height >> 16) - 65535
    r = radius(z)
    return signed(c * r) >> 15, signed(s * r) >> 15, z


def sphere_units(h: int) -> tuple[int, int, int]:
    return sphere_of(h, rehash(h, 1))


def largest(h: int, further: Sequence[int]) -> int:
    """U: the largest of the numbers of 15 bits that the further words of h begin with."""
    return max(rehash(h, k) >> 17 for k in further)


def shortened(units: Sequence[int], u: int) -> tuple[int, ...]:
    """A vector whose length is multiplied by a number in units of 2^-15."""
    return tuple(signed(x * u) >> 15 for x in units)


def in_units(units: Sequence[int]) -> tuple[float, ...]:
    return tuple(x / POINT_UNIT for x in units)


def circle(h: int) -> tuple[float, ...]:
    return in_units(circle_units(h))


def disk(h: int) -> tuple[float, ...]:
    return in_units(shortened(circle_units(h), largest(h, (1, 2))))


def sphere(h: int) -> tuple[float, ...]:
    return in_units(sphere_units(h))


def ball(h: int) -> tuple[float, ...]:
    return in_units(shortened(sphere_units(h), largest(h, (2, 3, 4))))


# --- A permutation -----------------------------------------------------------------------------------------------


ROUNDS = 10


def shuffle_step(x: int, m: int, seed: int) -> int:
    """Where the step takes x, in a permutation of 0 to m, which is 2^b - 1."""
    s, c = mix(seed), (m.bit_length() + 1) >> 1
    for k in range(1, ROUNDS + 1):
        a, d = rehash(s, k), 1 if k % 2 else c
        x = (x ^ x >> d) * (a | 1) + (a >> 16) & m
    return x


def shuffle(i: int, n: int, seed: int) -> int:
    if n <= 1:
        return 0
    m = 2**(n - 1).bit_length() - 1
    x = shuffle_step(i % n, m, seed)
    while x >= n:
        x = shuffle_step(x, m, seed)
    return x


# --- A Sobol sequence --------------------------------------------------------------------------------------------


def reversed_bits(word: int) -> int:
    return int(f"{word:032b}"[::-1], 2)


def scramble(x: int, s: int) -> int:
    """Each bit of the result depends on that bit and those below it."""
    x ^= x * 0x3D20ADEA & MASK
    x = x + s & MASK
    x = x * (s >> 16 | 1) & MASK
    x ^= x * 0x05526C56 & MASK
    return x ^ (x * 0x53A22864 & MASK)


def order(i: int, s: int) -> int:
    """j: which point comes as point i. Each of its bits depends on that bit of i and those above it."""
    return reversed_bits(scramble(reversed_bits(i), s))


def second_axis(j: int) -> int:
    """y of the point; its lowest bit is the first one behind the point. (x is j itself.)"""
    y, v = 0, 1
    for k in range(32):
        if j >> k & 1:
            y ^= v
        v ^= v << 1  # v_k has k + 1 bits
    return y


def sobol(i: int, seed: int) -> tuple[float, float]:
    s = mix(seed)
    j = order(i, rehash(s, 3))
    return (unorm(reversed_bits(scramble(j, rehash(s, 1)))),
            unorm(reversed_bits(scramble(second_axis(j), rehash(s, 2)))))
