"""Whether the tests shall try everything, as with tools/test --thorough, or the pairs that stand for it."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TypeVar

Choice = TypeVar("Choice")
THOROUGH = "HN_THOROUGH" in os.environ


def some(choices: Sequence[Choice], turn: int, count: int = 1) -> Sequence[Choice]:
    """So many of the choices, others with each turn; in a thorough run all of them."""
    return choices if THOROUGH else [choices[(turn * count + i) % len(choices)] for i in range(count)]
