"""The build systems that PyPI has, in a virtual environment for the tests.

    environment.py FOLDER    makes it in FOLDER, of what requirements.txt names; one that is there already is kept

Exit status: 0 done, 1 not, 77 PyPI cannot be reached.
"""

from __future__ import annotations

import shutil
import sys
import venv
from pathlib import Path

TESTS = Path(__file__).resolve().parent
sys.path.insert(0, str(TESTS.parents[1] / "tools" / "lib"))

from pypi import install  # noqa: E402

REQUIREMENTS = TESTS / "requirements.txt"


def complete(folder: Path) -> bool:
    """Whether the folder has all that is asked for; made is the last file that is written."""
    made = folder / "made"
    return made.is_file() and made.read_text(encoding="ascii") == REQUIREMENTS.read_text(encoding="ascii")


def main(arguments: list[str]) -> int:
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    folder = Path(arguments[0]).resolve()
    if complete(folder):
        return 0
    shutil.rmtree(folder, ignore_errors=True)
    venv.create(folder, with_pip=True, symlinks=True)
    if status := install(folder / "bin" / "python", REQUIREMENTS):
        return status
    shutil.copyfile(REQUIREMENTS, folder / "made")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
