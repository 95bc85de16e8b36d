"""The kinds of gradient that HN_GRADIENT selects."""

from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True, eq=False)
class Gradient:
    name: str
    support: Callable  # of the |d_i|: the largest |g.d|
    component_error: float  # of floats: what the contract allows


OCTAHEDRAL = Gradient("octahedral", max, 0.0)
SINE = Gradient("sine", sum, 2.0**-19)
GRADIENTS = (OCTAHEDRAL, SINE)
