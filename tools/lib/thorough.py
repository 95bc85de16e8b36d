"""Whether the tests shall try everything, as with tools/test --thorough, or the pairs that stand for it."""

import os

THOROUGH = "HN_THOROUGH" in os.environ
