"""Whether the tests shall try everything, as with tools/test --thorough, or the pairs that stand for it."""

from __future__ import annotations

import os
import unittest
from collections.abc import Sequence
from typing import TypeVar

Choice = TypeVar("Choice")
THOROUGH = "HN_THOROUGH" in os.environ
# For tests that take long and hold what changes seldom, beside others of the same that are run always.
in_thorough_runs = unittest.skipUnless(THOROUGH, "takes long: tools/test --thorough")


def some(choices: Sequence[Choice], turn: int, count: int = 1) -> Sequence[Choice]:
    """So many of the choices, others with each turn; in a thorough run all of them."""
    return choices if THOROUGH else [choices[(turn * count + i) % len(choices)] for i in range(count)]
