"""For tests of commands: a folder, scripts in it, and calls of main()."""

from __future__ import annotations

import contextlib
import functools
import io
import subprocess
import sys
import tempfile
import unittest
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from base.debian import SKIPPED, Missing


class Case(unittest.TestCase):
    @functools.cached_property
    def folder(self) -> Path:
        """It is empty at first, and gone after the test."""
        return Path(self.enterContext(tempfile.TemporaryDirectory()))

    def script(self, name: str | Path, text: str) -> Path:
        """A program in the folder; of the shell, unless its first line is another's."""
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text if text.startswith("#!") else f"#!/bin/sh\n{text}\n", encoding="utf-8")
        path.chmod(0o755)
        return path


def called(main: Callable[[Sequence[str]], int], *arguments: object) -> tuple[int, str]:
    """The exit status of a command, and what it prints."""
    with contextlib.redirect_stdout(io.StringIO()) as printed, contextlib.redirect_stderr(printed):
        try:
            status = main([str(word) for word in arguments])
        except SystemExit as end:
            status = end.code
    return status, printed.getvalue()


def check_opencl(python: str | Path) -> None:
    """Raises Missing if pyopencl, of that Python, has no device. The question needs a process of its own: where pocl cannot
    start, as without /sys, it aborts."""
    devices = "import pyopencl; assert any(one.get_devices() for one in pyopencl.get_platforms())"
    done = subprocess.run([python, "-c", devices], capture_output=True, text=True, check=False)
    if done.returncode < 0:
        raise Missing(f"the driver of OpenCL cannot start: {' '.join(done.stderr.splitlines())}")
    if done.returncode:
        raise Missing("there is no driver of OpenCL: apt-get install pocl-opencl-icd python3-pyopencl")


@contextlib.contextmanager
def skipped_without(*absent: type[Exception]) -> Iterator[None]:
    """Ends a program of tests as skipped where something that it needs is Missing, or absent otherwise."""
    try:
        yield
    except (Missing, *absent) as reason:
        print(f"skipped: {reason}")
        sys.exit(SKIPPED)
