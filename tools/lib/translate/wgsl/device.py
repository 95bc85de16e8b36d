"""WGSL on this machine outside of a browser: PyPI's wgpu, which is naga and a driver of Vulkan, Metal or DirectX."""

from __future__ import annotations

import importlib
import os
import sys
from collections.abc import Sequence
from types import ModuleType

from base.debian import Missing
from base.pypi import installed
from translate.wgsl import wgpu_program

WGPU = "wgpu==0.32.0"
INPUT_WORDS = 16
OUTPUT_WORDS = 4


def find_wgpu() -> ModuleType:
    """The package, which is installed if nobody has it."""
    os.environ.setdefault("XDG_RUNTIME_DIR", "/tmp")  # else Wayland's library complains
    try:
        return importlib.import_module("wgpu")
    except ImportError:
        folder = installed(WGPU)
    sys.path.insert(0, str(folder))
    importlib.invalidate_caches()
    try:
        return importlib.import_module("wgpu")
    except ImportError as error:
        raise Missing(f"{WGPU} cannot be imported from {folder}: {error}") from error


class Device(wgpu_program.Device):
    def __init__(self) -> None:
        try:
            super().__init__(find_wgpu())
        except Missing:
            raise
        except Exception as error:  # its errors have no common type
            raise Missing(f"wgpu finds no device here: {error}") from error

    def compile_glsl(self, text: str) -> None:
        """Compiles a fragment shader in GLSL, which naga reads as well."""
        self.compile(text, label="shader.frag")

    def evaluate(self, text: str, inputs: Sequence[Sequence[int]]) -> list[tuple[int, ...]]:
        """The words that come out of a shader for each point: those that go in are as many as its columns."""
        words = b"".join(word.to_bytes(4, "little") for point in inputs
                         for word in (*point, *[0] * (INPUT_WORDS - len(point))))
        results = memoryview(self.run(text, words, 4 * OUTPUT_WORDS * len(inputs), len(inputs))).cast("I").tolist()
        return [tuple(results[i:i + OUTPUT_WORDS]) for i in range(0, len(results), OUTPUT_WORDS)]
