"""Tests of what compiles shaders by way of Metal's language: the translation, and how what compilers print is counted.
The compilers run in thorough runs, as gpu_test.py does."""

from __future__ import annotations

import math
import os
import re
import subprocess
import unittest
from pathlib import Path
from unittest import mock

from base import debian, glslang
from base.debian import Missing
from base.testing import Case
from base.thorough import in_thorough_runs
from base.twin import SOON, compile_program
from measure.gpu import command, drivers, kernels, record
from measure.gpu.chips import CHIPS, chip_named
from measure.gpu.compiling import Device

# With a table, a loop, a minimum, and a product that must not be contracted.
SHADER = """#version 450
layout(location = 0) in float p;
layout(location = 0) out float result;
void main() {
  const float table[3] = float[3](0.5, 0.25, 0.125);
  float least = p;
  for (int i = 0; i < 3; ++i) {
    precise float product = least * table[int(p + float(i))];
    least = min(product, p);
  }
  result = least * p + 1.0;
}
"""
# In Metal's language; nothing is exact in it.
METAL = "\nfragment float main0(main0_in in [[stage_in]]);\n"
SASS = """\t.target\tsm_90
.text.k0:
        /*0000*/                   LDC R1, c[0x0][0x28] ;
        /*0010*/                   EXIT ;
.L_x_0:
        /*0020*/                   BRA `(.L_x_0);
        /*0030*/                   NOP;
.text.k1:
        /*0000*/                   LDC R1, c[0x0][0x28] ;
        /*0010*/                   IMAD.MOV.U32 R2, RZ, RZ, R1 ;
.L_x_2:
        /*0020*/                   FFMA R3, R3, R4, R5 ;
        /*0030*/              @!P0 FMNMX R3, R3, R4, !PT ;
        /*0040*/                   FRND.FLOOR R3, R3 ;
        /*0050*/                   IMAD R3, R3, R4, RZ ;
        /*0060*/                   ULOP3.LUT UR4, UR4, 0xff, URZ, 0xc0, !UPT ;
        /*0070*/              @UP0 BRA `(.L_x_2) ;
        /*0080*/                   EXIT ;
.L_x_3:
        /*0090*/                   BRA `(.L_x_3);
"""
SAID = """ptxas info    : 0 bytes gmem
ptxas info    : Compiling entry function 'k0' for 'sm_90'
ptxas info    : Function properties for k0
    0 bytes stack frame, 0 bytes spill stores, 0 bytes spill loads
ptxas info    : Used 10 registers, used 0 barriers
ptxas info    : Compiling entry function 'k1' for 'sm_90'
    16 bytes stack frame, 8 bytes spill stores, 8 bytes spill loads
ptxas info    : Used 31 registers, used 0 barriers
"""
ASM = """//.kernel k0
//.thread_config numGRF=128, numAcc=4, numSWSB=16
(W)     mov (8|M0)               r127.0<1>:ud  0x0:ud                         //
        sync.nop                             null                 {Compacted,A@1}
(W)     send.gtwy (8|M0)         null     r127    null:0  0x0     {EOT}
//.kernel k1
//.thread_config numGRF=128, numAcc=4, numSWSB=16
//.spill size 64
L8:
        mad (16|M0)              r2.0<1>:f     r6.1<0;0>:f       acc0.0<1;0>:f     r6.0<0>:f
(W)     mul (8|M0)               acc0.0<1>:d   r47.0<1;1,0>:d    0x79B1:uw
        mach (8|M0)              r47.0<1>:d    r47.0<1;1,0>:d    -1640531535:d
(f0.0)  sel (16|M0)              r3.0<1>:d     r4.0<1;1,0>:d     r5.0<1;1,0>:d
        math.sqt (16|M0)         r3.0<1>:f     r4.0<1;1,0>:f
        mov (16|M0)              r47.0<1>:d    r45.0<1;1,0>:f
        load.ugm.d32.a32.ca.ca (16|M0)  r29:2   bti[0][r5:2]
(f0.1)  goto (16|M0)                         _0_023            _0_023         // L8
(~f0.0) goto.b (16|M0)                       _0_023            L8
_0_023:
        join (16|M0)                         L8
(W)     jmpi                                 _0_024                            // $8
(~f0.0) while (16|M0)                        _0_030
        nop
"""


