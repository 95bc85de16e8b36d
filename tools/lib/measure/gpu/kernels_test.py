"""Tests of what compiles shaders by way of LLVM's text: the translation, and how what compilers print is counted. The
compilers run in thorough runs, as gpu_test.py does."""

from __future__ import annotations

import contextlib
import dataclasses
import io
import math
import os
import subprocess
import unittest
from pathlib import Path
from unittest import mock

from base import debian, glslang
from base.debian import Missing
from base.testing import Case
from base.thorough import in_thorough_runs
from base.twin import compile_program
from measure.gpu import command, drivers, kernels, llvm, record
from measure.gpu.chips import CHIPS, chip_named
from measure.gpu.compiling import Device

# A shader as spirv-dis prints it: with a table, a loop, a minimum, and a product that must not be contracted.
SHADER = """OpCapability Shader
%1 = OpExtInstImport "GLSL.std.450"
OpEntryPoint Fragment %2 "main" %10 %11
OpDecorate %40 NoContraction
%3 = OpTypeVoid
%4 = OpTypeFunction %3
%5 = OpTypeFloat 32
%6 = OpTypeInt 32 1
%7 = OpTypeBool
%8 = OpTypePointer Input %5
%9 = OpTypePointer Output %5
%10 = OpVariable %8 Input
%11 = OpVariable %9 Output
%12 = OpConstant %5 0.5
%13 = OpConstant %6 2
%14 = OpTypeArray %5 %13
%15 = OpConstantComposite %14 %12 %12
%16 = OpTypePointer Function %14
%17 = OpTypePointer Function %5
%18 = OpConstant %6 0
%19 = OpConstant %6 1
%2 = OpFunction %3 None %4
%20 = OpLabel
%21 = OpVariable %16 Function
%22 = OpLoad %5 %10
OpBranch %23
%23 = OpLabel
%24 = OpPhi %6 %18 %20 %25 %26
%27 = OpPhi %5 %22 %20 %28 %26
%29 = OpSLessThan %7 %24 %13
OpLoopMerge %30 %26 None
OpBranchConditional %29 %26 %30
%26 = OpLabel
OpStore %21 %15
%31 = OpAccessChain %17 %21 %24
%32 = OpLoad %5 %31
%40 = OpFMul %5 %27 %32
%28 = OpExtInst %5 %1 FMin %40 %22
%25 = OpIAdd %6 %24 %19
OpBranch %23
%30 = OpLabel
OpStore %11 %27
OpReturn
OpFunctionEnd
"""
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
    (folder / "nvidia").mkdir()
    libraries.mkdir(parents=True)
    (libraries / "libvulkan.so.1").touch()
    (folder / debian.VERSIONS).write_text("libigc2_2.40-1_amd64\nlibllvm22_1%3a22.1.8-3_amd64\n"
                                          "mesa-vulkan-drivers_26.2-1_amd64\n")
    # It starts the program behind --library-path X.
    for path, text in ((libraries / "ld-linux-any.so.2", 'shift 2; exec "$@"'),
                       *((folder / ("nvidia" if name in ("ptxas", "nvdisasm") else "usr/bin") / name.replace("_", "-"),
                          text) for name, text in programs.items())):
        path.write_text(f"#!/bin/sh\n{text}\n")
        path.chmod(0o755)
    return drivers.find(folder)


class Translation(unittest.TestCase):
    def test_an_operation_becomes_one(self):
        for target, exact in ((llvm.NVPTX, "call float @llvm.nvvm.mul.rn.ftz.f(float %v27, float %v32)"),
                              (llvm.SPIR, "fmul float %v27, %v32")):
            kernel = llvm.kernel_of(SHADER, target)
            self.assertTrue(kernel.has_exact_product)
            text = llvm.module({"k7": kernel}, target)
            for line in (f"%v40 = {exact}", "%v28 = call float @llvm.minnum.f32(float %v40, float %v22)",
                         "%v24 = phi i32 [ 0, %l20 ], [ %v25, %l26 ]", "void @k7(", "private unnamed_addr addrspace("):
                self.assertIn(line, text)
            # The branch back is the one that closes the loop, and the store of the table is none.
            self.assertEqual(text.count("!llvm.loop !"), 1)
            self.assertRegex(text, r"br label %l23, !llvm\.loop !1000001\n")
            self.assertNotIn("store [2 x float]", text)

    def test_what_may_be_contracted_says_so(self):
        kernel = llvm.kernel_of(SHADER.replace("OpDecorate %40 NoContraction\n", ""), llvm.NVPTX)
        self.assertIn("%v40 = fmul contract float %v27, %v32", kernel.definition)
        self.assertFalse(kernel.has_exact_product)

    def test_an_array_that_is_written_twice_is_no_table(self):
        other = SHADER.replace("OpStore %21 %15\n",
                               "OpStore %21 %15\n%50 = OpAccessChain %17 %21 %18\nOpStore %50 %22\n")
        self.assertIn("%v21 = alloca [2 x float]", llvm.kernel_of(other, llvm.NVPTX).definition)

    def test_numbers(self):
        for text, bits in (("0.5", "0x3FE0000000000000"), ("0x1p+128", "0x7FF0000000000000"),
                           ("-0x1p-149", "0xB6A0000000000000"), ("0x1.8p+128", "0x7FF8000000000000")):
            self.assertEqual(llvm.float_constant(text), bits)

    def test_what_is_not_known_is_refused(self):
        for old, new, part in (("OpIAdd", "OpIAddCarry", "OpIAddCarry has no translation"),
                               ("FMin", "Tan", "GLSL's Tan has no translation"),
                               ("Variable %8 Input", "Variable %8 Uniform", "variables that are Uniform have no"),
                               ("OpTypeFloat 32", "OpTypeFloat 64", "floats of 64 bits")):
            with self.subTest(part=part), self.assertRaisesRegex(llvm.Unsupported, part):
                llvm.kernel_of(SHADER.replace(old, new), llvm.NVPTX)
        found = llvm.Kernels({"good": SHADER, "bad": SHADER.replace("FMin", "Tan")}).of(llvm.SPIR)
        self.assertIsInstance(found["bad"], llvm.Unsupported)
        self.assertIsInstance(found["good"], llvm.Kernel)


