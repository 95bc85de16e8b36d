"""Small programs that call the C++ twin."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from tree import ROOT


@contextmanager
def program(source: Path, *arguments: str, files: dict[str, str] | None = None) -> Iterator[str]:
    """The path of a compiled program; files are what it includes, by their names."""
    with TemporaryDirectory() as folder:
        for name, text in (files or {}).items():
            (Path(folder) / name).write_text(text, encoding="utf-8")
        path = f"{folder}/{source.stem}"
        built = subprocess.run(["c++", "-std=c++20", "-O1", "-ffp-contract=off", "-I", folder, "-I", ROOT / "include",
                                source, "-o", path, *arguments], capture_output=True, text=True, check=False)
        if built.returncode != 0:
            raise ValueError(f"{source.relative_to(ROOT)} does not compile:\n{built.stderr}")
        yield path
