"""The output of Slang's compiler."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from pathlib import Path

from translate.pick.runners import ran
from translate.tools import SLANG, Tool

TARGETS = ("hlsl", "spirv", "metal", "wgsl")


def compiled(text: str, target: str = "wgsl", folder: Path | None = None, macros: Mapping[str, str] | None = None,
             entry: str = "main", stage: str = "compute", tool: Tool = SLANG) -> bytes:
    """An entry point, with modules of a folder and macros, which modules see as well; raises NotRun."""
    with tempfile.TemporaryDirectory() as place:
        (Path(place) / "shader.slang").write_text(text, encoding="ascii")
        ran(Path(place), tool.path(), "shader.slang", *(("-I", folder) if folder else ()), "-target", target,
            *(f"-D{name}={value}" for name, value in (macros or {}).items()), "-entry", entry, "-stage", stage, "-o", "made")
        return (Path(place) / "made").read_bytes()
