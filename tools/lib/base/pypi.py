"""Packages of PyPI for tests, which are skipped where it cannot be reached."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
import venv
from collections.abc import Callable
from pathlib import Path

from base.debian import SKIPPED, Missing
from base.tree import ROOT

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


def place_of(package: str) -> Path:
    """Where a package==VERSION of a registry is kept."""
    return ROOT / "build" / package.replace("==", "-")


def kept(folder: Path, fill: Callable[[Path], None]) -> Path:
    """The folder, which is filled if it is not there. It is whole when it is there."""
    if not folder.exists():
        folder.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=folder.parent) as place:
            whole = Path(place) / "whole"
            whole.mkdir()
            fill(whole)
            try:
                whole.rename(folder)
            except OSError:
                if not folder.exists():  # another test was faster
                    raise
    return folder


def installed(package: str, *options: str) -> Path:
    """The folder of builds in which a package is."""
    try:
        return kept(place_of(package),
                    lambda folder: _pip("install", package, "--no-input", *options, "--target", folder))
    except RuntimeError as error:  # it may not be for this machine
        raise Missing(str(error)) from error


def downloaded(package: str, folder: Path, *options: str) -> Path:
    """The archive of a package alone, in the folder, which has no other."""
    _pip("download", package, "--no-deps", *options, "--dest", folder)
    found, = folder.glob("*.*")
    return found


def _pip(command: str, package: str, *options: str | Path) -> None:
    words = [sys.executable, "-m", "pip", "--disable-pip-version-check", command, "--quiet", *options, package]
    try:
        done = subprocess.run(words, capture_output=True, text=True, check=False, timeout=300)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise Missing(f"pip cannot {command} {package}: {error}") from error
    if done.returncode != 0:
        said = done.stdout + done.stderr
        raise (Missing if OFFLINE.search(said) else RuntimeError)(f"pip cannot {command} {package}: {said.strip()[-300:]}")
