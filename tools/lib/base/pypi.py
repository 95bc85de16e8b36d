"""Packages of PyPI for tests, which are skipped where it cannot be reached."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import venv
from pathlib import Path

from base.debian import Missing

SKIPPED = 77
# pip's messages if it reaches no registry.
OFFLINE = re.compile("NewConnectionError|ConnectTimeout|ReadTimeout|NameResolutionError|ProxyError|"
                     "Max retries exceeded|connection broken", re.I)


def install(python: Path, requirements: Path, folder: Path | None = None) -> int:
    """Installs the packages that a file names, for the Python of a virtual environment, or into a folder: 0 if it is
    there, 1 if not, SKIPPED without PyPI. Packages in a folder are used for long, and so are compiled."""
    where = ["--no-compile"] if folder is None else ["--target", folder]
    done = subprocess.run([python, "-m", "pip", "--disable-pip-version-check", "install", "--quiet", *where,
                           "--retries", "1", "--requirement", requirements], capture_output=True, text=True, check=False)
    if done.returncode == 0:
        return 0
    print(done.stdout + done.stderr)
    if not OFFLINE.search(done.stdout + done.stderr):
        return 1
    print(f"PyPI cannot be reached, so what {requirements.name} names cannot be installed.")
    return SKIPPED


MADE = "made"  # a file of an environment, which is written last


def is_made(folder: Path, requirements: Path) -> bool:
    """Whether the virtual environment has all that the file names now."""
    made = folder / MADE
    return made.is_file() and made.read_text(encoding="ascii") == requirements.read_text(encoding="ascii")


def environment(folder: Path, requirements: Path) -> int:
    """A virtual environment with the packages that a file names. One that has them is kept. Returns as install() does."""
    if is_made(folder, requirements):
        return 0
    shutil.rmtree(folder, ignore_errors=True)
    venv.create(folder, with_pip=True, symlinks=True)
    if status := install(folder / "bin" / "python", requirements):
        return status
    shutil.copyfile(requirements, folder / MADE)
    return 0


def downloaded(package: str, folder: Path, *options: str) -> Path:
    """The archive of a package alone, in the folder, which has no other."""
    done = subprocess.run([sys.executable, "-m", "pip", "--disable-pip-version-check", "download", "--quiet",
                           "--no-deps", *options, "--dest", folder, package], capture_output=True, text=True, check=False)
    if done.returncode == 0:
        found, = folder.glob("*.*")
        return found
    if OFFLINE.search(done.stdout + done.stderr):
        raise Missing(f"PyPI cannot be reached, so there is no {package}")
    raise RuntimeError(f"{package} cannot be downloaded: {done.stdout}{done.stderr}")