class Counting(unittest.TestCase):
    def test_instructions_of_nvidia(self):
        self.assertEqual(kernels.counts_of_sass(SASS), {
            "k0": {"memory": 1, "branches": 2, "Issue slots": 3},
            "k1": {"memory": 1, "moves": 1, "FP": 1, "ALU": 1, "XU": 1, "IMAD": 1, "uniform": 1, "branches": 3,
                   "Loops": 1, "Issue slots": 10}})
        self.assertEqual(kernels.used_by_ptxas(SAID), {"k0": {"Spilled bytes": 0, "Registers": 10},
                                                       "k1": {"Spilled bytes": 8, "Registers": 31}})

    def test_instructions_of_intel(self):
        empty, found = kernels.counts_of_asm(ASM, 8).values()
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
  case $word in *.ll|*.bc) input=${input:-$word};; esac
  output=$word
done
cp "$input" "$output"'''
NAMES = r's/.*void @\(k[0-9]*\)(.*'
PTXAS = rf'''[ "$1" = --version ] && {{ echo "release 12.9, V12.9.86"; exit; }}
for word; do case $word in *.ptx) input=$word;; esac; done
grep -q refused "$input" && {{ echo "ptxas fatal : no"; exit 255; }}
sed -n "{NAMES}/Compiling entry function '\\1'\\nUsed 9 registers/p" "$input"
cp "$input" "${{input%ptx}}cubin"'''
NVDISASM = rf'''sed -n '{NAMES}/.text.\1:\n        \/*0000*\/   FADD R1, R2, R3 ;/p' "$2"'''
OCLOC = rf'''echo "$*" >>"$HN_ASKED"
sed -n '{NAMES}/\/\/.kernel \1\n\/\/.thread_config numGRF=128\n  add (16|M0) r1.0<1>:f/p' "$4"'''


class Compilers(Case):
    def test_a_shader_that_is_refused_costs_itself(self):
        found = stand_in(self.folder, opt=COPY, llc=COPY, ptxas=PTXAS, nvdisasm=NVDISASM)
        texts = {f"s{number}": SHADER for number in range(5)} | {"bad": SHADER.replace("FMin", "Tan"), "last": SHADER}
        translated = llvm.Kernels(texts)
        translated.of(llvm.NVPTX)["s3"].definition += "\n; refused"
        steps = []
        device, results = kernels.compile_all(found, chip_named("sm90"), translated, lambda: steps.append(1))
        self.assertEqual(device, Device("sm_90", "ptxas 12.9.86, LLVM 22.1.8-3"))
        problems = {id: result.problem for id, result in zip(texts, results) if result.problem}
        self.assertEqual(problems, {"s3": "the compiler ended with status 255 (ptxas fatal : no)",
                                    "bad": "GLSL's Tan has no translation"})
        self.assertEqual(results[-1].statistics, {"FP": 1, "Issue slots": 1, "Registers": 9})
        self.assertTrue(math.isnan(results[0].seconds))
        self.assertEqual(len(steps), 6)
        row = record.row("s0", chip_named("sm90"), results[0], results[0])
        self.assertEqual((row.cost, row.compile_ms, row.problem), ("0", "", ""))

    def test_a_compiler_that_prints_nothing_is_no_success(self):
        found = stand_in(self.folder, opt=COPY, llc=COPY, ptxas=PTXAS, nvdisasm="true")
        _, [result] = kernels.compile_all(found, chip_named("sm90"), llvm.Kernels({"s": SHADER}))
        self.assertEqual(result.problem, "the compiler printed nothing of 1 shaders")

    def test_exact_shaders_go_to_igc_apart(self):
        passed = self.folder / "passed"
        self.enterContext(mock.patch.dict(os.environ, {"HN_ASKED": str(passed)}))
        found = stand_in(self.folder / "drivers", opt=COPY, llvm_spirv=COPY, ocloc=OCLOC)
        plain = SHADER.replace("OpDecorate %40 NoContraction\n", "")
        _, results = kernels.compile_all(found, chip_named("acm"), llvm.Kernels({"exact": SHADER, "plain": plain}))
        self.assertEqual([result.statistics.get("floats") for result in results], [2, 2], results)
        options = [line.partition("-options ")[2] for line in passed.read_text().splitlines()]
        self.assertEqual(options, ["-cl-mad-enable", ""])

    def test_a_folder_without_them_is_told(self):
        found = stand_in(self.folder)
        for chip, part in (("sm90", "has no ptxas of NVIDIA"), ("sm120", "has no ptxas-blackwell"),
                           ("acm", "has no program ocloc")):
            with self.subTest(chip=chip), self.assertRaisesRegex(Missing, part):
                kernels.compile_all(found, chip_named(chip), llvm.Kernels({"s": SHADER}))
        with mock.patch("subprocess.run", side_effect=FileNotFoundError), \
                self.assertRaisesRegex(Missing, "spirv-tools"):
            kernels.translated({"s": self.folder})


class Getting(Case):
    def test_what_one_call_could_not_get_the_next_one_does(self):
        folder = self.folder / "drivers"
        stand_in(folder)
        (folder / "nvidia").rmdir()
        offline = subprocess.CompletedProcess([], 1, "no route to PyPI")
        with mock.patch("subprocess.run", return_value=offline), mock.patch("base.debian.get") as get, \
                contextlib.redirect_stderr(io.StringIO()), \
                self.assertRaisesRegex(Missing, "pip cannot download triton.*\nno route to PyPI"):
            drivers.get(folder)
        get.assert_not_called()
        self.assertFalse((folder / "nvidia").exists())
        (folder / "nvidia").mkdir()
        with self.assertRaisesRegex(Missing, "is not empty"):
            drivers.get(folder)


# The shaders on this processor: what stands for the functions of a GPU.
HOST = dataclasses.replace(
    llvm.SPIR, head='target triple = "x86_64-pc-linux-gnu"', kernel="", index=("  %index = add i64 0, 0",),
    declarations="", attributes="", tail="", constants=0,
    functions={"OpFDiv": "divided", "Sqrt": "sqrtf", "InverseSqrt": "inverse_root", "Sin": "sinf", "Cos": "cosf",
               "Exp2": "exp2f", "Log2": "log2f"})
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
    "float(int(p.x * 9.0) % 4) + float((ivec2(p.xy * 7.0) % ivec2(5, 3)).y)":
        "(int(x * 9) % 4 + 4) % 4 + (int(y * 7) % 3 + 3) % 3",
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
using namespace hashnoise;
extern "C" float divided(float a, float b) {{ return a / b; }}
extern "C" float inverse_root(float a) {{ return 1 / std::sqrt(a); }}
{declarations}
int main() {{
  static float place[{size}], made[{size}];
  auto check = [](void (*kernel)(const float*, float*), float wanted, const char* what) {{
    kernel(place, made);
    if (std::abs(made[0] - wanted) > 1e-5f * (1 + std::abs(wanted))) std::printf("%s\\n", what);
  }};
  for (float x = -7.3f; x < 7.0f; x += 0.61f) {{
    const float y = 3.1f - x * 1.7f, z = x * 0.3f;
    place[0] = x, place[{stride}] = y, place[2 * {stride}] = z;
    {checks}
  }}
}}
"""


@in_thorough_runs
class Real(Case):
    def setUp(self):
        folder = Path(os.environ.get("HN_GPU_DRIVERS", command.DRIVERS))
        try:
            if not debian.find(folder, "libvulkan.so.1") or not (folder / "nvidia").exists():
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
        shaders = kernels.translated(files).of(HOST)
        names = {id: f"k{number}" for number, id in enumerate(files)}
        text, made, machine = (self.folder / name for name in ("host.ll", "host.bc", "host.o"))
        text.write_text(llvm.module({name: shaders[id] for id, name in names.items()}, HOST))
        subprocess.run([*self.found.program("opt"), "-O3", text, "-o", made], check=True)
        subprocess.run([*self.found.program("llc"), "-mattr=+fma,+sse4.1", "-relocation-model=pic", "-filetype=obj",
                        made, "-o", machine], check=True)
        source, program = self.folder / "host.cpp", self.folder / "host"
        source.write_text(PROGRAM.format(
            size=4 * llvm.STRIDE, stride=llvm.STRIDE,
            declarations="\n".join(f'extern "C" void {name}(const float*, float*);' for name in names.values()),
            checks="\n    ".join(f'check({name}, {wanted[id]}, "{id}");' for id, name in names.items())))
        compile_program("the comparison", source, program, str(machine))
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

    def test_units_sum_up_to_what_is_counted(self):
        files = self.calls()
        for chip in (chip for chip in CHIPS if chip.vendor.target):
            _, results = kernels.compile_all(self.found, chip, kernels.translated(files))
            for id, result in zip(files, results):
                with self.subTest(chip=chip.name, id=id):
                    units = sum(result.statistics.get(kind, 0) for kind in chip.vendor.kinds if kind != "Loops")
                    self.assertEqual(units, result.statistics[chip.vendor.cost])
                    self.assertGreater(units, 40)