def stand_in(folder: Path, **programs: str) -> drivers.Drivers:
    """A folder of drivers with these programs, each a text for a shell."""
    libraries = folder / "usr/lib/any"
    (folder / "usr/bin").mkdir(parents=True)
    libraries.mkdir(parents=True)
    (libraries / "libvulkan.so.1").touch()
    (folder / debian.VERSIONS).write_text("libigc2_2.40-1_amd64\nlibllvm22_1%3a22.1.8-3_amd64\n"
                                          "mesa-vulkan-drivers_26.2-1_amd64\n")
    # It starts the program behind --library-path X.
    for path, text in ((libraries / "ld-linux-any.so.2", 'shift 2; exec "$@"'),
                       *((folder / "usr/bin" / name.replace("_", "-"), text) for name, text in programs.items())):
        path.write_text(f"#!/bin/sh\n{text}\n")
        path.chmod(0o755)
    return drivers.find(folder)


def metal(folder: Path, **texts: str) -> dict[str, str | kernels.Failed]:
    """The shaders of GLSL, by their ids."""
    for id, text in texts.items():
        done = glslang.compiled(text, "-V", "-o", str(folder / f"{id}.spv"))
        if done.returncode:
            raise ValueError(done.stdout)
    return kernels.translated({id: folder / f"{id}.spv" for id in texts})


class Translation(Case):
    def test_an_operation_becomes_one(self):
        [text] = metal(self.folder, shader=SHADER).values()
        made = kernels.Igc(stand_in(self.folder / "drivers", opt=COPY), chip_named("acm")).optimized({"k7": text}, self.folder)
        done = subprocess.run(["clang", "-x", "ir", "-Xclang", "-opaque-pointers", "-O1", "-S", "-emit-llvm", "-w",
                               made, "-o", "-"], stdout=subprocess.PIPE, text=True, check=True)
        for line in ("fmul arcp float", "@llvm.minnum.f32(", "fmul arcp contract float", "fadd arcp contract float", "@k7("):
            self.assertIn(line, done.stdout)
        # The loop is written out, and reads a table in the memory of constants.
        self.assertEqual(len(re.findall(r"call .*@llvm.minnum.f32\(", done.stdout)), 3)
        self.assertRegex(done.stdout, r"addrspace\(\d\) constant \[3 x float\]")

    def test_a_file_that_is_no_shader_is_refused(self):
        self.assertEqual(metal(self.folder, good=SHADER)["good"].count(kernels.EXACT_PRODUCT), 1)
        (self.folder / "bad.spv").write_text("none")
        self.assertRegex(str(kernels.translated({"bad": self.folder / "bad.spv"})["bad"]), "SPIRV-Cross: .")


class Counting(unittest.TestCase):
    def test_instructions_of_nvidia(self):
        self.assertEqual(kernels.counts_of_sass(SASS), {
            "k0": {"memory": 1, "branches": 2, "Issue slots": 3},
            "k1": {"memory": 1, "moves": 1, "FP": 1, "ALU": 1, "XU": 1, "IMAD": 1, "uniform": 1, "branches": 3,
                   "Loops": 1, "Issue slots": 10}})
        self.assertEqual(kernels.used_by_ptxas(SAID), {"k0": {"Spilled bytes": 0, "Registers": 10},
                                                       "k1": {"Spilled bytes": 8, "Registers": 31}})

    def test_instructions_of_intel(self):
        empty, found = kernels.counts_of_asm(ASM + ASM, 8).values()  # compiled twice
        self.assertEqual(empty, {"Registers": 128, "Instructions": 2, "Passes": 2, "moves": 1, "memory": 1})
        self.assertEqual(found, {"Registers": 128, "Spilled bytes": 64, "Instructions": 12, "Passes": 16, "floats": 2,
                                 "products": 2, "integers": 2, "math": 2, "moves": 2, "memory": 1, "branches": 5,
                                 "Loops": 2})
        # The newer GPUs pass 16 lanes at once.
        self.assertEqual(kernels.counts_of_asm(ASM, 16)["k1"]["Passes"], 12)

    def test_units(self):
        for instruction, unit in (("FADD.FTZ", "FP"), ("IMAD.MOV.U32", "moves"), ("IMAD.SHL.U32", "IMAD"),
                                  ("MUFU.SQRT", "XU"), ("F2I.TRUNC.NTZ", "XU"), ("I2FP.F32.S32", "ALU"),
                                  ("FMNMX", "ALU"), ("LDC", "memory"),
                                  ("UIADD3", "uniform"), ("ULDC", "memory"), ("SHF.L.U32", "ALU")):
            self.assertEqual(kernels.pipe(instruction), unit, instruction)


