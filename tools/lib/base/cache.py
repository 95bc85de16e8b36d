"""Folders of build/ whose files are made of others: when a command wants them, and those have changed."""

from __future__ import annotations

import hashlib
import shutil
import tempfile
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path


def _sum(paths: Iterable[Path]) -> str:
    digest = hashlib.sha256()
    for path in sorted(paths):
        digest.update(f"{path.name} {hashlib.sha256(path.read_bytes()).hexdigest()}\n".encode())
    return digest.hexdigest()


def cached(folder: Path, sources: Iterable[Path], make: Callable[[], Mapping[str, str]]) -> Path:
    """The folder with the files that make() returns by their names. It is called if a source or a file is not as it was
    when they were made; FOLDER.made records that."""
    record, of_sources = folder.with_name(f"{folder.name}.made"), _sum(sources)

    def state() -> str:
        return f"{of_sources} {_sum(folder.iterdir())}\n"

    if folder.is_dir() and record.is_file() and record.read_text(encoding="ascii") == state():
        return folder
    files = make()
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent) as scratch:
        new = Path(scratch) / "new"
        new.mkdir()
        for name, text in files.items():
            (new / name).write_bytes(text.encode("utf-8"))
        if folder.exists():
            shutil.rmtree(folder)
        new.rename(folder)
    record.write_text(state(), encoding="ascii")
    return folder
