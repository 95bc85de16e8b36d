"""WGSL on this machine outside of a browser: PyPI's wgpu, which is naga and a driver of Vulkan, Metal or DirectX."""

from __future__ import annotations

import importlib
import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from types import ModuleType

from base.tree import ROOT
from translate.wgsl import wgpu_program

WGPU = "wgpu==0.32.0"
INPUT_WORDS = 16
OUTPUT_WORDS = 4


class Absent(Exception):
    """Why there is no wgpu here."""


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
        raise Absent(f"{WGPU} cannot be imported from {folder}: {error}") from error


def installed(package: str, *options: str) -> Path:
    """Where a package of PyPI is, in the folder of builds: it is installed if it is not there."""
    folder = ROOT / "build" / package.replace("==", "-")
    if folder.exists():
        return folder
    folder.parent.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent) as place:  # the folder's own files are whole
        whole = Path(place) / "whole"
        command = [sys.executable, "-m", "pip", "install", "--quiet", "--no-input", *options, "--target", str(whole),
                   package]
        try:
            done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=300)
        except (OSError, subprocess.TimeoutExpired) as error:
            raise Absent(f"{package} cannot be installed: {error}") from error
        if done.returncode != 0:
            raise Absent(f"{package} cannot be installed: {done.stderr.strip()[-300:]}")
        try:
            whole.rename(folder)
        except OSError:
            if not folder.exists():  # another test was faster
                raise
    return folder


class Device(wgpu_program.Device):
    def __init__(self) -> None:
        try:
            super().__init__(find_wgpu())
        except Absent:
            raise
        except Exception as error:  # its errors have no common type
            raise Absent(f"wgpu finds no device here: {error}") from error

    def compile_glsl(self, text: str) -> None:
        """Compiles a fragment shader in GLSL, which naga reads as well."""
        self.compile(text, label="shader.frag")

    def evaluate(self, text: str, inputs: Sequence[Sequence[int]]) -> list[tuple[int, ...]]:
        """The words that come out of a shader for each point: those that go in are as many as its columns."""
        words = b"".join(word.to_bytes(4, "little") for point in inputs
                         for word in (*point, *[0] * (INPUT_WORDS - len(point))))
        results = memoryview(self.run(text, words, 4 * OUTPUT_WORDS * len(inputs), len(inputs))).cast("I").tolist()
        return [tuple(results[i:i + OUTPUT_WORDS]) for i in range(0, len(results), OUTPUT_WORDS)]
