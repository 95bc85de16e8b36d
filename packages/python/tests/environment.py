"""Where the tests of the package run: a new virtual environment with its wheel, and with what requirements.txt names.

    environment.py make FOLDER             makes it in FOLDER; the wheel is built by tools/wheel
    environment.py run FOLDER MODULE...    runs modules of tests in it

Exit status: 0 done, 1 not, 77 PyPI cannot be reached, so there is no such environment.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import venv
from pathlib import Path

TESTS = Path(__file__).resolve().parent
ROOT = TESTS.parents[2]
SKIPPED = 77
MADE = "made"  # a file that appears when all is there
# What pip says if it reaches no registry.
OFFLINE = re.compile(r"NewConnectionError|ConnectTimeout|ReadTimeout|NameResolutionError|ProxyError|Max retries exceeded|"
                     r"connection broken", re.I)


def make(folder: Path, requirements: Path) -> int:
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    python = folder / "venv" / "bin" / "python"
    venv.create(folder / "venv", with_pip=True, symlinks=True)
    pip = [python, "-m", "pip", "--disable-pip-version-check", "install", "--quiet"]
    done = subprocess.run([*pip, "--retries", "1", "--requirement", requirements], capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        print(done.stdout + done.stderr)
        if not OFFLINE.search(done.stdout + done.stderr):
            return 1
        print(f"PyPI cannot be reached, so what {requirements.name} names cannot be installed.")
        return SKIPPED
    done = subprocess.run([ROOT / "tools" / "wheel", "--python", sys.executable, folder / "wheels"],
                          stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        print(f"tools/wheel ended with status {done.returncode}")
        return 1
    subprocess.run([*pip, "--no-deps", done.stdout.splitlines()[-1]], check=True)
    (folder / MADE).touch()
    return 0


def run(folder: Path, modules: list[str]) -> int:
    if not (folder / MADE).exists():
        print(f"{folder} has no environment: python.wheel was skipped, or did not run")
        return SKIPPED
    return subprocess.run([folder / "venv" / "bin" / "python", "-B", "-m", "unittest", *modules], cwd=TESTS, check=False).returncode


def main(arguments: list[str]) -> int:
    if len(arguments) == 2 and arguments[0] == "make":
        return make(Path(arguments[1]).resolve(), TESTS / "requirements.txt")
    if len(arguments) > 2 and arguments[0] == "run":
        return run(Path(arguments[1]).resolve(), arguments[2:])
    print(__doc__, file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
