"""What tests of commands that make a package have in common."""

from __future__ import annotations

import contextlib
import io
import tempfile
import unittest
from collections.abc import Callable
from pathlib import Path


def made(case: type[unittest.TestCase], main: Callable[[list[str]], int], *options: str) -> tuple[Path, Path]:
    """A folder for all tests of a class, and the package that a command has made in it."""
    scratch = tempfile.TemporaryDirectory()
    case.addClassCleanup(scratch.cleanup)
    with contextlib.redirect_stdout(io.StringIO()) as out:
        main([*options, scratch.name])
    return Path(scratch.name), Path(out.getvalue().strip())
