"""The build systems that PyPI has, in a virtual environment for the tests.

    environment.py FOLDER    makes it in FOLDER, of what requirements.txt names; one that is there already is kept

Exit status: 0 done, 1 not, 77 PyPI cannot be reached.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import venv
from pathlib import Path

REQUIREMENTS = Path(__file__).resolve().parent / "requirements.txt"
SKIPPED = 77
# What pip says if it reaches no registry.
OFFLINE = re.compile("NewConnectionError|ConnectTimeout|ReadTimeout|NameResolutionError|ProxyError|"
                     "Max retries exceeded|connection broken", re.I)


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
    done = subprocess.run([folder / "bin" / "python", "-m", "pip", "--disable-pip-version-check", "install", "--quiet",
                           "--retries", "1", "--requirement", REQUIREMENTS],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        print(done.stdout + done.stderr)
        if not OFFLINE.search(done.stdout + done.stderr):
            return 1
        print(f"PyPI cannot be reached, so what {REQUIREMENTS.name} names cannot be installed.")
        return SKIPPED
    shutil.copyfile(REQUIREMENTS, folder / "made")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
