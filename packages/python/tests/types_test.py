"""The types of the package, as mypy sees them: those of a user's program, and those that the stub promises."""

from __future__ import annotations

import ast
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import documents_test
import hashnoise

STUB = Path(hashnoise.__file__).with_name("__init__.pyi")

PROGRAM = '''
import hashnoise
import hashnoise.arrays
import numpy as np
import numpy.typing as npt

x: npt.NDArray[np.float64] = np.linspace(0, 8, 100)
number: float = hashnoise.perlin(0.5, 1, seed=7)
single: float = hashnoise.fbm(np.float32(0.5), cell=3)
values: npt.NDArray[np.float32] = hashnoise.perlin(x, 0.5, period=(3, 4), phase=0.25)
again: npt.NDArray[np.float32] = hashnoise.perlin(x.tolist(), x[0], out=values)
value, dx, dy = hashnoise.perlin_d(0.5, 0.25)
slopes: npt.NDArray[np.float32] = dx
sum: npt.NDArray[np.float32] = hashnoise.eroded(x, x[:, np.newaxis], noise="simplex_d", octaves=8, strength=2)
far: npt.NDArray[np.float32] = hashnoise.fbm(0.5, 0.5, cell=(np.arange(3), 10**9), arithmetic="fixed")
image: npt.NDArray[np.float32] = hashnoise.grid("cellular", (640, 480), step=0.01, metric="manhattan")
volume, (least, greatest) = hashnoise.grid("clouds", (9, 9, 9), step=(0.1, 0.1, 0.2), return_range=True)
extent: float = greatest - least
names: tuple[str, ...] = hashnoise.noises(2) + hashnoise.fractals(2) + hashnoise.instruction_sets()
stripes, quadrature = hashnoise.phasor(x, 0.5, wave=(2.5, -1.5), phase=0.25)
heights: npt.NDArray[np.uint16] = hashnoise.grid("fbm", (64, 48), step=0.01, dtype="uint16", range=(-0.5, 0.5))
halves: npt.NDArray[np.float16] = hashnoise.grid("fbm", (64, 48), step=0.01, dtype=np.float16)
words, (low, high) = hashnoise.grid("fbm", 9, step=0.01, dtype=np.dtype("uint16"), return_range=True)
numbers: npt.NDArray[np.uint16] = words
part: npt.NDArray[np.float16] = hashnoise.grid("fbm", (64, 48), step=0.01, first=(64, 0),
                                               out=np.empty((48, 64), np.float16))
pictures = [hashnoise.grid(name, (9, 9), step=0.1) for name in hashnoise.noises(2) + hashnoise.fractals(2)]
layers: npt.NDArray[np.float32] = hashnoise.grid("phasor", (9, 9, 9), step=0.1, wave=[1, 2, 3])
planes: tuple[str, ...] = hashnoise.components("warp", 2, noise="perlin_vector")
version: str = hashnoise.__version__
number = hashnoise.fbm(0.5, octaves=np.int64(3), seed=np.uint32(3), gain=np.float32(0.5), period=np.array([4]))
values = hashnoise.fbm(x % 1, x % 1, octaves=np.int64(3), cell=3, threads=np.int32(1))
image = hashnoise.grid("fbm", np.array([64, 48]), step=np.array([0.01, 0.02]), origin=[1, np.float64(0.5)],
                       first=np.int64(3), period=np.array([3, 4]))
layers = hashnoise.grid("phasor", (9, 9), step=(1, np.float32(0.5)), wave=np.array([1.5, 2]), phase=np.float64(0.5))
heights = hashnoise.grid("fbm", [64, 48], step=0.01, dtype="uint16", range=[-0.5, np.float64(0.5)],
                         cell=np.array([1, 2]))
of_points: npt.NDArray[np.float32] = hashnoise.fbm(points=np.stack([x, x, x], -1), seed=3)
of_points = hashnoise.cellular(points=[[0.5, 0.25]], cell=[[1, 2]], metric="manhattan")
fitted = hashnoise.arrays.fbm(x, x, gain=x, seed=np.arange(100), octaves=3, period=(4, 4), arithmetic="fixed")
text: str = "fbm"
if text in hashnoise.noises(2) + hashnoise.fractals(2):
    image = hashnoise.grid(text, (9, 9), step=0.1)
'''
WRONG = {
    'hashnoise.perlin()': "call-overload",
    'hashnoise.arrays.perlin(0.5, arithmetic="precise")': "arg-type",
    'hashnoise.arrays.perlin(0.5, out=0.5)': "call-arg",
    'hashnoise.perlin(0.5, metric="euclidean")': "call-overload",
    'hashnoise.perlin(0.5, arithmetic="exact")': "call-overload",
    'hashnoise.perlin(0.5, seed=0.5)': "call-overload",
    'hashnoise.perlin(0.5, seed=np.float32(0.5))': "call-overload",
    'hashnoise.fbm(0.5, gain=np.array([0.5]))': "call-overload",
    'hashnoise.cellular(0.5, 0.5, metric="taxicab")': "call-overload",
    'hashnoise.phasor(0.5, 0.5, wave=2.5)': "call-overload",
    'hashnoise.simplex(0.5)': "call-overload",
    'hashnoise.perlin(0.5, points=[[0.5]])': "call-overload",
    'hashnoise.grid("perlin", 9, step=1, points=[[0.5]])': "call-overload",
    'hashnoise.grid("perlin", 9)': "call-overload",
    'hashnoise.grid("perlin", 9, step=1, first=0.5)': "call-overload",
    'hashnoise.grid("perlin", 9, step=1, dtype="uint16", range=3)': "call-overload",
    'hashnoise.grid("perlin", 9, step=1, out=np.empty(9))': "call-overload",
    'text: str = hashnoise.perlin(0.5)': "assignment",
    'array: int = hashnoise.perlin([0.5])': "assignment",
    'hashnoise.no_such(0.5)': "attr-defined",
    'hashnoise.hn_fbm(0.5)': "attr-defined",
    'hashnoise.grid("fmb", 9, step=1)': "call-overload",
    'hashnoise.grid("hn_fbm", 9, step=1, dtype="uint16")': "call-overload",
    'hashnoise.grid("fbm", 9, step=1, noise="perlim")': "call-overload",
    'hashnoise.grid("fbm", 9, step=1, dtype="float64")': "call-overload",
    'hashnoise.grid("fbm", 9, step=1, frequency=4)': "call-overload",
    'hashnoise.fbm_d(0.5, 0.5, noise="perlin_dd")': "call-overload",
    'hashnoise.components("fmb", 2)': "arg-type",
    'floats: npt.NDArray[np.float32] = hashnoise.grid("fbm", 9, step=1, dtype="uint16")': "assignment",
}
# The modules behind the stub are without types, as it has them.
CONFIGURATION = """[mypy]
[mypy-hashnoise._core,hashnoise._evaluate,hashnoise._grids,hashnoise._noises,hashnoise._sums,hashnoise._bake.*,hashnoise._bake_files,hashnoise.arrays.*,dask.*,xarray.*]
ignore_errors = True
ignore_missing_imports = True
"""


