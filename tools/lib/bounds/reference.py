"""What the tests of the bounds compare with: the exact noise of docs/contract.md, in doubles.

The hash does not matter here, so it is a checksum.
"""

import functools
import itertools
import math
import zlib

from bounds.boxes import fade
from bounds.gradients import OCTAHEDRAL, SINE
from bounds.noises.perlin.exact import SCALE


def contract_gradient(dims, word):
    sign = -1 if word >> 31 else 1
    if dims == 2:
        a = (2 * ((word >> 22) & 511) + 1) / 512 - 1
        return (a, sign * (1 - abs(a)))
    p, q = ((2 * ((word >> shift) & 255) + 1) / 256 - 1 for shift in (23, 15))
    return ((p + q) / 2, (p - q) / 2, sign * (1 - max(abs(p), abs(q))))


def sine_gradient(dims, word):
    """The exact one; a word for each component is made of the word given."""
    return tuple(math.sin(zlib.crc32(b"%d %d" % (word, i)) - 2**31) for i in range(dims))


@functools.cache
def lattice_gradient(kind, cell, seed=0):
    word = zlib.crc32(repr((cell, seed)).encode())
    return sine_gradient(len(cell), word) if kind is SINE else contract_gradient(len(cell), word)


def exact_noise(f, gradients, kind=OCTAHEDRAL):
    """In doubles; `gradients` maps a corner to its gradient."""
    total = 0.0
    for corner in itertools.product((0, 1), repeat=len(f)):
        weight = math.prod(fade(t) if o else 1 - fade(t) for t, o in zip(f, corner))
        total += weight * sum(g * (t - o) for g, t, o in zip(gradients(corner), f, corner))
    return SCALE[kind][len(f)] * total


def exact_noise_at(p, seed=0, kind=OCTAHEDRAL):
    cell = [math.floor(x) for x in p]
    return exact_noise([x - c for x, c in zip(p, cell)],
                       lambda corner: lattice_gradient(kind, tuple(c + o for c, o in zip(cell, corner)), seed), kind)
