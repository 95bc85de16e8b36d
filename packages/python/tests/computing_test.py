"""docs/guide/gpu-computing.md: the programs run as they stand, on a CPU, and find the bits of hashnoise.grid."""

from __future__ import annotations

import contextlib
import ctypes
import functools
import os
import re
import runpy
import subprocess
import sys
import tempfile
import types
import unittest
from pathlib import Path
from unittest import mock

import golden
import hashnoise
import numpy
import pyopencl
from documents_test import FENCE

from base import cuda
from base.debian import Missing
from base.testing import check_opencl

TEXT = (golden.ROOT / "docs" / "guide" / "gpu-computing.md").read_text(encoding="utf-8")
QUICK = ("cupy", "jax", "pyopencl")
THOROUGH = (*QUICK, "load_inline", "numba", "torch", "warp")
HEADER, ARRAYS, HOUDINI = re.findall(r"(?m)^    (tools/pick .*)$", TEXT)


def setUpModule() -> None:
    try:
        check_opencl(sys.executable)
    except Missing as reason:
        raise unittest.SkipTest(str(reason)) from None


@functools.cache
def printed(command: str) -> str:
    return subprocess.run(f"{golden.ROOT}/{command}", shell=True, check=True, capture_output=True, text=True).stdout


def program(package: str) -> str:
    found, = (block for block in FENCE.findall(TEXT) if f"import {package}\n" in block)
    return found


class Array(numpy.ndarray):
    get = numpy.ndarray.copy


class RawKernel:
    """CuPy's, without a GPU: g++ compiles the text, and runs it for one thread after the other."""

    def __init__(self, code: str, name: str) -> None:
        Path("kernel.cpp").write_text(f"""struct {{ int x; }} blockIdx, threadIdx;
#define __global__
{code}
extern "C" void run(int blocks, int threads, float *out) {{
  for (blockIdx.x = 0; blockIdx.x < blocks; ++blockIdx.x)
    for (threadIdx.x = 0; threadIdx.x < threads; ++threadIdx.x) {name}(out);
}}""", encoding="ascii")
        subprocess.run("g++ -O1 -shared -fPIC kernel.cpp -o kernel.so".split(), check=True)

    def __call__(self, grid: tuple[int], block: tuple[int], arguments: tuple[Array]) -> None:
        ctypes.CDLL(Path("kernel.so").absolute()).run(*grid, *block, ctypes.c_void_p(arguments[0].ctypes.data))


sys.modules["cupy"] = types.SimpleNamespace(  # it runs nothing without a GPU
    float32=numpy.float32, RawKernel=RawKernel, empty=lambda *of: numpy.empty(*of).view(Array))


class Programs(unittest.TestCase):
    """By default those of packages that are installed in seconds."""

    def setUp(self) -> None:
        self.enterContext(contextlib.chdir(self.enterContext(tempfile.TemporaryDirectory())))
        self.enterContext(mock.patch.dict(os.environ, TORCH_EXTENSIONS_DIR=os.getcwd(), WARP_CACHE_PATH=os.getcwd()))
        self.enterContext(mock.patch.object(sys, "path", [os.getcwd(), *sys.path]))
        for line in (HEADER, ARRAYS):
            command, name = line.split(" --out ")
            Path(name).write_text(printed(command), encoding="ascii")

    def run_program(self, code: str) -> None:
        Path("program.py").write_text(code, encoding="ascii")  # Warp reads it
        runpy.run_path("program.py")

    def test_they_run(self) -> None:
        for name in QUICK:
            with self.subTest(name):
                self.run_program(program(name))

    def test_another_seed_is_noticed(self) -> None:
        for name in ("cupy", "pyopencl"):
            with self.subTest(name), self.assertRaises(AssertionError):
                self.run_program(program(name).replace("7u)", "8u)"))

    def test_a_driver_that_cannot_start_is_a_reason_to_skip(self) -> None:
        """hwloc, by which pocl finds the processor, reads /sys in that folder: there is none."""
        with mock.patch.dict(os.environ, HWLOC_FSROOT=os.getcwd()), self.assertRaisesRegex(unittest.SkipTest, "hwloc.*sysfs"):
            setUpModule()

    def test_the_kernel_for_houdini_moves_points(self) -> None:
        kernel, = re.findall(r"(?ms)^```c\n(.*?)^```$", TEXT)
        context = pyopencl.create_some_context(interactive=False)
        program = pyopencl.Program(context, printed(HOUDINI) + kernel).build(["-cl-fast-relaxed-math"])
        points = numpy.random.default_rng(88).uniform(-8, 8, (1000, 3)).astype(numpy.float32)
        moved = points.copy()
        memory = pyopencl.Buffer(context, pyopencl.mem_flags.USE_HOST_PTR, hostbuf=moved)
        with pyopencl.CommandQueue(context) as queue:
            program.displace(queue, (1024,), None, numpy.int32(1000), memory)
            pyopencl.enqueue_copy(queue, moved, memory)
        points[:, 1] += hashnoise.fbm(points[:, 0], points[:, 2], seed=7, arithmetic="fixed")
        self.assertEqual(moved.tobytes(), points.tobytes())


class Thorough(Programs):
    def test_they_run(self) -> None:
        self.assertEqual(TEXT.count("```python"), len(THOROUGH))
        for name in THOROUGH:
            with self.subTest(name):
                self.run_program(program(name))

    def test_nvrtc_compiles_the_kernel_for_cupy(self) -> None:
        kernel, = re.findall(r'(?s)"""\n(.*?)"""', program("cupy"))
        text = Path("hashnoise.h").read_text(encoding="ascii") + kernel
        options = "-arch=sm_90", "-ftz=true", "--device-as-default-execution-space"  # CuPy's
        cuda.nvrtc(text, *options)
        with self.assertRaisesRegex(cuda.Refused, 'identifier "hn_fmb2" is undefined'):
            cuda.nvrtc(text.replace("hn_fbm2(x", "hn_fmb2(x"), *options)
