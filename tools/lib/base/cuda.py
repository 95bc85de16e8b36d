"""NVIDIA's compilers of CUDA, of packages of PyPI, 490 MB in build/cuda/. They need no GPU and no driver."""

from __future__ import annotations

import ctypes
import fcntl
from pathlib import Path

from base.debian import SKIPPED, Missing
from base.pypi import environment
from base.tree import ROOT

FOLDER = ROOT / "build" / "cuda"


def toolkit() -> Path:
    """The folder with bin/nvcc, bin/ptxas, include/ and lib/libnvrtc.so.13. The first call downloads it."""
    FOLDER.parent.mkdir(exist_ok=True)
    with FOLDER.with_suffix(".lock").open("w", encoding="ascii") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # tests run beside each other
        status = environment(FOLDER, Path(__file__).with_suffix(".txt"))
    if status == SKIPPED:
        raise Missing("PyPI cannot be reached, so there is no nvcc")
    if status:
        raise RuntimeError("NVIDIA's compilers cannot be installed")
    found, = FOLDER.glob("lib/python*/site-packages/nvidia/cu[0-9]*")
    return found


class Refused(Exception):
    """NVRTC's messages, warnings among them."""


def nvrtc(code: str, *options: str) -> str:
    """The PTX that NVIDIA's compiler for run time makes of a text, without headers."""
    library = ctypes.CDLL(str(next((toolkit() / "lib").glob("libnvrtc.so.*"))))
    program, size = ctypes.c_void_p(), ctypes.c_size_t()
    library.nvrtcCreateProgram(ctypes.byref(program), code.encode(), b"text.cu", 0, None, None)
    status = library.nvrtcCompileProgram(program, len(options), (ctypes.c_char_p * len(options))(
        *(one.encode() for one in options)))
    for of in ("ProgramLog", "PTX"):
        library[f"nvrtcGet{of}Size"](program, ctypes.byref(size))
        shown = ctypes.create_string_buffer(size.value)
        library[f"nvrtcGet{of}"](program, shown)
        if status or of == "ProgramLog" and shown.value.strip():
            raise Refused(shown.value.decode())
    return shown.value.decode()
