"""Shared parts of the packages' tests."""

from __future__ import annotations

import contextlib
import io
import tempfile
import unittest
from pathlib import Path

from ship import command


def made(case: type[unittest.TestCase], name: str, *options: str) -> tuple[Path, Path]:
    """A folder for all tests of a class, and the package that tools/pack has made in it."""
    scratch = tempfile.TemporaryDirectory()
    case.addClassCleanup(scratch.cleanup)
    with contextlib.redirect_stdout(io.StringIO()) as out:
        command.main([name, *options, scratch.name])
    return Path(scratch.name), Path(out.getvalue().strip())
