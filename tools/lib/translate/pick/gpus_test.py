"""The one text of C for NVIDIA's, AMD's and Intel's compilers, and the values that pocl and GCC compute of it. In
precise arithmetic no product is fused with a sum.

    python3 -m translate.pick.gpus_test [CASE...]

Exit status: 0 all is right, 1 not, 77 a compiler or a driver is not installed.
"""

from __future__ import annotations

import functools
import re
import shutil
import unittest
from collections.abc import Sequence

from base import cuda
from base.debian import Missing
from base.testing import Case, skipped_without
from translate.pick import command
from translate.pick.languages_test import module
from translate.pick.runners import NotRun, OpenClRunner, ran, written_to

RUNNER = OpenClRunner()
AS_CUDA = '#define __global\n#define __kernel extern "C" __global__\n'  # a kernel of OpenCL
ARITHMETICS = ("fast", "fixed", "precise")
PICKED = ("hn_fbm2", "hn_fbm_d2", "hn_cellular2_nearest", "hn_cell_border3", "hn_perlin4", "hn_simplex3_place",
          "hn_next3", "hn_curl3", "hn_gullies2", "hn_warp_progressive3")
# Without quotients and roots, which AMD computes by fused products.
PRODUCTS = ("hn_perlin2", "hn_perlin_d3", "hn_value3", "hn_simplex4", "hn_curl2", "hn_value_cubic2")
# Calls of the functions at 10 million points.
CALLS = {"hn_perlin3": "x, y, z, 7u", "hn_perlin4": "x, y, z, x, 7u", "hn_value3": "x, y, z, 7u",
         "hn_simplex3": "x, y, z, 7u", "hn_cellular2": "x, y, 7u", "hn_fbm2": "x, y, 6, 2.0f, 0.5f, 7u",
         "hn_ridged3": "x, y, z, 4, 2.0f, 0.5f, 7u", "hn_cell_border2": "x, y, 7u", "hn_value_cubic2": "x, y, 7u",
         "hn_turbulence2": "x, y, 5, 2.1f, 0.6f, 7u"}
POINTS = 10_000_000
VALUES = """import ctypes, sys
import numpy
import pyopencl
device = [one for platform in pyopencl.get_platforms() for one in platform.get_devices()][0]
context = pyopencl.Context([device])
queue = pyopencl.CommandQueue(context)
program = pyopencl.Program(context, open("text.cl").read()).build(sys.argv[2:])
library = ctypes.CDLL("./text.so")
points = numpy.random.default_rng(1).uniform(-1000, 1000, (3, int(sys.argv[1]))).astype("f4")
points[:, ::16] = numpy.rint(points[:, ::16])
numbers = numpy.empty((2, points.shape[1]), "f4")
flags = pyopencl.mem_flags
given = [pyopencl.Buffer(context, flags.READ_ONLY | flags.COPY_HOST_PTR, hostbuf=axis) for axis in points]
result = pyopencl.Buffer(context, flags.WRITE_ONLY, numbers[0].nbytes)
for kernel in program.all_kernels():
    kernel(queue, (points.shape[1],), None, *given, result)
    pyopencl.enqueue_copy(queue, numbers[0], result)
    run = library["loop_" + kernel.function_name]
    run(*(ctypes.c_void_p(one.ctypes.data) for one in (*points, numbers[1])), ctypes.c_long(points.shape[1]))
    words = numbers.view("u4")
    print(kernel.function_name, numpy.count_nonzero(words[0] != words[1]), len(numpy.unique(words[0])) > 1000)
"""


@functools.cache
def text(arithmetic: str, names: Sequence[str] = PICKED) -> str:
    return command.picked(names, command.Choice("c", arithmetic))


def source(arithmetic: str, names: Sequence[str] = PICKED) -> str:
    """With kernels that call the functions."""
    of = module(arithmetic)
    return text(arithmetic, names) + RUNNER.kernels([RUNNER.call(of, of.forms[name], 8) for name in names])


