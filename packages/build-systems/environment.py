"""The build systems that PyPI has, in a virtual environment for the tests.

    environment.py FOLDER    makes it in FOLDER, of what requirements.txt names; one that is there already is kept

Exit status: 0 done, 1 not, 77 PyPI cannot be reached.
"""

from __future__ import annotations

import sys
from pathlib import Path

TESTS = Path(__file__).resolve().parent
sys.path.insert(0, str(TESTS.parents[1] / "tools" / "lib"))

from base.pypi import environment  # noqa: E402

REQUIREMENTS = TESTS / "requirements.txt"


def main(arguments: list[str]) -> int:
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    return environment(Path(arguments[0]).resolve(), REQUIREMENTS)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