# Programs of a shell in place of the compilers: LLVM's copy what they get, and the others print what they were given.
COPY = '''for word; do
  case $word in *.cl|*.bc) input=${input:-$word};; esac
  output=$word
done
cp "$input" "$output"'''
NAMES = r's/SHADER(\(k[0-9]*\)).*'
NVCC = rf'''[ "$1" = --version ] && {{ echo "release 13.5, V13.5.37"; exit; }}
for word; do case $word in *.cu) input=$word;; esac; done
grep -q refused "$input" && {{ echo "error : no"; exit 255; }}
sed -n "{NAMES}/Compiling entry function '\\1'\\nUsed 9 registers/p" "$input"
cp "$input" "${{input%cu}}cubin"'''
NVDISASM = rf'''sed -n '{NAMES}/.text.\1:\n        \/*0000*\/   FADD R1, R2, R3 ;/p' "$2"'''
OCLOC = rf'''echo "$*" >>"$HN_ASKED"
sed -n '{NAMES}/\/\/.kernel \1\n\/\/.thread_config numGRF=128\n  add (16|M0) r1.0<1>:f/p' "$4"'''


class Compilers(Case):
    def setUp(self):
        self.enterContext(mock.patch.dict(os.environ, PATH=f"{self.script('bin/clang', COPY).parent}:{os.environ['PATH']}"))

    def nvidia(self, **programs: str) -> drivers.Drivers:
        """A folder of drivers, beside these programs of NVIDIA's."""
        for name, text in programs.items():
            self.script(f"cuda/bin/{name}", text)
        self.enterContext(mock.patch("base.cuda.toolkit", return_value=self.folder / "cuda"))
        return stand_in(self.folder / "drivers")

    def test_a_shader_that_is_refused_costs_itself(self):
        found = self.nvidia(nvcc=NVCC, nvdisasm=NVDISASM)
        shaders = {f"s{number}": METAL for number in range(5)} | {"bad": kernels.Failed("no shader"), "last": METAL}
        shaders["s3"] += "refused\n"
        steps = []
        device, results = kernels.compile_all(found, chip_named("sm90"), shaders, lambda: steps.append(1))
        self.assertEqual(device, Device("sm_90", "nvcc 13.5.37"))
        problems = {id: result.problem for id, result in zip(shaders, results) if result.problem}
        self.assertEqual(problems, {"s3": "the compiler ended with status 255 (error : no)", "bad": "no shader"})
        self.assertEqual(results[-1].statistics, {"FP": 1, "Issue slots": 1, "Registers": 9})
        self.assertTrue(math.isnan(results[0].seconds))
        self.assertEqual(len(steps), 6)
        row = record.row("s0", chip_named("sm90"), results[0], results[0])
        self.assertEqual((row.cost, row.compile_ms, row.problem), ("0", "", ""))

    def test_a_compiler_that_prints_nothing_is_no_success(self):
        _, [result] = kernels.compile_all(self.nvidia(nvcc=NVCC, nvdisasm="true"), chip_named("sm90"), {"s": METAL})
        self.assertEqual(result.problem, "the compiler printed nothing of 1 shaders")

    def test_exact_shaders_go_to_igc_apart(self):
        passed = self.folder / "passed"
        self.enterContext(mock.patch.dict(os.environ, {"HN_ASKED": str(passed)}))
        found = stand_in(self.folder / "drivers", opt=COPY, llvm_spirv=COPY, ocloc=OCLOC)
        _, results = kernels.compile_all(found, chip_named("acm"), {"exact": f"{METAL}spvFMul(1, 2)\n", "plain": METAL})
        self.assertEqual([result.statistics.get("floats") for result in results], [2, 2], results)
        options = [line.partition("-options ")[2] for line in passed.read_text().splitlines()]
        self.assertEqual(options, ["-cl-mad-enable", ""])

    def test_a_folder_without_them_is_told(self):
        with self.assertRaisesRegex(Missing, "has no program ocloc"):
            kernels.compile_all(stand_in(self.folder / "drivers"), chip_named("acm"), {"s": METAL})
        with mock.patch("shutil.which", return_value=None), self.assertRaisesRegex(Missing, "no clang and no spirv-cross"):
            kernels.translated({"s": self.folder})


