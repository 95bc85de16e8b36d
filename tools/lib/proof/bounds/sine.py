"""The sine of the sine gradient in integers (docs/reference/contract.md, section 8)."""

import functools

import numpy as np

from proof.bounds.integers import word


def fixed_sine(x):
    """g of the contract for x in [0, 2^16), in units of 2^-16."""
    u = word(x * x) >> 16
    inner = 5208 - (word(u * 288) >> 16)
    inner = 42328 - (word(u * word(inner)) >> 16)
    y = 102943 - (word(u * word(inner)) >> 16)
    return word(x * (word(y) >> 1) + 2**14) >> 15


@functools.cache
def fixed_sines():
    """g of every x."""
    return fixed_sine(np.arange(2**16, dtype=np.int64))


def fixed_sine_largest():
    """1, or the end to which a component exceeds it."""
    return max(1.0, fixed_sines().max() / 2**16)
