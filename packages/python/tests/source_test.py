"""The source distribution has what the build reads, and not the rest of the repository."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
import zlib
from pathlib import Path

import golden
from base.tree import VECTORS

TESTS = Path(__file__).resolve().parent
BUILD = "import scikit_build_core.build, sys; print(scikit_build_core.build.build_sdist(sys.argv[1]))"


class Source(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        done = subprocess.run([sys.executable, "-B", "-c", BUILD, scratch.name], cwd=golden.ROOT, capture_output=True,
                              text=True, check=False)
        if done.returncode != 0:
            raise RuntimeError(done.stderr)
        cls.archive = Path(scratch.name) / done.stdout.splitlines()[-1]
        with tarfile.open(cls.archive) as archive:
            archive.extractall(scratch.name)
        cls.root = Path(scratch.name) / cls.archive.name.removesuffix(".tar.gz")

    def missing_headers(self) -> str:
        """Files that the preprocessor misses, of those that the sources include."""
        compiler = shutil.which("c++") or self.skipTest("there is no compiler c++")
        said = ""
        for source in sorted((self.root / "src" / "grid").glob("*.cpp")):
            done = subprocess.run([compiler, "-std=c++20", f"-I{self.root / 'include'}", "-DHASHNOISE_X86",
                                   "-DHASHNOISE_TABLE=sse41_fast", "-DHN_ARITHMETIC=1", "-M", source],
                                  capture_output=True, text=True, check=False)
            said += done.stderr
        return said

    def test_what_the_build_reads(self):
        for name in ("CMakeLists.txt", "LICENSE", "pyproject.toml", "docs/guide/python.md", "src/CMakeLists.txt"):
            self.assertTrue((self.root / name).is_file(), name)
        for folder in ("glsl/hashnoise", "glsl/hashnoise/detail", "include/hashnoise", "packages/python/hashnoise",
                       "vectors"):
            origin = VECTORS if folder == "vectors" else golden.ROOT / folder
            names, copied = ({path.name for path in of.iterdir() if path.is_file()}
                             for of in (origin, self.root / folder))
            self.assertEqual(copied, names)
        for path in self.root.rglob("CMakeLists.txt"):
            for name in re.findall(r"^ *include\((\S*/\S*)\)", path.read_text(encoding="utf-8"), re.M):
                self.assertTrue((path.parent / name).is_file(), (path, name))
        self.assertEqual(self.missing_headers(), "")

    def test_a_file_that_is_missing_is_noticed(self):
        path = self.root / "glsl" / "hashnoise" / "perlin2d.glsl"
        self.addCleanup(path.write_bytes, path.read_bytes())
        path.unlink()
        self.assertIn("perlin2d.glsl", self.missing_headers())

    def test_it_is_small(self):
        vectors = sum(len(zlib.compress(path.read_bytes())) for path in (self.root / "vectors").iterdir())
        self.assertLess(self.archive.stat().st_size - vectors, 1_000_000)
        self.assertFalse((self.root / "conformance").exists())

    def test_the_version_is_that_of_the_shaders(self):
        text = (golden.ROOT / "glsl" / "hashnoise" / "config.glsl").read_text(encoding="ascii")
        numbers = re.findall(r"^#define HN_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", text, re.M)
        self.assertEqual(self.root.name, f"hashnoise-{'.'.join(numbers)}")

    def test_the_backend_is_that_of_the_project(self):
        project = (golden.ROOT / "pyproject.toml").read_text(encoding="utf-8")
        pinned = re.findall(r'"(scikit-build-core==\S+)"', project)
        self.assertEqual(len(pinned), 1)
        self.assertIn(pinned[0], (TESTS / "requirements.txt").read_text(encoding="utf-8").split())


if __name__ == "__main__":
    unittest.main()