CALLS = {"noise2d.perlin.lattice": "hn_perlin(vec2(x, y))", "noise3d.simplex.lattice": "hn_simplex(vec3(x, y, z))",
         "noise2d.cellular.lattice": "hn_cellular(vec2(x, y)).x + hn_cellular(vec2(x, y)).y",
         "fbm.fbm3.lattice": "hn_fbm(vec3(x, y, z), 6, 2.0f, 0.5f)"}
# In GLSL, with a position p, and in C++.
EXPRESSIONS = {
    "mix(p.x, p.y, 0.25)": "x + (y - x) * 0.25f",
    "step(p.x, p.y) + 2.0 * step(p.y, p.x)": "(y >= x ? 1 : 0) + (x >= y ? 2 : 0)",
    "clamp(p.z, -0.5, 0.7)": "std::clamp(z, -0.5f, 0.7f)",
    "float(clamp(int(p.z), -1, 1)) + float(clamp(uint(p.z * p.z), 1u, 3u))":
        "std::clamp(int(z), -1, 1) + std::clamp(int(z * z), 1, 3)",
    "smoothstep(-4.0, 5.0, p.x)": "[](float t) { return t * t * (3 - 2 * t); }(std::clamp((x + 4) / 9, 0.0f, 1.0f))",
    "sign(p.y) + 4.0 * sign(p.z)": "(y < 0 ? -1 : 1) + (z < 0 ? -4 : 4)",
    "mod(p.y, 1.7)": "y - 1.7f * std::floor(y / 1.7f)",
    "dot(p, p.zyx)": "2 * x * z + y * y",
    "length(p)": "std::sqrt(x * x + y * y + z * z)",
    "normalize(p).y": "y / std::sqrt(x * x + y * y + z * z)",
    "inversesqrt(p.z * p.z + 1.0)": "1 / std::sqrt(z * z + 1)",
    "(mat2(p.x, p.y, p.z, 1.0) * p.yz).x": "x * y + z * z",
    "(p.yz * mat2(p.x, p.y, p.z, 1.0)).x": "y * x + z * y",
    "float(abs(int(p.y * 10.0)))": "std::abs(int(y * 10))",
    "any(lessThan(p, vec3(0.0))) ? 1.0 : 2.0": "x < 0 || y < 0 || z < 0 ? 1 : 2",
    "all(lessThan(p, vec3(0.0))) ? 1.0 : 2.0": "x < 0 && y < 0 && z < 0 ? 1 : 2",
    "p[uint(p.x * p.x) % 3u]": "uint(x * x) % 3 == 0 ? x : uint(x * x) % 3 == 1 ? y : z",
    "float(~int(p.z)) + float(int(p.x * 9.0) / 4)": "~int(z) + int(x * 9) / 4",
    "float(int(p.x * p.x * 9.0) % 4) + float((ivec2(p.yy * p.xy * 7.0) % ivec2(5, 3)).y)":
        "int(x * x * 9) % 4 + int(y * y * 7) % 3",
    "float(1u << (uint(p.x * p.x) & 3u)) + float(40 >> uint(p.z * p.z))":
        "float(1u << (uint(x * x) & 3u)) + float(40 >> uint(z * z))",
    "fract(p.y) + trunc(p.y) + ceil(p.x)": "y - std::floor(y) + std::trunc(y) + std::ceil(x)",
    "sin(p.x) + cos(p.y)": "std::sin(x) + std::cos(y)",
    "exp2(p.x) + log2(p.z * p.z + 1.0)": "std::exp2(x) + std::log2(z * z + 1)",
    "pow(p.x * p.x + 1.0, p.z) + exp(p.x) + log(p.y * p.y + 1.0)":
        "std::pow(x * x + 1, z) + std::exp(x) + std::log(y * y + 1)",
    "vec4(p.xy, p.yz).w - p.zxy.xxy.y": "0.0f",
    "!(p.x < p.y) && p.z > 0.0 ? 1.0 : 0.0": "!(x < y) && z > 0 ? 1 : 0",
    "max(p.x, p.y) - min(p.y, p.z)": "std::max(x, y) - std::min(y, z)",
    "fma(p.x, p.y, p.z)": "std::fma(x, y, z)",
    "uintBitsToFloat(floatBitsToUint(p.x) ^ 0x80000000u)": "-x",
}
EXPRESSION = """#version 450
layout(location = 0) in vec3 p;
layout(location = 0) out float result;
void main() {{ result = {}; }}
"""
PROGRAM = """#include <algorithm>
#include <cmath>
#include <cstdio>
#include <hashnoise/hashnoise.hpp>
{shaders}
#undef for
using namespace hashnoise;
int main() {{
  static float place[4096], made[4096];
  auto check = [](void (*kernel)(const float*, float*), float wanted, const char* what) {{
    kernel(place, made);
    if (std::abs(made[0] - wanted) > 1e-5f * (1 + std::abs(wanted))) std::printf("%s\\n", what);
  }};
  for (float x = -7.3f; x < 7.0f; x += 0.61f) {{
    const float y = 3.1f - x * 1.7f, z = x * 0.3f;
    place[0] = x, place[1024] = y, place[2048] = z;
    {checks}
  }}
}}
"""