class Kernels(Case):
    def of_nvidia(self, name: str, *arguments: str) -> str:
        return ran(self.folder, cuda.toolkit() / "bin" / name, *arguments)

    def architectures(self) -> list[str]:
        known = re.findall(r"compute_(\d+)", self.of_nvidia("nvcc", "--list-gpu-arch"))
        return [one for one in known if int(one) >= 75]

    def assert_fused(self, pattern: str, precise: str, fast: str) -> None:
        """Instructions of precise text have no product with a sum, and those of fast text do."""
        self.assertNotRegex(precise, pattern)
        self.assertRegex(fast, pattern)

    def test_nvcc(self) -> None:
        architectures = self.architectures()
        self.assertGreater(len(architectures), 8)
        for arithmetic in ARITHMETICS:
            written_to(self.folder, {"text.cu": AS_CUDA + source(arithmetic)})
            for one in architectures:
                with self.subTest(one, arithmetic=arithmetic):
                    shown = self.of_nvidia("nvcc", "-Werror=all-warnings", "-Xcompiler=-Wall,-Wextra", "-cubin",
                                           f"-arch=sm_{one}", "text.cu")
                    self.assertEqual(shown, "")

    def test_nvcc_fuses_no_product(self) -> None:
        shown = []
        for changed in (source("precise"), source("fast"), source("precise").replace("__fmul_rn(a, b)", "((a) * (b))")):
            written_to(self.folder, {"text.cu": AS_CUDA + changed})
            self.of_nvidia("nvcc", "-ptx", "-arch=compute_75", "text.cu")
            shown.append((self.folder / "text.ptx").read_text(encoding="ascii"))
        self.assert_fused(r"\bfma\.", shown[0], shown[1])
        self.assert_fused(r"\bfma\.", shown[0], shown[2])

    def test_nvrtc(self) -> None:
        architectures = self.architectures()
        for one in (architectures[0], max(architectures, key=int)):
            made = {arithmetic: cuda.nvrtc(AS_CUDA + source(arithmetic), f"--gpu-architecture=compute_{one}")
                    for arithmetic in ARITHMETICS}
            self.assert_fused(r"\bfma\.", made["precise"], made["fast"])
            for arithmetic in ARITHMETICS:  # nothing calls its functions
                cuda.nvrtc(text(arithmetic), f"--gpu-architecture=compute_{one}")
            for ptx in made.values():
                written_to(self.folder, {"text.ptx": ptx})
                self.of_nvidia("ptxas", f"-arch=sm_{one}", "text.ptx")
        with self.assertRaisesRegex(cuda.Refused, "math.h"):
            cuda.nvrtc(source("fast").replace("defined(__CUDACC_RTC__)", "0"))

    def test_hipcc(self) -> None:
        for chip, *options in (("gfx90a",), ("gfx1100", "-nogpulib")):  # Debian 12 has no library for the second
            made = {}
            for arithmetic in ARITHMETICS:
                for names in (PICKED, PRODUCTS):
                    shown = f"#include <hip/hip_runtime.h>\n{AS_CUDA}{source(arithmetic, names)}"
                    written_to(self.folder, {"text.hip": shown})
                    ran(self.folder, "hipcc", f"--offload-arch={chip}", *options, "--cuda-device-only", "-O2",
                        *RUNNER.SILENT, "-Wno-unused-command-line-argument", "-S", "-o", "text.s", "text.hip")
                made[arithmetic] = (self.folder / "text.s").read_text(encoding="ascii")
            self.assert_fused(r"\bv_(pk_|dual_)?(fma|fmac|mac|mad|fmaak|fmamk)_f32", made["precise"], made["fast"])

    def test_opencl_fuses_no_product(self) -> None:
        made = []
        for arithmetic in ("precise", "fast"):
            written_to(self.folder, {"text.cl": source(arithmetic, PRODUCTS)})
            ran(self.folder, "clang", "-x", "cl", "-cl-std=CL1.2", "-O2", "-mfma", "-S", "-o", "text.s", "text.cl")
            made.append((self.folder / "text.s").read_text(encoding="ascii"))
        self.assert_fused(r"\bvfn?m(add|sub)", *made)

    def test_ocloc(self) -> None:
        """Debian 12's knows Arc as acm-g10."""
        for arithmetic in ARITHMETICS:
            written_to(self.folder, {"text.cl": source(arithmetic)})
            shown = ran(self.folder, "ocloc", "compile", "-file", "text.cl", "-device", "acm-g10")
            self.assertIn("Build succeeded", shown)
        written_to(self.folder, {"text.cl": source("fast").replace("typedef int int32_t", "#include <math.h>")})
        with self.assertRaises(NotRun):
            ran(self.folder, "ocloc", "compile", "-file", "text.cl", "-device", "acm-g10")

    def differing(self, arithmetic: str, *options: str, points: int = POINTS) -> dict[str, int]:
        """How many values of OpenCL are not GCC's, by the function."""
        returned = {name: ".x" for name in ("hn_cellular2",)}
        values = {name: f"{name}({call}){returned.get(name, '')}" for name, call in CALLS.items()}
        shown = command.picked(tuple(CALLS), command.Choice("c", arithmetic))
        taken = ", ".join(f"{{0}}const float *{axis}s" for axis in "xyz") + ", {0}float *out"
        read = " ".join(f"float {axis} = {axis}s[i];" for axis in "xyz") + " (void)z;"
        kernels = "".join(f"__kernel void {name[3:]}({taken.format('__global ')}) {{ size_t i = get_global_id(0); "
                          f"{read} out[i] = {value}; }}\n" for name, value in values.items())
        loops = "".join(f"void loop_{name[3:]}({taken.format('')}, long count) {{ for (long i = 0; i < count; i++) "
                        f"{{ {read} out[i] = {value}; }} }}\n" for name, value in values.items())
        written_to(self.folder, {"text.cl": shown + kernels, "text.c": shown + loops})
        ran(self.folder, "gcc", "-std=c99", "-O2", "-ffp-contract=off", "-fPIC", "-shared", "text.c", "-lm", "-o",
            "text.so")
        lines = ran(self.folder, "env", "POCL_CACHE_DIR=cache", "PYOPENCL_NO_CACHE=1", "/usr/bin/python3", "-c", VALUES,
                    str(points), *options).splitlines()
        self.assertEqual(len(lines), len(CALLS))
        self.assertTrue(all(line.endswith(" True") for line in lines))  # values are not all the same
        return {line.split()[0]: int(line.split()[1]) for line in lines}

    def test_ten_million_points_by_opencl_and_by_gcc(self) -> None:
        for arithmetic, *options in (("fixed",), ("precise",), ("fixed", "-cl-fast-relaxed-math"),
                                     ("precise", "-cl-mad-enable")):
            with self.subTest(arithmetic, options=options):
                self.assertEqual(sum(self.differing(arithmetic, *options).values()), 0)
        self.assertNotEqual(sum(self.differing("precise", "-cl-fast-relaxed-math", points=10_000).values()), 0)


if __name__ == "__main__":
    with skipped_without():
        cuda.toolkit()
        RUNNER.check()
        if missing := [one for one in ("hipcc", "ocloc") if not shutil.which(one)]:
            raise Missing(f"there is no {' and no '.join(missing)}")
    unittest.main(verbosity=2)
