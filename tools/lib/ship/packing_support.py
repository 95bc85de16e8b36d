"""Shared parts of the packages' tests."""

from __future__ import annotations

import contextlib
import io
import posixpath
import re
import tempfile
import unittest
from collections.abc import Iterable, Mapping
from pathlib import Path

from ship import command


def made(case: type[unittest.TestCase], name: str, *options: str) -> tuple[Path, Path]:
    """A folder for all tests of a class, and the package that tools/pack has made in it."""
    scratch = tempfile.TemporaryDirectory()
    case.addClassCleanup(scratch.cleanup)
    with contextlib.redirect_stdout(io.StringIO()) as out:
        command.main([name, *options, scratch.name])
    return Path(scratch.name), Path(out.getvalue().strip())


def lost_links(pages: Mapping[str, str], names: Iterable[str]) -> list[str]:
    """Links of these pages of a package that lead to no file in it, of those that lead nowhere else."""
    there = {posixpath.normpath(name) for name in names}
    found = []
    for path, page in pages.items():
        prose = re.sub(r"(?ms)^```.*?^```$|`[^`\n]*`", "", page)
        for link in re.findall(r"\]\(([^)#]+)[^)]*\)", prose):
            if "://" not in link and posixpath.normpath(posixpath.join(posixpath.dirname(path), link)) not in there:
                found.append(f"{path}: {link}")
    return found