@in_thorough_runs
class Real(Case):
    def setUp(self):
        folder = Path(os.environ.get("HN_GPU_DRIVERS", command.DRIVERS))
        try:
            drivers.get(folder)
            self.found = drivers.find(folder)
        except Missing as why:
            self.skipTest(str(why))

    def calls(self) -> dict[str, Path]:
        filters = [word for id in CALLS for word in ("--filter", id)]
        subprocess.run([command.program(), "spirv", "--out", self.folder, *filters],
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
        return {id: self.folder / "spirv" / f"{id}.spv" for id in CALLS}

    def wrong(self, files: dict[str, Path], wanted: dict[str, str]) -> set[str]:
        """Functions whose shader computes another number on this processor than the C++ that is wanted."""
        shaders = kernels.translated(files)
        names = {id: f"k{number}" for number, id in enumerate(files)}
        source, program = self.folder / "host.cpp", self.folder / "host"
        source.write_text(PROGRAM.format(
            shaders=kernels.module({name: shaders[id] for id, name in names.items()}),
            checks="\n    ".join(f'check(metal::of_{name}::{name}, {wanted[id]}, "{id}");' for id, name in names.items())))
        compile_program("the comparison", source, program, "-I", str(kernels.HEADER.parent), SOON)
        return set(subprocess.run([program], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines())

    def test_a_translated_shader_computes_what_the_twin_does(self):
        files = self.calls()
        self.assertEqual(self.wrong(files, {id: f"0.5f + 0.5f * ({call})" for id, call in CALLS.items()}), set())
        self.assertEqual(self.wrong(files, {id: f"0.51f + 0.5f * ({call})" for id, call in CALLS.items()}), set(CALLS))

    def test_what_glsl_has_means_what_it_means_there(self):
        files = {}
        for number, glsl in enumerate(EXPRESSIONS):
            files[glsl] = self.folder / f"{number}.spv"
            done = glslang.compiled(EXPRESSION.format(glsl), "-V", "-o", str(files[glsl]))
            self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(self.wrong(files, EXPRESSIONS), set())

    def test_a_division_is_the_gpus_own(self):
        texts = metal(self.folder, plain=EXPRESSION.format("p.x"), divided=EXPRESSION.format("p.x / p.y"))
        for chip, cost, most in (("sm90", "Issue slots", 4), ("acm", "Passes", 12)):
            plain, divided = kernels.compile_all(self.found, chip_named(chip), texts)[1]
            self.assertLess(divided.statistics[cost] - plain.statistics[cost], most, chip)

    def test_units_sum_up_to_what_is_counted(self):
        files = self.calls()
        for chip in (chip for chip in CHIPS if not chip.vendor.is_driver):
            _, results = kernels.compile_all(self.found, chip, kernels.translated(files))
            for id, result in zip(files, results):
                with self.subTest(chip=chip.name, id=id):
                    units = sum(result.statistics.get(kind, 0) for kind in chip.vendor.kinds if kind != "Loops")
                    self.assertEqual(units, result.statistics[chip.vendor.cost])
                    self.assertGreater(units, 40)
                    self.assertNotIn("Loops", result.statistics)  # a sum has all its octaves