def other_defaults(stub: str) -> set[str]:
    """The functions with another default in a stub than in the code. stubtest compares none where there are overloads."""
    return {function.name for function in ast.parse(stub).body if isinstance(function, ast.FunctionDef)
            for option, default in zip(function.args.kwonlyargs, function.args.kw_defaults)
            if default and ast.literal_eval(default) != getattr(hashnoise, function.name).__kwdefaults__[option.arg]}


class Types(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.scratch = Path(scratch.name)  # of all, since mypy takes most of its time to read numpy, once for a cache

    def call(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([sys.executable, "-m", *arguments], capture_output=True, text=True, check=False,
                              cwd=self.scratch)

    def check(self, program: str) -> subprocess.CompletedProcess[str]:
        (self.scratch / "program.py").write_text(program, encoding="utf-8")
        return self.call("mypy", "--strict", "program.py")

    def test_a_program(self):
        done = self.check(PROGRAM)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)

    def test_the_program_runs(self):
        exec(compile(PROGRAM, "program", "exec"), {})  # its asserts hold

    def test_the_page(self):
        for number, block in enumerate(documents_test.FENCE.findall(documents_test.PAGE.read_text(encoding="utf-8"))):
            if documents_test.ELSEWHERE.search(block):  # which are not here
                continue
            with self.subTest(block):
                done = self.check(block)
                self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)

    def test_wrong_calls(self):
        lines = [f"{call}  # {number}" for number, call in enumerate(WRONG)]
        done = self.check("import hashnoise.arrays, numpy as np, numpy.typing as npt\n" + "\n".join(lines) + "\n")
        self.assertEqual(done.returncode, 1)
        for number, (call, code) in enumerate(WRONG.items()):
            with self.subTest(call):
                self.assertRegex(done.stdout, rf"(?m)^program.py:{number + 2}: error: .*\[{code}\]$")

    def compare_with_the_code(self, folder: str | None = None) -> subprocess.CompletedProcess[str]:
        (self.scratch / "mypy.ini").write_text(CONFIGURATION)
        # Dask is not here; dask_cluster_test.py has it.
        (self.scratch / "allowed").write_text("hashnoise\\.(arrays\\.)?_.*\nhashnoise\\.dask\n")
        return self.call("mypy.stubtest", "hashnoise", "--mypy-config-file", "mypy.ini", "--allowlist", "allowed",
                         "--ignore-unused-allowlist")

    def test_the_stub_has_what_the_code_has(self):
        done = self.compare_with_the_code()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(other_defaults(STUB.read_text()), set())

    def test_another_stub_is_noticed(self):
        """In a copy of the package, which stands before the installed one."""
        shutil.copytree(STUB.parent, self.scratch / "hashnoise")
        stub = self.scratch / "hashnoise" / "__init__.pyi"
        text = stub.read_text()
        self.assertEqual(other_defaults(text.replace("amplitude: _Number = 1.0", "amplitude: _Number = 2.0")),
                         {"warp", "warp_progressive"})
        stub.write_text(text.replace("jitter: _Number", "jiter: _Number") + "def no_such() -> int: ...\n")
        try:
            done = self.compare_with_the_code()
        finally:
            shutil.rmtree(self.scratch / "hashnoise")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        for wrong in ("cellular", "no_such"):
            self.assertIn(f"error: hashnoise.{wrong} ", done.stdout)
