"""NVIDIA's compilers of CUDA, of packages of PyPI, 490 MB in build/cuda/. They need no GPU and no driver."""

from __future__ import annotations

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
