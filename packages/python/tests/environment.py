"""Where the tests of the package run: a new virtual environment with its wheel, and with what requirements.txt names.

    environment.py make FOLDER [LIBRARY]   makes it in FOLDER; the wheel is built by tools/pack python, and linked with
                                           LIBRARY if that is named
    environment.py run [--with FILE] FOLDER MODULE...
                                           runs modules of tests in it, with what a file of requirements names beside
                                           this one, which is kept in a folder beside FOLDER
    environment.py call [--with FILE] FOLDER MODULE [ARGUMENT]...
                                           runs one module as a program there

Exit status: 0 done, 1 not, 77 PyPI cannot be reached, so there is no such environment.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import venv
from pathlib import Path

TESTS = Path(__file__).resolve().parent
ROOT = TESTS.parents[2]
sys.path.insert(0, str(ROOT / "tools" / "lib"))

from base.pypi import SKIPPED, install  # noqa: E402

MADE = "made"  # a file that appears when all is there


def make(folder: Path, requirements: Path, library: Path | None = None) -> int:
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    python = folder / "venv" / "bin" / "python"
    venv.create(folder / "venv", with_pip=True, symlinks=True)
    if status := install(python, requirements):
        return status
    linked = ["--library", library] if library else []
    # It has pip and numpy, which tools/pack python would install once more.
    done = subprocess.run([ROOT / "tools" / "pack", "python", "--python", python, *linked, folder / "wheels"],
                          stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        print(f"tools/pack python ended with status {done.returncode}")
        return 1
    subprocess.run([python, "-m", "pip", "--disable-pip-version-check", "install", "--quiet", "--no-deps",
                    done.stdout.splitlines()[-1]], check=True)
    (folder / MADE).touch()
    return 0


def run(folder: Path, program: list[str], more: Path | None = None) -> int:
    """python -m PROGRAM, in the folder of the tests."""
    if not (folder / MADE).exists():
        print(f"{folder} has no environment: python.wheel was skipped, or did not run")
        return SKIPPED
    python = folder / "venv" / "bin" / "python"
    variables = {**os.environ}
    if more:
        added = folder.with_name(f"{folder.name}-{more.stem}")
        if status := add(python, more, added):
            return status
        variables["PYTHONPATH"] = str(added)
    return subprocess.run([python, "-B", "-m", *program], cwd=TESTS, env=variables, check=False).returncode


def add(python: Path, requirements: Path, folder: Path) -> int:
    """The packages that the file names, in a folder for Python's path. It is installed once, until the file or Python
    differs."""
    wanted = "".join(path.read_text(encoding="utf-8") for path in (requirements, *sorted(TESTS.glob("*.txt"))))
    wanted += os.path.realpath(python)
    made = folder / MADE
    if made.exists() and made.read_text(encoding="utf-8") == wanted:
        return 0
    shutil.rmtree(folder, ignore_errors=True)
    if status := install(python, requirements, folder):
        return status
    made.write_text(wanted, encoding="utf-8")
    return 0


def main(arguments: list[str]) -> int:
    if len(arguments) in (2, 3) and arguments[0] == "make":
        return make(Path(arguments[1]).resolve(), TESTS / "requirements.txt", *map(Path, arguments[2:]))
    before = {"run": ["unittest", "-v"], "call": []}.get(arguments[0] if arguments else "")
    if before is not None and len(arguments) > 4 and arguments[1] == "--with":
        return run(Path(arguments[3]).resolve(), [*before, *arguments[4:]], TESTS / arguments[2])
    if before is not None and len(arguments) > 2 and not arguments[1].startswith("-"):
        return run(Path(arguments[1]).resolve(), [*before, *arguments[2:]])
    print(__doc__, file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
