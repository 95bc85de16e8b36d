"""The versions of a program on the PATH, where tools/test puts Debian's programs first."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path


def folders(program: str) -> list[str]:
    """The folders of its versions, from the oldest to the newest."""
    found: dict[tuple[int, ...], str] = {}
    for folder in os.environ["PATH"].split(os.pathsep):
        if os.access(path := Path(folder) / program, os.X_OK):
            done = subprocess.run([path, "--version"], capture_output=True, text=True, check=False)
            if done.returncode == 0 and (number := re.search(r"\d+(\.\d+)+", done.stdout)):
                found.setdefault(tuple(map(int, number[0].split("."))), folder)
    return [folder for _, folder in sorted(found.items())]


def version_of(program: str | Path) -> str:
    """The line in which it prints its version."""
    option = "version" if Path(program).name == "go" else "--version"
    done = subprocess.run([program, option], capture_output=True, text=True, check=False)
    lines = [line for line in (done.stdout + done.stderr).splitlines() if re.search(r"\d", line)]
    return f"{'' if Path(program).name in lines[0] else Path(program).name + ' '}{lines[0]}" if lines else str(program)


def path_of(folder: str) -> str:
    """A PATH that has its programs first."""
    return os.pathsep.join((folder, os.environ["PATH"]))


def take_newest(program: str) -> None:
    if found := folders(program):
        os.environ["PATH"] = path_of(found[-1])
