#!/usr/bin/env python3
"""The C++ header in kernels of CUDA and HIP: compilers take all functions without a warning, and what NVIDIA's compiler
makes of them has the bits of the twin.

Usage: kernels_test.py --tables=FOLDER COMPILER, with what tools/lib/catalog/suite.py wrote, and Clang

No GPU is needed: a CPU runs NVIDIA's PTX, as base/ptx.py translates it. In default runs Clang alone compiles, as CUDA and
HIP, without their headers.
"""

from __future__ import annotations

import concurrent.futures
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import twin_flags_test

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(ROOT / "tools" / "lib"))

from base import cuda, ptx  # noqa: E402
from base.debian import Missing  # noqa: E402
from base.thorough import in_thorough_runs  # noqa: E402

COMPILER = ""
ARITHMETICS = ("HN_FAST", "HN_PRECISE", "HN_FIXED")
CUDA = ("-xcuda", "--cuda-gpu-arch=sm_75", "-nocudainc", "-nocudalib", "-D__CUDACC__")
HIP = ("-xhip", "--offload-arch=gfx90a", "-nogpuinc", "-nogpulib")
CHECKED = ("--cuda-device-only", "-fsyntax-only")
HIPCC = ("hipcc", "-xhip", "--offload-arch=gfx90a", "-Wno-unused-command-line-argument")  # of those for the linker
WARNINGS = ("-Wall", "-Wextra", "-Werror")
# CUDA's and HIP's own headers define these.
WORDS = tuple(f"-D__{word}__=__attribute__(({word}))" for word in ("host", "device", "global"))
# A kernel is one loop of products and sums.
PRECISE = """
#define HN_ARITHMETIC HN_PRECISE
#include <hashnoise/hashnoise.hpp>
__global__ void kernel(float* n) { *n = hashnoise::hn_fbm(hashnoise::vec2(n[0], n[1]), 6, 2.0f, 0.5f, 7u); }
"""


def messages(*command: str) -> str:
    """A compiler's messages about the kernels, and all that it prints if it refuses them."""
    done = subprocess.run([*command, "-std=c++20", f"-I{ROOT / 'include'}", f"-I{twin_flags_test.TABLES}",
                           str(HERE / "kernels.cu")], capture_output=True, text=True, check=False)
    return done.stderr + (done.stdout if done.returncode else "")


def fused(*command: str) -> int:
    """How many products of PRECISE a compiler adds to a sum without rounding them, or lets NVIDIA's assembler do so."""
    with tempfile.TemporaryDirectory() as folder:
        source, out = Path(folder, "kernel.cu"), Path(folder, "out")
        source.write_text(("#include <hip/hip_runtime.h>\n" if "-xhip" in command else "") + PRECISE, encoding="ascii")
        subprocess.run([*command, "-std=c++20", f"-I{ROOT / 'include'}", source, "-o", out], check=True)
        return len(re.findall(r"\bfma\.|\bmul\.f32|\bv_(?:fma|mad|mac|fmac|pk_fma)\w*_f32", out.read_text(encoding="ascii")))


def nvcc() -> str:
    try:
        return str(cuda.toolkit() / "bin" / "nvcc")
    except Missing as why:
        raise unittest.SkipTest(str(why)) from why


class Kernels(unittest.TestCase):
    def test_clang_takes_every_function(self) -> None:
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for said in pool.map(lambda row: messages(COMPILER, *row[0], *WORDS, *WARNINGS, *CHECKED, f"-DHN_ARITHMETIC={row[1]}"),
                                 zip((CUDA, HIP, CUDA), ARITHMETICS)):
                self.assertEqual(said, "")

    def test_a_function_of_the_host_is_noticed(self) -> None:
        said = messages(COMPILER, *CUDA, *WORDS, *CHECKED, "-DHN_HASH=HN_HASH_CUSTOM", "-DHN_HASH_FN(k)=std::rand()")
        self.assertIn("reference to __host__ function 'rand'", said)

    @in_thorough_runs
    def test_what_nvcc_makes_has_the_bits_of_the_twin(self) -> None:
        # From sm_100 on NVIDIA's compiler has another optimizer.
        for arithmetic, machine in zip(ARITHMETICS, ("sm_75", "sm_120", "sm_120")):
            macros = (f"HN_ARITHMETIC={arithmetic}", "HN_TEST_EVERY_FORM")
            as_cpu = ("-O1", "-ffp-contract=off", twin_flags_test.INLINE_SOME)
            rounded = () if arithmetic == "HN_FIXED" else ("-fmad=false",)
            with self.subTest(arithmetic=arithmetic), tempfile.TemporaryDirectory() as folder:
                text, source, made = (Path(folder, f"kernels.{name}") for name in ("ptx", "c", "o"))
                self.assertEqual(messages(nvcc(), f"-arch={machine}", *rounded, "-Werror", "all-warnings", "-ptx", "-o", str(text),
                                          f"-DHN_ARITHMETIC={arithmetic}"), "")
                kernels = text.read_text(encoding="ascii")
                numbers = re.findall(r"\.entry kernel(\d+)\(", kernels)
                cases = "".join(f"case {number}: kernel{number}(in, out); return;\n" for number in numbers)
                source.write_text(ptx.to_c(kernels) + "\nvoid hn_test_kernel(int line, const void* in, void* out) {\n"
                                  f"switch (line) {{\n{cases}}}\n}}\n", encoding="ascii")
                twin = twin_flags_test.digests("g++", as_cpu, macros)
                self.assertEqual(len(twin), len(numbers))
                differ = []
                for half in ("0x3F000000u", "0x3F000001u"):  # one kernel has a wrong constant then
                    source.write_text(source.read_text().replace("0x3F000000u", half, 1), encoding="ascii")
                    subprocess.run(["gcc", "-O1", *ptx.FLAGS, "-c", source, "-o", made], check=True)
                    twin_flags_test.digests.cache_clear()  # its key is the name of the file
                    found = twin_flags_test.digests("g++", (*as_cpu, str(made)), (*macros, "HN_TEST_KERNELS"))
                    differ.append({name for name in twin if twin[name] != found[name]})
                self.assertEqual(differ[0], set())
                self.assertEqual(len(differ[1]), 1)

    def test_what_the_translator_does_not_know_is_an_error(self) -> None:
        with self.assertRaisesRegex(ValueError, "not known: vote.sync.any.pred"):
            ptx.to_c("vote.sync.any.pred %p2, %p1, -1;")

    @in_thorough_runs
    def test_hipcc_takes_every_function(self) -> None:
        for arithmetic in ARITHMETICS:
            self.assertEqual(messages(*HIPCC, *WARNINGS, *CHECKED, "-include", "hip/hip_runtime.h",
                                      f"-DHN_ARITHMETIC={arithmetic}"), "")

    @in_thorough_runs
    def test_no_product_of_precise_is_fused_with_the_option_of_the_page(self) -> None:
        for command, option in (((nvcc(), "-arch=sm_75", "-ptx"), "-fmad=false"),
                                ((*HIPCC, "-S", "--cuda-device-only", "-O3"), "-ffp-contract=off")):
            with self.subTest(command=command):
                self.assertEqual(fused(*command, option), 0)
                self.assertGreater(fused(*command), 0)


if __name__ == "__main__":
    twin_flags_test.TABLES = next(argument.partition("=")[2] for argument in sys.argv if argument.startswith("--tables="))
    COMPILER = sys.argv[-1]
    unittest.main(argv=sys.argv[:1], verbosity=2)
