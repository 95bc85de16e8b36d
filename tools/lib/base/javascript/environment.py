"""Tests in JavaScript run in a folder with the packages of package.json, from npm's registry. It is made here.

    environment.py make FOLDER                     makes it
    environment.py run FOLDER PROGRAM [ARGUMENT]...    runs a program of Node.js there, such as node, by tools/lib/base/node

A module finds the packages if it lies in FOLDER; the tests copy theirs there. Exit status: that of the program, 0 made,
1 it could not be made, 77 npm's registry or a Node.js cannot be had here.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
NODE = HERE.parent / "node"
SKIPPED = 77
MADE = "made"  # a file that appears when all is there, and holds the digest of its inputs
# Messages of npm if it reaches no registry, and of pip if it is to fetch Node.js.
OFFLINE = re.compile("ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ECONNRESET|ETIMEDOUT|ENETUNREACH|NewConnectionError|"
                     "ConnectTimeout|ReadTimeout|NameResolutionError|ProxyError|Max retries exceeded", re.I)


def wanted(packages: Path = HERE) -> str:
    return (packages / "package-lock.json").read_text(encoding="utf-8")


def make(folder: Path, packages: Path = HERE) -> int:
    """With what the package.json of a folder names. Other tests have other packages, in a folder below this one."""
    made = folder / MADE
    if made.exists() and made.read_text(encoding="utf-8") == wanted(packages):
        return 0
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name in ("package.json", "package-lock.json"):
        shutil.copy(packages / name, folder)
    shutil.copy(HERE / "chromium.mjs", folder)
    done = subprocess.run([NODE, "npm", "ci", "--no-audit", "--no-fund", "--fetch-retries", "1"], cwd=folder,
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        print(done.stdout + done.stderr)
        if not OFFLINE.search(done.stdout + done.stderr):
            return 1
        print("npm's registry cannot be reached, so what package.json names cannot be installed.")
        return SKIPPED
    made.write_text(wanted(packages), encoding="utf-8")
    return 0


def run(folder: Path, command: list[str]) -> int:
    if not (folder / MADE).exists():
        print(f"{folder} has no packages: javascript.packages was skipped, or did not run")
        return SKIPPED
    shutil.copy(HERE / "chromium.mjs", folder)
    return subprocess.run([NODE, *command], cwd=folder, check=False).returncode


def main(arguments: list[str]) -> int:
    if len(arguments) == 2 and arguments[0] == "make":
        return make(Path(arguments[1]).resolve())
    if len(arguments) > 2 and arguments[0] == "run":
        return run(Path(arguments[1]).resolve(), arguments[2:])
    print(__doc__, file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
